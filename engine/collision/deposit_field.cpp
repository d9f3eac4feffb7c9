// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/parallel.hpp"

#include "deposit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace wcam::collision::detail {

namespace {

/// Voxels finer than this tell nothing about real beads, mm.
constexpr double kFinest = 1.0;
/// Rods nearer than this part of a voxel's edge count as one; the field is coarser by more.
constexpr double kThin = 0.125;
constexpr int kBlock = 8;  ///< voxels along a block's edge
/// What floats lose over a part of metres, mm.
constexpr double kRounding = 1e-2;

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

/// Both ends of a rod in cells of a grid.
using RodCells = std::array<std::int64_t, 6>;

struct RodCellsHash {
  std::size_t operator()(const RodCells& cells) const {
    std::size_t hash = 0;
    for (const std::int64_t cell : cells) {
      hash = hash * 0x9E3779B97F4A7C15U + static_cast<std::size_t>(cell);
    }
    return hash;
  }
};

/// Leaves out rods that lie within `distance` of an earlier one, which is made as much thicker and
/// so holds them: layers much thinner than the grid is fine.
std::vector<DepositRod> thinnedRods(const std::vector<DepositRod>& rods, double distance) {
  const double cell = distance / std::sqrt(3.0);
  std::unordered_map<RodCells, std::size_t, RodCellsHash> known;
  std::vector<DepositRod> kept;
  std::vector<double> thickest;  ///< of those that each stands for; the first is its own
  std::vector<bool> standsForMore;
  for (const DepositRod& rod : rods) {
    RodCells cells{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      cells[k] = static_cast<std::int64_t>(std::floor(rod.a(axis) / cell));
      cells[k + 3] = static_cast<std::int64_t>(std::floor(rod.b(axis) / cell));
    }
    const auto [at, fresh] = known.emplace(cells, kept.size());
    if (fresh) {
      kept.push_back(rod);
      thickest.push_back(rod.radius);
      standsForMore.push_back(false);
    } else {
      thickest[at->second] = std::max(thickest[at->second], rod.radius);
      standsForMore[at->second] = true;
    }
  }
  for (std::size_t i = 0; i < kept.size(); ++i) {
    kept[i].radius = standsForMore[i] ? thickest[i] + distance : kept[i].radius;
  }
  return kept;
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
  originF_ = origin_.cast<float>();
  sizeF_ = size_.cast<float>();
  while ((rods.back().order >> shift_) >= kNeverTick) {
    ++shift_;
  }
  fill(thinnedRods(joinedRods(rods, 2.0 * edge_), kThin * edge_), context);
}

/// Fills one slab of blocks: every run in order, block by block.
class DepositField::Filler {
public:
  Filler(DepositField& field, int slab)
      : field_(field),
        z0_(slab * kBlock),
        z1_(std::min(z0_ + kBlock, field.size_.z())),
        rowLength_((field.size_.x() + kBlock - 1) / kBlock * kBlock),
        blocks_((field.size_.x() + kBlock - 1) / kBlock, (field.size_.y() + kBlock - 1) / kBlock),
        next_(static_cast<std::size_t>(rowLength_) * static_cast<std::size_t>(field.size_.y()) *
                  static_cast<std::size_t>(z1_ - z0_),
              static_cast<float>(field.far_)),
        worst_(static_cast<std::size_t>(blocks_.prod()), static_cast<float>(field.far_)) {}

  void add(const DepositRod& run) {
    const double reach = run.radius + field_.far_;
    const Vec3 low = run.a.cwiseMin(run.b) - field_.origin_ - Vec3::Constant(reach);
    const Vec3 high = run.a.cwiseMax(run.b) - field_.origin_ + Vec3::Constant(reach);
    if (high.z() < z0_ * field_.edge_ || low.z() > z1_ * field_.edge_) {
      return;
    }
    const auto blockAt = [&](double x, int axis) {
      return std::clamp(static_cast<int>(x * field_.inverseEdge_) / kBlock, 0, blocks_(axis) - 1);
    };
    a_ = (run.a - field_.origin_).cast<float>();
    ab_ = (run.b - run.a).cast<float>();
    const float length2 = ab_.squaredNorm();
    inverse_ = length2 > 0.0F ? 1.0F / length2 : 0.0F;
    radius_ = static_cast<float>(run.radius + kRounding);
    tick_ = static_cast<std::uint16_t>(run.order >> field_.shift_);
    for (int by = blockAt(low.y(), 1); by <= blockAt(high.y(), 1); ++by) {
      for (int bx = blockAt(low.x(), 0); bx <= blockAt(high.x(), 0); ++bx) {
        addToBlock(bx, by);
      }
    }
  }

private:
  static constexpr float kAllReached = -1e9F;

  /// Squared distance of a point from the run's axis.
  [[nodiscard]] float squaredDistance(float x, float y, float z) const {
    const float px = x - a_.x();
    const float py = y - a_.y();
    const float pz = z - a_.z();
    const float along = (px * ab_.x() + py * ab_.y() + pz * ab_.z()) * inverse_;
    const float s = std::min(std::max(along, 0.0F), 1.0F);
    const float dx = px - s * ab_.x();
    const float dy = py - s * ab_.y();
    const float dz = pz - s * ab_.z();
    return dx * dx + dy * dy + dz * dz;
  }

  void addToBlock(int bx, int by) {
    float& worst = worst_[static_cast<std::size_t>(by * blocks_.x() + bx)];
    const auto edge = static_cast<float>(field_.edge_);
    const float half = 0.5F * kBlock * edge;
    const float out = worst + radius_ + std::sqrt(3.0F) * half;
    if (out <= 0.0F || squaredDistance(static_cast<float>(bx * kBlock) * edge + half,
                                       static_cast<float>(by * kBlock) * edge + half,
                                       static_cast<float>(z0_) * edge + half) >= out * out) {
      return;
    }
    worst = kAllReached;
    const int y1 = std::min((by + 1) * kBlock, field_.size_.y());
    for (int z = z0_; z < z1_; ++z) {
      for (int y = by * kBlock; y < y1; ++y) {
        worst = std::max(worst, addToRow(bx * kBlock, y, z));
      }
    }
  }

  /// A row of a block; its greatest distance that is still to be reached.
  float addToRow(int x0, int y, int z) {
    const auto edge = static_cast<float>(field_.edge_);
    const float py = (static_cast<float>(y) + 0.5F) * edge;
    const float pz = (static_cast<float>(z) + 0.5F) * edge;
    float* next =
        &next_[(static_cast<std::size_t>(z - z0_) * static_cast<std::size_t>(field_.size_.y()) +
                static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(rowLength_) +
               static_cast<std::size_t>(x0)];
    std::array<float, kBlock> missing{};
    for (int k = 0; k < kBlock; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const float px = (static_cast<float>(x0 + k) + 0.5F) * edge;
      const float limit = std::max(next[i] + radius_, 0.0F);
      missing[i] = squaredDistance(px, py, pz) - limit * limit;
    }
    float greatest = kAllReached;
    for (int k = 0; k < kBlock; ++k) {
      const auto i = static_cast<std::size_t>(k);
      if (missing[i] < 0.0F) {
        next[i] = reach(x0 + k, y, z);
      }
      greatest = std::max(greatest, next[i]);
    }
    return greatest;
  }

  /// Marks all levels that the run reaches in a voxel; the next one that it does not.
  float reach(int x, int y, int z) {
    if (x >= field_.size_.x()) {
      return kAllReached;
    }
    const auto edge = static_cast<float>(field_.edge_);
    const float d2 = squaredDistance((static_cast<float>(x) + 0.5F) * edge,
                                     (static_cast<float>(y) + 0.5F) * edge,
                                     (static_cast<float>(z) + 0.5F) * edge);
    std::uint16_t* levels = &field_.first_[field_.indexOf(x, y, z) * kLevels];
    for (int k = kLevels - 1; k >= 0; --k) {
      if (levels[k] != kNeverTick) {
        continue;
      }
      const float level = field_.levelAt(k);
      const float limit = level + radius_;
      if (d2 >= limit * limit) {
        return level;
      }
      levels[k] = tick_;
    }
    return kAllReached;
  }

  DepositField& field_;
  int z0_;
  int z1_;
  int rowLength_;
  Eigen::Vector2i blocks_;
  std::vector<float> next_;   ///< of each voxel: the greatest level that is not reached yet
  std::vector<float> worst_;  ///< of each block: the greatest of next_
  Eigen::Vector3f a_ = Eigen::Vector3f::Zero();
  Eigen::Vector3f ab_ = Eigen::Vector3f::Zero();
  float inverse_ = 0.0F;
  float radius_ = 0.0F;
  std::uint16_t tick_ = 0;
};

DepositField::SlabRuns DepositField::slabRuns(const std::vector<DepositRod>& runs,
                                              std::size_t slabs,
                                              const JobContext& context) const {
  const double height = kBlock * edge_;
  // The slabs that a run can reach, one more on both sides for rounding.
  const auto reached = [&](const DepositRod& run) {
    const double reach = run.radius + far_;
    const double low = (std::min(run.a.z(), run.b.z()) - origin_.z() - reach) / height;
    const double high = (std::max(run.a.z(), run.b.z()) - origin_.z() + reach) / height;
    const auto last = static_cast<double>(slabs - 1);
    return std::array<std::size_t, 2>{
        static_cast<std::size_t>(std::clamp(std::floor(low) - 1.0, 0.0, last)),
        static_cast<std::size_t>(std::clamp(std::floor(high) + 1.0, 0.0, last))};
  };
  SlabRuns of;
  of.begin.assign(slabs + 1, 0);
  for (const DepositRod& run : runs) {
    const auto [first, last] = reached(run);
    for (std::size_t slab = first; slab <= last; ++slab) {
      ++of.begin[slab + 1];
    }
  }
  for (std::size_t slab = 0; slab < slabs; ++slab) {
    of.begin[slab + 1] += of.begin[slab];
  }
  context.check();
  of.runs.resize(of.begin[slabs]);
  std::vector<std::size_t> next(of.begin.begin(), of.begin.end() - 1);
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto [first, last] = reached(runs[r]);
    for (std::size_t slab = first; slab <= last; ++slab) {
      of.runs[next[slab]++] = static_cast<std::uint32_t>(r);
    }
  }
  return of;
}

void DepositField::fill(const std::vector<DepositRod>& runs, const JobContext& context) {
  first_.assign(indexOf(0, 0, size_.z()) * kLevels, kNeverTick);
  // Every slab sees its runs in order: nothing depends on the number of threads.
  const auto slabs = static_cast<std::size_t>((size_.z() + kBlock - 1) / kBlock);
  const SlabRuns of = slabRuns(runs, slabs, context);
  parallelFor(
      slabs, 1,
      [&](std::size_t slab) {
        Filler filler(*this, static_cast<int>(slab));
        for (std::size_t k = of.begin[slab]; k < of.begin[slab + 1]; ++k) {
          if (k % 256 == 0) {
            context.check();
          }
          filler.add(runs[of.runs[k]]);
        }
      },
      context);
}

float DepositField::distance(const Eigen::Vector3f& p, std::uint32_t deposited) const {
  const Eigen::Vector3f local = (p - originF_) * static_cast<float>(inverseEdge_);
  if (first_.empty() || !(local.minCoeff() >= 0.0F && local.x() < sizeF_.x() &&
                          local.y() < sizeF_.y() && local.z() < sizeF_.z())) {
    return static_cast<float>(far_);
  }
  const Eigen::Vector3i at = local.cast<int>();
  const auto tick =
      static_cast<std::uint16_t>(std::min<std::uint32_t>(deposited >> shift_, kNeverTick - 1));
  const std::uint16_t* levels = &first_[indexOf(at.x(), at.y(), at.z()) * kLevels];
  // The ticks fall with the distance: count the levels that are not reached yet.
  int farther = 0;
  for (int k = 0; k < kLevels; ++k) {
    farther += levels[k] > tick ? 1 : 0;
  }
  const float off = static_cast<float>(edge_) *
                    (local - at.cast<float>() - Eigen::Vector3f::Constant(0.5F)).norm();
  // Below all levels: somewhere in or at the deposit.
  return farther == 0 ? -off : levelAt(farther - 1) - off;
}

}  // namespace wcam::collision::detail
