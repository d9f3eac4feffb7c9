// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"
#include "wcam/base/figure.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/parallel.hpp"
#include "wcam/base/plausible.hpp"

#include "mesh_boolean.hpp"
#include "mesh_order.hpp"
#include "mesh_repair.hpp"
#include "part_builder.hpp"
#include "text_scanner.hpp"

#include <cmath>
#include <utility>

namespace wcam::io {

using geometry::HalfEdges;
using geometry::TriangleMesh;
using geometry::Vec3;

namespace {

/// A part of less than this many units is not in millimetres: no bead is that small.
constexpr double kSmallestPartUnits = 2.0;
/// Steps of the file's precision by which the same point may differ in two triangles.
constexpr double kWeldSteps = 4.0;
constexpr std::size_t kGrain = 65536;

double largestExtent(const TriangleMesh& mesh) {
  const geometry::Box box = mesh.bounds();
  return box.empty() ? 0.0 : (box.max - box.min).maxCoeff();
}

double largestCoordinate(const TriangleMesh& mesh) {
  const geometry::Box box = mesh.bounds();
  return std::max(box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff());
}

void chooseUnit(const RawMesh& raw,
                const ImportJob& job,
                ImportReport& report,
                const JobContext& context) {
  if (!raw.unit.empty()) {
    report.unit = raw.unit;
    report.millimetresPerUnit = raw.millimetresPerUnit;
    report.unitReason = "told by the file";
    return;
  }
  if (job.options.unit != FileUnit::Auto) {
    report.unit = unitName(job.options.unit);
    report.millimetresPerUnit = millimetresPer(job.options.unit);
    report.unitReason = "chosen by the user";
    return;
  }
  const double extent = largestExtent(raw.mesh);
  const bool metres = extent < kSmallestPartUnits;
  const FileUnit unit = metres ? FileUnit::Metre : FileUnit::Millimetre;
  report.unit = unitName(unit);
  report.millimetresPerUnit = millimetresPer(unit);
  report.unitReason =
      metres
          ? text("guessed: the largest extent is %1, less than 2 units", {formatFixed(extent, 3)})
          : text("guessed: the largest extent is %1, at least 2 units", {formatFixed(extent, 3)});
  context.add({metres ? Severity::Warning : Severity::Information,
               "import.units_guessed",
               text("%1 files do not tell their unit; %2 is %3",
                    {report.format, report.unit, report.unitReason}),
               "set the option 'unit' if this is wrong",
               {},
               {{"extent", extent}, {"mm_per_unit", report.millimetresPerUnit}}});
}

void scaleAndPlace(TriangleMesh& mesh,
                   double scale,
                   const geometry::Pose& T_part_file,
                   const ImportJob& job,
                   const JobContext& context) {
  const bool placed = !T_part_file.matrix().isIdentity(0.0);
  parallelFor(
      mesh.vertices.size(), kGrain,
      [&](std::size_t v) {
        Vec3 p = scale * mesh.vertices[v];
        mesh.vertices[v] = placed ? Vec3(T_part_file * p) : p;
      },
      context);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    for (const double x : mesh.vertices[v]) {
      if (const Text wrong = implausible(x, QuantityKind::Length); !wrong.empty()) {
        throw Error(ErrorCode::InputInvalid,
                    text("vertex %1, coordinate: %2", {std::to_string(v), wrong}), job.fileText,
                    "check the unit and the placement, and export the part again");
      }
    }
  }
}

/// Drops what has no area or is there twice, and notes it.
void dropBadTriangles(TriangleMesh& mesh,
                      ImportReport& report,
                      Dropped& degenerate,
                      Dropped& inner,
                      Dropped& duplicate) {
  const Dropped twice = dropDegenerate(mesh);
  const Dropped between = dropInnerWalls(mesh);
  const Dropped again = dropDuplicates(mesh);
  if (inner.count == 0) {
    inner.first = between.first;
  }
  inner.count += between.count;
  if (degenerate.count == 0) {
    degenerate.first = twice.first;
  }
  if (duplicate.count == 0) {
    duplicate.first = again.first;
  }
  degenerate.count += twice.count;
  duplicate.count += again.count;
  report.degenerateTriangles = degenerate.count;
  report.duplicateTriangles = duplicate.count;
}

class MeshPartBuilder {
public:
  MeshPartBuilder(RawMesh raw,
                  const ImportJob& job,
                  ImportReport& report,
                  const JobContext& context)
      : raw_(std::move(raw)), job_(job), report_(report), context_(context) {}

  geometry::PartSurface build() {
    requireTriangles(pointCloud()
                         ? text("the file has no triangles; it is a point cloud of %1 "
                                "points",
                                {std::to_string(raw_.mesh.vertices.size() + raw_.weldedPoints)})
                         : text("the file has no triangles"));
    chooseUnit(raw_, job_, report_, context_);
    scaleAndPlace(raw_.mesh, report_.millimetresPerUnit, job_.T_part_file, job_, context_);
    report_.weldedVertices = raw_.weldedPoints;
    report_.bodies = std::move(raw_.bodies);
    if (job_.options.repair) {
      repair();
    } else {
      halfEdges_ = HalfEdges(raw_.mesh);
      pieces_ = 2;  // or more: not known
    }
    unite();
    geometry::PartSurface surface;
    surface.mesh = std::move(raw_.mesh);
    surface.halfEdges = std::move(halfEdges_);
    return surface;
  }

private:
  void requireTriangles(const Text& message) const {
    if (raw_.mesh.triangles.empty()) {
      throw Error(ErrorCode::InputInvalid, message, job_.fileText,
                  pointCloud() ? text("make a surface of the points first")
                               : text("export the part again"));
    }
  }

  [[nodiscard]] bool pointCloud() const {
    return raw_.mesh.triangles.empty() && !raw_.mesh.vertices.empty();
  }

  void repair() {
    Dropped degenerate;
    Dropped inner;
    Dropped duplicate;
    dropBadTriangles(raw_.mesh, report_, degenerate, inner, duplicate);
    context_.check();
    requireTriangles("no triangle is left after dropping those without area");
    halfEdges_ = HalfEdges(raw_.mesh);
    context_.check();
    stitch(degenerate, inner, duplicate);
    dropUnusedVerticesIfAny();
    requireTriangles("no triangle is left after joining the borders");
    orient();
    tell(degenerate, inner, duplicate);
  }

  /// Joins borders whose points differ by no more than the file's precision (or as far as the user
  /// says). The automatic width is only used when it closes something.
  void stitch(Dropped& degenerate, Dropped& inner, Dropped& duplicate) {
    if (halfEdges_.closed()) {
      return;
    }
    const double wanted = job_.options.weldTolerance.value();
    tolerance_ = wanted > 0.0 ? wanted : precisionLength();
    TriangleMesh trial = raw_.mesh;
    const std::size_t joined = stitchBorders(trial, halfEdges_, tolerance_);
    if (joined == 0) {
      return;
    }
    ImportReport report;
    Dropped trialDegenerate = degenerate;
    Dropped trialInner = inner;
    Dropped trialDuplicate = duplicate;
    dropBadTriangles(trial, report, trialDegenerate, trialInner, trialDuplicate);
    HalfEdges trialEdges(trial);
    if (wanted > 0.0 || trialEdges.borderEdgeCount() < halfEdges_.borderEdgeCount()) {
      raw_.mesh = std::move(trial);
      halfEdges_ = std::move(trialEdges);
      degenerate = trialDegenerate;
      inner = trialInner;
      duplicate = trialDuplicate;
      report_.degenerateTriangles = degenerate.count;
      report_.duplicateTriangles = duplicate.count;
      report_.weldedVertices += joined;
      stitched_ = joined;
    }
  }

  void dropUnusedVerticesIfAny() {
    const std::size_t before = raw_.mesh.vertices.size();
    dropUnusedVertices(raw_.mesh);
    if (raw_.mesh.vertices.size() != before) {
      halfEdges_ = HalfEdges(raw_.mesh);
    }
  }

  void orient() {
    const Orientation orientation = findOrientation(
        raw_.mesh, halfEdges_, {}, raw_.mesh.triangles.size(), job_.fileText, context_);
    pieces_ = orientation.components;
    report_.reorientedTriangles = orientation.flippedTriangles;
    if (orientation.flippedTriangles == 0) {
      return;
    }
    for (std::size_t t = 0; t < raw_.mesh.triangles.size(); ++t) {
      if (orientation.flipNode[t]) {
        std::swap(raw_.mesh.triangles[t][1], raw_.mesh.triangles[t][2]);
      }
    }
    halfEdges_ = HalfEdges(raw_.mesh);
    addCounted(
        context_, Severity::Information, "import.reoriented", orientation.flippedTriangles,
        text("%1 triangles were turned so that all normals agree, the first at %2 mm",
             {std::to_string(orientation.flippedTriangles), positionText(orientation.first)}));
  }

  /// Bodies that overlap are united when the mesh may be repaired, so that their material counts
  /// once.
  void unite() {
    if (pieces_ < 2) {
      return;
    }
    geometry::Overlaps overlaps =
        geometry::findOverlaps(raw_.mesh, halfEdges_, precisionLength(), context_);
    const bool united = job_.options.repair && overlaps.united;
    if (united) {
      raw_.mesh = std::move(*overlaps.united);
      dropUnusedVertices(raw_.mesh);
      sortForLocality(raw_.mesh);
      halfEdges_ = HalfEdges(raw_.mesh);
    }
    report_.overlap = overlaps.volume;
    report_.overlapsUnited = united;
    tellOverlaps(overlaps, united, context_);
  }

  [[nodiscard]] double precisionLength() const {
    return kWeldSteps * raw_.relativePrecision * largestCoordinate(raw_.mesh);
  }

  void tell(const Dropped& degenerate, const Dropped& inner, const Dropped& duplicate) {
    const auto count = [](std::size_t n) { return std::to_string(n); };
    if (report_.weldedVertices > 0) {
      const Text message =
          stitched_ > 0
              ? text("%1 equal points were joined, %2 of them on borders up to %3 mm apart",
                     {count(report_.weldedVertices), count(stitched_), formatFigure(tolerance_)})
              : text("%1 equal points were joined", {count(report_.weldedVertices)});
      context_.add({Severity::Information,
                    "import.welded",
                    message,
                    {},
                    {},
                    {{"count", static_cast<double>(report_.weldedVertices)},
                     {"on_borders", static_cast<double>(stitched_)}}});
    }
    addCounted(context_, Severity::Information, "import.degenerate_dropped", degenerate.count,
               text("%1 triangles without area were dropped, the first at %2 mm",
                    {count(degenerate.count), positionText(degenerate.first)}));
    addCounted(context_, Severity::Information, "import.inner_walls_dropped", inner.count,
               text("%1 triangles back to back between touching bodies were dropped, the first at "
                    "%2 mm: the bodies are built as one",
                    {count(inner.count), positionText(inner.first)}));
    addCounted(context_, Severity::Warning, "import.duplicate_dropped", duplicate.count,
               text("%1 triangles that were there twice were dropped, the first at %2 mm",
                    {count(duplicate.count), positionText(duplicate.first)}),
               "check that no wall is modelled as two coincident surfaces");
    const Dropped flat = countFlat(raw_.mesh);
    report_.flatTriangles = flat.count;
    addCounted(
        context_, Severity::Information, "import.flat_triangles", flat.count,
        text("%1 triangles have no area but connect others and were kept, the first at %2 mm",
             {count(flat.count), positionText(flat.first)}));
  }

  RawMesh raw_;
  const ImportJob& job_;
  ImportReport& report_;
  const JobContext& context_;
  HalfEdges halfEdges_;
  std::size_t pieces_ = 1;
  std::size_t stitched_ = 0;
  double tolerance_ = 0.0;
};

}  // namespace

double millimetresPer(FileUnit unit) {
  switch (unit) {
    case FileUnit::Millimetre:
      return 1.0;
    case FileUnit::Centimetre:
      return 10.0;
    case FileUnit::Metre:
      return 1000.0;
    case FileUnit::Inch:
      return 25.4;
    case FileUnit::Auto:
      break;
  }
  throw Error(ErrorCode::Internal, "the unit is not decided");
}

const char* unitName(FileUnit unit) {
  switch (unit) {
    case FileUnit::Auto:
      return "auto";
    case FileUnit::Millimetre:
      return "mm";
    case FileUnit::Centimetre:
      return "cm";
    case FileUnit::Metre:
      return "m";
    case FileUnit::Inch:
      return "in";
  }
  return "";
}

geometry::PartSurface buildMeshPart(RawMesh raw,
                                    const ImportJob& job,
                                    ImportReport& report,
                                    const JobContext& context) {
  return MeshPartBuilder(std::move(raw), job, report, context).build();
}

}  // namespace wcam::io
