// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/file_io.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/cell/kinematics.hpp"
#include "wcam/project/run.hpp"

#include "every_strategy.hpp"
#include "example_project.hpp"
#include "ls_reader.hpp"
#include "test_folder.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>

/// Every strategy from a part file to the program of a robot. What is checked is read out of the
/// program by the separately written reader and forward kinematics: where the arc burns, for how
/// long, and how much wire that is, against closed forms.
namespace wcam::project {
namespace {

struct Case {
  std::string strategy;
  std::size_t arcs;   ///< beads; 0: not known beforehand
  double length;      ///< of all beads, mm; 0: not known beforehand
  double volume = 0;  ///< of the wire, mm3; 0: not known beforehand
};

/// What a program burns.
struct Burnt {
  std::size_t arcs = 0;
  double length = 0.0;   ///< of the moves with the arc on, mm
  double volume = 0.0;   ///< of the wire that these moves take, mm3
  double offPart = 0.0;  ///< how far the wire leaves the part, mm
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.strategy;
}

class AllStrategies : public ::testing::TestWithParam<Case> {
protected:
  /// How far a point lies off what is to be built, mm.
  static double offPart(const geometry::Vec3& p) {
    const std::string& strategy = GetParam().strategy;
    if (strategy == "bulk" || strategy == "cladding") {
      const double top = strategy == "bulk" ? test::kBox.z() : 2.0;
      return std::max({std::abs(p.x()) - test::kBox.x() / 2.0,
                       std::abs(p.y()) - test::kBox.y() / 2.0, -p.z(), p.z() - top});
    }
    return std::max({std::abs(std::hypot(p.x(), p.y()) - test::kTubeRadius), -p.z(),
                     p.z() - test::kTubeHeight});
  }

  /// From the program alone: its moves, its comments, and the cell's kinematics.
  Burnt readBack(const cell::Cell& cell) const {
    std::string name = GetParam().strategy + "_CONSTANT.LS";
    std::transform(name.begin(), name.end(), name.begin(), ::toupper);
    const test::ReadJob job = test::readLs({{name, readFile(folder_ / "out" / name)}});
    EXPECT_EQ(job.problems, std::vector<std::string>{});
    double wireSpeed = 0.0;  // m/min
    for (const std::string& comment : job.comments) {
      (void)std::sscanf(comment.c_str(), "Wire speed %lf m/min", &wireSpeed);
    }
    EXPECT_GT(wireSpeed, 0.0);
    const double wireFlow = wireSpeed * 1000.0 / 60.0 * kPi / 4.0 * 1.2 * 1.2;  // mm3/s
    Burnt burnt;
    burnt.arcs = job.arcSchedules.size();
    geometry::Vec3 last;
    for (const test::ReadMove& move : job.moves) {
      cell::JointVector q(cell.jointCount());
      for (std::size_t j = 0; j < move.joints.size() + move.external.size(); ++j) {
        q[static_cast<Eigen::Index>(j)] = degToRad(
            j < move.joints.size() ? move.joints[j] : move.external[j - move.joints.size()]);
      }
      const geometry::Vec3 p = cell::T_part_tcp(cell, q).translation();
      if (move.arc) {
        const double length = (p - last).norm();
        burnt.length += length;
        burnt.volume += length / move.speed * wireFlow;
        burnt.offPart = std::max(burnt.offPart, offPart(p));
      }
      last = p;
    }
    return burnt;
  }

  testing::TestFolder folder_;
};

TEST_P(AllStrategies, BurnWhatTheyShould) {
  const Case& expected = GetParam();
  const std::filesystem::path file = test::writeEveryStrategy(folder_.path(), {"constant"});
  const Pipeline pipeline(loadProject(file).document, file, test::hostOfPlugins());
  RunRequest request;
  request.operations = {expected.strategy + "-constant"};
  request.folder = folder_ / "out";
  const RunResult run = runProject(pipeline, request, JobContext());
  for (const OperationResult& outcome : run.operations) {
    for (const Diagnostic& finding : outcome.findings) {
      EXPECT_NE(finding.severity, Severity::Violation) << toLine(finding);
    }
  }
  for (const RunFailure& failure : run.failures) {
    ADD_FAILURE() << failure.error.what() << "; " << failure.error.hint();
  }
  ASSERT_EQ(run.exitCode(), 0);
  ASSERT_EQ(run.operations.size(), 1U);
  const Burnt burnt = readBack(*run.operations[0].cell);
  if (expected.arcs > 0) {
    EXPECT_EQ(burnt.arcs, expected.arcs);
  }
  if (expected.length > 0.0) {
    EXPECT_NEAR(burnt.length, expected.length, 0.002 * expected.length);
  }
  if (expected.volume > 0.0) {
    EXPECT_NEAR(burnt.volume, expected.volume, 0.03 * expected.volume);
  }
  EXPECT_LT(burnt.offPart, 0.05);
}

constexpr double kCircles = 5 * 2 * kPi * test::kTubeRadius;  // of the tube, mm

INSTANTIATE_TEST_SUITE_P(Twelve,
                         AllStrategies,
                         ::testing::Values(Case{"planar", 5, kCircles},
                                           Case{"guide", 5, kCircles},
                                           Case{"geodesic", 5, kCircles},
                                           Case{"isovalues", 5, kCircles},
                                           Case{"constant", 5, kCircles},
                                           Case{"isoparam", 5, kCircles},
                                           Case{"branches", 5, kCircles},
                                           Case{"radial", 5, kCircles},
                                           Case{"import", 5, kCircles},
                                           // Five revolutions from border to border.
                                           Case{"spiral", 1, kCircles},
                                           Case{"bulk", 0, 0.0, test::kBox.prod()},
                                           // The face times the layer's height.
                                           Case{"cladding", 0, 0.0,
                                                2.0 * test::kBox.x() * test::kBox.y()}));

}  // namespace
}  // namespace wcam::project
