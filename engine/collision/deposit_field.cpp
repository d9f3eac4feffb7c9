// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/parallel.hpp"

#include "deposit.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::collision::detail {

namespace {

/// Voxels finer than this tell nothing about real beads, mm.
constexpr double kFinest = 1.0;
constexpr int kBlock = 8;  ///< voxels along a block's edge
/// What floats lose over a part of metres, mm.
constexpr double kRounding = 1e-3;

double pointToSegment(const Vec3& p, const Vec3& a, const Vec3& ab, double inverseLength2) {
  const double s = std::clamp((p - a).dot(ab) * inverseLength2, 0.0, 1.0);
  return (p - a - s * ab).norm();
}

/// Joins rods that follow one another into longer ones that hold them, no longer than `length`.
/// The joined rod counts from its first part on.
std::vector<DepositRod> joinedRods(const std::vector<DepositRod>& rods, double length) {
  const double sagitta = length / 16.0;
  std::vector<DepositRod> runs;
  std::size_t i = 0;
  while (i < rods.size()) {
    DepositRod run = rods[i];
    std::size_t next = i + 1;
    for (; next < rods.size(); ++next) {
      const DepositRod& rod = rods[next];
      if (rod.a != rods[next - 1].b || (rod.b - run.a).norm() > length) {
        break;
      }
      const Vec3 ab = rod.b - run.a;
      const double inverse = ab.squaredNorm() > 0.0 ? 1.0 / ab.squaredNorm() : 0.0;
      double radius = 0.0;
      for (std::size_t k = i; k <= next; ++k) {
        radius = std::max({radius, rods[k].radius + pointToSegment(rods[k].a, run.a, ab, inverse),
                           rods[k].radius + pointToSegment(rods[k].b, run.a, ab, inverse)});
      }
      if (radius > std::max(rods[i].radius, rod.radius) + sagitta) {
        break;
      }
      run.b = rod.b;
      run.radius = radius;
    }
    runs.push_back(run);
    i = next;
  }
  return runs;
}

}  // namespace

DepositField::DepositField(const std::vector<DepositRod>& rods,
                           double near,
                           double far,
                           std::size_t maxVoxels,
                           const JobContext& context)
    : near_(near), far_(far), step_((far - near) / (kLevels - 1)) {
  if (rods.empty()) {
    return;
  }
  geometry::Box box;
  for (const DepositRod& rod : rods) {
    for (const Vec3& p : {rod.a, rod.b}) {
      box.add(p - Vec3::Constant(rod.radius + far));
      box.add(p + Vec3::Constant(rod.radius + far));
    }
  }
  const Vec3 extent = box.max - box.min;
  edge_ = std::max(std::cbrt(extent.prod() / static_cast<double>(maxVoxels)), kFinest);
  inverseEdge_ = 1.0 / edge_;
  origin_ = box.min;
  size_ = (extent / edge_).array().ceil().cast<int>();
  fill(joinedRods(rods, 2.0 * edge_), context);
}

void DepositField::fill(const std::vector<DepositRod>& runs, const JobContext& context) {
  const auto voxels = static_cast<std::size_t>(size_.x()) * static_cast<std::size_t>(size_.y()) *
                      static_cast<std::size_t>(size_.z());
  first_.assign(voxels * kLevels, kNever);
  const Eigen::Vector3i blocks = (size_.array() + kBlock - 1) / kBlock;
  const double blockHalf = 0.5 * (kBlock - 1) * edge_;
  const double blockRadius = std::sqrt(3.0) * blockHalf;
  const auto slabs = static_cast<std::size_t>(blocks.z());
  // Every slab sees all runs in order: nothing depends on the number of threads.
  parallelFor(
      slabs, 1,
      [&](std::size_t slab) {
        const int z0 = static_cast<int>(slab) * kBlock;
        const int z1 = std::min(z0 + kBlock, size_.z());
        const auto plane =
            static_cast<std::size_t>(size_.x()) * static_cast<std::size_t>(size_.y());
        std::vector<float> least(plane * static_cast<std::size_t>(z1 - z0),
                                 static_cast<float>(far_));
        std::vector<float> greatest(
            static_cast<std::size_t>(blocks.x()) * static_cast<std::size_t>(blocks.y()),
            static_cast<float>(far_));
        const double low = origin_.z() + z0 * edge_;
        const double high = origin_.z() + z1 * edge_;
        for (std::size_t r = 0; r < runs.size(); ++r) {
          if (r % 256 == 0) {
            context.check();
          }
          const DepositRod& run = runs[r];
          const double reach = run.radius + far_;
          if (std::max(run.a.z(), run.b.z()) + reach < low ||
              std::min(run.a.z(), run.b.z()) - reach > high) {
            continue;
          }
          const Vec3 ab = run.b - run.a;
          const double inverse = ab.squaredNorm() > 0.0 ? 1.0 / ab.squaredNorm() : 0.0;
          const auto blockAt = [&](double x, int axis) {
            return std::clamp(static_cast<int>((x - origin_(axis)) * inverseEdge_) / kBlock, 0,
                              blocks(axis) - 1);
          };
          const int bx0 = blockAt(std::min(run.a.x(), run.b.x()) - reach, 0);
          const int bx1 = blockAt(std::max(run.a.x(), run.b.x()) + reach, 0);
          const int by0 = blockAt(std::min(run.a.y(), run.b.y()) - reach, 1);
          const int by1 = blockAt(std::max(run.a.y(), run.b.y()) + reach, 1);
          for (int by = by0; by <= by1; ++by) {
            for (int bx = bx0; bx <= bx1; ++bx) {
              float& worst = greatest[static_cast<std::size_t>(by * blocks.x() + bx)];
              const Vec3 middle = origin_ + edge_ * Vec3(bx * kBlock, by * kBlock, z0) +
                                  Vec3::Constant(0.5 * edge_ + blockHalf);
              if (pointToSegment(middle, run.a, ab, inverse) - run.radius - blockRadius >= worst) {
                continue;
              }
              worst = 0.0F;
              const int x1 = std::min((bx + 1) * kBlock, size_.x());
              const int y1 = std::min((by + 1) * kBlock, size_.y());
              for (int z = z0; z < z1; ++z) {
                for (int y = by * kBlock; y < y1; ++y) {
                  for (int x = bx * kBlock; x < x1; ++x) {
                    const auto inPlane = static_cast<std::size_t>(y * size_.x() + x);
                    float& old = least[static_cast<std::size_t>(z - z0) * plane + inPlane];
                    const Vec3 centre = origin_ + edge_ * Vec3(x + 0.5, y + 0.5, z + 0.5);
                    const auto now = static_cast<float>(pointToSegment(centre, run.a, ab, inverse) -
                                                        run.radius - kRounding);
                    if (now < old) {
                      // Levels that are crossed: level k stands for near + k·step.
                      const std::size_t voxel = static_cast<std::size_t>(z) * plane + inPlane;
                      std::uint32_t* levels = &first_[voxel * kLevels];
                      for (int k = kLevels - 1; k >= 0; --k) {
                        const double level = near_ + k * step_;
                        if (level < now) {
                          break;
                        }
                        if (levels[k] == kNever) {
                          levels[k] = run.order;
                        }
                      }
                      old = now;
                    }
                    worst = std::max(worst, old);
                  }
                }
              }
            }
          }
        }
      },
      context);
}

float DepositField::distance(const Vec3& p, std::uint32_t deposited) const {
  const Vec3 local = (p - origin_) * inverseEdge_;
  if (first_.empty() || !(local.x() >= 0.0 && local.y() >= 0.0 && local.z() >= 0.0)) {
    return static_cast<float>(far_);
  }
  const Eigen::Vector3i at = local.cast<int>();
  if (at.x() >= size_.x() || at.y() >= size_.y() || at.z() >= size_.z()) {
    return static_cast<float>(far_);
  }
  const auto voxel = (static_cast<std::size_t>(at.z()) * static_cast<std::size_t>(size_.y()) +
                      static_cast<std::size_t>(at.y())) *
                         static_cast<std::size_t>(size_.x()) +
                     static_cast<std::size_t>(at.x());
  const std::uint32_t* levels = &first_[voxel * kLevels];
  // The orders fall with the distance: count the levels that are not reached yet.
  int farther = 0;
  for (int k = 0; k < kLevels; ++k) {
    farther += levels[k] > deposited ? 1 : 0;
  }
  const double off = edge_ * (local - at.cast<double>() - Vec3::Constant(0.5)).norm();
  if (farther == 0) {
    // Somewhere in or at the deposit.
    return static_cast<float>(-off);
  }
  return static_cast<float>(near_ + (farther - 1) * step_ - off);
}

}  // namespace wcam::collision::detail
