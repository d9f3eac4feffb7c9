// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/slice_field.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/parallel.hpp"
#include "wcam/base/text.hpp"

#include "level_curve.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>

namespace wcam::toolpath {

LayerField::~LayerField() = default;

double LayerField::largestJump(double) const {
  return std::numeric_limits<double>::infinity();
}

std::vector<double> LayerField::vertexValues(std::size_t) const {
  return {};
}

namespace {

constexpr std::size_t kVertexGrain = 4096;
constexpr std::size_t kLevelGrain = 4;
/// Rounding of a field value, in parts of the part's size.
constexpr double kFieldSnap = 1e-11;
/// A contour shorter than this part of the part's size is a point: a pole or a tangent plane.
constexpr double kPointContour = 1e-6;
/// Below the substrate by more than so many tolerances of a flat face counts as below: a base with
/// noise lies on its plate.
constexpr double kOnSubstrate = 4.0;
/// A mesh edge shorter than this part of the part's size says nothing about a field's slope.
constexpr double kLongEdge = 0.01;

/// Field value per vertex; vertices of torn triangles become NaN only when the field may tear.
std::vector<double> fieldOf(const geometry::PartSurface& part,
                            std::size_t index,
                            const LayerField& field,
                            const JobContext& context) {
  std::vector<double> scalar = field.vertexValues(index);
  if (!scalar.empty()) {
    WCAM_ASSERT(scalar.size() == part.mesh.vertices.size());
    return scalar;
  }
  scalar.resize(part.mesh.vertices.size());
  parallelFor(
      scalar.size(), kVertexGrain,
      [&](std::size_t v) { scalar[v] = field.scalar(part.mesh.vertices[v]); }, context);
  return scalar;
}

/// The mesh without the triangles over which the field jumps; nothing when there are none.
std::optional<geometry::PartSurface> withoutTears(const geometry::PartSurface& part,
                                                  const LayerField& field,
                                                  const std::vector<double>& scalar) {
  std::vector<std::uint32_t> kept;
  const auto& triangles = part.mesh.triangles;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    bool torn = false;
    for (std::size_t c = 0; c < 3 && !torn; ++c) {
      const std::uint32_t a = triangles[t][c];
      const std::uint32_t b = triangles[t][(c + 1) % 3];
      const double length = (part.mesh.vertices[b] - part.mesh.vertices[a]).norm();
      torn = std::abs(scalar[a] - scalar[b]) > field.largestJump(length);
    }
    if (!torn) {
      kept.push_back(t);
    }
  }
  if (kept.size() == triangles.size()) {
    return std::nullopt;
  }
  geometry::PartSurface cut;
  cut.mesh.vertices = part.mesh.vertices;
  cut.brep = part.brep;
  for (const std::uint32_t t : kept) {
    cut.mesh.triangles.push_back(triangles[t]);
    if (part.exact()) {
      cut.binding.face.push_back(part.binding.face[t]);
      cut.binding.uv.push_back(part.binding.uv[t]);
      for (std::size_t h = 3 * std::size_t{t}; h < 3 * std::size_t{t} + 3; ++h) {
        cut.binding.edge.push_back(part.binding.edge[h]);
        cut.binding.edgeParam.push_back(part.binding.edgeParam[h]);
      }
    }
  }
  cut.halfEdges = geometry::HalfEdges(cut.mesh);
  return cut;
}

/// Change of a field's value per mm where it grows as the layers do.
double unitsPerMm(const geometry::TriangleMesh& mesh,
                  const std::vector<double>& scalar,
                  const std::vector<LayerLevel>& levels) {
  double height = 0.0;
  for (std::size_t l = 1; l < levels.size(); ++l) {
    height += levels[l].nominalHeight;
  }
  if (height > 0.0) {
    return (levels.back().value - levels.front().value) / height;
  }
  // A single layer: the field's greatest slope.
  const double least = kLongEdge * mesh.bounds().diagonal();
  double slope = 0.0;
  for (const auto& t : mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t a = t[c];
      const std::uint32_t b = t[(c + 1) % 3];
      const double length = (mesh.vertices[a] - mesh.vertices[b]).norm();
      const double rise = std::abs(scalar[a] - scalar[b]);
      slope = length > least && std::isfinite(rise) ? std::max(slope, rise / length) : slope;
    }
  }
  return slope;
}

struct LevelResult {
  std::vector<Contour> contours;
  std::size_t points = 0;          ///< contours that are single points
  Vec3 firstPoint = Vec3::Zero();  ///< of them
  std::size_t unrefined = 0;
  bool anyBelow = false;
};

/// @param size diagonal of the part's bounds, mm
/// @param flat tolerance of flat faces, mm
void traceOneLevel(const geometry::PartSurface& part,
                   double size,
                   double flat,
                   int partIndex,
                   const std::vector<geometry::LevelContour>& contours,
                   const LayerField* field,
                   std::size_t level,
                   const Substrate& substrate,
                   const Sampling& sampling,
                   LevelResult& result) {
  std::optional<geometry::BrepEvaluator> evaluator;
  if (part.exact()) {
    evaluator.emplace(*part.brep);
  }
  for (const geometry::LevelContour& contour : contours) {
    LevelCurve curve(part, evaluator ? &*evaluator : nullptr, field, level, size, flat);
    result.unrefined += curve.assign(contour);
    if (curve.length() <= kPointContour * size) {
      result.firstPoint = result.points == 0 ? contour.points.front() : result.firstPoint;
      ++result.points;
      continue;
    }
    std::vector<LevelCurve> kept = curve.keepAbove(substrate, kOnSubstrate * flat);
    result.anyBelow = result.anyBelow || kept.size() != 1 || kept[0].closed() != curve.closed();
    for (const LevelCurve& piece : kept) {
      if (piece.length() > kPointContour * size) {
        Contour& added = result.contours.emplace_back();
        added.closed = piece.closed();
        added.part = partIndex;
        added.points = sampleCurve(piece, sampling);
      }
    }
  }
}

void reportPoints(const LevelResult& result, double level, const JobContext& context) {
  if (result.points == 0) {
    return;
  }
  const Vec3& p = result.firstPoint;
  const std::string place = "(" + formatFixed(p.x(), 2) + ", " + formatFixed(p.y(), 2) + ", " +
                            formatFixed(p.z(), 2) + ")";
  context.add({Severity::Information,
               "slicing.degenerate_contour",
               result.points == 1
                   ? text("a contour of the layer at %1 is a single point and was dropped, at %2",
                          {formatFixed(level, 3), place})
                   : text("%1 contours of the layer at %2 are single points and were dropped, the "
                          "first at %3",
                          {std::to_string(result.points), formatFixed(level, 3), place}),
               "end the operation one layer earlier if this is not wanted",
               {},
               {{"points", static_cast<double>(result.points)},
                {"level", level},
                {"x_mm", p.x()},
                {"y_mm", p.y()},
                {"z_mm", p.z()}}});
}

/// @param layer index of the layer in the result
void report(const LevelResult& result, int layer, const JobContext& context) {
  if (result.unrefined > 0) {
    context.add({Severity::Warning,
                 "slicing.refinement_failed",
                 text("%1 nodes of the layer could not be moved onto the exact surface and keep "
                      "their place on the tessellation",
                      {std::to_string(result.unrefined)}),
                 "lower the tessellation's chord tolerance, or move the layers off tangent faces",
                 {{}, layer, -1, -1},
                 {{"nodes", static_cast<double>(result.unrefined)}}});
  }
  if (result.anyBelow) {
    context.add({Severity::Information,
                 "slicing.below_substrate",
                 "parts of the layer lie below the substrate and were cut away",
                 "move the part or the substrate if this is not wanted",
                 {{}, layer, -1, -1},
                 {}});
  }
}

std::vector<double> valuesOf(const std::vector<LayerLevel>& levels) {
  std::vector<double> values;
  values.reserve(levels.size());
  for (const LayerLevel& level : levels) {
    values.push_back(level.value);
  }
  return values;
}

/// Traces all levels on one part into `results`.
/// @param flat tolerance of flat faces and borders, mm
/// @param border of borders, where that is more, mm
/// @param field null when `scalar` is all that is known
void tracePart(const geometry::PartSurface& part,
               int partIndex,
               const std::vector<double>& scalar,
               double snap,
               double flat,
               double border,
               const LayerField* field,
               const std::vector<LayerLevel>& levels,
               const Substrate& substrate,
               const Sampling& sampling,
               std::vector<LevelResult>& results,
               const JobContext& context) {
  const double size = part.mesh.bounds().diagonal();
  const double unit = unitsPerMm(part.mesh, scalar, levels);
  const auto curves = geometry::traceLevels(part.mesh, part.halfEdges, scalar, valuesOf(levels),
                                            {snap, flat * unit, border * unit}, context);
  context.report(0.3);
  std::atomic<std::size_t> done{0};
  parallelForChunks(
      levels.size(), kLevelGrain,
      [&](std::size_t from, std::size_t to) {
        for (std::size_t l = from; l < to; ++l) {
          context.check();
          traceOneLevel(part, size, flat, partIndex, curves[l], field, l, substrate, sampling,
                        results[l]);
        }
        context.report(0.3 + 0.7 * static_cast<double>(done += to - from) /
                                 static_cast<double>(levels.size()));
      },
      context);
}

JobContext partPortion(const JobContext& context, std::size_t part, std::size_t parts) {
  return context.portion(static_cast<double>(part) / static_cast<double>(parts),
                         static_cast<double>(part + 1) / static_cast<double>(parts), "slicing");
}

SlicedLayers assemble(std::vector<LevelResult> results,
                      const std::vector<LayerLevel>& levels,
                      const JobContext& context) {
  SlicedLayers sliced;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    reportPoints(results[l], levels[l].value, context);
    if (results[l].contours.empty()) {
      context.add({Severity::Information,
                   "slicing.empty_layer",
                   text("the layer at %1 meets no part", {formatFixed(levels[l].value, 3)}),
                   "",
                   {},
                   {{"level", levels[l].value}}});
      continue;
    }
    report(results[l], static_cast<int>(sliced.layers.size()), context);
    SlicedLayer& layer = sliced.layers.emplace_back();
    layer.level = levels[l].value;
    layer.up = levels[l].up;
    layer.nominalHeight = levels[l].nominalHeight;
    layer.contours = std::move(results[l].contours);
  }
  if (sliced.layers.empty()) {
    throw Error(
        ErrorCode::CheckFailed, "no layer meets the part", "slicing",
        "check the part's place above the substrate, the build direction and the layer step");
  }
  context.report(1.0);
  return sliced;
}

}  // namespace

SlicedLayers sliceByField(const std::vector<std::shared_ptr<const geometry::PartSurface>>& parts,
                          const LayerField& field,
                          const std::vector<LayerLevel>& levels,
                          const Substrate& substrate,
                          const Sampling& sampling,
                          const JobContext& context) {
  std::vector<LevelResult> results(levels.size());
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const JobContext portion = partPortion(context, k, parts.size());
    const std::vector<double> scalar = fieldOf(*parts[k], k, field, portion);
    const auto cut = withoutTears(*parts[k], field, scalar);
    const geometry::PartSurface& part = cut ? *cut : *parts[k];
    const double snap = kFieldSnap * std::max(1.0, part.mesh.bounds().diagonal());
    tracePart(part, static_cast<int>(k), scalar, snap, geometry::flatTolerance(part.mesh), 0.0,
              &field, levels, substrate, sampling, results, portion);
  }
  return assemble(std::move(results), levels, context);
}

SlicedLayers sliceByField(const std::vector<std::shared_ptr<const geometry::PartSurface>>& parts,
                          const VertexField& field,
                          const std::vector<LayerLevel>& levels,
                          const Substrate& substrate,
                          const Sampling& sampling,
                          const JobContext& context) {
  if (field.values.size() != parts.size()) {
    throw Error(ErrorCode::InvalidArgument, "the field has values for another number of parts",
                "slicing", "give one list of values per part");
  }
  std::vector<LevelResult> results(levels.size());
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const std::vector<double>& scalar = field.values[k];
    if (scalar.size() != parts[k]->mesh.vertices.size()) {
      throw Error(ErrorCode::InvalidArgument, "the field has values for another number of vertices",
                  "slicing", "give one value per vertex of the part's mesh");
    }
    double largest = 0.0;
    for (const double value : scalar) {
      largest = std::isnan(value) ? largest : std::max(largest, std::abs(value));
    }
    tracePart(*parts[k], static_cast<int>(k), scalar, kFieldSnap * largest,
              geometry::flatTolerance(parts[k]->mesh), field.borderTolerance, nullptr, levels,
              substrate, sampling, results, partPortion(context, k, parts.size()));
  }
  return assemble(std::move(results), levels, context);
}

}  // namespace wcam::toolpath
