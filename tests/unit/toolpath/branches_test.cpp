// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/aabb_tree.hpp"

#include "error_matchers.hpp"
#include "field_meshes.hpp"
#include "implicit_mesh.hpp"
#include "slicing_fixture.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace wcam::toolpath {
namespace {

using geometry::PartSurface;
using wcam::testing::errorOf;

const std::string kBranches = "wcam.slicing.branches";

plugin::SliceInput inputOf(geometry::TriangleMesh mesh) {
  plugin::SliceInput input;
  input.parts = {test::meshSurface(std::move(mesh))};
  input.substrate = test::plate();
  input.bead = {0.1, 50.0, 8.0};
  return input;
}

/// What holds for every arrangement: what lies below comes first, and a layer is not far above it.
void expectSound(const SlicedLayers& sliced, const PartSurface& part, double farthest) {
  const geometry::AabbTree tree(part.mesh);
  for (std::size_t l = 0; l < sliced.layers.size(); ++l) {
    const SlicedLayer& layer = sliced.layers[l];
    ASSERT_TRUE(layer.below.has_value());
    EXPECT_FALSE(layer.contours.empty());
    for (const std::size_t below : *layer.below) {
      EXPECT_LT(below, l);
    }
    for (const Contour& contour : layer.contours) {
      for (const ContourPoint& point : contour.points) {
        EXPECT_LT(tree.closestPoint(point.p)->distance, 0.01);  // the chord error
      }
    }
    // The nearest point of what lies below.
    double least = 1e9;
    for (const ContourPoint& point : layer.contours.front().points) {
      least = layer.below->empty() ? std::min(least, point.p.z()) : least;
      for (const std::size_t below : *layer.below) {
        for (const Contour& contour : sliced.layers[below].contours) {
          for (const ContourPoint& other : contour.points) {
            least = std::min(least, (other.p - point.p).norm());
          }
        }
      }
    }
    EXPECT_LT(least, farthest) << "layer " << l;
  }
}

std::size_t junctions(const SlicedLayers& sliced) {
  std::size_t count = 0;
  for (const SlicedLayer& layer : sliced.layers) {
    for (const Contour& contour : layer.contours) {
      count += contour.feature == BeadFeature::Junction ? 1U : 0U;
    }
  }
  return count;
}

std::size_t piecesFound(const JobContext& context) {
  for (const Diagnostic& d : context.diagnostics().items()) {
    if (d.code == "slicing.branches") {
      return static_cast<std::size_t>(d.data.front().second);
    }
  }
  return 0;
}

TEST(Branches, LegsMeetInAJunction) {
  for (const char* field : {"height", "geodesic", "isovalues"}) {
    const plugin::SliceInput input = inputOf(test::forkMesh(45, true));
    const JobContext context;
    const SlicedLayers sliced = test::slice(
        kBranches, input, std::string(R"({"step": 2, "field": ")") + field + "\"}", context);
    EXPECT_EQ(piecesFound(context), 3U) << field;
    expectSound(sliced, *input.parts[0], 4.5);
    EXPECT_EQ(junctions(sliced), 1U) << field;
    EXPECT_EQ(context.diagnostics().count("slicing.several_lower_borders"), 0U);
    EXPECT_EQ(sliced.curved, field != std::string("height"));
    std::size_t onPlate = 0;
    std::size_t onTwo = 0;
    for (const SlicedLayer& layer : sliced.layers) {
      onPlate += layer.below->empty() ? 1U : 0U;
      onTwo += layer.below->size() == 2 ? 1U : 0U;
      EXPECT_EQ(layer.contours.size(), 1U) << field;
    }
    EXPECT_EQ(onPlate, 2U) << field;
    EXPECT_EQ(onTwo, 1U) << field;
  }
}

TEST(Branches, EveryPieceMayHaveItsOwnStrategy) {
  plugin::SliceInput input = inputOf(test::forkMesh(45));
  input.bead = {1.0, 3.0, 8.0};
  // One bead for each of the three pieces.
  const SlicedLayers spirals =
      test::slice(kBranches, input,
                  R"({"step": 2, "field": "geodesic", "order": "bottom", "pieces": "*=spiral"})");
  ASSERT_EQ(spirals.layers.size(), 3U);
  EXPECT_TRUE(spirals.curved);
  EXPECT_TRUE(spirals.layers[0].below->empty());
  for (std::size_t l = 0; l < 3; ++l) {
    ASSERT_EQ(spirals.layers[l].contours.size(), 1U);
    const Contour& contour = spirals.layers[l].contours.front();
    EXPECT_FALSE(contour.closed);
    EXPECT_GT(contour.turns.size(), 5U);
    if (l > 0) {
      EXPECT_EQ(*spirals.layers[l].below, std::vector<std::size_t>{0});
      EXPECT_GT(contour.points.front().p.z(),
                spirals.layers[0].contours.front().points.back().p.z() - 4.0);
    }
  }
  const geometry::AabbTree tree(input.parts[0]->mesh);
  for (const SlicedLayer& layer : spirals.layers) {
    for (const ContourPoint& point : layer.contours.front().points) {
      EXPECT_LT(tree.closestPoint(point.p)->distance, 1e-6);
    }
  }
  // The trunk by planes, one branch as a spiral, the other by its own distance.
  const SlicedLayers mixed = test::slice(
      kBranches, input, R"({"step": 2, "order": "bottom", "pieces": "1=spiral, 2=geodesic"})");
  std::size_t beads = 0;
  for (const SlicedLayer& layer : mixed.layers) {
    beads += layer.contours.front().turns.empty() ? 0U : 1U;
  }
  EXPECT_EQ(beads, 1U);
  EXPECT_GT(mixed.layers.size(), 20U);
  expectSound(mixed, *input.parts[0], 1e3);
}

TEST(Branches, WrongStrategiesOfPiecesNameTheItem) {
  const plugin::SliceInput input = inputOf(test::forkMesh(45));
  const auto expectError = [&](const std::string& pieces, const char* words) {
    EXPECT_THAT(errorOf(ErrorCode::JobFailed,
                        [&] {
                          (void)test::slice(kBranches, input,
                                            R"({"step": 2, "pieces": ")" + pieces + "\"}");
                        }),
                ::testing::HasSubstr(words));
  };
  expectError("spiral", "'spiral' has no '='");
  expectError("1=planar", "'1=planar' names no method");
  expectError("x=spiral", "'x=spiral' begins with no number");
  expectError("1=spiral,1=common", "names a piece twice");
  expectError("7=spiral", "no piece 7");
}

TEST(Branches, OrdersOfAFork) {
  const plugin::SliceInput input = inputOf(test::forkMesh(45));
  const auto sideOf = [](const SlicedLayer& layer) {
    double x = 0.0;
    for (const ContourPoint& point : layer.contours.front().points) {
      x += point.p.x() / static_cast<double>(layer.contours.front().points.size());
    }
    return x > 5.0 ? 1 : x < -5.0 ? -1 : 0;
  };
  const auto changes = [&](const char* order) {
    const SlicedLayers sliced =
        test::slice(kBranches, input, std::string(R"({"step": 2, "order": ")") + order + "\"}");
    expectSound(sliced, *input.parts[0], 4.0);
    EXPECT_EQ(junctions(sliced), 0U);
    int count = 0;
    for (std::size_t l = 1; l < sliced.layers.size(); ++l) {
      count += sideOf(sliced.layers[l]) != sideOf(sliced.layers[l - 1]) ? 1 : 0;
    }
    return count;
  };
  EXPECT_GT(changes("level"), 15);
  EXPECT_EQ(changes("bottom"), 2);
  EXPECT_EQ(changes("depth"), 2);
  EXPECT_EQ(changes("nearest"), 2);
}

TEST(Branches, HeightLayersAreThePlanes) {
  // The same curves as planar slicing gives, only in another order.
  const plugin::SliceInput input = inputOf(test::forkMesh(45));
  const SlicedLayers planar = test::slice("wcam.slicing.planar", input, R"({"step": 3})");
  const SlicedLayers pieces = test::slice(kBranches, input, R"({"step": 3})");
  double planarLength = 0.0;
  double piecesLength = 0.0;
  const auto add = [](const SlicedLayers& sliced, double& length) {
    for (const SlicedLayer& layer : sliced.layers) {
      for (const Contour& contour : layer.contours) {
        const std::size_t n = contour.points.size();
        for (std::size_t i = 0; i + (contour.closed ? 0 : 1) < n; ++i) {
          length += (contour.points[(i + 1) % n].p - contour.points[i].p).norm();
        }
      }
    }
  };
  add(planar, planarLength);
  add(pieces, piecesLength);
  EXPECT_NEAR(planarLength, piecesLength, 2e-3 * planarLength);
}

TEST(Branches, TubeIsOnePiece) {
  const plugin::SliceInput input = inputOf(test::tubeMesh(20.0, 60.0, 40, 30));
  const JobContext context;
  const SlicedLayers sliced = test::slice(kBranches, input, R"({"step": 2})", context);
  EXPECT_EQ(piecesFound(context), 1U);
  EXPECT_EQ(sliced.layers.size(), 30U);
  expectSound(sliced, *input.parts[0], 2.5);
}

TEST(Branches, SeventyBranchesOfARealPart) {
  plugin::SliceInput input;
  input.parts = {test::importSample("branches/branches_70_closed_low_res.stl")};
  input.substrate = test::plate();
  input.bead = {0.1, 50.0, 8.0};
  const JobContext context;
  const SlicedLayers sliced =
      test::slice(kBranches, input, R"({"step": 2, "order": "bottom"})", context);
  EXPECT_EQ(piecesFound(context), 71U);
  // The branches stand on the flat top of a plate, inside its outline.
  expectSound(sliced, *input.parts[0], 110.0);
  std::size_t onStem = 0;
  for (const SlicedLayer& layer : sliced.layers) {
    onStem += *layer.below == std::vector<std::size_t>{0} ? 1U : 0U;
  }
  EXPECT_EQ(onStem, 70U);  // the plate is one layer high
}

plugin::SliceInput dataInput(const std::string& file) {
  plugin::SliceInput input;
  input.parts = {io::importPart(std::string(WCAM_TEST_DATA) + "/compas_slicer/" + file,
                                io::ImportOptions{}, geometry::Pose::Identity(), JobContext())
                     .surface};
  input.substrate = test::plate(input.parts[0]->mesh.bounds().min.z());
  input.bead = {0.1, 50.0, 8.0};
  return input;
}

TEST(Branches, ThreeLeggedConnectionOfRealData) {
  // One stem, three open ends: two forks one after the other.
  const plugin::SliceInput input = dataInput("connection3legs_open_low_res.stl");
  for (const char* field : {"geodesic", "isovalues"}) {
    const JobContext context;
    const SlicedLayers sliced = test::slice(
        kBranches, input,
        std::string(R"({"step": 4, "order": "depth", "field": ")") + field + "\"}", context);
    EXPECT_EQ(piecesFound(context), 5U) << field;
    expectSound(sliced, *input.parts[0], 10.0);
    EXPECT_EQ(junctions(sliced), 0U) << field;
    EXPECT_EQ(context.diagnostics().count("slicing.grows_down"), 0U);
  }
}

TEST(Branches, LetterWithTwoFeetOfRealData) {
  const plugin::SliceInput input = dataInput("distorted_a_closed_mid_res.stl");
  const JobContext context;
  const SlicedLayers sliced = test::slice(kBranches, input, R"({"step": 3})", context);
  EXPECT_EQ(piecesFound(context), 3U);
  EXPECT_EQ(junctions(sliced), 1U);
  EXPECT_EQ(std::count_if(sliced.layers.begin(), sliced.layers.end(),
                          [](const SlicedLayer& layer) { return layer.below->empty(); }),
            2);
}

TEST(Branches, MovesAndScalesWithThePart) {
  geometry::TriangleMesh mesh = test::forkMesh(30, true);
  const SlicedLayers a =
      test::slice(kBranches, inputOf(mesh), R"({"step": 3, "field": "isovalues"})");
  for (Vec3& p : mesh.vertices) {
    p = 0.5 * Vec3(-p.y(), p.x(), p.z());
  }
  const SlicedLayers b =
      test::slice(kBranches, inputOf(mesh), R"({"step": 1.5, "field": "isovalues"})");
  ASSERT_EQ(a.layers.size(), b.layers.size());
  for (std::size_t l = 0; l < a.layers.size(); ++l) {
    EXPECT_EQ(a.layers[l].below, b.layers[l].below);
    EXPECT_NEAR(0.5 * a.layers[l].level, b.layers[l].level, 1e-6);
  }
}

TEST(Branches, CancelIsHeard) {
  std::stop_source stop;
  stop.request_stop();
  for (const char* field : {"height", "geodesic", "isovalues"}) {
    EXPECT_THROW(
        test::slice(kBranches, inputOf(test::forkMesh(30)),
                    std::string(R"({"field": ")") + field + "\"}", JobContext(stop.get_token())),
        CancelledError);
  }
}

TEST(Branches, TorusClosesOverItsHole) {
  geometry::TriangleMesh mesh = test::torusMesh(30.0, 10.0, 32, 96);
  for (Vec3& p : mesh.vertices) {
    p = Vec3(p.y(), p.z(), p.x() + 40.0);
  }
  const plugin::SliceInput input = inputOf(mesh);
  const JobContext context;
  const SlicedLayers sliced = test::slice(kBranches, input, R"({"step": 2})", context);
  EXPECT_EQ(piecesFound(context), 4U);
  EXPECT_EQ(junctions(sliced), 1U);
}

TEST(Branches, RefusesWhatItCannotSlice) {
  plugin::SliceInput below = inputOf(test::tubeMesh(25.0, 4.0, 40, 4));
  below.substrate = test::plate(50.0);
  for (const char* field : {"height", "geodesic", "isovalues"}) {
    EXPECT_THAT(errorOf(ErrorCode::CheckFailed,
                        [&] {
                          test::slice(kBranches, below,
                                      std::string(R"({"step": 2, "field": ")") + field + "\"}");
                        }),
                ::testing::HasSubstr("below the substrate"));
  }
}

}  // namespace
}  // namespace wcam::toolpath
