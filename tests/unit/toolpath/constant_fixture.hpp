// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/toolpath/layer_distance.hpp"

#include "sample_meshes.hpp"
#include "slicing_fixture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>

/// What the tests of layers on the parts of Chalvin share.
namespace wcam::toolpath::constant_test {

inline constexpr double kR = 50.0;
inline constexpr double kr = 15.0;

inline std::shared_ptr<const geometry::PartSurface> formulaPart(
    const std::string& name, const geometry::Pose& pose = geometry::Pose::Identity()) {
  return io::importPart(std::string(WCAM_TEST_DATA) + "/formula/" + name, io::ImportOptions{}, pose,
                        JobContext())
      .surface;
}

inline plugin::SliceInput inputOf(std::shared_ptr<const geometry::PartSurface> part,
                                  const Sampling& sampling = {}) {
  return {{std::move(part)}, test::plate(), nullptr, sampling};
}

inline std::vector<Vec3> pointsOf(const SlicedLayer& layer) {
  std::vector<Vec3> points;
  for (const Contour& contour : layer.contours) {
    for (const ContourPoint& point : contour.points) {
      points.push_back(point.p);
    }
  }
  return points;
}

/// Torus parameters of a point: u along, v around, rad.
inline double torusU(const Vec3& p) {
  return std::atan2(p.z(), p.x() + kR);
}

inline double torusV(const Vec3& p) {
  return std::atan2(p.y(), std::hypot(p.x() + kR, p.z()) - kR);
}

/// u of a layer where it crosses v, by interpolation between its points.
inline double uAt(const SlicedLayer& layer, double v) {
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
inline double worstDistance(const SlicedLayers& sliced, double step) {
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
inline void plot(const SlicedLayers& sliced, const std::string& name) {
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

/// A cylinder R 32 along y as a substrate (Chalvin A10, orientation 1).
inline std::shared_ptr<const Substrate> cylinderSubstrate() {
  geometry::Pose pose = geometry::Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(-kPi / 2.0, Vec3::UnitX()).toRotationMatrix();
  return std::make_shared<Substrate>(geometry::Pose::Identity(),
                                     formulaPart("cylinder_r32.wsurf", pose));
}

}  // namespace wcam::toolpath::constant_test
