// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/geometry/geodesic.hpp"
#include "wcam/geometry/linear_elements.hpp"

#include "../../support/error_matchers.hpp"
#include "../../support/field_meshes.hpp"
#include "../../support/random_source.hpp"

#include <algorithm>
#include <cmath>

namespace {

using namespace wcam;
using namespace wcam::geometry;
using wcam::testing::errorOf;

TriangleMesh hemisphere(double R, int around, int rows) {
  std::vector<Vec2> profile;
  for (int i = 0; i <= rows; ++i) {
    const double a = 0.5 * kPi * i / rows;
    profile.emplace_back(i == rows ? 0.0 : R * std::cos(a), R * std::sin(a));
  }
  return test::revolvedMesh(profile, around);
}

double hemisphereError(double R, int around, int rows, bool* poleIsFarthest = nullptr) {
  const TriangleMesh mesh = hemisphere(R, around, rows);
  const std::vector<double> phi =
      HeatSolver(mesh, HalfEdges(mesh)).distance(test::borderAt(mesh, true));
  double error = 0.0;
  for (std::size_t v = 0; v < phi.size(); ++v) {
    const double exact = R * std::asin(std::min(1.0, mesh.vertices[v].z() / R));
    error = std::max(error, std::abs(phi[v] - exact));
  }
  if (poleIsFarthest != nullptr) {
    *poleIsFarthest = std::max_element(phi.begin(), phi.end()) == phi.end() - 1;
  }
  return error / (0.5 * kPi * R);
}

TEST(Heat, HemisphereFromTheEquator) {  // Diourté A10
  EXPECT_EQ(hemisphere(50.0, 30, 10).triangles.size(), 570U);
  bool poleIsFarthest = false;
  const double coarse = hemisphereError(50.0, 30, 10, &poleIsFarthest);
  const double middle = hemisphereError(50.0, 60, 20);
  const double fine = hemisphereError(50.0, 120, 40);
  EXPECT_NEAR(coarse, 0.0037, 1e-4);
  EXPECT_LT(middle, coarse);
  EXPECT_LT(fine, middle);
  EXPECT_TRUE(poleIsFarthest);
}

TEST(Heat, ConeAndCappedCylinder) {  // Diourté A11
  std::vector<Vec2> cone;
  for (int i = 0; i <= 20; ++i) {
    cone.emplace_back(30.0 * (20 - i) / 20, 40.0 * i / 20);
  }
  const TriangleMesh mesh = test::revolvedMesh(cone, 48);
  const std::vector<double> phi =
      HeatSolver(mesh, HalfEdges(mesh)).distance(test::borderAt(mesh, true));
  EXPECT_NEAR(phi.back(), 50.0, 0.1);
  EXPECT_EQ(std::max_element(phi.begin(), phi.end()), phi.end() - 1);

  std::vector<Vec2> capped;
  for (int i = 0; i <= 20; ++i) {
    capped.emplace_back(20.0, 2.0 * i);
  }
  for (int i = 1; i <= 10; ++i) {
    capped.emplace_back(20.0 - 2.0 * i, 40.0);
  }
  const TriangleMesh cap = test::revolvedMesh(capped, 60);
  const std::vector<double> height =
      HeatSolver(cap, HalfEdges(cap)).distance(test::borderAt(cap, true));
  EXPECT_NEAR(height.back(), 60.0, 0.1);
  EXPECT_EQ(std::max_element(height.begin(), height.end()), height.end() - 1);
}

TEST(Heat, FreeBordersDoNotBendTheDistance) {
  // From the lower border of a tube the distance is the height, also near the free upper border.
  const TriangleMesh tube = test::tubeMesh(15.0, 40.0, 40, 40);
  const std::vector<double> phi =
      HeatSolver(tube, HalfEdges(tube)).distance(test::borderAt(tube, true));
  for (std::size_t v = 0; v < phi.size(); ++v) {
    EXPECT_NEAR(phi[v], tube.vertices[v].z(), 0.02);
  }
  // From a corner of a plate circles stay circles.
  const TriangleMesh plate = test::gridMesh(40.0, 40.0, 60, 60);
  const std::vector<double> circle = HeatSolver(plate, HalfEdges(plate)).distance({30 * 61 + 30});
  for (std::size_t v = 0; v < circle.size(); ++v) {
    EXPECT_NEAR(circle[v], (plate.vertices[v] - Vec3(20, 20, 0)).norm(), 1.2);
  }
}

TEST(Heat, LongPartsKeepTheirGradient) {
  // 3000 rows: with t = h² the heat would fall below the least number.
  const TriangleMesh tube = test::tubeMesh(1.0, 3000.0, 6, 3000);
  const std::vector<double> phi =
      HeatSolver(tube, HalfEdges(tube)).distance(test::borderAt(tube, true));
  for (std::size_t v = 0; v < phi.size(); ++v) {
    EXPECT_NEAR(phi[v], tube.vertices[v].z(), 3.0);
  }
}

TEST(Heat, OtherComponentsAreUnreachable) {
  TriangleMesh mesh = test::tubeMesh(10.0, 20.0, 16, 10);
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const std::vector<std::uint32_t> source = test::borderAt(mesh, true);
  const TriangleMesh box = test::boxMesh({50, 0, 0}, {60, 10, 10});
  mesh.vertices.insert(mesh.vertices.end(), box.vertices.begin(), box.vertices.end());
  for (const auto& t : box.triangles) {
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  mesh.vertices.emplace_back(0.0, 0.0, 5.0);
  const std::vector<double> phi = HeatSolver(mesh, HalfEdges(mesh)).distance(source);
  for (std::size_t v = 0; v < phi.size(); ++v) {
    EXPECT_EQ(std::isinf(phi[v]), v >= first);
  }
}

TEST(Heat, ManySourcesShareOneSolver) {
  const TriangleMesh mesh = hemisphere(50.0, 30, 10);
  const HeatSolver solver(mesh, HalfEdges(mesh));
  const std::vector<double> first = solver.distance(test::borderAt(mesh, true));
  (void)solver.distance({static_cast<std::uint32_t>(mesh.vertices.size() - 1)});
  EXPECT_EQ(first, solver.distance(test::borderAt(mesh, true)));
  EXPECT_THAT(errorOf(ErrorCode::InvalidArgument, [&] { (void)solver.distance({}); }),
              ::testing::HasSubstr("no vertex is a source"));
  EXPECT_THAT(errorOf(ErrorCode::InvalidArgument, [&] { (void)solver.distance({9999}); }),
              ::testing::HasSubstr("no vertex 9999"));
  EXPECT_THAT(errorOf(ErrorCode::InvalidArgument, [&] { HeatSolver(mesh, HalfEdges(mesh), 0.0); }),
              ::testing::HasSubstr("time factor"));
}

TEST(LinearElements, OperatorsKeepTheirIdentities) {  // Diourté A17
  for (const std::uint64_t seed : wcam::testing::testSeeds(5)) {
    wcam::testing::RandomSource random(seed);
    TriangleMesh mesh = test::torusMesh(30.0, 10.0, 16, 32);
    for (Vec3& p : mesh.vertices) {
      p += Vec3(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1));
    }
    const SparseMatrix stiffness = stiffnessMatrix(mesh);
    const auto n = static_cast<Eigen::Index>(mesh.vertices.size());
    const double scale = stiffness.diagonal().maxCoeff();
    EXPECT_LT((stiffness * Eigen::VectorXd::Ones(n)).cwiseAbs().maxCoeff(), 1e-12 * scale) << seed;
    EXPECT_LT(SparseMatrix(stiffness - SparseMatrix(stiffness.transpose())).norm(), 1e-12 * scale);
    std::vector<Vec3> x;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      Vec3 direction(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1));
      const FlatTriangle flat = flatten(mesh, t);
      direction = flat.toSpace(flat.toPlane(direction).normalized());
      EXPECT_NEAR(direction.norm(), 1.0, 1e-12);
      x.push_back(direction);
      EXPECT_NEAR((flat.gradients[0] + flat.gradients[1] + flat.gradients[2]).norm(), 0.0, 1e-12);
    }
    EXPECT_NEAR(divergence(mesh, x).sum(), 0.0, 1e-9);
    double area = 0.0;
    for (const double a : vertexAreas(mesh)) {
      area += a;
    }
    double exact = 0.0;
    for (const auto& t : mesh.triangles) {
      exact += 0.5 * (mesh.vertices[t[1]] - mesh.vertices[t[0]])
                         .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]])
                         .norm();
    }
    EXPECT_NEAR(area, exact, 1e-9 * exact);
  }
}

TEST(LinearElements, DivergenceOfAGradientIsTheLaplacian) {
  const TriangleMesh mesh = test::torusMesh(30.0, 10.0, 16, 32);
  Eigen::VectorXd u(static_cast<Eigen::Index>(mesh.vertices.size()));
  for (Eigen::Index v = 0; v < u.size(); ++v) {
    u[v] = std::sin(0.3 * static_cast<double>(v));
  }
  std::vector<Vec3> gradients;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const FlatTriangle flat = flatten(mesh, t);
    Vec2 g = Vec2::Zero();
    for (std::size_t c = 0; c < 3; ++c) {
      g += u[mesh.triangles[t][c]] * flat.gradients[c];
    }
    gradients.push_back(flat.toSpace(g));
  }
  EXPECT_LT((divergence(mesh, gradients) - stiffnessMatrix(mesh) * u).cwiseAbs().maxCoeff(), 1e-10);
}

}  // namespace
