// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"

#include "mesh_boolean.hpp"
#include "mesh_repair.hpp"
#include "part_builder.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace wcam::io {

using geometry::HalfEdges;
using geometry::PartSurface;
using geometry::TriangleMesh;
using geometry::Vec3;

namespace {

/// Loops listed in a report; a damaged mesh may have a hundred thousand.
constexpr std::size_t kMaxListedLoops = 100;

Value vector(const Vec3& p) {
  return Value(Value::Array{p.x(), p.y(), p.z()});
}

std::vector<BorderLoop> measureBorders(const PartSurface& surface) {
  const auto& vertices = surface.mesh.vertices;
  std::vector<BorderLoop> borders;
  for (const auto& loop : surface.halfEdges.borderLoops(surface.mesh)) {
    BorderLoop border;
    border.vertices = loop.size();
    border.start = vertices[loop.front()];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      border.length += (vertices[loop[(i + 1) % loop.size()]] - vertices[loop[i]]).norm();
    }
    borders.push_back(border);
  }
  return borders;
}

/// Pieces that share no edge.
std::size_t countComponents(const PartSurface& surface) {
  const auto count = static_cast<std::uint32_t>(surface.mesh.triangles.size());
  std::vector<std::uint32_t> parent(count);
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t t) {
    while (parent[t] != t) {
      parent[t] = parent[parent[t]];
      t = parent[t];
    }
    return t;
  };
  std::size_t components = count;
  for (std::uint32_t h = 0; h < 3 * count; ++h) {
    const std::uint32_t first = surface.halfEdges.halfEdgeOf(surface.halfEdges.edgeOf(h));
    const std::uint32_t a = root(h / 3);
    const std::uint32_t b = root(first / 3);
    if (a != b) {
      parent[std::max(a, b)] = std::min(a, b);
      --components;
    }
  }
  return components;
}

void measureAreaAndVolume(const PartSurface& surface, ImportReport& report) {
  const TriangleMesh& mesh = surface.mesh;
  const Vec3 origin = mesh.vertices.front();
  double area2 = 0.0;
  double volume6 = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[0]] - origin;
    const Vec3 b = mesh.vertices[t[1]] - origin;
    const Vec3 c = mesh.vertices[t[2]] - origin;
    area2 += (b - a).cross(Vec3(c - a)).norm();
    volume6 += a.dot(b.cross(c));
  }
  report.area = area2 / 2.0;
  if (report.closed) {
    report.volume = volume6 / 6.0 - (report.overlapsUnited ? 0.0 : report.overlap);
  }
}

/// Whether the borders are only edges along which closed bodies touch.
bool onlyTouches(const PartSurface& surface) {
  const auto& edges = surface.halfEdges.nonManifoldEdges();
  for (std::uint32_t h = 0; h < 3 * surface.mesh.triangles.size(); ++h) {
    if (surface.halfEdges.twin(h) == geometry::HalfEdges::kNone &&
        std::find(edges.begin(), edges.end(), surface.halfEdges.edgeOf(h)) == edges.end()) {
      return false;
    }
  }
  return !edges.empty();
}

void addOpenFinding(const ImportReport& report, const JobContext& context) {
  const auto longest = std::max_element(
      report.borders.begin(), report.borders.end(),
      [](const BorderLoop& a, const BorderLoop& b) { return a.length < b.length; });
  context.add({Severity::Information,
               "import.open_surface",
               text("the surface is open: %1 border loops, the longest %2 mm from %3",
                    {std::to_string(report.borders.size()), formatFixed(longest->length, 3),
                     positionText(longest->start)}),
               {},
               {},
               {{"border_loops", static_cast<double>(report.borders.size())},
                {"longest_mm", longest->length}}});
}

void addNonManifoldFinding(const PartSurface& surface,
                           const ImportReport& report,
                           const JobContext& context) {
  const auto& v = surface.halfEdges.edgeVertices(surface.halfEdges.nonManifoldEdges().front());
  const Vec3 p = 0.5 * (surface.mesh.vertices[v[0]] + surface.mesh.vertices[v[1]]);
  context.add({Severity::Warning,
               "import.non_manifold",
               text("%1 edges do not have one triangle on each side, the first at %2 mm; contours "
                    "may break there",
                    {std::to_string(report.nonManifoldEdges), positionText(p)}),
               "separate the bodies that touch along an edge",
               {},
               {{"edges", static_cast<double>(report.nonManifoldEdges)},
                {"x_mm", p.x()},
                {"y_mm", p.y()},
                {"z_mm", p.z()}}});
}

Value bodiesValue(const std::vector<ImportedBody>& bodies) {
  Value list = Value::array();
  for (const ImportedBody& body : bodies) {
    Value item = Value::object({{"name", body.name}, {"kind", body.kind}});
    if (!body.colour.empty()) {
      item.set("colour", body.colour);
    }
    if (body.faces > 0) {
      item.set("faces", body.faces);
    }
    list.push(std::move(item));
  }
  return list;
}

Value bordersValue(const std::vector<BorderLoop>& borders) {
  Value list = Value::array();
  for (std::size_t i = 0; i < std::min(borders.size(), kMaxListedLoops); ++i) {
    list.push(Value::object({{"length_mm", borders[i].length},
                             {"vertices", borders[i].vertices},
                             {"start_mm", vector(borders[i].start)}}));
  }
  return list;
}

}  // namespace

void addCounted(const JobContext& context,
                Severity severity,
                const char* code,
                std::size_t count,
                const Text& message,
                const Text& remedy) {
  if (count > 0) {
    context.add({severity, code, message, remedy, {}, {{"count", static_cast<double>(count)}}});
  }
}

void tellOverlaps(const geometry::Overlaps& overlaps, bool united, const JobContext& context) {
  if (!overlaps.any()) {
    return;
  }
  const std::string volume = formatFixed(overlaps.volume, 1);
  const std::string place = positionText(overlaps.place);
  const auto add = [&](const char* code, std::size_t count, const Text& message,
                       const Text& remedy) {
    context.add({Severity::Warning,
                 code,
                 message,
                 remedy,
                 {},
                 {{"count", static_cast<double>(count)},
                  {"overlap_mm3", overlaps.volume},
                  {"x_mm", overlaps.place.x()},
                  {"y_mm", overlaps.place.y()},
                  {"z_mm", overlaps.place.z()}}});
  };
  const std::string crossing = std::to_string(overlaps.crossing);
  if (overlaps.crossing > 0 && overlaps.volume > 0.0) {
    add("import.overlapping_bodies", overlaps.crossing,
        united ? text("%1 bodies overlap by %2 mm³, first around %3 mm; they were united, so that "
                      "this material counts once",
                      {crossing, volume, place})
               : text("%1 bodies overlap by %2 mm³, first around %3 mm; paths fill this space more "
                      "than once",
                      {crossing, volume, place}),
        "unite the bodies in the CAD system, or move them apart");
  } else if (overlaps.crossing > 0) {
    add("import.overlapping_bodies", overlaps.crossing,
        text("%1 bodies meet around %2 mm and cannot be united, since a surface crosses itself or "
             "has too many triangles; where they overlap, paths fill the space more than once",
             {crossing, place}),
        "unite the bodies in the CAD system");
  }
  if (overlaps.nested > 0) {
    add("import.inner_shell_outwards", overlaps.nested,
        united ? text("%1 shells inside others (%2 mm³, first around %3 mm) are turned outwards "
                      "like them and count as solid material",
                      {std::to_string(overlaps.nested), volume, place})
               : text("%1 shells inside others (%2 mm³, first around %3 mm) are turned outwards "
                      "like them; paths fill them more than once",
                      {std::to_string(overlaps.nested), volume, place}),
        "turn the normals of a shell over if it is a cavity, else remove it");
  }
}

void measure(const PartSurface& surface, ImportReport& report, const JobContext& context) {
  report.vertices = surface.mesh.vertices.size();
  report.triangles = surface.mesh.triangles.size();
  report.closed = surface.halfEdges.closed();
  report.nonManifoldEdges = surface.halfEdges.nonManifoldEdges().size();
  report.bounds = surface.mesh.bounds();
  report.components = countComponents(surface);
  context.check();
  report.borders = measureBorders(surface);
  measureAreaAndVolume(surface, report);
  context.check();
  if (report.nonManifoldEdges > 0) {
    addNonManifoldFinding(surface, report, context);
  }
  if (!report.borders.empty() && !onlyTouches(surface)) {
    addOpenFinding(report, context);
  }
}

Value ImportReport::toValue() const {
  Value value = Value::object({{"file", file},
                               {"format", format},
                               {"unit", unit},
                               {"unit_reason", unitReason.str()},
                               {"mm_per_unit", millimetresPerUnit},
                               {"bodies", bodiesValue(bodies)},
                               {"faces", faces},
                               {"edges", edges},
                               {"free_edges", freeEdges},
                               {"vertices", vertices},
                               {"triangles", triangles},
                               {"closed", closed},
                               {"components", components},
                               {"border_loops", borders.size()},
                               {"borders", bordersValue(borders)},
                               {"non_manifold_edges", nonManifoldEdges},
                               {"welded_vertices", weldedVertices},
                               {"degenerate_triangles", degenerateTriangles},
                               {"flat_triangles", flatTriangles},
                               {"duplicate_triangles", duplicateTriangles},
                               {"reoriented_triangles", reorientedTriangles},
                               {"bounds_min_mm", vector(bounds.min)},
                               {"bounds_max_mm", vector(bounds.max)},
                               {"area_mm2", area}});
  if (formulaDeviation) {
    value.set("formula_deviation_mm", *formulaDeviation);
  }
  if (volume) {
    value.set("volume_mm3", *volume);
  }
  if (overlap > 0.0) {
    value.set("overlap_mm3", overlap);
  }
  return value;
}

}  // namespace wcam::io
