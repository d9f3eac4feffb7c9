// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/geometry/mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

namespace wcam::test {

using Implicit = std::function<double(const geometry::Vec3&)>;

/// Surface {f = 0} inside a box by marching tetrahedra: outward (towards f > 0) triangles, open
/// where it leaves the box. `cells` along each axis.
inline geometry::TriangleMesh implicitMesh(const Implicit& f,
                                           const geometry::Box& box,
                                           const std::array<int, 3>& cells) {
  using geometry::Vec3;
  const std::array<int, 3> n{cells[0] + 1, cells[1] + 1, cells[2] + 1};
  const auto index = [&](int i, int j, int k) {
    return static_cast<std::uint32_t>((k * n[1] + j) * n[0] + i);
  };
  std::vector<Vec3> places;
  std::vector<double> values;
  for (int k = 0; k < n[2]; ++k) {
    for (int j = 0; j < n[1]; ++j) {
      for (int i = 0; i < n[0]; ++i) {
        const Vec3 fraction(static_cast<double>(i) / cells[0], static_cast<double>(j) / cells[1],
                            static_cast<double>(k) / cells[2]);
        places.push_back(box.min + fraction.cwiseProduct(box.max - box.min));
        values.push_back(f(places.back()));
      }
    }
  }
  geometry::TriangleMesh mesh;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> cut;
  const auto vertex = [&](std::uint32_t a, std::uint32_t b) {
    const auto key = std::minmax(a, b);
    const auto [it, made] = cut.try_emplace({key.first, key.second}, 0U);
    if (made) {
      // Kept off the corners of the grid, so that no triangle vanishes.
      const double va = values[key.first];
      const double vb = values[key.second];
      const double w = std::clamp(va / (va - vb), 0.05, 0.95);
      it->second = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back((1.0 - w) * places[key.first] + w * places[key.second]);
    }
    return it->second;
  };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, const Vec3& inside) {
    const Vec3& pa = mesh.vertices[a];
    const Vec3 normal = (mesh.vertices[b] - pa).cross(mesh.vertices[c] - pa);
    if (normal.dot(pa - inside) >= 0.0) {
      mesh.triangles.push_back({a, b, c});
    } else {
      mesh.triangles.push_back({a, c, b});
    }
  };
  const auto tetrahedron = [&](const std::array<std::uint32_t, 4>& v) {
    std::vector<std::uint32_t> in, out;
    for (const std::uint32_t c : v) {
      (values[c] < 0.0 ? in : out).push_back(c);
    }
    if (in.size() == 1) {
      add(vertex(in[0], out[0]), vertex(in[0], out[1]), vertex(in[0], out[2]), places[in[0]]);
    } else if (in.size() == 3) {
      // The centre of the three inner corners lies on their side of the cut.
      const Vec3 inside = (places[in[0]] + places[in[1]] + places[in[2]]) / 3.0;
      add(vertex(in[0], out[0]), vertex(in[1], out[0]), vertex(in[2], out[0]), inside);
    } else if (in.size() == 2) {
      const std::array<std::uint32_t, 4> q{vertex(in[0], out[0]), vertex(in[0], out[1]),
                                           vertex(in[1], out[1]), vertex(in[1], out[0])};
      const Vec3 inside = 0.5 * (places[in[0]] + places[in[1]]);
      add(q[0], q[1], q[2], inside);
      add(q[0], q[2], q[3], inside);
    }
  };
  constexpr std::array<std::array<int, 2>, 6> kPaths{
      {{1, 3}, {1, 5}, {2, 3}, {2, 6}, {4, 5}, {4, 6}}};
  for (int k = 0; k < cells[2]; ++k) {
    for (int j = 0; j < cells[1]; ++j) {
      for (int i = 0; i < cells[0]; ++i) {
        const auto corner = [&](int bits) {
          return index(i + (bits & 1), j + (bits >> 1 & 1), k + (bits >> 2 & 1));
        };
        for (const auto& path : kPaths) {
          tetrahedron({corner(0), corner(path[0]), corner(path[1]), corner(7)});
        }
      }
    }
  }
  return mesh;
}

/// Distance to a segment.
inline double segmentDistance(const geometry::Vec3& p,
                              const geometry::Vec3& a,
                              const geometry::Vec3& b) {
  const double w = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - w * (b - a)).norm();
}

/// A tube that parts into two: a stem up to z = 40 and two arms to z = 90, open at z = 0 and z = 90
/// (`down` turns it over: two legs that join). Smoothly blended.
inline geometry::TriangleMesh forkMesh(int cells, bool down = false) {
  using geometry::Vec3;
  const auto f = [down](const Vec3& q) {
    const Vec3 p(q.x(), q.y(), down ? 90.0 - q.z() : q.z());
    const double blend = 3.0;
    double sum = 0.0;
    for (const auto& [a, b] : {std::pair<Vec3, Vec3>{{0, 0, -30}, {0, 0, 40}},
                               std::pair<Vec3, Vec3>{{0, 0, 40}, {30, 0, 100}},
                               std::pair<Vec3, Vec3>{{0, 0, 40}, {-30, 0, 100}}}) {
      sum += std::exp(-(segmentDistance(p, a, b) - 10.0) / blend);
    }
    return -blend * std::log(sum);
  };
  geometry::Box box;
  box.add(Vec3(-48, -18, 0));
  box.add(Vec3(48, 18, 90));
  return implicitMesh(f, box, {96 * cells / 90, 36 * cells / 90, cells});
}

}  // namespace wcam::test
