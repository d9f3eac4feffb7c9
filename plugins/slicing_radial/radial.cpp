// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/quantity.hpp"
#include "wcam/base/text.hpp"
#include "wcam/geometry/level_set.hpp"
#include "wcam/geometry/refine.hpp"
#include "wcam/plugin/plugin.hpp"
#include "wcam/toolpath/layer_levels.hpp"
#include "wcam/toolpath/onto_parts.hpp"
#include "wcam/toolpath/slice_field.hpp"

#include "facets.hpp"
#include "radial_fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

namespace {

using namespace wcam;
using namespace wcam::radial;

struct Params {
  Shape shape = Shape::Cylinder;
  Length step = 2.0_mm;
  bool customAxis = false;
  std::array<double, 3> origin{0.0, 0.0, 0.0};
  std::array<double, 3> direction{0.0, 0.0, 1.0};
  Angle coneAngle = 45.0_deg;
  Length start = 0.0_mm;
  double firstLayer = 1.0;
  Length end = 0.0_mm;
  toolpath::LastLayer last = toolpath::LastLayer::Fit;
  Angle startAngle = 0.0_deg;
  Angle sweep = 360.0_deg;
  Length stepRadius = 0.0_mm;

  static const Schema<Params>& schema();
};

void addLayers(Schema<Params>& schema) {
  schema
      .add(&Params::shape, {.key = "shape",
                            .label = "Layer surface",
                            .help = "On what the layers lie.",
                            .group = "Layers",
                            .choices = {{"cylinder", "Cylinders around the axis"},
                                        {"cone", "Cones around the axis"},
                                        {"sphere", "Spheres around the origin"},
                                        {"angle", "Half-planes through the axis"}}})
      .add(&Params::step,
           {.key = "step",
            .label = "Layer step",
            .help = "Distance between neighbouring layers; of half-planes at the step "
                    "radius.",
            .group = "Layers",
            .min = 0.01,
            .max = 1000.0})
      .add(&Params::start,
           {.key = "start",
            .label = "Start radius",
            .help =
                "Where the layers begin: the radius of the shaft or core on which they are built "
                "(of cones: the distance along the normal from the cone through the origin); 0 "
                "takes the part's nearest point.",
            .group = "Layers",
            .min = 0.0,
            .max = 1e6})
      .add(
          &Params::firstLayer,
          {.key = "first_layer",
           .label = "First layer, in steps",
           .help = "Height of the first layer above the start; 0 puts a layer on the start itself.",
           .group = "Layers",
           .level = ParamLevel::Advanced,
           .min = 0.0,
           .max = 100.0})
      .add(&Params::end,
           {.key = "end",
            .label = "End height",
            .help = "No layer above this height over the start; 0 slices the whole part.",
            .group = "Layers",
            .level = ParamLevel::Advanced,
            .min = 0.0,
            .max = 1e6});
  toolpath::addLastLayer(schema, &Params::last);
}

void addAxis(Schema<Params>& schema) {
  schema
      .add(&Params::customAxis, {.key = "custom_axis",
                                 .label = "Own axis",
                                 .help = "Otherwise the z axis of the substrate's frame.",
                                 .group = "Axis"})
      .add(&Params::origin, {.key = "axis_origin",
                             .label = "Axis origin",
                             .help = "A point of the axis in the part frame, mm.",
                             .group = "Axis",
                             .enabledIf = "custom_axis=true"})
      .add(&Params::direction, {.key = "axis_direction",
                                .label = "Axis direction",
                                .help = "In the part frame; any length.",
                                .group = "Axis",
                                .enabledIf = "custom_axis=true"})
      .add(&Params::coneAngle,
           {.key = "cone_angle",
            .label = "Cone angle",
            .help =
                "Between the axis and the direction in which cones grow: 0 gives planes across the "
                "axis, 90 cylinders; above 90 the cones open downwards.",
            .group = "Axis",
            .min = 0.0,
            .max = 180.0,
            .enabledIf = "shape=cone"})
      .add(&Params::startAngle, {.key = "start_angle",
                                 .label = "Start angle",
                                 .help = "Of the first half-plane, about the axis.",
                                 .group = "Axis",
                                 .min = -360.0,
                                 .max = 360.0,
                                 .enabledIf = "shape=angle"})
      .add(&Params::sweep, {.key = "sweep",
                            .label = "Sweep",
                            .help = "Angle over which half-planes follow each other.",
                            .group = "Axis",
                            .min = 0.01,
                            .max = 360.0,
                            .enabledIf = "shape=angle"})
      .add(&Params::stepRadius,
           {.key = "step_radius",
            .label = "Step radius",
            .help =
                "Radius at which half-planes lie one step apart; 0 takes the part's middle radius.",
            .group = "Axis",
            .level = ParamLevel::Advanced,
            .min = 0.0,
            .max = 1e6,
            .enabledIf = "shape=angle"});
}

const Schema<Params>& Params::schema() {
  static const Schema<Params> schema = [] {
    Schema<Params> made;
    addLayers(made);
    addAxis(made);
    return made;
  }();
  return schema;
}

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

/// Values of a field at the vertices of each part.
using PartValues = std::vector<std::vector<double>>;

/// The field's own values.
template <class Function>
PartValues fieldAt(const plugin::SliceInput& input, const Function& value) {
  PartValues values;
  for (const auto& part : input.parts) {
    std::vector<double>& at = values.emplace_back();
    for (const Vec3& p : part->mesh.vertices) {
      at.push_back(value(p));
    }
  }
  return values;
}

/// Minimum and maximum over the parts.
Extent extentOf(const PartValues& values) {
  Extent extent;
  for (const std::vector<double>& part : values) {
    for (const double v : part) {
      extent.low = std::min(extent.low, v);
      extent.high = std::max(extent.high, v);
    }
  }
  return extent;
}

Axis axisOf(const Params& params, const toolpath::Substrate& substrate) {
  Axis axis;
  axis.origin = substrate.pose().translation();
  axis.z = substrate.up();
  axis.x = substrate.pose().linear().col(0);
  if (params.customAxis) {
    axis.origin = Vec3(params.origin[0], params.origin[1], params.origin[2]);
    axis.z = Vec3(params.direction[0], params.direction[1], params.direction[2]);
    if (!(axis.z.norm() > 0.0)) {
      throw Error(ErrorCode::InvalidArgument, "the axis has no direction", "axis_direction",
                  "give a vector such as [0, 0, 1]");
    }
    axis.z.normalize();
    // The nearest to the part's x axis, so that angles count from there.
    const Vec3 x = Vec3::UnitX() - axis.z.x() * axis.z;
    constexpr double kAlongX = 1e-6;
    axis.x = x.norm() > kAlongX ? Vec3(x.normalized()) : axis.z.unitOrthogonal();
  }
  axis.y = axis.z.cross(axis.x);
  return axis;
}

/// Layers around an axis do not grow along the substrate's build direction, so that nothing is
/// below it: the start radius says where the part begins.
toolpath::Substrate nothingBelow(const toolpath::Substrate& substrate, double size) {
  geometry::Pose pose = substrate.pose();
  constexpr double kFarBelow = 1e3;
  pose.translation() -= kFarBelow * size * substrate.up();
  return toolpath::Substrate(pose, Vec3(1.0, 1.0, 1.0));
}

/// Heights above the start at which the parts end in a face or a border, mm; NaN for the others.
/// @param unit change of the field's value per mm
std::vector<double> endsOf(const plugin::SliceInput& input,
                           const PartValues& values,
                           double start,
                           double unit,
                           double tolerance) {
  std::vector<double> ends;
  for (std::size_t k = 0; k < values.size(); ++k) {
    std::vector<double> heights;
    double most = -std::numeric_limits<double>::infinity();
    for (const double v : values[k]) {
      heights.push_back((v - start) / unit);
      most = std::max(most, heights.back());
    }
    const geometry::PartSurface& part = *input.parts[k];
    const bool flat = toolpath::endsFlat(part.mesh, part.halfEdges, heights, 2.0 * tolerance);
    ends.push_back(flat ? most : std::numeric_limits<double>::quiet_NaN());
  }
  return ends;
}

double flatToleranceOf(const plugin::SliceInput& input) {
  double tolerance = 0.0;
  for (const auto& part : input.parts) {
    tolerance = std::max(tolerance, geometry::flatTolerance(part->mesh));
  }
  return tolerance;
}

/// A border or an outer face of flats, whose corners lie beyond the last layer: their middles may
/// not, and no step ends on both.
void reportUnevenEnds(const plugin::SliceInput& given,
                      const RevolvedField& field,
                      const std::vector<double>& ends,
                      double last,
                      const JobContext& context) {
  for (std::size_t k = 0; k < given.parts.size(); ++k) {
    const geometry::PartSurface& part = *given.parts[k];
    if (part.exact() || !std::isnan(ends[k])) {
      continue;  // an even end has a finding of its own
    }
    std::vector<double> values;
    double most = -std::numeric_limits<double>::infinity();
    for (const Vec3& p : part.mesh.vertices) {
      values.push_back(field.scalar(p));
      most = std::max(most, values.back());
    }
    const double tolerance = 2.0 * geometry::flatTolerance(part.mesh);
    if (most - last <= tolerance ||
        !toolpath::endsFlat(part.mesh, part.halfEdges, values, tolerance)) {
      continue;
    }
    double middle = most;
    for (const auto& c : part.mesh.triangles) {
      for (std::size_t e = 0; e < 3; ++e) {
        const std::uint32_t a = c[e];
        const std::uint32_t b = c[(e + 1) % 3];
        if (std::min(values[a], values[b]) >= most - tolerance) {
          middle =
              std::min(middle, field.scalar(0.5 * (part.mesh.vertices[a] + part.mesh.vertices[b])));
        }
      }
    }
    context.add({Severity::Warning,
                 "slicing.rest",
                 text("the end of part %1 is made of flats: it goes on above the last layer for %2 "
                      "mm at its corners and for %3 mm between them",
                      {std::to_string(k + 1), formatFixed(most - last, 3),
                       formatFixed(std::max(0.0, middle - last), 3)}),
                 "export the part with finer facets if its end is round; otherwise shape it by an "
                 "operation of its own",
                 {},
                 {{"rest_mm", most - last}, {"middle_rest_mm", middle - last}}});
  }
}

/// Levels of a field from its value `start` on.
/// @param ends heights at which the parts end, mm
/// @param height of the last level at most, mm
/// @param cut whether the layers end before the parts do, as is wanted
std::vector<toolpath::LayerLevel> levelsFrom(double start,
                                             double unit,
                                             const std::vector<double>& ends,
                                             double height,
                                             bool cut,
                                             const toolpath::LayerWish& wanted,
                                             double tolerance,
                                             const Vec3& up,
                                             const JobContext& context) {
  toolpath::LayerWish wish = wanted;
  double flat = -1.0;
  for (const double end : ends) {
    flat = std::isnan(end) ? flat : std::max(flat, end);
  }
  if (flat > 0.0) {
    wish.step = toolpath::layersUpTo(flat, wish, tolerance).step;
  }
  wish.last = toolpath::LastLayer::Leave;
  const toolpath::LayerSteps steps = toolpath::layersUpTo(height, wish, tolerance);
  std::vector<toolpath::LayerLevel> heights;
  std::vector<toolpath::LayerLevel> levels;
  for (std::size_t k = 0; k < steps.count; ++k) {
    const double h = (wish.firstLayer + static_cast<double>(k)) * steps.step;
    heights.push_back({h, up, steps.step});
    levels.push_back({start + h * unit, up, steps.step});
  }
  toolpath::reportSteps(cut ? std::vector<double>{} : ends, heights, wanted, steps.step, tolerance,
                        context);
  return levels;
}

class RadialSlicing : public plugin::SlicingStrategy {
public:
  [[nodiscard]] toolpath::SlicedLayers slice(const plugin::SliceInput& given,
                                             const Value& values,
                                             const JobContext& context) const override {
    const Params params = Params::schema().read(values, "slicing around an axis");
    const Axis axis = axisOf(params, *given.substrate);
    const plugin::SliceInput input =
        refined(given, params.step.value(), context.portion(0.0, 0.3, "refinement"));
    double size = 0.0;
    for (const auto& part : input.parts) {
      size = std::max(size, part->mesh.bounds().diagonal());
    }
    const toolpath::Substrate substrate = nothingBelow(*input.substrate, size);
    toolpath::SlicedLayers sliced =
        params.shape == Shape::Angle
            ? sliceByAngle(input, params, axis, substrate, context)
            : sliceByHeight(given, input, params, axis, substrate, context);
    sliced.curved = true;
    sliced.onSubstrate = false;
    toolpath::moveOntoParts(sliced, given.parts, given.sampling, context);
    for (toolpath::SlicedLayer& layer : sliced.layers) {
      setBuildDirection(layer);
    }
    sliced.layers.front().below = std::vector<std::size_t>{};
    return sliced;
  }

private:
  /// A round field is not linear on large flat triangles.
  static plugin::SliceInput refined(plugin::SliceInput input,
                                    double step,
                                    const JobContext& context) {
    constexpr double kLayersPerEdge = 2.0;
    for (std::size_t k = 0; k < input.parts.size(); ++k) {
      const auto& part = input.parts[k];
      input.parts[k] = std::make_shared<const geometry::PartSurface>(geometry::refineSurface(
          *part, geometry::fieldEdgeLength(*part, kLayersPerEdge * step), context));
    }
    return input;
  }

  static toolpath::SlicedLayers sliceByHeight(const plugin::SliceInput& given,
                                              const plugin::SliceInput& input,
                                              const Params& params,
                                              const Axis& axis,
                                              const toolpath::Substrate& substrate,
                                              const JobContext& context) {
    RevolvedField field(axis, params.shape, params.coneAngle.value());
    const double tolerance = flatToleranceOf(input);
    PartValues values;
    for (std::size_t k = 0; k < given.parts.size(); ++k) {
      values.push_back(valuesOnFacets(
          *given.parts[k], *input.parts[k], [&](const Vec3& p) { return field.scalar(p); },
          params.step.value(), 2.0 * tolerance));
    }
    const Extent extent = extentOf(values);
    const double start = params.start.value() > 0.0 ? params.start.value() : extent.low;
    const std::vector<double> ends = endsOf(input, values, start, 1.0, tolerance);
    const double height = extent.high - start;
    const bool cut = params.end.value() > 0.0 && params.end.value() < height;
    const std::vector<toolpath::LayerLevel> levels =
        levelsFrom(start, 1.0, ends, cut ? params.end.value() : height, cut, wishOf(params, input),
                   tolerance, axis.z, context);
    requireLevels(levels, start, extent);
    if (!cut) {
      reportUnevenEnds(given, field, ends, levels.back().value, context);
    }
    field.setLevels(levels);
    field.setValues(std::move(values));
    toolpath::SlicedLayers sliced =
        toolpath::sliceByField(input.parts, field, levels, substrate, input.sampling, context);
    // The first layer lies on the core, whose distance nobody can measure.
    setHeights(sliced.layers.front(), sliced.layers.front().level - start);
    return sliced;
  }

  static toolpath::SlicedLayers sliceByAngle(const plugin::SliceInput& input,
                                             const Params& params,
                                             const Axis& axis,
                                             const toolpath::Substrate& substrate,
                                             const JobContext& context) {
    const Extent radius =
        extentOf(fieldAt(input, [&](const Vec3& p) { return axis.radial(p).norm(); }));
    const double stepRadius = params.stepRadius.value() > 0.0 ? params.stepRadius.value()
                                                              : 0.5 * (radius.low + radius.high);
    if (!(stepRadius > 0.0)) {
      throw Error(ErrorCode::JobFailed, "the part lies on the axis", "slicing around an axis",
                  "move the axis beside the part");
    }
    const double step = 2.0 * std::asin(std::min(1.0, 0.5 * params.step.value() / stepRadius));
    AngleField field(axis, params.startAngle.value(), radius.low);
    const PartValues values = fieldAt(input, [&](const Vec3& p) { return field.scalar(p); });
    const Extent angles = extentOf(values);
    const double start = std::max(0.0, angles.low);
    const double unit = step / params.step.value();
    const double tolerance = flatToleranceOf(input);
    const bool cut = params.sweep.value() < angles.high;
    const double high = cut ? params.sweep.value() : angles.high;
    const std::vector<toolpath::LayerLevel> levels =
        levelsFrom(start, unit, endsOf(input, values, start, unit, tolerance),
                   (high - start) / unit, cut, wishOf(params, input), tolerance, axis.z, context);
    requireLevels(levels, 0.0, angles);
    field.setLevels(levels);
    toolpath::SlicedLayers sliced =
        toolpath::sliceByField(input.parts, field, levels, substrate, input.sampling, context);
    // The first layer lies on the half-plane of the start: its height grows with the radius.
    toolpath::SlicedLayer& first = sliced.layers.front();
    const double chord = 2.0 * std::sin(0.5 * (first.level - std::max(0.0, angles.low)));
    for (toolpath::Contour& contour : first.contours) {
      for (toolpath::ContourPoint& point : contour.points) {
        point.height = chord * axis.radial(point.p).norm();
      }
    }
    return sliced;
  }

  static toolpath::LayerWish wishOf(const Params& params, const plugin::SliceInput& input) {
    return {params.step.value(), params.firstLayer, params.last, input.bead.heightMin,
            input.bead.heightMax};
  }

  static void requireLevels(const std::vector<toolpath::LayerLevel>& levels,
                            double start,
                            const Extent& extent) {
    if (levels.empty()) {
      throw Error(ErrorCode::JobFailed,
                  text("no layer fits between the start at %1 and the part's end at %2",
                       {formatFixed(start, 2), formatFixed(extent.high, 2)}),
                  "slicing around an axis", "choose a smaller step or start radius");
    }
  }

  static void setHeights(toolpath::SlicedLayer& layer, double height) {
    if (!(height > 0.0)) {
      return;
    }
    for (toolpath::Contour& contour : layer.contours) {
      for (toolpath::ContourPoint& point : contour.points) {
        point.height = height;
      }
    }
  }

  /// Mean of t × n over the layer; what cancels around the axis leaves the direction that it had.
  static void setBuildDirection(toolpath::SlicedLayer& layer) {
    Vec3 sum = Vec3::Zero();
    double weight = 0.0;
    for (const toolpath::Contour& contour : layer.contours) {
      for (std::size_t i = 1; i < contour.points.size(); ++i) {
        const Vec3 b = (contour.points[i].p - contour.points[i - 1].p).cross(contour.points[i].n);
        sum += b;
        weight += b.norm();
      }
    }
    constexpr double kCancelled = 1e-6;
    if (sum.norm() > kCancelled * weight) {
      layer.up = sum.normalized();
    }
  }
};

void registerComponents(plugin::Registrar& registrar) {
  registrar.addSlicing(
      {.id = "wcam.slicing.radial",
       .name = "Around an axis",
       .summary = "Layers on cylinders, cones, spheres or half-planes around an axis: flanges on a "
                  "shaft, blades on a hub, bent walls.",
       .version = 4,
       .params = Params::schema().params()},
      [] { return std::make_unique<RadialSlicing>(); });
}

}  // namespace

WCAM_PLUGIN(registerComponents);
