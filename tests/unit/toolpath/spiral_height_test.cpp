// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a spiral really deposits, and how many points it takes.

#include "wcam/geometry/aabb_tree.hpp"
#include "wcam/geometry/mesh_deviation.hpp"
#include "wcam/toolpath/spiral.hpp"

#include "error_matchers.hpp"
#include "sample_meshes.hpp"
#include "slicing_fixture.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace wcam::toolpath {
namespace {

using geometry::Vec3;

const Diagnostic* find(const JobContext& context, const std::string& code) {
  for (const Diagnostic& finding : context.diagnostics().items()) {
    if (finding.code == code) {
      return &finding;
    }
  }
  return nullptr;
}

/// A cylinder of 200 mm with generatrices that wind about it: between a step along them and the
/// build direction of the nearly level path lies the angle.
constexpr double kRadius = 40.0;

Generatrices winding(double angle, double height) {
  Generatrices result;
  constexpr int kCurves = 360;
  const double length = height / std::cos(angle);
  for (int i = 0; i < kCurves; ++i) {
    std::vector<Vec3> points;
    constexpr int kPoints = 4000;
    for (int k = 0; k <= kPoints; ++k) {
      const double way = length * k / kPoints;
      const double a = -2.0 * kPi * i / kCurves + way * std::sin(angle) / kRadius;
      points.emplace_back(kRadius * std::cos(a), kRadius * std::sin(a), way * std::cos(angle));
    }
    result.curves.emplace_back(std::move(points));
  }
  return result;
}

SlicedLayers windingSpiral(double angle, double second, const JobContext& context) {
  const auto part = test::meshSurface(test::tubeMesh(kRadius, 100.0, 720, 20));
  const Generatrices curves = winding(angle, 100.0);
  SpiralWish wish;
  wish.height = 2.0;
  wish.heightMin = 1.6;
  wish.heightMax = 2.4;
  wish.secondHeight = second;
  wish.secondFrom = 0.5 * curves.curves[0].length();
  std::vector<double> lengths;
  for (const Generatrix& curve : curves.curves) {
    lengths.push_back(curve.length());
  }
  return spiralAlong(*part, curves, planSpiral(lengths, wish), wish, context);
}

TEST(SpiralHeight, IsTheStepOnTheBuildDirectionHoweverMuchItTilts) {
  for (const double degrees : {0.0, 30.0, 60.0, 80.0, 85.0}) {
    const double angle = degToRad(degrees);
    const JobContext context;
    const SlicedLayers sliced = windingSpiral(angle, 0.0, context);
    const Contour& bead = sliced.layers[0].contours[0];
    const std::size_t middle = bead.turns[bead.turns.size() / 2];
    for (std::size_t i = middle; i < middle + 300; ++i) {
      EXPECT_NEAR(bead.points[i].height, 2.0 * std::cos(angle), 0.06) << degrees;
    }
    const Diagnostic* finding = find(context, "slicing.spiral_height");
    EXPECT_EQ(finding != nullptr, degrees > 31.0) << degrees;
    if (finding != nullptr) {
      EXPECT_NEAR(finding->data[1].second, 2.0 * std::cos(angle), 0.1) << degrees;
    }
  }
}

TEST(SpiralHeight, EachZoneIsMeasuredByItsOwnRange) {
  // Upright generatrices keep both ranges; at 60 degrees both zones are left.
  const JobContext upright;
  (void)windingSpiral(0.0, 1.2, upright);
  EXPECT_EQ(find(upright, "slicing.spiral_height"), nullptr);
  const JobContext tilted;
  (void)windingSpiral(degToRad(60.0), 1.2, tilted);
  ASSERT_NE(find(tilted, "slicing.spiral_height"), nullptr);
  EXPECT_LT(find(tilted, "slicing.spiral_height")->data[1].second, 1.0);
}

std::shared_ptr<const geometry::PartSurface> formulaPart(const std::string& name) {
  return io::importPart(std::string(WCAM_TEST_DATA) + "/formula/" + name, io::ImportOptions{},
                        geometry::Pose::Identity(), JobContext())
      .surface;
}

TEST(SpiralHeight, TheFieldRefusesWhatItCannotKeepAndItsRemedyDoes) {
  // The quarter torus spreads from 40 to 160 % of its mean generatrix.
  const plugin::SliceInput input{
      {formulaPart("p4_quarter_torus.wsurf")}, test::plate(), nullptr, {0.02, 4.9}};
  double low = 0.0;
  double high = 0.0;
  try {
    (void)test::slice("wcam.slicing.spiral", input, R"({"step": 2.0, "form": "field"})");
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::JobFailed);
    ASSERT_EQ(
        std::sscanf(error.hint().c_str(), "set the modulation range to %lf to %lf mm", &low, &high),
        2)
        << error.hint();
  }
  EXPECT_LT(low, 1.8);
  EXPECT_GT(high, 2.2);
  (void)test::slice("wcam.slicing.spiral", input,
                    R"({"step": 2.0, "form": "field", "height_min": )" + std::to_string(low) +
                        R"(, "height_max": )" + std::to_string(high) + "}");
  const JobContext told;
  (void)test::slice("wcam.slicing.spiral", input,
                    R"({"step": 2.0, "form": "field", "infeasible": "report"})", told);
  EXPECT_NE(find(told, "slicing.spiral_infeasible"), nullptr);
}

TEST(SpiralPoints, FollowTheMeshAsCloselyAsItFollowsItsShape) {
  // 418 000 points with a chord error that only copies the facets of this mesh.
  const auto part =
      io::importPart(std::string(WCAM_TEST_DATA) + "/compas_slicer/wavy_vase_open_low_res.stl",
                     io::ImportOptions{}, geometry::Pose::Identity(), JobContext())
          .surface;
  const double deviation = geometry::meshDeviation(*part);
  EXPECT_GT(deviation, 0.02);
  EXPECT_LT(deviation, 0.12);
  plugin::SliceInput input{{part}, nullptr, nullptr, PathParams().sampling(8.0, deviation)};
  input.substrate =
      std::make_shared<Substrate>(geometry::Pose::Identity(), Vec3(600.0, 600.0, 10.0));
  const SlicedLayers sliced = test::slice("wcam.slicing.spiral", input,
                                          R"({"step": 2.0, "height_min": 1.5, "height_max": 2.5})");
  const Contour& bead = sliced.layers[0].contours[0];
  EXPECT_LT(bead.points.size(), 60000U);
  EXPECT_GT(bead.points.size(), 15000U);
  const geometry::AabbTree tree(part->mesh);
  std::vector<double> distances;
  for (std::size_t i = 1; i < bead.points.size(); ++i) {
    for (const double s : {0.25, 0.5, 0.75, 1.0}) {
      const Vec3 p = (1.0 - s) * bead.points[i - 1].p + s * bead.points[i].p;
      distances.push_back(tree.closestPoint(p)->distance);
    }
  }
  std::sort(distances.begin(), distances.end());
  RecordProperty("points", static_cast<int>(bead.points.size()));
  RecordProperty("worst_um", static_cast<int>(1000.0 * distances.back()));
  EXPECT_LT(distances[distances.size() * 99 / 100], deviation);
  EXPECT_LT(distances.back(), 2.0 * deviation);
}

}  // namespace
}  // namespace wcam::toolpath
