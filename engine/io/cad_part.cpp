// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"
#include "wcam/base/figure.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/plausible.hpp"

#include "brep_impl.hpp"
#include "cad_mend.hpp"
#include "cad_mesh.hpp"
#include "cad_reader.hpp"
#include "formula_reader.hpp"
#include "mesh_boolean.hpp"
#include "mesh_repair.hpp"
#include "occt_session.hpp"
#include "part_builder.hpp"
#include "text_scanner.hpp"
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <gp_Trsf.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace wcam::io {

using geometry::HalfEdges;

namespace {

/// Gap between CAD faces without common edges (IGES) that is closed by default, mm: above the
/// tolerances that CAD systems export with, far below a bead.
constexpr double kSewTolerance = 0.01;
/// The same relative to the size of the part, for very small ones.
constexpr double kSewRelative = 1e-4;

/// A formula that is met better than this is met exactly, mm.
constexpr double kExactFormula = 1e-6;

double sewTolerance(const TopoDS_Shape& shape, double wanted) {
  if (wanted > 0.0) {
    return wanted;
  }
  Bnd_Box box;
  BRepBndLib::AddClose(shape, box);
  const double diagonal = box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent());
  return diagonal > 0.0 ? std::min(kSewTolerance, kSewRelative * diagonal) : kSewTolerance;
}

gp_Trsf toTrsf(const geometry::Pose& pose) {
  const auto& m = pose.matrix();
  gp_Trsf trsf;
  trsf.SetValues(m(0, 0), m(0, 1), m(0, 2), m(0, 3), m(1, 0), m(1, 1), m(1, 2), m(1, 3), m(2, 0),
                 m(2, 1), m(2, 2), m(2, 3));
  trsf.SetScaleFactor(1.0);  // exactly: a location may not scale
  return trsf;
}

int countOf(const TopoDS_Shape& shape, TopAbs_ShapeEnum type) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, type, map);
  return map.Extent();
}

/// Type of a shape; a compound of one thing counts as that thing.
std::string kindOf(const TopoDS_Shape& whole) {
  TopoDS_Shape shape = whole;
  while (shape.ShapeType() == TopAbs_COMPOUND && shape.NbChildren() == 1) {
    shape = TopoDS_Iterator(shape).Value();
  }
  std::string kind = TopAbs::ShapeTypeToString(shape.ShapeType());
  std::transform(kind.begin(), kind.end(), kind.begin(),
                 [](char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c); });
  return kind;
}

struct NamedFactor {
  const char* name;
  double millimetres;
};

/// Unit names of STEP and IGES files.
constexpr std::array<NamedFactor, 22> kUnitNames{
    {{"millimetre", 1.0},   {"millimeter", 1.0}, {"mm", 1.0},       {"centimetre", 10.0},
     {"centimeter", 10.0},  {"cm", 10.0},        {"metre", 1000.0}, {"meter", 1000.0},
     {"m", 1000.0},         {"inch", 25.4},      {"inches", 25.4},  {"in", 25.4},
     {"foot", 304.8},       {"feet", 304.8},     {"ft", 304.8},     {"micrometre", 0.001},
     {"micrometer", 0.001}, {"um", 0.001},       {"micron", 0.001}, {"mil", 0.0254},
     {"kilometre", 1e6},    {"decimetre", 100.0}}};

double millimetresPer(const std::string& name, double otherwise) {
  for (const NamedFactor& unit : kUnitNames) {
    if (equalNoCase(name, unit.name)) {
      return unit.millimetres;
    }
  }
  return otherwise;
}

/// The unit, and the factor that BREP files are still to be scaled by.
double chooseUnit(const CadModel& model, const ImportJob& job, ImportReport& report) {
  const bool brep = job.format == FileFormat::BrepText || job.format == FileFormat::BrepBinary;
  if (!brep) {
    report.unit = model.unit.empty() ? "mm" : model.unit;
    report.unitReason = model.unit.empty() ? "the file tells none" : "told by the file";
    report.millimetresPerUnit = millimetresPer(model.unit, model.millimetresPerUnit);
    return 1.0;
  }
  const bool chosen = job.options.unit != FileUnit::Auto;
  const FileUnit unit = chosen ? job.options.unit : FileUnit::Millimetre;
  report.unit = unitName(unit);
  report.unitReason = chosen ? "chosen by the user" : "BREP files are in mm by convention";
  report.millimetresPerUnit = millimetresPer(unit);
  return report.millimetresPerUnit;
}

/// Scales and places all shapes of the model.
void placeModel(CadModel& model, double scale, const geometry::Pose& T_part_file) {
  if (scale != 1.0) {
    gp_Trsf scaling;
    scaling.SetScaleFactor(scale);
    for (CadItem& body : model.bodies) {
      body.shape = BRepBuilderAPI_Transform(body.shape, scaling, Standard_True).Shape();
    }
  }
  if (!T_part_file.matrix().isIdentity(0.0)) {
    // One location for all, since locations are compared by identity.
    const TopLoc_Location location(toTrsf(T_part_file));
    for (std::vector<CadItem>* items : {&model.bodies, &model.named}) {
      for (CadItem& item : *items) {
        item.shape.Move(location);
      }
    }
  }
}

TopoDS_Compound compoundOf(const CadModel& model) {
  TopoDS_Compound compound;
  const BRep_Builder builder;
  builder.MakeCompound(compound);
  for (const CadItem& body : model.bodies) {
    builder.Add(compound, body.shape);
  }
  return compound;
}

Text contentText(const TopoDS_Shape& shape) {
  const std::array<std::pair<TopAbs_ShapeEnum, const char*>, 3> kinds{
      {{TopAbs_WIRE, "%1 wires"}, {TopAbs_EDGE, "%1 edges"}, {TopAbs_VERTEX, "%1 points"}}};
  std::vector<Text> texts;
  for (const auto& [type, name] : kinds) {
    texts.push_back(text(name, {std::to_string(countOf(shape, type))}));
  }
  return joinTexts(texts, ", ");
}

void requireFaces(const TopoDS_Shape& shape, const ImportJob& job, const OcctSession& session) {
  if (countOf(shape, TopAbs_FACE) == 0) {
    throw Error(
        ErrorCode::InputInvalid,
        text("the file has no surface; it has %1%2", {contentText(shape), session.messageTail()}),
        job.fileText, "export the part as a solid or as surfaces");
  }
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  for (int i = 1; i <= faces.Extent(); ++i) {
    if (BRep_Tool::Surface(TopoDS::Face(faces.FindKey(i))).IsNull()) {
      throw Error(ErrorCode::InputInvalid,
                  text("face %1 has triangles but no exact surface", {std::to_string(i - 1)}),
                  job.fileText, "export exact geometry, or export the part as STL");
    }
  }
}

/// Infinite faces (construction planes) cannot be tessellated.
void requireFinite(const geometry::Brep::Impl& brep, const ImportJob& job) {
  for (std::size_t f = 0; f < brep.faceInfos.size(); ++f) {
    for (const double bound : brep.faceInfos[f].uvBounds) {
      if (Precision::IsInfinite(bound) || bound != bound) {
        throw Error(ErrorCode::InputInvalid,
                    text("face %1 (%2) has no border and is infinite",
                         {std::to_string(f), brep.faceInfos[f].surfaceType}),
                    job.fileText, "trim or remove this face in the CAD system");
      }
    }
  }
}

/// Faces and shells that belong to no solid.
std::vector<TopoDS_Shape> looseSurfaces(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Shape> loose;
  for (TopExp_Explorer it(shape, TopAbs_SHELL, TopAbs_SOLID); it.More(); it.Next()) {
    loose.push_back(it.Current());
  }
  for (TopExp_Explorer it(shape, TopAbs_FACE, TopAbs_SHELL); it.More(); it.Next()) {
    loose.push_back(it.Current());
  }
  return loose;
}

/// Joins loose faces and shells along their borders. Solids and free curves stay as they are.
TopoDS_Shape sew(const TopoDS_Shape& shape,
                 CadModel& model,
                 const ImportJob& job,
                 const JobContext& context) {
  const std::vector<TopoDS_Shape> loose = looseSurfaces(shape);
  // IGES has no common edges: even the seam of a single face is open.
  if (loose.empty() || (loose.size() == 1 && job.format != FileFormat::Iges)) {
    return shape;
  }
  BRepBuilderAPI_Sewing sewing(sewTolerance(shape, job.options.weldTolerance.value()));
  for (const TopoDS_Shape& surface : loose) {
    sewing.Add(surface);
  }
  const Handle(OcctProgress) progress = new OcctProgress(context);
  sewing.Perform(progress->Start());
  context.check();
  if (sewing.SewedShape().IsNull() || sewing.NbContigousEdges() == 0) {
    return shape;
  }
  TopoDS_Compound result;
  const BRep_Builder builder;
  builder.MakeCompound(result);
  for (TopExp_Explorer it(shape, TopAbs_SOLID); it.More(); it.Next()) {
    builder.Add(result, it.Current());
  }
  builder.Add(result, sewing.SewedShape());
  TopTools_IndexedMapOfShape freeEdges;
  for (TopExp_Explorer it(shape, TopAbs_EDGE, TopAbs_FACE); it.More(); it.Next()) {
    if (freeEdges.Add(it.Current()) == freeEdges.Extent()) {
      builder.Add(result, it.Current());
    }
  }
  std::vector<CadItem> renamed;
  for (const std::vector<CadItem>* items : {&model.bodies, &model.named}) {
    for (const CadItem& item : *items) {
      for (TopExp_Explorer it(item.shape, TopAbs_FACE); it.More(); it.Next()) {
        renamed.push_back({sewing.ModifiedSubShape(it.Current()), item.name, {}});
      }
    }
  }
  model.named.insert(model.named.end(), renamed.begin(), renamed.end());
  addCounted(context, Severity::Information, "import.sewn",
             static_cast<std::size_t>(sewing.NbContigousEdges()),
             text("%1 edges of faces without connection were joined",
                  {std::to_string(sewing.NbContigousEdges())}));
  return result;
}

void nameFacesAndEdges(const CadModel& model, geometry::Brep::Impl& brep) {
  TopTools_IndexedMapOfShape faces;
  TopTools_IndexedMapOfShape edges;
  for (const TopoDS_Face& face : brep.faces) {
    faces.Add(face);
  }
  for (const TopoDS_Edge& edge : brep.edges) {
    edges.Add(edge);
  }
  const auto name = [&](const TopoDS_Shape& shape, const std::string& text) {
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
      if (const int i = faces.FindIndex(it.Current()); i > 0) {
        brep.faceInfos[static_cast<std::size_t>(i - 1)].name = text;
      }
    }
    for (TopExp_Explorer it(shape, TopAbs_EDGE, TopAbs_FACE); it.More(); it.Next()) {
      if (const int i = edges.FindIndex(it.Current()); i > 0) {
        brep.edgeInfos[static_cast<std::size_t>(i - 1)].name = text;
      }
    }
  };
  for (const CadItem& body : model.bodies) {
    name(body.shape, body.name);
  }
  for (const CadItem& item : model.named) {
    name(item.shape, item.name);
  }
}

void reportBodies(const CadModel& model,
                  const TopoDS_Shape& shape,
                  const geometry::Brep::Impl& brep,
                  ImportReport& report,
                  const JobContext& context) {
  for (const CadItem& body : model.bodies) {
    report.bodies.push_back(
        {body.name, kindOf(body.shape), body.colour, countOf(body.shape, TopAbs_FACE)});
  }
  report.faces = static_cast<int>(brep.faces.size());
  for (const geometry::BrepEdgeInfo& edge : brep.edgeInfos) {
    ++(edge.faceCount == 0 ? report.freeEdges : report.edges);
  }
  if (countOf(shape, TopAbs_SOLID) == 0) {
    context.add({Severity::Information,
                 "import.no_solid",
                 "the file has surfaces but no solid",
                 {},
                 {},
                 {{"faces", static_cast<double>(report.faces)}}});
  }
}

/// Turns a triangle over: corners 0, 2, 1.
void turnTriangle(geometry::TriangleMesh& mesh, geometry::BrepBinding& binding, std::size_t t) {
  std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  std::swap(binding.uv[t][1], binding.uv[t][2]);
  std::swap(binding.edge[3 * t], binding.edge[3 * t + 2]);
  std::swap(binding.edgeParam[3 * t], binding.edgeParam[3 * t + 2]);
  for (std::size_t h = 3 * t; h < 3 * t + 3; ++h) {
    std::swap(binding.edgeParam[h][0], binding.edgeParam[h][1]);
  }
}

/// Turns whole faces so that all normals agree and closed bodies point outwards.
void orientFaces(CadMesh& cad,
                 HalfEdges& halfEdges,
                 geometry::Brep::Impl& brep,
                 const ImportJob& job,
                 ImportReport& report,
                 const JobContext& context) {
  const Orientation orientation = findOrientation(cad.mesh, halfEdges, cad.binding.face,
                                                  brep.faces.size(), job.fileText, context);
  report.reorientedTriangles = orientation.flippedTriangles;
  if (orientation.flippedTriangles == 0) {
    return;
  }
  std::size_t turnedFaces = 0;
  for (std::size_t f = 0; f < brep.faces.size(); ++f) {
    if (orientation.flipNode[f]) {
      ++turnedFaces;
      brep.faces[f].Reverse();
      brep.faceInfos[f].reversed = !brep.faceInfos[f].reversed;
    }
  }
  for (std::size_t t = 0; t < cad.mesh.triangles.size(); ++t) {
    if (orientation.flipNode[static_cast<std::size_t>(cad.binding.face[t])]) {
      turnTriangle(cad.mesh, cad.binding, t);
    }
  }
  halfEdges = HalfEdges(cad.mesh);
  addCounted(context, Severity::Information, "import.reoriented", turnedFaces,
             text("%1 faces were turned so that all normals agree, the first at %2 mm",
                  {std::to_string(turnedFaces), positionText(orientation.first)}));
}

void tellReaderFindings(const CadMesh& cad,
                        const TopoDS_Shape& shape,
                        const OcctSession& session,
                        const JobContext& context) {
  if (!cad.unmeshedFaces.empty()) {
    // A solid with a hole has open sections: beads that end where the part does not.
    const bool solid = countOf(shape, TopAbs_SOLID) > 0;
    addCounted(
        context, solid ? Severity::Violation : Severity::Warning, "import.face_not_meshed",
        cad.unmeshedFaces.size(),
        text("%1 faces could not be tessellated and are missing, the first is face %2",
             {std::to_string(cad.unmeshedFaces.size()), std::to_string(cad.unmeshedFaces.front())}),
        "check these faces in the CAD system, or export them divided in halves");
  }
  addCounted(context, Severity::Information, "import.reader_message", session.messages().size(),
             text("the CAD reader reports%1", {session.messageTail()}),
             "check the part against the CAD system");
}

/// A damaged number of the file makes points that are none, or lie beyond all measure.
void requireCoordinates(const CadMesh& cad, const ImportJob& job) {
  for (std::size_t t = 0; t < cad.mesh.triangles.size(); ++t) {
    for (const std::uint32_t v : cad.mesh.triangles[t]) {
      for (const double x : cad.mesh.vertices[v]) {
        if (const Text wrong = implausible(x, QuantityKind::Length); !wrong.empty()) {
          throw Error(ErrorCode::InputInvalid,
                      text("face %1, coordinate: %2", {std::to_string(cad.binding.face[t]), wrong}),
                      job.fileText, "check this face in the CAD system, and export the part again");
        }
      }
    }
  }
}

CadFormat cadFormat(FileFormat format) {
  switch (format) {
    case FileFormat::Step:
      return CadFormat::Step;
    case FileFormat::Iges:
      return CadFormat::Iges;
    case FileFormat::BrepBinary:
      return CadFormat::BrepBinary;
    default:
      return CadFormat::BrepText;
  }
}

/// A shape with its faces and their tessellation.
struct MeshedShape {
  TopoDS_Shape shape;
  std::unique_ptr<geometry::Brep::Impl> brep;
  CadMesh cad;
};

MeshedShape meshed(const TopoDS_Shape& shape,
                   const CadModel& model,
                   const ImportJob& job,
                   const JobContext& context) {
  MeshedShape result{shape, geometry::makeBrepImpl(shape), {}};
  requireFinite(*result.brep, job);
  nameFacesAndEdges(model, *result.brep);
  result.cad = meshShape(shape, *result.brep, job.options.chordTolerance.value(),
                         job.options.angularTolerance.value(), context);
  return result;
}

/// Mends faces that cannot be tessellated as they are: their seams are straightened, and where that
/// does not do, closed faces are divided.
void mendFaces(MeshedShape& part,
               CadModel& model,
               const ImportJob& job,
               const JobContext& context) {
  const std::vector<int> missing = part.cad.unmeshedFaces;
  if (missing.empty()) {
    return;
  }
  straightenSeams(*part.brep, missing);
  part = meshed(part.shape, model, job, context);
  bool divided = false;
  if (!part.cad.unmeshedFaces.empty()) {
    MeshedShape halves = meshed(divideClosedFaces(part.shape, model), model, job, context);
    divided = halves.cad.unmeshedFaces.size() < part.cad.unmeshedFaces.size();
    part = divided ? std::move(halves) : std::move(part);
  }
  if (part.cad.unmeshedFaces.size() < missing.size()) {
    addCounted(context, Severity::Information, "import.face_mended",
               missing.size() - part.cad.unmeshedFaces.size(),
               divided ? text("closed faces were divided, since %1 could not be tessellated whole",
                              {std::to_string(missing.size())})
                       : text("the seams of %1 faces were straightened, since they could not be "
                              "tessellated as they are",
                              {std::to_string(missing.size())}));
  }
}

geometry::PartSurface build(std::string_view bytes,
                            const ImportJob& job,
                            ImportReport& report,
                            const OcctSession& session,
                            const JobContext& context) {
  const JobContext reading = context.portion(0.0, 0.6, "Reading CAD file");
  CadModel model = job.format == FileFormat::Formula
                       ? readFormulaSurface(bytes, job.fileText, reading)
                       : readCadModel(job.file, bytes, cadFormat(job.format), session, reading);
  report.formulaDeviation = model.deviation;
  if (model.deviation && *model.deviation > kExactFormula) {
    context.add(
        {Severity::Information,
         "import.formula_deviation",
         text("the surface follows its formula within %1 mm", {formatFigure(*model.deviation)}),
         "split the range where the formula has a corner or a vertical tangent, if that is "
         "not near enough",
         {},
         {{"deviation_mm", *model.deviation}}});
  }
  placeModel(model, chooseUnit(model, job, report), job.T_part_file);
  TopoDS_Shape shape = compoundOf(model);
  requireFaces(shape, job, session);
  if (job.options.repair) {
    shape = sew(shape, model, job, context.portion(0.6, 0.7, "Sewing faces"));
  }
  MeshedShape part = meshed(shape, model, job, context.portion(0.7, 0.95, "Tessellating"));
  mendFaces(part, model, job, context);
  std::unique_ptr<geometry::Brep::Impl>& brep = part.brep;
  CadMesh& cad = part.cad;
  reportBodies(model, part.shape, *brep, report, context);
  if (cad.mesh.triangles.empty()) {
    throw Error(ErrorCode::InputInvalid,
                text("none of the %1 faces could be tessellated%2",
                     {std::to_string(brep->faces.size()), session.messageTail()}),
                job.fileText, "check the part in the CAD system and export it again");
  }
  requireCoordinates(cad, job);
  geometry::PartSurface surface;
  // Free curves have end points that no triangle uses; the builder adds none of them.
  HalfEdges halfEdges(cad.mesh);
  if (job.options.repair) {
    orientFaces(cad, halfEdges, *brep, job, report, context);
  }
  // Exact bodies stay as they are; the triangles tell how much they share.
  const geometry::Overlaps overlaps =
      geometry::findOverlaps(cad.mesh, halfEdges, job.options.chordTolerance.value(), context);
  report.overlap = overlaps.volume;
  tellOverlaps(overlaps, false, context);
  tellReaderFindings(cad, part.shape, session, context);
  surface.mesh = std::move(cad.mesh);
  surface.binding = std::move(cad.binding);
  surface.halfEdges = std::move(halfEdges);
  surface.brep = std::make_shared<const geometry::Brep>(std::move(brep));
  return surface;
}

}  // namespace

geometry::PartSurface buildCadPart(std::string_view bytes,
                                   const ImportJob& job,
                                   ImportReport& report,
                                   const JobContext& context) {
  const OcctSession session(context);
  return guardOcct(job.fileText, "reading the CAD file", context,
                   [&] { return build(bytes, job, report, session, context); });
}

}  // namespace wcam::io
