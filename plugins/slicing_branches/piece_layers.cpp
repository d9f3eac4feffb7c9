// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "piece_layers.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"
#include "wcam/geometry/cut_mesh.hpp"
#include "wcam/geometry/refine.hpp"
#include "wcam/toolpath/base_curve.hpp"
#include "wcam/toolpath/field_heights.hpp"
#include "wcam/toolpath/iso_field.hpp"
#include "wcam/toolpath/plane_field.hpp"

#include <algorithm>
#include <cmath>
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
      : input_(input), part_(part), options_(options), context_(context) {}

  std::vector<PieceLayers> run() {
    makeField();
    std::vector<FieldPiece> pieces = geometry::splitAtSaddles(
        wall_, field_, options_.leastBranch, context_.portion(0.4, 0.6, "branches"));
    report(pieces);
    std::vector<PieceLayers> result;
    for (FieldPiece& piece : pieces) {
      context_.check();
      result.push_back(slicePiece(std::move(piece)));
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
      stack.step = options_.step;
      stack.firstLayer = options_.firstLayer;
      stack_ = toolpath::planeStack(input_.parts, *input_.substrate, stack);
      wall_ = part;
      for (const Vec3& p : wall_.mesh.vertices) {
        field_.push_back(stack_.up.dot(p) - stack_.base);
      }
      return;
    }
    const double edge = options_.edge > 0.0
                            ? options_.edge
                            : geometry::fieldEdgeLength(part, kLayersPerEdge * options_.step);
    wall_ = toolpath::openWall(
        geometry::refineSurface(part, edge, context_.portion(0.0, 0.2, "refinement")),
        *input_.substrate);
    const JobContext own = context_.withOwnDiagnostics();
    if (options_.field == Field::Geodesic) {
      field_ =
          toolpath::distanceFromBase(wall_, toolpath::findBase(wall_, *input_.substrate, own), own);
    } else {
      toolpath::IsoValueOptions iso;
      iso.step = options_.step;
      iso.firstLayer = options_.firstLayer;
      field_ = toolpath::isoValueField(wall_, *input_.substrate, iso, own).values;
    }
    for (Diagnostic finding : own.diagnostics().items()) {
      // Standing on several legs is what branches are for.
      if (finding.code != "slicing.several_lower_borders") {
        context_.add(std::move(finding));
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
      where += (i > 0 ? ", " : " at ") + formatFixed(cuts[i], 2);
    }
    where += cuts.size() > kNamed ? " …" : "";
    context_.add({Severity::Information,
                  "slicing.branches",
                  "the part has " + std::to_string(pieces.size()) +
                      (pieces.size() == 1 ? " piece" : " pieces") +
                      (cuts.empty() ? std::string() : ", cut" + where + " mm of the field"),
                  "",
                  {},
                  {{"pieces", static_cast<double>(pieces.size())},
                   {"cuts", static_cast<double>(cuts.size())}}});
  }

  PieceLayers slicePiece(FieldPiece&& piece) {
    PieceLayers result;
    result.from = piece.from;
    result.below = piece.below;
    result.above = piece.above;
    toolpath::SlicedLayers sliced = options_.field == Field::Height     ? byPlanes(piece)
                                    : options_.field == Field::Geodesic ? byDistance(piece)
                                                                        : byIsoValues(piece);
    for (SlicedLayer& layer : sliced.layers) {
      result.levels.push_back(options_.field == Field::IsoValues ? commonLevel(piece, layer.level)
                                                                 : layer.level);
      for (toolpath::Contour& contour : layer.contours) {
        contour.part = static_cast<int>(part_);
      }
      result.layers.push_back(std::move(layer));
    }
    if (piece.below.size() > 1 && !result.layers.empty()) {
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
    const double slack = kOnEnd * options_.step;
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
      if (error.code() != ErrorCode::JobFailed) {
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
    const toolpath::VertexField field{{piece.field}};
    const double count = piece.to / options_.step - options_.firstLayer + 1.0;
    const auto levels = toolpath::isoLevels({surface}, field, options_.step, options_.firstLayer,
                                            static_cast<std::size_t>(std::max(0.0, count + kOnEnd)),
                                            input_.substrate->up());
    return withHeights(piece, surface, field, within(levels, piece));
  }

  /// A piece follows its own ends: its cuts and borders.
  [[nodiscard]] toolpath::SlicedLayers byIsoValues(const FieldPiece& piece) {
    pieceHeight_ = 0.0;
    std::vector<std::uint32_t> lower;
    std::vector<std::uint32_t> upper;
    const double slack = kOnEnd * options_.step;
    for (const auto& loop : piece.surface.halfEdges.borderLoops(piece.surface.mesh)) {
      for (const std::uint32_t v : loop) {
        if (piece.field[v] <= piece.from + slack) {
          lower.push_back(v);
        } else if (piece.field[v] >= piece.to - slack) {
          upper.push_back(v);
        }
      }
    }
    if (lower.empty() || upper.empty()) {
      return byDistance(piece);  // it closes in a point: the common field has its distance
    }
    toolpath::IsoField iso = toolpath::isoValuesBetween(piece.surface, lower, upper, options_.step,
                                                        context_.withOwnDiagnostics());
    const auto surface = std::make_shared<const PartSurface>(piece.surface);
    const double first = piece.below.empty() ? options_.firstLayer : 1.0;
    const std::size_t layers = iso.layers + (first < 1.0 && iso.layers > 0 ? 1 : 0);
    const double stretch =
        first < 1.0 && iso.layers > 0
            ? (static_cast<double>(layers) - 1.0 + first) / static_cast<double>(iso.layers)
            : 1.0;
    toolpath::VertexField field{{std::move(iso.values)}};
    for (double& value : field.values[0]) {
      value *= stretch;
    }
    pieceHeight_ = static_cast<double>(iso.layers) * options_.step * stretch;
    const auto levels =
        toolpath::isoLevels({surface}, field, options_.step, first, layers, input_.substrate->up());
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
    toolpath::setFieldHeights(sliced, {surface}, field, options_.step);
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
  double pieceHeight_ = 0.0;  ///< greatest value of the own field of the piece at hand
};

}  // namespace

std::vector<PieceLayers> slicePieces(const plugin::SliceInput& input,
                                     std::size_t part,
                                     const PieceOptions& options,
                                     const JobContext& context) {
  return PartSlicer(input, part, options, context).run();
}

}  // namespace wcam::branches
