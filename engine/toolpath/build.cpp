// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/build.hpp"

#include "wcam/base/parallel.hpp"
#include "wcam/base/text.hpp"
#include "wcam/geometry/segment_tree.hpp"
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
/// A bead of which all points are nearer than this part lies on it too: what is between is the
/// noise of the part's file.
constexpr double kBeadOnSubstrate = 0.01;

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
    point.fillWidth = here.fillWidth;
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
      throw Error(ErrorCode::InvalidArgument,
                  text("the strategy names layer %1 below layer %2 of %3",
                       {std::to_string(l + 1), std::to_string(layer + 1),
                        std::to_string(sliced.layers.size())}),
                  text("layer %1", {std::to_string(layer + 1)}),
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

/// What a point of a bead lies on.
struct Support {
  double distance = std::numeric_limits<double>::infinity();  ///< mm
  bool substrate = false;
};

/// The substrate counts where it is met before the layers below, going down against the build
/// direction: a wall that grows sideways just above the plate lies on its own last layer, however
/// near the plate is, and layers about an axis that stands on the plate have nothing of it below.
/// The distance is the shortest one, as to the layers (Chalvin A4): on a slope it is not the
/// height.
Support supportOf(const PathPoint& point,
                  double toLayer,
                  const Substrate& substrate,
                  double onSubstrate) {
  const Substrate::Foot foot = substrate.nearest(point.p);
  if (std::abs(foot.distance) <= onSubstrate) {
    return {toLayer, true};
  }
  const double descent = point.b.dot(foot.direction);
  // Directions that reach the substrate only farther than a hundred times away run along it.
  constexpr double kAlong = 0.01;
  const bool counts = descent > kAlong && foot.distance > 0.0 && foot.distance < descent * toLayer;
  return counts ? Support{foot.distance, true} : Support{toLayer, false};
}

/// Distances of a layer's points to what lies below them: the layers below, the substrate or the
/// bead's own revolution before; and the heights that follow from them.
/// @param substrate null for layers that do not stand on it
/// @returns what the points of all beads lie on, in order
std::vector<Support> setDistances(Layer& layer,
                                  const std::vector<OrderedContour>& ordered,
                                  const SlicedLayer& sliced,
                                  const std::vector<const Contour*>& below,
                                  const Substrate* substrate) {
  std::vector<Vec3> points;
  std::vector<PathPoint*> own;
  std::vector<Support> supports;
  for (std::size_t b = 0; b < layer.beads.size(); ++b) {
    const std::vector<Vec3> positions = positionsOf(layer.beads[b]);
    points.insert(points.end(), positions.begin(), positions.end());
    for (const double distance : revolutionDistance(positions, ordered[b].contour.turns)) {
      supports.push_back({distance, false});
    }
    for (PathPoint& point : layer.beads[b].points) {
      own.push_back(&point);
    }
  }
  const std::vector<double> toLayer = layerDistance(points, below);
  // A layer on the substrate itself has no height of its own: the wanted one holds.
  std::vector<double> onSubstrate;
  for (const Bead& bead : layer.beads) {
    const bool lies = substrate != nullptr &&
                      std::all_of(bead.points.begin(), bead.points.end(), [&](const PathPoint& p) {
                        return std::abs(substrate->nearest(p.p).distance) <=
                               kBeadOnSubstrate * sliced.nominalHeight;
                      });
    onSubstrate.insert(onSubstrate.end(), bead.points.size(),
                       (lies ? kBeadOnSubstrate : kOnSubstrate) * sliced.nominalHeight);
  }
  constexpr std::size_t kGrain = 512;
  parallelFor(own.size(), kGrain, [&](std::size_t i) {
    PathPoint& point = *own[i];
    const double toPath = std::min(toLayer[i], supports[i].distance);
    supports[i] = substrate != nullptr ? supportOf(point, toPath, *substrate, onSubstrate[i])
                                       : Support{toPath, false};
    const double nearest = supports[i].distance;
    const bool known = std::isfinite(nearest) && nearest > onSubstrate[i];
    const double unknown = point.height > 0.0 ? point.height : sliced.nominalHeight;
    point.distance = known ? nearest : unknown;
    point.height = point.height > 0.0 ? point.height : point.distance;
  });
  return supports;
}

/// Least distance of a bead's points to the beads of its layer before it.
double besideDistance(const Layer& layer, std::size_t bead) {
  geometry::SegmentTree tree;
  for (std::size_t b = 0; b < bead; ++b) {
    tree.add(positionsOf(layer.beads[b]), false);
  }
  tree.build();
  double nearest = std::numeric_limits<double>::infinity();
  for (const PathPoint& point : layer.beads[bead].points) {
    nearest = std::min(nearest, tree.distance(point.p));
  }
  return nearest;
}

/// A bead in the air cannot be deposited: a violation, unless it is welded to a bead beside it or
/// below it to one side.
void reportUnsupported(const Layer& layer,
                       int layerIndex,
                       double nominalHeight,
                       double width,
                       const JobContext& context) {
  for (std::size_t b = 0; b < layer.beads.size(); ++b) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const PathPoint& point : layer.beads[b].points) {
      nearest = std::min(nearest, point.distance);
    }
    if (nearest > kUnsupported * nominalHeight) {
      // A bead no farther aside than its width still touches the one below.
      const bool touches = nearest <= std::hypot(width, kUnsupported * nominalHeight);
      const bool beside = touches || (b > 0 && besideDistance(layer, b) <= width);
      context.add(
          {beside ? Severity::Warning : Severity::Violation,
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

/// Points that lie on the plate's plane but not on the plate. A spiral's later revolutions lie on
/// the ones before.
class OutsidePlate {
public:
  OutsidePlate(const Substrate& substrate, double width)
      : substrate_(substrate),
        T_substrate_part_(substrate.pose().inverse()),
        half_(0.5 * substrate.size()),
        width_(width) {}

  /// @param nominalHeight of the layer, mm: what hangs higher above the plate is unsupported
  void add(const Layer& layer,
           int layerIndex,
           const std::vector<Support>& supports,
           double nominalHeight) {
    if (!substrate_.isPlate()) {
      return;
    }
    std::size_t i = 0;
    for (const Bead& bead : layer.beads) {
      for (const PathPoint& point : bead.points) {
        if (!supports[i++].substrate || point.distance > kUnsupported * nominalHeight) {
          continue;
        }
        const Vec3 p = T_substrate_part_ * point.p;
        const double excess = std::max(std::abs(p.x()) - half_.x(), std::abs(p.y()) - half_.y());
        low_ = low_.cwiseMin(p);
        high_ = high_.cwiseMax(p);
        outside_ += excess > 0.0 ? 1U : 0U;
        if (excess > farthest_) {
          farthest_ = excess;
          layer_ = layerIndex;
        }
      }
    }
  }

  /// A bead whose middle lies beyond the edge by half its width meets nothing of the plate.
  void report(const JobContext& context) const {
    if (outside_ == 0) {
      return;
    }
    const bool off = farthest_ > 0.5 * width_;
    context.add(
        {off ? Severity::Violation : Severity::Warning,
         "toolpath.outside_plate",
         text(outside_ == 1 ? "%1 point that should lie on the plate lies beside it, by %2 mm"
                            : "%1 points that should lie on the plate lie beside it, by up "
                              "to %2 mm",
              {std::to_string(outside_), formatFixed(farthest_, 1)}),
         remedy(),
         {{}, layer_, -1, -1},
         {{"points", static_cast<double>(outside_)}, {"excess_mm", farthest_}}});
  }

private:
  /// The move along the plate that takes all beads onto it, or the plate that would hold them.
  [[nodiscard]] Text remedy() const {
    const Vec3 size = high_ - low_ + Vec3(width_, width_, 0.0);
    if (size.x() > 2.0 * half_.x() || size.y() > 2.0 * half_.y()) {
      return text("choose a plate of %1 by %2 mm or more, and place the part on it",
                  {formatFixed(std::ceil(size.x()), 0), formatFixed(std::ceil(size.y()), 0)});
    }
    Vec3 move = Vec3::Zero();
    for (int axis = 0; axis < 2; ++axis) {
      const double least = -half_[axis] + 0.5 * width_ - low_[axis];
      const double most = half_[axis] - 0.5 * width_ - high_[axis];
      move[axis] = std::clamp(0.0, least, most);
    }
    move = substrate_.pose().linear() * move;
    return text("move the part by (%1, %2, %3) mm, or choose a larger plate",
                {formatFixed(move.x(), 2), formatFixed(move.y(), 2), formatFixed(move.z(), 2)});
  }

  const Substrate& substrate_;
  geometry::Pose T_substrate_part_;
  Vec3 half_;
  double width_;
  std::size_t outside_ = 0;
  double farthest_ = 0.0;
  int layer_ = 0;
  /// Beads on the plate's plane, in its frame.
  Vec3 low_ = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high_ = Vec3::Constant(-std::numeric_limits<double>::infinity());
};

}  // namespace

Toolpath buildToolpath(const SlicedLayers& contours,
                       const Substrate& substrate,
                       const PathParams& params,
                       const JobContext& context,
                       const BeadRange& range) {
  const SlicedLayers sliced = withBeadReference(contours, substrate, params, range.width, context);
  Toolpath path;
  BeadOrder order(params, substrate);
  OutsidePlate outside(substrate, range.width);
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
    const std::vector<Support> supports =
        setDistances(layer, ordered, source, contoursBelow(sliced, l),
                     sliced.onSubstrate ? &substrate : nullptr);
    outside.add(layer, static_cast<int>(l), supports, source.nominalHeight);
    reportUnsupported(layer, static_cast<int>(l), source.nominalHeight, range.width, context);
    for (Bead& bead : layer.beads) {
      addZones(bead, params.zones());
    }
    path.layers.push_back(std::move(layer));
    context.report(static_cast<double>(l + 1) / static_cast<double>(sliced.layers.size()));
  }
  outside.report(context);
  return path;
}

}  // namespace wcam::toolpath
