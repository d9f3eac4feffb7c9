// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"

#include "occt_session.hpp"
#include <TopoDS_Shape.hxx>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wcam::io {

enum class CadFormat { Step, Iges, BrepText, BrepBinary };

/// A shape of the file with what is said about it.
struct CadItem {
  TopoDS_Shape shape;
  std::string name;
  std::string colour;  ///< "#RRGGBB" or empty
};

/// The shapes of a CAD file in the frame of the file, assemblies flattened. Lengths in mm for STEP
/// and IGES, as written for BREP.
struct CadModel {
  std::vector<CadItem> bodies;
  std::vector<CadItem> named;  ///< faces and edges inside bodies that have their own name
  std::string unit;            ///< as the file writes it; empty when it does not
  double millimetresPerUnit = 1.0;
  std::optional<double> deviation;  ///< of shapes made from formulas: largest distance, mm
};

/// @throws Error(InputInvalid), CancelledError, Standard_Failure
CadModel readCadModel(const std::filesystem::path& file,
                      std::string_view bytes,
                      CadFormat format,
                      const OcctSession& session,
                      const JobContext& context);

}  // namespace wcam::io
