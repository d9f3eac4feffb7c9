// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/collision/deposit.hpp"

#include "primitive.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace wcam::collision::detail {

inline constexpr std::uint32_t kNever = 0xFFFFFFFFU;

/// A lower bound of the distance from the deposit at every moment, by one look-up.
///
/// Every voxel holds, for each of kLevels distances, the tick from which on the deposit is no
/// farther than that from the voxel's centre: one grid serves all instants of the build. A tick is
/// a power of two of points, as few as 16 bits allow; within one everything counts from its start
/// on. 32 bytes per voxel: a query reads half a cache line.
class DepositField {
public:
  static constexpr int kLevels = 16;

  DepositField() = default;
  /// @param near, far distances from the deposit between which the field tells them apart
  DepositField(const std::vector<DepositRod>& rods,
               double near,
               double far,
               std::size_t maxVoxels,
               const JobContext& context);

  [[nodiscard]] bool empty() const noexcept { return first_.empty(); }

  [[nodiscard]] double far() const noexcept { return far_; }

  /// Lower bound of the distance of a point of the part frame from what is deposited, negative when
  /// nothing is known; at most far(). About 5 ns when neighbouring queries are near one another.
  [[nodiscard]] float distance(const Eigen::Vector3f& p, std::uint32_t deposited) const;

private:
  class Filler;

  /// Of each slab of blocks the runs that can reach it, in order.
  struct SlabRuns {
    std::vector<std::size_t> begin;  ///< places in `runs`, one more than there are slabs
    std::vector<std::uint32_t> runs;
  };

  [[nodiscard]] SlabRuns slabRuns(const std::vector<DepositRod>& runs,
                                  std::size_t slabs,
                                  const JobContext& context) const;
  void fill(const std::vector<DepositRod>& runs, const JobContext& context);

  [[nodiscard]] std::size_t indexOf(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(size_.y()) +
            static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(size_.x()) +
           static_cast<std::size_t>(x);
  }

  [[nodiscard]] float levelAt(int k) const { return static_cast<float>(near_ + k * step_); }

  Vec3 origin_ = Vec3::Zero();
  Eigen::Vector3f originF_ = Eigen::Vector3f::Zero();
  Eigen::Vector3f sizeF_ = Eigen::Vector3f::Zero();
  double edge_ = 1.0;
  double inverseEdge_ = 1.0;
  double near_ = 0.0;
  double far_ = 0.0;
  double step_ = 1.0;  ///< between levels
  Eigen::Vector3i size_ = Eigen::Vector3i::Zero();
  static constexpr std::uint16_t kNeverTick = 0xFFFFU;
  int shift_ = 0;  ///< of orders to ticks
  std::vector<std::uint16_t> first_;
};

/// Exact queries: a bounding hierarchy over all rods of the deposit whose nodes know from which
/// order on they hold anything, so that one hierarchy grows with the build.
class DepositTree {
public:
  DepositTree() = default;
  explicit DepositTree(const std::vector<DepositRod>& rods);

  struct Hit {
    double distance = 0.0;
    Vec3 point = Vec3::Zero();   ///< on the rod's axis, part frame
    std::uint32_t rod = kNever;  ///< kNever: nothing within the limit
  };

  /// The rod of least distance from a solid at T_part_solid, among those deposited and not skipped,
  /// below `limit`.
  [[nodiscard]] Hit nearest(const Primitive& solid,
                            const Pose& T_part_solid,
                            std::uint32_t deposited,
                            double limit,
                            const std::function<bool(const DepositRod&, double)>& skip = {}) const;

  /// Calls `visit` for every deposited rod within `reach` of a point's ball.
  void visit(const Vec3& centre,
             double reach,
             std::uint32_t deposited,
             const std::function<void(std::uint32_t)>& visit) const;

  /// Spheres that hold everything, each with the order from which on it holds anything: nodes of
  /// about the given number.
  struct Ball {
    Vec3 centre = Vec3::Zero();
    double radius = 0.0;
    std::uint32_t order = 0;
  };

  [[nodiscard]] std::vector<Ball> balls(std::size_t count) const;

private:
  struct Node {
    Vec3 centre = Vec3::Zero();
    double radius = 0.0;
    std::uint32_t order = kNever;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::uint32_t left = 0;  ///< 0: a leaf; the right child follows the left one's subtree
    std::uint32_t right = 0;
  };

  std::uint32_t build(std::uint32_t begin, std::uint32_t end);

  std::vector<DepositRod> rods_;
  std::vector<std::uint32_t> index_;  ///< of rods_ in the order of the leaves
  std::vector<Node> nodes_;
};

}  // namespace wcam::collision::detail
