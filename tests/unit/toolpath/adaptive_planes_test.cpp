// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/toolpath/layer_distance.hpp"

#include "constant_fixture.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

/// Planes at adaptive heights (Chalvin A6) and the substrate's surface moved up.
namespace wcam::toolpath {
namespace {

using namespace constant_test;

plugin::SliceInput withRange(std::shared_ptr<const geometry::PartSurface> part,
                             double least,
                             double most) {
  plugin::SliceInput input = inputOf(std::move(part));
  input.bead.heightMin = least;
  input.bead.heightMax = most;
  return input;
}

TEST(AdaptivePlanes, OnASphereTheyAreTheParallels) {
  JobContext context;
  const SlicedLayers sliced =
      test::slice("wcam.slicing.planar", withRange(formulaPart("p1_hemisphere.wsurf"), 1.0, 7.0),
                  R"({"step": 5.0, "first_layer": 0, "adaptive_step": true})", context);
  for (std::size_t n = 0; n <= 12; ++n) {
    const double u = static_cast<double>(n) * 2.0 * std::asin(5.0 / 90.0);
    EXPECT_NEAR(sliced.layers[n].level, 45.0 * std::sin(u), 0.01) << n;
  }
  EXPECT_LE(worstDistance({{sliced.layers.begin(), sliced.layers.begin() + 13}, false}, 5.0), 0.01);
  // Near the pole planes would have to be nearer than the process allows.
  EXPECT_GE(context.diagnostics().count("slicing.step_not_kept"), 1U);
}

TEST(AdaptivePlanes, StraightWallsKeepTheStep) {
  JobContext context;
  const auto tube = test::meshSurface(test::tubeMesh(10.0, 20.0, 64, 4));
  const SlicedLayers sliced = test::slice("wcam.slicing.planar", withRange(tube, 1.0, 7.0),
                                          R"({"step": 2.0, "adaptive_step": true})", context);
  ASSERT_EQ(sliced.layers.size(), 10U);
  for (std::size_t n = 0; n < 10; ++n) {
    EXPECT_NEAR(sliced.layers[n].level, 2.0 * static_cast<double>(n + 1), 1e-9);
  }
  EXPECT_EQ(context.diagnostics().items().size(), 0U);
}

TEST(AdaptivePlanes, HeightsStayInsideTheRange) {
  JobContext context;
  const SlicedLayers sliced =
      test::slice("wcam.slicing.planar", withRange(formulaPart("p4_quarter_torus.wsurf"), 1.0, 6.0),
                  R"({"step": 5.0, "adaptive_step": true})", context);
  for (std::size_t n = 1; n < sliced.layers.size(); ++n) {
    const double height = sliced.layers[n].level - sliced.layers[n - 1].level;
    EXPECT_GE(height, 1.0 - 1e-9);
    EXPECT_LE(height, 5.0 + 1e-9);
    const std::vector<double> distances =
        layerDistance(pointsOf(sliced.layers[n]), sliced.layers[n - 1].contours);
    if (height > 1.0 + 1e-6) {
      EXPECT_LE(*std::max_element(distances.begin(), distances.end()), 5.01);
    }
  }
}

TEST(AdaptivePlanes, RefusesAStepOutsideTheRange) {
  try {
    static_cast<void>(test::slice("wcam.slicing.planar",
                                  withRange(formulaPart("p1_hemisphere.wsurf"), 1.0, 4.0),
                                  R"({"step": 5.0, "adaptive_step": true})"));
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("1.000 to 4.000"));
  }
}

TEST(SubstrateLayers, AreTheSubstrateMovedUp) {
  plugin::SliceInput input = inputOf(formulaPart("p4_quarter_torus.wsurf"));
  input.substrate = cylinderSubstrate();
  const SlicedLayers sliced = test::slice("wcam.slicing.planar", input,
                                          R"({"step": 4.0, "first_layer": 0,
                                              "surface": "substrate"})");
  plot(sliced, "substrate");
  EXPECT_TRUE(sliced.curved);
  ASSERT_GE(sliced.layers.size(), 3U);
  for (const SlicedLayer& layer : sliced.layers) {
    for (const Vec3& p : pointsOf(layer)) {
      if (std::abs(p.x()) < 31.9) {
        EXPECT_NEAR(p.z() - std::sqrt(1024.0 - p.x() * p.x()), layer.level, 1e-6);
      }
    }
  }
}

}  // namespace
}  // namespace wcam::toolpath
