// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_order.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace wcam::io {

namespace {

using geometry::TriangleMesh;
using geometry::Vec3;

constexpr unsigned kBitsPerAxis = 10;
constexpr unsigned kRadixBits = 10;
constexpr std::size_t kRadix = std::size_t{1} << kRadixBits;

struct Item {
  std::uint32_t key;
  std::uint32_t vertex;
};

/// Spreads the ten low bits: bit i goes to bit 3i.
std::uint32_t spread(std::uint32_t x) {
  x = (x | (x << 16U)) & 0x030000FFU;
  x = (x | (x << 8U)) & 0x0300F00FU;
  x = (x | (x << 4U)) & 0x030C30C3U;
  x = (x | (x << 2U)) & 0x09249249U;
  return x;
}

std::vector<Item> mortonItems(const std::vector<Vec3>& vertices) {
  geometry::Box box;
  for (const Vec3& p : vertices) {
    box.add(p);
  }
  constexpr double kCells = double(1U << kBitsPerAxis);
  Vec3 scale = Vec3::Zero();
  for (int k = 0; k < 3; ++k) {
    // Halved first: the difference of two finite numbers may overflow.
    const double half = 0.5 * box.max[k] - 0.5 * box.min[k];
    scale[k] = half > 0.0 ? 0.5 * kCells / half : 0.0;
    scale[k] = scale[k] < std::numeric_limits<double>::infinity() ? scale[k] : 0.0;
  }
  const auto cell = [&](const Vec3& p, int k) {
    const double x = (0.5 * p[k] - 0.5 * box.min[k]) * 2.0 * scale[k];
    return static_cast<std::uint32_t>(std::clamp(x, 0.0, kCells - 1.0));
  };
  std::vector<Item> items(vertices.size());
  for (std::uint32_t v = 0; v < items.size(); ++v) {
    const Vec3& p = vertices[v];
    items[v] = {spread(cell(p, 0)) | spread(cell(p, 1)) << 1U | spread(cell(p, 2)) << 2U, v};
  }
  return items;
}

/// Stable radix sort by key.
void sortItems(std::vector<Item>& items) {
  std::vector<Item> other(items.size());
  for (unsigned shift = 0; shift < 3 * kBitsPerAxis; shift += kRadixBits) {
    std::array<std::uint32_t, kRadix + 1> start{};
    for (const Item& item : items) {
      ++start[((item.key >> shift) & (kRadix - 1)) + 1];
    }
    for (std::size_t r = 1; r <= kRadix; ++r) {
      start[r] += start[r - 1];
    }
    for (const Item& item : items) {
      other[start[(item.key >> shift) & (kRadix - 1)]++] = item;
    }
    items.swap(other);
  }
}

void sortTriangles(TriangleMesh& mesh) {
  const auto lowest = [](const std::array<std::uint32_t, 3>& t) {
    return std::min({t[0], t[1], t[2]});
  };
  std::vector<std::uint32_t> start(mesh.vertices.size() + 1, 0);
  for (const auto& t : mesh.triangles) {
    ++start[lowest(t) + 1];
  }
  for (std::size_t v = 1; v < start.size(); ++v) {
    start[v] += start[v - 1];
  }
  std::vector<std::array<std::uint32_t, 3>> sorted(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    sorted[start[lowest(t)]++] = t;
  }
  mesh.triangles.swap(sorted);
}

}  // namespace

void sortForLocality(TriangleMesh& mesh) {
  std::vector<Item> items = mortonItems(mesh.vertices);
  sortItems(items);
  std::vector<std::uint32_t> newIndex(items.size());
  std::vector<Vec3> vertices(items.size());
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    newIndex[items[i].vertex] = i;
    vertices[i] = mesh.vertices[items[i].vertex];
  }
  mesh.vertices.swap(vertices);
  for (auto& t : mesh.triangles) {
    t = {newIndex[t[0]], newIndex[t[1]], newIndex[t[2]]};
  }
  sortTriangles(mesh);
}

}  // namespace wcam::io
