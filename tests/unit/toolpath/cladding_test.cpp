// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/quantity.hpp"

#include "error_matchers.hpp"
#include "sample_meshes.hpp"
#include "slicing_fixture.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace wcam::test {
namespace {

using geometry::Vec3;
using toolpath::BeadFeature;
using toolpath::Contour;
using toolpath::SlicedLayers;

constexpr const char* kCladding = "wcam.slicing.cladding";
constexpr double kSpacing = 0.667 * 6.0;

plugin::SliceInput inputOf(geometry::TriangleMesh mesh) {
  plugin::SliceInput input;
  input.parts = {meshSurface(std::move(mesh))};
  input.substrate = plate(-100.0);
  input.bead = {1.0, 4.0, 6.0};
  return input;
}

/// A grid of a surface given by two parameters from 0 to 1; normal along dp/du × dp/dv.
geometry::TriangleMesh grid(int n, int m, const std::function<Vec3(double, double)>& at) {
  geometry::TriangleMesh mesh;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= m; ++j) {
      mesh.vertices.push_back(at(static_cast<double>(i) / n, static_cast<double>(j) / m));
    }
  }
  const auto index = [&](int i, int j) { return static_cast<std::uint32_t>(i * (m + 1) + j); };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) {
      mesh.triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  }
  return mesh;
}

geometry::TriangleMesh plane(double length, double width) {
  return grid(20, 12, [=](double u, double v) { return Vec3(length * u, width * v, 0.0); });
}

/// Upper half of a cylinder about x, radius 20.
geometry::TriangleMesh halfCylinder(double length) {
  return grid(20, 180, [=](double u, double v) {
    const double a = kPi * v;
    return Vec3(length * u, -20.0 * std::cos(a), 20.0 * std::sin(a));
  });
}

/// Cap of a sphere of radius 40 about z, half angle 1 rad.
geometry::TriangleMesh dome() {
  return grid(60, 60, [](double u, double v) {
    // A square grid on the disc, so that no triangle is thin at the pole.
    const double x0 = 2.0 * u - 1.0;
    const double y0 = 2.0 * v - 1.0;
    const double x = x0 * std::sqrt(1.0 - 0.5 * y0 * y0);
    const double y = y0 * std::sqrt(1.0 - 0.5 * x0 * x0);
    const double r = std::hypot(x, y);
    const double a = r > 0.0 ? std::atan2(y, x) : 0.0;
    return Vec3(40.0 * std::sin(r) * std::cos(a), 40.0 * std::sin(r) * std::sin(a),
                40.0 * std::cos(r));
  });
}

/// t × n = surface normal at every inner point, beads of the cladding feature.
void checkBeads(const SlicedLayers& sliced, const std::function<Vec3(const Vec3&)>& normalAt) {
  EXPECT_TRUE(sliced.curved);
  for (const auto& layer : sliced.layers) {
    for (const Contour& contour : layer.contours) {
      EXPECT_EQ(contour.feature, BeadFeature::Cladding);
      const auto& points = contour.points;
      ASSERT_GE(points.size(), 2U);
      for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 normal = normalAt(points[i].p);
        ASSERT_NEAR(points[i].n.norm(), 1.0, 1e-9);
        // Facets at the rim of a mesh are off by a few degrees.
        ASSERT_NEAR(points[i].n.dot(normal), 0.0, 0.1);
        const Vec3 t = points[std::min(i + 1, points.size() - 1)].p - points[i > 0 ? i - 1 : 0].p;
        ASSERT_GT(t.normalized().cross(points[i].n).dot(normal), 0.95);
        EXPECT_GT(points[i].height, 0.0);
      }
    }
  }
}

TEST(Cladding, PlaneTakesLinesAtTheOverlapDistance) {
  const auto input = inputOf(plane(100.0, 60.0));
  const JobContext context;
  const SlicedLayers sliced = slice(
      kCladding, input,
      R"({"pattern": "parallel", "direction": [0, 1, 0], "step": 2.0, "layers": 3})", context);
  ASSERT_EQ(sliced.layers.size(), 3U);
  checkBeads(sliced, [](const Vec3&) { return Vec3::UnitZ(); });
  for (std::size_t j = 0; j < 3; ++j) {
    // (60 − 6) / 4.002 = 13.5: 14 distances of 54/14, the outer sides on the border.
    const auto& contours = sliced.layers[j].contours;
    ASSERT_EQ(contours.size(), 15U);
    for (std::size_t k = 0; k < contours.size(); ++k) {
      EXPECT_EQ(contours[k].group, static_cast<int>(k));
      const double y = 3.0 + static_cast<double>(k) * 54.0 / 14.0;
      for (const auto& point : contours[k].points) {
        EXPECT_NEAR(point.p.y(), y, 1e-6);
        EXPECT_NEAR(point.p.z(), 2.0 * static_cast<double>(j + 1), 1e-9);
        EXPECT_GE(point.p.x(), 3.0 - 1e-9);
        EXPECT_LE(point.p.x(), 97.0 + 1e-9);
      }
    }
  }
  EXPECT_EQ(context.diagnostics().items().size(), 0U);
}

TEST(Cladding, ZigzagIsOneBeadOnAPlaneAndOnACylinder) {
  const SlicedLayers flat =
      slice(kCladding, inputOf(plane(100.0, 60.0)), R"({"direction": [0, 1, 0]})");
  EXPECT_EQ(flat.layers[0].contours.size(), 1U);
  const SlicedLayers round =
      slice(kCladding, inputOf(halfCylinder(60.0)), R"({"direction": [1, 0, 0]})");
  EXPECT_EQ(round.layers[0].contours.size(), 1U);
  checkBeads(round, [](const Vec3& p) { return Vec3(0.0, p.y(), p.z()).normalized(); });
  for (const auto& point : round.layers[0].contours[0].points) {
    EXPECT_NEAR(std::hypot(point.p.y(), point.p.z()), 22.0, 0.01);
  }
}

TEST(Cladding, LinesAlongACylinderAreEquallyFarOnTheSurface) {
  const SlicedLayers sliced =
      slice(kCladding, inputOf(halfCylinder(60.0)),
            R"({"pattern": "parallel", "direction": [0, 1, 0], "first_layer": 0})");
  // Planes y = const meet the half cylinder in two lines each, one on the other side of the top
  // belongs to another plane: one line per plane and one arc distance, 4.002 or a little less.
  std::vector<double> angles;
  for (const Contour& contour : sliced.layers[0].contours) {
    const Vec3& p = contour.points.front().p;
    angles.push_back(std::atan2(p.y(), p.z()));
  }
  std::sort(angles.begin(), angles.end());
  ASSERT_GE(angles.size(), 13U);
  const double distance =
      20.0 * (angles.back() - angles.front()) / static_cast<double>(angles.size() - 1);
  EXPECT_LE(distance, 1.1 * kSpacing);
  EXPECT_GE(distance, 0.9 * kSpacing);
  for (std::size_t k = 1; k < angles.size(); ++k) {
    // The surface steeper than the planes' limit at both borders is left out.
    EXPECT_NEAR(20.0 * (angles[k] - angles[k - 1]), distance, 0.06) << k;
  }
}

TEST(Cladding, DomeIsCoveredAtTheDistanceAndNormalToItself) {
  const auto input = inputOf(dome());
  const JobContext context;
  const SlicedLayers sliced =
      slice(kCladding, input, R"({"pattern": "parallel", "first_layer": 0, "border": "centre"})",
            context);
  checkBeads(sliced, [](const Vec3& p) { return Vec3(p.normalized()); });
  EXPECT_EQ(context.diagnostics().count("slicing.uncovered"), 0U);
  std::vector<double> angles;
  for (const Contour& contour : sliced.layers[0].contours) {
    for (const auto& point : contour.points) {
      ASSERT_NEAR(point.p.norm(), 40.0, 0.02);
    }
    angles.push_back(std::asin(contour.points.front().p.x() / 40.0));
  }
  ASSERT_GE(angles.size(), 15U);
  for (std::size_t k = 1; k < angles.size(); ++k) {
    // Nowhere farther apart than the bead distance; tessellation makes it a little less.
    EXPECT_LE(40.0 * (angles[k] - angles[k - 1]), kSpacing + 0.01) << k;
    EXPECT_GE(40.0 * (angles[k] - angles[k - 1]), 0.9 * kSpacing) << k;
  }
}

TEST(Cladding, ConcentricBeadsFollowTheBorder) {
  const SlicedLayers flat = slice(kCladding, inputOf(plane(100.0, 60.0)),
                                  R"({"pattern": "concentric", "first_layer": 0})");
  ASSERT_GE(flat.layers[0].contours.size(), 6U);
  for (const Contour& contour : flat.layers[0].contours) {
    EXPECT_TRUE(contour.closed);
    double nearest = 1e9;
    for (const auto& point : contour.points) {
      nearest =
          std::min({nearest, point.p.x(), point.p.y(), 100.0 - point.p.x(), 60.0 - point.p.y()});
    }
    // The middle line lies 27 mm from the outermost bead: 7 distances and a half.
    constexpr double kFitted = 27.0 / 7.5;
    const double k = std::round((nearest - 3.0) / kFitted);
    EXPECT_NEAR(nearest, 3.0 + k * kFitted, 0.05);
  }
  const SlicedLayers round =
      slice(kCladding, inputOf(dome()), R"({"pattern": "concentric", "first_layer": 0})");
  checkBeads(round, [](const Vec3& p) { return Vec3(p.normalized()); });
  for (const Contour& contour : round.layers[0].contours) {
    double low = 10.0;
    double high = 0.0;
    for (const auto& point : contour.points) {
      const double arc = 40.0 * std::acos(std::clamp(point.p.z() / 40.0, -1.0, 1.0));
      low = low == 10.0 ? arc : std::min(low, arc);
      high = std::max(high, arc);
    }
    // The innermost ring turns around the pole in half a bead distance.
    EXPECT_LT(high - low, low < kSpacing ? 0.2 : 0.15);
    constexpr double kFitted = 37.0 / 9.5;
    const double k = std::round((40.0 - 3.0 - low) / kFitted);
    EXPECT_NEAR(40.0 - low, 3.0 + k * kFitted, 0.15);
  }
}

/// Material of a layer, mm³.
double volumeOf(const toolpath::SlicedLayer& layer) {
  double volume = 0.0;
  for (const Contour& contour : layer.contours) {
    const auto& points = contour.points;
    for (std::size_t i = contour.closed ? 0 : 1; i < points.size(); ++i) {
      const auto& before = points[i > 0 ? i - 1 : points.size() - 1];
      EXPECT_GT(points[i].fillWidth, 0.0);
      volume += points[i].fillWidth * points[i].height * (points[i].p - before.p).norm();
    }
  }
  return volume;
}

/// A disc in the plane z = 0.
geometry::TriangleMesh disc(double radius) {
  geometry::TriangleMesh mesh;
  constexpr std::uint32_t kSides = 72;
  mesh.vertices.emplace_back(0.0, 0.0, 0.0);
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const double a = 2.0 * kPi * i / kSides;
    mesh.vertices.emplace_back(radius * std::cos(a), radius * std::sin(a), 0.0);
    mesh.triangles.push_back({0, i + 1, (i + 1) % kSides + 1});
  }
  return mesh;
}

TEST(Cladding, LayersHoldTheirAreaTimesTheirHeight) {
  struct Case {
    const char* name;
    geometry::TriangleMesh mesh;
    const char* direction;
    std::function<double(double)> area;  ///< at a height above the surface
    double allowed;
  };

  const double sector = 2.0 * kPi * 40.0 * (1.0 - std::cos(1.0));
  const std::vector<Case> cases = {
      {"two triangles", grid(1, 1, [](double u, double v) { return Vec3(71 * u, 43 * v, 0); }),
       "[0, 1, 0]", [](double) { return 71.0 * 43.0; }, 0.02},
      {"long", plane(150.0, 31.0), "[1, 0, 0]", [](double) { return 150.0 * 31.0; }, 0.02},
      {"narrower than two beads", plane(80.0, 9.0), "[0, 1, 0]", [](double) { return 720.0; },
       0.02},
      {"wall", halfCylinder(60.0), "[1, 0, 0]", [](double h) { return kPi * (20.0 + h) * 60.0; },
       0.02},
      {"disc", disc(35.0), "[0, 1, 0]",
       [](double) { return 36.0 * 35.0 * 35.0 * std::sin(kPi / 36); }, 0.03},
      {"dome", dome(), "[1, 0, 0]",
       [&](double h) { return sector * (40.0 + h) * (40.0 + h) / 40.0; }, 0.03}};
  for (const Case& c : cases) {
    for (const char* pattern : {"parallel", "zigzag", "concentric"}) {
      SCOPED_TRACE(std::string(c.name) + ", " + pattern);
      const JobContext context;
      const SlicedLayers sliced =
          slice(kCladding, inputOf(c.mesh),
                R"({"layers": 2, "step": 1.5, "pattern": ")" + std::string(pattern) +
                    R"(", "direction": )" + c.direction + "}",
                context);
      ASSERT_EQ(sliced.layers.size(), 2U);
      for (std::size_t l = 0; l < 2; ++l) {
        const double wanted = 1.5 * c.area(1.5 * (static_cast<double>(l) + 0.5));
        EXPECT_NEAR(volumeOf(sliced.layers[l]) / wanted, 1.0, c.allowed);
      }
      EXPECT_EQ(context.diagnostics().count("slicing.uncovered"), 0U);
    }
  }
}

TEST(Cladding, SidesOfTheOuterBeadsLieOnTheBorder) {
  for (const auto& [length, width] : {std::pair{71.0, 43.0}, {50.0, 38.5}, {33.0, 90.0}}) {
    for (const char* pattern : {"parallel", "zigzag", "concentric"}) {
      SCOPED_TRACE(std::to_string(length) + ", " + pattern);
      const SlicedLayers sliced =
          slice(kCladding, inputOf(plane(length, width)),
                R"({"direction": [0, 1, 0], "pattern": ")" + std::string(pattern) + R"("})");
      Vec3 low(1e9, 1e9, 0.0);
      Vec3 high(-1e9, -1e9, 0.0);
      for (const Contour& contour : sliced.layers[0].contours) {
        for (const auto& point : contour.points) {
          low = low.cwiseMin(point.p);
          high = high.cwiseMax(point.p);
        }
      }
      EXPECT_NEAR(low.x(), 3.0, 0.02);
      EXPECT_NEAR(low.y(), 3.0, 0.02);
      EXPECT_NEAR(high.x(), length - 3.0, 0.02);
      EXPECT_NEAR(high.y(), width - 3.0, 0.02);
    }
  }
}

TEST(Cladding, AHoleInTheSurfaceKeepsItsDistance) {
  // A plate of 80 by 60 with a square hole of 20 in its middle.
  geometry::TriangleMesh mesh =
      grid(8, 6, [](double u, double v) { return Vec3(80 * u, 60 * v, 0); });
  std::erase_if(mesh.triangles, [&](const auto& t) {
    const Vec3 c = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
    return std::abs(c.x() - 40.0) < 10.0 && std::abs(c.y() - 30.0) < 10.0;
  });
  for (const char* pattern : {"parallel", "zigzag", "concentric"}) {
    SCOPED_TRACE(pattern);
    const SlicedLayers sliced = slice(
        kCladding, inputOf(mesh),
        R"({"direction": [0, 1, 0], "step": 2, "pattern": ")" + std::string(pattern) + R"("})");
    EXPECT_NEAR(volumeOf(sliced.layers[0]) / (2.0 * 4400.0), 1.0, 0.03);
  }
}

TEST(Cladding, FindingsAndRefusals) {
  const auto closed = inputOf(boxMesh(Vec3(-20, -20, 0), Vec3(20, 20, 40)));
  EXPECT_NE(
      testing::errorOf(
          ErrorCode::JobFailed,
          [&] { static_cast<void>(slice(kCladding, closed, R"({"pattern": "concentric"})")); })
          .find("no border"),
      std::string::npos);
  // Two faces of the box run along the planes.
  const JobContext context;
  EXPECT_FALSE(slice(kCladding, closed, "{}", context).layers.empty());
  const auto items = context.diagnostics().items();
  ASSERT_EQ(context.diagnostics().count("slicing.uncovered"), 1U);
  EXPECT_NEAR(items[0].data[0].second, 2.0 * 1600.0, 1e-6);
  const auto flat = inputOf(plane(100.0, 60.0));
  for (const char* direction : {"[0, 0, 1]", "[0, 0, 0]"}) {
    testing::errorOf(ErrorCode::JobFailed, [&] {
      static_cast<void>(slice(kCladding, flat, R"({"direction": )" + std::string(direction) + "}"));
    });
  }
  // A face smaller than a bead.
  testing::errorOf(ErrorCode::JobFailed,
                   [&] { static_cast<void>(slice(kCladding, inputOf(plane(3.0, 2.0)), "{}")); });
  // The hollow side of a cylinder of 20 mm folds above 20 mm.
  geometry::TriangleMesh hollow = halfCylinder(60.0);
  for (auto& triangle : hollow.triangles) {
    std::swap(triangle[1], triangle[2]);
  }
  const JobContext folded;
  EXPECT_FALSE(slice(kCladding, inputOf(hollow),
                     R"({"pattern": "parallel", "step": 5.0, "layers": 5})", folded)
                   .layers.empty());
  EXPECT_GE(folded.diagnostics().count("slicing.fold"), 1U);
}

TEST(Cladding, BecomesAToolpathWithTheNormalAsAxis) {
  const auto input = inputOf(dome());
  const SlicedLayers sliced = slice(kCladding, input, R"({"layers": 2, "step": 2.0})");
  toolpath::PathParams params;
  params.axis = toolpath::AxisMode::Local;
  const auto path = toolpath::buildToolpath(sliced, *input.substrate, params, JobContext());
  ASSERT_EQ(path.layers.size(), 2U);
  for (const auto& layer : path.layers) {
    for (const auto& bead : layer.beads) {
      for (std::size_t i = 1; i + 1 < bead.points.size(); ++i) {
        ASSERT_GT(bead.points[i].axis.dot(bead.points[i].p.normalized()), 0.95);
      }
    }
  }
}

}  // namespace
}  // namespace wcam::test
