// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sampled_curve.hpp"

#include <cstdint>
#include <vector>

namespace wcam::toolpath {

/// A finely sampled layer that distances are measured from, as segments that know their neighbours
/// along their curve. The nearest segment is found by walking from one that is near, so that a
/// distance follows the surface on which the walk began: the other side of a thin double wall is
/// never taken for it.
class FrontLine {
public:
  struct Foot {
    std::int32_t segment = -1;
    double distance = 0.0;  ///< mm
    Vec3 point = Vec3::Zero();
  };

  /// The nearest place within a curve, downhill from `hint`.
  [[nodiscard]] Foot nearest(const Vec3& p, std::int32_t hint) const;
  /// The better of two walks.
  [[nodiscard]] Foot nearest(const Vec3& p, std::int32_t hint, std::int32_t otherHint) const;

  /// Adds a curve so finely that no chord is farther than `chord` from it.
  /// @return per piece of the curve its middle segment
  std::vector<std::int32_t> add(const SampledCurve& curve, double chord);

  [[nodiscard]] bool empty() const { return start_.empty(); }

  [[nodiscard]] std::size_t size() const { return start_.size(); }

private:
  [[nodiscard]] Foot footOn(const Vec3& p, std::int32_t segment) const;

  std::vector<Vec3> start_;
  std::vector<Vec3> end_;
  std::vector<std::int32_t> previous_;  ///< −1 at an open end
  std::vector<std::int32_t> next_;
};

}  // namespace wcam::toolpath
