// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/base_curve.hpp"

#include "wcam/toolpath/layer_distance.hpp"

#include "error_matchers.hpp"
#include "sample_meshes.hpp"
#include "slicing_fixture.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace wcam::toolpath {
namespace {

using geometry::TriangleMesh;

TriangleMesh moved(TriangleMesh mesh, const Vec3& by) {
  for (Vec3& p : mesh.vertices) {
    p += by;
  }
  return mesh;
}

TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
  const auto shift = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& t : b.triangles) {
    a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  }
  return a;
}

/// Half a torus standing on both of its ends: an arch.
TriangleMesh archMesh() {
  TriangleMesh mesh;
  constexpr int kAlong = 40;
  constexpr int kAround = 24;
  for (int i = 0; i <= kAlong; ++i) {
    for (int j = 0; j < kAround; ++j) {
      const double u = kPi * i / kAlong;
      const double v = 2.0 * kPi * j / kAround;
      const double rho = 40 + 10 * std::cos(v);
      mesh.vertices.emplace_back(rho * std::cos(u), 10 * std::sin(v),
                                 i == kAlong ? 0.0 : rho * std::sin(u));
    }
  }
  const auto id = [](int i, int j) {
    return static_cast<std::uint32_t>(i * kAround + j % kAround);
  };
  for (int i = 0; i < kAlong; ++i) {
    for (int j = 0; j < kAround; ++j) {
      mesh.triangles.push_back({id(i, j), id(i, j + 1), id(i + 1, j + 1)});
      mesh.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i + 1, j)});
    }
  }
  return mesh;
}

std::string errorOf(const geometry::PartSurface& surface,
                    const Substrate& substrate,
                    ErrorCode code = ErrorCode::JobFailed) {
  try {
    (void)findBase(surface, substrate);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code);
    EXPECT_FALSE(error.hint().empty());
    return error.what();
  }
  return {};
}

TEST(BaseCurve, OpenTubeStandsOnItsLowerBorder) {
  const auto tube = test::meshSurface(test::tubeMesh(20, 60, 48, 30));
  JobContext context;
  const PartBase base = findBase(*tube, *test::plate(), context);
  ASSERT_EQ(base.lower.size(), 1U);
  ASSERT_EQ(base.upper.size(), 1U);
  EXPECT_EQ(base.kind, std::vector<BaseKind>{BaseKind::Border});
  EXPECT_EQ(base.lower[0].vertices.size(), 48U);
  EXPECT_EQ(base.lower[0].highest, 0.0);
  EXPECT_NEAR(base.upper[0].mean, 60.0, 1e-9);
  EXPECT_NEAR(base.lower[0].length, 2 * kPi * 20, 0.2);
  EXPECT_EQ(base.source.borderEdges.size(), 48U);
  EXPECT_TRUE(context.diagnostics().items().empty());
  const std::vector<double> distance = distanceFromBase(*tube, base);
  for (std::size_t v = 0; v < distance.size(); ++v) {
    EXPECT_NEAR(distance[v], tube->mesh.vertices[v].z(), 1e-3);
  }
}

TEST(BaseCurve, PartThroughTheSubstrateBeginsThere) {
  const auto tube = test::meshSurface(test::tubeMesh(20, 60, 48, 30));
  const PartBase base = findBase(*tube, *test::plate(13.3));
  EXPECT_EQ(base.kind, std::vector<BaseKind>{BaseKind::Intersection});
  ASSERT_EQ(base.lower.size(), 1U);
  EXPECT_TRUE(base.lower[0].closed);
  EXPECT_NEAR(base.lower[0].length, 2 * kPi * 20, 0.2);
  EXPECT_EQ(base.upper.size(), 1U);
  const std::vector<double> distance = distanceFromBase(*tube, base);
  for (std::size_t v = 0; v < distance.size(); ++v) {
    EXPECT_NEAR(distance[v], tube->mesh.vertices[v].z() - 13.3, 0.02);
  }
}

/// A sheet in the plane y = 0 below a profile z(x), 80 mm wide, in columns of 2 mm.
TriangleMesh sheetBelow(const std::function<double(double)>& height, double bottom = 0.0) {
  TriangleMesh mesh;
  constexpr int kColumns = 40;
  constexpr int kRows = 20;
  for (int i = 0; i <= kColumns; ++i) {
    const double x = 2.0 * i - kColumns;
    for (int j = 0; j <= kRows; ++j) {
      mesh.vertices.emplace_back(x, 0.0, bottom + (height(x) - bottom) * j / kRows);
    }
  }
  const auto id = [](int i, int j) { return static_cast<std::uint32_t>(i * (kRows + 1) + j); };
  for (int i = 0; i < kColumns; ++i) {
    for (int j = 0; j < kRows; ++j) {
      mesh.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      mesh.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  return mesh;
}

TEST(BaseCurve, OpenSheetStandsOnTheStretchOfItsBorder) {
  const auto sheet = test::meshSurface(sheetBelow([](double x) { return 30.0 + 0.1 * x; }));
  JobContext context;
  const PartBase base = findBase(*sheet, *test::plate(), context);
  ASSERT_EQ(base.lower.size(), 1U);
  EXPECT_FALSE(base.lower[0].closed);
  EXPECT_NEAR(base.lower[0].length, 80.0, 1e-9);
  EXPECT_EQ(base.lower[0].vertices.size(), base.lower[0].halfEdges.size() + 1);
  EXPECT_EQ(base.lower[0].highest, 0.0);
  ASSERT_EQ(base.upper.size(), 1U);
  EXPECT_FALSE(base.upper[0].closed);
  EXPECT_NEAR(base.upper[0].length, std::hypot(80.0, 8.0), 1e-9);
  EXPECT_NEAR(base.upper[0].mean, 30.0, 1e-9);
  EXPECT_TRUE(context.diagnostics().items().empty());
  const std::vector<double> distance = distanceFromBase(*sheet, base);
  for (std::size_t v = 0; v < distance.size(); ++v) {
    EXPECT_NEAR(distance[v], sheet->mesh.vertices[v].z(),
                0.3);  // of the propagation on skewed triangles
  }
}

TEST(BaseCurve, OpenSheetThroughTheSubstrate) {
  const auto sheet = test::meshSurface(sheetBelow([](double) { return 30.0; }, -10.0));
  const PartBase base = findBase(*sheet, *test::plate());
  EXPECT_EQ(base.kind, std::vector<BaseKind>{BaseKind::Intersection});
  ASSERT_EQ(base.lower.size(), 1U);
  EXPECT_NEAR(base.lower[0].length, 80.0, 1e-9);
  ASSERT_EQ(base.upper.size(), 1U);
  EXPECT_NEAR(base.upper[0].length, 80.0, 1e-9);
  EXPECT_NEAR(base.upper[0].lowest, 30.0, 1e-9);
}

TEST(BaseCurve, SheetsWithoutATop) {
  // A pointed one and a round one: the border beyond the base is only sides.
  for (const auto& profile : std::vector<std::function<double(double)>>{
           [](double x) { return 40.0 - 0.9 * std::abs(x) + 1.0; },
           [](double x) { return std::sqrt(std::max(0.0, 1600.0 - x * x)) + 5.0; }}) {
    const auto sheet = test::meshSurface(sheetBelow(profile));
    const PartBase base = findBase(*sheet, *test::plate());
    ASSERT_EQ(base.lower.size(), 1U);
    EXPECT_NEAR(base.lower[0].length, 80.0, 1e-9);
    const std::vector<double> distance = distanceFromBase(*sheet, base);
    for (std::size_t v = 0; v < distance.size(); ++v) {
      EXPECT_NEAR(distance[v], sheet->mesh.vertices[v].z(),
                  0.3);  // of the propagation on skewed triangles
    }
  }
}

TEST(BaseCurve, SheetOnTwoFeet) {
  // A bridge: cut out below, 20 mm of feet on both sides.
  TriangleMesh bridge = sheetBelow([](double) { return 40.0; });
  for (Vec3& p : bridge.vertices) {
    if (std::abs(p.x()) < 19.0) {
      p.z() = 20.0 + 0.5 * p.z();
    }
  }
  const auto sheet = test::meshSurface(std::move(bridge));
  JobContext context;
  const PartBase base = findBase(*sheet, *test::plate(), context);
  ASSERT_EQ(base.lower.size(), 2U);
  EXPECT_NEAR(base.lower[0].length + base.lower[1].length, 40.0, 1e-9);
  ASSERT_EQ(context.diagnostics().items().size(), 1U);
  EXPECT_EQ(context.diagnostics().items()[0].code, "slicing.several_lower_borders");
}

TEST(BaseCurve, SlantedRimThatTouchesThePlateStaysOneBorder) {
  TriangleMesh tube = test::tubeMesh(20, 60, 360, 30);
  for (Vec3& p : tube.vertices) {
    p.z() += 0.05 * (20.0 + p.x()) * (60.0 - p.z()) / 60.0;
  }
  const auto surface = test::meshSurface(std::move(tube));
  JobContext context;
  const PartBase base = findBase(*surface, *test::plate(), context);
  ASSERT_EQ(base.lower.size(), 1U);
  EXPECT_TRUE(base.lower[0].closed);
  ASSERT_EQ(context.diagnostics().items().size(), 1U);
  EXPECT_EQ(context.diagnostics().items()[0].code, "slicing.base_off_substrate");
}

TEST(BaseCurve, ClosedBodyStandsOnItsFlatBottom) {
  const auto box = test::meshSurface(test::boxMesh({0, 0, 0}, {30, 20, 10}));
  const PartBase base = findBase(*box, *test::plate());
  EXPECT_EQ(base.kind, std::vector<BaseKind>{BaseKind::Contact});
  EXPECT_EQ(base.source.borderEdges.size(), 4U);
  EXPECT_TRUE(base.lower.empty());
  // A torus on its side touches the plate with a circle of vertices, without a triangle.
  const auto torus = test::meshSurface(moved(test::torusMesh(50, 15, 24, 60), {0, 0, 15}));
  const PartBase circle = findBase(*torus, *test::plate());
  EXPECT_EQ(circle.kind, std::vector<BaseKind>{BaseKind::Contact});
  EXPECT_EQ(circle.source.vertices.size(), 60U);
}

TEST(BaseCurve, ClosedBodyInTheAirIsRefused) {
  const auto box = test::meshSurface(test::boxMesh({0, 0, 7.25}, {30, 20, 10}));
  const std::string message = errorOf(*box, *test::plate());
  EXPECT_NE(message.find("7.250 mm"), std::string::npos) << message;
  EXPECT_NE(message.find("0.00, 0.00, 7.25"), std::string::npos) << message;
}

TEST(BaseCurve, PartBelowTheSubstrateIsRefused) {
  const auto tube = test::meshSurface(test::tubeMesh(20, 60, 48, 30));
  EXPECT_NE(errorOf(*tube, *test::plate(100), ErrorCode::CheckFailed).find("below the substrate"),
            std::string::npos);
  EXPECT_NE(errorOf(*test::meshSurface({}), *test::plate()).find("no triangles"),
            std::string::npos);
}

TEST(BaseCurve, BorderInTheAirIsReported) {
  const auto tube = test::meshSurface(moved(test::tubeMesh(20, 60, 48, 30), {0, 0, 3.5}));
  JobContext context;
  const PartBase base = findBase(*tube, *test::plate(), context);
  EXPECT_EQ(base.lower.size(), 1U);
  ASSERT_EQ(context.diagnostics().count("slicing.base_off_substrate"), 1U);
  const Diagnostic finding = context.diagnostics().items()[0];
  EXPECT_NE(finding.message.str().find("3.500 to 3.500 mm"), std::string::npos) << finding.message;
  EXPECT_FALSE(finding.remedy.empty());
}

TEST(BaseCurve, TwoLowerBordersAreReported) {
  const auto arch = test::meshSurface(archMesh());
  JobContext context;
  const PartBase base = findBase(*arch, *test::plate(), context);
  EXPECT_EQ(base.lower.size(), 2U);
  EXPECT_TRUE(base.upper.empty());
  EXPECT_EQ(context.diagnostics().count("slicing.several_lower_borders"), 1U);
}

TEST(BaseCurve, EachPieceHasItsOwnBase) {
  const TriangleMesh tube = test::tubeMesh(20, 60, 48, 30);
  const TriangleMesh below = moved(test::boxMesh({0, 0, 0}, {5, 5, 5}), {60, 0, -20});
  const TriangleMesh box = moved(test::boxMesh({0, 0, 0}, {5, 5, 5}), {90, 0, 0});
  const TriangleMesh above = moved(test::boxMesh({0, 0, 0}, {5, 5, 5}), {120, 0, 4});
  const auto part = test::meshSurface(together(together(together(tube, below), box), above));
  JobContext context;
  const PartBase base = findBase(*part, *test::plate(), context);
  EXPECT_EQ(base.kind, (std::vector<BaseKind>{BaseKind::Border, BaseKind::None, BaseKind::Contact,
                                              BaseKind::None}));
  EXPECT_EQ(context.diagnostics().count("slicing.piece_without_base"), 1U);
  EXPECT_EQ(context.diagnostics().count("slicing.piece_below_substrate"), 1U);
  const std::vector<double> distance = distanceFromBase(*part, base);
  const std::size_t first = tube.vertices.size();
  for (std::size_t v = 0; v < distance.size(); ++v) {
    EXPECT_EQ(std::isnan(distance[v]), v >= first && (v < first + 8 || v >= first + 16)) << v;
  }
}

plugin::SliceInput inputOf(std::shared_ptr<const geometry::PartSurface> part, double z = 0.0) {
  return {{std::move(part)}, test::plate(z), nullptr, {}};
}

TEST(GeodesicSlicing, TorusLayersKeepTheirDistance) {
  const auto layers = test::slice(
      "wcam.slicing.geodesic", inputOf(test::importSample("elbow/elbow.step")), R"({"step": 5.0})");
  // The shortest way to the end is 54.98 mm (inner side), the farthest 83.546 mm (v = 0, A11).
  ASSERT_EQ(layers.layers.size(), 16U);
  EXPECT_TRUE(layers.curved);
  for (std::size_t l = 0; l < layers.layers.size(); ++l) {
    const SlicedLayer& layer = layers.layers[l];
    EXPECT_NEAR(layer.level, 5.0 * static_cast<double>(l + 1), 1e-12);
    if (l < 10) {
      ASSERT_EQ(layer.contours.size(), 1U) << l;
      EXPECT_TRUE(layer.contours[0].closed) << l;
    }
    for (const Contour& contour : layer.contours) {
      std::vector<Vec3> points;
      for (const ContourPoint& point : contour.points) {
        points.push_back(point.p);
        // On the exact torus (file frame of the elbow).
        EXPECT_NEAR(std::hypot(std::hypot(point.p.x() + 50.0, point.p.z()) - 50.0, point.p.y()),
                    15.0, 1e-6);
      }
      if (l == 0) {
        continue;
      }
      // Chords between the layers are a little shorter than the ways on the surface, most where the
      // tube bends tightest; points in the crease see the layer below from two sides.
      const std::vector<double> delta = layerDistance(points, layers.layers[l - 1].contours);
      for (std::size_t i = 0; i < delta.size(); ++i) {
        EXPECT_LT(delta[i], 5.02) << l;
        if (l < 9) {
          EXPECT_GT(delta[i], 4.93) << l;
        }
      }
    }
  }
}

TEST(GeodesicSlicing, CutTubeBeginsAtTheSubstrate) {
  const auto tube = test::meshSurface(test::tubeMesh(20, 60, 96, 30));
  const auto layers = test::slice("wcam.slicing.geodesic", inputOf(tube, 13.3), R"({"step": 2.0})");
  ASSERT_EQ(layers.layers.size(), 23U);
  for (const SlicedLayer& layer : layers.layers) {
    ASSERT_EQ(layer.contours.size(), 1U);
    EXPECT_TRUE(layer.contours[0].closed);
    for (const ContourPoint& point : layer.contours[0].points) {
      EXPECT_NEAR(point.p.z(), 13.3 + layer.level, 0.01);
    }
  }
}

TEST(GeodesicSlicing, HeatAgreesWithPropagation) {
  const auto tube = test::meshSurface(test::tubeMesh(20, 60, 96, 30));
  const auto layers =
      test::slice("wcam.slicing.geodesic", inputOf(tube), R"({"step": 4.0, "method": "heat"})");
  ASSERT_GE(layers.layers.size(), 14U);
  for (const SlicedLayer& layer : layers.layers) {
    for (const ContourPoint& point : layer.contours.at(0).points) {
      EXPECT_NEAR(point.p.z(), layer.level, 0.6);
    }
  }
}

TEST(GeodesicSlicing, RefusesAPartSmallerThanALayer) {
  const auto tube = test::meshSurface(test::tubeMesh(20, 6, 48, 3));
  try {
    (void)test::slice("wcam.slicing.geodesic", inputOf(tube), R"({"step": 10.0})");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::JobFailed);
    EXPECT_NE(error.message().find("6.000 mm"), std::string::npos) << error.message();
    EXPECT_FALSE(error.hint().empty());
  }
}

TEST(GeodesicSlicing, LayersFollowTheMotionOfThePart) {
  TriangleMesh mesh = test::tubeMesh(20, 60, 48, 30);
  const auto straight =
      test::slice("wcam.slicing.geodesic", inputOf(test::meshSurface(mesh)), R"({"step": 3.0})");
  const Eigen::AngleAxisd turn(0.7, Vec3::UnitZ());
  for (Vec3& p : mesh.vertices) {
    p = turn * p + Vec3(30, -12, 0);
  }
  const auto turned =
      test::slice("wcam.slicing.geodesic", inputOf(test::meshSurface(mesh)), R"({"step": 3.0})");
  ASSERT_EQ(straight.layers.size(), turned.layers.size());
  for (std::size_t l = 0; l < straight.layers.size(); ++l) {
    double a = 0.0;
    double b = 0.0;
    for (const auto& point : straight.layers[l].contours.at(0).points) {
      a = std::max(a, std::abs(point.p.z() - straight.layers[l].level));
    }
    for (const auto& point : turned.layers[l].contours.at(0).points) {
      b = std::max(b, std::abs(point.p.z() - turned.layers[l].level));
    }
    EXPECT_LT(std::max(a, b), 0.01);
  }
}

}  // namespace
}  // namespace wcam::toolpath
