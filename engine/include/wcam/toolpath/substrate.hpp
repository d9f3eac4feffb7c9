// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/part_surface.hpp"
#include "wcam/geometry/types.hpp"

#include <memory>
#include <optional>
#include <string>

namespace wcam::toolpath {

using geometry::Pose;
using geometry::Vec3;

/// What the part is built on: a plate whose top is the plane z = 0 of its frame, or an imported
/// part. Build direction = z of its frame, in the part frame.
class Substrate {
public:
  /// @param size length, width, thickness of the plate, mm
  Substrate(const Pose& T_part_substrate, const Vec3& size);
  /// @param body closed or open surface in the part frame
  Substrate(const Pose& T_part_substrate, std::shared_ptr<const geometry::PartSurface> body);
  ~Substrate();

  [[nodiscard]] const Pose& pose() const noexcept { return T_part_substrate_; }

  [[nodiscard]] Vec3 up() const { return T_part_substrate_.linear().col(2); }

  [[nodiscard]] bool isPlate() const noexcept { return body_ == nullptr; }

  [[nodiscard]] const Vec3& size() const noexcept { return size_; }

  /// Height of a point above the substrate along the build direction, negative below. Beside an
  /// imported body: height above the frame's plane z = 0.
  [[nodiscard]] double heightAbove(const Vec3& p) const;

  /// Height above the substrate and the gradient of that height.
  struct Height {
    double value = 0.0;
    Vec3 gradient = Vec3::UnitZ();
  };

  /// The same measured on the exact surface where the substrate has one: for curves that lie on it
  /// (Chalvin A10). Thread-safe.
  [[nodiscard]] Height exactHeightAbove(const Vec3& p) const;

  /// The nearest place of the surface on which the part stands.
  struct Foot {
    double distance = 0.0;           ///< mm, negative inside the substrate
    Vec3 direction = Vec3::UnitZ();  ///< unit vector from the surface outwards, to the point
  };

  /// Of a plate the plane of its top, however far the point lies beside it; of an imported body its
  /// surface, the exact one where it has one. Thread-safe.
  [[nodiscard]] Foot nearest(const Vec3& p) const;

  /// The imported body; null for a plate.
  [[nodiscard]] const std::shared_ptr<const geometry::PartSurface>& body() const noexcept {
    return body_;
  }

private:
  struct Query;
  Pose T_part_substrate_;
  Vec3 size_ = Vec3::Zero();
  std::shared_ptr<const geometry::PartSurface> body_;
  std::shared_ptr<Query> query_;
};

}  // namespace wcam::toolpath
