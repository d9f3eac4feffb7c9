// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/refine.hpp"
#include "wcam/plugin/plugin.hpp"
#include "wcam/toolpath/field_heights.hpp"
#include "wcam/toolpath/iso_field.hpp"
#include "wcam/toolpath/onto_parts.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace {

using namespace wcam;

enum class Borders { ByDistance, Together };

struct Params {
  Length step = 2.0_mm;
  double firstLayer = 1.0;
  Borders borders = Borders::ByDistance;
  double conductivityUp = 1.0;
  double geodesicShare = 0.0;
  Length edge = 0.0_mm;

  static const Schema<Params>& schema();
};

const Schema<Params>& Params::schema() {
  static const Schema<Params> schema =
      Schema<Params>{}
          .add(&Params::step, {.key = "step",
                               .label = "Mean layer height",
                               .help = "Rounded so that the last layer is the upper border.",
                               .group = "Layers",
                               .min = 0.01,
                               .max = 1000.0})
          .add(&Params::firstLayer,
               {.key = "first_layer",
                .label = "First layer, in steps",
                .help = "Place of the first layer above the lower border; 0 puts it on the border.",
                .group = "Layers",
                .level = ParamLevel::Advanced,
                .min = 0.0,
                .max = 1.0})
          .add(&Params::borders,
               {.key = "upper_borders",
                .label = "Several upper borders",
                .help = "At which layer a part with several upper borders reaches each of them.",
                .group = "Field",
                .level = ParamLevel::Advanced,
                .choices = {{"by_distance", "Each at the layer that its distance asks for"},
                            {"together", "All at the last layer"}}})
          .add(
              &Params::conductivityUp,
              {.key = "conductivity_up",
               .label = "Conduction along the build direction",
               .help = "Over that across it. Above 1 layers bend less towards slanted borders near "
                       "them and more in the middle of the part.",
               .group = "Field",
               .level = ParamLevel::Expert,
               .min = 0.01,
               .max = 100.0})
          .add(
              &Params::geodesicShare,
              {.key = "geodesic_share",
               .label = "Share of distances",
               .help = "0: harmonic field, smoothest. 1: ratio of the distances from the lower and "
                       "the upper border, most even heights along the wall.",
               .group = "Field",
               .level = ParamLevel::Advanced,
               .min = 0.0,
               .max = 1.0})
          .add(&Params::edge,
               {.key = "edge_length",
                .label = "Mesh edge length",
                .help = "Fineness of the mesh that carries the field; 0 follows from the step.",
                .group = "Field",
                .level = ParamLevel::Expert,
                .min = 0.0,
                .max = 1e4});
  return schema;
}

/// The field is smooth over many layers: the mesh resolves the shape, not the layers.
constexpr double kLayersPerEdge = 2.0;

class IsoValueSlicing : public plugin::SlicingStrategy {
public:
  [[nodiscard]] toolpath::SlicedLayers slice(const plugin::SliceInput& input,
                                             const Value& values,
                                             const JobContext& context) const override {
    const Params params = Params::schema().read(values, "slicing by iso-values");
    toolpath::IsoValueOptions options;
    options.step = params.step.value();
    options.firstLayer = params.firstLayer;
    options.bordersByDistance = params.borders == Borders::ByDistance;
    options.conductivityUp = params.conductivityUp;
    options.geodesicShare = params.geodesicShare;

    std::vector<std::shared_ptr<const geometry::PartSurface>> walls;
    toolpath::VertexField field;
    std::size_t layers = 0;
    for (std::size_t k = 0; k < input.parts.size(); ++k) {
      const JobContext portion = context.portion(
          0.6 * static_cast<double>(k) / static_cast<double>(input.parts.size()),
          0.6 * static_cast<double>(k + 1) / static_cast<double>(input.parts.size()), "field");
      const double edge =
          params.edge.value() > 0.0
              ? params.edge.value()
              : geometry::fieldEdgeLength(*input.parts[k], kLayersPerEdge * params.step.value());
      auto wall = std::make_shared<const geometry::PartSurface>(toolpath::openWall(
          geometry::refineSurface(*input.parts[k], edge, portion), *input.substrate));
      toolpath::IsoField iso = toolpath::isoValueField(*wall, *input.substrate, options, portion);
      layers = std::max(layers, iso.layers);
      field.values.push_back(std::move(iso.values));
      walls.push_back(std::move(wall));
    }
    const auto levels = toolpath::isoLevels(walls, field, options.step, options.firstLayer, layers,
                                            input.substrate->up());
    toolpath::SlicedLayers sliced =
        toolpath::sliceByField(walls, field, levels, *input.substrate, input.sampling,
                               context.portion(0.6, 0.9, "slicing"));
    sliced.curved = true;
    toolpath::setFieldHeights(sliced, walls, field, options.step);
    toolpath::moveOntoParts(sliced, input.parts, input.sampling, context.portion(0.9, 1.0));
    toolpath::reportHeights(
        sliced, input.bead, options.step,
        "a larger share of distances spreads the heights more evenly, and branches get steps of "
        "their own with the strategy for branching parts",
        context);
    toolpath::reportDownward(sliced, input.substrate->up(), context);
    context.report(1.0);
    return sliced;
  }
};

void registerComponents(plugin::Registrar& registrar) {
  registrar.addSlicing(
      {.id = "wcam.slicing.isovalues",
       .name = "Iso-values between the borders",
       .summary = "Curved layers that follow the lower and the upper border of a wall.",
       .version = 1,
       .params = Params::schema().params()},
      [] { return std::make_unique<IsoValueSlicing>(); });
}

}  // namespace

WCAM_PLUGIN(registerComponents);
