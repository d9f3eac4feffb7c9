// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/refine.hpp"
#include "wcam/plugin/plugin.hpp"
#include "wcam/toolpath/base_curve.hpp"
#include "wcam/toolpath/constant_distance.hpp"
#include "wcam/toolpath/layer_levels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using namespace wcam;
using geometry::Vec3;

struct Params {
  Length step = 2.0_mm;
  double firstLayer = 1.0;
  toolpath::LastLayer last = toolpath::LastLayer::Fit;
  bool cut = false;
  std::array<double, 3> cutPoint{0.0, 0.0, 0.0};
  std::array<double, 3> cutNormal{0.0, 0.0, 1.0};
  Length cornerBound = 0.0_mm;
  Length meshEdge = 0.0_mm;

  static const Schema<Params>& schema() {
    static const Schema<Params> schema = [] {
      Schema<Params> s;
      s.add(&Params::step,
            {.key = "step",
             .label = "Layer step",
             .help = "Distance of every point of a layer to the layer below (Chalvin A11).",
             .group = "Layers",
             .min = 0.01,
             .max = 1000.0})
          .add(&Params::firstLayer,
               {.key = "first_layer",
                .label = "First layer, in steps",
                .help = "Distance of the first layer from the base; 0 puts a layer on the base.",
                .group = "Layers",
                .level = ParamLevel::Advanced,
                .min = 0.0,
                .max = 100.0});
      toolpath::addLastLayer(s, &Params::last, "cut=false");
      s.add(&Params::cut,
            {.key = "cut",
             .label = "Cut off by a plane",
             .help = "Layers end at a plane: for parts that were made longer than wanted so "
                     "that their last layers are whole (Chalvin A13).",
             .group = "End"})
          .add(&Params::cutPoint,
               {.key = "cut_point",
                .label = "Point of the plane",
                .help = "In the part frame.",
                .group = "End",
                .enabledIf = "cut=true"},
               ParamType::Vector3, QuantityKind::Length)
          .add(&Params::cutNormal, {.key = "cut_normal",
                                    .label = "Normal of the plane",
                                    .help = "Points away from the material that stays; any length.",
                                    .group = "End",
                                    .enabledIf = "cut=true"})
          .add(&Params::cornerBound,
               {.key = "corner_bound",
                .label = "Rounding of corners",
                .help = "Layers have corners where fronts meet, such as on the outside of a "
                        "bend. They are rounded so far that the distance between layers differs "
                        "from the step by at most this; 0 keeps them.",
                .group = "Layers",
                .min = 0.0,
                .max = 100.0})
          .add(&Params::meshEdge,
               {.key = "mesh_edge",
                .label = "Mesh edge length",
                .help = "Of the mesh that carries the layers; 0 chooses it. Points are exact "
                        "whatever it is; details smaller than it may be passed over.",
                .group = "Accuracy",
                .level = ParamLevel::Advanced,
                .min = 0.0,
                .max = 100.0});
      return s;
    }();
    return schema;
  }
};

/// Distances from the base at which the parts end in a border that can be a layer, mm; NaN for the
/// others. They are measured along the surface, which on bent walls is a little more than the
/// layers' chords add up to.
std::vector<double> endsOf(const plugin::SliceInput& input,
                           double step,
                           const JobContext& context) {
  constexpr double kLayersPerEdge = 2.0;
  std::vector<double> ends;
  for (const auto& given : input.parts) {
    ends.push_back(std::numeric_limits<double>::quiet_NaN());
    // The slicing itself reports what is wrong with the base.
    const JobContext own = context.withOwnDiagnostics();
    try {
      const geometry::PartSurface part = geometry::refineSurface(
          *given, geometry::fieldEdgeLength(*given, kLayersPerEdge * step), own);
      const toolpath::PartBase base = toolpath::findBase(part, *input.substrate, own);
      ends.back() =
          toolpath::endBorderOf(base, toolpath::distanceFromBase(part, base, own), step).distance;
    } catch (const Error& error) {
      if (error.code() != ErrorCode::JobFailed && error.code() != ErrorCode::CheckFailed) {
        throw;
      }
    }
  }
  return ends;
}

class ConstantSlicing : public plugin::SlicingStrategy {
public:
  [[nodiscard]] toolpath::SlicedLayers slice(const plugin::SliceInput& input,
                                             const Value& values,
                                             const JobContext& context) const override {
    const Params params = Params::schema().read(values, "constant distance");
    toolpath::ConstantDistanceOptions options;
    const toolpath::LayerWish wish{params.step.value(), params.firstLayer, params.last,
                                   input.bead.heightMin, input.bead.heightMax};
    const std::vector<double> ends =
        params.cut ? std::vector<double>{} : endsOf(input, wish.step, context.portion(0.0, 0.2));
    // A border that misses the last layer by less than this part of the step is that layer.
    constexpr double kBorder = 0.01;
    options.step = wish.step;
    double farthest = 0.0;
    for (const double end : ends) {
      farthest = std::isnan(end) ? farthest : std::max(farthest, end);
    }
    if (farthest > 0.0) {
      options.step = toolpath::layersUpTo(farthest, wish, kBorder * wish.step).step;
    }
    options.firstLayer = params.firstLayer;
    options.cornerBound = params.cornerBound.value();
    options.meshEdge = params.meshEdge.value();
    if (params.cut) {
      const Vec3 normal(params.cutNormal[0], params.cutNormal[1], params.cutNormal[2]);
      if (!(normal.norm() > 0.0)) {
        throw Error(ErrorCode::InvalidArgument, "the normal of the cutting plane has no length",
                    "cut_normal", "give a vector such as [0, 0, 1]");
      }
      options.end = {Vec3(params.cutPoint[0], params.cutPoint[1], params.cutPoint[2]),
                     normal.normalized()};
    }
    toolpath::SlicedLayers sliced = toolpath::sliceConstantDistance(
        input.parts, *input.substrate, options, input.sampling, context.portion(0.2, 1.0));
    std::vector<toolpath::LayerLevel> levels;
    for (const toolpath::SlicedLayer& layer : sliced.layers) {
      levels.push_back({layer.level, layer.up, layer.nominalHeight});
    }
    toolpath::reportSteps(ends, levels, wish, options.step, kBorder * wish.step, context);
    return sliced;
  }
};

void registerComponents(plugin::Registrar& registrar) {
  registrar.addSlicing(
      {.id = "wcam.slicing.constant",
       .name = "Constant inter-layer distance",
       .summary = "Curved layers, each at the same distance from the one below at every point.",
       .version = 2,
       .params = Params::schema().params()},
      [] { return std::make_unique<ConstantSlicing>(); });
}

}  // namespace

WCAM_PLUGIN(registerComponents);
