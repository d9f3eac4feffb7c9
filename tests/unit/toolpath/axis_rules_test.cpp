// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/build.hpp"
#include "wcam/toolpath/numeric_frames.hpp"
#include "wcam/toolpath/tool_axis.hpp"

#include "hand_made_layers.hpp"
#include "slicing_fixture.hpp"
#include <gtest/gtest.h>

#include <random>

namespace wcam::toolpath {
namespace {

using test::circle;
using test::layerOf;

double angle(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

Toolpath build(const SlicedLayers& sliced,
               const std::string& params,
               const JobContext& context = JobContext()) {
  return buildToolpath(sliced, *test::plate(), PathParams::schema().read(parseJson(params)),
                       context);
}

/// Latitude circles of a hemisphere, 5 mm apart on the meridian.
SlicedLayers hemisphere() {
  SlicedLayers sliced{{}, true};
  constexpr double kRadius = 45.0;
  for (int k = 0; 5.0 * k / kRadius < 0.5 * kPi; ++k) {
    const double u = 5.0 * k / kRadius;
    Contour contour;
    contour.closed = true;
    for (int i = 0; i < 120; ++i) {
      const double v = -2 * kPi * i / 120;
      const Vec3 n(std::cos(u) * std::cos(v), std::cos(u) * std::sin(v), std::sin(u));
      contour.points.push_back({kRadius * n, n});
    }
    sliced.layers.push_back(layerOf(5.0 * k, {contour}));
  }
  return sliced;
}

TEST(AxisRules, HemisphereLeansAtMostFiftyDegrees) {
  // Chalvin AT-22: b tangent to the meridian; angle(T, Z) ≤ 50° everywhere, = 50° towards the pole.
  const Toolpath path = build(hemisphere(), R"({"axis_limit": 50.0})");
  const double limit = degToRad(50.0);
  for (const Layer& layer : path.layers) {
    for (const PathPoint& point : layer.beads[0].points) {
      const Vec3 n = point.p.normalized();
      const Vec3 meridian = (Vec3::UnitZ() - n.z() * n).normalized();
      EXPECT_NEAR((point.b - meridian).norm(), 0.0, 1e-9);
      const double beta = angle(point.b, Vec3::UnitZ());
      EXPECT_LE(angle(point.axis, Vec3::UnitZ()), limit + 1e-9);
      EXPECT_NEAR(angle(point.axis, Vec3::UnitZ()), std::min(beta, limit), 1e-9);
      // The same by the lateral tilt of the corrected rule: θt = β − 50°, n outwards.
      const double tilt = beta > limit ? beta - limit : 0.0;
      const Vec3 byTilt = tiltedAxis(point.t, point.n, point.b, Angle(0.0), Angle(tilt));
      EXPECT_NEAR((byTilt - point.axis).norm(), 0.0, 1e-9);
    }
  }
  const Layer& last = path.layers.back();
  EXPECT_NEAR(angle(last.beads[0].points[0].axis, Vec3::UnitZ()), limit, 1e-12);
}

TEST(AxisRules, LimitOfADirectionStraightDown) {
  const Vec3 axis = limitedAxis(-Vec3::UnitZ(), Vec3::UnitZ(), Angle(degToRad(50.0)));
  EXPECT_NEAR(angle(axis, Vec3::UnitZ()), degToRad(50.0), 1e-12);
  EXPECT_EQ(limitedAxis(-Vec3::UnitZ(), Vec3::UnitZ(), Angle(kPi)), -Vec3::UnitZ());
}

TEST(AxisRules, ProjectionOnAPlane) {
  // Chalvin A16c: build directions projected on the YZ plane.
  JobContext context;
  const Toolpath path =
      build(hemisphere(), R"({"axis_project": true, "axis_plane_normal": [2, 0, 0]})", context);
  for (const Layer& layer : path.layers) {
    for (const PathPoint& point : layer.beads[0].points) {
      EXPECT_NEAR(point.axis.norm(), 1.0, 1e-12);
      EXPECT_NEAR(point.axis.x(), 0.0, 1e-12);
      const Vec3 inPlane(0, point.b.y(), point.b.z());
      EXPECT_NEAR((point.axis - inPlane.normalized()).norm(), 0.0, 1e-12);
    }
  }
  EXPECT_EQ(context.diagnostics().count("toolpath.axis_not_projected"), 0U);
  (void)build({{layerOf(2, {circle(20, 2)})}},
              R"({"axis_project": true, "axis_plane_normal": [0, 0, 1]})", context);
  EXPECT_EQ(context.diagnostics().count("toolpath.axis_not_projected"), 1U);
}

TEST(AxisRules, MeanOfALayer) {
  const Toolpath path = build(hemisphere(), R"({"axis": "mean"})");
  for (const PathPoint& point : path.layers[4].beads[0].points) {
    EXPECT_NEAR((point.axis - Vec3::UnitZ()).norm(), 0.0, 1e-9);
  }
  // A ring across a leaning tube: b is the tube's axis.
  const Vec3 axis = Vec3(0.3, 0.0, 1.0).normalized();
  const Vec3 side = Vec3::UnitY().cross(axis).normalized();
  Contour contour;
  contour.closed = true;
  for (int i = 0; i < 90; ++i) {
    const double v = -2 * kPi * i / 90;
    const Vec3 n = std::cos(v) * side + std::sin(v) * Vec3::UnitY();
    contour.points.push_back({20.0 * n + 50.0 * axis, n});
  }
  const Toolpath mean = build({{layerOf(50.0, {contour})}, true}, R"({"axis": "mean"})");
  EXPECT_NEAR((mean.layers[0].beads[0].points[0].axis - axis).norm(), 0.0, 1e-9);
}

TEST(AxisRules, AxesThatComeWithThePathAreKept) {
  SlicedLayers sliced{{layerOf(2.0, {circle(20, 2.0)})}};
  for (ContourPoint& point : sliced.layers[0].contours[0].points) {
    point.axis = Vec3(0, 0.6, 0.8);
  }
  EXPECT_EQ(build(sliced, "{}").layers[0].beads[0].points[5].axis, Vec3(0, 0.6, 0.8).normalized());
  EXPECT_EQ(build(sliced, R"({"axis": "layer"})").layers[0].beads[0].points[5].axis, Vec3::UnitZ());
}

double greatestRate(const std::vector<Vec3>& p, const std::vector<Vec3>& axes) {
  double rate = 0.0;
  for (std::size_t i = 1; i < p.size(); ++i) {
    rate = std::max(rate, angle(axes[i], axes[i - 1]) / (p[i] - p[i - 1]).norm());
  }
  return rate;
}

TEST(SmoothedAxes, AStepBecomesARampAroundIt) {
  std::vector<Vec3> p;
  std::vector<Vec3> wanted;
  for (int i = 0; i <= 200; ++i) {
    p.emplace_back(i, 0, 0);
    wanted.push_back(i <= 100 ? Vec3::UnitZ() : Vec3(0, std::sin(1.0), std::cos(1.0)));
  }
  const double rate = degToRad(1.0);
  const SmoothedAxes smoothed = smoothedAxes(p, wanted, false, rate);
  EXPECT_LE(greatestRate(p, smoothed.axes), rate * (1 + 1e-9));
  // The best there is deviates by half of the step, less half of what one spacing allows.
  EXPECT_NEAR(smoothed.maxDeviation, 0.5, 0.02);
  // Far from the step nothing changes.
  EXPECT_LT(angle(smoothed.axes[60], wanted[60]), 1e-3);
  EXPECT_LT(angle(smoothed.axes[140], wanted[140]), 1e-3);
}

TEST(SmoothedAxes, WhatHoldsTheBoundStaysAsItIs) {
  std::vector<Vec3> p;
  std::vector<Vec3> wanted;
  for (int i = 0; i <= 50; ++i) {
    p.emplace_back(i, 0, 0);
    wanted.emplace_back(0, std::sin(0.01 * i), std::cos(0.01 * i));
  }
  const SmoothedAxes smoothed = smoothedAxes(p, wanted, false, 0.0101);
  EXPECT_EQ(smoothed.axes, wanted);
  EXPECT_EQ(smoothed.maxDeviation, 0.0);
  EXPECT_EQ(smoothedAxes({Vec3::Zero()}, {Vec3::UnitZ()}, false, 1.0).axes.size(), 1U);
}

TEST(SmoothedAxes, RandomFieldsHoldTheBoundOpenAndClosed) {
  constexpr unsigned kSeed = 99;
  std::mt19937 random(kSeed);
  std::normal_distribution<double> normal;
  for (int run = 0; run < 40; ++run) {
    const bool closed = run % 2 == 0;
    std::vector<Vec3> p;
    std::vector<Vec3> wanted;
    Vec3 drift = Vec3::UnitZ();
    for (int i = 0; i < 150; ++i) {
      p.emplace_back(30 * std::cos(2 * kPi * i / 150), 30 * std::sin(2 * kPi * i / 150), 0);
      drift = (drift + 0.4 * Vec3(normal(random), normal(random), normal(random))).normalized();
      wanted.push_back(drift);
    }
    if (closed) {
      p.push_back(p.front());
      wanted.push_back(wanted.front());
    }
    const double rate = degToRad(0.5 + 0.2 * run);
    const SmoothedAxes smoothed = smoothedAxes(p, wanted, closed, rate);
    EXPECT_LE(greatestRate(p, smoothed.axes), rate * (1 + 1e-6) + 1e-9)
        << "seed " << kSeed << " run " << run;
    if (closed) {
      EXPECT_EQ(smoothed.axes.front(), smoothed.axes.back());
    }
    for (const Vec3& axis : smoothed.axes) {
      EXPECT_NEAR(axis.norm(), 1.0, 1e-12);
    }
  }
}

TEST(AxisRules, SmoothingReportsWhatItCosts) {
  const SlicedLayers sliced{
      {layerOf(2.0, {test::polygon({{-20, -20}, {-20, 20}, {20, 20}, {20, -20}}, 2.0)})}};
  JobContext context;
  // With lead the axis turns by 90° of travel in a corner.
  const Toolpath path = build(sliced, R"({"lead": 30, "axis_rate": 0.2})", context);
  EXPECT_EQ(context.diagnostics().count("toolpath.axis_smoothed"), 1U);
  const auto& points = path.layers[0].beads[0].points;
  for (std::size_t i = 1; i < points.size(); ++i) {
    EXPECT_LE(radToDeg(angle(points[i].axis, points[i - 1].axis)),
              0.2 * (points[i].p - points[i - 1].p).norm() + 1e-6);
  }
}

/// Chalvin A9: quarter torus in iso-v layers, Δ = 5 on every generatrix.
SlicedLayers isoTorus(int points) {
  SlicedLayers sliced{{}, true};
  std::vector<double> u(static_cast<std::size_t>(points), 0.0);
  for (int k = 0; k < 11; ++k) {
    Contour contour;
    contour.closed = true;
    for (int i = 0; i < points; ++i) {
      const double v = -2 * kPi * i / points;
      const double rho = 50 + 15 * std::cos(v);
      double& at = u[static_cast<std::size_t>(i)];
      const Vec3 n(std::cos(v) * std::cos(at), std::sin(v), std::cos(v) * std::sin(at));
      contour.points.push_back(
          {Vec3(rho * std::cos(at) - 50, 15 * std::sin(v), rho * std::sin(at)), n});
      at += std::acos(1.0 - 25.0 / (2.0 * rho * rho));
    }
    sliced.layers.push_back(layerOf(5.0 * k, {contour}));
  }
  return sliced;
}

TEST(NumericNormals, IsoParametricTorusWithinOnePercent) {
  // Chalvin AT-21 (Eq. 2.36): μ ≤ 0.01 at Δ = 5 and 500 points.
  const SlicedLayers exact = isoTorus(500);
  SlicedLayers numeric = exact;
  for (SlicedLayer& layer : numeric.layers) {
    for (ContourPoint& point : layer.contours[0].points) {
      point.n = Vec3::Zero();
    }
  }
  setNumericNormals(numeric);
  for (std::size_t l = 0; l < exact.layers.size(); ++l) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 500; ++i) {
      const Vec3& n = numeric.layers[l].contours[0].points[i].n;
      EXPECT_NEAR(n.norm(), 1.0, 1e-12);
      sum += (n - exact.layers[l].contours[0].points[i].n).norm();
    }
    // The end layers have one neighbour and hence one facet: the slope over half a step.
    const bool end = l == 0 || l + 1 == exact.layers.size();
    EXPECT_LE(sum / 500, end ? 0.05 : 0.01) << "layer " << l;
  }
}

TEST(NumericNormals, SingleLayersAndOpenBeads) {
  SlicedLayers one{{layerOf(2.0, {circle(20, 2.0)})}};
  const SlicedLayers exact = one;
  one.layers[0].contours[0].points[3].n = Vec3::Zero();
  setNumericNormals(one);
  EXPECT_NEAR(
      (one.layers[0].contours[0].points[3].n - exact.layers[0].contours[0].points[3].n).norm(), 0.0,
      1e-9);
  Contour line;
  line.points = {{Vec3(0, 0, 2), Vec3::Zero()}, {Vec3(5, 0, 2), Vec3::Zero()}};
  Contour dot;
  dot.points = {{Vec3(9, 9, 2), Vec3::Zero()}};
  SlicedLayers open{{layerOf(2.0, {line, dot, Contour{}})}};
  setNumericNormals(open);
  EXPECT_NEAR((open.layers[0].contours[0].points[0].n - Vec3::UnitY()).norm(), 0.0, 1e-12);
  EXPECT_NEAR(open.layers[0].contours[1].points[0].n.norm(), 1.0, 1e-12);
}

}  // namespace
}  // namespace wcam::toolpath
