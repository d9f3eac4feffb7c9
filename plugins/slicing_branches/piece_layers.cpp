// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "piece_layers.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"
#include "wcam/geometry/cut_mesh.hpp"
#include "wcam/geometry/geodesic.hpp"
#include "wcam/geometry/level_set.hpp"
#include "wcam/geometry/refine.hpp"
#include "wcam/toolpath/base_curve.hpp"
#include "wcam/toolpath/field_heights.hpp"
#include "wcam/toolpath/iso_field.hpp"
#include "wcam/toolpath/layer_levels.hpp"
#include "wcam/toolpath/plane_field.hpp"
#include "wcam/toolpath/spiral.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace wcam::branches {

namespace {

using geometry::FieldPiece;
using geometry::PartSurface;
using geometry::Vec3;
using toolpath::LayerLevel;
using toolpath::SlicedLayer;

/// Levels nearer to the end of a piece than this part of a step lie on it.
constexpr double kOnEnd = 1e-6;

/// The field is smooth over many layers: the mesh resolves the shape, not the layers.
constexpr double kLayersPerEdge = 2.0;

/// One part on its way to layers.
class PartSlicer {
public:
  PartSlicer(const plugin::SliceInput& input,
             std::size_t part,
             const PieceOptions& options,
             const JobContext& context)
      : input_(input),
        part_(part),
        options_(options),
        context_(context),
        step_(options.layers.step) {}

  std::vector<PieceLayers> run() {
    makeField();
    std::vector<FieldPiece> pieces = geometry::splitAtSaddles(
        wall_, field_, options_.leastBranch, context_.portion(0.4, 0.6, "branches"));
    report(pieces);
    checkMethods(pieces.size());
    std::vector<PieceLayers> result;
    for (FieldPiece& piece : pieces) {
      context_.check();
      result.push_back(slicePiece(std::move(piece), result.size()));
      context_.report(0.6 + 0.4 * static_cast<double>(result.size()) /
                                static_cast<double>(pieces.size()));
    }
    return result;
  }

private:
  void makeField() {
    const PartSurface& part = *input_.parts[part_];
    if (options_.field == Field::Height) {
      toolpath::PlaneStackOptions stack;
      stack.layers.step = step_;
      stack.layers.firstLayer = options_.layers.firstLayer;
      stack_ = toolpath::planeStack(input_.parts, *input_.substrate, stack);
      wall_ = options_.methods.common() ? part : fineWall();
      for (const Vec3& p : wall_.mesh.vertices) {
        field_.push_back(stack_.up.dot(p) - stack_.base);
      }
      return;
    }
    wall_ = fineWall();
    const JobContext own = context_.withOwnDiagnostics();
    if (options_.field == Field::Geodesic) {
      const toolpath::PartBase base = toolpath::findBase(wall_, *input_.substrate, own);
      field_ = toolpath::distanceFromBase(wall_, base, own);
      fitToBorder(base);
    } else {
      toolpath::IsoValueOptions iso;
      iso.step = step_;
      iso.firstLayer = options_.layers.firstLayer;
      field_ = toolpath::isoValueField(wall_, *input_.substrate, iso, own).values;
    }
    for (Diagnostic finding : own.diagnostics().items()) {
      // Standing on several legs is what branches are for.
      if (finding.code != "slicing.several_lower_borders") {
        context_.add(std::move(finding));
      }
    }
  }

  /// The step with which the highest border of a part that is even enough is a layer.
  void fitToBorder(const toolpath::PartBase& base) {
    const toolpath::EndBorder end = toolpath::endBorderOf(base, field_, step_);
    if (!(end.distance > 0.0)) {
      return;
    }
    borderTolerance_ = std::max(end.spread, geometry::flatTolerance(wall_.mesh));
    const toolpath::LayerSteps fitted =
        toolpath::layersUpTo(end.distance, options_.layers, borderTolerance_);
    step_ = fitted.step;
    std::vector<LayerLevel> levels;
    for (std::size_t k = 0; k < fitted.count; ++k) {
      levels.push_back({(options_.layers.firstLayer + static_cast<double>(k)) * step_,
                        input_.substrate->up(), step_});
    }
    toolpath::reportSteps({end.distance}, levels, options_.layers, step_, borderTolerance_,
                          context_);
  }

  /// The part above the substrate, with a mesh that carries fields.
  [[nodiscard]] PartSurface fineWall() const {
    const PartSurface& part = *input_.parts[part_];
    const double edge = options_.edge > 0.0
                            ? options_.edge
                            : geometry::fieldEdgeLength(part, kLayersPerEdge * step_);
    return toolpath::openWall(
        geometry::refineSurface(part, edge, context_.portion(0.0, 0.2, "refinement")),
        *input_.substrate);
  }

  void checkMethods(std::size_t pieces) const {
    for (const auto& [piece, method] : options_.methods.own) {
      if (piece >= pieces) {
        throw Error(ErrorCode::JobFailed,
                    text("the part has no piece %1: its pieces are 0 to %2",
                         {std::to_string(piece), std::to_string(pieces - 1)}),
                    "slicing of branching parts, pieces",
                    "correct the number in 'pieces', or lower the least branch");
      }
    }
  }

  void report(const std::vector<FieldPiece>& pieces) const {
    std::vector<double> cuts;
    for (const FieldPiece& piece : pieces) {
      if (!piece.below.empty()) {
        cuts.push_back(piece.from);
      }
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    std::string where;
    constexpr std::size_t kNamed = 5;
    for (std::size_t i = 0; i < std::min(cuts.size(), kNamed); ++i) {
      where += (i > 0 ? ", " : "") + formatFixed(cuts[i], 2);
    }
    where += cuts.size() > kNamed ? " …" : "";
    const bool one = pieces.size() == 1;
    context_.add({Severity::Information,
                  "slicing.branches",
                  text(cuts.empty() ? (one ? "the part has %1 piece" : "the part has %1 pieces")
                                    : (one ? "the part has %1 piece, cut at %2 mm of the field"
                                           : "the part has %1 pieces, cut at %2 mm of the field"),
                       {std::to_string(pieces.size()), where}),
                  "",
                  {},
                  {{"pieces", static_cast<double>(pieces.size())},
                   {"cuts", static_cast<double>(cuts.size())}}});
  }

  /// Layers of a piece; their levels are those of the common field unless pieceHeight_ is set.
  toolpath::SlicedLayers layersOf(const FieldPiece& piece, std::size_t number) {
    pieceHeight_ = 0.0;
    try {
      switch (options_.methods.of(number)) {
        case Method::Geodesic:
          return byOwnDistance(piece);
        case Method::IsoValues:
          return byIsoValues(piece);
        case Method::Spiral:
          return bySpiral(piece, number);
        case Method::Common:
          break;
      }
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Cancelled) {
        throw;
      }
      const Text place = text("piece %1", {std::to_string(number)});
      throw Error(error.code(), error.messageText(),
                  error.context().empty() ? place : text("%1: %2", {place, error.contextText()}),
                  error.hintText());
    }
    return options_.field == Field::Height     ? byPlanes(piece)
           : options_.field == Field::Geodesic ? byDistance(piece)
                                               : byIsoValues(piece);
  }

  PieceLayers slicePiece(FieldPiece&& piece, std::size_t number) {
    PieceLayers result;
    result.from = piece.from;
    result.below = piece.below;
    result.above = piece.above;
    toolpath::SlicedLayers sliced = layersOf(piece, number);
    for (SlicedLayer& layer : sliced.layers) {
      result.levels.push_back(commonLevel(piece, layer.level));
      for (toolpath::Contour& contour : layer.contours) {
        contour.part = static_cast<int>(part_);
      }
      result.layers.push_back(std::move(layer));
    }
    const bool layered = options_.methods.of(number) != Method::Spiral;
    if (piece.below.size() > 1 && layered && !result.layers.empty()) {
      for (toolpath::Contour& contour : result.layers.front().contours) {
        contour.feature = toolpath::BeadFeature::Junction;
      }
    }
    return result;
  }

  /// Levels of the whole part that fall into a piece. One on a cut belongs to the piece below.
  [[nodiscard]] std::vector<LayerLevel> within(const std::vector<LayerLevel>& levels,
                                               const FieldPiece& piece) const {
    std::vector<LayerLevel> result;
    const double slack = std::max(kOnEnd * step_, borderTolerance_);
    for (const LayerLevel& level : levels) {
      const bool begins = piece.below.empty() ? level.value >= piece.from - slack
                                              : level.value > piece.from + slack;
      if (begins && level.value <= piece.to + slack) {
        result.push_back(level);
        // Rounding must not lift the last layer off the piece.
        result.back().value = std::min(level.value, piece.to);
      }
    }
    return result;
  }

  /// No layers when there are no levels or they meet the piece in points only.
  template <class FieldType>
  toolpath::SlicedLayers trace(const FieldPiece& piece,
                               const FieldType& field,
                               const std::vector<LayerLevel>& levels) const {
    toolpath::SlicedLayers sliced;
    if (levels.empty()) {
      return sliced;
    }
    const JobContext own = context_.withOwnDiagnostics();
    try {
      sliced = toolpath::sliceByField({std::make_shared<const PartSurface>(piece.surface)}, field,
                                      levels, *input_.substrate, input_.sampling, own);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::JobFailed && error.code() != ErrorCode::CheckFailed) {
        throw;
      }
    }
    for (Diagnostic finding : own.diagnostics().items()) {
      if (finding.severity != Severity::Information) {
        finding.place = {};  // layers get other numbers when the pieces are put in order
        context_.add(std::move(finding));
      }
    }
    return sliced;
  }

  [[nodiscard]] toolpath::SlicedLayers byPlanes(const FieldPiece& piece) const {
    toolpath::PlaneStack stack = stack_;
    stack.levels = within(stack_.levels, piece);
    return trace(piece, toolpath::PlaneField(stack), stack.levels);
  }

  [[nodiscard]] toolpath::SlicedLayers byDistance(const FieldPiece& piece) const {
    const auto surface = std::make_shared<const PartSurface>(piece.surface);
    toolpath::VertexField field{{piece.field}};
    field.borderTolerance = borderTolerance_;
    const double count = (piece.to + borderTolerance_) / step_ - options_.layers.firstLayer + 1.0;
    const auto levels = toolpath::isoLevels({surface}, field, step_, options_.layers.firstLayer,
                                            static_cast<std::size_t>(std::max(0.0, count + kOnEnd)),
                                            input_.substrate->up());
    return withHeights(piece, surface, field, within(levels, piece));
  }

  /// Vertices of the borders of a piece that lie at its lower and at its upper end.
  struct Ends {
    std::vector<std::uint32_t> lower;
    std::vector<std::uint32_t> upper;
  };

  [[nodiscard]] Ends endsOf(const FieldPiece& piece) const {
    Ends ends;
    const double slack = kOnEnd * step_;
    for (const auto& loop : piece.surface.halfEdges.borderLoops(piece.surface.mesh)) {
      for (const std::uint32_t v : loop) {
        if (piece.field[v] <= piece.from + slack) {
          ends.lower.push_back(v);
        } else if (piece.field[v] >= piece.to - slack) {
          ends.upper.push_back(v);
        }
      }
    }
    return ends;
  }

  /// Distance from the lower end of the piece itself.
  [[nodiscard]] toolpath::SlicedLayers byOwnDistance(const FieldPiece& piece) {
    const Ends ends = endsOf(piece);
    if (ends.lower.empty()) {
      return byDistance(piece);
    }
    geometry::GeodesicSource source;
    source.vertices = ends.lower;
    std::vector<bool> low(piece.surface.mesh.vertices.size(), false);
    for (const std::uint32_t v : ends.lower) {
      low[v] = true;
    }
    const auto& halfEdges = piece.surface.halfEdges;
    for (std::uint32_t h = 0; h < 3 * piece.surface.mesh.triangles.size(); ++h) {
      const auto& [a, b] = halfEdges.edgeVertices(halfEdges.edgeOf(h));
      if (halfEdges.twin(h) == geometry::HalfEdges::kNone && low[a] && low[b]) {
        source.borderEdges.push_back(h);
      }
    }
    toolpath::VertexField field{
        {geometry::GeodesicSolver(piece.surface.mesh, halfEdges)
             .distance(source, std::numeric_limits<double>::infinity(), context_)}};
    const double farthest = *std::max_element(field.values[0].begin(), field.values[0].end());
    pieceHeight_ = farthest;
    const double first = piece.below.empty() ? options_.layers.firstLayer : 1.0;
    const double count = std::floor(farthest / step_ - first + 1.0 + kOnEnd);
    const auto surface = std::make_shared<const PartSurface>(piece.surface);
    const auto levels =
        toolpath::isoLevels({surface}, field, step_, first,
                            static_cast<std::size_t>(std::max(0.0, count)), input_.substrate->up());
    return withHeights(piece, surface, field, levels);
  }

  /// One bead through the whole piece.
  [[nodiscard]] toolpath::SlicedLayers bySpiral(const FieldPiece& piece, std::size_t number) {
    const toolpath::WallLimits limits = limitsOf(piece);
    toolpath::SpiralWish wish;
    wish.height = step_;
    wish.heightMin = input_.bead.heightMin;
    wish.heightMax = input_.bead.heightMax;
    wish.end = limits.upper.empty() ? toolpath::SpiralEnd::Point : toolpath::SpiralEnd::Mirrored;
    wish.endReserve = 0.5 * wish.height;
    toolpath::GeneratrixOptions options;
    options.up = input_.substrate->up();
    options.step = wish.height;
    options.sampling = input_.sampling;
    const toolpath::Generatrices curves =
        toolpath::decomposeWall(piece.surface, limits, options, context_.portion(0.6, 0.6));
    std::vector<double> lengths;
    for (const toolpath::Generatrix& curve : curves.curves) {
      lengths.push_back(curve.length());
    }
    const toolpath::SpiralPlan plan = toolpath::planSpiral(lengths, wish);
    if (plan.excess) {
      const auto range = toolpath::rangeThatWouldDo(lengths, wish);
      context_.add({Severity::Warning,
                    "slicing.spiral_infeasible",
                    text("piece %1 needs a deposit of %2 mm, outside of %3 to %4 mm",
                         {std::to_string(number), formatFixed(plan.excess->height, 3),
                          formatFixed(wish.heightMin, 3), formatFixed(wish.heightMax, 3)}),
                    range ? text("a process whose heights go from %1 would do",
                                 {toolpath::rangeText(*range)})
                          : text("no range about this deposit does: build the piece in layers"),
                    {},
                    {{"piece", static_cast<double>(number)}, {"deposit_mm", plan.excess->height}}});
    }
    pieceHeight_ = piece.to - piece.from;
    toolpath::SlicedLayers sliced = toolpath::spiralAlong(
        piece.surface, curves, plan, wish, context_.withOwnDiagnostics(),
        piece.surface.exact() ? std::nullopt : std::optional(input_.sampling));
    for (SlicedLayer& layer : sliced.layers) {
      layer.level = 0.0;
    }
    return sliced;
  }

  /// The one loop on which a piece stands and the one at which it ends.
  [[nodiscard]] toolpath::WallLimits limitsOf(const FieldPiece& piece) const {
    toolpath::WallLimits limits;
    const double middle = 0.5 * (piece.from + piece.to);
    for (const auto& loop : piece.surface.halfEdges.borderLoops(piece.surface.mesh)) {
      double mean = 0.0;
      for (const std::uint32_t v : loop) {
        mean += piece.field[v] / static_cast<double>(loop.size());
      }
      std::vector<std::uint32_t>& end = mean < middle ? limits.lower : limits.upper;
      if (!end.empty()) {
        throw Error(ErrorCode::JobFailed, "it has several borders at one end",
                    "slicing of branching parts",
                    "a spiral needs one border below and at most one above: slice this piece by "
                    "isovalues");
      }
      end = loop;
    }
    if (limits.lower.empty()) {
      throw Error(ErrorCode::JobFailed, "it has no border to stand on",
                  "slicing of branching parts", "slice this piece by isovalues");
    }
    return limits;
  }

  /// A piece follows its own ends: its cuts and borders.
  [[nodiscard]] toolpath::SlicedLayers byIsoValues(const FieldPiece& piece) {
    const auto [lower, upper] = endsOf(piece);
    if (lower.empty() || upper.empty()) {
      return byDistance(piece);  // it closes in a point: the common field has its distance
    }
    toolpath::IsoField iso = toolpath::isoValuesBetween(piece.surface, lower, upper, step_,
                                                        context_.withOwnDiagnostics());
    const auto surface = std::make_shared<const PartSurface>(piece.surface);
    const double first = piece.below.empty() ? options_.layers.firstLayer : 1.0;
    const std::size_t layers = iso.layers + (first < 1.0 && iso.layers > 0 ? 1 : 0);
    const double stretch =
        first < 1.0 && iso.layers > 0
            ? (static_cast<double>(layers) - 1.0 + first) / static_cast<double>(iso.layers)
            : 1.0;
    toolpath::VertexField field{{std::move(iso.values)}};
    for (double& value : field.values[0]) {
      value *= stretch;
    }
    pieceHeight_ = static_cast<double>(iso.layers) * step_ * stretch;
    const auto levels =
        toolpath::isoLevels({surface}, field, step_, first, layers, input_.substrate->up());
    return withHeights(piece, surface, field, levels);
  }

  /// Level of the common field for a level of a piece's own one.
  [[nodiscard]] double commonLevel(const FieldPiece& piece, double level) const {
    return pieceHeight_ > 0.0 ? piece.from + (piece.to - piece.from) * level / pieceHeight_ : level;
  }

  /// Heights follow from the field, save next to a cut: a saddle has no gradient, so that what was
  /// measured counts there.
  [[nodiscard]] toolpath::SlicedLayers withHeights(
      const FieldPiece& piece,
      const std::shared_ptr<const PartSurface>& surface,
      const toolpath::VertexField& field,
      const std::vector<LayerLevel>& levels) const {
    toolpath::SlicedLayers sliced = trace(piece, field, levels);
    toolpath::setFieldHeights(sliced, {surface}, field, step_);
    const auto forget = [](SlicedLayer& layer) {
      for (toolpath::Contour& contour : layer.contours) {
        for (toolpath::ContourPoint& point : contour.points) {
          point.height = 0.0;
        }
      }
    };
    if (!sliced.layers.empty() && !piece.below.empty()) {
      forget(sliced.layers.front());
    }
    if (!sliced.layers.empty() && !piece.above.empty()) {
      forget(sliced.layers.back());
    }
    return sliced;
  }

  const plugin::SliceInput& input_;
  std::size_t part_;
  const PieceOptions& options_;
  const JobContext& context_;
  toolpath::PlaneStack stack_;
  PartSurface wall_;
  std::vector<double> field_;
  double step_;                   ///< fitted to the height where that is asked for, mm
  double borderTolerance_ = 0.0;  ///< a level this near to a border is that border, mm
  double pieceHeight_ = 0.0;      ///< greatest value of the own field of the piece at hand
};

}  // namespace

std::vector<PieceLayers> slicePieces(const plugin::SliceInput& input,
                                     std::size_t part,
                                     const PieceOptions& options,
                                     const JobContext& context) {
  return PartSlicer(input, part, options, context).run();
}

}  // namespace wcam::branches
