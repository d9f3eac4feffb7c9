// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/quantity.hpp"
#include "wcam/cell/angles.hpp"
#include "wcam/cell/arm.hpp"
#include "wcam/cell/cell.hpp"
#include "wcam/collision/cell_collision.hpp"

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace wcam::collision::test {

using geometry::Pose;
using geometry::Vec3;

inline cell::Cell shippedCell(const std::string& name) {
  return cell::loadCell(std::string(WCAM_RESOURCES) + "/cells/" + name + ".json");
}

inline double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
}

inline toolpath::PathPoint pathPoint(const Vec3& p, const Vec3& t, const Vec3& b) {
  toolpath::PathPoint point;
  point.p = p;
  point.t = t;
  point.b = b;
  point.n = b.cross(t);
  point.axis = b;
  point.up = b;
  point.height = 2.0;
  point.width = 6.0;
  point.speed = 10.0;
  return point;
}

/// A tube of radius 30 whose axis bends with radius 100 from the vertical to `bend` rad.
inline toolpath::Toolpath bentTube(int layers, int points, double bend) {
  constexpr double kBend = 100.0;
  constexpr double kRadius = 30.0;
  toolpath::Toolpath path;
  for (int l = 1; l <= layers; ++l) {
    const double angle = bend * l / layers;
    const Vec3 across(std::cos(angle), 0, -std::sin(angle));
    const Vec3 along(std::sin(angle), 0, std::cos(angle));
    const Vec3 centre(kBend * (1 - std::cos(angle)), 0, kBend * std::sin(angle));
    toolpath::Bead bead;
    bead.closed = true;
    for (int i = 0; i <= points; ++i) {
      const double a = 2 * kPi * (i % points) / points;
      const Vec3 out = std::cos(a) * across + std::sin(a) * Vec3::UnitY();
      bead.points.push_back(pathPoint(centre + kRadius * out, along.cross(out), along));
    }
    toolpath::Layer layer;
    layer.beads.push_back(std::move(bead));
    path.layers.push_back(std::move(layer));
  }
  return path;
}

/// A straight wall along x.
inline toolpath::Toolpath straightWall(int layers, double length, double spacing) {
  toolpath::Toolpath path;
  for (int l = 1; l <= layers; ++l) {
    toolpath::Bead bead;
    for (double x = 0.0; x <= length; x += spacing) {
      bead.points.push_back(pathPoint(Vec3(x, 0, 2.0 * l), Vec3::UnitX(), Vec3::UnitZ()));
    }
    toolpath::Layer layer;
    layer.beads.push_back(std::move(bead));
    path.layers.push_back(std::move(layer));
  }
  return path;
}

/// States with the torch near the part: the positioner anywhere, a random branch of the arm.
inline std::vector<CellState> randomStates(const cell::Cell& cell,
                                           const toolpath::Toolpath& path,
                                           std::size_t count,
                                           std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Vec3> points;
  for (const toolpath::Layer& layer : path.layers) {
    for (const toolpath::PathPoint& point : layer.beads[0].points) {
      points.push_back(point.p);
    }
  }
  std::vector<CellState> states;
  while (states.size() < count) {
    CellState state;
    state.joints = cell::JointVector::Zero(cell.jointCount());
    std::array<double, 2> positioner{uniform(random, -1.5, 1.5), uniform(random, -3, 3)};
    const std::size_t at = random() % points.size();
    const Vec3 p = points[at] + Vec3(uniform(random, -30, 30), uniform(random, -30, 30),
                                     uniform(random, -10, 40));
    const Vec3 lean(uniform(random, -0.6, 0.6), uniform(random, -0.6, 0.6), 1.0);
    const double turn = uniform(random, -kPi, kPi);
    Pose flange = Pose::Identity();
    if (cell.partCarried()) {
      Pose T_base_part = Pose::Identity();
      T_base_part.linear() =
          cell.T_base_tcp.linear() * cell::axisToVertical(lean.normalized(), turn);
      T_base_part.translation() = cell.T_base_tcp.translation() - T_base_part.linear() * p;
      flange = T_base_part * (cell.T_flange_table * cell.T_table_part).inverse();
    } else {
      const Pose T_base_part =
          cell::chainPose(cell.positioner, positioner.data()) * cell.T_table_part;
      Pose tcp = Pose::Identity();
      tcp.linear() = cell::frameWithZ(T_base_part.linear() * lean.normalized(), turn);
      tcp.translation() = T_base_part * p;
      flange = tcp * cell.T_flange_tcp.inverse();
    }
    const cell::IkResult solutions = cell::inverseArm(*cell.arm, flange);
    const cell::IkSolution& solution = solutions[random() % solutions.size()];
    if (!solution.reachable) {
      continue;
    }
    state.joints.head<6>() = solution.joints;
    for (int j = 0; j < cell.positionerJoints(); ++j) {
      state.joints(6 + j) = positioner[static_cast<std::size_t>(j)];
    }
    state.deposited = random() % (points.size() + 1);
    states.push_back(state);
  }
  return states;
}

}  // namespace wcam::collision::test
