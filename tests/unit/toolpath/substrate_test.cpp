// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sample_meshes.hpp"
#include "slicing_fixture.hpp"
#include <gtest/gtest.h>

namespace wcam::toolpath {
namespace {

TEST(Substrate, HeightAboveAPlateInItsOwnFrame) {
  geometry::Pose pose = geometry::Pose::Identity();
  pose.translation() = Vec3(10, 0, 5);
  pose.rotate(Eigen::AngleAxisd(kPi / 2.0, Vec3::UnitY()));  // z of the plate along x of the part
  const Substrate substrate(pose, Vec3(100, 100, 10));
  EXPECT_NEAR(substrate.heightAbove({12, 7, 90}), 2.0, 1e-12);
  EXPECT_NEAR(substrate.heightAbove({8, 7, 90}), -2.0, 1e-12);
  EXPECT_THROW(Substrate(pose, Vec3(100, 0, 10)), Error);
}

TEST(Substrate, HeightAboveABody) {
  const Substrate substrate(geometry::Pose::Identity(),
                            test::meshSurface(test::boxMesh({0, 0, 0}, {10, 10, 4})));
  EXPECT_NEAR(substrate.heightAbove({5, 5, 6}), 2.0, 1e-9);
  EXPECT_NEAR(substrate.heightAbove({5, 5, 1}), -3.0, 1e-9);
  EXPECT_NEAR(substrate.heightAbove({50, 5, 6}), 6.0, 1e-9);  // beside it: above the frame's plane
}

TEST(Substrate, PointsBelowAPlateAreCutAway) {
  // A tube lying along x, half of it below the plate.
  geometry::TriangleMesh mesh = test::tubeMesh(10.0, 40.0, 90, 20);
  for (Vec3& v : mesh.vertices) {
    v = Vec3(v.z(), v.x(), v.y());
  }
  plugin::SliceInput input{{test::meshSurface(mesh)}, test::plate(), nullptr, {0.01, 2.0}};
  JobContext context;
  // Layers across the tube, along x: every circle loses its lower half.
  const SlicedLayers sliced =
      test::slice("wcam.slicing.planar", input,
                  R"({"step": 4.0, "custom_direction": true, "direction": [1, 0, 0]})", context);
  ASSERT_GE(sliced.layers.size(), 9U);
  for (const SlicedLayer& layer : sliced.layers) {
    ASSERT_EQ(layer.contours.size(), 1U);
    EXPECT_FALSE(layer.contours[0].closed);
    EXPECT_NEAR(layer.contours[0].points.front().p.z(), 0.0, 1e-5);
    EXPECT_NEAR(layer.contours[0].points.back().p.z(), 0.0, 1e-5);
    for (const ContourPoint& point : layer.contours[0].points) {
      EXPECT_GE(point.p.z(), -1e-5);
    }
  }
  EXPECT_GT(context.diagnostics().count("slicing.below_substrate"), 0U);
}

TEST(Substrate, LayersStartOnARaisedPlate) {
  plugin::SliceInput input{
      {test::meshSurface(test::tubeMesh(10.0, 40.0, 60, 4))}, test::plate(12.5), nullptr, {}};
  const SlicedLayers sliced = test::slice("wcam.slicing.planar", input, R"({"step": 5.0})");
  ASSERT_EQ(sliced.layers.size(), 5U);
  EXPECT_NEAR(sliced.layers[0].contours[0].points[0].p.z(), 17.5, 1e-12);
}

TEST(Substrate, FirstLayerStartsOnAnImportedBody) {
  // A tube that stands on, and reaches into, a block of height 4.
  const auto block = std::make_shared<Substrate>(
      geometry::Pose::Identity(), test::meshSurface(test::boxMesh({-30, -30, -6}, {30, 30, 4})));
  plugin::SliceInput input{
      {test::meshSurface(test::tubeMesh(10.0, 20.0, 60, 20))}, block, nullptr, {}};
  const SlicedLayers sliced = test::slice("wcam.slicing.planar", input, R"({"step": 2.0})");
  EXPECT_NEAR(sliced.layers[0].contours[0].points[0].p.z(), 6.0, 1e-9);
  const Toolpath path = buildToolpath(sliced, *block, PathParams{}, JobContext());
  EXPECT_NEAR(path.layers[0].beads[0].points[3].distance, 2.0, 1e-9);
}

TEST(Substrate, PartBelowTheSubstrateIsRefused) {
  plugin::SliceInput input{
      {test::meshSurface(test::tubeMesh(10.0, 20.0, 60, 20))}, test::plate(100.0), nullptr, {}};
  try {
    (void)test::slice("wcam.slicing.planar", input, R"({"step": 2.0})");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("below the substrate"), std::string::npos);
  }
}

}  // namespace
}  // namespace wcam::toolpath
