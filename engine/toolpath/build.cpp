// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/build.hpp"

#include "wcam/base/text.hpp"
#include "wcam/toolpath/layer_distance.hpp"

#include "axis_rules.hpp"
#include "bead_order.hpp"
#include "bead_reference.hpp"
#include "frames.hpp"
#include "zones.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace wcam::toolpath {

namespace {

/// A point nearer to the substrate than this part of the layer height lies on it.
constexpr double kOnSubstrate = 1e-6;

Bead makeBead(const Contour& contour, const SlicedLayer& layer, bool reversed) {
  Bead bead;
  bead.closed = contour.closed;
  bead.part = contour.part;
  bead.feature = contour.feature;
  bead.back = reversed;
  bead.revolutions = static_cast<int>(contour.turns.size());
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
    // A reversed bead keeps its build direction: n is then the inward normal.
    setFrame(point, tangentAt(before, here.p, after), reversed ? Vec3(-here.n) : here.n, layer.up);
    point.height = here.height;
    point.width = here.width;
  }
  return bead;
}

/// A bead that is nowhere nearer to what lies below it than this many nominal heights hangs in the
/// air.
constexpr double kUnsupported = 2.0;

/// Contours of the layers below a layer.
std::vector<const Contour*> contoursBelow(const SlicedLayers& sliced, std::size_t layer) {
  std::vector<std::size_t> below;
  if (sliced.layers[layer].below) {
    below = *sliced.layers[layer].below;
  } else if (layer > 0) {
    below = {layer - 1};
  }
  std::vector<const Contour*> contours;
  for (const std::size_t l : below) {
    if (l >= sliced.layers.size() || l == layer) {
      throw Error(
          ErrorCode::InvalidArgument,
          text("the strategy names layer %1 below layer %2 of %3",
               {std::to_string(l), std::to_string(layer), std::to_string(sliced.layers.size())}),
          text("layer %1", {std::to_string(layer)}),
          "this is a fault of the strategy's plugin; report it to its author");
    }
    for (const Contour& contour : sliced.layers[l].contours) {
      contours.push_back(&contour);
    }
  }
  return contours;
}

std::vector<Vec3> positionsOf(const Bead& bead) {
  std::vector<Vec3> points;
  points.reserve(bead.points.size());
  for (const PathPoint& point : bead.points) {
    points.push_back(point.p);
  }
  return points;
}

/// Distances of a layer's points to the layers below, to the substrate or to the bead's own
/// revolution before, whichever is nearest; and the heights that follow from them.
void setDistances(Layer& layer,
                  const std::vector<OrderedContour>& ordered,
                  const SlicedLayer& sliced,
                  const std::vector<const Contour*>& below,
                  const Substrate& substrate) {
  std::vector<Vec3> points;
  std::vector<double> own;
  for (std::size_t b = 0; b < layer.beads.size(); ++b) {
    const std::vector<Vec3> positions = positionsOf(layer.beads[b]);
    const std::vector<double> distances = revolutionDistance(positions, ordered[b].contour.turns);
    points.insert(points.end(), positions.begin(), positions.end());
    own.insert(own.end(), distances.begin(), distances.end());
  }
  const std::vector<double> toLayer = layerDistance(points, below);
  // A layer on the substrate itself has no height of its own: the wanted one holds.
  const double onSubstrate = kOnSubstrate * sliced.nominalHeight;
  std::size_t i = 0;
  for (Bead& bead : layer.beads) {
    for (PathPoint& point : bead.points) {
      const double above = substrate.heightAbove(point.p);
      double nearest = std::min(toLayer[i], own[i]);
      nearest = above > onSubstrate ? std::min(nearest, above) : nearest;
      const bool known = std::isfinite(nearest) && nearest > onSubstrate;
      const double unknown = point.height > 0.0 ? point.height : sliced.nominalHeight;
      point.distance = known ? nearest : unknown;
      point.height = point.height > 0.0 ? point.height : point.distance;
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
           text("a bead lies %1 mm or more above everything below it", {formatFixed(nearest, 2)}),
           "build this place on something: another order, a support or another build direction",
           {{}, layerIndex, static_cast<int>(b), -1},
           {{"distance_mm", nearest}}});
    }
  }
}

void reportSeams(std::size_t tooClose,
                 int layer,
                 const PathParams& params,
                 const JobContext& context) {
  if (tooClose == 0) {
    return;
  }
  context.add({Severity::Warning,
               "toolpath.seam_too_close",
               text("%1 beads have no start %2 mm away from the starts of the last %3 layers; the "
                    "farthest point is used",
                    {std::to_string(tooClose), formatFixed(params.seamKeepAway.value(), 1),
                     std::to_string(params.seamMemory)}),
               "lower seam_keep_away or seam_memory",
               {{}, layer, -1, -1},
               {{"beads", static_cast<double>(tooClose)}}});
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
                 text("%1 points of the first layer lie beside the plate, up to %2 mm",
                      {std::to_string(outside), formatFixed(farthest, 1)}),
                 "move the part or choose a larger plate",
                 {{}, 0, -1, -1},
                 {{"points", static_cast<double>(outside)}, {"excess_mm", farthest}}});
  }
}

}  // namespace

Toolpath buildToolpath(const SlicedLayers& contours,
                       const Substrate& substrate,
                       const PathParams& params,
                       const JobContext& context,
                       const BeadRange& range) {
  const SlicedLayers sliced =
      withBeadReference(contours, params.beadReference, range.width, params.sampling(), context);
  Toolpath path;
  BeadOrder order(params, substrate);
  for (std::size_t l = 0; l < sliced.layers.size(); ++l) {
    context.check();
    const SlicedLayer& source = sliced.layers[l];
    Layer layer;
    layer.level = source.level;
    layer.up = source.up;
    const std::vector<OrderedContour> ordered = order.arrange(source, l, sliced.asGiven);
    reportSeams(order.seams().takeTooClose(), static_cast<int>(l), params, context);
    for (const OrderedContour& item : ordered) {
      layer.beads.push_back(makeBead(item.contour, source, item.reversed != item.contour.back));
    }
    setAxes(layer, ordered, sliced.curved, substrate, params, static_cast<int>(l), context);
    setDistances(layer, ordered, source, contoursBelow(sliced, l), substrate);
    reportUnsupported(layer, static_cast<int>(l), source.nominalHeight, context);
    for (Bead& bead : layer.beads) {
      addZones(bead, params.zones());
    }
    path.layers.push_back(std::move(layer));
    context.report(static_cast<double>(l + 1) / static_cast<double>(sliced.layers.size()));
  }
  if (!path.layers.empty()) {
    reportOutsidePlate(path.layers.front(), substrate, context);
  }
  return path;
}

}  // namespace wcam::toolpath
