// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/plugin/plugin.hpp"
#include "wcam/toolpath/field_heights.hpp"
#include "wcam/toolpath/onto_parts.hpp"
#include "wcam/toolpath/plane_field.hpp"

#include "piece_layers.hpp"

#include <memory>
#include <string>
#include <utility>

namespace {

using namespace wcam;
using branches::Field;
using branches::Order;

struct Params {
  Length step = 2.0_mm;
  double firstLayer = 1.0;
  toolpath::LastLayer last = toolpath::LastLayer::Fit;
  Field field = Field::Height;
  Order order = Order::Level;
  std::string pieces;
  Length leastBranch = 0.0_mm;
  Length edge = 0.0_mm;

  static const Schema<Params>& schema();
};

Schema<Params> makeSchema() {
  Schema<Params> schema;
  schema
      .add(&Params::step, {.key = "step",
                           .label = "Layer height",
                           .help = "Wanted height of a layer; with iso-values the mean of each "
                                   "piece, rounded to whole layers.",
                           .group = "Layers",
                           .min = 0.01,
                           .max = 1000.0})
      .add(&Params::firstLayer,
           {.key = "first_layer",
            .label = "First layer, in steps",
            .help = "Place of the first layer above the base; 0 puts it on the base.",
            .group = "Layers",
            .level = ParamLevel::Advanced,
            .min = 0.0,
            .max = 1.0})
      .add(&Params::field,
           {.key = "field",
            .label = "Layers follow",
            .help = "The field whose saddles cut the part into branches and whose level curves "
                    "are the layers.",
            .group = "Branches",
            .choices = {{"height", "Planes across the build direction"},
                        {"geodesic", "The distance from the base along the wall"},
                        {"isovalues", "The borders and cuts of each piece"}}})
      .add(&Params::order, {.key = "order",
                            .label = "Order of the pieces",
                            .help = "A piece is never built before what it stands on.",
                            .group = "Branches",
                            .choices = {{"level", "Layer by layer over all branches"},
                                        {"bottom", "Piece by piece, the lowest first"},
                                        {"depth", "Piece by piece, upwards along each branch"},
                                        {"nearest", "Piece by piece, the nearest next"}}})
      .add(&Params::pieces,
           {.key = "pieces",
            .label = "Strategies of single pieces",
            .help = "What slices a piece instead of the common field: 1=spiral, 3=isovalues; "
                    "*=spiral for all others. Methods: common, geodesic (distance from the "
                    "lower end of the piece), isovalues, spiral (one bead; its heights stay "
                    "inside the process's range). Pieces count from 0, the lowest first, as "
                    "the finding slicing.branches lists them.",
            .group = "Branches",
            .level = ParamLevel::Advanced})
      .add(&Params::leastBranch,
           {.key = "least_branch",
            .label = "Least branch",
            .help = "What spans less than this is a bump, not a branch; 0 takes the step.",
            .group = "Branches",
            .level = ParamLevel::Advanced,
            .min = 0.0,
            .max = 1e4})
      .add(&Params::edge,
           {.key = "edge_length",
            .label = "Mesh edge length",
            .help = "Fineness of the mesh that carries the field; 0 follows from the step.",
            .group = "Branches",
            .level = ParamLevel::Expert,
            .min = 0.0,
            .max = 1e4,
            .enabledIf = "field!=height"});
  toolpath::addLastLayer(schema, &Params::last, "field!=isovalues");
  return schema;
}

const Schema<Params>& Params::schema() {
  static const Schema<Params> schema = makeSchema();
  return schema;
}

class BranchSlicing : public plugin::SlicingStrategy {
public:
  [[nodiscard]] toolpath::SlicedLayers slice(const plugin::SliceInput& input,
                                             const Value& values,
                                             const JobContext& context) const override {
    const Params params = Params::schema().read(values, "slicing of branching parts");
    branches::PieceOptions options;
    options.field = params.field;
    options.layers = {params.step.value(), params.firstLayer, params.last, input.bead.heightMin,
                      input.bead.heightMax};
    options.leastBranch =
        params.leastBranch.value() > 0.0 ? params.leastBranch.value() : params.step.value();
    options.edge = params.edge.value();
    options.methods = branches::parsePieceMethods(params.pieces);
    if (params.field == Field::Height) {
      const toolpath::PlaneStack stack =
          toolpath::planeStack(input.parts, *input.substrate, {options.layers, 0.0, std::nullopt});
      toolpath::reportSteps(stack.ends, stack.levels, options.layers, stack.step, stack.tolerance,
                            context);
      options.layers.step = stack.step;
    }
    std::vector<branches::PieceLayers> pieces;
    bool any = false;
    for (std::size_t k = 0; k < input.parts.size(); ++k) {
      const double share = 1.0 / static_cast<double>(input.parts.size());
      const std::size_t first = pieces.size();
      for (branches::PieceLayers& piece :
           branches::slicePieces(input, k, options,
                                 context.portion(static_cast<double>(k) * share,
                                                 static_cast<double>(k + 1) * share, "branches"))) {
        for (auto* list : {&piece.below, &piece.above}) {
          for (std::size_t& index : *list) {
            index += first;
          }
        }
        any = any || !piece.layers.empty();
        pieces.push_back(std::move(piece));
      }
    }
    if (!any) {
      throw Error(ErrorCode::JobFailed, "no layer meets the part", "slicing of branching parts",
                  "choose a smaller step, or check the part's place above the substrate");
    }
    toolpath::SlicedLayers sliced = branches::arrange(std::move(pieces), params.order);
    sliced.curved = params.field != Field::Height || !options.methods.common();
    toolpath::moveOntoParts(sliced, input.parts, input.sampling, context);
    toolpath::reportHeights(sliced, input.bead, options.layers.step,
                            "layers that follow the distance from the base keep the height best",
                            context);
    toolpath::reportDownward(sliced, input.substrate->up(), context);
    return sliced;
  }
};

void registerComponents(plugin::Registrar& registrar) {
  registrar.addSlicing(
      {.id = "wcam.slicing.branches",
       .name = "Branching parts",
       .summary = "Cuts a part where its layers part or join and builds the pieces in a chosen "
                  "order, each layer on those that lie below it.",
       .version = 4,
       .params = Params::schema().params()},
      [] { return std::make_unique<BranchSlicing>(); });
}

}  // namespace

WCAM_PLUGIN(registerComponents);
