// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Binary STL file to welded indexed mesh: own reader against vtkSTLReader with merging, on a torus
// of a million triangles. Numbers of vertices and triangles must agree.

#include "file_bytes.hpp"
#include "stl_parser.hpp"
#include "timing.hpp"
#include "vtk_stl.hpp"
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

constexpr std::uint32_t kAround = 1000;
constexpr std::uint32_t kAcross = 500;
constexpr int kRepetitions = 7;
constexpr double kGoal = 3.0;

std::array<float, 3> torusPoint(std::uint32_t i, std::uint32_t j) {
  const double tau = 6.283185307179586;
  const double u = tau * (i % kAround) / kAround;
  const double v = tau * (j % kAcross) / kAcross;
  const double w = 50.0 + 15.0 * std::cos(v);
  return {static_cast<float>(w * std::cos(u)), static_cast<float>(w * std::sin(u)),
          static_cast<float>(15.0 * std::sin(v))};
}

void writeTorus(const std::filesystem::path& file) {
  const std::uint32_t count = 2 * kAround * kAcross;
  std::string bytes(84 + std::size_t{50} * count, '\0');
  std::memcpy(bytes.data() + 80, &count, 4);
  char* facet = bytes.data() + 84;
  const auto put = [&facet](const std::array<std::array<float, 3>, 3>& corners) {
    std::memcpy(facet + 12, corners.data(), sizeof(corners));
    facet += 50;
  };
  for (std::uint32_t i = 0; i < kAround; ++i) {
    for (std::uint32_t j = 0; j < kAcross; ++j) {
      put({torusPoint(i, j), torusPoint(i + 1, j), torusPoint(i + 1, j + 1)});
      put({torusPoint(i, j), torusPoint(i + 1, j + 1), torusPoint(i, j + 1)});
    }
  }
  std::ofstream(file, std::ios::binary)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

wcam::io::ParsedMesh readOwn(const std::filesystem::path& file) {
  const wcam::JobContext context;
  const wcam::io::FileBytes bytes(file, context);
  return wcam::io::parseStl(bytes.view(), file.string(), context);
}

}  // namespace

int main() {
  const auto file =
      std::filesystem::temp_directory_path() / ("wcam-bench-" + std::to_string(getpid()) + ".stl");
  writeTorus(file);
  wcam::bench::Times own;
  wcam::bench::Times vtk;
  bool agree = true;
  for (int k = 0; k < kRepetitions; ++k) {
    const auto parsed = own.measure([&] { return readOwn(file); });
    const auto counts = vtk.measure([&] { return wcam::bench::readWithVtk(file.string()); });
    agree = agree && parsed.mesh.vertices.size() == counts.points &&
            parsed.mesh.triangles.size() == counts.triangles;
  }
  std::filesystem::remove(file);
  const double ratio = vtk.median() / own.median();
  std::printf("STL of 1 million triangles   min s    median s   first s\n");
  std::printf("  wcam                       %.4f   %.4f     %.4f\n", own.min(), own.median(),
              own.first());
  std::printf("  vtkSTLReader (merging)     %.4f   %.4f     %.4f\n", vtk.min(), vtk.median(),
              vtk.first());
  std::printf("  ratio %.1f (goal %.0f), counts %s\n", ratio, kGoal, agree ? "agree" : "DISAGREE");
  return agree ? 0 : 1;
}
