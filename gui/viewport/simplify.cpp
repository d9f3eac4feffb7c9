// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "simplify.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace wcam::viewport {

namespace {

/// Cells along an axis at most: their numbers share 64 bits.
constexpr double kMostCells = 2097151.0;

double areaOf(const MeshData& mesh) {
  double area = 0.0;
  for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) {
    std::array<std::array<double, 3>, 2> side{};
    const float* a = &mesh.positions[3UL * mesh.triangles[t]];
    for (std::size_t k = 0; k < 2; ++k) {
      const float* b = &mesh.positions[3UL * mesh.triangles[t + 1 + k]];
      for (std::size_t i = 0; i < 3; ++i) {
        side[k][i] = static_cast<double>(b[i]) - static_cast<double>(a[i]);
      }
    }
    area += 0.5 * std::hypot(side[0][1] * side[1][2] - side[0][2] * side[1][1],
                             side[0][2] * side[1][0] - side[0][0] * side[1][2],
                             side[0][0] * side[1][1] - side[0][1] * side[1][0]);
  }
  return area;
}

/// The cell of every vertex.
std::vector<std::uint64_t> cellsOf(const MeshData& mesh, double edge) {
  std::array<float, 3> low = {mesh.positions[0], mesh.positions[1], mesh.positions[2]};
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], mesh.positions[i]);
  }
  std::vector<std::uint64_t> cells(mesh.positions.size() / 3, 0);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const double at = static_cast<double>(mesh.positions[i] - low[i % 3]) / edge;
    cells[i / 3] = cells[i / 3] << 21U | static_cast<std::uint64_t>(std::min(at, kMostCells));
  }
  return cells;
}

}  // namespace

MeshData simplified(MeshData mesh, std::size_t most) {
  const std::size_t count = mesh.triangles.size() / 3;
  if (count <= most) {
    return mesh;
  }
  const double area = areaOf(mesh);
  if (!(area > 0.0) || !std::isfinite(area)) {
    return mesh;
  }
  // A cell that the surface crosses holds one vertex, and a surface has two triangles for each.
  const double edge = std::sqrt(2.0 * area / static_cast<double>(most));
  const std::vector<std::uint64_t> cells = cellsOf(mesh, edge);
  std::vector<std::uint32_t> order(cells.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&cells](std::uint32_t a, std::uint32_t b) {
    return cells[a] != cells[b] ? cells[a] < cells[b] : a < b;
  });
  MeshData result;
  std::vector<std::uint32_t> vertexOf(cells.size());
  for (std::size_t i = 0; i < order.size();) {
    std::array<double, 3> sum{};
    const std::size_t begin = i;
    for (; i < order.size() && cells[order[i]] == cells[order[begin]]; ++i) {
      vertexOf[order[i]] = static_cast<std::uint32_t>(result.positions.size() / 3);
      for (std::size_t k = 0; k < 3; ++k) {
        sum[k] += static_cast<double>(mesh.positions[3UL * order[i] + k]);
      }
    }
    for (const double value : sum) {
      result.positions.push_back(static_cast<float>(value / static_cast<double>(i - begin)));
    }
  }
  for (std::size_t t = 0; t < count; ++t) {
    const std::uint32_t a = vertexOf[mesh.triangles[3 * t]];
    const std::uint32_t b = vertexOf[mesh.triangles[3 * t + 1]];
    const std::uint32_t c = vertexOf[mesh.triangles[3 * t + 2]];
    if (a != b && b != c && c != a) {
      result.triangles.insert(result.triangles.end(), {a, b, c});
      if (!mesh.faces.empty()) {
        result.faces.push_back(mesh.faces[t]);
      }
    }
  }
  result.edgePositions = std::move(mesh.edgePositions);
  result.edgeBegin = std::move(mesh.edgeBegin);
  result.edgeIds = std::move(mesh.edgeIds);
  return result;
}

}  // namespace wcam::viewport
