// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/spiral.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/parallel.hpp"
#include "wcam/base/remedy.hpp"
#include "wcam/base/text.hpp"
#include "wcam/geometry/segment_tree.hpp"
#include "wcam/geometry/surface_projector.hpp"

#include "sample_meshes.hpp"
#include "slicing_fixture.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace wcam::toolpath {
namespace {

using geometry::Vec3;

std::shared_ptr<const geometry::PartSurface> formulaPart(const std::string& name) {
  return io::importPart(std::string(WCAM_TEST_DATA) + "/formula/" + name, io::ImportOptions{},
                        geometry::Pose::Identity(), JobContext())
      .surface;
}

struct Spiral {
  SlicedLayers sliced;
  std::vector<Diagnostic> findings;

  [[nodiscard]] const Contour& bead() const { return sliced.layers.front().contours.front(); }

  [[nodiscard]] double number(const std::string& key) const {
    for (const Diagnostic& finding : findings) {
      for (const auto& [name, value] : finding.data) {
        if (finding.code == "slicing.spiral" && name == key) {
          return value;
        }
      }
    }
    ADD_FAILURE() << "no number " << key;
    return 0.0;
  }
};

Spiral spiral(const std::shared_ptr<const geometry::PartSurface>& part,
              const std::string& params,
              const Sampling& sampling = {0.02, 4.9}) {
  plugin::SliceInput input{{part}, test::plate(), nullptr, sampling};
  const JobContext context;
  Spiral result;
  result.sliced = test::slice("wcam.slicing.spiral", input, params, context);
  result.findings = context.diagnostics().items();
  return result;
}

TEST(SpiralSlicing, LiteralLawReproducesTable33OnTheTrunkSurrogate) {
  // Diourté Table 3.3, A21: 84 revolutions of 1.81 … 2.12 mm, one bead.
  for (const std::string method : {"isovalues", "geodesic"}) {
    SCOPED_TRACE(method);
    const Spiral result = spiral(formulaPart("trunk_surrogate.wsurf"),
                                 R"({"step": 2.0, "start": "none", "end": "literal",
                                     "centred": false, "decomposition": ")" +
                                     method + "\"}");
    EXPECT_EQ(result.number("revolutions"), 84.0);
    EXPECT_NEAR(result.number("deposit_min_mm"), 1.81, 0.005);
    EXPECT_NEAR(result.number("deposit_max_mm"), 2.12, 0.005);
    EXPECT_NEAR(result.number("shortest_mm"), 152.0, 0.1);
    EXPECT_NEAR(result.number("longest_mm"), 178.0, 0.1);
    ASSERT_EQ(result.sliced.layers.size(), 1U);
    ASSERT_EQ(result.sliced.layers[0].contours.size(), 1U);
  }
}

TEST(SpiralSlicing, PointsLieOnTheExactSurfaceAndTheSeamHasNoStep) {
  const Spiral result = spiral(formulaPart("trunk_surrogate.wsurf"), R"({"step": 2.0})");
  const double R = 165.0 * 19.0 / 13.0;
  EXPECT_LT(result.number("seam_step_mm"), 1e-9);
  const Contour& bead = result.bead();
  for (const ContourPoint& point : bead.points) {
    const double ring = std::hypot(point.p.x() + R, point.p.z()) - R;
    EXPECT_NEAR(std::hypot(ring, point.p.y()), 19.0, 1e-6);
    EXPECT_NEAR(point.n.norm(), 1.0, 1e-12);
  }
  // Ordered: no jump beyond the spacing except in the ramps' seams.
  const std::size_t from = bead.turns[static_cast<std::size_t>(result.number("start_revolutions"))];
  const std::size_t to =
      bead.turns[bead.turns.size() - static_cast<std::size_t>(result.number("end_revolutions"))];
  for (std::size_t i = from + 1; i < to; ++i) {
    EXPECT_LT((bead.points[i].p - bead.points[i - 1].p).norm(), 4.9 * 1.05) << i;
  }
  // Heights inside the range, apart from the cosine of the path's slope (A27: below 1e-4).
  for (std::size_t i = from; i < to; ++i) {
    EXPECT_GT(bead.points[i].height, 1.8 * 0.999);
    EXPECT_LT(bead.points[i].height, 2.2 * 1.001);
  }
}

TEST(SpiralSlicing, CylinderIsAHelixOfTheExpectedHeight) {
  // A27: R = 25, D = 2: γ = 0.7295°, H = D·cos γ = 1.99984.
  const auto part = test::meshSurface(test::tubeMesh(25.0, 100.0, 256, 100));
  const Spiral result = spiral(part, R"({"step": 2.0, "start": "ramp", "generatrices": 360})");
  const Contour& bead = result.bead();
  // One turn below each point lies the same angle: the climb between them is D.
  const std::size_t around = bead.turns[3] - bead.turns[2];
  ASSERT_EQ(around, 360U);
  for (std::size_t i = bead.turns[3]; i < bead.turns[bead.turns.size() - 2]; ++i) {
    const double pitch = bead.points[i].p.z() - bead.points[i - around].p.z();
    EXPECT_NEAR(pitch, 2.0, 0.02);
    const double slope = std::atan(pitch / (2.0 * kPi * 25.0));
    // D − D·cos γ is 1.6e-4: the bound tells one from the other.
    EXPECT_NEAR(bead.points[i].height, pitch * std::cos(slope), 5e-5);
  }
  // Travel clockwise seen from above, so that b = t × n points up (A26).
  const Vec3 t = bead.points[1].p - bead.points[0].p;
  EXPECT_GT(t.cross(bead.points[0].n).z(), 0.0);
  EXPECT_NEAR(bead.points.back().p.z(), 100.0, 1e-9);
  // A24: exactly one bead.
  const Toolpath path = buildToolpath(result.sliced, *test::plate(), PathParams{}, JobContext());
  EXPECT_EQ(path.beadCount(), 1U);
}

TEST(SpiralSlicing, SlantedTubeIsFeasibleInsideTheDerivedLimit) {
  // A9: feasible iff R·tan β ≤ 0.1 H; here 25·tan 15° = 6.7 of 100.
  for (const std::string method : {"isovalues", "envelope"}) {
    SCOPED_TRACE(method);
    const Spiral result =
        spiral(formulaPart("slanted_tube.wsurf"),
               R"({"step": 1.0, "start": "ramp", "decomposition": ")" + method + "\"}");
    EXPECT_NEAR(result.number("longest_mm"), 100.0, 0.3);
    EXPECT_NEAR(result.number("shortest_mm"), 100.0 - 50.0 * std::tan(degToRad(15.0)), 0.3);
  }
  // Both sides of the limit: tan β = 0.1·100/25 at 21.8 degrees.
  for (const auto& [degrees, feasible] : {std::pair{20.0, true}, std::pair{24.0, false}}) {
    geometry::TriangleMesh tube = test::tubeMesh(25.0, 100.0, 128, 50);
    for (Vec3& p : tube.vertices) {
      p.z() *= 1.0 + p.x() * std::tan(degToRad(degrees)) / 100.0;
    }
    const auto part = test::meshSurface(std::move(tube));
    const char* params = R"({"step": 1.0, "start": "none", "end": "literal"})";
    try {
      static_cast<void>(spiral(part, params));
      EXPECT_TRUE(feasible) << degrees;
    } catch (const Error& error) {
      EXPECT_FALSE(feasible) << degrees << ": " << error.what();
      EXPECT_THAT(error.what(), testing::HasSubstr("needs a deposit of"));
    }
  }
}

TEST(SpiralSlicing, EnvelopeOfACylinderIsItself) {
  // A4.
  const auto part = test::meshSurface(test::tubeMesh(25.0, 100.0, 128, 50));
  const Spiral result = spiral(part, R"({"step": 2.0, "decomposition": "envelope"})");
  EXPECT_NEAR(result.number("shortest_mm"), 100.0, 1e-9);
  EXPECT_NEAR(result.number("longest_mm"), 100.0, 1e-9);
}

TEST(SpiralSlicing, VaseOfRevolutionHasEqualGeneratrices) {
  double length = 0.0;
  constexpr int kPieces = 100000;
  for (int i = 0; i < kPieces; ++i) {
    const double z = 115.0 * (i + 0.5) / kPieces;
    const double slope = 30.0 * 0.15 * 2.0 * kPi / 115.0 * std::cos(2.0 * kPi * z / 115.0);
    length += std::hypot(1.0, slope) * 115.0 / kPieces;
  }
  for (const std::string method : {"isovalues", "geodesic", "envelope"}) {
    SCOPED_TRACE(method);
    const Spiral result =
        spiral(formulaPart("vase.wsurf"), R"({"step": 2.0, "decomposition": ")" + method + "\"}");
    EXPECT_NEAR(result.number("shortest_mm"), length, 0.02);
    EXPECT_NEAR(result.number("longest_mm"), length, 0.02);
    EXPECT_EQ(result.number("filled"), 0.0);
  }
}

TEST(SpiralSlicing, HemisphereClosesAtItsPole) {
  // A10: all generatrices have the length πR/2, the closure is the pole.
  for (const std::string method : {"isovalues", "geodesic"}) {
    SCOPED_TRACE(method);
    const Spiral result = spiral(formulaPart("p1_hemisphere.wsurf"),
                                 R"({"step": 2.0, "decomposition": ")" + method + "\"}");
    EXPECT_NEAR(result.number("shortest_mm"), 45.0 * kPi / 2.0, 0.15);
    EXPECT_NEAR(result.number("longest_mm"), 45.0 * kPi / 2.0, 0.15);
    EXPECT_GT(result.bead().points.back().p.z(), 44.9);
    EXPECT_LT(result.bead().points.back().p.z(), 45.0);
  }
}

TEST(SpiralSlicing, TooNarrowARangeNamesTheGeneratrixAndWhatWouldDo) {
  // A8: the quarter torus R50 r15 has lengths of 55 to 102 mm.
  try {
    (void)spiral(formulaPart("p4_quarter_torus.wsurf"), R"({"step": 2.0})");
    FAIL() << "must refuse";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::JobFailed);
    EXPECT_NE(error.message().find("generatrix from"), std::string::npos) << error.message();
    EXPECT_NE(error.message().find("mm long"), std::string::npos);
    EXPECT_NE(error.hint().find("set the modulation range to "), std::string::npos) << error.hint();
    // The remedy comes with its figures, and they do.
    const auto* remedied = dynamic_cast<const RemediedError*>(&error);
    ASSERT_NE(remedied, nullptr) << "the plugin's guard keeps what kind of error it is";
    ASSERT_EQ(remedied->settings().size(), 2U);
    EXPECT_EQ(remedied->settings()[0].key, "height_min");
    EXPECT_EQ(remedied->settings()[1].key, "height_max");
    const Spiral followed =
        spiral(formulaPart("p4_quarter_torus.wsurf"),
               R"({"step": 2.0, "height_min": )" + formatFixed(remedied->settings()[0].value, 2) +
                   R"(, "height_max": )" + formatFixed(remedied->settings()[1].value, 2) + "}");
    for (const Diagnostic& finding : followed.findings) {
      EXPECT_NE(finding.code, "slicing.spiral_height") << finding.message;
      EXPECT_NE(finding.code, "slicing.spiral_infeasible") << finding.message;
    }
  }
  const Spiral reported =
      spiral(formulaPart("p4_quarter_torus.wsurf"), R"({"step": 2.0, "infeasible": "report"})");
  EXPECT_TRUE(std::any_of(reported.findings.begin(), reported.findings.end(),
                          [](const auto& f) { return f.code == "slicing.spiral_infeasible"; }));
  const Spiral wide = spiral(formulaPart("p4_quarter_torus.wsurf"),
                             R"({"step": 2.0, "height_min": 1.2, "height_max": 2.8})");
  EXPECT_GT(wide.number("revolutions"), 30.0);
}

TEST(SpiralSlicing, RigidMotionAndScalingMoveThePath) {
  const Spiral one = spiral(test::meshSurface(test::tubeMesh(20.0, 60.0, 64, 60)),
                            R"({"step": 2.0, "generatrices": 64})");
  geometry::TriangleMesh scaled = test::tubeMesh(20.0, 60.0, 64, 60);
  for (Vec3& p : scaled.vertices) {
    p = 2.0 * Vec3(p.y(), -p.x(), p.z());
  }
  const Spiral two =
      spiral(test::meshSurface(scaled), R"({"step": 4.0, "generatrices": 64})", {0.04, 9.8});
  ASSERT_EQ(one.bead().points.size(), two.bead().points.size());
  for (std::size_t i = 0; i < one.bead().points.size(); ++i) {
    EXPECT_NEAR(one.bead().points[i].height * 2.0, two.bead().points[i].height, 1e-6);
    EXPECT_NEAR(one.bead().points[i].p.z() * 2.0, two.bead().points[i].p.z(), 1e-6);
  }
}

TEST(SpiralSlicing, BadPartsAreRefusedWithTheReason) {
  const auto message = [](const std::shared_ptr<const geometry::PartSurface>& part,
                          const std::string& params) {
    try {
      (void)spiral(part, params);
    } catch (const Error& error) {
      EXPECT_FALSE(error.hint().empty());
      return error.message();
    }
    return std::string("accepted");
  };
  geometry::TriangleMesh ring = test::torusMesh(50, 15, 24, 48);
  for (Vec3& p : ring.vertices) {
    p.z() += 15.0;
  }
  EXPECT_NE(
      message(test::meshSurface(ring), R"({"step": 2.0})").find("closed surface without a border"),
      std::string::npos);
  EXPECT_NE(message(test::meshSurface(test::tubeMesh(25.0, 5.0, 64, 5)), R"({"step": 2.0})")
                .find("too short"),
            std::string::npos);
  EXPECT_NE(message(test::meshSurface(test::tubeMesh(25.0, 50.0, 64, 5)),
                    R"({"step": 2.0, "height_min": 2.2, "height_max": 1.8})")
                .find("above h_max"),
            std::string::npos);
  // A tube with a slit: its only border runs up and down.
  geometry::TriangleMesh slit = test::tubeMesh(25.0, 50.0, 64, 50);
  std::erase_if(slit.triangles, [](const auto& t) {
    return std::all_of(t.begin(), t.end(), [](std::uint32_t v) { return v % 64 < 2; });
  });
  EXPECT_NE(message(test::meshSurface(slit), R"({"step": 2.0})"), "accepted");
}

TEST(SpiralSlicing, PartThatPassesThroughThePlateIsCutThere) {
  const auto part = test::meshSurface(test::tubeMesh(25.0, 100.0, 96, 30));
  plugin::SliceInput input{{part}, test::plate(40.3), nullptr, {0.05, 4.9}};
  const JobContext context;
  const SlicedLayers sliced =
      test::slice("wcam.slicing.spiral", input, R"({"step": 2.0, "start": "ramp"})", context);
  const Contour& bead = sliced.layers.front().contours.front();
  for (const ContourPoint& point : bead.points) {
    EXPECT_GE(point.p.z(), 40.3 - 1e-6);
  }
  EXPECT_NEAR(bead.points.back().p.z(), 100.0, 1e-9);
  for (const Diagnostic& finding : context.diagnostics().items()) {
    for (const auto& [name, value] : finding.data) {
      if (name == "shortest_mm") {
        EXPECT_NEAR(value, 59.7, 1e-6);
      }
    }
  }
}

TEST(SpiralSlicing, GapsOfShortestPathsAreFilledWhereTheTextSaysSo) {
  // A14: none on a cylinder; some on a slender tube with a top slanted by β when
  // tan β·(H + R·tan β) > R.
  const auto filled = [](double radius, double height, double beta) {
    geometry::TriangleMesh mesh = test::tubeMesh(radius, 1.0, 96, 80);
    for (Vec3& p : mesh.vertices) {
      p.z() *= height + p.x() * std::tan(beta);
    }
    return spiral(test::meshSurface(mesh),
                  R"({"step": 1.0, "decomposition": "geodesic", "infeasible": "report",
                      "start": "ramp", "generatrices": 120})")
        .number("filled");
  };
  EXPECT_EQ(filled(10.0, 60.0, 0.0), 0.0);
  EXPECT_GT(filled(10.0, 60.0, degToRad(15.0)), 0.0);
}

TEST(SpiralSlicing, OverhangIsRefusedByTheEnvelopeOnly) {
  // A7: a tube with a lip that turns outwards and down again.
  geometry::TriangleMesh mesh = test::tubeMesh(20.0, 60.0, 96, 60);
  for (Vec3& p : mesh.vertices) {
    const double s = p.z();
    const double angle = std::atan2(p.y(), p.x());
    // Straight to 25 mm, then an arc of radius 8 over 230 degrees: up, outwards, down.
    const double bend = std::clamp((s - 25.0) / 8.0, 0.0, degToRad(230.0));
    const double radius = 20.0 + 8.0 * (1.0 - std::cos(bend));
    const double z = std::min(s, 25.0) + 8.0 * std::sin(bend);
    p = Vec3(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  std::erase_if(mesh.triangles, [](const auto& t) {
    return std::any_of(t.begin(), t.end(), [](std::uint32_t v) { return v / 96 > 57; });
  });
  const auto part = test::meshSurface(mesh);
  try {
    (void)spiral(part, R"({"step": 1.5, "decomposition": "envelope"})");
    FAIL() << "must refuse";
  } catch (const Error& error) {
    EXPECT_NE(error.message().find("overhang"), std::string::npos) << error.message();
  }
  for (const std::string method : {"isovalues", "geodesic"}) {
    const Spiral result = spiral(part, R"({"step": 1.5, "decomposition": ")" + method + R"("})");
    EXPECT_NEAR(result.number("shortest_mm"), result.number("longest_mm"), 0.05) << method;
  }
}

TEST(SpiralSlicing, FieldFormAgreesWithTheGeneratrices) {
  for (const std::string name : {"trunk_surrogate.wsurf", "vase.wsurf"}) {
    SCOPED_TRACE(name);
    const Spiral curves = spiral(formulaPart(name), R"({"step": 2.0})");
    const Spiral field = spiral(formulaPart(name), R"({"step": 2.0, "form": "field"})");
    EXPECT_NEAR(field.number("revolutions"), curves.number("revolutions"), 1.0);
    EXPECT_NEAR(field.number("deposit_min_mm"), curves.number("deposit_min_mm"), 0.03);
    EXPECT_NEAR(field.number("deposit_max_mm"), curves.number("deposit_max_mm"), 0.03);
    // Every point of the one lies between the revolutions of the other: no jump, one bead.
    const Contour& bead = field.bead();
    const std::size_t from =
        bead.turns[static_cast<std::size_t>(field.number("start_revolutions"))];
    const std::size_t to =
        bead.turns[bead.turns.size() - static_cast<std::size_t>(field.number("end_revolutions"))];
    for (std::size_t i = from + 1; i < to; ++i) {
      ASSERT_LT((bead.points[i].p - bead.points[i - 1].p).norm(), 5.5) << i;
    }
    // Each revolution lies a deposit above the one before it, whatever the form.
    const auto first = static_cast<std::size_t>(field.number("start_revolutions"));
    const auto last = bead.turns.size() - static_cast<std::size_t>(field.number("end_revolutions"));
    for (std::size_t k = first + 1; k + 1 < last; ++k) {
      geometry::SegmentTree below;
      std::vector<Vec3> turn;
      for (std::size_t i = bead.turns[k - 1]; i < bead.turns[k]; ++i) {
        turn.push_back(bead.points[i].p);
      }
      below.add(turn, false);
      below.build();
      for (std::size_t i = bead.turns[k]; i < bead.turns[k + 1]; ++i) {
        // The beginning follows the end of the revolution below.
        if ((bead.points[i].p - bead.points[bead.turns[k]].p).norm() < 6.0) {
          continue;
        }
        const double distance = below.distance(bead.points[i].p);
        ASSERT_GT(distance, 1.75) << k;
        ASSERT_LT(distance, 2.25) << k;
      }
    }
  }
}

TEST(SpiralSlicing, HeightsRepeatFromRevolutionToRevolution) {
  // A29, and A28: H ≤ D.
  const Spiral result = spiral(formulaPart("trunk_surrogate.wsurf"), R"({"step": 2.0})");
  const Contour& bead = result.bead();
  const auto first = static_cast<std::size_t>(result.number("start_revolutions"));
  const auto last = bead.turns.size() - static_cast<std::size_t>(result.number("end_revolutions"));
  const auto around = bead.turns[1];
  for (std::size_t k = first + 1; k < last; ++k) {
    for (std::size_t i = 1; i + 1 < around; ++i) {
      const double here = bead.points[bead.turns[k] + i].height;
      EXPECT_NEAR(here, bead.points[bead.turns[k - 1] + i].height, 2e-3);
      EXPECT_LE(here, result.number("deposit_max_mm") + 1e-9);
      // Against the climb at this very point.
      const double climb =
          (bead.points[bead.turns[k] + i].p - bead.points[bead.turns[k - 1] + i].p).norm();
      EXPECT_LE(here, climb + 1e-4);
      EXPECT_GE(here, climb * 0.995);
    }
  }
}

TEST(SpiralSlicing, SurfaceThroughThePathStaysNearThePart) {
  // A30: the surface through the path's points within 0.2 mm of the part; chords within s²/(8R).
  const Spiral result = spiral(formulaPart("trunk_surrogate.wsurf"), R"({"step": 2.0})");
  const Contour& bead = result.bead();
  const auto around = bead.turns[1];
  const double R = 165.0 * 19.0 / 13.0;
  for (std::size_t k = 1; k + 1 < bead.turns.size(); ++k) {
    for (std::size_t i = 0; i < around; ++i) {
      const Vec3 middle = 0.25 * (bead.points[bead.turns[k] + i].p +
                                  bead.points[bead.turns[k] + (i + 1) % around].p +
                                  bead.points[bead.turns[k - 1] + i].p +
                                  bead.points[bead.turns[k - 1] + (i + 1) % around].p);
      const double ring = std::hypot(middle.x() + R, middle.z()) - R;
      EXPECT_NEAR(std::hypot(ring, middle.y()), 19.0, 0.2);
    }
  }
}

TEST(SpiralSlicing, MirrorSymmetricDomeClosesInItsPlane) {
  // A13: the closure of a symmetric part lies within a mesh edge of the symmetry plane.
  geometry::TriangleMesh mesh = test::tubeMesh(1.0, 1.0, 96, 60);
  for (Vec3& p : mesh.vertices) {
    const double polar = 0.5 * kPi * p.z();
    const double angle = std::atan2(p.y(), p.x());
    p = Vec3(40.0 * std::cos(polar) * std::cos(angle) - 25.0 * std::pow(std::sin(polar), 2),
             40.0 * std::cos(polar) * std::sin(angle), 60.0 * std::sin(polar));
  }
  // The top ring is one point.
  const auto top = static_cast<std::uint32_t>(60 * 96);
  for (auto& triangle : mesh.triangles) {
    for (std::uint32_t& v : triangle) {
      v = v > top ? top : v;
    }
  }
  mesh.vertices.resize(top + 1);
  std::erase_if(mesh.triangles,
                [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  const Spiral result = spiral(test::meshSurface(mesh),
                               R"({"step": 2.0, "height_min": 1.2, "height_max": 2.8,
                                   "infeasible": "report"})");
  EXPECT_NEAR(result.bead().points.back().p.y(), 0.0, 2.0);
}

TEST(SpiralSlicing, ResultDoesNotDependOnThreads) {
  std::vector<Spiral> results;
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    results.push_back(spiral(formulaPart("trunk_surrogate.wsurf"), R"({"step": 3.0})"));
  }
  for (std::size_t r = 1; r < results.size(); ++r) {
    ASSERT_EQ(results[r].bead().points.size(), results[0].bead().points.size());
    for (std::size_t i = 0; i < results[0].bead().points.size(); ++i) {
      ASSERT_EQ(results[r].bead().points[i].p, results[0].bead().points[i].p);
    }
  }
}

}  // namespace
}  // namespace wcam::toolpath
