// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/text.hpp"
#include "wcam/geometry/refine.hpp"
#include "wcam/plugin/plugin.hpp"
#include "wcam/toolpath/base_curve.hpp"
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
  Method method = Method::Propagation;
  Length edge = 0.0_mm;

  static const Schema<Params>& schema();
};

const Schema<Params>& Params::schema() {
  static const Schema<Params> schema =
      Schema<Params>{}
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
                .max = 1e6})
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
                                             double farthest,
                                             const geometry::Vec3& up) {
  const double step = params.step.value();
  const double end = params.end.value() > 0.0 ? std::min(farthest, params.end.value()) : farthest;
  // A level that rounding puts a hair above the top is still the top.
  constexpr double kRounding = 1e-9;
  const double count = std::floor((end + kRounding * step) / step - params.firstLayer) + 1.0;
  if (!(count >= 1.0)) {
    throw Error(ErrorCode::JobFailed,
                text("the part is smaller than one layer: its farthest point is %1 mm from the "
                     "base, the first layer at %2 mm",
                     {formatFixed(farthest, 3), formatFixed(params.firstLayer * step, 3)}),
                kPlace, "choose a smaller step or first layer, or a later end");
  }
  constexpr double kMostLevels = 1e6;
  if (count > kMostLevels) {
    throw Error(ErrorCode::InvalidArgument, "the step gives more than a million layers", "step",
                "choose a larger step");
  }
  std::vector<toolpath::LayerLevel> levels;
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
    levels.push_back({(params.firstLayer + static_cast<double>(k)) * step, up, step});
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
      parts.push_back(std::move(part));
    }
    const auto levels = levelsUpTo(params, farthest, input.substrate->up());
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
                        .version = 1,
                        .params = Params::schema().params()},
                       [] { return std::make_unique<GeodesicSlicing>(); });
}

}  // namespace

WCAM_PLUGIN("org.wcam.slicing.geodesic", "0.1.0", registerComponents);
