// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/cell/kinematics.hpp"
#include "wcam/project/run.hpp"

#include "example_project.hpp"
#include "ls_reader.hpp"
#include "test_folder.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

/// Every strategy from a part file to the program of a robot. What is checked is read out of the
/// program by the separately written reader and forward kinematics: where the arc burns, for how
/// long, and how much wire that is, against closed forms.
namespace wcam::project {
namespace {

constexpr double kRadius = 30.0;       // of the tube, mm
constexpr double kHeight = 20.0;       // of the tube, mm
constexpr double kStep = 4.0;          // mm
constexpr double kWireDiameter = 1.2;  // mm
const geometry::Vec3 kBox(60.0, 40.0, 12.0);

const char* const kTube =
    R"({"format_version": 1, "surface": {"type": "revolution", "radius": 30, "z": [0, 20]}})";
const char* const kSheet = R"({"format_version": 1, "surface": {"type": "parametric",
    "x": "u", "y": "v", "z": "0", "u": [-30, 30], "v": [-20, 20]}})";

std::string box() {
  std::string text = "solid box\n";
  const auto triangle = [&](const geometry::Vec3& a, const geometry::Vec3& b,
                            const geometry::Vec3& c) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const geometry::Vec3& p : {a, b, c}) {
      text += "vertex " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
              std::to_string(p.z()) + "\n";
    }
    text += "endloop\nendfacet\n";
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-0.5, 0.5}) {
      geometry::Vec3 u = geometry::Vec3::Unit((axis + 1) % 3);
      geometry::Vec3 v = geometry::Vec3::Unit((axis + 2) % 3);
      if (side < 0.0) {
        std::swap(u, v);
      }
      const auto corner = [&](double s, double t) -> geometry::Vec3 {
        return (side * geometry::Vec3::Unit(axis) + s * u + t * v).cwiseProduct(kBox) +
               geometry::Vec3(0.0, 0.0, kBox.z() / 2.0);
      };
      triangle(corner(-0.5, -0.5), corner(0.5, -0.5), corner(0.5, 0.5));
      triangle(corner(-0.5, -0.5), corner(0.5, 0.5), corner(-0.5, 0.5));
    }
  }
  return text + "endsolid box\n";
}

/// Five circles of the tube, as a table of points.
std::string circles() {
  constexpr int kPoints = 120;
  std::string text = "layer,bead,x_mm,y_mm,z_mm\n";
  for (int layer = 0; layer < 5; ++layer) {
    for (int i = 0; i <= kPoints; ++i) {
      const double angle = 2.0 * kPi * (i % kPoints) / kPoints;
      text += std::to_string(layer) + ",0," + std::to_string(kRadius * std::cos(angle)) + "," +
              std::to_string(kRadius * std::sin(angle)) + "," +
              std::to_string(kStep * (layer + 1)) + "\n";
    }
  }
  return text;
}

struct Case {
  std::string strategy;
  std::string part;    ///< file name and text of the part; empty: the strategy takes a file
  std::string params;  ///< JSON
  std::size_t arcs;    ///< beads; 0: not known beforehand
  double length;       ///< of all beads, mm; 0: not known beforehand
  double volume = 0;   ///< of the wire, mm3; 0: not known beforehand
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
  Document document() const {
    const Case& c = GetParam();
    Value file = Value::object({{"path", c.part.empty() ? "circles.csv" : c.part}});
    Value operation = Value::object({{"id", "build"},
                                     {"strategy", c.strategy},
                                     {"parts", Value::array()},
                                     {"substrate", "plate"},
                                     {"process", "steel"},
                                     {"params", parseJson(c.params)}});
    Document result = parseProject();
    if (c.part.empty()) {
      operation.set("file", file);
    } else {
      result = apply(result, {"part.add", Value::object({{"id", "part"}, {"file", file}})});
      operation.set("parts", Value(Value::Array{Value("part")}));
    }
    return test::withQuickMotion(apply(result, {"operation.add", operation}));
  }

  /// Cell, plate and process.
  Document parseProject() const {
    writeFileAtomically(folder_ / "tube.wsurf", kTube);
    writeFileAtomically(folder_ / "sheet.wsurf", kSheet);
    writeFileAtomically(folder_ / "box.stl", box());
    writeFileAtomically(folder_ / "circles.csv", circles());
    writeFileAtomically(folder_ / "all.wcam", R"({"format": "wcam-project", "format_version": 1,
      "name": "all", "cell": {"path": "wcam:cells/fanuc_arcmate120ic.json"},
      "substrates": [{"id": "plate", "type": "plate", "size_mm": [200, 200, 10]}],
      "processes": [{"id": "steel",
                     "params": {"wire_diameter": 1.2, "wire_speed": 6.0, "bead_width": 6.0}}],
      "outputs": [{"id": "robot", "post": "wcam.post.fanuc", "params": {"mode": "joint", "speed_decimals": 3}}]})");
    return loadProject(folder_ / "all.wcam").document;
  }

  /// How far a point lies off what is to be built, mm.
  static double offPart(const geometry::Vec3& p) {
    if (GetParam().part == "tube.wsurf" || GetParam().part.empty()) {
      return std::max({std::abs(std::hypot(p.x(), p.y()) - kRadius), -p.z(), p.z() - kHeight});
    }
    const double top = GetParam().part == "box.stl" ? kBox.z() : 2.0;
    return std::max(
        {std::abs(p.x()) - kBox.x() / 2.0, std::abs(p.y()) - kBox.y() / 2.0, -p.z(), p.z() - top});
  }

  /// From the program alone: its moves, its comments, and the cell's kinematics.
  Burnt readBack(const cell::Cell& cell) const {
    const test::ReadJob job = test::readLs({{"BUILD.LS", readFile(folder_ / "out/BUILD.LS")}});
    EXPECT_EQ(job.problems, std::vector<std::string>{});
    double wireSpeed = 0.0;  // m/min
    for (const std::string& comment : job.comments) {
      (void)std::sscanf(comment.c_str(), "Wire speed %lf m/min", &wireSpeed);
    }
    EXPECT_GT(wireSpeed, 0.0);
    const double wireFlow =
        wireSpeed * 1000.0 / 60.0 * kPi / 4.0 * kWireDiameter * kWireDiameter;  // mm3/s
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
  const Document project = document();
  const Pipeline pipeline(project, folder_ / "all.wcam", test::hostOfPlugins());
  RunRequest request;
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

constexpr double kCircles = 5 * 2 * kPi * kRadius;  // of the tube, mm

INSTANTIATE_TEST_SUITE_P(
    Twelve,
    AllStrategies,
    ::testing::Values(
        Case{"wcam.slicing.planar", "tube.wsurf", R"({"step": 4})", 5, kCircles},
        Case{"wcam.slicing.guide", "tube.wsurf", R"({"step": 4, "automatic_guide": true})", 5,
             kCircles},
        Case{"wcam.slicing.geodesic", "tube.wsurf", R"({"step": 4})", 5, kCircles},
        Case{"wcam.slicing.isovalues", "tube.wsurf", R"({"step": 4})", 5, kCircles},
        Case{"wcam.slicing.constant", "tube.wsurf", R"({"step": 4})", 5, kCircles},
        Case{"wcam.slicing.isoparam", "tube.wsurf", R"({"step": 4})", 5, kCircles},
        Case{"wcam.slicing.branches", "tube.wsurf", R"({"step": 4})", 5, kCircles},
        // Cones of 0 degrees are planes across the axis.
        Case{"wcam.slicing.radial", "tube.wsurf",
             R"({"step": 4, "shape": "cone", "cone_angle": 0})", 5, kCircles},
        Case{"wcam.slicing.import", "", "{}", 5, kCircles},
        // Five revolutions from border to border.
        Case{"wcam.slicing.spiral", "tube.wsurf",
             R"({"step": 4, "height_min": 2, "height_max": 6})", 1, kCircles},
        Case{"wcam.slicing.bulk", "box.stl", R"({"step": 2})", 0, 0.0, kBox.prod()},
        // Level from the first centre line to the last one, half a parabola of 6 mm beyond each.
        Case{"wcam.slicing.cladding", "sheet.wsurf", R"({"step": 2})", 0, 0.0,
             2.0 * kBox.x() * (kBox.y() - 6.0 + 2.0 / 3.0 * 6.0)}));

}  // namespace
}  // namespace wcam::project
