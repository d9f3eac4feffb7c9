// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "viewport/simplify.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace wcam::viewport {
namespace {

constexpr double kRadius = 50.0;

/// Sphere of rows × columns vertices.
MeshData sphere(int rows, int columns) {
  MeshData mesh;
  for (int i = 0; i < rows; ++i) {
    for (int k = 0; k < columns; ++k) {
      const double u = M_PI * (i + 0.5) / rows;
      const double v = 2.0 * M_PI * k / columns;
      mesh.positions.insert(mesh.positions.end(),
                            {static_cast<float>(kRadius * std::sin(u) * std::cos(v)),
                             static_cast<float>(kRadius * std::sin(u) * std::sin(v)),
                             static_cast<float>(kRadius * std::cos(u))});
    }
  }
  const auto at = [columns](int i, int k) {
    return static_cast<std::uint32_t>(i * columns + k % columns);
  };
  for (int i = 0; i + 1 < rows; ++i) {
    for (int k = 0; k < columns; ++k) {
      mesh.triangles.insert(mesh.triangles.end(), {at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      mesh.triangles.insert(mesh.triangles.end(), {at(i, k), at(i + 1, k + 1), at(i, k + 1)});
      mesh.faces.insert(mesh.faces.end(), {i % 7, i % 7});
    }
  }
  return mesh;
}

TEST(Simplified, LeavesASmallMeshAsItIs) {
  const MeshData mesh = sphere(20, 40);
  const MeshData same = simplified(mesh, mesh.triangles.size() / 3);
  EXPECT_EQ(same.positions, mesh.positions);
  EXPECT_EQ(same.triangles, mesh.triangles);
}

TEST(Simplified, KeepsTheShapeOfALargeOne) {
  constexpr std::size_t kMost = 10000;
  const MeshData mesh = sphere(300, 600);
  const MeshData coarse = simplified(mesh, kMost);
  const std::size_t count = coarse.triangles.size() / 3;
  EXPECT_GT(count, kMost / 3);
  EXPECT_LT(count, 2 * kMost);
  ASSERT_EQ(coarse.faces.size(), count);
  EXPECT_TRUE(std::all_of(coarse.faces.begin(), coarse.faces.end(),
                          [](std::int32_t face) { return face >= 0 && face < 7; }));
  // Means of points on the sphere within a cell's diagonal lie below it by no more than its
  // sagitta.
  const double edge = std::sqrt(2.0 * 4.0 * M_PI * kRadius * kRadius / kMost);
  const double sagitta = 3.0 * edge * edge / (2.0 * kRadius);
  for (std::size_t i = 0; i < coarse.positions.size(); i += 3) {
    const double r =
        std::hypot(coarse.positions[i], coarse.positions[i + 1], coarse.positions[i + 2]);
    ASSERT_LE(r, kRadius + 1e-4);
    ASSERT_GE(r, kRadius - sagitta);
  }
}

TEST(Simplified, TakesDamagedMeshes) {
  MeshData flat = sphere(30, 60);
  for (float& x : flat.positions) {
    x = 1.0F;
  }
  EXPECT_EQ(simplified(flat, 10).triangles.size(), flat.triangles.size())
      << "without area nothing is known";
  flat.positions[5] = std::nanf("");
  EXPECT_EQ(simplified(flat, 10).triangles.size(), flat.triangles.size());
  EXPECT_TRUE(simplified(MeshData(), 0).triangles.empty());
}

}  // namespace
}  // namespace wcam::viewport
