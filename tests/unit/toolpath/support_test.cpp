// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a point of a bead lies on, and how far: the layer below, or the substrate where that is met
// first.

#include "wcam/toolpath/build.hpp"

#include "hand_made_layers.hpp"
#include "sample_meshes.hpp"
#include "slicing_fixture.hpp"
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace wcam::toolpath {
namespace {

Toolpath build(const SlicedLayers& sliced,
               const Substrate& substrate,
               const std::string& params = "{}",
               double width = 6.0,
               const JobContext& context = JobContext()) {
  BeadRange range;
  range.width = width;
  return buildToolpath(sliced, substrate, PathParams::schema().read(parseJson(params)), context,
                       range);
}

/// A circle about z whose wall leans outwards from the vertical by an angle.
Contour leaningCircle(double radius, double z, double lean, int points = 72) {
  Contour contour = test::circle(radius, z, Vec3::Zero(), points);
  for (ContourPoint& point : contour.points) {
    point.n = std::cos(lean) * point.n - std::sin(lean) * Vec3::UnitZ();
  }
  return contour;
}

/// Layers one step apart along a cone that leans outwards, the first one step above z = 0.
SlicedLayers cone(double lean, double step, int layers) {
  SlicedLayers sliced;
  sliced.curved = true;
  for (int k = 1; k <= layers; ++k) {
    const double way = step * k;
    sliced.layers.push_back(test::layerOf(
        way, {leaningCircle(50.0 + way * std::sin(lean), way * std::cos(lean), lean)}));
    sliced.layers.back().nominalHeight = step;
  }
  return sliced;
}

TEST(LayerDistance, AWallThatGrowsSidewaysNearThePlateLiesOnItself) {
  // 85 degrees from the vertical: ten layers of 2 mm rise to 1.7 mm above the plate.
  const Toolpath path = build(cone(degToRad(85.0), 2.0, 10), *test::plate());
  for (std::size_t l = 1; l < path.layers.size(); ++l) {
    for (const PathPoint& point : path.layers[l].beads[0].points) {
      EXPECT_NEAR(point.distance, 2.0, 1e-9) << "layer " << l;
      EXPECT_NEAR(point.height, 2.0, 1e-9);
    }
  }
  // The first lies on the plate.
  for (const PathPoint& point : path.layers[0].beads[0].points) {
    EXPECT_NEAR(point.distance, 2.0 * std::cos(degToRad(85.0)), 1e-9);
  }
}

TEST(LayerDistance, ANewFootLiesOnThePlate) {
  // The second layer has an island of its own beside what lies below it.
  const SlicedLayers sliced{
      {test::layerOf(2.0, {test::circle(10, 2.0)}),
       test::layerOf(2.5, {test::circle(10, 4.0), test::circle(10, 2.5, Vec3(60, 0, 0))})}};
  const Toolpath path = build(sliced, *test::plate());
  for (const Bead& bead : path.layers[1].beads) {
    const double wanted = bead.points[0].p.x() > 30.0 ? 2.5 : 2.0;
    for (const PathPoint& point : bead.points) {
      EXPECT_NEAR(point.distance, wanted, 1e-9);
    }
  }
}

TEST(LayerDistance, OnASlopeTheFirstLayerIsAsFarAsThePerpendicular) {
  // A body that slopes by 30 degrees; the layer is 2 mm above it along the build direction.
  const double slope = degToRad(30.0);
  geometry::TriangleMesh wedge = test::boxMesh({-100, -100, -10}, {100, 100, 0});
  for (Vec3& v : wedge.vertices) {
    v.z() += std::tan(slope) * v.x();
  }
  const Substrate substrate(geometry::Pose::Identity(), test::meshSurface(wedge));
  Contour contour = test::circle(20.0, 0.0);
  for (ContourPoint& point : contour.points) {
    point.p.z() = 2.0 + std::tan(slope) * point.p.x();
  }
  SlicedLayers sliced{{test::layerOf(2.0, {contour})}};
  sliced.curved = true;
  const Toolpath path = build(sliced, substrate);
  for (const PathPoint& point : path.layers[0].beads[0].points) {
    EXPECT_NEAR(point.distance, 2.0 * std::cos(slope), 1e-9);
  }
}

TEST(LayerDistance, HalfPlanesStandOnTheirStartNotOnThePlateBelow) {
  // A ring 40 mm above the plate in half-planes about z: the first lies one step from the start at
  // the step radius, by its radius elsewhere; the others one step from those before.
  geometry::TriangleMesh ring = test::torusMesh(50.0, 15.0, 90, 180);
  for (Vec3& p : ring.vertices) {
    p.z() += 60.0;
  }
  const plugin::SliceInput input{{test::meshSurface(ring)}, test::plate(), nullptr, {0.01, 3.0}};
  const SlicedLayers sliced =
      test::slice("wcam.slicing.radial", input,
                  R"({"shape": "angle", "step": 5.0, "step_radius": 50.0, "sweep": 350.0})");
  JobContext context;
  const Toolpath path = build(sliced, *test::plate(), "{}", 8.0, context);
  for (std::size_t l = 0; l < 3; ++l) {
    for (const PathPoint& point : path.layers[l].beads[0].points) {
      const double radius = std::hypot(point.p.x(), point.p.y());
      EXPECT_NEAR(point.height, 5.0 * radius / 50.0, 0.02) << "layer " << l;
      EXPECT_NEAR(point.distance, 5.0 * radius / 50.0, 0.02) << "layer " << l;
    }
  }
  EXPECT_EQ(context.diagnostics().count("toolpath.unsupported"), 0U);
  EXPECT_EQ(context.diagnostics().count("toolpath.outside_plate"), 0U);
}

TEST(BeadReference, OnALeaningWallTheFirstLayerKeepsItsHeightAndTheOthersTheStep) {
  for (const double lean : {degToRad(30.0), degToRad(-25.0), degToRad(50.0)}) {
    const SlicedLayers sliced = cone(lean, 2.0, 12);
    for (const std::string reference : {"inside", "outside"}) {
      SCOPED_TRACE(reference + " " + std::to_string(radToDeg(lean)));
      const Toolpath path =
          build(sliced, *test::plate(), R"({"bead_reference": ")" + reference + "\"}", 6.0);
      const double sign = reference == "inside" ? 1.0 : -1.0;
      for (std::size_t l = 0; l < path.layers.size(); ++l) {
        const double way = 2.0 * static_cast<double>(l + 1);
        // Half a bead across the wall, measured level.
        const double radius = 50.0 + way * std::sin(lean) + sign * 3.0 / std::cos(lean);
        ASSERT_EQ(path.layers[l].beads.size(), 1U);
        for (const PathPoint& point : path.layers[l].beads[0].points) {
          EXPECT_NEAR(point.p.z(), way * std::cos(lean), 2e-4) << "layer " << l;
          EXPECT_NEAR(std::hypot(point.p.x(), point.p.y()), radius, 2e-4) << "layer " << l;
          if (l > 0) {
            EXPECT_NEAR(point.distance, 2.0, 1e-3);
          }
        }
      }
    }
  }
}

TEST(BeadReference, ASpiralOnALeaningWallIsSlidAsWell) {
  const double lean = degToRad(35.0);
  Contour spiral = test::helix(50.0, 2.0 * std::cos(lean), 6.0, 72);
  for (ContourPoint& point : spiral.points) {
    const Vec3 out(point.n.x(), point.n.y(), 0.0);
    point.p.z() += 2.0 * std::cos(lean);
    point.p += std::tan(lean) * point.p.z() * out;
    point.n = std::cos(lean) * out - std::sin(lean) * Vec3::UnitZ();
  }
  SlicedLayers sliced{{test::layerOf(0.0, {spiral})}};
  sliced.curved = true;
  for (const std::string reference : {"inside", "outside"}) {
    const Toolpath path =
        build(sliced, *test::plate(), R"({"bead_reference": ")" + reference + "\"}", 6.0);
    const Bead& bead = path.layers[0].beads[0];
    ASSERT_EQ(bead.points.size(), spiral.points.size());
    for (std::size_t i = 0; i < bead.points.size(); ++i) {
      EXPECT_NEAR(bead.points[i].p.z(), spiral.points[i].p.z(), 0.01) << reference << i;
    }
  }
}

TEST(BeadReference, WhereTheWallStraightensTheMovedTopIsTold) {
  // A bowl: it leans by 60 degrees at the plate and stands upright at its edge.
  SlicedLayers sliced;
  sliced.curved = true;
  double r = 60.0;
  double z = 0.0;
  for (int k = 0; k < 20; ++k) {
    const double lean = degToRad(60.0) * (1.0 - k / 19.0);
    r += 2.0 * std::sin(lean);
    z += 2.0 * std::cos(lean);
    sliced.layers.push_back(test::layerOf(2.0 * (k + 1), {leaningCircle(r, z, lean)}));
  }
  JobContext context;
  (void)build(sliced, *test::plate(), R"({"bead_reference": "inside"})", 6.0, context);
  ASSERT_EQ(context.diagnostics().count("toolpath.top_moved"), 1U);
  JobContext straight;
  (void)build(cone(degToRad(30.0), 2.0, 12), *test::plate(), R"({"bead_reference": "inside"})", 6.0,
              straight);
  EXPECT_EQ(straight.diagnostics().count("toolpath.top_moved"), 0U);
}

std::optional<Severity> severityOf(const JobContext& context, const std::string& code) {
  for (const Diagnostic& finding : context.diagnostics().items()) {
    if (finding.code == code) {
      return finding.severity;
    }
  }
  return std::nullopt;
}

TEST(BuildToolpath, BeadsAboveNothingAndBesideThePlateAreViolations) {
  const SlicedLayers high{{test::layerOf(52.0, {test::circle(20, 52.0)})}};
  JobContext air;
  (void)build(high, *test::plate(), "{}", 6.0, air);
  EXPECT_EQ(severityOf(air, "toolpath.unsupported"), Severity::Violation);
  // 3 m beside the plate.
  const SlicedLayers far{{test::layerOf(2.0, {test::circle(20, 2.0, Vec3(3000, 0, 0))})}};
  JobContext beside;
  (void)build(far, *test::plate(), "{}", 6.0, beside);
  EXPECT_EQ(severityOf(beside, "toolpath.outside_plate"), Severity::Violation);
  // A bead that still meets the plate with half of itself is only told.
  const SlicedLayers edge{{test::layerOf(2.0, {test::circle(20, 2.0, Vec3(82, 0, 0))})}};
  JobContext near;
  (void)build(edge, *test::plate(), "{}", 6.0, near);
  EXPECT_EQ(severityOf(near, "toolpath.outside_plate"), Severity::Warning);
}

TEST(BuildToolpath, OfASpiralOnlyTheFirstRevolutionLiesOnThePlate) {
  // A cone that grows beyond the plate of 200 mm, but starts on it.
  Contour spiral = test::helix(90.0, 2.0, 10.0, 72);
  for (ContourPoint& point : spiral.points) {
    point.p += Vec3(0, 0, 2.0) + 1.5 * point.p.z() * point.n;
  }
  SlicedLayers sliced{{test::layerOf(0.0, {spiral})}};
  sliced.curved = true;
  JobContext context;
  (void)build(sliced, *test::plate(), "{}", 6.0, context);
  EXPECT_FALSE(severityOf(context, "toolpath.outside_plate"));
}

TEST(Sampling, FollowsFromBeadAndMesh) {
  const PathParams params;
  EXPECT_EQ(params.sampling(8.0, 0.0).chordError, 0.01);
  EXPECT_EQ(params.sampling(8.0, 0.0).maxSpacing, 4.9);
  EXPECT_EQ(params.sampling(8.0, 0.05).chordError, 0.05);
  EXPECT_EQ(params.sampling(8.0, 3.0).chordError, 0.16);  // what a bead of 8 mm hides
  EXPECT_EQ(params.sampling(2.0, 0.0).maxSpacing, 2.0);
  PathParams given;
  given.chordError = 0.002_mm;
  given.maxSpacing = 7.0_mm;
  EXPECT_EQ(given.sampling(8.0, 3.0).chordError, 0.002);
  EXPECT_EQ(given.sampling(2.0, 3.0).maxSpacing, 7.0);
}

}  // namespace
}  // namespace wcam::toolpath
