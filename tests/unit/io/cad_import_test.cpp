// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/io/import.hpp"

#include "cad_process.hpp"
#include "export_brep.hpp"
#include "io_files.hpp"
#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <BinTools.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TDF_Label.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gmock/gmock.h>
#include <gp_Ax2.hxx>
#include <gtest/gtest.h>

#include <Quantity_Color.hxx>

#include <sstream>
#include <thread>

namespace wcam::io {
namespace {

using geometry::BrepEvaluator;
using geometry::PartSurface;
using geometry::Pose;
using geometry::Vec2;
using geometry::Vec3;
using test::TemporaryFolder;

const std::filesystem::path kProjects = std::filesystem::path(WCAM_RESOURCES) / "projects";

ImportedPart importFile(const std::filesystem::path& file,
                        const ImportOptions& options = {},
                        const Pose& pose = Pose::Identity()) {
  return importPart(file, options, pose, JobContext());
}

void writeBrep(const TopoDS_Shape& shape, const std::filesystem::path& file) {
  ASSERT_TRUE(BRepTools::Write(shape, file.c_str()));
}

void writeIges(const TopoDS_Shape& shape, const std::filesystem::path& file) {
  IGESControl_Controller::Init();
  IGESControl_Writer writer("MM", 0);
  ASSERT_TRUE(writer.AddShape(shape));
  writer.ComputeModel();
  ASSERT_TRUE(writer.Write(file.c_str()));
}

/// V − E + F.
long eulerCharacteristic(const PartSurface& s) {
  return static_cast<long>(s.mesh.vertices.size()) - static_cast<long>(s.halfEdges.edgeCount()) +
         static_cast<long>(s.mesh.triangles.size());
}

/// Largest distance of corners and of edge parameters from their vertices.
struct BindingError {
  double corner = 0.0;
  double edge = 0.0;
  double normal = 0.0;  ///< 1 − cosine between exact and triangle normal
};

BindingError bindingError(const PartSurface& s) {
  const BrepEvaluator evaluator(*s.brep);
  BindingError error;
  for (std::size_t t = 0; t < s.mesh.triangles.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3& p = s.mesh.vertices[s.mesh.triangles[t][c]];
      const Vec3& q = s.mesh.vertices[s.mesh.triangles[t][(c + 1) % 3]];
      const Vec2& uv = s.binding.uv[t][c];
      const int face = s.binding.face[t];
      error.corner = std::max(error.corner, (evaluator.surface(face, uv).p - p).norm());
      error.normal = std::max(error.normal, 1.0 - evaluator.normal(face, uv).dot(s.mesh.normal(t)));
      const std::size_t h = 3 * t + c;
      if (s.binding.edge[h] >= 0) {
        const auto [a, b] = s.binding.edgeParam[h];
        error.edge = std::max({error.edge, (evaluator.curve(s.binding.edge[h], a).p - p).norm(),
                               (evaluator.curve(s.binding.edge[h], b).p - q).norm()});
      }
    }
  }
  return error;
}

/// Half-edges without twin lie on CAD edges, and those on CAD edges agree with their twins.
void expectEdgesBound(const PartSurface& s) {
  for (std::uint32_t h = 0; h < s.binding.edge.size(); ++h) {
    const std::uint32_t twin = s.halfEdges.twin(h);
    if (twin == geometry::HalfEdges::kNone) {
      EXPECT_GE(s.binding.edge[h], 0);
    } else {
      EXPECT_EQ(s.binding.edge[h], s.binding.edge[twin]);
      if (s.binding.face[h / 3] != s.binding.face[twin / 3]) {
        EXPECT_GE(s.binding.edge[h], 0);
      }
    }
  }
}

TEST(CadImport, ElbowIsTheTorusOfChalvin211) {
  const ImportedPart part = importFile(kProjects / "elbow" / "elbow.step");
  const PartSurface& s = *part.surface;
  EXPECT_EQ(part.report.format, "STEP");
  EXPECT_EQ(part.report.faces, 1);
  EXPECT_EQ(part.report.freeEdges, 1);
  EXPECT_FALSE(part.report.closed);
  EXPECT_EQ(part.report.components, 1U);
  ASSERT_EQ(part.report.borders.size(), 2U);
  // A polygon with sagitta e is shorter than its circle by e/(3r) of the length.
  EXPECT_NEAR(part.report.borders[0].length, 30.0 * kPi, 30.0 * kPi * 0.05 / (3.0 * 15.0));
  EXPECT_EQ(s.brep->face(0).surfaceType, "torus");
  EXPECT_EQ(s.brep->face(0).name, "elbow");
  for (const Vec3& p : s.mesh.vertices) {
    const double w = std::hypot(p.x() + 50.0, p.z()) - 50.0;
    EXPECT_NEAR(std::hypot(w, p.y()), 15.0, 1e-9);
    EXPECT_GE(p.z(), -1e-9);
    EXPECT_GE(p.x(), -50.0 - 1e-9);
  }
  const BindingError error = bindingError(s);
  EXPECT_LT(error.corner, 1e-9);
  EXPECT_LT(error.edge, 1e-9);
  EXPECT_LT(error.normal, 0.01);
  expectEdgesBound(s);
}

TEST(CadImport, ElbowNormalPointsAwayFromTheGuide) {
  const ImportedPart part = importFile(kProjects / "elbow" / "elbow.step");
  const BrepEvaluator evaluator(*part.surface->brep);
  for (const double v : {0.0, 1.0, 2.0, 4.0}) {
    const auto q = evaluator.surface(0, Vec2(0.3, v));
    const Vec3 centre = Vec3(50.0 * std::cos(0.3) - 50.0, 0.0, 50.0 * std::sin(0.3));
    EXPECT_NEAR((evaluator.normal(0, Vec2(0.3, v)) - (q.p - centre) / 15.0).norm(), 0.0, 1e-12);
  }
}

TEST(CadImport, ElbowGuideIsAnExactFreeEdge) {
  const ImportedPart part = importFile(kProjects / "elbow" / "elbow.step");
  const geometry::Brep& brep = *part.surface->brep;
  int guide = -1;
  for (int e = 0; e < brep.edgeCount(); ++e) {
    if (brep.edge(e).faceCount == 0) {
      guide = e;
    }
  }
  ASSERT_GE(guide, 0);
  EXPECT_EQ(brep.edge(guide).name, "guide");
  EXPECT_NEAR(brep.edge(guide).length, 25.0 * kPi, 1e-9);
  const BrepEvaluator evaluator(brep);
  const auto [begin, end] = brep.edge(guide).range;
  EXPECT_NEAR(evaluator.curve(guide, begin).p.norm(), 0.0, 1e-9);
  EXPECT_NEAR((evaluator.curve(guide, begin).d1.normalized() - Vec3::UnitZ()).norm(), 0.0, 1e-12);
  EXPECT_NEAR((evaluator.curve(guide, end).p - Vec3(-50, 0, 50)).norm(), 0.0, 1e-9);
  for (int i = 0; i <= 100; ++i) {
    const auto p = evaluator.curve(guide, begin + (end - begin) * i / 100.0);
    EXPECT_NEAR(std::hypot(p.p.x() + 50.0, p.p.z()), 50.0, 1e-9);
    EXPECT_NEAR(p.p.y(), 0.0, 1e-9);
    const double curvature = p.d1.cross(p.d2).norm() / std::pow(p.d1.norm(), 3);
    EXPECT_NEAR(1.0 / curvature, 50.0, 1e-9);
  }
}

TEST(CadImport, HemisphereIsAnOpenShell) {
  const ImportedPart part = importFile(kProjects / "hemisphere" / "hemisphere.step");
  const PartSurface& s = *part.surface;
  ASSERT_EQ(part.report.borders.size(), 1U);
  EXPECT_NEAR(part.report.borders[0].length, 90.0 * kPi, 90.0 * kPi * 0.05 / (3.0 * 45.0));
  EXPECT_EQ(eulerCharacteristic(s), 1);
  for (const Vec3& p : s.mesh.vertices) {
    EXPECT_NEAR(p.norm(), 45.0, 1e-9);
    EXPECT_GE(p.z(), -1e-9);
  }
  const BindingError error = bindingError(s);
  EXPECT_LT(error.corner, 1e-9);
  EXPECT_LT(error.edge, 1e-9);
}

TEST(CadImport, ForeignSolidIsWatertight) {
  const ImportedPart part = importFile(kProjects / "supportless" / "supportless_sample.stp");
  EXPECT_TRUE(part.report.closed);
  EXPECT_GT(*part.report.volume, 0.0);
  EXPECT_EQ(part.report.nonManifoldEdges, 0U);
  EXPECT_EQ(part.report.faces, 23);
}

struct Solid {
  const char* name;
  TopoDS_Shape shape;
  long euler;
  double volume;
};

std::vector<Solid> solids() {
  return {
      {"box", BRepPrimAPI_MakeBox(10, 20, 30), 2, 6000},
      {"cylinder", BRepPrimAPI_MakeCylinder(10, 30), 2, kPi * 100 * 30},
      {"cone", BRepPrimAPI_MakeCone(10, 0, 30), 2, kPi * 100 * 30 / 3},
      {"sphere", BRepPrimAPI_MakeSphere(20), 2, 4.0 / 3.0 * kPi * 8000},
      {"torus", BRepPrimAPI_MakeTorus(50, 15), 0, 2 * kPi * kPi * 50 * 225},
      {"half cylinder", BRepPrimAPI_MakeCylinder(10, 30, kPi), 2, kPi * 50 * 30},
  };
}

void expectClosedSolid(const Solid& solid, const ImportedPart& part) {
  SCOPED_TRACE(solid.name);
  const PartSurface& s = *part.surface;
  EXPECT_TRUE(s.halfEdges.closed());
  EXPECT_EQ(part.report.components, 1U);
  EXPECT_EQ(eulerCharacteristic(s), solid.euler);
  ASSERT_TRUE(part.report.volume.has_value());
  EXPECT_NEAR(*part.report.volume / solid.volume, 1.0, 0.01);
  const BindingError error = bindingError(s);
  EXPECT_LT(error.corner, 1e-9);
  EXPECT_LT(error.edge, 1e-9);
  EXPECT_LT(error.normal, 0.05);
  expectEdgesBound(s);
}

TEST(CadImport, SolidsFromStepAreWatertight) {
  const TemporaryFolder folder;
  for (const Solid& solid : solids()) {
    writeStep({{solid.shape, solid.name}}, folder / "a.step");
    const ImportedPart part = importFile(folder / "a.step");
    expectClosedSolid(solid, part);
    ASSERT_EQ(part.report.bodies.size(), 1U);
    EXPECT_EQ(part.report.bodies[0].name, solid.name);
    EXPECT_EQ(part.report.bodies[0].kind, "solid");
  }
}

TEST(CadImport, SolidsFromBrepTextAndBinaryAreWatertight) {
  const TemporaryFolder folder;
  for (const Solid& solid : solids()) {
    writeBrep(solid.shape, folder / "a.brep");
    expectClosedSolid(solid, importFile(folder / "a.brep"));
    ASSERT_TRUE(BinTools::Write(solid.shape, (folder / "b.brep").c_str()));
    expectClosedSolid(solid, importFile(folder / "b.brep"));
  }
}

TEST(CadImport, SolidsFromIgesAreSewnTogether) {
  const TemporaryFolder folder;
  for (const Solid& solid : solids()) {
    SCOPED_TRACE(solid.name);
    writeIges(solid.shape, folder / "a.igs");
    const ImportedPart part = importFile(folder / "a.igs");
    EXPECT_TRUE(part.report.closed);
    EXPECT_EQ(part.report.unit, "MM");
    EXPECT_EQ(eulerCharacteristic(*part.surface), solid.euler);
    EXPECT_NEAR(part.report.volume.value_or(0.0) / solid.volume, 1.0, 0.01);
  }
}

TEST(CadImport, StoredTriangulationsAreReplaced) {
  const TemporaryFolder folder;
  writeStep({{BRepPrimAPI_MakeSphere(20), "ball"}}, folder / "a.step");
  ImportOptions coarse;
  coarse.chordTolerance = Length(5.0);
  coarse.angularTolerance = Angle(degToRad(45.0));
  const std::size_t few = importFile(folder / "a.step", coarse).report.triangles;
  EXPECT_GT(importFile(folder / "a.step").report.triangles, 10 * few);
}

// OpenCASCADE exceeds the wanted distance on doubly curved faces; the header promises twice.
TEST(CadImport, ChordToleranceIsKept) {
  const TemporaryFolder folder;
  writeStep({{BRepPrimAPI_MakeSphere(50), "ball"}}, folder / "a.step");
  for (const double chord : {0.5, 0.1, 0.02}) {
    ImportOptions options;
    options.chordTolerance = Length(chord);
    options.angularTolerance = Angle(degToRad(60.0));
    const PartSurface s = *importFile(folder / "a.step", options).surface;
    double worst = 0.0;
    for (const auto& t : s.mesh.triangles) {
      const Vec3 centre =
          (s.mesh.vertices[t[0]] + s.mesh.vertices[t[1]] + s.mesh.vertices[t[2]]) / 3;
      worst = std::max(worst, 50.0 - centre.norm());
    }
    EXPECT_LT(worst, 2.0 * chord);
  }
}

TEST(CadImport, AssemblyIsFlattenedWithPlacementsNamesAndColours) {
  const TemporaryFolder folder;
  STEPControl_Controller::Init();
  const Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const Handle(XCAFDoc_ColorTool) colours = XCAFDoc_DocumentTool::ColorTool(document->Main());
  const TDF_Label box = shapes->AddShape(BRepPrimAPI_MakeBox(10, 10, 10).Shape(), Standard_False);
  TDataStd_Name::Set(box, TCollection_ExtendedString("Würfel", Standard_True));
  colours->SetColor(box, Quantity_Color(1.0, 0.0, 0.0, Quantity_TOC_sRGB), XCAFDoc_ColorGen);
  const TDF_Label assembly = shapes->NewShape();
  TDataStd_Name::Set(assembly, "pair");
  gp_Trsf near;
  near.SetTranslation(gp_Vec(100, 0, 0));
  gp_Trsf far;
  far.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), kPi / 2);
  shapes->AddComponent(assembly, box, TopLoc_Location(near));
  shapes->AddComponent(assembly, box, TopLoc_Location(far));
  shapes->UpdateAssemblies();
  STEPCAFControl_Writer writer;
  ASSERT_TRUE(writer.Transfer(document, STEPControl_AsIs));
  ASSERT_EQ(writer.Write((folder / "a.step").c_str()), IFSelect_RetDone);

  const ImportedPart part = importFile(folder / "a.step");
  EXPECT_EQ(part.report.components, 2U);
  EXPECT_TRUE(part.report.closed);
  EXPECT_NEAR(*part.report.volume, 2000.0, 1e-6);
  EXPECT_NEAR((part.report.bounds.min - Vec3(-10, 0, 0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((part.report.bounds.max - Vec3(110, 10, 10)).norm(), 0.0, 1e-9);
  ASSERT_EQ(part.report.bodies.size(), 2U);
  EXPECT_EQ(part.report.bodies[0].name, "Würfel");
  EXPECT_EQ(part.report.bodies[0].colour, "#FF0000");
  EXPECT_EQ(part.report.bodies[0].faces, 6);
  EXPECT_EQ(part.surface->brep->faceCount(), 12);
  EXPECT_EQ(part.surface->brep->face(7).name, "Würfel");
  EXPECT_LT(bindingError(*part.surface).corner, 1e-9);
}

TEST(CadImport, InchesBecomeMillimetres) {
  const TemporaryFolder folder;
  STEPControl_Controller::Init();
  Interface_Static::SetCVal("write.step.unit", "INCH");
  STEPControl_Writer writer;
  writer.Transfer(BRepPrimAPI_MakeBox(25.4, 50.8, 76.2), STEPControl_AsIs);
  writer.Write((folder / "a.step").c_str());
  Interface_Static::SetCVal("write.step.unit", "MM");
  const std::string text = test::readBytes(folder / "a.step");
  ASSERT_NE(text.find("INCH"), std::string::npos);
  const ImportedPart part = importFile(folder / "a.step");
  EXPECT_NEAR((part.report.bounds.max - Vec3(25.4, 50.8, 76.2)).norm(), 0.0, 1e-9);
  EXPECT_EQ(part.report.unit, "INCH");
  EXPECT_DOUBLE_EQ(part.report.millimetresPerUnit, 25.4);
}

TEST(CadImport, BrepUnitCanBeChosen) {
  const TemporaryFolder folder;
  writeBrep(BRepPrimAPI_MakeSphere(2), folder / "a.brep");
  ImportOptions options;
  options.unit = FileUnit::Inch;
  const ImportedPart part = importFile(folder / "a.brep", options);
  EXPECT_NEAR(part.report.bounds.max.z(), 50.8, 1e-9);
  EXPECT_LT(bindingError(*part.surface).corner, 1e-9);
  EXPECT_NEAR(importFile(folder / "a.brep").report.bounds.max.z(), 2.0, 1e-9);
}

TEST(CadImport, PlacementMovesMeshAndExactGeometry) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  pose.translation() = Vec3(100, -20, 5);
  const auto file = kProjects / "elbow" / "elbow.step";
  const ImportedPart here = importFile(file);
  const ImportedPart there = importFile(file, {}, pose);
  ASSERT_EQ(here.report.vertices, there.report.vertices);
  for (std::size_t v = 0; v < here.report.vertices; ++v) {
    EXPECT_NEAR((pose * here.surface->mesh.vertices[v] - there.surface->mesh.vertices[v]).norm(),
                0.0, 1e-9);
  }
  EXPECT_LT(bindingError(*there.surface).corner, 1e-9);
  EXPECT_LT(bindingError(*there.surface).edge, 1e-9);
  const BrepEvaluator a(*here.surface->brep);
  const BrepEvaluator b(*there.surface->brep);
  EXPECT_NEAR((pose * a.curve(3, 0.4).p - b.curve(3, 0.4).p).norm(), 0.0, 1e-9);
  EXPECT_NE(here.surface->hash, there.surface->hash);
}

TEST(CadImport, PlacementMustBeRigid) {
  Pose pose = Pose::Identity();
  pose.linear() *= 2.0;
  try {
    importFile(kProjects / "elbow" / "elbow.step", {}, pose);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::InvalidArgument);
  }
}

TEST(CadImport, HashCoversOptions) {
  const auto file = kProjects / "hemisphere" / "hemisphere.step";
  ImportOptions options;
  const std::string first = importFile(file, options).surface->hash;
  EXPECT_EQ(first.size(), 64U);
  EXPECT_EQ(importFile(file, options).surface->hash, first);
  options.chordTolerance = Length(0.2);
  EXPECT_NE(importFile(file, options).surface->hash, first);
}

TEST(CadImport, SameFileGivesTheSameMesh) {
  const auto file = kProjects / "supportless" / "supportless_sample.stp";
  const ImportedPart a = importFile(file);
  const ImportedPart b = importFile(file);
  EXPECT_EQ(a.surface->mesh.vertices, b.surface->mesh.vertices);
  EXPECT_EQ(a.surface->mesh.triangles, b.surface->mesh.triangles);
}

TEST(CadImport, ReversedFaceOfAShellIsTurned) {
  const TemporaryFolder folder;
  TopoDS_Compound faces;
  const BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  int i = 0;
  for (TopExp_Explorer it(BRepPrimAPI_MakeBox(10, 10, 10).Shape(), TopAbs_FACE); it.More();
       it.Next(), ++i) {
    builder.Add(shell, i == 2 ? it.Current().Reversed() : it.Current());
  }
  writeBrep(shell, folder / "a.brep");
  const JobContext context;
  const ImportedPart part = importPart(folder / "a.brep", {}, Pose::Identity(), context);
  EXPECT_TRUE(part.report.closed);
  EXPECT_NEAR(*part.report.volume, 1000.0, 1e-9);
  EXPECT_EQ(part.report.reorientedTriangles, 2U);
  EXPECT_EQ(context.diagnostics().count("import.reoriented"), 1U);
  EXPECT_EQ(context.diagnostics().count("import.no_solid"), 1U);
  const BindingError error = bindingError(*part.surface);
  EXPECT_LT(error.corner, 1e-9);
  EXPECT_LT(error.edge, 1e-9);
  EXPECT_LT(error.normal, 1e-12);
}

TEST(CadImport, InsideOutShellIsTurnedOutwards) {
  const TemporaryFolder folder;
  writeBrep(BRepPrimAPI_MakeTorus(50, 15).Shape().Reversed(), folder / "a.brep");
  const ImportedPart part = importFile(folder / "a.brep");
  EXPECT_NEAR(*part.report.volume / (2 * kPi * kPi * 50 * 225), 1.0, 0.01);
  EXPECT_LT(bindingError(*part.surface).normal, 0.05);
}

TEST(CadImport, FacesCanBeSelected) {
  const TemporaryFolder folder;
  writeBrep(BRepPrimAPI_MakeCylinder(10, 30), folder / "a.brep");
  const ImportedPart part = importFile(folder / "a.brep");
  int mantle = -1;
  for (int f = 0; f < part.surface->brep->faceCount(); ++f) {
    mantle = part.surface->brep->face(f).surfaceType == "cylinder" ? f : mantle;
  }
  const PartSurface tube = geometry::selectFaces(*part.surface, {mantle, mantle});
  EXPECT_EQ(tube.halfEdges.borderLoops(tube.mesh).size(), 2U);
  EXPECT_LT(bindingError(tube).corner, 1e-9);
  EXPECT_LT(bindingError(tube).edge, 1e-9);
  EXPECT_NE(tube.hash, part.surface->hash);
  for (const std::vector<int>& bad : {std::vector<int>{}, {3}, {-1}}) {
    EXPECT_THROW(geometry::selectFaces(*part.surface, bad), Error);
  }
}

TEST(CadImport, NormalsExistAtPoles) {
  const TemporaryFolder folder;
  writeBrep(BRepPrimAPI_MakeSphere(20), folder / "a.brep");
  const ImportedPart ball = importFile(folder / "a.brep");
  const BrepEvaluator sphere(*ball.surface->brep);
  EXPECT_NEAR((sphere.normal(0, Vec2(1.0, kPi / 2)) - Vec3::UnitZ()).norm(), 0.0, 1e-9);
  EXPECT_NEAR((sphere.normal(0, Vec2(4.0, -kPi / 2)) + Vec3::UnitZ()).norm(), 0.0, 1e-9);

  writeBrep(BRepPrimAPI_MakeCone(10, 0, 10), folder / "b.brep");
  const ImportedPart cone = importFile(folder / "b.brep");
  for (int f = 0; f < cone.surface->brep->faceCount(); ++f) {
    const auto& info = cone.surface->brep->face(f);
    if (info.surfaceType == "cone") {
      const BrepEvaluator evaluator(*cone.surface->brep);
      const double apex = evaluator.surface(f, Vec2(0, info.uvBounds[2])).du.norm() < 1e-9
                              ? info.uvBounds[2]
                              : info.uvBounds[3];
      const Vec3 n = evaluator.normal(f, Vec2(0.0, apex));
      EXPECT_NEAR((n - Vec3(1, 0, 1).normalized()).norm(), 0.0, 1e-9);
    }
  }
}

TEST(CadImport, FileWithoutFacesTellsWhatItHas) {
  const TemporaryFolder folder;
  writeStep({{BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(10, 0, 0)).Edge(), "line"}},
            folder / "a.step");
  try {
    importFile(folder / "a.step");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::InputInvalid);
    EXPECT_THAT(error.what(), testing::HasSubstr("a.step"));
    EXPECT_THAT(error.what(), testing::HasSubstr("1 edges"));
  }
}

TEST(CadImport, EvaluatorsOfSeveralThreadsAgree) {
  const ImportedPart part = importFile(kProjects / "supportless" / "supportless_sample.stp");
  const geometry::Brep& brep = *part.surface->brep;
  const auto sum = [&] {
    const BrepEvaluator evaluator(brep);
    Vec3 total = Vec3::Zero();
    for (int f = 0; f < brep.faceCount(); ++f) {
      const auto& b = brep.face(f).uvBounds;
      for (int i = 0; i <= 50; ++i) {
        const Vec2 uv(b[0] + (b[1] - b[0]) * i / 50.0, b[2] + (b[3] - b[2]) * i / 50.0);
        total += evaluator.surface(f, uv).p + evaluator.normal(f, uv);
      }
    }
    return total;
  };
  const Vec3 expected = sum();
  std::vector<Vec3> results(8);
  {
    std::vector<std::jthread> threads;
    for (Vec3& result : results) {
      threads.emplace_back([&] { result = sum(); });
    }
  }
  for (const Vec3& result : results) {
    EXPECT_EQ(result, expected);
  }
}

TEST(CadImport, SeveralThreadsMayImport) {
  std::vector<std::size_t> counts(4);
  {
    std::vector<std::jthread> threads;
    for (std::size_t& count : counts) {
      threads.emplace_back([&count] {
        count = importFile(kProjects / "hemisphere" / "hemisphere.step").report.triangles;
      });
    }
  }
  EXPECT_THAT(counts, testing::Each(counts[0]));
}

TEST(CadImport, WorkerGivesTheSameAsThisProcess) {
  const auto file = kProjects / "supportless" / "supportless_sample.stp";
  const Pose pose(Eigen::AngleAxisd(0.3, Vec3::UnitX()) * Eigen::Translation3d(1, 2, 3));
  const ImportOptions options;
  const std::string bytes = test::readBytes(file);
  const ImportJob job{file, file.string(), FileFormat::Step, options, pose};
  const JobContext hereContext;
  const JobContext thereContext;
  ImportReport hereReport;
  ImportReport thereReport;
  const PartSurface here = buildCadPart(bytes, job, hereReport, hereContext);
  const PartSurface there = buildCadPartApart(bytes, job, thereReport, thereContext);
  EXPECT_EQ(here.mesh.vertices, there.mesh.vertices);
  EXPECT_EQ(here.mesh.triangles, there.mesh.triangles);
  EXPECT_EQ(here.binding.face, there.binding.face);
  EXPECT_EQ(here.binding.uv, there.binding.uv);
  EXPECT_EQ(here.binding.edge, there.binding.edge);
  EXPECT_EQ(here.binding.edgeParam, there.binding.edgeParam);
  EXPECT_EQ(hereReport.unit, thereReport.unit);
  EXPECT_EQ(hereReport.bodies.size(), thereReport.bodies.size());
  EXPECT_EQ(hereReport.edges, thereReport.edges);
  EXPECT_EQ(hereContext.diagnostics().items().size(), thereContext.diagnostics().items().size());
  const BrepEvaluator a(*here.brep);
  const BrepEvaluator b(*there.brep);
  for (int f = 0; f < here.brep->faceCount(); ++f) {
    const auto& bounds = here.brep->face(f).uvBounds;
    EXPECT_EQ(here.brep->face(f).name, there.brep->face(f).name);
    EXPECT_EQ(here.brep->face(f).reversed, there.brep->face(f).reversed);
    EXPECT_EQ(bounds, there.brep->face(f).uvBounds);
    const Vec2 uv(0.3 * bounds[0] + 0.7 * bounds[1], 0.6 * bounds[2] + 0.4 * bounds[3]);
    EXPECT_NEAR((a.surface(f, uv).p - b.surface(f, uv).p).norm(), 0.0, 1e-12);
    EXPECT_NEAR((a.normal(f, uv) - b.normal(f, uv)).norm(), 0.0, 1e-12);
  }
  for (int e = 0; e < here.brep->edgeCount(); ++e) {
    const double t = here.brep->edge(e).range[0];
    EXPECT_EQ(here.brep->edge(e).faceCount, there.brep->edge(e).faceCount);
    EXPECT_NEAR((a.curve(e, t).p - b.curve(e, t).p).norm(), 0.0, 1e-12);
  }
}

TEST(CadImport, CancelStopsTheImport) {
  for (const double at : {0.0, 0.06, 0.3, 0.8}) {
    std::stop_source stop;
    const JobContext context(stop.get_token(), [&](double fraction, const std::string&) {
      if (fraction >= at) {
        stop.request_stop();
      }
    });
    EXPECT_THROW(importPart(kProjects / "supportless" / "supportless_sample.stp", {},
                            Pose::Identity(), context),
                 CancelledError);
  }
  EXPECT_NO_THROW(importFile(kProjects / "hemisphere" / "hemisphere.step"));
}

/// A washer with a countersunk hole whose cone has a seam that is tilted in the parameters, as
/// rounding leaves it. OpenCASCADE 7.6 does not tessellate such a cone.
TopoDS_Shape washerWithTiltedSeam(double tilt) {
  BRepBuilderAPI_MakePolygon profile;
  for (const auto& [r, z] :
       {std::pair{4.0, 0.0}, {12.0, 0.0}, {12.0, 7.0}, {9.0, 7.0}, {4.0, 2.0}}) {
    profile.Add(gp_Pnt(r, 0, z));
  }
  profile.Close();
  const TopoDS_Shape washer = BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(profile.Wire()),
                                                    gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)))
                                  .Shape();
  for (TopExp_Explorer it(washer, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Face face = TopoDS::Face(it.Current());
    if (BRepAdaptor_Surface(face).GetType() != GeomAbs_Cone) {
      continue;
    }
    for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(edges.Current().Oriented(TopAbs_FORWARD));
      if (!BRep_Tool::IsClosed(edge, face)) {
        continue;
      }
      double first = 0.0;
      double last = 0.0;
      const auto tilted = [&](const TopoDS_Edge& side) -> Handle(Geom2d_Curve) {
        const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(side, face, first, last);
        const gp_Pnt2d a = curve->Value(first);
        const gp_Pnt2d b = curve->Value(last);
        const gp_Dir2d along(b.X() - tilt - a.X(), b.Y() - a.Y());
        return new Geom2d_Line(a.Translated(-first * gp_Vec2d(along)), along);
      };
      const Handle(Geom2d_Curve) one = tilted(edge);
      const Handle(Geom2d_Curve) other = tilted(TopoDS::Edge(edge.Oriented(TopAbs_REVERSED)));
      const BRep_Builder builder;
      builder.UpdateEdge(edge, one, other, face, 1e-7);
      builder.Range(edge, face, first, last);
      break;
    }
  }
  return washer;
}

TEST(CadImport, ConeWithATiltedSeamIsMended) {
  const TemporaryFolder folder;
  for (const double tilt : {3e-14, 1e-11, 1e-9}) {
    SCOPED_TRACE(tilt);
    writeBrep(washerWithTiltedSeam(tilt), folder / "washer.brep");
    const JobContext context;
    const ImportedPart part = importPart(folder / "washer.brep", {}, Pose::Identity(), context);
    EXPECT_TRUE(part.surface->halfEdges.closed());
    EXPECT_EQ(context.diagnostics().count("import.face_mended"), 1U);
    EXPECT_EQ(context.diagnostics().count("import.face_not_meshed"), 0U);
    double volume = 0.0;
    for (const auto& t : part.surface->mesh.triangles) {
      const auto& v = part.surface->mesh.vertices;
      volume += v[t[0]].dot(v[t[1]].cross(v[t[2]])) / 6.0;
    }
    // Full cylinder less hole and countersink.
    const double exact = kPi * (144.0 * 7.0 - 16.0 * 2.0 - 5.0 / 3.0 * (81.0 + 36.0 + 16.0));
    EXPECT_NEAR(volume, exact, 2e-3 * exact);
  }
}

}  // namespace
}  // namespace wcam::io
