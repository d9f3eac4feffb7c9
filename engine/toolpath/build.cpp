// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/build.hpp"

#include "wcam/base/text.hpp"
#include "wcam/toolpath/layer_distance.hpp"
#include "wcam/toolpath/tool_axis.hpp"

#include "seam.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace wcam::toolpath {

namespace {

void addSampling(Schema<PathParams>& schema) {
  schema
      .add(&PathParams::chordError,
           {.key = "chord_error",
            .label = "Chord error",
            .help = "Greatest distance between the path and the curve it follows.",
            .group = "Sampling",
            .min = 1e-5,
            .max = 10.0})
      .add(&PathParams::maxSpacing,
           {.key = "max_spacing",
            .label = "Greatest point spacing",
            .help = "Robots leave the line between far points; 4.9 mm keeps them on it.",
            .group = "Sampling",
            .min = 0.01,
            .max = 1000.0});
}

void addSeam(Schema<PathParams>& schema) {
  schema
      .add(&PathParams::seam, {.key = "seam",
                               .label = "Seam",
                               .help = "Where each closed bead starts and ends.",
                               .group = "Seam",
                               .choices = {{"nearest", "Nearest to the end of the bead before"},
                                           {"aligned", "Aligned in one direction"},
                                           {"shifted", "Shifted by a length from layer to layer"},
                                           {"golden", "Golden ratio from layer to layer"},
                                           {"random", "Random, from a seed"}}})
      .add(&PathParams::seamShift,
           {.key = "seam_shift",
            .label = "Seam shift",
            .help = "Length along the bead by which the start moves on in each layer.",
            .group = "Seam",
            .min = 0.0,
            .max = 1e4,
            .enabledIf = "seam=shifted"})
      .add(&PathParams::seamDirection,
           {.key = "seam_direction",
            .label = "Seam direction",
            .help = "Direction from the layer's centre, about the build direction, from x.",
            .group = "Seam",
            .level = ParamLevel::Advanced,
            .min = -360.0,
            .max = 360.0})
      .add(&PathParams::seed, {.key = "seam_seed",
                               .label = "Random seed",
                               .help = "The same seed gives the same seams.",
                               .group = "Seam",
                               .level = ParamLevel::Advanced,
                               .min = 0,
                               .max = 2147483647,
                               .enabledIf = "seam=random"});
}

void addOrder(Schema<PathParams>& schema) {
  schema.add(&PathParams::alternate, {.key = "alternate",
                                      .label = "Alternate direction",
                                      .help = "Every other layer runs the other way.",
                                      .group = "Order"});
}

void addToolAxis(Schema<PathParams>& schema) {
  schema
      .add(&PathParams::axis,
           {.key = "axis",
            .label = "Tool axis",
            .help = "Build direction that the torch follows and the positioner turns upright.",
            .group = "Tool axis",
            .choices = {{"local", "Local: tangent to the wall at every point"},
                        {"layer", "Layer: one direction for each layer"},
                        {"global", "Global: the substrate's build direction"}}})
      .add(&PathParams::lead,
           {.key = "lead",
            .label = "Lead angle",
            .help = "Lean of the torch in the travel plane; positive leans forward.",
            .group = "Tool axis",
            .min = -80.0,
            .max = 80.0})
      .add(&PathParams::lateralTilt,
           {.key = "lateral_tilt",
            .label = "Lateral tilt",
            .help = "Lean of the torch across the travel; positive leans outwards.",
            .group = "Tool axis",
            .min = -80.0,
            .max = 80.0});
}

Schema<PathParams> makeSchema() {
  Schema<PathParams> schema;
  addSampling(schema);
  addSeam(schema);
  addOrder(schema);
  addToolAxis(schema);
  return schema;
}

}  // namespace

const Schema<PathParams>& PathParams::schema() {
  static const Schema<PathParams> schema = makeSchema();
  return schema;
}

namespace {

/// Below this a sum or product of unit vectors has no direction that rounding leaves alone.
constexpr double kNoDirection = 1e-9;
/// A point nearer to the substrate than this part of the layer height lies on it.
constexpr double kOnSubstrate = 1e-6;

/// Unit tangent at the middle of three points: exact on circles (each chord weighted by the other's
/// length).
Vec3 tangentAt(const Vec3& before, const Vec3& p, const Vec3& after) {
  const Vec3 d1 = p - before;
  const Vec3 d2 = after - p;
  const double l1 = d1.norm();
  const double l2 = d2.norm();
  Vec3 t = Vec3::Zero();
  if (l1 > 0.0) {
    t += d1 / l1 * l2;
  }
  if (l2 > 0.0) {
    t += d2 / l2 * l1;
  }
  // A point where the path turns back on itself has no mean direction: keep the one that leaves.
  return t.norm() > kNoDirection * (l1 + l2) ? Vec3(t.normalized())
                                             : Vec3((l2 > 0.0 ? d2 : d1).normalized());
}

/// Right-handed (t, n, b) with t kept and n as near to the surface normal as it can be.
void setFrame(PathPoint& point, const Vec3& t, const Vec3& surfaceNormal, const Vec3& fallbackUp) {
  Vec3 b = t.cross(surfaceNormal);
  if (b.norm() < kNoDirection) {
    b = fallbackUp - fallbackUp.dot(t) * t;
  }
  point.t = t;
  point.b = b.norm() > 0.0 ? Vec3(b.normalized()) : t.unitOrthogonal();
  point.n = point.b.cross(point.t);
}

void setAxis(PathPoint& point, const Vec3& up, const PathParams& params) {
  point.up = up;
  if (params.lead.value() == 0.0 && params.lateralTilt.value() == 0.0) {
    point.axis = up;
    return;
  }
  Vec3 t = point.t - point.t.dot(up) * up;
  t = t.norm() > kNoDirection ? Vec3(t.normalized()) : up.unitOrthogonal();
  point.axis = tiltedAxis(t, up.cross(t), up, params.lead, params.lateralTilt);
}

Bead makeBead(const Contour& contour,
              const SlicedLayer& layer,
              const Substrate& substrate,
              bool reversed,
              const PathParams& params) {
  Bead bead;
  bead.closed = contour.closed;
  bead.part = contour.part;
  const std::size_t n = contour.points.size();
  bead.points.resize(n + (contour.closed ? 1 : 0));
  for (std::size_t i = 0; i < bead.points.size(); ++i) {
    const ContourPoint& here = contour.points[i % n];
    const Vec3& before =
        contour.closed ? contour.points[(i + n - 1) % n].p : contour.points[i > 0 ? i - 1 : 0].p;
    const Vec3& after =
        contour.closed ? contour.points[(i + 1) % n].p : contour.points[std::min(i + 1, n - 1)].p;
    PathPoint& point = bead.points[i];
    point.p = here.p;
    // A reversed bead keeps its build direction: the normal then points to the other side of the
    // travel.
    setFrame(point, tangentAt(before, here.p, after), reversed ? Vec3(-here.n) : here.n, layer.up);
    const Vec3 up = params.axis == AxisMode::Local   ? point.b
                    : params.axis == AxisMode::Layer ? layer.up
                                                     : substrate.up();
    setAxis(point, up, params);
  }
  return bead;
}

/// A bead that is nowhere nearer to what lies below it than this many nominal heights hangs in the
/// air.
constexpr double kUnsupported = 2.0;

/// Distances of a layer's points to the layer below or to the substrate, whichever is nearer.
void setDistances(Layer& layer,
                  const SlicedLayer& sliced,
                  const SlicedLayer* below,
                  const Substrate& substrate) {
  std::vector<Vec3> points;
  for (const Bead& bead : layer.beads) {
    for (const PathPoint& point : bead.points) {
      points.push_back(point.p);
    }
  }
  const std::vector<double> toLayer =
      below != nullptr
          ? layerDistance(points, below->contours)
          : std::vector<double>(points.size(), std::numeric_limits<double>::infinity());
  // A layer on the substrate itself has no height of its own: the wanted one holds.
  const double onSubstrate = kOnSubstrate * sliced.nominalHeight;
  std::size_t i = 0;
  for (Bead& bead : layer.beads) {
    for (PathPoint& point : bead.points) {
      const double above = substrate.heightAbove(point.p);
      const double nearest = above > onSubstrate ? std::min(toLayer[i], above) : toLayer[i];
      const bool known = std::isfinite(nearest) && nearest > onSubstrate;
      point.distance = point.height = known ? nearest : sliced.nominalHeight;
      ++i;
    }
  }
}

void reportUnsupported(const Layer& layer,
                       int layerIndex,
                       double nominalHeight,
                       const JobContext& context) {
  for (std::size_t b = 0; b < layer.beads.size(); ++b) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const PathPoint& point : layer.beads[b].points) {
      nearest = std::min(nearest, point.distance);
    }
    if (nearest > kUnsupported * nominalHeight) {
      context.add(
          {Severity::Warning,
           "toolpath.unsupported",
           "a bead lies " + formatFixed(nearest, 2) + " mm or more above everything below it",
           "build this place on something: another order, a support or another build direction",
           {{}, layerIndex, static_cast<int>(b), -1},
           {{"distance_mm", nearest}}});
    }
  }
}

/// Points of the first layer beside the plate.
void reportOutsidePlate(const Layer& first, const Substrate& substrate, const JobContext& context) {
  if (!substrate.isPlate()) {
    return;
  }
  const geometry::Pose T_substrate_part = substrate.pose().inverse();
  const Vec3 half = 0.5 * substrate.size();
  std::size_t outside = 0;
  double farthest = 0.0;
  for (const Bead& bead : first.beads) {
    for (const PathPoint& point : bead.points) {
      const Vec3 p = T_substrate_part * point.p;
      const double excess = std::max(std::abs(p.x()) - half.x(), std::abs(p.y()) - half.y());
      outside += excess > 0.0 ? 1U : 0U;
      farthest = std::max(farthest, excess);
    }
  }
  if (outside > 0) {
    context.add({Severity::Warning,
                 "toolpath.outside_plate",
                 std::to_string(outside) +
                     " points of the first layer lie beside the plate, up to " +
                     formatFixed(farthest, 1) + " mm",
                 "move the part or choose a larger plate",
                 {{}, 0, -1, -1},
                 {{"points", static_cast<double>(outside)}, {"excess_mm", farthest}}});
  }
}

}  // namespace

Toolpath buildToolpath(const SlicedLayers& sliced,
                       const Substrate& substrate,
                       const PathParams& params,
                       const JobContext& context) {
  Toolpath path;
  SeamChooser seams(params, substrate);
  for (std::size_t l = 0; l < sliced.layers.size(); ++l) {
    context.check();
    const SlicedLayer& source = sliced.layers[l];
    Layer layer;
    layer.level = source.level;
    layer.up = source.up;
    const bool reversed = params.alternate && l % 2 == 1;
    for (const OrderedContour& ordered : seams.arrange(source, l, reversed)) {
      layer.beads.push_back(makeBead(ordered.contour, source, substrate, ordered.reversed, params));
    }
    setDistances(layer, source, l > 0 ? &sliced.layers[l - 1] : nullptr, substrate);
    reportUnsupported(layer, static_cast<int>(l), source.nominalHeight, context);
    path.layers.push_back(std::move(layer));
    context.report(static_cast<double>(l + 1) / static_cast<double>(sliced.layers.size()));
  }
  if (!path.layers.empty()) {
    reportOutsidePlate(path.layers.front(), substrate, context);
  }
  return path;
}

}  // namespace wcam::toolpath
