// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The least translation against FCL: it parts the two, and nothing clearly shorter does.

#include "overlap.hpp"

#include "wcam/base/quantity.hpp"

#include "exact.hpp"
#include <gtest/gtest.h>

#include <random>

namespace wcam::collision::detail {
namespace {

double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
}

Vec3 unit(std::mt19937_64& random) {
  const double z = uniform(random, -1.0, 1.0);
  const double a = uniform(random, 0.0, 2.0 * kPi);
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(a), r * std::sin(a), z};
}

Shape randomShape(std::mt19937_64& random, ShapeKind kind) {
  Shape shape;
  shape.kind = kind;
  shape.radius = uniform(random, 5.0, 30.0);
  shape.length = uniform(random, 10.0, 120.0);
  shape.size = {uniform(random, 10, 100), uniform(random, 10, 100), uniform(random, 10, 100)};
  return shape;
}

Pose randomPose(std::mt19937_64& random, double range) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(uniform(random, -kPi, kPi), unit(random)).toRotationMatrix();
  pose.translation() = uniform(random, 0.0, range) * unit(random);
  return pose;
}

TEST(Overlap, TheLeastTranslationPartsSolidsAndNoShorterOneDoes) {
  constexpr int kDirections = 60;
  std::mt19937_64 random(20261201);
  const std::array kinds = {ShapeKind::Sphere, ShapeKind::Capsule, ShapeKind::Cylinder,
                            ShapeKind::Box};
  int overlapping = 0;
  for (int i = 0; i < 400; ++i) {
    const Shape first = randomShape(random, kinds[static_cast<std::size_t>(i) % 4]);
    const Shape second = randomShape(random, kinds[static_cast<std::size_t>(i) / 4 % 4]);
    const Pose T_a = randomPose(random, 60.0);
    const Pose T_b = Pose::Identity();
    const ExactShape a(first);
    const ExactShape b(second);
    const Overlap found = leastTranslation(primitiveOf(first), T_a, primitiveOf(second), T_b);
    const double distance = exactDistance(a, T_a, b, T_b).value;
    if (found.depth <= 0.0) {
      EXPECT_GE(distance, -1e-3) << i;
      continue;
    }
    if (found.depth < 0.5) {
      continue;  // where rounding and FCL's own tolerance decide
    }
    ++overlapping;
    const auto movedBy = [&](const Vec3& move) {
      Pose T = T_a;
      T.translation() += move;
      return exactDistance(a, T, b, T_b).value;
    };
    EXPECT_GE(movedBy((found.depth + 0.02) * found.way), 0.0) << i;
    for (int k = 0; k < kDirections; ++k) {
      EXPECT_LE(movedBy(0.97 * found.depth * unit(random)), 1e-3) << i << ", direction " << k;
    }
  }
  EXPECT_GT(overlapping, 150);
}

}  // namespace
}  // namespace wcam::collision::detail
