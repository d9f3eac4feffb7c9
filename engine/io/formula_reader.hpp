// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cad_reader.hpp"

#include <string_view>

namespace wcam::io {

/// The exact shape of a formula surface (.wsurf, see resources/doc/part-formats.md): parametric
/// surfaces and tubes become one spline face, surfaces of revolution one face per piece of the
/// profile. CadModel::deviation tells how far it is from the formulas.
/// @throws Error(InputInvalid) naming the file, the formula and the position; Standard_Failure
CadModel readFormulaSurface(std::string_view bytes,
                            const std::string& file,
                            const JobContext& context);

}  // namespace wcam::io
