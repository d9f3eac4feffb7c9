// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/refine.hpp"

#include "wcam/geometry/aabb_tree.hpp"

#include "error_matchers.hpp"
#include "random_source.hpp"
#include "sample_meshes.hpp"
#include "slicing_fixture.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace wcam::geometry {
namespace {

double longestEdge(const TriangleMesh& mesh) {
  double longest = 0.0;
  for (const auto& t : mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      longest = std::max(longest, (mesh.vertices[t[c]] - mesh.vertices[t[(c + 1) % 3]]).norm());
    }
  }
  return longest;
}

double areaOf(const TriangleMesh& mesh) {
  double area = 0.0;
  for (const auto& t : mesh.triangles) {
    area += 0.5 * (mesh.vertices[t[1]] - mesh.vertices[t[0]])
                      .cross(Vec3(mesh.vertices[t[2]] - mesh.vertices[t[0]]))
                      .norm();
  }
  return area;
}

/// Greatest angle of any triangle, rad.
double worstAngle(const TriangleMesh& mesh) {
  double worst = 0.0;
  for (const auto& t : mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3 a = mesh.vertices[t[(c + 1) % 3]] - mesh.vertices[t[c]];
      const Vec3 b = mesh.vertices[t[(c + 2) % 3]] - mesh.vertices[t[c]];
      worst = std::max(worst, std::atan2(a.cross(b).norm(), a.dot(b)));
    }
  }
  return worst;
}

/// Vertices, edges and triangles fit, and the binding says where each corner is.
/// @param gap how far the file's own edges lie off their faces
void expectSound(const PartSurface& surface, double gap = 1e-9) {
  const TriangleMesh& mesh = surface.mesh;
  ASSERT_TRUE(surface.halfEdges.nonManifoldEdges().empty());
  if (!surface.exact()) {
    return;
  }
  const BrepBinding& binding = surface.binding;
  ASSERT_EQ(binding.face.size(), mesh.triangles.size());
  ASSERT_EQ(binding.uv.size(), mesh.triangles.size());
  ASSERT_EQ(binding.edge.size(), 3 * mesh.triangles.size());
  ASSERT_EQ(binding.edgeParam.size(), 3 * mesh.triangles.size());
  const BrepEvaluator evaluator(*surface.brep);
  std::size_t folded = 0;
  std::vector<bool> onEdge(mesh.vertices.size(), false);
  for (std::uint32_t h = 0; h < 3 * mesh.triangles.size(); ++h) {
    if (binding.edge[h] >= 0) {
      onEdge[mesh.triangles[h / 3][h % 3]] = true;
      onEdge[mesh.triangles[h / 3][(h % 3 + 1) % 3]] = true;
    }
  }
  for (std::uint32_t h = 0; h < 3 * mesh.triangles.size(); ++h) {
    const std::uint32_t t = h / 3;
    const Vec3& p = mesh.vertices[mesh.triangles[t][h % 3]];
    const Vec3& q = mesh.vertices[mesh.triangles[t][(h % 3 + 1) % 3]];
    const Vec2& uv = binding.uv[t][h % 3];
    const double tolerance = onEdge[mesh.triangles[t][h % 3]] ? gap : 1e-9;
    ASSERT_LT((evaluator.surface(binding.face[t], uv).p - p).norm(), tolerance) << "triangle " << t;
    if (binding.edge[h] >= 0) {
      const auto& param = binding.edgeParam[h];
      ASSERT_LT((evaluator.curve(binding.edge[h], param[0]).p - p).norm(), gap);
      ASSERT_LT((evaluator.curve(binding.edge[h], param[1]).p - q).norm(), gap);
    } else if (const std::uint32_t twin = surface.halfEdges.twin(h); twin != HalfEdges::kNone) {
      ASSERT_EQ(binding.face[twin / 3], binding.face[t]);
      ASSERT_LT(binding.edge[twin], 0);
    }
    if (h % 3 == 0) {
      const Vec2 middle = (binding.uv[t][0] + binding.uv[t][1] + binding.uv[t][2]) / 3.0;
      folded += mesh.normal(t).dot(evaluator.normal(binding.face[t], middle)) < 0.5 ? 1 : 0;
    }
  }
  EXPECT_EQ(folded, 0U);
}

/// Border vertices of the coarse surface remain on the border, loop by loop.
void expectSameBorders(const PartSurface& coarse, const PartSurface& fine) {
  const auto before = coarse.halfEdges.borderLoops(coarse.mesh);
  const auto after = fine.halfEdges.borderLoops(fine.mesh);
  ASSERT_EQ(before.size(), after.size());
  EXPECT_EQ(coarse.halfEdges.closed(), fine.halfEdges.closed());
  std::vector<bool> onBorder(fine.mesh.vertices.size(), false);
  for (const auto& loop : after) {
    for (const std::uint32_t v : loop) {
      onBorder[v] = true;
    }
  }
  for (const auto& loop : before) {
    for (const std::uint32_t v : loop) {
      EXPECT_TRUE(onBorder[v]);
      EXPECT_EQ(fine.mesh.vertices[v], coarse.mesh.vertices[v]);
    }
  }
}

class RefineExactParts : public ::testing::TestWithParam<const char*> {};

TEST_P(RefineExactParts, KeepsSurfaceBordersAndBounds) {
  const auto coarse = test::importSample(GetParam());
  for (const double maxEdge : {8.0, 3.0, 1.1}) {
    SCOPED_TRACE(maxEdge);
    const PartSurface fine = refineSurface(*coarse, maxEdge);
    EXPECT_LE(longestEdge(fine.mesh), maxEdge);
    EXPECT_GE(fine.mesh.triangles.size(), coarse->mesh.triangles.size());
    // The curves of the last part lie up to 1e-3 mm off its B-spline faces.
    expectSound(fine, std::string(GetParam()).find("supportless") == 0 ? 1e-3 : 1e-9);
    expectSameBorders(*coarse, fine);
    EXPECT_NE(fine.hash, coarse->hash);
  }
}

INSTANTIATE_TEST_SUITE_P(Parts,
                         RefineExactParts,
                         ::testing::Values("elbow/elbow.step",
                                           "hemisphere/hemisphere.step",
                                           "supportless/supportless_sample.stp"));

TEST(Refine, AreaOfTheTorusConverges) {
  // A quarter of the torus R 50, r 15.
  const double exact = 4.0 * kPi * kPi * 50.0 * 15.0 / 4.0;
  const auto coarse = test::importSample("elbow/elbow.step");
  double previous = std::abs(areaOf(coarse->mesh) - exact);
  for (const double maxEdge : {3.0, 1.5, 0.75}) {
    const double error = std::abs(areaOf(refineSurface(*coarse, maxEdge).mesh) - exact);
    EXPECT_LT(error, 0.5 * previous) << maxEdge;
    previous = error;
  }
  EXPECT_LT(previous, 2e-4 * exact);
}

TEST(Refine, SlicesAreTheSameExactCurves) {
  const auto coarse = test::importSample("elbow/elbow.step");
  const auto fine = std::make_shared<PartSurface>(refineSurface(*coarse, 2.0));
  const plugin::SliceInput a{{coarse}, test::plate(), nullptr, {}};
  const plugin::SliceInput b{{fine}, test::plate(), nullptr, {}};
  const auto first = test::slice("wcam.slicing.planar", a, R"({"step": 5.0})");
  const auto second = test::slice("wcam.slicing.planar", b, R"({"step": 5.0})");
  ASSERT_EQ(first.layers.size(), second.layers.size());
  for (std::size_t l = 0; l < first.layers.size(); ++l) {
    ASSERT_EQ(first.layers[l].contours.size(), second.layers[l].contours.size());
    EXPECT_EQ(first.layers[l].contours[0].closed, second.layers[l].contours[0].closed);
    for (const auto& point : second.layers[l].contours[0].points) {
      EXPECT_NEAR(point.p.z(), first.layers[l].level, 1e-9);
      EXPECT_NEAR(std::hypot(std::hypot(point.p.x() + 50.0, point.p.z()) - 50.0, point.p.y()), 15.0,
                  1e-9);
    }
  }
}

TEST(Refine, PlaneFacesGetWellShapedTriangles) {
  // Box faces are two triangles each in the mesh.
  auto box = test::meshSurface(test::boxMesh({0, 0, 0}, {100, 37, 11}));
  const PartSurface fine = refineSurface(*box, 2.0);
  EXPECT_LE(longestEdge(fine.mesh), 2.0);
  expectSound(fine);
  EXPECT_TRUE(fine.halfEdges.closed());
  EXPECT_NEAR(areaOf(fine.mesh), areaOf(box->mesh), 1e-9 * areaOf(box->mesh));
  EXPECT_LT(worstAngle(fine.mesh), 120.0 * kPi / 180.0);
}

TEST(Refine, CurvedMeshesKeepTheirShape) {
  const auto torus = test::meshSurface(test::torusMesh(50, 15, 24, 60));
  const PartSurface fine = refineSurface(*torus, 1.0);
  expectSound(fine);
  const AabbTree tree(torus->mesh);
  for (const Vec3& p : fine.mesh.vertices) {
    ASSERT_LT(tree.closestPoint(p)->distance, 1e-9);
  }
  EXPECT_NEAR(areaOf(fine.mesh), areaOf(torus->mesh), 1e-6 * areaOf(torus->mesh));
}

/// The triangles as coordinates, corners turned to the least first, sorted.
std::vector<std::array<double, 9>> shapeOf(const TriangleMesh& mesh) {
  std::vector<std::array<double, 9>> shape;
  for (const auto& t : mesh.triangles) {
    std::array<double, 9> best{};
    for (std::size_t turn = 0; turn < 3; ++turn) {
      std::array<double, 9> now{};
      for (std::size_t c = 0; c < 3; ++c) {
        std::copy_n(mesh.vertices[t[(c + turn) % 3]].data(), 3, now.begin() + 3 * c);
      }
      best = turn == 0 ? now : std::min(best, now);
    }
    shape.push_back(best);
  }
  std::sort(shape.begin(), shape.end());
  return shape;
}

/// The same surface with triangles, vertices and corners in another order.
PartSurface shuffled(const PartSurface& surface, testing::RandomSource& random) {
  const std::size_t vertices = surface.mesh.vertices.size();
  const std::size_t triangles = surface.mesh.triangles.size();
  std::vector<std::uint32_t> vertexOrder(vertices);
  std::vector<std::uint32_t> triangleOrder(triangles);
  for (std::uint32_t v = 0; v < vertices; ++v) {
    vertexOrder[v] = v;
  }
  for (std::uint32_t t = 0; t < triangles; ++t) {
    triangleOrder[t] = t;
  }
  for (std::size_t i = vertices; i > 1; --i) {
    std::swap(vertexOrder[i - 1], vertexOrder[random.below(i)]);
  }
  for (std::size_t i = triangles; i > 1; --i) {
    std::swap(triangleOrder[i - 1], triangleOrder[random.below(i)]);
  }
  PartSurface result;
  result.brep = surface.brep;
  result.mesh.vertices.resize(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    result.mesh.vertices[vertexOrder[v]] = surface.mesh.vertices[v];
  }
  for (const std::uint32_t t : triangleOrder) {
    const std::size_t turn = random.below(3);
    std::array<std::uint32_t, 3> corners{};
    std::array<Vec2, 3> uv;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t from = (c + turn) % 3;
      corners[c] = vertexOrder[surface.mesh.triangles[t][from]];
      if (surface.exact()) {
        uv[c] = surface.binding.uv[t][from];
        result.binding.edge.push_back(surface.binding.edge[3 * t + from]);
        result.binding.edgeParam.push_back(surface.binding.edgeParam[3 * t + from]);
      }
    }
    result.mesh.triangles.push_back(corners);
    if (surface.exact()) {
      result.binding.face.push_back(surface.binding.face[t]);
      result.binding.uv.push_back(uv);
    }
  }
  result.halfEdges = HalfEdges(result.mesh);
  return result;
}

TEST(Refine, DoesNotDependOnTheOrderOfTriangles) {
  testing::RandomSource random(20261122);
  SCOPED_TRACE(random.seed());
  for (const auto& part :
       {test::importSample("elbow/elbow.step"), test::importSample("hemisphere/hemisphere.step"),
        test::meshSurface(test::torusMesh(50, 15, 12, 31)),
        test::meshSurface(test::boxMesh({0, 0, 0}, {100, 37, 11}))}) {
    const auto expected = shapeOf(refineSurface(*part, 2.0).mesh);
    const auto other = shapeOf(refineSurface(shuffled(*part, random), 2.0).mesh);
    EXPECT_EQ(expected, other);
  }
}

TEST(Refine, AFineSurfaceStays) {
  const auto torus = test::meshSurface(test::torusMesh(50, 15, 24, 60));
  const PartSurface same = refineSurface(*torus, 100.0);
  EXPECT_EQ(same.mesh.vertices.size(), torus->mesh.vertices.size());
  EXPECT_EQ(same.mesh.triangles.size(), torus->mesh.triangles.size());
}

TEST(Refine, RefusesWhatCannotBe) {
  const auto torus = test::meshSurface(test::torusMesh(50, 15, 24, 60));
  EXPECT_THROW(refineSurface(*torus, 0.0), Error);
  EXPECT_THROW(refineSurface(*torus, -1.0), Error);
  EXPECT_THROW(refineSurface(*torus, std::nan("")), Error);
  try {
    refineSurface(*torus, 0.001);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::InvalidArgument);
    EXPECT_NE(error.hint().find("0.256"), std::string::npos) << error.hint();
  }
}

TEST(Refine, FieldEdgeLengthFollowsStepAndArea) {
  const auto torus = test::meshSurface(test::torusMesh(50, 15, 240, 600));
  // 29.6e3 mm²: 5 mm would leave some 3000 triangles, too few for a distance.
  EXPECT_DOUBLE_EQ(fieldEdgeLength(*torus, 2.0), 1.0);
  EXPECT_LT(fieldEdgeLength(*torus, 10.0), 3.0);
  const PartSurface coarse = refineSurface(*torus, fieldEdgeLength(*torus, 10.0));
  EXPECT_GT(coarse.mesh.triangles.size(), 20000U);
  const auto part = test::importSample("elbow/elbow.step");
  const std::size_t count =
      refineSurface(*part, fieldEdgeLength(*part, 0.01)).mesh.triangles.size();
  EXPECT_GT(count, 200000U);
  EXPECT_LT(count, 1000000U);
}

}  // namespace
}  // namespace wcam::geometry
