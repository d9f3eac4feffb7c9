// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/geometry/geodesic.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/quantity.hpp"

#include "random_source.hpp"
#include "sample_meshes.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace wcam::geometry {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Grid of (rows+1)·(columns+1) vertices at(s, t), s and t in [0,1]; diagonals alternate.
TriangleMesh gridMesh(int rows, int columns, const std::function<Vec3(double, double)>& at) {
  TriangleMesh mesh;
  for (int i = 0; i <= rows; ++i) {
    for (int j = 0; j <= columns; ++j) {
      mesh.vertices.push_back(at(static_cast<double>(i) / rows, static_cast<double>(j) / columns));
    }
  }
  const auto id = [columns](int i, int j) {
    return static_cast<std::uint32_t>(i * (columns + 1) + j);
  };
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      if ((i + j) % 2 == 0) {
        mesh.triangles.push_back({id(i, j), id(i + 1, j), id(i, j + 1)});
        mesh.triangles.push_back({id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)});
      } else {
        mesh.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
        mesh.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
      }
    }
  }
  return mesh;
}

/// The same, closed in the second direction.
TriangleMesh ringMesh(int rows, int around, const std::function<Vec3(double, double)>& at) {
  TriangleMesh mesh;
  for (int i = 0; i <= rows; ++i) {
    for (int j = 0; j < around; ++j) {
      mesh.vertices.push_back(at(static_cast<double>(i) / rows, static_cast<double>(j) / around));
    }
  }
  const auto id = [around](int i, int j) {
    return static_cast<std::uint32_t>(i * around + j % around);
  };
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < around; ++j) {
      const int k = (i + j) % 2;
      mesh.triangles.push_back({id(i, j), id(i + 1, j), id(i + k, j + 1)});
      mesh.triangles.push_back({id(i + 1 - k, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  return mesh;
}

/// Border half-edges whose two ends satisfy a condition.
template <class Holds>
GeodesicSource borderSource(const TriangleMesh& mesh, const HalfEdges& halfEdges, Holds holds) {
  GeodesicSource source;
  for (std::uint32_t h = 0; h < 3 * mesh.triangles.size(); ++h) {
    if (halfEdges.twin(h) == HalfEdges::kNone &&
        holds(mesh.vertices[mesh.triangles[h / 3][h % 3]]) &&
        holds(mesh.vertices[mesh.triangles[h / 3][(h % 3 + 1) % 3]])) {
      source.borderEdges.push_back(h);
    }
  }
  return source;
}

std::vector<double> distances(const TriangleMesh& mesh, const GeodesicSource& source) {
  return GeodesicSolver(mesh, HalfEdges(mesh)).distance(source);
}

struct Deviation {
  double worst = 0.0;
  double mean = 0.0;
};

/// Relative to the true distance, over vertices farther than `from`.
template <class Truth>
Deviation deviation(const TriangleMesh& mesh,
                    const std::vector<double>& distance,
                    const Truth& truth,
                    double from = 1e-9) {
  Deviation result;
  std::size_t count = 0;
  for (std::size_t v = 0; v < distance.size(); ++v) {
    const double expected = truth(mesh.vertices[v]);
    if (expected > from) {
      const double error = std::abs(distance[v] / expected - 1.0);
      result.worst = std::max(result.worst, error);
      result.mean += error;
      ++count;
    }
  }
  result.mean /= static_cast<double>(std::max<std::size_t>(1, count));
  return result;
}

/// Square of size × size squares of 1 mm, its inner vertices moved at random.
TriangleMesh jitteredSquare(testing::RandomSource& random, int size) {
  constexpr double kBy = 0.3;
  return gridMesh(size, size, [&](double s, double t) {
    const bool border = s == 0.0 || s == 1.0 || t == 0.0 || t == 1.0;
    const double by = border ? 0.0 : kBy;
    return Vec3(size * s + random.real(-by, by), size * t + random.real(-by, by), 0.0);
  });
}

TEST(Geodesic, PointOfAPlane) {
  testing::RandomSource random(7);
  SCOPED_TRACE(random.seed());
  const TriangleMesh mesh = jitteredSquare(random, 60);
  const std::uint32_t centre = 23 * 61 + 31;
  const auto truth = [&](const Vec3& p) { return (p - mesh.vertices[centre]).norm(); };
  GeodesicSource source;
  source.vertices = {centre};
  const Deviation vertex = deviation(mesh, distances(mesh, source), truth);
  EXPECT_LT(vertex.worst, 5e-4);
  EXPECT_LT(vertex.mean, 2e-5);
  // A point inside a triangle.
  const MeshPoint inside{3000, {0.5, 0.3, 0.2}};
  const Vec3 p = position(mesh, inside);
  source = {};
  source.points = {inside};
  const Deviation point =
      deviation(mesh, distances(mesh, source), [&](const Vec3& q) { return (p - q).norm(); });
  EXPECT_LT(point.worst, 5e-3);
  EXPECT_LT(point.mean, 2e-4);
}

TEST(Geodesic, LineAndCircleOnAPlane) {
  testing::RandomSource random(8);
  SCOPED_TRACE(random.seed());
  const TriangleMesh mesh = jitteredSquare(random, 40);
  const GeodesicSource line =
      borderSource(mesh, HalfEdges(mesh), [](const Vec3& p) { return p.x() == 0.0; });
  const Deviation straight =
      deviation(mesh, distances(mesh, line), [](const Vec3& p) { return p.x(); });
  EXPECT_LT(straight.worst, 1e-4);
  // An annulus from its inner circle outwards: the front spreads.
  const TriangleMesh annulus = ringMesh(40, 120, [](double s, double t) {
    const double r = 15 + 45 * s;
    return Vec3(r * std::cos(2 * kPi * t), r * std::sin(2 * kPi * t), 0);
  });
  const GeodesicSource circle = borderSource(annulus, HalfEdges(annulus),
                                             [](const Vec3& p) { return p.norm() < 15.0 + 1e-9; });
  EXPECT_EQ(circle.borderEdges.size(), 120U);
  const Deviation round =
      deviation(annulus, distances(annulus, circle), [](const Vec3& p) { return p.norm() - 15.0; });
  EXPECT_LT(round.worst, 2e-3);
  EXPECT_LT(round.mean, 5e-4);
}

TEST(Geodesic, CurveThroughTriangles) {
  // The line x = 9.5 from side to side, cut at the edges that it crosses: no vertex is on it.
  const TriangleMesh mesh =
      gridMesh(20, 20, [](double s, double t) { return Vec3(20 * s, 20 * t, 0); });
  GeodesicSource source;
  source.curves.emplace_back();
  for (std::uint32_t j = 0; j < 20; ++j) {
    const std::uint32_t first = 2 * (9 * 20 + j);
    const bool even = (9 + j) % 2 == 0;
    source.curves[0].push_back({first, {0.5, 0.5, 0.0}});
    source.curves[0].push_back({first, {even ? 0.0 : 0.5, even ? 0.5 : 0.0, 0.5}});
  }
  source.curves[0].push_back({2 * (9 * 20 + 19) + 1, {0.0, 0.5, 0.5}});
  const Deviation result =
      deviation(mesh, distances(mesh, source), [](const Vec3& p) { return std::abs(p.x() - 9.5); });
  EXPECT_LT(result.worst, 5e-3);
  EXPECT_LT(result.mean, 5e-4);
}

TEST(Geodesic, UnrolledCylinder) {
  constexpr double kRadius = 20.0;
  const TriangleMesh mesh = ringMesh(80, 160, [](double s, double t) {
    return Vec3(kRadius * std::cos(2 * kPi * t), kRadius * std::sin(2 * kPi * t), 60 * s);
  });
  GeodesicSource source;
  const std::uint32_t centre = 40 * 160;
  source.vertices = {centre};
  const Deviation result = deviation(mesh, distances(mesh, source), [](const Vec3& p) {
    return std::hypot(kRadius * std::atan2(p.y(), p.x()), p.z() - 30.0);
  });
  EXPECT_LT(result.worst, 3e-3);
  EXPECT_LT(result.mean, 2e-4);
}

TEST(Geodesic, UnrolledCone) {
  // Half angle 30°: unrolled it is a half disc, its apex a corner.
  const TriangleMesh mesh = ringMesh(60, 160, [](double s, double t) {
    const double slant = 10 + 50 * s;
    return Vec3(slant *
                Vec3(0.5 * std::cos(2 * kPi * t), 0.5 * std::sin(2 * kPi * t), std::sqrt(0.75)));
  });
  GeodesicSource source;
  source.vertices = {50 * 160};
  const double slant = mesh.vertices[50 * 160].norm();
  const auto truth = [&](const Vec3& p) {
    const double angle = 0.5 * std::atan2(p.y(), p.x());
    const Vec3 q(p.norm() * std::cos(angle), p.norm() * std::sin(angle), 0.0);
    return (q - Vec3(slant, 0, 0)).norm();
  };
  // Ways over the missing tip would be shorter where the line passes within 10 mm of the apex.
  const std::vector<double> distance = distances(mesh, source);
  double worst = 0.0;
  for (std::size_t v = 0; v < distance.size(); ++v) {
    const Vec3& p = mesh.vertices[v];
    if (std::abs(std::atan2(p.y(), p.x())) < 2.0 && truth(p) > 1e-9) {
      worst = std::max(worst, std::abs(distance[v] / truth(p) - 1.0));
    }
  }
  EXPECT_LT(worst, 3e-3);
}

TEST(Geodesic, HemisphereFromItsEquator) {
  constexpr double kRadius = 50.0;
  for (const int n : {16, 64}) {
    const TriangleMesh mesh = ringMesh(n, 4 * n, [](double s, double t) {
      const double latitude = 0.499 * kPi * s;
      return Vec3(kRadius * std::cos(latitude) * std::cos(2 * kPi * t),
                  kRadius * std::cos(latitude) * std::sin(2 * kPi * t),
                  kRadius * std::sin(latitude));
    });
    const GeodesicSource equator =
        borderSource(mesh, HalfEdges(mesh), [](const Vec3& p) { return p.z() == 0.0; });
    const Deviation result = deviation(mesh, distances(mesh, equator), [](const Vec3& p) {
      return kRadius * std::asin(std::min(1.0, p.z() / kRadius));
    });
    EXPECT_LT(result.worst, n == 16 ? 4e-3 : 1e-3) << n;
    EXPECT_LT(result.mean, n == 16 ? 2e-3 : 2e-4) << n;
  }
}

/// Chalvin AT-10: quarter torus R 50, r 15 (P4), distance from the circle u = 0 along v = 0, where
/// fronts that passed on both sides meet.
double torusError(int along, double u, double expected, std::size_t* triangles = nullptr) {
  const int around = 4 * along / 3;
  const TriangleMesh mesh = ringMesh(along, around, [](double s, double t) {
    const double rho = 50 + 15 * std::cos(2 * kPi * t);
    return Vec3(rho * std::cos(0.5 * kPi * s), rho * std::sin(0.5 * kPi * s),
                15 * std::sin(2 * kPi * t));
  });
  if (triangles != nullptr) {
    *triangles = mesh.triangles.size();
  }
  const GeodesicSource base =
      borderSource(mesh, HalfEdges(mesh), [](const Vec3& p) { return p.y() == 0.0; });
  const auto row = static_cast<std::size_t>(std::lround(u / 90.0 * along));
  return std::abs(distances(mesh, base)[row * static_cast<std::size_t>(around)] / expected - 1.0);
}

TEST(Geodesic, TorusFromItsBaseCircle) {
  for (const auto& [u, expected] :
       {std::pair(45.0, 50.962), std::pair(60.0, 63.616), std::pair(90.0, 83.546)}) {
    SCOPED_TRACE(u);
    std::size_t triangles = 0;
    const double coarse = torusError(84, u, expected, &triangles);
    EXPECT_LE(triangles, 20000U);
    EXPECT_LT(coarse, 2e-3);
    EXPECT_LT(torusError(336, u, expected), 0.5 * coarse + 2e-5);
  }
}

TEST(Geodesic, AgreesWithTheExactSolver) {
  const TriangleMesh mesh = test::torusMesh(50, 20, 60, 150);
  const ExactGeodesics exact(mesh, {77});
  GeodesicSource source;
  source.vertices = {77};
  const std::vector<double> distance = distances(mesh, source);
  double worst = 0.0;
  double mean = 0.0;
  for (std::uint32_t v = 0; v < distance.size(); ++v) {
    if (v != 77) {
      const double error = std::abs(distance[v] / exact.distance(v) - 1.0);
      worst = std::max(worst, error);
      mean += error / static_cast<double>(distance.size());
    }
  }
  EXPECT_LT(mean, 1e-3);
  EXPECT_LT(worst, 1e-2);
}

TEST(Geodesic, WaysBendAroundASlit) {
  // A square with a slit along x = 20 from y = 10 up: distances behind it go around its tip.
  TriangleMesh mesh = gridMesh(40, 40, [](double s, double t) { return Vec3(40 * s, 40 * t, 0); });
  const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
  std::vector<std::uint32_t> copy(count);
  for (std::uint32_t v = 0; v < count; ++v) {
    copy[v] = v;
    if (mesh.vertices[v].x() == 20.0 && mesh.vertices[v].y() > 10.0) {
      copy[v] = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back(mesh.vertices[v]);
    }
  }
  for (auto& t : mesh.triangles) {
    const double x = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]).x() / 3.0;
    for (std::uint32_t& v : t) {
      v = x > 20.0 ? copy[v] : v;
    }
  }
  const Vec3 from(10, 20, 0);
  const Vec3 tip(20, 10, 0);
  GeodesicSource source;
  source.vertices = {10 * 41 + 20};
  ASSERT_EQ(mesh.vertices[source.vertices[0]], from);
  const std::vector<double> distance = distances(mesh, source);
  double worst = 0.0;
  for (std::uint32_t v = 0; v < distance.size(); ++v) {
    const Vec3& p = mesh.vertices[v];
    const bool right = p.x() > 20.0 || v >= count;
    const double crossing = from.y() + (p.y() - from.y()) * (20.0 - from.x()) / (p.x() - from.x());
    const bool shadow = right && crossing > 10.0;
    const double truth = shadow ? (tip - from).norm() + (p - tip).norm() : (p - from).norm();
    if (truth > 0.0) {
      worst = std::max(worst, std::abs(distance[v] / truth - 1.0));
    }
  }
  // A mesh edge is a tenth of the way to the tip.
  EXPECT_LT(worst, 1e-2);
}

TEST(Geodesic, SliversAndObtuseCornersDoNoHarm) {
  // Rows 60 times as dense as columns, sheared: all corners are needles or obtuse.
  const TriangleMesh mesh =
      gridMesh(600, 10, [](double s, double t) { return Vec3(20 * s, 20 * t + 15 * s, 0); });
  GeodesicSource source;
  source.vertices = {300 * 11 + 5};
  const Vec3 from = mesh.vertices[source.vertices[0]];
  const auto truth = [&](const Vec3& p) { return (p - from).norm(); };
  const std::vector<double> distance = distances(mesh, source);
  double worst = 0.0;
  for (std::size_t v = 0; v < distance.size(); ++v) {
    // Where the straight way stays inside the parallelogram.
    if (truth(mesh.vertices[v]) > 0.5) {
      worst = std::max(worst, std::abs(distance[v] / truth(mesh.vertices[v]) - 1.0));
    }
  }
  EXPECT_LT(worst, 2e-2);
}

TEST(Geodesic, OtherComponentsAreInfinitelyFar) {
  TriangleMesh mesh = test::torusMesh(50, 15, 12, 30);
  const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
  const TriangleMesh one = mesh;
  for (const Vec3& p : one.vertices) {
    mesh.vertices.push_back(p + Vec3(0, 0, 100));
  }
  for (const auto& t : one.triangles) {
    mesh.triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
  }
  GeodesicSource source;
  source.vertices = {3};
  const std::vector<double> distance = distances(mesh, source);
  for (std::uint32_t v = 0; v < 2 * count; ++v) {
    EXPECT_EQ(std::isinf(distance[v]), v >= count);
  }
}

TEST(Geodesic, LimitEndsTheSearch) {
  const TriangleMesh mesh = test::torusMesh(50, 15, 40, 100);
  GeodesicSource source;
  source.vertices = {0};
  const HalfEdges halfEdges(mesh);
  const GeodesicSolver solver(mesh, halfEdges);
  const std::vector<double> all = solver.distance(source);
  const std::vector<double> near = solver.distance(source, 40.0);
  for (std::size_t v = 0; v < all.size(); ++v) {
    if (all[v] <= 40.0) {
      EXPECT_NEAR(near[v], all[v], 1e-6);
    } else {
      EXPECT_EQ(near[v], kInfinity);
    }
  }
}

TEST(Geodesic, FollowsMotionScaleAndOrder) {
  testing::RandomSource random(20261122);
  SCOPED_TRACE(random.seed());
  const TriangleMesh mesh = test::torusMesh(50, 20, 40, 100);
  GeodesicSource source;
  source.vertices = {11};
  const std::vector<double> expected = distances(mesh, source);
  TriangleMesh moved = mesh;
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized()));
  for (Vec3& p : moved.vertices) {
    p = 0.01 * (turn * p) + Vec3(300, -20, 7);
  }
  const std::vector<double> scaled = distances(moved, source);
  TriangleMesh mixed = mesh;
  for (std::size_t i = mixed.triangles.size(); i > 1; --i) {
    std::swap(mixed.triangles[i - 1], mixed.triangles[random.below(i)]);
  }
  const std::vector<double> other = distances(mixed, source);
  for (std::size_t v = 0; v < expected.size(); ++v) {
    EXPECT_NEAR(100.0 * scaled[v], expected[v], 1e-3 * expected[v] + 1e-9);
    EXPECT_NEAR(other[v], expected[v], 1e-3 * expected[v] + 1e-9);
  }
}

TEST(Geodesic, RefusesSourcesOffTheMesh) {
  const TriangleMesh mesh = test::torusMesh(50, 15, 12, 30);
  const HalfEdges halfEdges(mesh);
  const GeodesicSolver solver(mesh, halfEdges);
  EXPECT_THROW((void)solver.distance({}), Error);
  GeodesicSource source;
  source.vertices = {100000};
  EXPECT_THROW((void)solver.distance(source), Error);
  source = {};
  source.points = {{0, {0.5, 0.6, 0.7}}};
  EXPECT_THROW((void)solver.distance(source), Error);
  source = {};
  source.points = {{99999, {1, 0, 0}}};
  EXPECT_THROW((void)solver.distance(source), Error);
  source = {};
  source.borderEdges = {99999};
  EXPECT_THROW((void)solver.distance(source), Error);
  source = {};
  source.curves = {{{0, {0.4, 0.3, 0.3}}, {200, {0.4, 0.3, 0.3}}}};
  EXPECT_THROW((void)solver.distance(source), Error);
}

double lengthOf(const TriangleMesh& mesh, const std::vector<MeshPoint>& path) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    length += (position(mesh, path[i]) - position(mesh, path[i - 1])).norm();
  }
  return length;
}

void expectDescending(const TriangleMesh& mesh,
                      const std::vector<double>& field,
                      const std::vector<MeshPoint>& path) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    ASSERT_LE(valueAt(mesh, field, path[i]), valueAt(mesh, field, path[i - 1]) + 1e-9);
  }
}

TEST(GeodesicPath, StraightOnPlaneAndCylinder) {
  testing::RandomSource random(9);
  SCOPED_TRACE(random.seed());
  const TriangleMesh plane = jitteredSquare(random, 60);
  const TriangleMesh cylinder = ringMesh(60, 120, [](double s, double t) {
    return Vec3(20 * std::cos(2 * kPi * t), 20 * std::sin(2 * kPi * t), 60 * s);
  });
  for (const TriangleMesh* mesh : {&plane, &cylinder}) {
    const HalfEdges halfEdges(*mesh);
    GeodesicSource source;
    const auto centre = static_cast<std::uint32_t>(mesh->vertices.size() / 2);
    source.vertices = {centre};
    const std::vector<double> field = GeodesicSolver(*mesh, halfEdges).distance(source);
    for (int i = 0; i < 200; ++i) {
      const auto t = static_cast<std::uint32_t>(random.below(mesh->triangles.size()));
      const MeshPoint from{t, {0.2, 0.5, 0.3}};
      const std::vector<MeshPoint> path = descend(*mesh, halfEdges, field, from);
      expectDescending(*mesh, field, path);
      EXPECT_LT((position(*mesh, path.back()) - mesh->vertices[centre]).norm(), 1e-9);
      EXPECT_NEAR(lengthOf(*mesh, path), valueAt(*mesh, field, from),
                  0.01 * valueAt(*mesh, field, from) + 0.2);
    }
  }
}

TEST(GeodesicPath, MeridiansOfASphereEndOnTheEquator) {
  const TriangleMesh mesh = ringMesh(60, 160, [](double s, double t) {
    const double latitude = 0.45 * kPi * s;
    return Vec3(50.0 * Vec3(std::cos(latitude) * std::cos(2 * kPi * t),
                            std::cos(latitude) * std::sin(2 * kPi * t), std::sin(latitude)));
  });
  const HalfEdges halfEdges(mesh);
  const GeodesicSource equator =
      borderSource(mesh, halfEdges, [](const Vec3& p) { return p.z() == 0.0; });
  const std::vector<double> field = GeodesicSolver(mesh, halfEdges).distance(equator);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); t += 53) {
    const MeshPoint from{t, {0.3, 0.3, 0.4}};
    const std::vector<MeshPoint> path = descend(mesh, halfEdges, field, from);
    expectDescending(mesh, field, path);
    const Vec3 start = position(mesh, from);
    const Vec3 end = position(mesh, path.back());
    EXPECT_NEAR(end.z(), 0.0, 1e-9);
    EXPECT_LT(Vec3(start.x(), start.y(), 0).normalized().cross(end.normalized()).norm(), 0.02);
    EXPECT_NEAR(lengthOf(mesh, path), valueAt(mesh, field, from), 0.02);
  }
}

TEST(GeodesicPath, EndsOnAnyField) {
  testing::RandomSource random(10);
  SCOPED_TRACE(random.seed());
  const TriangleMesh mesh = test::torusMesh(50, 15, 20, 50);
  const HalfEdges halfEdges(mesh);
  for (int run = 0; run < 50; ++run) {
    std::vector<double> field(mesh.vertices.size());
    for (double& value : field) {
      const double r = random.real(0.0, 1.0);
      value = r < 0.02 ? kInfinity : (r < 0.3 ? 0.5 : r);
    }
    const auto t = static_cast<std::uint32_t>(random.below(mesh.triangles.size()));
    const std::vector<MeshPoint> path = descend(mesh, halfEdges, field, {t, {0.2, 0.2, 0.6}});
    EXPECT_LT(path.size(), 1000U);
    for (const MeshPoint& point : path) {
      EXPECT_NEAR(point.weights[0] + point.weights[1] + point.weights[2], 1.0, 1e-9);
    }
  }
}

TEST(TriangleGradients, OfALinearFieldAndOfNothing) {
  TriangleMesh mesh = test::torusMesh(50, 15, 20, 50);
  const Vec3 slope(0.3, -2.0, 1.1);
  std::vector<double> field;
  for (const Vec3& p : mesh.vertices) {
    field.push_back(slope.dot(p));
  }
  const std::vector<Vec3> gradients = triangleGradients(mesh, field);
  for (std::size_t t = 0; t < gradients.size(); ++t) {
    const Vec3 n = mesh.normal(t);
    EXPECT_LT((gradients[t] - (slope - slope.dot(n) * n)).norm(), 1e-9);
  }
  mesh.triangles.push_back({0, 0, 1});
  field[5] = std::nan("");
  const std::vector<Vec3> holes = triangleGradients(mesh, field);
  EXPECT_EQ(holes.back(), Vec3::Zero());
  for (std::size_t t = 0; t + 1 < holes.size(); ++t) {
    const auto& corners = mesh.triangles[t];
    EXPECT_EQ(holes[t].hasNaN(), std::count(corners.begin(), corners.end(), 5U) > 0);
  }
}

}  // namespace
}  // namespace wcam::geometry
