// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/toolpath/slicing.hpp"

#include <cstddef>
#include <vector>

namespace wcam::toolpath {

/// A curve on a part made of pieces, each inside one triangle, that can be evaluated between its
/// nodes.
class SampledCurve {
public:
  virtual ~SampledCurve();
  [[nodiscard]] virtual std::size_t pieces() const = 0;
  [[nodiscard]] virtual bool closed() const = 0;
  /// Points lie on an exact surface, so that a change of direction is a corner of the part.
  [[nodiscard]] virtual bool exact() const = 0;
  /// Point at fraction w in [0,1] of a piece; its ends at 0 and 1.
  [[nodiscard]] virtual ContourPoint at(std::size_t piece, double w) const = 0;
  /// Travel direction at the start (w = 0) or the end (w = 1) of a piece.
  [[nodiscard]] virtual Vec3 tangent(std::size_t piece, double w) const = 0;
};

/// Samples a curve so that chord error and spacing keep their bounds and corners stay points
/// (Chalvin A3).
std::vector<ContourPoint> sampleCurve(const SampledCurve& curve, const Sampling& sampling);

}  // namespace wcam::toolpath
