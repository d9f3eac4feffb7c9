// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/constant_distance.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"
#include "wcam/geometry/guide_curve.hpp"
#include "wcam/toolpath/layer_distance.hpp"

#include "sample_meshes.hpp"
#include "slicing_fixture.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

/// Constant inter-layer distance on the test parts of Chalvin (AT-08 … AT-15).
namespace wcam::toolpath {
namespace {

constexpr double kR = 50.0;
constexpr double kr = 15.0;

std::shared_ptr<const geometry::PartSurface> formulaPart(const std::string& name) {
  return io::importPart(std::string(WCAM_TEST_DATA) + "/formula/" + name, io::ImportOptions{},
                        geometry::Pose::Identity(), JobContext())
      .surface;
}

plugin::SliceInput inputOf(std::shared_ptr<const geometry::PartSurface> part,
                           const Sampling& sampling = {}) {
  return {{std::move(part)}, test::plate(), nullptr, sampling};
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

/// Torus parameters of a point: u along, v around, rad.
double torusU(const Vec3& p) {
  return std::atan2(p.z(), p.x() + kR);
}

double torusV(const Vec3& p) {
  return std::atan2(p.y(), std::hypot(p.x() + kR, p.z()) - kR);
}

/// u of a layer where it crosses v, by interpolation between its points.
double uAt(const SlicedLayer& layer, double v) {
  for (const Contour& contour : layer.contours) {
    const std::size_t n = contour.points.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3& a = contour.points[i].p;
      const Vec3& b = contour.points[(i + 1) % n].p;
      const double va = std::remainder(torusV(a) - v, 2.0 * kPi);
      const double vb = std::remainder(torusV(b) - v, 2.0 * kPi);
      if (std::abs(va) < 1.0 && std::abs(vb) < 1.0 && (va < 0.0) != (vb < 0.0)) {
        return torusU(a) + (torusU(b) - torusU(a)) * va / (va - vb);
      }
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// Greatest |δ − step| of all layers above the first, measured as A4 between the output polylines.
double worstDistance(const SlicedLayers& sliced, double step) {
  double worst = 0.0;
  for (std::size_t l = 1; l < sliced.layers.size(); ++l) {
    for (const double d :
         layerDistance(pointsOf(sliced.layers[l]), sliced.layers[l - 1].contours)) {
      worst = std::max(worst, std::abs(d - step));
    }
  }
  return worst;
}

/// Writes the layers for a plot when WCAM_TEST_PLOT names a folder.
void plot(const SlicedLayers& sliced, const std::string& name) {
  const char* folder = std::getenv("WCAM_TEST_PLOT");
  if (folder == nullptr) {
    return;
  }
  std::ofstream out(std::string(folder) + "/" + name + ".txt");
  for (const SlicedLayer& layer : sliced.layers) {
    for (const Contour& contour : layer.contours) {
      for (std::size_t i = 0; i < contour.points.size() + (contour.closed ? 1 : 0); ++i) {
        const Vec3& p = contour.points[i % contour.points.size()].p;
        out << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
      }
      out << '\n';
    }
  }
}

TEST(ConstantDistance, TorusHasTheStepEverywhere) {
  // AT-09, on a torus of 110 degrees so that the last layers are whole.
  JobContext context;
  const SlicedLayers sliced =
      test::slice("wcam.slicing.constant", inputOf(formulaPart("p4_torus_110.wsurf")),
                  R"({"step": 5.0, "first_layer": 0})", context);
  plot(sliced, "torus");
  for (const Diagnostic& d : context.diagnostics().items()) {
    ADD_FAILURE() << toLine(d);
  }
  ASSERT_GE(sliced.layers.size(), 18U);
  EXPECT_LE(worstDistance(sliced, 5.0), 0.01);
  for (std::size_t n = 0; n <= 17; ++n) {
    SCOPED_TRACE("layer " + std::to_string(n));
    const SlicedLayer& layer = sliced.layers[n];
    ASSERT_EQ(layer.contours.size(), 1U);
    EXPECT_TRUE(layer.contours[0].closed);
    EXPECT_NEAR(uAt(layer, kPi), static_cast<double>(n) * 2.0 * std::asin(5.0 / 70.0), 1e-4);
    double least = 10.0;
    for (const Vec3& p : pointsOf(layer)) {
      least = std::min(least, torusU(p));
      const Vec3 centre = kR * Vec3(p.x() + kR, 0, p.z()).normalized() - Vec3(kR, 0, 0);
      EXPECT_NEAR((p - centre).norm(), kr, 1e-6);
    }
    EXPECT_EQ(least >= kPi / 2.0, n >= 17);
  }
  EXPECT_NEAR(radToDeg(uAt(sliced.layers[10], 0.0)), 44.1, 0.3);
  EXPECT_NEAR(radToDeg(uAt(sliced.layers[17], 0.0)), 92.4, 0.3);
}

}  // namespace
}  // namespace wcam::toolpath
