// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_field.hpp"

#include "wcam/base/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::collision::detail {

namespace {

using geometry::Vec3;

constexpr double kFinest = 1.0;  // mm
constexpr float kFree = std::numeric_limits<float>::max();
const double kHalfDiagonal = 0.5 * std::sqrt(3.0);
constexpr double kRounding = 1e-3;  // mm, of floats

/// Lower envelope of parabolas: squared distances along one line, in voxels.
void transformLine(std::vector<float>& f,
                   std::vector<float>& out,
                   std::vector<int>& at,
                   std::vector<float>& border,
                   int n) {
  int k = -1;
  for (int q = 0; q < n; ++q) {
    const auto i = static_cast<std::size_t>(q);
    if (f[i] == kFree) {
      continue;
    }
    float meet = -kFree;
    while (k >= 0) {
      const int v = at[static_cast<std::size_t>(k)];
      const auto j = static_cast<std::size_t>(v);
      meet = (f[i] - f[j] + static_cast<float>(q * q - v * v)) / static_cast<float>(2 * (q - v));
      if (meet > border[static_cast<std::size_t>(k)]) {
        break;
      }
      --k;
      meet = -kFree;
    }
    ++k;
    at[static_cast<std::size_t>(k)] = q;
    border[static_cast<std::size_t>(k)] = meet;
  }
  const int last = k;
  k = 0;
  for (int q = 0; q < n; ++q) {
    if (last < 0) {
      out[static_cast<std::size_t>(q)] = kFree;
      continue;
    }
    while (k < last && border[static_cast<std::size_t>(k + 1)] < static_cast<float>(q)) {
      ++k;
    }
    const int v = at[static_cast<std::size_t>(k)];
    out[static_cast<std::size_t>(q)] =
        static_cast<float>((q - v) * (q - v)) + f[static_cast<std::size_t>(v)];
  }
}

}  // namespace

MeshField::MeshField(const geometry::TriangleMesh& mesh,
                     double far,
                     std::size_t maxVoxels,
                     const JobContext& context)
    : far_(far) {
  const geometry::Box bounds = mesh.bounds();
  const Vec3 extent = bounds.max - bounds.min + Vec3::Constant(2.0 * far);
  edge_ = std::max(std::cbrt(extent.prod() / static_cast<double>(maxVoxels)), kFinest);
  inverseEdge_ = 1.0 / edge_;
  origin_ = bounds.min - Vec3::Constant(far);
  size_ = (extent / edge_).array().ceil().cast<int>() + 1;
  distance_.assign(indexOf(0, 0, size_.z()), kFree);
  mark(mesh, context);
  transform(context);
  closeInside();
}

/// 0 in every voxel that may hold a piece of a triangle: its box and its plane meet the voxel.
void MeshField::mark(const geometry::TriangleMesh& mesh, const JobContext& context) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (t % 4096 == 0) {
      context.check();
    }
    geometry::Box box;
    for (const std::uint32_t v : mesh.triangles[t]) {
      box.add(mesh.vertices[v]);
    }
    const Vec3 normal = mesh.normal(t);
    const double level = normal.dot(mesh.vertices[mesh.triangles[t][0]]);
    const double half = 0.5 * edge_ * normal.cwiseAbs().sum() + kRounding;
    const Eigen::Vector3i low =
        ((box.min - origin_) * inverseEdge_).array().floor().cast<int>().max(0);
    const Eigen::Vector3i high =
        ((box.max - origin_) * inverseEdge_).array().floor().cast<int>().min(size_.array() - 1);
    for (int z = low.z(); z <= high.z(); ++z) {
      for (int y = low.y(); y <= high.y(); ++y) {
        for (int x = low.x(); x <= high.x(); ++x) {
          const Vec3 centre = origin_ + edge_ * Vec3(x + 0.5, y + 0.5, z + 0.5);
          if (std::abs(normal.dot(centre) - level) <= half) {
            distance_[indexOf(x, y, z)] = 0.0F;
          }
        }
      }
    }
  }
}

/// Squared distances in voxels along x, y and z, then lower bounds in mm.
void MeshField::transform(const JobContext& context) {
  for (int axis = 0; axis < 3; ++axis) {
    const int u = axis == 0 ? 1 : 0;
    const int v = axis == 2 ? 1 : 2;
    const int n = size_(axis);
    parallelForChunks(
        static_cast<std::size_t>(size_(v)), 1,
        [&](std::size_t begin, std::size_t end) {
          const auto length = static_cast<std::size_t>(n);
          std::vector<float> line(length);
          std::vector<float> out(length);
          std::vector<int> at(length);
          std::vector<float> border(length);
          Eigen::Vector3i p = Eigen::Vector3i::Zero();
          const auto place = [&](int k) -> float& {
            p(axis) = k;
            return distance_[indexOf(p.x(), p.y(), p.z())];
          };
          for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row) {
            p(v) = row;
            for (int i = 0; i < size_(u); ++i) {
              p(u) = i;
              for (int k = 0; k < n; ++k) {
                line[static_cast<std::size_t>(k)] = place(k);
              }
              transformLine(line, out, at, border, n);
              for (int k = 0; k < n; ++k) {
                place(k) = out[static_cast<std::size_t>(k)];
              }
            }
          }
        },
        context);
  }
  for (float& value : distance_) {
    // A point of the surface lies anywhere in its voxel.
    const double d = value == kFree ? far_ : edge_ * (std::sqrt(value) - kHalfDiagonal);
    value = static_cast<float>(std::min(d, far_) - kRounding);
  }
}

/// Voxels that the outside does not reach through free ones lie inside: no distance there.
void MeshField::closeInside() {
  constexpr char kInside = 0;
  constexpr char kOutside = 1;
  std::vector<char> state(distance_.size(), kInside);
  std::vector<Eigen::Vector3i> stack = {Eigen::Vector3i::Zero()};
  state[0] = kOutside;  // far outside of the mesh
  while (!stack.empty()) {
    const Eigen::Vector3i at = stack.back();
    stack.pop_back();
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {-1, 1}) {
        Eigen::Vector3i next = at;
        next(axis) += side;
        if (next(axis) < 0 || next(axis) >= size_(axis)) {
          continue;
        }
        const std::size_t k = indexOf(next.x(), next.y(), next.z());
        if (state[k] == kInside && distance_[k] > -kHalfDiagonal * edge_) {
          state[k] = kOutside;
          stack.push_back(next);
        }
      }
    }
  }
  inside_.assign(state.size(), 0);
  for (std::size_t k = 0; k < state.size(); ++k) {
    if (state[k] == kInside) {
      // What no triangle meets and nothing reaches is inside; the rest is the surface.
      inside_[k] = distance_[k] > -kHalfDiagonal * edge_ ? 1 : 0;
      distance_[k] = static_cast<float>(-kHalfDiagonal * edge_);
    }
  }
}

bool MeshField::voxelOf(const Vec3& local, std::size_t* index) const {
  if (!(local.x() >= 0.0 && local.y() >= 0.0 && local.z() >= 0.0 && local.x() < size_.x() &&
        local.y() < size_.y() && local.z() < size_.z())) {
    return false;
  }
  const Eigen::Vector3i at = local.cast<int>();
  *index = indexOf(at.x(), at.y(), at.z());
  return true;
}

float MeshField::distance(const Vec3& p) const {
  const Vec3 local = (p - origin_) * inverseEdge_;
  std::size_t index = 0;
  if (!voxelOf(local, &index)) {
    return static_cast<float>(far_);
  }
  const Vec3 off = local - local.array().floor().matrix() - Vec3::Constant(0.5);
  return distance_[index] - static_cast<float>(edge_ * off.norm());
}

bool MeshField::inside(const Vec3& p) const {
  std::size_t index = 0;
  return voxelOf((p - origin_) * inverseEdge_, &index) && inside_[index] != 0;
}

}  // namespace wcam::collision::detail
