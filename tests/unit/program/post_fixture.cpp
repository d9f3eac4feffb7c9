// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "post_fixture.hpp"

#include "wcam/base/json.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/plugin/host.hpp"
#include "wcam/testing/sample_program.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace wcam::test {

namespace {

struct Planner {
  std::vector<PlannedMove> moves;
  bool arc = false;

  void operator()(const program::MoveJoint& m) {
    moves.push_back({ReadKind::Joint, m.target, 100.0 * m.speedRatio, m.stop, arc});
  }

  void operator()(const program::MoveLinear& m) {
    moves.push_back({ReadKind::Linear, m.target, m.speed, m.stop, arc});
  }

  void operator()(const program::MoveCircular& m) {
    moves.push_back({ReadKind::CircularVia, m.via, m.speed, false, arc});
    moves.push_back({ReadKind::Circular, m.target, m.speed, m.stop, arc});
  }

  void operator()(const program::ArcOn&) { arc = true; }

  void operator()(const program::ArcOff&) { arc = false; }

  template <class Other>
  void operator()(const Other&) {}
};

}  // namespace

Files runPost(const std::string& id,
              const program::Program& program,
              const std::string& params,
              const JobContext& context) {
  static const plugin::PluginHost kHost(plugin::defaultPluginSearch({}, false));
  const auto component = kHost.findPost(id);
  Files files;
  for (plugin::OutputFile& file : component->post->post(program, parseJson(params), context)) {
    files.emplace_back(std::move(file.name), std::move(file.content));
  }
  return files;
}

std::vector<PlannedMove> plannedMoves(const program::Program& program) {
  Planner planner;
  for (const program::Instruction& instruction : program.instructions) {
    std::visit(planner, instruction.action);
  }
  return std::move(planner.moves);
}

double angleBetween(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  // The sine form keeps its precision for small angles.
  return 2.0 * std::asin(std::min(1.0, (a - b).norm() / std::sqrt(8.0))) * 180.0 / kPi;
}

bool sameStructure(const ReadJob& job,
                   const std::vector<PlannedMove>& planned,
                   double jointTolerance,
                   bool arcs) {
  for (const std::string& problem : job.problems) {
    ADD_FAILURE() << problem;
  }
  EXPECT_EQ(job.moves.size(), planned.size());
  if (job.moves.size() != planned.size() || !job.problems.empty()) {
    return false;
  }
  for (std::size_t i = 0; i < planned.size(); ++i) {
    const ReadMove& read = job.moves[i];
    const PlannedMove& plan = planned[i];
    EXPECT_EQ(read.stop, plan.stop) << i;
    EXPECT_TRUE(!arcs || read.arc == plan.arc) << i;
    const Eigen::Index positioner = plan.target.joints.size() - 6;
    EXPECT_EQ(static_cast<Eigen::Index>(read.external.size()), positioner) << i;
    if (static_cast<Eigen::Index>(read.external.size()) != positioner) {
      return false;
    }
    for (Eigen::Index k = 0; k < positioner; ++k) {
      EXPECT_NEAR(read.external[static_cast<std::size_t>(k)], radToDeg(plan.target.joints[6 + k]),
                  jointTolerance)
          << i;
    }
  }
  return !::testing::Test::HasFailure();
}

program::Program randomProgram(unsigned seed, int beads, int pointsPerBead) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> angle(-kPi, kPi);
  std::uniform_real_distribution<double> joint(-2.0 * kPi, 2.0 * kPi);
  std::uniform_real_distribution<double> position(-2000.0, 2000.0);
  std::uniform_real_distribution<double> speed(1.0, 40.0);
  program::Program result =
      testing::sampleProgram({.layers = beads, .pointsPerBead = pointsPerBead});
  const auto randomPose = [&] {
    program::Pose pose = program::Pose::Identity();
    pose.translation() << position(random), position(random), position(random);
    pose.linear() = (Eigen::AngleAxisd(angle(random), Eigen::Vector3d::UnitZ()) *
                     Eigen::AngleAxisd(angle(random), Eigen::Vector3d::UnitY()) *
                     Eigen::AngleAxisd(angle(random), Eigen::Vector3d::UnitX()))
                        .toRotationMatrix();
    return pose;
  };
  const auto shuffle = [&](program::Target& target) {
    for (double& value : target.joints) {
      value = joint(random);
    }
    target.T_base_tcp = randomPose();
    target.T_table_tcp = randomPose();
  };
  for (program::Instruction& instruction : result.instructions) {
    if (auto* jointMove = std::get_if<program::MoveJoint>(&instruction.action)) {
      shuffle(jointMove->target);
    } else if (auto* linear = std::get_if<program::MoveLinear>(&instruction.action)) {
      shuffle(linear->target);
      linear->speed = speed(random);
    } else if (auto* circular = std::get_if<program::MoveCircular>(&instruction.action)) {
      program::Target via = circular->via;
      shuffle(via);
      circular->via = via;
      shuffle(circular->target);
    }
  }
  return result;
}

}  // namespace wcam::test
