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
    // (60 − 6) / 4.002: 13 distances, 14 lines, shared margins.
    const auto& contours = sliced.layers[j].contours;
    ASSERT_EQ(contours.size(), 14U);
    for (std::size_t k = 0; k < contours.size(); ++k) {
      EXPECT_EQ(contours[k].group, static_cast<int>(k));
      const double y = 30.0 + (static_cast<double>(k) - 6.5) * kSpacing;
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
  // belongs to another plane: one line per plane and arc distance 4.002.
  std::vector<double> angles;
  for (const Contour& contour : sliced.layers[0].contours) {
    const Vec3& p = contour.points.front().p;
    angles.push_back(std::atan2(p.y(), p.z()));
  }
  std::sort(angles.begin(), angles.end());
  ASSERT_GE(angles.size(), 13U);
  for (std::size_t k = 1; k < angles.size(); ++k) {
    // The surface steeper than the planes' limit at both borders is left out.
    EXPECT_NEAR(20.0 * (angles[k] - angles[k - 1]), kSpacing, 0.06) << k;
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
    const double k = std::round((nearest - 3.0) / kSpacing);
    EXPECT_NEAR(nearest, 3.0 + k * kSpacing, 0.05);
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
    EXPECT_LT(high - low, 0.15);
    const double k = std::round((40.0 - 3.0 - low) / kSpacing);
    EXPECT_NEAR(40.0 - low, 3.0 + k * kSpacing, 0.15);
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
