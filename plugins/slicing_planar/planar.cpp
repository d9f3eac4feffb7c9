// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/plugin/plugin.hpp"
#include "wcam/toolpath/slice_field.hpp"

#include <algorithm>
#include <cmath>

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

/// φ(p) = up·p − base: heights of parallel planes.
class PlaneField : public toolpath::LayerField {
public:
  PlaneField(const Vec3& up, double base, const std::vector<toolpath::LayerLevel>& levels)
      : up_(up), base_(base), levels_(levels) {}

  [[nodiscard]] double scalar(const Vec3& p) const override { return up_.dot(p) - base_; }

  [[nodiscard]] double residual(const Vec3& p, std::size_t level) const override {
    return scalar(p) - levels_[level].value;
  }

  [[nodiscard]] Vec3 gradient(const Vec3&, std::size_t) const override { return up_; }

private:
  Vec3 up_;
  double base_;
  const std::vector<toolpath::LayerLevel>& levels_;
};

/// Lowest and highest plane position of what stands above the substrate.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double position) {
    low = std::min(low, position);
    high = std::max(high, position);
  }
};

Extent extentAboveSubstrate(const plugin::SliceInput& input, const Vec3& up) {
  Extent extent;
  for (const auto& part : input.parts) {
    const geometry::TriangleMesh& mesh = part->mesh;
    std::vector<double> height(mesh.vertices.size());
    for (std::size_t v = 0; v < height.size(); ++v) {
      height[v] = input.substrate->heightAbove(mesh.vertices[v]);
      if (height[v] >= 0.0) {
        extent.add(up.dot(mesh.vertices[v]));
      }
    }
    // Where an edge passes through the substrate, the part begins on it.
    for (const auto& triangle : mesh.triangles) {
      for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t a = triangle[c];
        const std::uint32_t b = triangle[(c + 1) % 3];
        if ((height[a] < 0.0) != (height[b] < 0.0)) {
          const double s = height[a] / (height[a] - height[b]);
          extent.add(up.dot(mesh.vertices[a] + s * (mesh.vertices[b] - mesh.vertices[a])));
        }
      }
    }
  }
  return extent;
}

class PlanarSlicing : public plugin::SlicingStrategy {
public:
  [[nodiscard]] toolpath::SlicedLayers slice(const plugin::SliceInput& input,
                                             const Value& values,
                                             const JobContext& context) const override {
    const Params params = Params::schema().read(values, "planar slicing");
    const toolpath::Substrate& substrate = *input.substrate;
    Vec3 up = substrate.up();
    if (params.customDirection) {
      up = Vec3(params.direction[0], params.direction[1], params.direction[2]);
      if (!(up.norm() > 0.0)) {
        throw Error(ErrorCode::InvalidArgument, "the build direction has no length", "direction",
                    "give a vector such as [0, 0, 1]");
      }
      up.normalize();
    }
    const Extent extent = extentAboveSubstrate(input, up);
    if (!(extent.low <= extent.high)) {
      throw Error(ErrorCode::JobFailed, "the whole part lies below the substrate", "planar slicing",
                  "raise the part or lower the substrate");
    }
    // On a plate the planes count from its top; with an own direction or an uneven substrate from
    // the part's lowest point.
    const bool fromPlate = substrate.isPlate() && !params.customDirection;
    const double base = fromPlate ? up.dot(substrate.pose().translation()) : extent.low;
    const std::vector<toolpath::LayerLevel> levels =
        levelsBetween(params, up, extent.low - base, extent.high - base);
    const PlaneField field(up, base, levels);
    return toolpath::sliceByField(input.parts, field, levels, substrate, input.sampling, context);
  }

private:
  static std::vector<toolpath::LayerLevel> levelsBetween(const Params& params,
                                                         const Vec3& up,
                                                         double low,
                                                         double high) {
    const double step = params.step.value();
    const double end =
        params.endHeight.value() > 0.0 ? std::min(high, params.endHeight.value()) : high;
    // A level that rounding puts a hair above the top is still the top.
    constexpr double kRounding = 1e-9;
    std::vector<toolpath::LayerLevel> levels;
    constexpr std::size_t kMostLevels = 1000000;
    for (std::size_t k = 0; levels.size() <= kMostLevels; ++k) {
      const double value = (params.firstLayer + static_cast<double>(k)) * step;
      if (value > end + kRounding * step) {
        return levels;
      }
      if (value >= low - kRounding * step) {
        levels.push_back({value, up, step});
      }
    }
    throw Error(ErrorCode::InvalidArgument, "the step gives more than a million layers", "step",
                "choose a larger step");
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
