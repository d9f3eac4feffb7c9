// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "sample_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace wcam::test {

/// Open elbow: a tube of radius r bent about the y axis by `bend` rad at radius R, starting at the
/// origin along +z. Vertices of ring i stand at bend·i/rows; ring by ring, `around` each.
inline geometry::TriangleMesh elbowMesh(double r, double R, double bend, int around, int rows) {
  geometry::TriangleMesh mesh = tubeMesh(r, 1.0, around, rows);
  for (int i = 0; i <= rows; ++i) {
    const double phi = bend * i / rows;
    for (int j = 0; j < around; ++j) {
      const double v = 2.0 * kPi * j / around;
      const double rho = R + r * std::cos(v);
      mesh.vertices[static_cast<std::size_t>(i * around + j)] = {
          rho * std::cos(phi) - R, r * std::sin(v), rho * std::sin(phi)};
    }
  }
  return mesh;
}

/// Flat rectangle [0,width]×[0,depth] at z = 0, normal +z; vertex i·(nx+1)+j at row i, column j.
inline geometry::TriangleMesh gridMesh(double width, double depth, int nx, int ny) {
  geometry::TriangleMesh mesh;
  for (int i = 0; i <= ny; ++i) {
    for (int j = 0; j <= nx; ++j) {
      mesh.vertices.emplace_back(width * j / nx, depth * i / ny, 0.0);
    }
  }
  const auto index = [&](int i, int j) { return static_cast<std::uint32_t>(i * (nx + 1) + j); };
  for (int i = 0; i < ny; ++i) {
    for (int j = 0; j < nx; ++j) {
      mesh.triangles.push_back({index(i, j), index(i, j + 1), index(i + 1, j + 1)});
      mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i + 1, j)});
    }
  }
  return mesh;
}

/// Open surface of revolution about z through the profile points (radius, z), bottom first. A last
/// point of radius 0 closes it with a pole. Vertices ring by ring.
inline geometry::TriangleMesh revolvedMesh(const std::vector<geometry::Vec2>& profile, int around) {
  geometry::TriangleMesh mesh;
  const bool pole = profile.back().x() == 0.0;
  const int rings = static_cast<int>(profile.size()) - (pole ? 1 : 0);
  for (int i = 0; i < rings; ++i) {
    const geometry::Vec2& p = profile[static_cast<std::size_t>(i)];
    for (int j = 0; j < around; ++j) {
      const double v = 2.0 * kPi * j / around;
      mesh.vertices.emplace_back(p.x() * std::cos(v), p.x() * std::sin(v), p.y());
    }
  }
  const auto index = [&](int i, int j) {
    return static_cast<std::uint32_t>(i * around + j % around);
  };
  for (int i = 0; i + 1 < rings; ++i) {
    for (int j = 0; j < around; ++j) {
      mesh.triangles.push_back({index(i, j), index(i, j + 1), index(i + 1, j + 1)});
      mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i + 1, j)});
    }
  }
  if (pole) {
    const auto top = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(0.0, 0.0, profile.back().y());
    for (int j = 0; j < around; ++j) {
      mesh.triangles.push_back({index(rings - 1, j), index(rings - 1, j + 1), top});
    }
  }
  return mesh;
}

/// Vertices of the border loop whose mean is lowest (or highest) in z.
inline std::vector<std::uint32_t> borderAt(const geometry::TriangleMesh& mesh, bool lowest) {
  const auto loops = geometry::HalfEdges(mesh).borderLoops(mesh);
  std::vector<std::uint32_t> best;
  double bestMean = 0.0;
  for (const auto& loop : loops) {
    double mean = 0.0;
    for (const std::uint32_t v : loop) {
      mean += mesh.vertices[v].z() / static_cast<double>(loop.size());
    }
    if (best.empty() || (lowest ? mean < bestMean : mean > bestMean)) {
      best = loop;
      bestMean = mean;
    }
  }
  return best;
}

}  // namespace wcam::test
