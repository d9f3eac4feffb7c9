// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/toolpath/constant_distance.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"
#include "wcam/geometry/level_set.hpp"
#include "wcam/geometry/refine.hpp"
#include "wcam/toolpath/layer_distance.hpp"
#include "wcam/toolpath/onto_parts.hpp"

#include "corner_smoothing.hpp"
#include "front_base.hpp"
#include "front_curve.hpp"
#include "front_line.hpp"

#include <queue>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::toolpath {

using geometry::HalfEdges;
using geometry::PartSurface;

namespace {

/// Chord of the line that distances are measured from, in steps: its error is of second order in
/// the distance, so that layers do not feel it.
constexpr double kLineChord = 1e-4;
/// Rounding of a distance, in parts of the part's size.
constexpr double kSnap = 1e-12;
/// A contour shorter than this part of the step is where a front vanishes: a point.
constexpr double kPointContour = 1e-3;
/// More layers than this are a wrong step.
constexpr std::size_t kMostLayers = 1000000;
/// Longest edge of the mesh that carries the fronts, in steps: then the distance behind a front
/// never reaches the step on an edge that leads ahead of it.
constexpr double kLongestEdge = 0.9;

/// The layers of one part, one after the other.
class Fronts {
public:
  Fronts(const PartSurface& part, const Substrate& substrate, const JobContext& context)
      : part_(part),
        patch_(part),
        size_(std::max(1.0, part.mesh.bounds().diagonal())),
        base_(findFrontBase(patch_, substrate, context)) {
    const std::size_t n = part.mesh.vertices.size();
    covered_.assign(base_.covered.begin(), base_.covered.end());
    distance_.resize(n);
    segment_.resize(n);
    local_.resize(n);
    stamp_.assign(n, 0);
    triangleStamp_.assign(part.mesh.triangles.size(), 0);
    listTriangles();
  }

  [[nodiscard]] const FrontBase& base() const { return base_; }

  [[nodiscard]] const SurfacePatch& patch() const { return patch_; }

  /// Starts from the base.
  void begin(double step) {
    for (const TracedCurve& traced : base_.curves) {
      addToLine(*traced.curve, traced.triangles, kLineChord * step);
    }
  }

  /// The points at distance `step` of the current line; the line moves on. Empty at the end.
  std::vector<FrontCurve> advance(double step, double nextStep) {
    propagate(step);
    lines_.push_back(std::move(line_));  // the curves refer to it
    line_ = std::make_unique<FrontLine>();
    std::vector<FrontCurve> curves = trace(*lines_.back(), step);
    for (const std::uint32_t v : band_) {
      // A vertex on the layer is ahead of it, as it is for the tracing.
      covered_[v] =
          covered_[v] || (stamp_[v] == generation_ && distance_[v] < step - kSnap * size_);
    }
    seeds_.clear();
    for (const FrontCurve& curve : curves) {
      std::vector<std::uint32_t> triangles;
      for (const FrontPiece& piece : curve.list) {
        triangles.push_back(piece.triangle);
      }
      addToLine(curve, triangles, kLineChord * nextStep);
    }
    if (lines_.size() > 1) {
      lines_.erase(lines_.begin());
    }
    return curves;
  }

  [[nodiscard]] std::size_t unrefined() const { return unrefined_; }

  /// Vertices of the wall that no layer came to.
  [[nodiscard]] std::size_t notReached() const {
    std::size_t count = 0;
    for (std::size_t v = 0; v < reached_.size(); ++v) {
      count += reached_[v] || base_.covered[v] ? 0U : 1U;
    }
    return count;
  }

private:
  struct Seed {
    std::uint32_t triangle;
    std::int32_t segment;
  };

  void listTriangles() {
    firstTriangle_.assign(part_.mesh.vertices.size() + 1, 0);
    for (const auto& t : part_.mesh.triangles) {
      for (const std::uint32_t v : t) {
        ++firstTriangle_[v + 1];
      }
    }
    for (std::size_t v = 1; v < firstTriangle_.size(); ++v) {
      firstTriangle_[v] += firstTriangle_[v - 1];
    }
    trianglesOf_.resize(3 * part_.mesh.triangles.size());
    std::vector<std::uint32_t> fill(firstTriangle_.begin(), firstTriangle_.end() - 1);
    for (std::uint32_t t = 0; t < part_.mesh.triangles.size(); ++t) {
      for (const std::uint32_t v : part_.mesh.triangles[t]) {
        trianglesOf_[fill[v]++] = t;
      }
    }
    reached_.assign(part_.mesh.vertices.size(), false);
  }

  void addToLine(const SampledCurve& curve,
                 const std::vector<std::uint32_t>& triangles,
                 double chord) {
    if (line_ == nullptr) {
      line_ = std::make_unique<FrontLine>();
    }
    const std::vector<std::int32_t> middles = line_->add(curve, chord);
    for (std::size_t i = 0; i < middles.size(); ++i) {
      seeds_.push_back({triangles[i], middles[i]});
    }
  }

  /// Takes the distance of a vertex from the line near a segment. True when it is the least yet.
  bool relax(std::uint32_t v, std::int32_t hint) {
    const FrontLine::Foot foot = line_->nearest(part_.mesh.vertices[v], hint);
    if (stamp_[v] == generation_ && !(foot.distance < distance_[v])) {
      return false;
    }
    if (stamp_[v] != generation_) {
      stamp_[v] = generation_;
      band_.push_back(v);
    }
    distance_[v] = foot.distance;
    segment_[v] = foot.segment;
    return true;
  }

  void addTriangle(std::uint32_t t) {
    if (triangleStamp_[t] != generation_) {
      triangleStamp_[t] = generation_;
      bandTriangles_.push_back(t);
    }
  }

  /// Distances of the vertices ahead of the line, from neighbour to neighbour, up to `step`.
  void propagate(double step) {
    ++generation_;
    band_.clear();
    bandTriangles_.clear();
    using Item = std::pair<double, std::uint32_t>;
    std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
    for (const Seed& seed : seeds_) {
      addTriangle(seed.triangle);
      for (const std::uint32_t v : part_.mesh.triangles[seed.triangle]) {
        if (relax(v, seed.segment) && !covered_[v]) {
          queue.emplace(distance_[v], v);
        }
      }
    }
    while (!queue.empty()) {
      const auto [d, v] = queue.top();
      queue.pop();
      if (d > distance_[v] || !(d < step)) {
        continue;
      }
      for (std::uint32_t k = firstTriangle_[v]; k < firstTriangle_[v + 1]; ++k) {
        addTriangle(trianglesOf_[k]);
        for (const std::uint32_t w : part_.mesh.triangles[trianglesOf_[k]]) {
          if (w != v && !covered_[w] && relax(w, segment_[v])) {
            queue.emplace(distance_[w], w);
          }
        }
      }
    }
    for (const std::uint32_t v : band_) {
      reached_[v] = true;
    }
  }

  /// The band as a mesh of its own with distances counted negative behind the line.
  geometry::TriangleMesh bandMesh(std::vector<double>& scalar, double step) {
    geometry::TriangleMesh mesh;
    std::sort(bandTriangles_.begin(), bandTriangles_.end());
    constexpr std::uint32_t kUnknown = HalfEdges::kNone;
    for (const std::uint32_t t : bandTriangles_) {
      for (const std::uint32_t v : part_.mesh.triangles[t]) {
        local_[v] = kUnknown;
      }
    }
    for (const std::uint32_t t : bandTriangles_) {
      std::array<std::uint32_t, 3> corners{};
      for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t v = part_.mesh.triangles[t][c];
        if (local_[v] == kUnknown) {
          local_[v] = static_cast<std::uint32_t>(mesh.vertices.size());
          mesh.vertices.push_back(part_.mesh.vertices[v]);
          const bool known = stamp_[v] == generation_;
          scalar.push_back(covered_[v] ? (known ? -distance_[v] : -step) : distance_[v]);
        }
        corners[c] = local_[v];
      }
      mesh.triangles.push_back(corners);
    }
    return mesh;
  }

  struct Node {
    std::uint32_t halfEdge = 0;
    double fraction = 0.0;
    Vec3 p = Vec3::Zero();
    std::int32_t foot = -1;
  };

  /// The place on a mesh edge that has the distance exactly.
  Node solveNode(const FrontLine& below, std::uint32_t halfEdge, double guess, double step) {
    const auto& t = part_.mesh.triangles[halfEdge / 3];
    const std::uint32_t from = t[halfEdge % 3];
    const std::uint32_t to = t[(halfEdge % 3 + 1) % 3];
    const auto hint = [&](std::uint32_t v, std::uint32_t other) {
      return stamp_[v] == generation_ ? segment_[v] : segment_[other];
    };
    const std::int32_t hintA = hint(from, to);
    const std::int32_t hintB = hint(to, from);
    const auto value = [&](std::uint32_t v) {
      return (covered_[v] ? -1.0 : distance_[v] / step) - 1.0;
    };
    const double tolerance = kSnap * size_;
    double low = 0.0;
    double high = 1.0;
    double fLow = step * value(from);
    double fHigh = step * value(to);
    const bool rising = fLow < fHigh;
    Node node{halfEdge, guess, {}, hintA};
    if (!((fLow < 0.0) != (fHigh < 0.0))) {
      node.p = patch_.edgePoint(halfEdge, guess);
      node.foot = below.nearest(node.p, hintA, hintB).segment;
      return node;  // a vertex on the level
    }
    constexpr int kSteps = 80;
    for (int i = 0; i < kSteps; ++i) {
      node.p = patch_.edgePoint(halfEdge, node.fraction);
      const FrontLine::Foot foot = below.nearest(node.p, hintA, hintB);
      node.foot = foot.segment;
      const double f = foot.distance - step;
      if (std::abs(f) <= tolerance) {
        return node;
      }
      const bool takeLow = (f < 0.0) == rising;
      // Illinois: the end that stays twice counts half.
      if (takeLow) {
        fHigh *= lastSide_ == 1 ? 0.5 : 1.0;
        low = node.fraction;
        fLow = f;
        lastSide_ = 1;
      } else {
        fLow *= lastSide_ == 2 ? 0.5 : 1.0;
        high = node.fraction;
        fHigh = f;
        lastSide_ = 2;
      }
      const double secant = low - fLow * (high - low) / (fHigh - fLow);
      const double next = secant > low && secant < high ? secant : 0.5 * (low + high);
      if (next == node.fraction || high - low <= std::numeric_limits<double>::epsilon()) {
        break;
      }
      node.fraction = next;
    }
    constexpr double kAccepted = 1e4;
    unrefined_ += std::abs((node.p - below.nearest(node.p, hintA, hintB).point).norm() - step) >
                          kAccepted * tolerance
                      ? 1U
                      : 0U;
    return node;
  }

  FrontPiece makePiece(const Node& from, const Node& to) const {
    FrontPiece piece;
    piece.triangle = from.halfEdge / 3;
    piece.footA = from.foot;
    piece.footB = to.foot;
    const auto place = [&](const Node& node, geometry::Vec2& uv, ContourPoint& point) {
      uv = patch_.onHalfEdge(piece.triangle, node.halfEdge, node.fraction);
      geometry::SurfacePoint s = patch_.surface(piece.triangle, uv);
      if ((s.p - node.p).norm() > kSnap * size_) {
        uv = patch_.project(piece.triangle, uv, node.p);
        s = patch_.surface(piece.triangle, uv);
      }
      point = {node.p, patch_.normal(piece.triangle, uv, s)};
    };
    place(from, piece.uvA, piece.a);
    place(to, piece.uvB, piece.b);
    return piece;
  }

  std::vector<FrontCurve> trace(const FrontLine& below, double step) {
    std::vector<FrontCurve> curves;
    if (bandTriangles_.empty() || below.empty()) {
      return curves;
    }
    std::vector<double> scalar;
    const geometry::TriangleMesh mesh = bandMesh(scalar, step);
    const HalfEdges halfEdges(mesh);
    const std::vector<double> levels{step};
    const auto contours = geometry::traceLevels(
        mesh, halfEdges, scalar, levels, {kSnap * size_, geometry::flatTolerance(part_.mesh)});
    for (const geometry::LevelContour& contour : contours[0]) {
      FrontCurve curve(patch_, below, step, size_);
      curve.ring = contour.closed;
      std::vector<Node> nodes;
      double length = 0.0;
      for (std::size_t i = 0; i < contour.points.size(); ++i) {
        const std::uint32_t h = contour.halfEdges[i];
        lastSide_ = 0;
        nodes.push_back(
            solveNode(below, 3 * bandTriangles_[h / 3] + h % 3, contour.fractions[i], step));
        length += i > 0 ? (nodes[i].p - nodes[i - 1].p).norm() : 0.0;
      }
      if (length <= kPointContour * step) {
        continue;
      }
      const std::size_t pieces = nodes.size() - (contour.closed ? 0 : 1);
      for (std::size_t i = 0; i < pieces; ++i) {
        curve.list.push_back(makePiece(nodes[i], nodes[(i + 1) % nodes.size()]));
      }
      if (!patch_.exact()) {
        curve.smoothMeshNormals();
      }
      curve.insertCorners();
      curves.push_back(std::move(curve));
    }
    return curves;
  }

  const PartSurface& part_;
  SurfacePatch patch_;
  double size_;
  FrontBase base_;
  std::vector<bool> covered_;
  std::vector<bool> reached_;
  std::vector<double> distance_;       ///< to the line, of vertices with the current stamp
  std::vector<std::int32_t> segment_;  ///< of the line, nearest to the vertex
  std::vector<std::uint32_t> local_;   ///< index in the band's mesh
  std::vector<std::uint32_t> stamp_;
  std::vector<std::uint32_t> triangleStamp_;
  std::uint32_t generation_ = 0;
  std::vector<std::uint32_t> firstTriangle_;
  std::vector<std::uint32_t> trianglesOf_;
  std::vector<std::uint32_t> band_;
  std::vector<std::uint32_t> bandTriangles_;
  std::unique_ptr<FrontLine> line_;
  std::vector<std::unique_ptr<FrontLine>> lines_;  ///< the one below the current layer
  std::vector<Seed> seeds_;
  int lastSide_ = 0;
  std::size_t unrefined_ = 0;
};

struct Layer {
  std::vector<Contour> contours;
  Vec3 up = Vec3::Zero();  ///< sum of the growth directions
};

/// Appends a sampled curve; b = t × n sums up to the layer's growth direction.
void addContour(const SampledCurve& curve, int part, const Sampling& sampling, Layer& layer) {
  Contour contour;
  contour.closed = curve.closed();
  contour.part = part;
  contour.points = sampleCurve(curve, sampling);
  for (std::size_t i = 0; i + 1 < contour.points.size(); ++i) {
    const Vec3 d = contour.points[i + 1].p - contour.points[i].p;
    layer.up += d.cross(contour.points[i].n);
  }
  layer.contours.push_back(std::move(contour));
}

Layer& layerAt(std::vector<Layer>& layers, std::size_t index) {
  if (layers.size() <= index) {
    layers.resize(index + 1);
  }
  return layers[index];
}

double outsideOf(const CutPlane& plane, const Vec3& p) {
  return (p - plane.point).dot(plane.normal);
}

/// Makes contours of fronts.
class Emitter {
public:
  Emitter(const SurfacePatch& patch,
          int part,
          const ConstantDistanceOptions& options,
          const Sampling& sampling)
      : part_(part), options_(options), sampling_(sampling) {
    // Both layers move, each by half of the bound at most.
    if (options.cornerBound > 0.0) {
      smoothing_.emplace(patch, 0.5 * options.cornerBound);
    }
  }

  /// Adds what is visible of the fronts. @return whether any of it lies inside
  bool emit(const std::vector<FrontCurve>& fronts, Layer& layer) {
    bool any = false;
    for (const FrontCurve& front : fronts) {
      if (!options_.end) {
        add(front, layer);
        any = true;
        continue;
      }
      const auto outside = [&](const Vec3& p) { return outsideOf(*options_.end, p); };
      for (const FrontCurve& piece : keepInside(front, outside)) {
        add(piece, layer);
        any = true;
      }
    }
    return any;
  }

  [[nodiscard]] std::size_t rounded() const { return rounded_; }

private:
  void add(const FrontCurve& curve, Layer& layer) {
    addContour(curve, part_, sampling_, layer);
    if (smoothing_) {
      rounded_ += smoothing_->apply(layer.contours.back(), curve.corners);
    }
  }

  int part_;
  const ConstantDistanceOptions& options_;
  const Sampling& sampling_;
  std::optional<CornerSmoothing> smoothing_;
  std::size_t rounded_ = 0;
};

/// Tells of layers whose points do not have the distance, measured as A4 on the result.
void checkDistances(const SlicedLayers& sliced,
                    const ConstantDistanceOptions& options,
                    const Sampling& sampling,
                    const JobContext& context) {
  // Chords of the layer below lie this near to its curve.
  constexpr double kShare = 0.01;
  const double allowed =
      std::max(kShare * options.step, 1.1 * sampling.chordError) + options.cornerBound;
  for (std::size_t l = 1; l < sliced.layers.size(); ++l) {
    std::vector<Vec3> points;
    for (const Contour& contour : sliced.layers[l].contours) {
      for (const ContourPoint& point : contour.points) {
        points.push_back(point.p);
      }
    }
    const std::vector<double> distances = layerDistance(points, sliced.layers[l - 1].contours);
    std::size_t count = 0;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < distances.size(); ++i) {
      const double error = std::abs(distances[i] - options.step);
      count += error > allowed ? 1U : 0U;
      worst = error > std::abs(distances[worst] - options.step) ? i : worst;
    }
    if (count > 0) {
      const Vec3& p = points[worst];
      context.add({Severity::Warning,
                   "slicing.distance_not_kept",
                   text("%1 points of the layer do not have the step to the layer below, the worst "
                        "has %2 mm",
                        {std::to_string(count), formatFixed(distances[worst], 3)}),
                   "sharp edges of a mesh can do this: use a finer mesh edge length or the CAD "
                   "file",
                   {{}, static_cast<int>(l), -1, -1},
                   {{"points", static_cast<double>(count)},
                    {"distance_mm", distances[worst]},
                    {"x_mm", p.x()},
                    {"y_mm", p.y()},
                    {"z_mm", p.z()}}});
    }
  }
}

void slicePart(const PartSurface& part,
               int index,
               const Substrate& substrate,
               const ConstantDistanceOptions& options,
               const Sampling& sampling,
               std::vector<Layer>& layers,
               const JobContext& context) {
  Fronts fronts(part, substrate, context);
  const double first = options.firstLayer > 0.0 ? options.firstLayer * options.step : options.step;
  std::size_t layer = 0;
  if (!(options.firstLayer > 0.0)) {
    for (const TracedCurve& traced : fronts.base().curves) {
      addContour(*traced.curve, index, sampling, layerAt(layers, 0));
    }
    ++layer;
  }
  Emitter emitter(fronts.patch(), index, options, sampling);
  fronts.begin(first);
  for (double step = first; layer < kMostLayers; step = options.step, ++layer) {
    context.check();
    const std::vector<FrontCurve> curves = fronts.advance(step, options.step);
    if (curves.empty() || !emitter.emit(curves, layerAt(layers, layer))) {
      break;
    }
  }
  if (const std::size_t missing = fronts.notReached(); missing > 0 && !options.end) {
    context.add({Severity::Warning,
                 "slicing.not_reached",
                 "a piece of the part is not joined to the base and gets no layers",
                 "close the gaps of the part, or give the piece a base of its own",
                 {},
                 {{"vertices", static_cast<double>(missing)}}});
  }
  if (options.cornerBound > 0.0) {
    context.add(
        {Severity::Information,
         "slicing.corners_rounded",
         text("%1 corners were rounded; there the distance differs from the step by up to %2 mm",
              {std::to_string(emitter.rounded()), formatFixed(options.cornerBound, 3)}),
         {},
         {},
         {{"corners", static_cast<double>(emitter.rounded())}, {"bound_mm", options.cornerBound}}});
  }
  if (fronts.unrefined() > 0) {
    context.add(
        {Severity::Warning,
         "slicing.refinement_failed",
         text("%1 nodes do not have the wanted distance", {std::to_string(fronts.unrefined())}),
         "use a finer mesh",
         {},
         {{"nodes", static_cast<double>(fronts.unrefined())}}});
  }
}

}  // namespace

SlicedLayers sliceConstantDistance(const std::vector<std::shared_ptr<const PartSurface>>& parts,
                                   const Substrate& substrate,
                                   const ConstantDistanceOptions& options,
                                   const Sampling& sampling,
                                   const JobContext& context) {
  if (!(options.step > 0.0) || !(options.firstLayer >= 0.0)) {
    throw Error(ErrorCode::InvalidArgument, "the step must be positive", "slicing");
  }
  std::vector<Layer> layers;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const JobContext portion =
        context.portion(static_cast<double>(k) / static_cast<double>(parts.size()),
                        static_cast<double>(k + 1) / static_cast<double>(parts.size()), "slicing");
    const double edge = options.meshEdge > 0.0
                            ? options.meshEdge
                            : std::min(kLongestEdge * options.step,
                                       geometry::fieldEdgeLength(*parts[k], options.step));
    const PartSurface refined = geometry::refineSurface(*parts[k], edge, portion.portion(0.0, 0.4));
    slicePart(refined, static_cast<int>(k), substrate, options, sampling, layers,
              portion.portion(0.4, 1.0));
  }
  SlicedLayers sliced;
  sliced.curved = true;
  double level = 0.0;
  for (std::size_t l = 0; l < layers.size(); ++l) {
    const double height =
        l == 0 && options.firstLayer > 0.0 ? options.firstLayer * options.step : options.step;
    level += l == 0 && !(options.firstLayer > 0.0) ? 0.0 : height;
    if (layers[l].contours.empty()) {
      continue;
    }
    SlicedLayer layer;
    layer.level = level;
    layer.up = layers[l].up.norm() > 0.0 ? Vec3(layers[l].up.normalized()) : substrate.up();
    layer.nominalHeight = height;
    layer.contours = std::move(layers[l].contours);
    sliced.layers.push_back(std::move(layer));
  }
  if (sliced.layers.empty()) {
    throw Error(ErrorCode::JobFailed, "no layer fits on the part", "slicing",
                "the part ends less than one step above its base: choose a smaller step");
  }
  moveOntoParts(sliced, parts, sampling, context);
  checkDistances(sliced, options, sampling, context);
  return sliced;
}

}  // namespace wcam::toolpath
