// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/linear_elements.hpp"

#include <algorithm>
#include <numeric>

namespace wcam::geometry {

namespace {

/// Least height of a triangle over its longest edge. Cotangents stay below its inverse, which
/// leaves nine of the sixteen digits to the sums of a row; the heights of true triangles, down to
/// slivers of 0.1 µm on a metre, lie above.
constexpr double kLeastHeight = 1e-7;

std::uint32_t rootOf(std::vector<std::uint32_t>& parent, std::uint32_t v) {
  while (parent[v] != v) {
    parent[v] = parent[parent[v]];
    v = parent[v];
  }
  return v;
}

}  // namespace

FlatTriangle flatten(const TriangleMesh& mesh, std::size_t triangle) {
  const auto& corners = mesh.triangles[triangle];
  std::size_t base = 0;
  double longest = -1.0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double length = (mesh.vertices[corners[(c + 1) % 3]] - mesh.vertices[corners[c]]).norm();
    if (length > longest) {
      longest = length;
      base = c;
    }
  }
  FlatTriangle flat;
  if (!(longest > 0.0)) {
    return flat;
  }
  const Vec3& a = mesh.vertices[corners[base]];
  const Vec3& b = mesh.vertices[corners[(base + 1) % 3]];
  const Vec3 toApex = mesh.vertices[corners[(base + 2) % 3]] - a;
  flat.first = (b - a) / longest;
  // The longest edge is the base, so that the foot of the height lies on it.
  const double foot = std::clamp(toApex.dot(flat.first), 0.0, longest);
  const Vec3 rise = toApex - toApex.dot(flat.first) * flat.first;
  const double least = kLeastHeight * longest;
  const double height = std::max(rise.norm(), least);
  if (rise.norm() > least) {
    flat.second = rise / rise.norm();
  }
  flat.area = 0.5 * longest * height;
  flat.gradients[base] = {-1.0 / longest, (foot / longest - 1.0) / height};
  flat.gradients[(base + 1) % 3] = {1.0 / longest, -foot / longest / height};
  flat.gradients[(base + 2) % 3] = {0.0, 1.0 / height};
  return flat;
}

SparseMatrix stiffnessMatrix(const TriangleMesh& mesh) {
  const auto n = static_cast<Eigen::Index>(mesh.vertices.size());
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(9 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const FlatTriangle flat = flatten(mesh, t);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        entries.emplace_back(static_cast<int>(mesh.triangles[t][i]),
                             static_cast<int>(mesh.triangles[t][j]),
                             flat.area * flat.gradients[i].dot(flat.gradients[j]));
      }
    }
  }
  SparseMatrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

std::vector<double> vertexAreas(const TriangleMesh& mesh) {
  std::vector<double> areas(mesh.vertices.size(), 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double third = flatten(mesh, t).area / 3.0;
    for (const std::uint32_t v : mesh.triangles[t]) {
      areas[v] += third;
    }
  }
  return areas;
}

Eigen::VectorXd divergence(const TriangleMesh& mesh, const std::vector<Vec3>& vectors) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.vertices.size()));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const FlatTriangle flat = flatten(mesh, t);
    const Vec2 x = flat.toPlane(vectors[t]);
    for (std::size_t c = 0; c < 3; ++c) {
      result[mesh.triangles[t][c]] += flat.area * flat.gradients[c].dot(x);
    }
  }
  return result;
}

std::vector<std::uint32_t> componentsOf(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0U);
  for (const auto& t : mesh.triangles) {
    for (std::size_t c = 1; c < 3; ++c) {
      const std::uint32_t a = rootOf(parent, t[0]);
      const std::uint32_t b = rootOf(parent, t[c]);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  std::uint32_t count = 0;
  std::vector<std::uint32_t> component(parent.size());
  for (std::uint32_t v = 0; v < parent.size(); ++v) {
    const std::uint32_t root = rootOf(parent, v);
    component[v] = root == v ? count++ : component[root];
  }
  return component;
}

}  // namespace wcam::geometry
