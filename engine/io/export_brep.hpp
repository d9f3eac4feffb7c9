// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TopoDS_Shape.hxx>

#include <filesystem>
#include <string>
#include <vector>

namespace wcam::io {

/// A shape with its name in the file.
struct NamedShape {
  TopoDS_Shape shape;
  std::string name;
};

/// Writes shapes as STEP (AP214, mm), each as a product of its own. @throws Error(OutputConflict)
void writeStep(const std::vector<NamedShape>& shapes, const std::filesystem::path& file);

}  // namespace wcam::io
