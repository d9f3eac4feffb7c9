// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/geometry/mesh.hpp"

#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace wcam::test {

/// A folder of its own that goes away with the object.
class TemporaryFolder {
public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "wcam-io-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }

  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
    return path_ / name;
  }

private:
  std::filesystem::path path_;
};

inline void writeBytes(const std::filesystem::path& file, std::string_view bytes) {
  std::ofstream stream(file, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

inline std::string readBytes(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// A binary STL file; `declared` replaces the triangle count of the header.
inline std::string binaryStl(const geometry::TriangleMesh& mesh, std::int64_t declared = -1) {
  std::string bytes(84 + 50 * mesh.triangles.size(), '\0');
  const auto count = static_cast<std::uint32_t>(
      declared >= 0 ? declared : static_cast<std::int64_t>(mesh.triangles.size()));
  std::memcpy(bytes.data() + 80, &count, 4);
  char* facet = bytes.data() + 84;
  for (const auto& t : mesh.triangles) {
    float* out = nullptr;
    float xyz[9];
    out = xyz;
    for (const std::uint32_t v : t) {
      for (int k = 0; k < 3; ++k) {
        *out++ = static_cast<float>(mesh.vertices[v][k]);
      }
    }
    std::memcpy(facet + 12, xyz, sizeof(xyz));
    facet += 50;
  }
  return bytes;
}

/// Torus about Z of 2·n·m triangles, outward.
inline geometry::TriangleMesh torusMesh(std::uint32_t n,
                                        std::uint32_t m,
                                        double big,
                                        double small) {
  geometry::TriangleMesh mesh;
  const double tau = 6.283185307179586;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < m; ++j) {
      const double u = tau * i / n;
      const double v = tau * j / m;
      const double w = big + small * std::cos(v);
      mesh.vertices.emplace_back(w * std::cos(u), w * std::sin(u), small * std::sin(v));
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < m; ++j) {
      const std::uint32_t a = i * m + j;
      const std::uint32_t b = (i + 1) % n * m + j;
      const std::uint32_t c = (i + 1) % n * m + (j + 1) % m;
      const std::uint32_t d = i * m + (j + 1) % m;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

/// Axis-aligned box of 12 triangles, outward.
inline geometry::TriangleMesh boxMesh(const geometry::Vec3& low, const geometry::Vec3& high) {
  geometry::TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back((i & 1) != 0 ? high.x() : low.x(), (i & 2) != 0 ? high.y() : low.y(),
                               (i & 4) != 0 ? high.z() : low.z());
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// Appends b to a.
inline void append(geometry::TriangleMesh& a, const geometry::TriangleMesh& b) {
  const auto base = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& t : b.triangles) {
    a.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
}

inline double signedVolume(const geometry::TriangleMesh& mesh) {
  double volume = 0.0;
  for (const auto& t : mesh.triangles) {
    volume += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6.0;
  }
  return volume;
}

}  // namespace wcam::test
