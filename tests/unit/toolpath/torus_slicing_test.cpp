// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/parallel.hpp"
#include "wcam/geometry/guide_curve.hpp"
#include "wcam/toolpath/layer_distance.hpp"

#include "slicing_fixture.hpp"
#include <gtest/gtest.h>

#include <fstream>

/// The quarter torus R 50, r 15 of Chalvin P4 (Eq. 2.11), from its STEP file, and its two slicings.
namespace wcam::toolpath {
namespace {

constexpr double kR = 50.0;
constexpr double kr = 15.0;

double implicitTorus(const Vec3& p) {
  return std::pow(std::hypot(p.x() + kR, p.z()) - kR, 2) + p.y() * p.y() - kr * kr;
}

plugin::SliceInput elbowInput(const Sampling& sampling = {}) {
  return {{test::importSample("elbow/elbow.step")}, test::plate(), nullptr, sampling};
}

std::shared_ptr<const geometry::GuideCurve> guideEdge(const geometry::PartSurface& part) {
  for (int i = 0; i < part.brep->edgeCount(); ++i) {
    if (part.brep->edge(i).name == "guide") {
      return geometry::guideFromEdge(part.brep, i);
    }
  }
  return nullptr;
}

std::vector<Vec3> pointsOf(const SlicedLayer& layer) {
  std::vector<Vec3> points;
  for (const Contour& contour : layer.contours) {
    for (const ContourPoint& point : contour.points) {
      points.push_back(point.p);
    }
  }
  return points;
}

TEST(TorusPlanar, SevenClosedThenFiveOpenLayersOnTheExactTorus) {
  JobContext context;
  const SlicedLayers sliced =
      test::slice("wcam.slicing.planar", elbowInput(), R"({"step": 5.0})", context);
  ASSERT_EQ(sliced.layers.size(), 12U);
  for (std::size_t l = 0; l < 12; ++l) {
    SCOPED_TRACE("n = " + std::to_string(l + 1));
    const SlicedLayer& layer = sliced.layers[l];
    EXPECT_DOUBLE_EQ(layer.level, 5.0 * static_cast<double>(l + 1));
    ASSERT_EQ(layer.contours.size(), 1U);
    EXPECT_EQ(layer.contours[0].closed, l + 1 <= 7);
    for (const ContourPoint& point : layer.contours[0].points) {
      EXPECT_NEAR(implicitTorus(point.p), 0.0, 1e-9);
      EXPECT_NEAR(point.p.z(), 5.0 * static_cast<double>(l + 1), 1e-9);
      // The outward normal of the torus.
      const Vec3 centre = kR * Vec3(point.p.x() + kR, 0, point.p.z()).normalized() - Vec3(kR, 0, 0);
      EXPECT_NEAR((point.n - (point.p - centre) / kr).norm(), 0.0, 1e-9);
    }
  }
  // n = 13 touches the torus in one point only.
  EXPECT_EQ(context.diagnostics().count("slicing.degenerate_contour"), 1U);
}

TEST(TorusPlanar, ArcsEndOnTheBorderCircle) {
  const SlicedLayers sliced = test::slice("wcam.slicing.planar", elbowInput(), R"({"step": 5.0})");
  for (std::size_t l = 7; l < 12; ++l) {
    const Contour& arc = sliced.layers[l].contours[0];
    EXPECT_NEAR(arc.points.front().p.x(), -kR, 1e-9);
    EXPECT_NEAR(arc.points.back().p.x(), -kR, 1e-9);
  }
}

TEST(TorusPlanar, TessellationDoesNotShow) {
  // Layers from a coarse and a fine mesh are the same curves.
  io::ImportOptions coarse;
  coarse.chordTolerance = Length(1.0);
  coarse.angularTolerance = Angle(0.5);
  plugin::SliceInput input = elbowInput({0.001, 1.0});
  const SlicedLayers fine = test::slice("wcam.slicing.planar", input, R"({"step": 5.0})");
  input.parts = {io::importPart(std::string(WCAM_RESOURCES) + "/projects/elbow/elbow.step", coarse,
                                geometry::Pose::Identity(), JobContext())
                     .surface};
  const SlicedLayers rough = test::slice("wcam.slicing.planar", input, R"({"step": 5.0})");
  ASSERT_EQ(fine.layers.size(), rough.layers.size());
  for (std::size_t l = 0; l < fine.layers.size(); ++l) {
    for (const double distance :
         layerDistance(pointsOf(rough.layers[l]), fine.layers[l].contours)) {
      EXPECT_LT(distance, 0.001 * (1.0 + 1e-6));
    }
  }
}

TEST(TorusGuide, AngleStepAndInterLayerDistance) {
  // Chalvin AT-06.
  plugin::SliceInput input = elbowInput();
  input.guide = guideEdge(*input.parts[0]);
  ASSERT_NE(input.guide, nullptr);
  const SlicedLayers sliced =
      test::slice("wcam.slicing.guide", input, R"({"step": 5.0, "first_layer": 0.0})");
  ASSERT_EQ(sliced.layers.size(), 16U);
  double least = 1e9;
  double greatest = 0.0;
  for (std::size_t l = 0; l < sliced.layers.size(); ++l) {
    SCOPED_TRACE("layer " + std::to_string(l));
    ASSERT_EQ(sliced.layers[l].contours.size(), 1U);
    EXPECT_TRUE(sliced.layers[l].contours[0].closed);
    const double u = 0.100042 * static_cast<double>(l);
    for (const Vec3& p : pointsOf(sliced.layers[l])) {
      EXPECT_NEAR(implicitTorus(p), 0.0, 1e-9);
      EXPECT_NEAR(std::atan2(p.z(), p.x() + kR), u, 1e-5);
    }
    if (l > 0) {
      for (const double distance :
           layerDistance(pointsOf(sliced.layers[l]), sliced.layers[l - 1].contours)) {
        least = std::min(least, distance);
        greatest = std::max(greatest, distance);
      }
    }
  }
  EXPECT_NEAR(least, 3.500, 0.005);
  EXPECT_NEAR(greatest, 6.500, 0.005);
}

TEST(TorusGuide, EdgePolylineAndFormulaGiveTheSameLayers) {
  plugin::SliceInput input = elbowInput({0.001, 2.0});
  input.guide = guideEdge(*input.parts[0]);
  const SlicedLayers fromEdge = test::slice("wcam.slicing.guide", input, R"({"step": 5.0})");
  input.guide = geometry::guideFromFormula({"50*cos(t)-50", "0", "50*sin(t)"}, 0.0, kPi / 2.0);
  const SlicedLayers fromFormula = test::slice("wcam.slicing.guide", input, R"({"step": 5.0})");
  const std::string file = ::testing::TempDir() + "guide_points.csv";
  {
    std::ofstream out(file);
    out.precision(17);
    for (int i = 0; i <= 90; ++i) {
      out << 50 * std::cos(degToRad(i)) - 50 << ",0," << 50 * std::sin(degToRad(i)) << "\n";
    }
  }
  input.guide = geometry::guideFromFile(file);
  const SlicedLayers fromPolyline = test::slice("wcam.slicing.guide", input, R"({"step": 5.0})");
  ASSERT_EQ(fromEdge.layers.size(), 15U);
  ASSERT_EQ(fromFormula.layers.size(), 15U);
  ASSERT_EQ(fromPolyline.layers.size(), 15U);
  for (std::size_t l = 0; l < 15; ++l) {
    for (const double distance :
         layerDistance(pointsOf(fromFormula.layers[l]), fromEdge.layers[l].contours)) {
      EXPECT_LT(distance, 0.0011);
    }
    for (const double distance :
         layerDistance(pointsOf(fromPolyline.layers[l]), fromEdge.layers[l].contours)) {
      EXPECT_LT(distance, 0.0015);
    }
  }
}

TEST(TorusGuide, CrossingPlanesAreReported) {
  // A guide that bends more tightly than the part is wide.
  plugin::SliceInput input = elbowInput();
  input.guide = geometry::guideFromFormula({"10*cos(t)-10", "0", "10*sin(t)"}, 0.0, 1.0);
  JobContext context;
  (void)test::slice("wcam.slicing.guide", input, R"({"step": 1.0})", context);
  EXPECT_GT(context.diagnostics().count("slicing.planes_cross"), 0U);
}

TEST(TorusGuide, MissingGuideIsAnErrorWithTheRemedy) {
  try {
    (void)test::slice("wcam.slicing.guide", elbowInput(), R"({"step": 5.0})");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("guide"), std::string::npos);
    EXPECT_FALSE(error.hint().empty());
  }
}

TEST(SpherePlanar, InterLayerDistancesOfChalvinAt04) {
  plugin::SliceInput input{
      {test::importSample("hemisphere/hemisphere.step")}, test::plate(), nullptr, {1e-5, 0.5}};
  JobContext context;
  const SlicedLayers sliced =
      test::slice("wcam.slicing.planar", input, R"({"step": 5.0, "first_layer": 0.0})", context);
  ASSERT_EQ(sliced.layers.size(), 9U);  // z = 0, 5, ..., 40; the pole at 45 is a point
  const std::vector<double> expected{5.008, 5.071, 5.206, 5.429, 5.777,
                                     6.326, 7.255, 9.155, 21.213};
  for (std::size_t l = 1; l < 9; ++l) {
    const std::vector<double> distance =
        layerDistance(pointsOf(sliced.layers[l]), sliced.layers[l - 1].contours);
    EXPECT_NEAR(*std::max_element(distance.begin(), distance.end()), expected[l - 1], 0.001);
    EXPECT_NEAR(*std::min_element(distance.begin(), distance.end()), expected[l - 1], 0.001);
  }
  const auto findings = context.diagnostics().items();
  const auto pole = std::find_if(findings.begin(), findings.end(), [](const Diagnostic& d) {
    return d.code == "slicing.degenerate_contour";
  });
  ASSERT_NE(pole, findings.end());
  Vec3 p;
  for (const auto& [key, value] : pole->data) {
    (key == "x_mm" ? p.x() : key == "y_mm" ? p.y() : p.z()) = key == "level" ? p.z() : value;
  }
  EXPECT_NEAR(layerDistance({p}, sliced.layers[8].contours)[0], expected[8], 0.001);
}

TEST(Slicing, CirclesAreWholeAtAnyTessellation) {
  // Seams, borders and poles at many tessellations: every layer of the sphere is one full circle,
  // run once.
  for (const double angle : {4.0, 7.0, 11.0, 15.0, 20.0, 30.0, 45.0}) {
    SCOPED_TRACE("angular tolerance " + std::to_string(angle));
    io::ImportOptions options;
    options.chordTolerance = Length(0.5);
    options.angularTolerance = Angle(degToRad(angle));
    const auto part =
        io::importPart(std::string(WCAM_RESOURCES) + "/projects/hemisphere/hemisphere.step",
                       options, geometry::Pose::Identity(), JobContext())
            .surface;
    plugin::SliceInput input{{part}, test::plate(), nullptr, {0.001, 5.0}};
    const SlicedLayers sliced =
        test::slice("wcam.slicing.planar", input, R"({"step": 1.5, "first_layer": 0.0})");
    ASSERT_EQ(sliced.layers.size(), 30U);
    for (const SlicedLayer& layer : sliced.layers) {
      ASSERT_EQ(layer.contours.size(), 1U);
      const std::vector<Vec3> points = pointsOf(layer);
      double length = 0.0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        length += (points[(i + 1) % points.size()] - points[i]).norm();
        EXPECT_NEAR(points[i].norm(), 45.0, 1e-9);
      }
      const double radius = std::sqrt(45.0 * 45.0 - layer.level * layer.level);
      EXPECT_NEAR(length, 2.0 * kPi * radius, 0.01 * radius) << "level " << layer.level;
    }
  }
}

TEST(Slicing, OutputDoesNotDependOnThreads) {
  std::vector<SlicedLayers> results;
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    results.push_back(test::slice("wcam.slicing.planar", elbowInput(), R"({"step": 0.5})"));
  }
  for (std::size_t r = 1; r < results.size(); ++r) {
    ASSERT_EQ(results[r].layers.size(), results[0].layers.size());
    for (std::size_t l = 0; l < results[0].layers.size(); ++l) {
      EXPECT_EQ(pointsOf(results[r].layers[l]), pointsOf(results[0].layers[l]));
    }
  }
}

TEST(Slicing, CancelStopsIt) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)test::slice("wcam.slicing.planar", elbowInput(), R"({"step": 5.0})",
                                 JobContext(stop.get_token())),
               CancelledError);
}

}  // namespace
}  // namespace wcam::toolpath
