// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/quantity.hpp"
#include "wcam/toolpath/build.hpp"
#include "wcam/toolpath/part_coverage.hpp"

#include "sample_meshes.hpp"
#include "slicing_fixture.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace wcam::toolpath {
namespace {

using geometry::Vec3;

/// Findings of planar layers of a box.
std::vector<Diagnostic> findingsOf(const Vec3& low, const Vec3& high, double tilt = 0.0) {
  geometry::Pose pose = geometry::Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(tilt, Vec3::UnitX()).toRotationMatrix();
  plugin::SliceInput input;
  input.parts = {test::meshSurface(test::boxMesh(low, high))};
  input.substrate = std::make_shared<Substrate>(pose, Vec3(400.0, 400.0, 10.0));
  input.sampling = {0.01, 3.0};
  input.bead = {1.0, 4.0, 6.0};
  const JobContext context;
  const SlicedLayers sliced =
      test::slice("wcam.slicing.planar", input, R"({"step": 2.0, "last_layer": "fit"})", context);
  reportLeftOut(sliced, input.parts, *input.substrate, input.bead, context);
  (void)buildToolpath(sliced, *input.substrate, PathParams{}, context, input.bead);
  return context.diagnostics().items();
}

const Diagnostic* find(const std::vector<Diagnostic>& items, const std::string& code) {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const Diagnostic& d) { return d.code == code; });
  return found == items.end() ? nullptr : &*found;
}

TEST(LeftOut, APartThatFloatsIsAFindingWithTheWayDown) {
  for (const double gap : {0.25, 1.5, 4.75, 9.0}) {
    SCOPED_TRACE(gap);
    const auto items = findingsOf(Vec3(0, 0, gap), Vec3(40, 30, gap + 12));
    const Diagnostic* floating = find(items, "slicing.floating");
    ASSERT_NE(floating, nullptr);
    EXPECT_NEAR(floating->data[0].second, gap, 1e-9);
    EXPECT_NE(floating->remedy.str().find("lower the part by " + formatFixed(gap, 3) + " mm"),
              std::string::npos);
  }
  for (const double noise : {0.0, 1e-5, 1e-3}) {
    EXPECT_EQ(find(findingsOf(Vec3(0, 0, noise), Vec3(40, 30, 12)), "slicing.floating"), nullptr);
  }
}

TEST(LeftOut, MovesOnATiltedPlateAreVectors) {
  bool found = false;
  for (const double tilt : {0.3, -0.3}) {
    // One side of the box lies up to 30·sin 0.3 mm below the leaning plate.
    const auto items = findingsOf(Vec3(0, 0, 0), Vec3(40, 30, 20), tilt);
    const Diagnostic* below = find(items, "slicing.below_plate");
    if (below != nullptr) {
      found = true;
      EXPECT_NEAR(below->data[0].second, 30.0 * std::sin(0.3), 1e-6);
      EXPECT_NE(below->remedy.str().find("along the plate's normal"), std::string::npos);
    }
  }
  EXPECT_TRUE(found);
}

TEST(LeftOut, TheTopOfAPartOfOneLayerIsLookedAt) {
  const auto items = findingsOf(Vec3(0, 0, 0), Vec3(50, 45, 2.3));
  const Diagnostic* uncovered = find(items, "slicing.uncovered");
  ASSERT_NE(uncovered, nullptr);
  EXPECT_GT(uncovered->data[0].second, 1000.0);
}

TEST(LeftOut, APartBesideItsPlateIsToldTheMove) {
  const auto items = findingsOf(Vec3(190, 0, 0), Vec3(230, 30, 6));
  const Diagnostic* outside = find(items, "toolpath.outside_plate");
  ASSERT_NE(outside, nullptr);
  EXPECT_NE(outside->remedy.str().find("move the part by (-33.00, 0.00, 0.00) mm"),
            std::string::npos)
      << outside->remedy.str();
}

}  // namespace
}  // namespace wcam::toolpath
