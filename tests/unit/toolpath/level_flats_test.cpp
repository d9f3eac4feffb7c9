// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "random_source.hpp"
#include "sample_meshes.hpp"
#include "slicing_fixture.hpp"
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>

/// Faces that lie on a layer up to rounding or noise: one closed contour of the section's length.
namespace wcam::toolpath {
namespace {

using geometry::Vec3;
using wcam::testing::RandomSource;
using wcam::testing::testSeeds;

plugin::SliceInput inputOf(const std::shared_ptr<const geometry::PartSurface>& part) {
  return {{part}, test::plate(), nullptr, {0.001, 4.9}};
}

std::shared_ptr<const geometry::PartSurface> trial(const std::string& file, double degreesAboutY) {
  geometry::Pose pose = geometry::Pose::Identity();
  pose.rotate(Eigen::AngleAxisd(degToRad(degreesAboutY), Vec3::UnitY()));
  return io::importPart(std::string(WCAM_TEST_DATA) + "/trials/" + file, io::ImportOptions{}, pose,
                        JobContext())
      .surface;
}

double lengthOf(const Contour& contour) {
  double length = 0.0;
  const std::size_t n = contour.points.size();
  for (std::size_t i = 0; i + (contour.closed ? 0 : 1) < n; ++i) {
    length += (contour.points[(i + 1) % n].p - contour.points[i].p).norm();
  }
  return length;
}

/// The layer at a level has one closed contour of this length.
void expectOne(const SlicedLayers& sliced, double level, double length, double tolerance) {
  std::size_t found = 0;
  for (const SlicedLayer& layer : sliced.layers) {
    if (std::abs(layer.level - level) > 1e-6) {
      continue;
    }
    ++found;
    ASSERT_EQ(layer.contours.size(), 1U) << "at " << level;
    EXPECT_TRUE(layer.contours[0].closed) << "at " << level;
    EXPECT_NEAR(lengthOf(layer.contours[0]), length, tolerance) << "at " << level;
    for (const ContourPoint& point : layer.contours[0].points) {
      EXPECT_NEAR(point.p.z(), level, 4e-3);
    }
  }
  EXPECT_EQ(found, 1U) << "at " << level;
}

SlicedLayers planar(const std::shared_ptr<const geometry::PartSurface>& part, double step = 2.0) {
  return test::slice("wcam.slicing.planar", inputOf(part),
                     R"({"step": )" + std::to_string(step) + "}");
}

TEST(FlatFaces, BoxThatWasTurnedBackHasItsTopLayer) {
  const SlicedLayers sliced = planar(trial("box_rot30.stl", -30.0));
  const double top = sliced.layers.back().level;
  expectOne(sliced, top, 160.0, 0.01);
  for (const SlicedLayer& layer : sliced.layers) {
    expectOne(sliced, layer.level, 160.0, 0.01);
  }
}

TEST(FlatFaces, LedgesOfTurnedAndNoisyPartsAreOneContour) {
  for (const auto& part :
       {trial("stepped_flats_rot30.stl", -30.0), trial("stepped_flats_wobble.stl", 0.0)}) {
    const SlicedLayers sliced = planar(part);
    std::vector<double> lengths;
    for (const SlicedLayer& layer : sliced.layers) {
      ASSERT_EQ(layer.contours.size(), 1U) << layer.level;
      EXPECT_TRUE(layer.contours[0].closed);
      const double length = lengthOf(layer.contours[0]);
      if (lengths.empty() || std::abs(length - lengths.back()) > 1.0) {
        lengths.push_back(length);
      }
    }
    ASSERT_EQ(lengths.size(), 3U);
    EXPECT_NEAR(lengths[0], 251.23, 0.02);
    EXPECT_NEAR(lengths[1], 314.03, 0.02);
    EXPECT_NEAR(lengths[2], 251.23, 0.02);
  }
}

TEST(FlatFaces, NoisyTopOfACylinderIsOneContour) {
  for (const char* file : {"top_wobble_0.obj", "top_wobble_2.obj", "top_wobble_4.obj"}) {
    SCOPED_TRACE(file);
    const SlicedLayers sliced = planar(trial(file, 0.0));
    ASSERT_EQ(sliced.layers.size(), 20U);
    // 64 corners; 188.40 mm with the default chord error.
    expectOne(sliced, 40.0, 128.0 * 30.0 * std::sin(kPi / 64.0), 0.005);
  }
}

/// A prism of n corners whose radius steps at each height, closed, with a ring of triangles and a
/// middle vertex on every level face.
geometry::TriangleMesh steppedPrism(int corners,
                                    const std::vector<std::array<double, 2>>& radiusFrom) {
  geometry::TriangleMesh mesh;
  const auto ring = [&](double radius, double z) {
    for (int i = 0; i < corners; ++i) {
      const double a = 2.0 * kPi * i / corners;
      mesh.vertices.emplace_back(radius * std::cos(a), radius * std::sin(a), z);
    }
  };
  const auto n = static_cast<std::uint32_t>(corners);
  const auto join = [&](std::uint32_t low, std::uint32_t high) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t j = (i + 1) % n;
      mesh.triangles.push_back({low + i, low + j, high + j});
      mesh.triangles.push_back({low + i, high + j, high + i});
    }
  };
  for (std::size_t k = 0; k + 1 < radiusFrom.size(); ++k) {
    ring(radiusFrom[k][0], radiusFrom[k][1]);
    ring(radiusFrom[k][0], radiusFrom[k + 1][1]);
  }
  const auto rings = static_cast<std::uint32_t>(mesh.vertices.size()) / n;
  for (std::uint32_t k = 0; k + 1 < rings; ++k) {
    join(k * n, (k + 1) * n);
  }
  const auto low = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.emplace_back(0.0, 0.0, radiusFrom.front()[1]);
  mesh.vertices.emplace_back(0.0, 0.0, radiusFrom.back()[1]);
  for (std::uint32_t i = 0; i < n; ++i) {
    mesh.triangles.push_back({low, (i + 1) % n, i});
    mesh.triangles.push_back({low + 1, (rings - 1) * n + i, (rings - 1) * n + (i + 1) % n});
  }
  return mesh;
}

/// Noise that a file or a program leaves: turned away and back in single precision, and shaken.
void disturb(geometry::TriangleMesh& mesh, RandomSource& random, double noise) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(
      random.real(0.0, 2.0 * kPi),
      Vec3(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)).normalized()));
  for (Vec3& p : mesh.vertices) {
    p += Vec3(random.real(-noise, noise), random.real(-noise, noise), random.real(-noise, noise));
    const Eigen::Vector3f stored = (turn * p).cast<float>();
    p = turn.inverse() * stored.cast<double>();
  }
}

TEST(FlatFaces, AnyNoiseAndAnyTurnLeaveOneContourPerLayer) {
  for (const std::uint64_t seed : testSeeds(150)) {
    SCOPED_TRACE(seed);
    RandomSource random(seed);
    const int corners = static_cast<int>(4 + random.below(90));
    const double scale = random.real(0.4, 3.0);
    const double step = 2.0;
    // Radii and heights, the heights on levels.
    const std::vector<std::array<double, 2>> shape{{20.0 * scale, 0.0},
                                                   {25.0 * scale, 8.0},
                                                   {14.0 * scale, 14.0},
                                                   {18.0 * scale, 20.0},
                                                   {0.0, 30.0}};
    geometry::TriangleMesh mesh = steppedPrism(corners, shape);
    disturb(mesh, random, random.chance(0.2) ? 0.0 : std::pow(10.0, random.real(-9.0, -3.0)));
    const SlicedLayers sliced = planar(test::meshSurface(std::move(mesh)), step);
    ASSERT_EQ(sliced.layers.size(), 15U);
    for (const SlicedLayer& layer : sliced.layers) {
      double radius = shape[0][0];
      for (std::size_t k = 1; k + 1 < shape.size(); ++k) {
        // On a ledge the section just below counts.
        radius = layer.level > shape[k][1] + 1.0 ? shape[k][0] : radius;
      }
      expectOne(sliced, layer.level, 2.0 * corners * radius * std::sin(kPi / corners),
                0.02 + 1e-4 * radius);
    }
  }
}

/// The surface of cells of 5 mm, with noise on every vertex.
geometry::TriangleMesh cellMesh(const std::function<bool(int, int, int)>& full,
                                const std::array<int, 3>& size,
                                double noise,
                                RandomSource& random) {
  geometry::TriangleMesh mesh;
  std::map<std::array<int, 3>, std::uint32_t> vertices;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [it, fresh] =
        vertices.try_emplace(at, static_cast<std::uint32_t>(mesh.vertices.size()));
    if (fresh) {
      Vec3 p(5.0 * at[0], 5.0 * at[1], 5.0 * at[2]);
      for (double& x : p) {
        x += random.real(-noise, noise);
      }
      mesh.vertices.push_back(p);
    }
    return it->second;
  };
  const auto inside = [&](const std::array<int, 3>& c) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (c[k] < 0 || c[k] >= size[k]) {
        return false;
      }
    }
    return full(c[0], c[1], c[2]);
  };
  for (int x = 0; x < size[0]; ++x) {
    for (int y = 0; y < size[1]; ++y) {
      for (int z = 0; z < size[2]; ++z) {
        const std::array<int, 3> cell{x, y, z};
        for (std::size_t axis = 0; axis < 3 && inside(cell); ++axis) {
          for (const int side : {0, 1}) {
            std::array<int, 3> beyond = cell;
            beyond[axis] += side == 1 ? 1 : -1;
            if (inside(beyond)) {
              continue;
            }
            std::array<std::array<int, 3>, 4> corner;
            corner.fill(cell);
            const std::size_t u = (axis + (side == 1 ? 1 : 2)) % 3;
            const std::size_t v = (axis + (side == 1 ? 2 : 1)) % 3;
            for (auto& c : corner) {
              c[axis] += side;
            }
            ++corner[1][u];
            ++corner[2][u];
            ++corner[2][v];
            ++corner[3][v];
            mesh.triangles.push_back({vertex(corner[0]), vertex(corner[1]), vertex(corner[2])});
            mesh.triangles.push_back({vertex(corner[0]), vertex(corner[2]), vertex(corner[3])});
          }
        }
      }
    }
  }
  return mesh;
}

TEST(FlatFaces, LegsFlushWithTheSidesOfATableKeepTheirCorners) {
  // Legs of 10 x 10 mm whose outer sides go on into the table's sides, below its underside.
  const auto full = [](int x, int y, int z) {
    return z >= 4 || ((x < 2 || x >= 10) && (y < 2 || y >= 6));
  };
  for (const std::uint64_t seed : testSeeds(20)) {
    RandomSource random(seed);
    for (const double noise : {0.0, 1e-6, 1e-5, 1e-4, 1e-3}) {
      const auto table = test::meshSurface(cellMesh(full, {12, 8, 5}, noise, random));
      const SlicedLayers sliced = planar(table, 2.5);
      for (const SlicedLayer& layer : sliced.layers) {
        if (layer.level > 20.1) {
          continue;
        }
        ASSERT_EQ(layer.contours.size(), 4U) << layer.level << " seed " << seed << " " << noise;
        for (const Contour& contour : layer.contours) {
          EXPECT_NEAR(lengthOf(contour), 40.0, 0.02)
              << layer.level << " seed " << seed << " " << noise;
        }
      }
    }
  }
}

TEST(FlatFaces, NoisyBaseIsItsOwnLayer) {
  for (const std::uint64_t seed : testSeeds(30)) {
    SCOPED_TRACE(seed);
    RandomSource random(seed);
    geometry::TriangleMesh mesh = steppedPrism(40, {{20.0, 0.0}, {25.0, 8.0}, {0.0, 14.0}});
    disturb(mesh, random, 1e-3);
    const SlicedLayers sliced =
        test::slice("wcam.slicing.planar", inputOf(test::meshSurface(std::move(mesh))),
                    R"({"step": 2.0, "first_layer": 0})");
    ASSERT_EQ(sliced.layers.size(), 8U);
    expectOne(sliced, 0.0, 80.0 * 20.0 * std::sin(kPi / 40.0), 0.02);
  }
}

TEST(FlatFaces, DomesAndSlopesKeepTheirContours) {
  // A sphere's cap about a level is a slope, not a face: its circle has the true radius.
  geometry::TriangleMesh dome;
  constexpr int kRows = 400;
  constexpr int kAround = 90;
  const double radius = 40.0;
  for (int i = 0; i < kRows; ++i) {
    const double v = 0.5 * kPi * i / kRows;
    for (int j = 0; j < kAround; ++j) {
      const double u = 2.0 * kPi * j / kAround;
      dome.vertices.emplace_back(radius * std::cos(v) * std::cos(u),
                                 radius * std::cos(v) * std::sin(u), radius * std::sin(v));
    }
  }
  dome.vertices.emplace_back(0.0, 0.0, radius);
  const auto index = [](int i, int j) {
    return static_cast<std::uint32_t>(i * kAround + j % kAround);
  };
  for (int i = 0; i + 1 < kRows; ++i) {
    for (int j = 0; j < kAround; ++j) {
      dome.triangles.push_back({index(i, j), index(i, j + 1), index(i + 1, j + 1)});
      dome.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i + 1, j)});
    }
  }
  for (int j = 0; j < kAround; ++j) {
    dome.triangles.push_back({index(kRows - 1, j), index(kRows - 1, j + 1),
                              static_cast<std::uint32_t>(dome.vertices.size() - 1)});
  }
  const auto part = test::meshSurface(std::move(dome));
  const double level = radius - 0.004;
  const SlicedLayers sliced = planar(part, level);
  ASSERT_EQ(sliced.layers.size(), 1U);
  ASSERT_EQ(sliced.layers[0].contours.size(), 1U);
  for (const ContourPoint& point : sliced.layers[0].contours[0].points) {
    EXPECT_NEAR(point.p.z(), level, 1e-9);
    EXPECT_NEAR(std::hypot(point.p.x(), point.p.y()), std::sqrt(radius * radius - level * level),
                0.03);
  }
  // The pole itself is no layer.
  EXPECT_EQ(planar(part, 20.0).layers.size(), 1U);
}

TEST(FlatFaces, EveryStrategyDecidesInTheSameWay) {
  RandomSource random(7);
  geometry::TriangleMesh mesh = test::boxMesh({-20, -15, 0}, {20, 15, 20});
  disturb(mesh, random, 1e-3);
  const auto part = test::meshSurface(std::move(mesh));
  const SlicedLayers bulk =
      test::slice("wcam.slicing.bulk", inputOf(part), R"({"step": 2.0, "pattern": "none"})");
  EXPECT_EQ(bulk.layers.size(), 10U);
  for (const SlicedLayer& layer : bulk.layers) {
    for (const Contour& contour : layer.contours) {
      EXPECT_TRUE(contour.closed);
    }
  }
  // A flange on a shaft: the outer border of a flat ring is a cylinder's level up to noise.
  geometry::TriangleMesh ring = test::tubeMesh(1.0, 1.0, 720, 10);
  for (Vec3& p : ring.vertices) {
    const double angle = std::atan2(p.y(), p.x());
    const double radius = 20.0 + p.z() * 30.0 + random.real(-1e-3, 1e-3);
    p = Vec3(radius * std::cos(angle), radius * std::sin(angle), 7.0);
  }
  const SlicedLayers radial =
      test::slice("wcam.slicing.radial", inputOf(test::meshSurface(std::move(ring))),
                  R"({"step": 2.0, "start": 20.0})");
  ASSERT_EQ(radial.layers.size(), 15U);
  ASSERT_EQ(radial.layers.back().contours.size(), 1U);
  EXPECT_TRUE(radial.layers.back().contours[0].closed);
  EXPECT_NEAR(lengthOf(radial.layers.back().contours[0]), 2.0 * kPi * 50.0, 0.1);
}

}  // namespace
}  // namespace wcam::toolpath
