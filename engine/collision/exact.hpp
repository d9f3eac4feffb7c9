// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "primitive.hpp"

#include <memory>

namespace wcam::collision::detail {

/// A shape as FCL sees it.
class ExactShape {
public:
  ExactShape() = default;
  explicit ExactShape(const Shape& shape);
  explicit ExactShape(const Rod& rod);  ///< along z, centred

  struct Impl;

  [[nodiscard]] const Impl& impl() const { return *impl_; }

private:
  std::shared_ptr<const Impl> impl_;
};

struct ExactDistance {
  double value = 0.0;  ///< mm, minus the depth of the deepest contact where they overlap
  Vec3 point = Vec3::Zero();
};

/// Distance by FCL. Meshes are surfaces there: something wholly inside one does not touch it.
ExactDistance exactDistance(const ExactShape& a,
                            const Pose& T_a,
                            const ExactShape& b,
                            const Pose& T_b);

/// Pose of ExactShape(rod).
Pose poseOf(const Rod& rod);

}  // namespace wcam::collision::detail
