// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"
#include "wcam/base/json.hpp"
#include "wcam/io/import.hpp"

#include "io_files.hpp"
#include "zip_file.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

namespace wcam::io {
namespace {

using geometry::Pose;
using geometry::TriangleMesh;
using geometry::Vec3;
using test::TemporaryFolder;
using testing::HasSubstr;

const std::filesystem::path kProjects = std::filesystem::path(WCAM_RESOURCES) / "projects";
const std::filesystem::path kData = WCAM_TEST_DATA;

ImportedPart importFile(const std::filesystem::path& file,
                        const ImportOptions& options = {},
                        const JobContext& context = JobContext()) {
  return importPart(file, options, Pose::Identity(), context);
}

std::string number(double x) {
  return formatReal(x);
}

std::string objText(const TriangleMesh& mesh) {
  std::string text = "# box\no body\n";
  for (const Vec3& p : mesh.vertices) {
    text += "v " + number(p.x()) + " " + number(p.y()) + " " + number(p.z()) + "\n";
  }
  for (const auto& t : mesh.triangles) {
    text += "f";
    for (const std::uint32_t v : t) {
      text += " " + std::to_string(v + 1) + "//1";
    }
    text += "\n";
  }
  return text;
}

template <class T>
void put(std::string& bytes, T value, bool bigEndian) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (bigEndian) {
    std::reverse(raw, raw + sizeof(T));
  }
  bytes.append(raw, sizeof(T));
}

std::string plyHeader(const TriangleMesh& mesh, const char* format) {
  return std::string("ply\nformat ") + format + " 1.0\ncomment test\nelement vertex " +
         std::to_string(mesh.vertices.size()) +
         "\nproperty double x\nproperty uchar red\nproperty double y\nproperty double z\n"
         "element face " +
         std::to_string(mesh.triangles.size()) +
         "\nproperty list uchar int vertex_indices\nelement extra 1\nproperty list int float q\n"
         "end_header\n";
}

std::string binaryPly(const TriangleMesh& mesh, bool bigEndian) {
  std::string bytes = plyHeader(mesh, bigEndian ? "binary_big_endian" : "binary_little_endian");
  for (const Vec3& p : mesh.vertices) {
    put(bytes, p.x(), bigEndian);
    put(bytes, std::uint8_t{200}, bigEndian);
    put(bytes, p.y(), bigEndian);
    put(bytes, p.z(), bigEndian);
  }
  for (const auto& t : mesh.triangles) {
    put(bytes, std::uint8_t{3}, bigEndian);
    for (const std::uint32_t v : t) {
      put(bytes, static_cast<std::int32_t>(v), bigEndian);
    }
  }
  put(bytes, std::int32_t{2}, bigEndian);
  put(bytes, 1.0F, bigEndian);
  put(bytes, 2.0F, bigEndian);
  return bytes;
}

std::string asciiPly(const TriangleMesh& mesh) {
  std::string text = plyHeader(mesh, "ascii");
  for (const Vec3& p : mesh.vertices) {
    text += number(p.x()) + " 200 " + number(p.y()) + " " + number(p.z()) + "\n";
  }
  for (const auto& t : mesh.triangles) {
    text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) +
            "\n";
  }
  return text + "2 1 2";
}

void expectTorus(const ImportedPart& part, const char* format) {
  SCOPED_TRACE(format);
  const TriangleMesh torus = test::torusMesh(30, 20, 50, 15);
  EXPECT_EQ(part.report.format, format);
  EXPECT_EQ(part.report.vertices, torus.vertices.size());
  EXPECT_EQ(part.report.triangles, torus.triangles.size());
  EXPECT_TRUE(part.report.closed);
  EXPECT_FALSE(part.surface->exact());
  EXPECT_NEAR(*part.report.volume / test::signedVolume(torus), 1.0, 1e-6);
}

TEST(MeshImport, EveryFormatGivesTheSameTorus) {
  const TemporaryFolder folder;
  const TriangleMesh torus = test::torusMesh(30, 20, 50, 15);
  test::writeBytes(folder / "a.stl", test::binaryStl(torus));
  expectTorus(importFile(folder / "a.stl"), "STL");
  test::writeBytes(folder / "a.obj", objText(torus));
  expectTorus(importFile(folder / "a.obj"), "OBJ");
  EXPECT_EQ(importFile(folder / "a.obj").report.bodies[0].name, "body");
  test::writeBytes(folder / "a.ply", asciiPly(torus));
  expectTorus(importFile(folder / "a.ply"), "PLY");
  test::writeBytes(folder / "b.ply", binaryPly(torus, false));
  expectTorus(importFile(folder / "b.ply"), "PLY");
  test::writeBytes(folder / "c.ply", binaryPly(torus, true));
  expectTorus(importFile(folder / "c.ply"), "PLY");
  test::writeThreeMf(folder / "a.3mf", torus, "millimeter");
  expectTorus(importFile(folder / "a.3mf"), "3MF");
}

TEST(MeshImport, ContentCountsMoreThanTheExtension) {
  const TemporaryFolder folder;
  test::writeBytes(folder / "a.step", test::binaryStl(test::torusMesh(30, 20, 50, 15)));
  expectTorus(importFile(folder / "a.step"), "STL");
  test::writeBytes(folder / "noextension", asciiPly(test::torusMesh(30, 20, 50, 15)));
  expectTorus(importFile(folder / "noextension"), "PLY");
}

TEST(MeshImport, ObjPolygonsAndRelativeIndices) {
  const TemporaryFolder folder;
  test::writeBytes(folder / "a.obj",
                   "mtllib x.mtl\nv 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 0 0 10\nv 10 0 10\n"
                   "v 10 10 10\nv 0 10 10\nvt 0 0\nvn 0 0 1\nusemtl m\ns off\nl 1 2\n"
                   "f 1/1/1 4/1/1 3/1/1 2/1/1\nf -4 -3 -2 -1\nf 1 2 6 5\nf 2 3 7 \\\n 6\n"
                   "f 3 4 8 7\nf 4 1 5 8\n");
  const ImportedPart part = importFile(folder / "a.obj");
  EXPECT_TRUE(part.report.closed);
  EXPECT_EQ(part.report.triangles, 12U);
  EXPECT_NEAR(*part.report.volume, 1000.0, 1e-9);
}

TEST(MeshImport, UnitsAreGuessedAndTold) {
  const TemporaryFolder folder;
  test::writeBytes(folder / "small.stl",
                   test::binaryStl(test::boxMesh(Vec3(0, 0, 0), Vec3(0.5, 1.0, 1.9))));
  test::writeBytes(folder / "large.stl",
                   test::binaryStl(test::boxMesh(Vec3(0, 0, 0), Vec3(0.5, 1.0, 2.0))));
  const JobContext context;
  const ImportedPart small = importFile(folder / "small.stl", {}, context);
  EXPECT_EQ(small.report.unit, "m");
  EXPECT_NEAR(small.report.bounds.max.z(), 1900.0, 1e-3);
  EXPECT_THAT(small.report.unitReason.str(), HasSubstr("less than 2"));
  EXPECT_EQ(context.diagnostics().count("import.units_guessed"), 1U);
  EXPECT_EQ(context.diagnostics().count(Severity::Warning), 1U);
  EXPECT_EQ(importFile(folder / "large.stl").report.unit, "mm");
  ImportOptions options;
  for (const auto& [unit, factor] : {std::pair{FileUnit::Millimetre, 1.0},
                                     {FileUnit::Centimetre, 10.0},
                                     {FileUnit::Metre, 1000.0},
                                     {FileUnit::Inch, 25.4}}) {
    options.unit = unit;
    const JobContext quiet;
    const ImportedPart part = importFile(folder / "large.stl", options, quiet);
    EXPECT_NEAR(part.report.bounds.max.z(), 2.0 * factor, 1e-9);
    EXPECT_EQ(quiet.diagnostics().count("import.units_guessed"), 0U);
  }
}

TEST(MeshImport, PlacementIsApplied) {
  const TemporaryFolder folder;
  test::writeBytes(folder / "a.stl", test::binaryStl(test::boxMesh(Vec3(0, 0, 0), Vec3(1, 2, 3))));
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(kPi / 2, Vec3::UnitZ()).toRotationMatrix();
  pose.translation() = Vec3(10, 20, 30);
  const ImportedPart part = importPart(folder / "a.stl", {}, pose, JobContext());
  EXPECT_NEAR((part.report.bounds.min - Vec3(8, 20, 30)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((part.report.bounds.max - Vec3(10, 21, 33)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(*part.report.volume, 6.0, 1e-9);
}

TEST(MeshImport, RepairsAreTold) {
  const TemporaryFolder folder;
  TriangleMesh mesh = test::boxMesh(Vec3(0, 0, 0), Vec3(10, 20, 30));
  std::swap(mesh.triangles[4][1], mesh.triangles[4][2]);
  mesh.triangles.push_back(mesh.triangles[0]);
  mesh.triangles.push_back({2, 2, 3});
  test::writeBytes(folder / "a.stl", test::binaryStl(mesh));
  const JobContext context;
  const ImportedPart part = importFile(folder / "a.stl", {}, context);
  EXPECT_TRUE(part.report.closed);
  EXPECT_NEAR(*part.report.volume, 6000.0, 1e-9);
  EXPECT_EQ(part.report.degenerateTriangles, 1U);
  EXPECT_EQ(part.report.duplicateTriangles, 1U);
  EXPECT_EQ(part.report.reorientedTriangles, 1U);
  for (const char* code : {"import.welded", "import.degenerate_dropped", "import.duplicate_dropped",
                           "import.reoriented"}) {
    EXPECT_EQ(context.diagnostics().count(code), 1U) << code;
  }
  ImportOptions raw;
  raw.repair = false;
  const ImportedPart asIs = importFile(folder / "a.stl", raw);
  EXPECT_EQ(asIs.report.triangles, 14U);
  EXPECT_FALSE(asIs.report.closed);
}

TEST(MeshImport, GapsOfSinglePrecisionAreClosed) {
  const TemporaryFolder folder;
  // Two halves of a torus whose common border differs in the last digit.
  TriangleMesh torus = test::torusMesh(30, 20, 50, 15);
  std::string bytes = test::binaryStl(torus);
  for (std::size_t t = 0; t < torus.triangles.size() / 2; ++t) {
    for (int k = 0; k < 9; ++k) {
      float x = 0.0F;
      char* at = bytes.data() + 84 + 50 * t + 12 + 4 * k;
      std::memcpy(&x, at, 4);
      x = std::nextafter(x, 1e9F);
      std::memcpy(at, &x, 4);
    }
  }
  test::writeBytes(folder / "a.stl", bytes);
  const ImportedPart part = importFile(folder / "a.stl");
  EXPECT_TRUE(part.report.closed);
  EXPECT_EQ(part.report.vertices, torus.vertices.size());
}

TEST(MeshImport, WeldToleranceOfTheUserClosesWiderGaps) {
  const TemporaryFolder folder;
  TriangleMesh mesh = test::boxMesh(Vec3(0, 0, 0), Vec3(10, 10, 10));
  mesh.vertices.push_back(mesh.vertices[7] + Vec3(0.05, 0, 0));
  mesh.triangles.back()[1] = 8;
  test::writeBytes(folder / "a.stl", test::binaryStl(mesh));
  EXPECT_FALSE(importFile(folder / "a.stl").report.closed);
  ImportOptions options;
  options.weldTolerance = Length(0.1);
  EXPECT_TRUE(importFile(folder / "a.stl", options).report.closed);
}

TEST(MeshImport, OpenAndNonManifoldSurfacesAreTold) {
  const TemporaryFolder folder;
  TriangleMesh mesh = test::boxMesh(Vec3(0, 0, 0), Vec3(10, 10, 10));
  mesh.vertices.push_back(Vec3(20, 20, 5));
  mesh.triangles.push_back({3, 7, 8});
  test::writeBytes(folder / "a.stl", test::binaryStl(mesh));
  const JobContext context;
  const ImportedPart part = importFile(folder / "a.stl", {}, context);
  EXPECT_EQ(part.report.nonManifoldEdges, 1U);
  EXPECT_FALSE(part.report.closed);
  EXPECT_EQ(part.report.components, 1U);
  bool found = false;
  for (const Diagnostic& d : context.diagnostics().items()) {
    if (d.code == "import.non_manifold") {
      found = true;
      EXPECT_EQ(d.severity, Severity::Warning);
      EXPECT_THAT(d.message, HasSubstr("(10.0, 10.0, 5.0)"));
    }
  }
  EXPECT_TRUE(found);
}

TEST(MeshImport, ThreeMfUnitsComponentsTransformsAndOtherParts) {
  const TemporaryFolder folder;
  const std::string box = test::threeMfMesh(test::boxMesh(Vec3(0, 0, 0), Vec3(1, 2, 3)));
  const std::string model =
      "<?xml version=\"1.0\"?><model unit=\"inch\" xmlns=\"http://schemas.microsoft.com/"
      "3dmanufacturing/core/2015/02\" xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/"
      "production/2015/06\"><resources><basematerials id=\"9\"><base name=\"red\" "
      "displaycolor=\"#FF0000FF\"/></basematerials>"
      "<object id=\"1\" name=\"Stück\" pid=\"9\" pindex=\"0\">" +
      box +
      "</object><object id=\"2\"><components><component objectid=\"1\" transform=\"1 0 0 0 1 0 0 "
      "0 1 10 0 0\"/><component objectid=\"5\" p:path=\"/3D/other.model\"/></components></object>"
      "<object id=\"3\" type=\"support\">" +
      box +
      "</object></resources><build><item objectid=\"2\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 5\"/>"
      "<item objectid=\"3\"/></build></model>";
  const std::string other =
      "<model unit=\"inch\"><resources><object id=\"5\">" + box + "</object></resources></model>";
  test::writeZip(folder / "a.3mf", {{"_rels/.rels", test::threeMfRelations("/3D/root.model")},
                                    {"3D/root.model", model},
                                    {"3D/other.model", other}});
  const ImportedPart part = importFile(folder / "a.3mf");
  EXPECT_EQ(part.report.unit, "inch");
  EXPECT_EQ(part.report.components, 2U);
  EXPECT_TRUE(part.report.closed);
  const double inch = 25.4;
  EXPECT_NEAR(*part.report.volume, 12.0 * inch * inch * inch, 1e-6);
  EXPECT_NEAR((part.report.bounds.min - inch * Vec3(-11, 0, 5)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((part.report.bounds.max - inch * Vec3(0, 2, 8)).norm(), 0.0, 1e-9);
  ASSERT_EQ(part.report.bodies.size(), 2U);
  EXPECT_EQ(part.report.bodies[0].name, "Stück");
  EXPECT_EQ(part.report.bodies[0].colour, "#FF0000");
}

TEST(MeshImport, FilesOfOtherProjects) {
  const ImportedPart branches =
      importFile(kProjects / "branches" / "branches_70_closed_low_res.stl");
  EXPECT_TRUE(branches.report.closed);
  EXPECT_EQ(branches.report.triangles, 6232U);
  EXPECT_EQ(branches.report.components, 1U);
  const ImportedPart dome = importFile(kData / "ram" / "dome.ply");
  EXPECT_EQ(dome.report.unit, "m");
  EXPECT_EQ(dome.report.borders.size(), 1U);
  EXPECT_NEAR(dome.report.borders[0].length, 40.0 * kPi, 0.5);
  const ImportedPart wall = importFile(kData / "ram" / "inclined_wall.stl");
  EXPECT_TRUE(wall.report.closed);
  EXPECT_NEAR(*wall.report.volume, 1.92e6, 10.0);
}

TEST(MeshImport, ReportIsCompleteJson) {
  const ImportedPart part = importFile(kData / "ram" / "dome.ply");
  const Value value = part.report.toValue();
  EXPECT_EQ(parseJson(toCanonicalJson(value)), value);
  EXPECT_EQ(value.at("triangles").asInteger(), 480);
  EXPECT_EQ(value.at("borders").size(), 1U);
  EXPECT_FALSE(value.contains("volume_mm3"));
}

TEST(MeshImport, OptionsAreDeclaredOnce) {
  const auto& schema = importOptionsSchema();
  const ImportOptions defaults = schema.read(Value::object());
  EXPECT_EQ(defaults.chordTolerance, ImportOptions().chordTolerance);
  EXPECT_EQ(defaults.unit, FileUnit::Auto);
  Value value = Value::object();
  value.set("unit", "in").set("chord_tolerance", 0.2).set("repair", false);
  const ImportOptions read = schema.read(value);
  EXPECT_EQ(read.unit, FileUnit::Inch);
  EXPECT_EQ(read.chordTolerance, Length(0.2));
  EXPECT_FALSE(read.repair);
  value.set("chord_tolerance", -1.0);
  EXPECT_THROW(static_cast<void>(schema.read(value)), Error);
}

TEST(MeshImport, TenMillionTriangles) {
  const TemporaryFolder folder;
  const auto file = folder / "large.stl";
  {
    const TriangleMesh torus = test::torusMesh(2500, 2000, 500, 150);
    test::writeBytes(file, test::binaryStl(torus));
  }
  const ImportedPart part = importFile(file);
  EXPECT_EQ(part.report.triangles, 10000000U);
  EXPECT_EQ(part.report.vertices, 5000000U);
  EXPECT_TRUE(part.report.closed);
  EXPECT_EQ(part.report.components, 1U);
  EXPECT_NEAR(*part.report.volume / (2 * kPi * kPi * 500 * 150 * 150), 1.0, 1e-5);

  struct rusage usage {};

  getrusage(RUSAGE_SELF, &usage);
  EXPECT_LT(usage.ru_maxrss, 3L * 1024 * 1024) << "KiB at the peak, test data included";
}

}  // namespace
}  // namespace wcam::io
