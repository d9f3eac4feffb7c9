// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/program/program.hpp"

#include <cmath>
#include <string>

/// Programs for tests of post-processors.
namespace wcam::testing {

struct SampleOptions {
  int layers = 2;
  int pointsPerBead = 25;
  int positionerJoints = 2;
  double speed = 6.0;         ///< mm/s on deposition moves
  double travelSpeed = 50.0;  ///< mm/s on approach and retract moves
};

namespace detail {

/// A target with smooth, made-up joints and poses: not the kinematics of a real robot.
inline program::Target sampleTarget(double turn, double height, int positionerJoints) {
  using geometry::Pose;
  program::Target target;
  target.joints.resize(6 + positionerJoints);
  target.joints.head(6) << 0.4 * std::sin(turn), -0.2 + 0.01 * height, 0.5 + 0.1 * std::cos(turn),
      -2.0 + 0.3 * turn, -0.9 + 0.2 * std::sin(2.0 * turn), 3.3 - 0.9 * turn;
  for (int i = 0; i < positionerJoints; ++i) {
    target.joints[6 + i] = i == 0 ? 0.3 * std::cos(turn) : turn;
  }
  target.T_base_tcp =
      Eigen::Translation3d(900.0 + 50.0 * std::cos(turn), 50.0 * std::sin(turn), 300.0 + height) *
      Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) *
      Eigen::AngleAxisd(3.0, Eigen::Vector3d::UnitY()) *
      Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX());
  target.T_table_tcp = Eigen::Translation3d(50.0 * std::cos(turn), 50.0 * std::sin(turn), height) *
                       Eigen::AngleAxisd(-turn, Eigen::Vector3d::UnitZ()) *
                       Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitY());
  return target;
}

}  // namespace detail

/// One round bead per layer: joint move to the start, arc on, linear moves, arc off, retract. Uses
/// every instruction at least once.
inline program::Program sampleProgram(const SampleOptions& options = {}) {
  namespace ir = program;
  constexpr double kTurn = 6.283185307179586;
  constexpr double kLayerHeight = 2.0;
  constexpr double kClearance = 30.0;
  ir::Program result;
  result.name = "sample";
  result.projectName = "conformance";
  result.cell.cellName = "sample cell";
  result.cell.positionerJoints = options.positionerJoints;
  for (int i = 0; i < 6 + options.positionerJoints; ++i) {
    result.cell.jointNames.push_back("J" + std::to_string(i + 1));
    result.cell.linearJoint.push_back(false);
    result.cell.jointSpeeds.push_back(3.0);
  }
  const auto add = [&result](ir::Action action, ir::Origin origin) {
    result.instructions.push_back({std::move(action), origin});
  };
  add(ir::Comment{"sample program"}, {});
  for (int layer = 0; layer < options.layers; ++layer) {
    const double height = kLayerHeight * (layer + 1);
    const auto target = [&](double turn, double above) {
      return detail::sampleTarget(turn, height + above, options.positionerJoints);
    };
    const ir::Origin place{layer, 0, -1};
    add(ir::LayerBegin{layer}, place);
    add(ir::MoveJoint{target(0.0, kClearance), 0.2, false}, place);
    add(ir::BeadBegin{layer, 0}, place);
    add(ir::MoveLinear{target(0.0, 0.0), options.travelSpeed, true}, {layer, 0, 0});
    add(ir::SetProcess{50.0}, place);
    add(ir::ArcOn{3}, place);
    const int last = options.pointsPerBead - 1;
    for (int i = 1; i <= last; ++i) {
      add(ir::MoveLinear{target(kTurn * i / last, 0.0), options.speed, i == last}, {layer, 0, i});
    }
    add(ir::ArcOff{0.5}, place);
    add(ir::BeadEnd{layer, 0}, place);
    add(ir::MoveLinear{target(kTurn, kClearance), options.travelSpeed, false}, place);
    add(ir::Wait{1.5}, place);
    add(ir::SetIo{7, layer % 2 == 0}, place);
    add(ir::MoveCircular{target(0.9 * kTurn, kClearance), target(0.8 * kTurn, kClearance),
                         options.travelSpeed, false},
        place);
    add(ir::LayerEnd{layer}, place);
  }
  return result;
}

}  // namespace wcam::testing
