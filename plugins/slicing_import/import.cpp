// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/plugin/plugin.hpp"
#include "wcam/toolpath/numeric_frames.hpp"

#include <algorithm>
#include <limits>

namespace {

using namespace wcam;
using geometry::Vec3;

enum class Axes { File, Numeric, Rules };

struct Params {
  Axes axes = Axes::File;
  bool keepOrder = true;
  bool heights = true;
  bool widths = true;
  Length layerHeight = 2.0_mm;

  static const Schema<Params>& schema() {
    static const Schema<Params> schema =
        Schema<Params>{}
            .add(&Params::axes,
                 {.key = "axes",
                  .label = "Tool axes",
                  .help = "Axes of the file are used where the path's axis rule is automatic. "
                          "Numeric axes follow from the neighbouring layers, for files without "
                          "normals.",
                  .group = "Import",
                  .choices = {{"file", "From the file, else numeric"},
                              {"numeric", "Numeric, from the points alone"},
                              {"rules", "By the axis rules of the path, from the file's normals"}}})
            .add(&Params::keepOrder,
                 {.key = "keep_order",
                  .label = "Keep the order",
                  .help = "Order, starts and directions of the beads stay as in the file. "
                          "Otherwise the path's rules choose them.",
                  .group = "Import"})
            .add(&Params::heights, {.key = "heights",
                                    .label = "Layer heights of the file",
                                    .help = "Otherwise they are measured.",
                                    .group = "Import"})
            .add(&Params::widths, {.key = "widths",
                                   .label = "Bead widths of the file",
                                   .help = "Otherwise the process's width holds.",
                                   .group = "Import"})
            .add(&Params::layerHeight,
                 {.key = "layer_height",
                  .label = "Nominal layer height",
                  .help = "Holds where no height is given and none can be measured.",
                  .group = "Import",
                  .min = 0.01,
                  .max = 100.0});
    return schema;
  }
};

/// Mean and spread of a layer's heights above the substrate.
struct Heights {
  double mean = 0.0;
  double spread = 0.0;
};

Heights heightsOf(const std::vector<toolpath::Contour>& contours,
                  const Vec3& up,
                  const Vec3& base) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  double sum = 0.0;
  double count = 0.0;
  for (const toolpath::Contour& contour : contours) {
    for (const toolpath::ContourPoint& point : contour.points) {
      const double height = up.dot(point.p - base);
      low = std::min(low, height);
      high = std::max(high, height);
      sum += height;
      count += 1.0;
    }
  }
  return count > 0.0 ? Heights{sum / count, high - low} : Heights{};
}

class ImportedSlicing : public plugin::SlicingStrategy {
public:
  [[nodiscard]] toolpath::SlicedLayers slice(const plugin::SliceInput& input,
                                             const Value& values,
                                             const JobContext& context) const override {
    const Params params = Params::schema().read(values, "imported path");
    if (input.imported == nullptr) {
      throw Error(ErrorCode::InvalidArgument, "the operation names no file with a path", {},
                  "set the operation's \"file\" to a table of points");
    }
    const toolpath::ImportedPath& imported = *input.imported;
    const Vec3 up = input.substrate->up();
    const bool numeric = params.axes == Axes::Numeric || !imported.hasNormals;
    toolpath::SlicedLayers result;
    result.asGiven = params.keepOrder;
    for (const std::vector<toolpath::Contour>& contours : imported.layers) {
      context.check();
      toolpath::SlicedLayer layer;
      const Heights heights = heightsOf(contours, up, input.substrate->pose().translation());
      layer.level = heights.mean;
      layer.up = up;
      layer.nominalHeight = params.layerHeight.value();
      layer.contours = contours;
      // A layer that is not as flat as its chords are exact has a build direction that changes.
      result.curved |= heights.spread > input.sampling.chordError;
      for (toolpath::Contour& contour : layer.contours) {
        adapt(contour, params);
      }
      result.layers.push_back(std::move(layer));
    }
    if (numeric) {
      toolpath::setNumericNormals(result, context);
    }
    return result;
  }

private:
  static void adapt(toolpath::Contour& contour, const Params& params) {
    for (toolpath::ContourPoint& point : contour.points) {
      point.height = params.heights ? point.height : 0.0;
      point.width = params.widths ? point.width : 0.0;
      if (params.axes != Axes::File) {
        point.axis = Vec3::Zero();
      }
    }
  }
};

void registerComponents(plugin::Registrar& registrar) {
  registrar.addSlicing(
      {.id = "wcam.slicing.import",
       .name = "Imported path",
       .summary = "Takes the path from a table of points instead of slicing the part.",
       .version = 1,
       .params = Params::schema().params(),
       .needsFile = true},
      [] { return std::make_unique<ImportedSlicing>(); });
}

}  // namespace

WCAM_PLUGIN(registerComponents);
