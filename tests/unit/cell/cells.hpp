// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/quantity.hpp"
#include "wcam/cell/cell.hpp"

#include <cmath>
#include <initializer_list>
#include <random>
#include <string>

namespace wcam::cell::test {

inline Cell shippedCell(const std::string& name, const JobContext& context = JobContext()) {
  return loadCell(std::string(WCAM_RESOURCES) + "/cells/" + name + ".json", context);
}

inline Cell fanuc() {
  return shippedCell("fanuc_arcmate120ic");
}

inline Cell fanucPartCarried() {
  return shippedCell("fanuc_arcmate120ic_part_carried");
}

inline Cell yaskawa() {
  return shippedCell("yaskawa_ma1440_mt250");
}

/// Joint vector from degrees.
inline JointVector degrees(std::initializer_list<double> values) {
  JointVector q(static_cast<Eigen::Index>(values.size()));
  Eigen::Index i = 0;
  for (const double value : values) {
    q(i++) = degToRad(value);
  }
  return q;
}

inline double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
}

inline Vec3 randomUnit(std::mt19937_64& random) {
  for (;;) {
    const Vec3 v(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
    if (v.norm() > 0.1 && v.norm() < 1.0) {
      return v.normalized();
    }
  }
}

inline JointVector randomJoints(std::mt19937_64& random, int count, double range = kPi) {
  JointVector q(count);
  for (int j = 0; j < count; ++j) {
    q(j) = uniform(random, -range, range);
  }
  return q;
}

inline double angleBetween(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Largest difference of two poses: mm of the translation, or of the rotation matrices.
inline double poseDifference(const Pose& a, const Pose& b) {
  return std::max((a.translation() - b.translation()).cwiseAbs().maxCoeff(),
                  (a.linear() - b.linear()).cwiseAbs().maxCoeff());
}

}  // namespace wcam::cell::test
