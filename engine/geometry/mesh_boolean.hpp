// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/mesh.hpp"

#include <cstddef>
#include <optional>

namespace wcam::geometry {

/// What is left of body a without body b. Nothing when one of them does not bound a volume or
/// crosses itself where they meet.
std::optional<TriangleMesh> subtract(const TriangleMesh& a, const TriangleMesh& b);

/// Bodies of a mesh that fill the same space.
struct Overlaps {
  std::size_t crossing = 0;   ///< bodies whose surfaces cross another's
  std::size_t nested = 0;     ///< bodies inside another's material, turned outwards like it
  double volume = 0.0;        ///< mm³ that are counted more than once
  Vec3 place = Vec3::Zero();  ///< in the middle of the first overlap's box
  /// The mesh with these bodies united; empty when that fails.
  std::optional<TriangleMesh> united;

  [[nodiscard]] bool any() const noexcept { return crossing + nested > 0; }
};

/// Finds closed pieces (bodies, with the cavities in them) that overlap. Bodies that touch, or
/// overlap by less than `tolerance` along their surfaces, are left alone, as open pieces are.
///
/// Boxes first, then triangles in the common box: about O(n log n) in usual parts.
/// @param tolerance mm, by which the surfaces may be off
Overlaps findOverlaps(const TriangleMesh& mesh,
                      const HalfEdges& halfEdges,
                      double tolerance,
                      const JobContext& context);

}  // namespace wcam::geometry
