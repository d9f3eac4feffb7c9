// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/mesh.hpp"

#include <vector>

namespace wcam::collision::detail {

/// A lower bound of the distance from a mesh by one look-up: voxels that triangles meet, and the
/// exact Euclidean distance transform of them (Felzenszwalb and Huttenlocher). Points that no way
/// leads to from outside count as inside.
class MeshField {
public:
  MeshField() = default;
  /// @param far greatest distance that is told, mm
  MeshField(const geometry::TriangleMesh& mesh,
            double far,
            std::size_t maxVoxels,
            const JobContext& context);

  /// At most far; negative when nothing is known. About 5 ns for neighbouring queries.
  [[nodiscard]] float distance(const geometry::Vec3& p) const;

  /// True where no way leads from outside.
  [[nodiscard]] bool inside(const geometry::Vec3& p) const;

private:
  [[nodiscard]] bool voxelOf(const geometry::Vec3& local, std::size_t* index) const;

  [[nodiscard]] std::size_t indexOf(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(size_.y()) +
            static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(size_.x()) +
           static_cast<std::size_t>(x);
  }

  void mark(const geometry::TriangleMesh& mesh, const JobContext& context);
  void transform(const JobContext& context);
  void closeInside();

  geometry::Vec3 origin_ = geometry::Vec3::Zero();
  double edge_ = 1.0;
  double inverseEdge_ = 1.0;
  double far_ = 0.0;
  Eigen::Vector3i size_ = Eigen::Vector3i::Zero();
  std::vector<float> distance_;
  std::vector<char> inside_;
};

}  // namespace wcam::collision::detail
