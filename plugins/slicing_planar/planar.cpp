// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/plugin/plugin.hpp"
#include "wcam/toolpath/adaptive_planes.hpp"
#include "wcam/toolpath/height_field.hpp"
#include "wcam/toolpath/plane_field.hpp"

#include <optional>

namespace {

using namespace wcam;
using geometry::Vec3;

enum class Surface { Planes, Substrate };

struct Params {
  Length step = 2.0_mm;
  double firstLayer = 1.0;
  Length endHeight = 0.0_mm;
  toolpath::LastLayer last = toolpath::LastLayer::Fit;
  Surface surface = Surface::Planes;
  bool adaptive = false;
  bool customDirection = false;
  std::array<double, 3> direction{0.0, 0.0, 1.0};

  static const Schema<Params>& schema() {
    static const Schema<Params> schema = [] {
      Schema<Params> s;
      addLayers(s);
      addShape(s);
      return s;
    }();
    return schema;
  }

private:
  static void addLayers(Schema<Params>& s) {
    s.add(&Params::step, {.key = "step",
                          .label = "Layer step",
                          .help = "Distance between neighbouring planes; with adaptive heights the "
                                  "greatest distance between neighbouring layers.",
                          .group = "Layers",
                          .min = 0.01,
                          .max = 1000.0});
    s.add(&Params::firstLayer,
          {.key = "first_layer",
           .label = "First layer, in steps",
           .help = "Height of the first layer above the base; 0 puts a layer on the base itself.",
           .group = "Layers",
           .level = ParamLevel::Advanced,
           .min = 0.0,
           .max = 100.0});
    s.add(&Params::endHeight,
          {.key = "end_height",
           .label = "End height",
           .help = "No layer above this height over the base; 0 slices the whole part.",
           .group = "Layers",
           .level = ParamLevel::Advanced,
           .min = 0.0,
           .max = 1e6});
    toolpath::addLastLayer(s, &Params::last);
  }

  static void addShape(Schema<Params>& s) {
    s.add(&Params::surface,
          {.key = "surface",
           .label = "Layers are",
           .help = "Planes, or the surface of the substrate moved up along the build direction.",
           .group = "Direction",
           .choices = {{"planes", "Planes"}, {"substrate", "The substrate's surface"}}});
    s.add(&Params::adaptive,
          {.key = "adaptive_step",
           .label = "Adaptive heights",
           .help = "Planes come nearer where walls lean, so that neighbouring layers are nowhere "
                   "farther apart than the step, within the layer heights of the process (Chalvin "
                   "A6).",
           .group = "Layers",
           .enabledIf = "surface=planes"});
    s.add(&Params::customDirection,
          {.key = "custom_direction",
           .label = "Own build direction",
           .help = "Otherwise layers grow along the substrate's build direction.",
           .group = "Direction",
           .enabledIf = "surface=planes"});
    s.add(&Params::direction, {.key = "direction",
                               .label = "Build direction",
                               .help = "In the part frame; any length.",
                               .group = "Direction",
                               .enabledIf = "custom_direction=true"});
  }
};

class PlanarSlicing : public plugin::SlicingStrategy {
public:
  [[nodiscard]] toolpath::SlicedLayers slice(const plugin::SliceInput& input,
                                             const Value& values,
                                             const JobContext& context) const override {
    const Params params = Params::schema().read(values, "planar slicing");
    const toolpath::LayerWish wish{params.step.value(), params.firstLayer, params.last,
                                   input.bead.heightMin, input.bead.heightMax};
    if (params.surface == Surface::Substrate) {
      const toolpath::HeightLevels heights =
          toolpath::heightLevels(input.parts, *input.substrate, wish, params.endHeight.value());
      const std::vector<toolpath::LayerLevel>& levels = heights.levels;
      toolpath::SlicedLayers sliced =
          toolpath::sliceByField(input.parts, toolpath::HeightField(*input.substrate, levels),
                                 levels, *input.substrate, input.sampling, context);
      sliced.curved = !input.substrate->isPlate();
      toolpath::reportSteps(heights.ends, levels, wish, heights.step, heights.tolerance, context);
      return sliced;
    }
    toolpath::PlaneStackOptions options{wish, params.endHeight.value(), std::nullopt};
    if (params.customDirection) {
      options.direction = Vec3(params.direction[0], params.direction[1], params.direction[2]);
    }
    const toolpath::PlaneStack stack =
        params.adaptive ? toolpath::adaptivePlanes(input.parts, *input.substrate, options,
                                                   input.bead, input.sampling, context)
                        : toolpath::planeStack(input.parts, *input.substrate, options);
    toolpath::reportSteps(stack.ends, stack.levels, wish, stack.step, stack.tolerance, context);
    return toolpath::sliceByField(input.parts, toolpath::PlaneField(stack), stack.levels,
                                  *input.substrate, input.sampling, context);
  }
};

void registerComponents(plugin::Registrar& registrar) {
  registrar.addSlicing(
      {.id = "wcam.slicing.planar",
       .name = "Planar slicing",
       .summary = "Parallel planes at a constant step or at adaptive heights, in any build "
                  "direction; or the substrate's surface moved up.",
       .version = 2,
       .params = Params::schema().params()},
      [] { return std::make_unique<PlanarSlicing>(); });
}

}  // namespace

WCAM_PLUGIN(registerComponents);
