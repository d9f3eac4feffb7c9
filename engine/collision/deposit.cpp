// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "deposit.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::collision {

namespace {

using geometry::Vec3;
using toolpath::PathPoint;

/// Radius of a bead whose path knows neither width nor height, mm.
constexpr double kUnknownRadius = 1.0;

double beadRadius(const PathPoint& point) {
  const double radius = 0.5 * std::max(point.width, point.height);
  return radius > 0.0 ? radius : kUnknownRadius;
}

}  // namespace

std::vector<DepositRod> depositRods(const toolpath::Toolpath& path) {
  std::vector<DepositRod> rods;
  std::uint32_t order = 0;
  for (const toolpath::Layer& layer : path.layers) {
    for (const toolpath::Bead& bead : layer.beads) {
      for (std::size_t i = 0; i < bead.points.size(); ++i) {
        ++order;
        if (i == 0 || !bead.points[i].arc) {
          continue;
        }
        const PathPoint& from = bead.points[i - 1];
        const PathPoint& to = bead.points[i];
        DepositRod rod;
        rod.radius = std::max(beadRadius(from), beadRadius(to));
        rod.a = from.p - rod.radius * from.b;
        rod.b = to.p - rod.radius * to.b;
        rod.order = order;
        rods.push_back(rod);
      }
    }
  }
  return rods;
}

namespace detail {

namespace {

constexpr std::uint32_t kLeafSize = 4;

}  // namespace

DepositTree::DepositTree(const std::vector<DepositRod>& rods) : rods_(rods), index_(rods.size()) {
  for (std::uint32_t i = 0; i < index_.size(); ++i) {
    index_[i] = i;
  }
  if (!rods_.empty()) {
    nodes_.reserve(2 * rods_.size() / kLeafSize + 2);
    build(0, static_cast<std::uint32_t>(rods_.size()));
  }
}

std::uint32_t DepositTree::build(std::uint32_t begin, std::uint32_t end) {
  const auto self = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  geometry::Box box;
  std::uint32_t order = kNever;
  for (std::uint32_t i = begin; i < end; ++i) {
    const DepositRod& rod = rods_[index_[i]];
    box.add(rod.a);
    box.add(rod.b);
    order = std::min(order, rod.order);
  }
  Node node;
  node.centre = 0.5 * (box.min + box.max);
  node.order = order;
  node.begin = begin;
  node.end = end;
  for (std::uint32_t i = begin; i < end; ++i) {
    const DepositRod& rod = rods_[index_[i]];
    node.radius = std::max({node.radius, (rod.a - node.centre).norm() + rod.radius,
                            (rod.b - node.centre).norm() + rod.radius});
  }
  if (end - begin > kLeafSize) {
    Eigen::Index axis = 0;
    (box.max - box.min).maxCoeff(&axis);
    const std::uint32_t middle = begin + (end - begin) / 2;
    const auto key = [&](std::uint32_t i) { return rods_[i].a(axis) + rods_[i].b(axis); };
    std::nth_element(index_.begin() + begin, index_.begin() + middle, index_.begin() + end,
                     [&](std::uint32_t i, std::uint32_t k) {
                       return key(i) != key(k) ? key(i) < key(k) : i < k;
                     });
    node.left = build(begin, middle);
    node.right = build(middle, end);
  }
  nodes_[self] = node;
  return self;
}

DepositTree::Hit DepositTree::nearest(
    const Primitive& solid,
    const Pose& T_part_solid,
    std::uint32_t deposited,
    double limit,
    const std::function<bool(const DepositRod&, double)>& skip) const {
  Hit best;
  best.distance = limit;
  if (nodes_.empty()) {
    return best;
  }
  const Pose T_solid_part = T_part_solid.inverse();

  struct Entry {
    double bound;
    std::uint32_t node;
  };

  // A depth-first walk, the nearer child first; the stack never holds more than two per depth.
  std::array<Entry, 128> stack{};
  std::size_t count = 0;
  const auto push = [&](std::uint32_t k) {
    const Node& node = nodes_[k];
    if (node.order <= deposited) {
      const double bound = signedDistance(solid, T_solid_part * node.centre) - node.radius;
      if (bound < best.distance) {
        stack[count++] = {bound, k};
      }
    }
  };
  push(0);
  while (count > 0) {
    const Entry entry = stack[--count];
    if (entry.bound >= best.distance) {
      continue;
    }
    const Node& node = nodes_[entry.node];
    if (node.left != 0) {
      const std::size_t before = count;
      push(node.left);
      push(node.right);
      if (count == before + 2 && stack[before].bound < stack[before + 1].bound) {
        std::swap(stack[before], stack[before + 1]);
      }
      continue;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      const DepositRod& rod = rods_[index_[i]];
      if (rod.order > deposited) {
        continue;
      }
      // Most rods of a leaf are ruled out by their middle.
      const double half = 0.5 * (rod.b - rod.a).norm();
      if (signedDistance(solid, T_solid_part * Vec3(0.5 * (rod.a + rod.b))) - half - rod.radius >
          best.distance) {
        continue;
      }
      const RodDistance found =
          rodDistance(solid, {T_solid_part * rod.a, T_solid_part * rod.b, rod.radius});
      const bool nearer =
          found.value < best.distance ||
          (found.value == best.distance && index_[i] < best.rod && best.rod != kNever);
      if (nearer && !(skip && skip(rod, found.value))) {
        best = {found.value, T_part_solid * found.point, index_[i]};
      }
    }
  }
  return best;
}

void DepositTree::visit(const Vec3& centre,
                        double reach,
                        std::uint32_t deposited,
                        const std::function<void(std::uint32_t)>& visit) const {
  std::vector<std::uint32_t> stack;
  if (!nodes_.empty()) {
    stack.push_back(0);
  }
  while (!stack.empty()) {
    const Node& node = nodes_[stack.back()];
    stack.pop_back();
    if (node.order > deposited || (node.centre - centre).norm() > node.radius + reach) {
      continue;
    }
    if (node.left != 0) {
      stack.push_back(node.right);
      stack.push_back(node.left);
      continue;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      if (rods_[index_[i]].order <= deposited) {
        visit(index_[i]);
      }
    }
  }
}

std::vector<DepositTree::Ball> DepositTree::balls(std::size_t count) const {
  std::vector<std::uint32_t> level;
  if (!nodes_.empty()) {
    level.push_back(0);
  }
  bool split = true;
  while (split && 2 * level.size() <= count) {
    split = false;
    std::vector<std::uint32_t> next;
    for (const std::uint32_t k : level) {
      if (nodes_[k].left == 0) {
        next.push_back(k);
      } else {
        next.push_back(nodes_[k].left);
        next.push_back(nodes_[k].right);
        split = true;
      }
    }
    level = std::move(next);
  }
  std::vector<Ball> result;
  for (const std::uint32_t k : level) {
    result.push_back({nodes_[k].centre, nodes_[k].radius, nodes_[k].order});
  }
  return result;
}

}  // namespace detail

}  // namespace wcam::collision
