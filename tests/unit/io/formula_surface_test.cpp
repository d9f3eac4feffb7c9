// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/geometry/guide_curve.hpp"
#include "wcam/io/import.hpp"

#include "io_files.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

/// Formula surfaces: the test parts of Chalvin (P1, P2, P3, P4, P6) from their equations.
namespace wcam::io {
namespace {

using geometry::BrepEvaluator;
using geometry::PartSurface;
using geometry::Pose;
using geometry::Vec2;
using geometry::Vec3;
using test::TemporaryFolder;
using test::writeBytes;

ImportedPart importFormula(const std::string& name, const Pose& pose = Pose::Identity()) {
  return importPart(std::filesystem::path(WCAM_TEST_DATA) / "formula" / name, {}, pose,
                    JobContext());
}

ImportedPart importText(const std::string& text) {
  const TemporaryFolder folder;
  writeBytes(folder / "part.wsurf", text);
  return importPart(folder / "part.wsurf", {}, Pose::Identity(), JobContext());
}

/// A file with this surface; ' stands for ".
std::string surfaceText(std::string surface) {
  std::replace(surface.begin(), surface.end(), '\'', '"');
  return "{\"format_version\": 1, \"surface\": {" + surface + "}}";
}

/// Calls `visit` at places all over every face of the part.
void sampleFaces(const PartSurface& part,
                 const std::function<void(const geometry::SurfacePoint&, const Vec3&)>& visit) {
  BrepEvaluator evaluator(*part.brep);
  constexpr int kSamples = 37;  // no divisor of a power of two: between the nodes of the spline
  for (int f = 0; f < part.brep->faceCount(); ++f) {
    const auto& b = part.brep->face(f).uvBounds;
    for (int i = 1; i < kSamples; ++i) {
      for (int j = 0; j <= kSamples; ++j) {
        const Vec2 uv(b[0] + (b[1] - b[0]) * i / kSamples, b[2] + (b[3] - b[2]) * j / kSamples);
        visit(evaluator.surface(f, uv), evaluator.normal(f, uv));
      }
    }
  }
}

long eulerCharacteristic(const PartSurface& s) {
  return static_cast<long>(s.mesh.vertices.size()) - static_cast<long>(s.halfEdges.edgeCount()) +
         static_cast<long>(s.mesh.triangles.size());
}

TEST(FormulaSurface, EveryPartIsMetToTheStatedAccuracy) {
  for (const char* name : {"p1_hemisphere", "p2_half_catenoid", "p3_nozzle", "p4_quarter_torus",
                           "p4_torus_150", "p6_tube", "p6_tube_extended"}) {
    SCOPED_TRACE(name);
    const ImportedPart part = importFormula(std::string(name) + ".wsurf");
    ASSERT_TRUE(part.report.formulaDeviation.has_value());
    EXPECT_LE(*part.report.formulaDeviation, 1e-7 * part.report.bounds.diagonal());
    EXPECT_EQ(part.report.format, "formula");
    EXPECT_EQ(part.report.components, 1U);
    EXPECT_EQ(part.report.nonManifoldEdges, 0U);
    EXPECT_TRUE(part.surface->exact());
    EXPECT_TRUE(part.report.toValue().contains("formula_deviation_mm"));
  }
}

TEST(FormulaSurface, HemisphereHasItsPoleAndItsNormals) {
  const ImportedPart part = importFormula("p1_hemisphere.wsurf");
  EXPECT_EQ(part.report.borders.size(), 1U);
  EXPECT_EQ(eulerCharacteristic(*part.surface), 1);  // a disc
  EXPECT_NEAR(part.report.bounds.max.z(), 45.0, 1e-12);
  sampleFaces(*part.surface, [](const geometry::SurfacePoint& s, const Vec3& n) {
    EXPECT_NEAR(s.p.norm(), 45.0, 1e-6);
    if (s.p.z() < 44.99) {
      EXPECT_NEAR((n - s.p / 45.0).norm(), 0.0, 1e-5);
    }
  });
}

TEST(FormulaSurface, HalfCatenoidHasItsRadii) {
  const ImportedPart part = importFormula("p2_half_catenoid.wsurf");
  EXPECT_EQ(part.report.borders.size(), 2U);
  EXPECT_EQ(eulerCharacteristic(*part.surface), 0);  // a ring
  double least = 1e9;
  double most = 0.0;
  sampleFaces(*part.surface, [&](const geometry::SurfacePoint& s, const Vec3&) {
    const double r = std::hypot(s.p.x(), s.p.y());
    EXPECT_NEAR(std::hypot(90.0 - r, s.p.z()), 45.0, 1e-6);
    least = std::min(least, r);
    most = std::max(most, r);
  });
  EXPECT_NEAR(least, 45.0, 1e-9);  // AT-19
  EXPECT_NEAR(most, 90.0, 1e-9);
}

TEST(FormulaSurface, NozzleIsOnePieceAcrossItsThroat) {
  const ImportedPart part = importFormula("p3_nozzle.wsurf");
  EXPECT_EQ(part.surface->brep->faceCount(), 3);
  EXPECT_EQ(part.report.borders.size(), 2U);
  EXPECT_EQ(eulerCharacteristic(*part.surface), 0);
  // AT-18: radii at the ends and on both sides of the throat, and the length of the profile.
  std::vector<double> atEnds;
  double length = 0.0;
  BrepEvaluator evaluator(*part.surface->brep);
  for (int f = 0; f < 3; ++f) {
    if (part.surface->brep->face(f).surfaceType == "plane") {
      continue;  // the ring at the throat
    }
    const auto& b = part.surface->brep->face(f).uvBounds;
    constexpr int kSteps = 20000;
    Vec3 last = evaluator.surface(f, Vec2(b[0], b[2])).p;
    atEnds.push_back(last.head<2>().norm());
    for (int i = 1; i <= kSteps; ++i) {
      const Vec3 p = evaluator.surface(f, Vec2(b[0], b[2] + (b[3] - b[2]) * i / kSteps)).p;
      length += (p - last).norm();
      last = p;
    }
    atEnds.push_back(last.head<2>().norm());
  }
  std::sort(atEnds.begin(), atEnds.end());
  EXPECT_NEAR(atEnds.front(), 8.307, 1e-3);
  EXPECT_NEAR(atEnds[1], 8.367, 1e-3);
  EXPECT_NEAR(atEnds[2], 16.062, 1e-3);
  EXPECT_NEAR(atEnds[3], 44.721, 1e-3);
  // With the jump of the radius at the throat.
  EXPECT_NEAR(length + atEnds[1] - atEnds[0], 136.757, 2e-3);
  sampleFaces(*part.surface, [](const geometry::SurfacePoint& s, const Vec3& n) {
    if (s.p.z() < 96.49 || s.p.z() > 96.51) {
      EXPECT_GT(n.head<2>().dot(s.p.head<2>()), 0.0);
    }
  });
}

TEST(FormulaSurface, TorusHasItsSeamAndItsNormals) {
  const ImportedPart part = importFormula("p4_quarter_torus.wsurf");
  EXPECT_EQ(part.report.borders.size(), 2U);
  EXPECT_EQ(eulerCharacteristic(*part.surface), 0);
  sampleFaces(*part.surface, [](const geometry::SurfacePoint& s, const Vec3& n) {
    const Vec3 centre = 50.0 * Vec3(s.p.x() + 50.0, 0.0, s.p.z()).normalized() - Vec3(50, 0, 0);
    EXPECT_NEAR((s.p - centre).norm(), 15.0, 1e-6);
    EXPECT_NEAR((n - (s.p - centre) / 15.0).norm(), 0.0, 1e-6);
  });
}

TEST(FormulaSurface, GeneralTubeHasTheNumbersOfTheThesis) {
  const auto guide =
      geometry::guideFromFormula({"(0.005*t^3-0.22*t^2)/6", "0.02*t^2", "t"}, 0.0, 40.0);
  const auto radius = [](double t) { return 5.0 + std::cos(8.0 * kPi * t / 40.0); };
  // AT-12, first half.
  EXPECT_NEAR((guide->evaluate(40.0).p - Vec3(-16.0 / 3.0, 32.0, 40.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(geometry::arcLength(*guide, 0.0, 40.0), 56.154, 1e-3);
  double most = 0.0;
  double least = 1.0;
  for (int i = 0; i <= 4000; ++i) {
    const double t = 40.0 * i / 4000.0;
    const geometry::CurvePoint g = guide->evaluate(t);
    const double curvature = g.d1.cross(g.d2).norm() / std::pow(g.d1.norm(), 3);
    most = std::max(most, curvature);
    least = std::min(least, 1.0 - curvature * radius(t));
  }
  EXPECT_NEAR(most, std::hypot(0.44 / 6.0, 0.04), 1e-9);  // at t = 0
  EXPECT_NEAR(most, 0.08351, 3e-5);
  EXPECT_NEAR(least, 0.4989, 2e-4);

  const ImportedPart part = importFormula("p6_tube.wsurf");
  sampleFaces(*part.surface, [&](const geometry::SurfacePoint& s, const Vec3& n) {
    // The section's plane contains the point: find its parameter by bisection.
    double low = 0.0;
    double high = 40.0;
    for (int i = 0; i < 60; ++i) {
      const double t = 0.5 * (low + high);
      const geometry::CurvePoint g = guide->evaluate(t);
      ((s.p - g.p).dot(g.d1) > 0.0 ? low : high) = t;
    }
    const Vec3 spoke = s.p - guide->evaluate(low).p;
    EXPECT_NEAR(spoke.norm(), radius(low), 1e-6);
    EXPECT_GT(n.dot(spoke), 0.0);
  });
}

TEST(FormulaSurface, FrenetAndMinimalFramesGiveTheSameSurface) {
  const auto with = [](const std::string& frame) {
    return importText(surfaceText(
        "'type': 'tube', 'guide': {'x': '10*cos(t)', 'y': '10*sin(t)', 'z': '4*t', 't': [0, 5]}, "
        "'radius': '2', 'frame': '" +
        frame + "'"));
  };
  const ImportedPart a = with("frenet");
  const ImportedPart b = with("minimal");
  EXPECT_NEAR(a.report.area, b.report.area, 2e-3 * a.report.area);
  EXPECT_LE(*a.report.formulaDeviation, 1e-6);
  EXPECT_LE(*b.report.formulaDeviation, 1e-6);
}

TEST(FormulaSurface, APlacementMovesItAndFlipTurnsItOver) {
  Pose pose = Pose::Identity();
  pose.translate(Vec3(1, 2, 3));
  const ImportedPart part = importFormula("p1_hemisphere.wsurf", pose);
  sampleFaces(*part.surface, [](const geometry::SurfacePoint& s, const Vec3&) {
    EXPECT_NEAR((s.p - Vec3(1, 2, 3)).norm(), 45.0, 1e-6);
  });
  const ImportedPart inner =
      importText(surfaceText("'type': 'revolution', 'radius': 5, 'z': [0, 9], 'flip': true"));
  sampleFaces(*inner.surface, [](const geometry::SurfacePoint& s, const Vec3& n) {
    EXPECT_LT(n.dot(Vec3(s.p.x(), s.p.y(), 0.0)), 0.0);
  });
}

struct BadFile {
  const char* text;  ///< the whole file, or only its surface when it begins with '
  const char* message;
};

class BadFormulaFile : public testing::TestWithParam<BadFile> {};

TEST_P(BadFormulaFile, IsRefusedNamingThePlace) {
  const std::string given = GetParam().text;
  try {
    static_cast<void>(importText(given.front() == '\'' ? surfaceText(given) : given));
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::InputInvalid);
    EXPECT_THAT(error.what(), testing::HasSubstr("part.wsurf"));
    EXPECT_THAT(error.what(), testing::HasSubstr(GetParam().message));
  }
}

INSTANTIATE_TEST_SUITE_P(
    All,
    BadFormulaFile,
    testing::Values(
        BadFile{"{}", "lacks \"format_version\""},
        BadFile{"{\"format_version\": 2, \"surface\": {}}", "format_version other than 1"},
        BadFile{"[1]", "does not start like one"},
        BadFile{"{\"format_version\": 1, \"surface\": 3}", "type of the surface"},
        BadFile{"'type': 'ball'", "type of the surface"},
        BadFile{"'type': 'revolution', 'radius': '5+', 'z': [0, 1]", "surface.radius = 5+"},
        BadFile{"'type': 'revolution', 'radius': 'foo(z)', 'z': [0, 1]", "position 1"},
        BadFile{"'type': 'revolution', 'radius': '5', 'z': [1, 0]", "ascending range"},
        BadFile{"'type': 'revolution', 'radius': '5', 'z': [0, 1], 'k': 1", "unknown key \"k\""},
        BadFile{"'type': 'revolution', 'radius': 'z-2', 'z': [0, 4]",
                "the radius is -2.000000 at z = 0.000000"},
        BadFile{"'type': 'revolution', 'radius': [{'z': [0, 4], 'radius': '3'}, "
                "{'z': [5, 6], 'radius': '3'}]",
                "must begin where the piece before it ends"},
        BadFile{"'type': 'tube', 'guide': {'x': '0', 'y': 't^', 'z': 't', 't': [0, 4]}, "
                "'radius': '1'",
                "guide formula y(t) = t^"},
        BadFile{"'type': 'tube', 'guide': {'x': '0', 'y': '0', 'z': 't', 't': [0, 4]}, "
                "'radius': '1', 'frame': 'frenet'",
                "straight at t"},
        BadFile{"'type': 'tube', 'guide': {'x': '5*cos(t)', 'y': '5*sin(t)', 'z': '0', "
                "'t': [0, 3]}, 'radius': '6'",
                "the tube folds"},
        BadFile{"'type': 'tube', 'guide': {'x': '0', 'y': '0', 'z': 't', 't': [0, 4]}, "
                "'radius': 't-1'",
                "the radius is"},
        BadFile{"'type': 'parametric', 'x': '1/u', 'y': 'v', 'z': '0', 'u': [0, 1], 'v': [0, 1]",
                "no finite value at u = 0"},
        BadFile{"'type': 'parametric', 'x': 'cos(v)', 'y': 'sin(v)', 'z': 'u', 'u': [0, 1], "
                "'v': [0, 6], 'closed_v': true",
                "not closed in v"},
        BadFile{"'type': 'parametric', 'x': 'abs(u)', 'y': 'v', 'z': 'u', 'u': [-1, 1.1], "
                "'v': [0, 1]",
                "cannot be met exactly"},
        BadFile{"'type': 'parametric', 'x': '1', 'y': '1', 'z': '1', 'u': [0, 1], 'v': [0, 1]",
                "single point"}));

std::string refusalOf(const std::string& surface) {
  try {
    (void)importText(surfaceText(surface));
  } catch (const Error& error) {
    return std::string(error.what()) + " | " + error.hint();
  }
  return {};
}

TEST(FormulaSurface, ARoundedEndIsCutBackToTheFormula) {
  for (const char* end : {"38.0000001", "38.00001", "'38*(1+1e-15)'", "38"}) {
    SCOPED_TRACE(end);
    const ImportedPart part = importText(surfaceText(
        "'type': 'revolution', 'radius': 'sqrt(38^2-z^2)', 'z': [0, " + std::string(end) + "]"));
    // The area is that of the tessellation.
    EXPECT_NEAR(part.report.area / (2.0 * kPi * 38.0 * 38.0), 1.0, 1e-3);
    // Its pole is closed: one border, the equator.
    EXPECT_EQ(part.report.borders.size(), 1U);
    EXPECT_LE(*part.report.formulaDeviation, 2e-5);
  }
  // A real overshoot is refused, and no word of a radius that is negative.
  const std::string refused =
      refusalOf("'type': 'revolution', 'radius': 'sqrt(38^2-z^2)', 'z': [0, 38.1]");
  EXPECT_THAT(refused, testing::HasSubstr("has no value at z"));
  EXPECT_THAT(refused, testing::HasSubstr("root of a negative number"));
  EXPECT_THAT(refusalOf("'type': 'revolution', 'radius': '20/(z-5)', 'z': [5, 30]"),
              testing::HasSubstr("division by zero"));
}

TEST(FormulaSurface, NearlyClosedIsClosedAndTheTrueGapIsSaid) {
  const auto tube = [](const char* end) {
    return "'type': 'parametric', 'x': '25*cos(u)', 'y': '25*sin(u)', 'z': 'v', 'u': [0, " +
           std::string(end) + "], 'v': [0, 12], 'closed_u': true";
  };
  const ImportedPart part = importText(surfaceText(tube("6.2831853")));
  EXPECT_EQ(part.report.borders.size(), 2U);
  EXPECT_NEAR(*part.report.formulaDeviation, 25.0 * (2.0 * kPi - 6.2831853), 1e-9);
  // 25·(2π − 6.28) = 0.0796 mm along y; along x only 0.000127.
  EXPECT_THAT(refusalOf(tube("6.28")), testing::HasSubstr("0.07963 mm apart"));
}

TEST(FormulaSurface, PiecesMayLieATraceApart) {
  const ImportedPart part =
      importText(surfaceText("'type': 'revolution', 'radius': [{'z': [0, 8], 'radius': 20}, "
                             "{'z': [8.0000001, 16], 'radius': 20}]"));
  EXPECT_EQ(part.report.borders.size(), 2U);
  EXPECT_THAT(refusalOf("'type': 'revolution', 'radius': [{'z': [0, 8], 'radius': 20}, "
                        "{'z': [8.01, 16], 'radius': 20}]"),
              testing::HasSubstr("0.01 mm from there"));
}

TEST(FormulaSurface, ADecimalCommaInAListOfValuesIsRefused) {
  for (const char* radius : {"max(10, 20+0,3*z)", "min(25,5, 30)", "sum(1,5)", "2*avg(20,30)"}) {
    SCOPED_TRACE(radius);
    EXPECT_THAT(
        refusalOf("'type': 'revolution', 'z': [0, 9], 'radius': '" + std::string(radius) + "'"),
        testing::HasSubstr("decimal comma"));
  }
  EXPECT_EQ(refusalOf("'type': 'revolution', 'z': [0, 9], 'radius': 'max(10, 20+0.3*z)'"), "");
  EXPECT_EQ(refusalOf("'type': 'revolution', 'z': [0, 9], 'radius': '20+atan2(1,2)'"), "");
}

TEST(FormulaSurface, NearlyExactIsTakenAndReported) {
  // The profile's curvature jumps at z = 1.3: splines come near, but not to 1e-7 of the size.
  const JobContext context;
  const TemporaryFolder folder;
  writeBytes(folder / "part.wsurf",
             surfaceText("'type': 'revolution', 'radius': '20+abs(z-1.3)*(z-1.3)', 'z': [0, 8]"));
  const ImportedPart part = importPart(folder / "part.wsurf", {}, Pose::Identity(), context);
  double reported = 0.0;
  for (const Diagnostic& item : context.diagnostics().items()) {
    if (item.code == "import.formula_deviation") {
      reported = item.data.at(0).second;
    }
  }
  EXPECT_GT(reported, 1e-6);
  EXPECT_LE(reported, 1e-4);
  double worst = 0.0;
  sampleFaces(*part.surface, [&](const geometry::SurfacePoint& s, const Vec3&) {
    const double z = s.p.z() - 1.3;
    worst = std::max(worst, std::abs(std::hypot(s.p.x(), s.p.y()) - 20.0 - std::abs(z) * z));
  });
  EXPECT_LE(worst, 1e-4);
}

}  // namespace
}  // namespace wcam::io
