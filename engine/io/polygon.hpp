// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/types.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace wcam::io {

/// Largest polygon of a mesh file that is divided; cutting ears takes the square of the corners.
inline constexpr std::size_t kMaxPolygonCorners = 10000;

/// Divides a polygon of vertex indices into triangles of the same direction: three corners as they
/// are, otherwise by cutting ears in its mean plane. A polygon that crosses itself still gives
/// n − 2 triangles.
void dividePolygon(const std::vector<geometry::Vec3>& vertices,
                   const std::vector<std::uint32_t>& corners,
                   std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace wcam::io
