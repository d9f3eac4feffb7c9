// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/text.hpp"
#include "wcam/geometry/level_set.hpp"
#include "wcam/geometry/refine.hpp"
#include "wcam/plugin/plugin.hpp"
#include "wcam/toolpath/base_curve.hpp"
#include "wcam/toolpath/layer_levels.hpp"
#include "wcam/toolpath/onto_parts.hpp"
#include "wcam/toolpath/slice_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace {

using namespace wcam;

constexpr const char* kPlace = "geodesic slicing";

enum class Method { Propagation, Heat };

struct Params {
  Length step = 2.0_mm;
  double firstLayer = 1.0;
  Length end = 0.0_mm;
  toolpath::LastLayer last = toolpath::LastLayer::Fit;
  Method method = Method::Propagation;
  Length edge = 0.0_mm;

  static const Schema<Params>& schema();
};

Schema<Params> makeSchema() {
  Schema<Params> schema;
  schema
      .add(&Params::step, {.key = "step",
                           .label = "Layer step",
                           .help = "Distance between neighbouring layers along the surface.",
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
            .max = 100.0})
      .add(&Params::end,
           {.key = "end_distance",
            .label = "End distance",
            .help = "No layer farther from the base than this; 0 slices the whole part.",
            .group = "Layers",
            .level = ParamLevel::Advanced,
            .min = 0.0,
            .max = 1e6});
  toolpath::addLastLayer(schema, &Params::last);
  schema
      .add(&Params::method,
           {.key = "method",
            .label = "Distance by",
            .help = "Propagation is exact up to the mesh and keeps the creases where ways from "
                    "two sides meet; heat rounds them.",
            .group = "Field",
            .level = ParamLevel::Expert,
            .choices = {{"propagation", "Propagation of fronts"}, {"heat", "Heat"}}})
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

const Schema<Params>& Params::schema() {
  static const Schema<Params> schema = makeSchema();
  return schema;
}

/// Distance by heat from the vertices of the base's borders.
std::vector<double> heatFromBase(const geometry::PartSurface& part,
                                 const toolpath::PartBase& base) {
  if (!base.source.curves.empty()) {
    throw Error(ErrorCode::InvalidArgument,
                "the part passes through the substrate, and heat starts at borders only", kPlace,
                "choose the method propagation, or cut the part at the substrate");
  }
  std::vector<std::uint32_t> vertices = base.source.vertices;
  for (const std::uint32_t h : base.source.borderEdges) {
    vertices.push_back(part.mesh.triangles[h / 3][h % 3]);
    vertices.push_back(part.mesh.triangles[h / 3][(h % 3 + 1) % 3]);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const geometry::HeatSolver solver(part.mesh, part.halfEdges);
  std::vector<double> distance = solver.distance(vertices);
  for (double& d : distance) {
    d = std::isfinite(d) ? d : std::numeric_limits<double>::quiet_NaN();
  }
  return distance;
}

/// Levels from the first layer to the farthest point.
/// @param farthest greatest distance on any part, mm
std::vector<toolpath::LayerLevel> levelsUpTo(const Params& params,
                                             const toolpath::LayerWish& wish,
                                             double farthest,
                                             double tolerance,
                                             const geometry::Vec3& up) {
  const double end = params.end.value() > 0.0 ? std::min(farthest, params.end.value()) : farthest;
  const toolpath::LayerSteps steps = toolpath::layersUpTo(end, wish, tolerance);
  if (steps.count == 0) {
    throw Error(ErrorCode::JobFailed,
                text("the part is smaller than one layer: its farthest point is %1 mm from the "
                     "base, the first layer at %2 mm",
                     {formatFixed(farthest, 3), formatFixed(wish.firstLayer * wish.step, 3)}),
                kPlace, "choose a smaller step or first layer, or a later end");
  }
  std::vector<toolpath::LayerLevel> levels;
  for (std::size_t k = 0; k < steps.count; ++k) {
    levels.push_back({(wish.firstLayer + static_cast<double>(k)) * steps.step, up, steps.step});
  }
  return levels;
}

class GeodesicSlicing : public plugin::SlicingStrategy {
public:
  [[nodiscard]] toolpath::SlicedLayers slice(const plugin::SliceInput& input,
                                             const Value& values,
                                             const JobContext& context) const override {
    const Params params = Params::schema().read(values, kPlace);
    std::vector<std::shared_ptr<const geometry::PartSurface>> parts;
    toolpath::VertexField field;
    double farthest = 0.0;
    double flat = 0.0;
    std::vector<double> ends;
    for (std::size_t k = 0; k < input.parts.size(); ++k) {
      const auto count = static_cast<double>(input.parts.size());
      const JobContext portion = context.portion(0.6 * static_cast<double>(k) / count,
                                                 0.6 * static_cast<double>(k + 1) / count, "field");
      const double edge = params.edge.value() > 0.0
                              ? params.edge.value()
                              : geometry::fieldEdgeLength(*input.parts[k], params.step.value());
      auto part = std::make_shared<const geometry::PartSurface>(
          geometry::refineSurface(*input.parts[k], edge, portion));
      const toolpath::PartBase base = toolpath::findBase(*part, *input.substrate, portion);
      field.values.push_back(params.method == Method::Heat
                                 ? heatFromBase(*part, base)
                                 : toolpath::distanceFromBase(*part, base, portion));
      for (const double d : field.values.back()) {
        farthest = std::isnan(d) ? farthest : std::max(farthest, d);
      }
      const toolpath::EndBorder border =
          toolpath::endBorderOf(base, field.values.back(), params.step.value());
      ends.push_back(border.distance);
      flat = std::isnan(border.distance) ? flat : std::max(flat, border.distance);
      field.borderTolerance =
          std::max({field.borderTolerance, border.spread, geometry::flatTolerance(part->mesh)});
      parts.push_back(std::move(part));
    }
    const toolpath::LayerWish wanted{params.step.value(), params.firstLayer, params.last,
                                     input.bead.heightMin, input.bead.heightMax};
    toolpath::LayerWish wish = wanted;
    if (flat > 0.0) {
      wish.step = toolpath::layersUpTo(flat, wish, field.borderTolerance).step;
    }
    wish.last = toolpath::LastLayer::Leave;
    const auto levels =
        levelsUpTo(params, wish, farthest, field.borderTolerance, input.substrate->up());
    if (!(params.end.value() > 0.0 && params.end.value() < farthest)) {
      toolpath::reportSteps(ends, levels, wanted, wish.step, field.borderTolerance, context);
    }
    toolpath::SlicedLayers sliced =
        toolpath::sliceByField(parts, field, levels, *input.substrate, input.sampling,
                               context.portion(0.6, 0.9, "slicing"));
    toolpath::moveOntoParts(sliced, input.parts, input.sampling, context.portion(0.9, 1.0));
    sliced.curved = true;
    return sliced;
  }
};

void registerComponents(plugin::Registrar& registrar) {
  registrar.addSlicing({.id = "wcam.slicing.geodesic",
                        .name = "Geodesic distance from the base",
                        .summary = "Curved layers at a constant distance along the surface from "
                                   "the border on which the part stands.",
                        .version = 3,
                        .params = Params::schema().params()},
                       [] { return std::make_unique<GeodesicSlicing>(); });
}

}  // namespace

WCAM_PLUGIN(registerComponents);
