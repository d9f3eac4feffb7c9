// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/plugin/plugin.hpp"
#include "wcam/toolpath/plane_field.hpp"

#include <optional>

namespace {

using namespace wcam;
using geometry::Vec3;

struct Params {
  Length step = 2.0_mm;
  double firstLayer = 1.0;
  Length endHeight = 0.0_mm;
  bool customDirection = false;
  std::array<double, 3> direction{0.0, 0.0, 1.0};

  static const Schema<Params>& schema() {
    static const Schema<Params> schema =
        Schema<Params>{}
            .add(&Params::step, {.key = "step",
                                 .label = "Layer step",
                                 .help = "Distance between neighbouring planes.",
                                 .group = "Layers",
                                 .min = 0.01,
                                 .max = 1000.0})
            .add(
                &Params::firstLayer,
                {.key = "first_layer",
                 .label = "First layer, in steps",
                 .help =
                     "Height of the first layer above the base; 0 puts a layer on the base itself.",
                 .group = "Layers",
                 .level = ParamLevel::Advanced,
                 .min = 0.0,
                 .max = 100.0})
            .add(&Params::endHeight,
                 {.key = "end_height",
                  .label = "End height",
                  .help = "No layer above this height over the base; 0 slices the whole part.",
                  .group = "Layers",
                  .level = ParamLevel::Advanced,
                  .min = 0.0,
                  .max = 1e6})
            .add(&Params::customDirection,
                 {.key = "custom_direction",
                  .label = "Own build direction",
                  .help = "Otherwise layers grow along the substrate's build direction.",
                  .group = "Direction"})
            .add(&Params::direction, {.key = "direction",
                                      .label = "Build direction",
                                      .help = "In the part frame; any length.",
                                      .group = "Direction",
                                      .enabledIf = "custom_direction=true"});
    return schema;
  }
};

class PlanarSlicing : public plugin::SlicingStrategy {
public:
  [[nodiscard]] toolpath::SlicedLayers slice(const plugin::SliceInput& input,
                                             const Value& values,
                                             const JobContext& context) const override {
    const Params params = Params::schema().read(values, "planar slicing");
    toolpath::PlaneStackOptions options{params.step.value(), params.firstLayer,
                                        params.endHeight.value(), std::nullopt};
    if (params.customDirection) {
      options.direction = Vec3(params.direction[0], params.direction[1], params.direction[2]);
    }
    const toolpath::PlaneStack stack = toolpath::planeStack(input.parts, *input.substrate, options);
    return toolpath::sliceByField(input.parts, toolpath::PlaneField(stack), stack.levels,
                                  *input.substrate, input.sampling, context);
  }
};

void registerComponents(plugin::Registrar& registrar) {
  registrar.addSlicing({.id = "wcam.slicing.planar",
                        .name = "Planar slicing",
                        .summary = "Parallel planes at a constant step, in any build direction.",
                        .version = 1,
                        .params = Params::schema().params()},
                       [] { return std::make_unique<PlanarSlicing>(); });
}

}  // namespace

WCAM_PLUGIN("org.wcam.slicing.planar", "0.1.0", registerComponents);
