// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/part_coverage.hpp"

#include "constant_fixture.hpp"
#include "sample_meshes.hpp"
#include "slicing_fixture.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

/// The last layer, and what no layer covers.
namespace wcam::toolpath {
namespace {

using geometry::Vec3;

plugin::SliceInput inputOf(const std::shared_ptr<const geometry::PartSurface>& part) {
  return {{part}, test::plate(), nullptr, {0.01, 3.0}};
}

double lengthOf(const SlicedLayer& layer) {
  double length = 0.0;
  for (const Contour& contour : layer.contours) {
    const std::size_t n = contour.points.size();
    for (std::size_t i = 0; i + (contour.closed ? 0 : 1) < n; ++i) {
      length += (contour.points[(i + 1) % n].p - contour.points[i].p).norm();
    }
  }
  return length;
}

std::vector<Diagnostic> withCode(const JobContext& context, const std::string& code) {
  std::vector<Diagnostic> found;
  for (const Diagnostic& item : context.diagnostics().items()) {
    if (item.code == code) {
      found.push_back(item);
    }
  }
  return found;
}

double figure(const Diagnostic& finding, const std::string& name) {
  for (const auto& [key, value] : finding.data) {
    if (key == name) {
      return value;
    }
  }
  return std::nan("");
}

/// Half of a tube, open at its sides.
geometry::TriangleMesh halfTube(double radius, double height, int around, int rows) {
  geometry::TriangleMesh mesh = test::tubeMesh(radius, height, 2 * around, rows);
  geometry::TriangleMesh half;
  half.vertices = mesh.vertices;
  for (const auto& t : mesh.triangles) {
    const Vec3 centre = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
    if (centre.y() > 0.0) {
      half.triangles.push_back(t);
    }
  }
  std::vector<std::uint32_t> index(half.vertices.size(), geometry::HalfEdges::kNone);
  std::vector<Vec3> kept;
  for (auto& t : half.triangles) {
    for (std::uint32_t& v : t) {
      if (index[v] == geometry::HalfEdges::kNone) {
        index[v] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(half.vertices[v]);
      }
      v = index[v];
    }
  }
  half.vertices = kept;
  return half;
}

TEST(LastLayer, BorderOfACylinderIsALayerInEveryStrategy) {
  const auto tube = test::meshSurface(test::tubeMesh(30.0, 40.0, 120, 8));
  for (const char* strategy :
       {"wcam.slicing.planar", "wcam.slicing.geodesic", "wcam.slicing.isoparam",
        "wcam.slicing.constant", "wcam.slicing.isovalues", "wcam.slicing.branches"}) {
    for (const auto& [step, count] : {std::pair{2.0, 20U}, std::pair{4.0, 10U}}) {
      SCOPED_TRACE(std::string(strategy) + " at " + std::to_string(step));
      const SlicedLayers sliced =
          test::slice(strategy, inputOf(tube), R"({"step": )" + std::to_string(step) + "}");
      ASSERT_EQ(sliced.layers.size(), count);
      const SlicedLayer& last = sliced.layers.back();
      ASSERT_EQ(last.contours.size(), 1U);
      EXPECT_TRUE(last.contours[0].closed);
      EXPECT_NEAR(lengthOf(last), 2.0 * kPi * 30.0, 0.2);
      for (const ContourPoint& point : last.contours[0].points) {
        EXPECT_NEAR(point.p.z(), 40.0, 0.02);
      }
    }
  }
}

TEST(LastLayer, BorderOfAHalfCylinderIsOneArc) {
  const auto half = test::meshSurface(halfTube(30.0, 40.0, 60, 8));
  for (const char* strategy : {"wcam.slicing.isoparam", "wcam.slicing.planar"}) {
    for (const double step : {2.0, 4.0}) {
      SCOPED_TRACE(std::string(strategy) + " at " + std::to_string(step));
      const SlicedLayers sliced =
          test::slice(strategy, inputOf(half), R"({"step": )" + std::to_string(step) + "}");
      ASSERT_EQ(sliced.layers.size(), static_cast<std::size_t>(40.0 / step));
      for (const SlicedLayer& layer : sliced.layers) {
        ASSERT_EQ(layer.contours.size(), 1U) << layer.level;
        EXPECT_FALSE(layer.contours[0].closed);
        EXPECT_NEAR(lengthOf(layer), kPi * 30.0, 0.1) << layer.level;
      }
    }
  }
}

TEST(LastLayer, FacesOfAHalfCylinderEndInOneArc) {
  const auto part = constant_test::formulaPart("cylinder_r32.wsurf");
  double height = 0.0;
  for (const Vec3& p : part->mesh.vertices) {
    height = std::max(height, p.z());
  }
  for (const double steps : {10.0, 20.0}) {
    const SlicedLayers sliced =
        test::slice("wcam.slicing.isoparam", inputOf(part),
                    R"({"mode": "faces", "step": )" + std::to_string(height / steps) + "}");
    ASSERT_EQ(static_cast<double>(sliced.layers.size()), steps);
    ASSERT_EQ(sliced.layers.back().contours.size(), 1U);
    EXPECT_NEAR(lengthOf(sliced.layers.back()), lengthOf(sliced.layers.front()), 0.01);
  }
}

TEST(LastLayer, StepFitsTheHeightUnlessItIsToBeLeft) {
  const auto tube = test::meshSurface(test::tubeMesh(30.0, 39.9, 120, 8));
  for (const char* strategy :
       {"wcam.slicing.planar", "wcam.slicing.geodesic", "wcam.slicing.isoparam",
        "wcam.slicing.constant", "wcam.slicing.branches"}) {
    SCOPED_TRACE(strategy);
    // The default.
    const ParamDef* last = test::pluginHost().findSlicing(strategy)->info.params.find("last_layer");
    ASSERT_NE(last, nullptr);
    EXPECT_EQ(last->defaultValue, Value("fit"));
    const SlicedLayers fitted =
        test::slice(strategy, inputOf(tube), R"({"step": 4.0, "last_layer": "fit"})");
    ASSERT_EQ(fitted.layers.size(), 10U);
    for (const SlicedLayer& layer : fitted.layers) {
      EXPECT_NEAR(layer.nominalHeight, 3.99, 0.005);
      ASSERT_EQ(layer.contours.size(), 1U);
    }
    EXPECT_NEAR(fitted.layers.back().contours[0].points[0].p.z(), 39.9, 0.02);

    const JobContext context;
    const SlicedLayers left =
        test::slice(strategy, inputOf(tube), R"({"step": 4.0, "last_layer": "leave"})", context);
    EXPECT_EQ(left.layers.size(), 9U);
    EXPECT_NEAR(left.layers.back().contours[0].points[0].p.z(), 36.0, 0.02);
    const auto rests = withCode(context, "slicing.rest");
    ASSERT_EQ(rests.size(), 1U);
    EXPECT_NEAR(figure(rests[0], "rest_mm"), 3.9, 0.02);
    // The remedy works when it is followed.
    const double step = figure(rests[0], "step_mm");
    const JobContext again;
    const SlicedLayers followed =
        test::slice(strategy, inputOf(tube),
                    R"({"last_layer": "leave", "step": )" + std::to_string(step) + "}", again);
    EXPECT_TRUE(withCode(again, "slicing.rest").empty());
    EXPECT_EQ(followed.layers.size(), 10U);
  }
}

TEST(LastLayer, FittedStepStaysInsideTheProcess) {
  plugin::SliceInput input = inputOf(test::meshSurface(test::tubeMesh(30.0, 9.2, 60, 4)));
  input.bead.heightMin = 1.0;
  input.bead.heightMax = 2.0;
  // Five layers of 1.84 mm, not four (2.3) and not six.
  const SlicedLayers sliced =
      test::slice("wcam.slicing.planar", input, R"({"step": 2.0, "last_layer": "fit"})");
  ASSERT_EQ(sliced.layers.size(), 5U);
  EXPECT_NEAR(sliced.layers.back().level, 9.2, 1e-9);
  // 2.3 mm would be nearer to 2.2 than 1.84 is.
  input.bead.heightMax = 2.2;
  EXPECT_EQ(test::slice("wcam.slicing.planar", input, R"({"step": 2.2, "last_layer": "fit"})")
                .layers.size(),
            5U);
}

TEST(LeftOut, TopOfASolidThatIsOnlyOutlined) {
  const auto box = test::meshSurface(test::boxMesh({-40, -30, 0}, {40, 30, 20}));
  const plugin::SliceInput input = inputOf(box);
  const JobContext context;
  const SlicedLayers outlined = test::slice("wcam.slicing.planar", input, R"({"step": 2.0})");
  reportLeftOut(outlined, input.parts, *input.substrate, {1.0, 4.0, 6.0}, context);
  const auto found = withCode(context, "slicing.uncovered");
  ASSERT_EQ(found.size(), 1U);
  // Half a bead (times 1.1) along the border is covered.
  const double inside = (80.0 - 6.6) * (60.0 - 6.6);
  EXPECT_NEAR(figure(found[0], "area_mm2"), inside, 0.05 * inside);
  EXPECT_NEAR(figure(found[0], "z_mm"), 20.0, 1e-6);
  EXPECT_NEAR(figure(found[0], "distance_mm"), 30.0, 2.0);
  EXPECT_NE(found[0].remedy.str().find("wcam.slicing.bulk"), std::string::npos);
  // What the remedy names covers it.
  const JobContext filled;
  plugin::SliceInput bulk = input;
  bulk.bead = {1.0, 4.0, 6.0};
  reportLeftOut(test::slice("wcam.slicing.bulk", bulk, R"({"step": 2.0})"), bulk.parts,
                *bulk.substrate, bulk.bead, filled);
  EXPECT_TRUE(withCode(filled, "slicing.uncovered").empty());
}

TEST(LeftOut, ShallowConeIsCoveredByDistanceAlongIt) {
  // 60 mm wide, 4 mm high: planes 2 mm apart leave rings of 15 mm.
  geometry::TriangleMesh cone = test::tubeMesh(1.0, 1.0, 90, 12);
  for (Vec3& p : cone.vertices) {
    const double angle = std::atan2(p.y(), p.x());
    const double radius = 40.0 - 30.0 * p.z();
    p = Vec3(radius * std::cos(angle), radius * std::sin(angle), 4.0 * p.z());
  }
  const plugin::SliceInput input = inputOf(test::meshSurface(std::move(cone)));
  const BeadRange bead{1.0, 4.0, 6.0};
  const JobContext planes;
  reportLeftOut(test::slice("wcam.slicing.planar", input, R"({"step": 2.0})"), input.parts,
                *input.substrate, bead, planes);
  const auto found = withCode(planes, "slicing.uncovered");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].remedy.str().find("wcam.slicing.geodesic"), std::string::npos);
  const JobContext along;
  reportLeftOut(test::slice("wcam.slicing.geodesic", input, R"({"step": 2.0})"), input.parts,
                *input.substrate, bead, along);
  EXPECT_TRUE(withCode(along, "slicing.uncovered").empty());
  // Walls that stand have nothing uncovered.
  const plugin::SliceInput wall = inputOf(test::meshSurface(test::tubeMesh(30.0, 40.0, 90, 8)));
  const JobContext standing;
  reportLeftOut(test::slice("wcam.slicing.planar", wall, R"({"step": 4.0, "end_height": 20})"),
                wall.parts, *wall.substrate, bead, standing);
  EXPECT_EQ(standing.diagnostics().items().size(), 0U);
}

TEST(LeftOut, WhatLiesBelowThePlateIsTold) {
  geometry::Pose pose = geometry::Pose::Identity();
  const auto placed = [&] {
    return io::importPart(std::string(WCAM_TEST_DATA) + "/trials/tube_centred.stl",
                          io::ImportOptions{}, pose, JobContext())
        .surface;
  };
  for (const char* strategy :
       {"wcam.slicing.planar", "wcam.slicing.geodesic", "wcam.slicing.isovalues",
        "wcam.slicing.constant", "wcam.slicing.isoparam", "wcam.slicing.branches"}) {
    SCOPED_TRACE(strategy);
    pose = geometry::Pose::Identity();
    plugin::SliceInput input = inputOf(placed());
    const JobContext context;
    reportLeftOut(test::slice(strategy, input, R"({"step": 2.0})"), input.parts, *input.substrate,
                  {1.0, 4.0, 6.0}, context);
    const auto found = withCode(context, "slicing.below_plate");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].severity, Severity::Warning);
    EXPECT_NEAR(figure(found[0], "depth_mm"), 40.0, 1e-3);
    EXPECT_NE(found[0].remedy.str().find("40.000 mm"), std::string::npos);
    pose.translation().z() = figure(found[0], "depth_mm");
    input.parts = {placed()};
    const JobContext raised;
    const SlicedLayers whole = test::slice(strategy, input, R"({"step": 2.0})");
    reportLeftOut(whole, input.parts, *input.substrate, {1.0, 4.0, 6.0}, raised);
    EXPECT_TRUE(withCode(raised, "slicing.below_plate").empty());
    EXPECT_EQ(whole.layers.size(), 40U);
  }
}

TEST(LeftOut, BeadsAroundAnAxisInsideThePlateAreAViolation) {
  // A tube about the plate's axis that reaches 5 mm below its top.
  const auto part = [](double z) {
    geometry::TriangleMesh tube = test::tubeMesh(20, 30, 48, 12);
    for (geometry::Vec3& p : tube.vertices) {
      p.z() += z;
    }
    return test::meshSurface(std::move(tube));
  };
  for (const double z : {-5.0, 0.0}) {
    const plugin::SliceInput input{{part(z)}, test::plate(), nullptr, {0.001, 4.9}};
    const JobContext context;
    const SlicedLayers sliced = test::slice("wcam.slicing.radial", input,
                                            R"({"shape": "angle", "step": 5.0, "sweep": 180})");
    reportLeftOut(sliced, input.parts, *input.substrate, {1.0, 4.0, 6.0}, context);
    const auto found = withCode(context, "slicing.bead_in_plate");
    ASSERT_EQ(found.size(), z < 0.0 ? 1U : 0U);
    if (z < 0.0) {
      EXPECT_EQ(found[0].severity, Severity::Violation);
      EXPECT_NE(found[0].message.str().find("5.000 mm"), std::string::npos) << found[0].message;
    }
  }
}

}  // namespace
}  // namespace wcam::toolpath
