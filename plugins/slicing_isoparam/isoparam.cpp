// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/plugin/plugin.hpp"
#include "wcam/toolpath/iso_parametric.hpp"

namespace {

using namespace wcam;
using geometry::Vec3;

enum class Mode { Auto, Revolution, Faces };
enum class Measure { Chord, Arc };

struct Params {
  Length step = 2.0_mm;
  double firstLayer = 1.0;
  toolpath::LastLayer last = toolpath::LastLayer::Fit;
  Mode mode = Mode::Auto;
  Measure measure = Measure::Chord;
  Length leastRadius = 0.0_mm;
  bool customAxis = false;
  std::array<double, 3> axisPoint{0.0, 0.0, 0.0};
  std::array<double, 3> axisDirection{0.0, 0.0, 1.0};
  toolpath::IsoDirection direction = toolpath::IsoDirection::Auto;

  static const Schema<Params>& schema() {
    static const Schema<Params> schema = [] {
      Schema<Params> s;
      addLayers(s);
      addRevolution(s);
      return s;
    }();
    return schema;
  }

private:
  static void addLayers(Schema<Params>& s) {
    s.add(&Params::step,
          {.key = "step",
           .label = "Layer step",
           .help = "Distance between points of neighbouring layers on the same iso-curve (Chalvin "
                   "A7, A9).",
           .group = "Layers",
           .min = 0.01,
           .max = 1000.0});
    s.add(&Params::firstLayer,
          {.key = "first_layer",
           .label = "First layer, in steps",
           .help = "Distance of the first layer from the base; 0 puts a layer on the base.",
           .group = "Layers",
           .level = ParamLevel::Advanced,
           .min = 0.0,
           .max = 100.0});
    toolpath::addLastLayer(s, &Params::last);
    s.add(&Params::mode,
          {.key = "mode",
           .label = "Curves",
           .help = "Parallels of a body of revolution, or the parameters of the faces of a CAD "
                   "part. auto takes the first where it fits.",
           .group = "Layers",
           .choices = {{"auto", "Automatic"},
                       {"revolution", "Body of revolution"},
                       {"faces", "Parameters of the faces"}}});
    s.add(&Params::direction,
          {.key = "direction",
           .label = "Parameter that climbs",
           .help = "auto takes for each face the one that leads away from the base.",
           .group = "Layers",
           .level = ParamLevel::Advanced,
           .choices = {{"auto", "Automatic"}, {"u", "u"}, {"v", "v"}}});
  }

  static void addRevolution(Schema<Params>& s) {
    s.add(
        &Params::measure,
        {.key = "measure",
         .label = "Step measured as",
         .help = "Chord: the distance between layers is exactly the step. Arc: along the profile.",
         .group = "Revolution",
         .level = ParamLevel::Advanced,
         .choices = {{"chord", "Chord"}, {"arc", "Arc length"}}});
    s.add(&Params::leastRadius,
          {.key = "least_radius",
           .label = "Least radius",
           .help = "Circles smaller than this are left out: near a pole the beads would overlap.",
           .group = "Revolution",
           .min = 0.0,
           .max = 1e6});
    s.add(&Params::customAxis, {.key = "custom_axis",
                                .label = "Own axis",
                                .help = "Otherwise the axis is found from the surface.",
                                .group = "Revolution"});
    s.add(&Params::axisPoint,
          {.key = "axis_point",
           .label = "Point of the axis",
           .help = "In the part frame.",
           .group = "Revolution",
           .enabledIf = "custom_axis=true"},
          ParamType::Vector3, QuantityKind::Length);
    s.add(&Params::axisDirection, {.key = "axis_direction",
                                   .label = "Direction of the axis",
                                   .help = "The way that the part grows; any length.",
                                   .group = "Revolution",
                                   .enabledIf = "custom_axis=true"});
  }
};

Vec3 toVec3(const std::array<double, 3>& a) {
  return {a[0], a[1], a[2]};
}

class IsoparamSlicing : public plugin::SlicingStrategy {
public:
  [[nodiscard]] toolpath::SlicedLayers slice(const plugin::SliceInput& input,
                                             const Value& values,
                                             const JobContext& context) const override {
    const Params params = Params::schema().read(values, "iso-parametric slicing");
    if (params.mode == Mode::Faces) {
      return byFaces(input, params, context);
    }
    if (params.mode == Mode::Revolution) {
      return byRevolution(input, params, context);
    }
    try {
      return byRevolution(input, params, context);
    } catch (const Error& revolution) {
      if (revolution.code() != ErrorCode::JobFailed) {
        throw;
      }
      try {
        return byFaces(input, params, context);
      } catch (const Error& faces) {
        if (faces.code() != ErrorCode::JobFailed) {
          throw;
        }
        throw Error(ErrorCode::JobFailed,
                    text("%1; %2", {revolution.messageText(), faces.messageText()}),
                    "iso-parametric slicing", faces.hintText());
      }
    }
  }

private:
  static toolpath::LayerWish wishOf(const plugin::SliceInput& input, const Params& params) {
    return {params.step.value(), params.firstLayer, params.last, input.bead.heightMin,
            input.bead.heightMax};
  }

  static toolpath::SlicedLayers byRevolution(const plugin::SliceInput& input,
                                             const Params& params,
                                             const JobContext& context) {
    toolpath::RevolutionOptions options;
    options.layers = wishOf(input, params);
    options.arcLength = params.measure == Measure::Arc;
    options.leastRadius = params.leastRadius.value();
    if (params.customAxis) {
      options.axis = {toVec3(params.axisPoint), toVec3(params.axisDirection)};
      if (!(options.axis->direction.norm() > 0.0)) {
        throw Error(ErrorCode::InvalidArgument, "the axis has no direction", "axis_direction",
                    "give a vector such as [0, 0, 1]");
      }
    }
    return toolpath::sliceRevolution(input.parts, *input.substrate, options, input.sampling,
                                     context);
  }

  static toolpath::SlicedLayers byFaces(const plugin::SliceInput& input,
                                        const Params& params,
                                        const JobContext& context) {
    toolpath::FaceIsoOptions options;
    options.layers = wishOf(input, params);
    options.direction = params.direction;
    return toolpath::sliceFaceIso(input.parts, *input.substrate, options, input.sampling, context);
  }
};

void registerComponents(plugin::Registrar& registrar) {
  registrar.addSlicing(
      {.id = "wcam.slicing.isoparam",
       .name = "Iso-parametric",
       .summary = "Parallels of a body of revolution at constant distance, or layers by the "
                  "parameters of the faces.",
       .version = 2,
       .params = Params::schema().params()},
      [] { return std::make_unique<IsoparamSlicing>(); });
}

}  // namespace

WCAM_PLUGIN(registerComponents);
