// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/build.hpp"

#include "sample_meshes.hpp"
#include "slicing_fixture.hpp"
#include <gtest/gtest.h>

#include <set>

namespace wcam::toolpath {
namespace {

SlicedLayers tubeLayers(double maxSpacing = 1.0) {
  plugin::SliceInput input{{test::meshSurface(test::tubeMesh(20.0, 21.0, 180, 21))},
                           test::plate(),
                           nullptr,
                           {0.01, maxSpacing}};
  return test::slice("wcam.slicing.planar", input, R"({"step": 2.0})");
}

Toolpath build(const SlicedLayers& sliced, const std::string& params) {
  return buildToolpath(sliced, *test::plate(), PathParams::schema().read(parseJson(params)),
                       JobContext());
}

double azimuth(const Vec3& p) {
  return std::atan2(p.y(), p.x());
}

double wrapped(double angle) {
  return std::remainder(angle, 2.0 * kPi);
}

TEST(BuildToolpath, FramesAreOrthonormalDirectWithTheSurfaceNormal) {
  const Toolpath path = build(tubeLayers(), "{}");
  ASSERT_EQ(path.layers.size(), 10U);
  for (const Layer& layer : path.layers) {
    for (const PathPoint& point : layer.beads.at(0).points) {
      EXPECT_NEAR((point.t.cross(point.n) - point.b).norm(), 0.0, 1e-12);
      EXPECT_NEAR(point.t.norm(), 1.0, 1e-12);
      EXPECT_NEAR(point.t.dot(point.n), 0.0, 1e-12);
      EXPECT_NEAR((point.b - Vec3::UnitZ()).norm(), 0.0, 1e-9);
      EXPECT_GT(point.n.dot(Vec3(point.p.x(), point.p.y(), 0).normalized()), 0.999);
      EXPECT_EQ(point.axis, point.up);
      EXPECT_NEAR(point.height, 2.0, 1e-9);
    }
  }
}

TEST(BuildToolpath, ClosedBeadsRepeatTheirFirstPoint) {
  const Toolpath path = build(tubeLayers(), "{}");
  for (const Layer& layer : path.layers) {
    const Bead& bead = layer.beads.at(0);
    EXPECT_TRUE(bead.closed);
    EXPECT_EQ(bead.points.front().p, bead.points.back().p);
    EXPECT_NEAR(bead.length(), 2.0 * kPi * 20.0, 0.2);
  }
}

TEST(BuildToolpath, ExactTorusNormalsAndBuildDirections) {
  // Chalvin AT-21: n = (cos v cos u, sin v, cos v sin u), b along the guide for guide-normal
  // layers.
  plugin::SliceInput input{{test::importSample("elbow/elbow.step")}, test::plate(), nullptr, {}};
  input.guide = geometry::guideFromFormula({"50*cos(t)-50", "0", "50*sin(t)"}, 0.0, kPi / 2.0);
  const Toolpath path =
      build(test::slice("wcam.slicing.guide", input, R"({"step": 5.0})"), R"({"axis": "local"})");
  for (const Layer& layer : path.layers) {
    for (const PathPoint& point : layer.beads.at(0).points) {
      const double u = std::atan2(point.p.z(), point.p.x() + 50.0);
      const double v = std::atan2(point.p.y(), std::hypot(point.p.x() + 50.0, point.p.z()) - 50.0);
      EXPECT_NEAR(
          (point.n - Vec3(std::cos(v) * std::cos(u), std::sin(v), std::cos(v) * std::sin(u)))
              .norm(),
          0.0, 1e-6);
      EXPECT_NEAR((point.b - Vec3(-std::sin(u), 0, std::cos(u))).norm(), 0.0, 1e-6);
      EXPECT_EQ(point.axis, point.b);
    }
  }
}

TEST(Seam, AlignedStartsLieInOneDirection) {
  for (const double direction : {0.0, 90.0, -135.0}) {
    const Toolpath path = build(tubeLayers(), R"({"seam": "aligned", "seam_direction": )" +
                                                  std::to_string(direction) + "}");
    for (const Layer& layer : path.layers) {
      EXPECT_NEAR(wrapped(azimuth(layer.beads[0].points[0].p) - degToRad(direction)), 0.0,
                  0.5 / 20.0 + 1e-9);
    }
  }
}

TEST(Seam, NearestStartsWhereTheLastBeadEnded) {
  // Chalvin A14, AT-16: the start is the point of the contour nearest to the last end; no point is
  // lost.
  const SlicedLayers sliced = tubeLayers();
  const Toolpath path = build(sliced, R"({"seam": "nearest"})");
  for (std::size_t l = 1; l < path.layers.size(); ++l) {
    const Vec3 end = path.layers[l - 1].beads[0].points.back().p;
    const double start = (path.layers[l].beads[0].points.front().p - end).norm();
    std::multiset<double> before;
    std::multiset<double> after;
    for (const ContourPoint& point : sliced.layers[l].contours[0].points) {
      EXPECT_LE(start, (point.p - end).norm() + 1e-12);
      before.insert(point.p.x());
    }
    for (std::size_t i = 0; i + 1 < path.layers[l].beads[0].points.size(); ++i) {
      after.insert(path.layers[l].beads[0].points[i].p.x());
    }
    EXPECT_EQ(before, after);
  }
}

TEST(Seam, ShiftedStartsMoveOnByALength) {
  const Toolpath path = build(tubeLayers(), R"({"seam": "shifted", "seam_shift": 12.0})");
  for (std::size_t l = 1; l < path.layers.size(); ++l) {
    const double turn = wrapped(azimuth(path.layers[l].beads[0].points[0].p) -
                                azimuth(path.layers[l - 1].beads[0].points[0].p));
    EXPECT_NEAR(std::abs(turn) * 20.0, 12.0, 1.01);
  }
}

TEST(Seam, GoldenRatioNeverPutsThreeStartsTogether) {
  const Toolpath path = build(tubeLayers(), R"({"seam": "golden"})");
  for (std::size_t l = 1; l < path.layers.size(); ++l) {
    for (std::size_t k = l >= 3 ? l - 3 : 0; k < l; ++k) {
      const double turn = wrapped(azimuth(path.layers[l].beads[0].points[0].p) -
                                  azimuth(path.layers[k].beads[0].points[0].p));
      EXPECT_GT(std::abs(turn), 2.0 * kPi * 0.1);
    }
  }
}

TEST(Seam, RandomStartsFollowTheSeed) {
  const SlicedLayers sliced = tubeLayers();
  const auto starts = [&](int seed) {
    std::vector<double> x;
    for (const Layer& layer :
         build(sliced, R"({"seam": "random", "seam_seed": )" + std::to_string(seed) + "}").layers) {
      x.push_back(layer.beads[0].points[0].p.x());
    }
    return x;
  };
  EXPECT_EQ(starts(3), starts(3));
  EXPECT_NE(starts(3), starts(4));
}

TEST(BuildToolpath, AlternateReversesEveryOtherLayerAndKeepsTheBuildDirection) {
  const Toolpath path = build(tubeLayers(), R"({"alternate": true})");
  for (std::size_t l = 0; l < path.layers.size(); ++l) {
    const auto& points = path.layers[l].beads[0].points;
    const double turn = wrapped(azimuth(points[1].p) - azimuth(points[0].p));
    EXPECT_EQ(turn > 0.0, l % 2 == 1) << "layer " << l;
    EXPECT_NEAR((points[3].b - Vec3::UnitZ()).norm(), 0.0, 1e-9);
  }
}

TEST(BuildToolpath, LeadLeansTheAxisForward) {
  const Toolpath path = build(tubeLayers(), R"({"lead": 20.0})");
  for (const PathPoint& point : path.layers[2].beads[0].points) {
    EXPECT_NEAR(point.axis.dot(point.t), std::sin(degToRad(20.0)), 1e-6);
    EXPECT_NEAR(point.axis.dot(point.n), 0.0, 1e-6);
    EXPECT_EQ(point.up, Vec3(0, 0, 1));
  }
}

TEST(BuildToolpath, LateralTiltAndNormalsStayOutwardsWhicheverWayABeadRuns) {
  const Toolpath path = build(tubeLayers(), R"({"alternate": true, "lateral_tilt": 15.0})");
  for (std::size_t l = 0; l < path.layers.size(); ++l) {
    const Bead& bead = path.layers[l].beads[0];
    EXPECT_EQ(bead.back, l % 2 == 1) << l;
    for (const PathPoint& point : bead.points) {
      const Vec3 out = Vec3(point.p.x(), point.p.y(), 0).normalized();
      EXPECT_GT(bead.outward(point).dot(out), 0.999) << l;
      EXPECT_NEAR(point.axis.dot(bead.outward(point)), std::sin(degToRad(15.0)), 1e-6) << l;
    }
  }
}

TEST(BuildToolpath, BeadsInTheAirAndBesideThePlateAreReported) {
  geometry::TriangleMesh hanging = test::tubeMesh(8.0, 10.0, 60, 10);
  for (Vec3& v : hanging.vertices) {
    v += Vec3(120.0, 0.0, 10.0);
  }
  plugin::SliceInput input{
      {test::meshSurface(test::tubeMesh(20.0, 21.0, 90, 21)), test::meshSurface(hanging)},
      test::plate(),
      nullptr,
      {}};
  const SlicedLayers sliced = test::slice("wcam.slicing.planar", input, R"({"step": 2.0})");
  JobContext context;
  (void)buildToolpath(sliced, *test::plate(), PathParams{}, context);
  EXPECT_EQ(context.diagnostics().count("toolpath.unsupported"), 1U);
  EXPECT_EQ(context.diagnostics().count("toolpath.outside_plate"), 0U);
  const Substrate small(geometry::Pose::Identity(), Vec3(30, 100, 10));
  (void)buildToolpath(sliced, small, PathParams{}, context);
  EXPECT_EQ(context.diagnostics().count("toolpath.outside_plate"), 1U);
}

TEST(BuildToolpath, SeveralPartsShareALayer) {
  geometry::TriangleMesh second = test::tubeMesh(8.0, 21.0, 60, 21);
  for (Vec3& v : second.vertices) {
    v.x() += 60.0;
  }
  plugin::SliceInput input{
      {test::meshSurface(test::tubeMesh(20.0, 21.0, 90, 21)), test::meshSurface(second)},
      test::plate(),
      nullptr,
      {}};
  const Toolpath path = build(test::slice("wcam.slicing.planar", input, R"({"step": 2.0})"), "{}");
  for (const Layer& layer : path.layers) {
    ASSERT_EQ(layer.beads.size(), 2U);
    EXPECT_NE(layer.beads[0].part, layer.beads[1].part);
  }
}

}  // namespace
}  // namespace wcam::toolpath
