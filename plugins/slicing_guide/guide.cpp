// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/text.hpp"
#include "wcam/geometry/skeleton.hpp"
#include "wcam/plugin/plugin.hpp"
#include "wcam/toolpath/layer_levels.hpp"
#include "wcam/toolpath/slice_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using namespace wcam;
using geometry::Vec3;

struct Params {
  bool automatic = false;
  Length step = 2.0_mm;
  double firstLayer = 1.0;
  toolpath::LastLayer last = toolpath::LastLayer::Fit;

  static const Schema<Params>& schema() {
    static const Schema<Params> schema = [] {
      Schema<Params> s;
      s.add(&Params::automatic,
            {.key = "automatic_guide",
             .label = "Automatic guide",
             .help = "Takes the axis of a tube-like part as guide, from its lower to its upper "
                     "end, instead of a guide of the project.",
             .group = "Guide"})
          .add(&Params::step,
               {.key = "step",
                .label = "Layer step",
                .help = "Chord of the guide between neighbouring planes (Chalvin A8).",
                .group = "Layers",
                .min = 0.01,
                .max = 1000.0})
          .add(&Params::firstLayer,
               {.key = "first_layer",
                .label = "First layer, in steps",
                .help = "Place of the first plane along the guide; 0 puts it at the guide's start.",
                .group = "Layers",
                .level = ParamLevel::Advanced,
                .min = 0.0,
                .max = 100.0});
      toolpath::addLastLayer(s, &Params::last);
      return s;
    }();
    return schema;
  }
};

/// The guide sampled so densely that the plane through a point is found between two neighbours.
class GuideTable {
public:
  explicit GuideTable(const geometry::GuideCurve& guide) {
    constexpr int kSamples = 1024;
    double length = 0.0;
    for (int i = 0; i <= kSamples; ++i) {
      const double t = guide.begin() + (guide.end() - guide.begin()) * i / kSamples;
      const geometry::CurvePoint c = guide.evaluate(t);
      if (!(c.d1.norm() > 0.0)) {
        throw Error(ErrorCode::InvalidArgument,
                    text("the guide curve stands still at parameter %1", {formatFixed(t, 6)}),
                    "guide", "choose a guide without cusps");
      }
      length += samples_.empty() ? 0.0 : (c.p - samples_.back().p).norm();
      samples_.push_back({t, c.p, c.d1.normalized(), c.d1.norm(), length});
    }
  }

  /// Parameter of the plane through p that is nearest along the guide; beyond the ends the guide
  /// goes on straight.
  [[nodiscard]] double parameterOf(const Vec3& p) const {
    std::size_t nearest = 0;
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const double distance = (p - samples_[i].p).squaredNorm();
      if (distance < best) {
        best = distance;
        nearest = i;
      }
    }
    std::size_t i = nearest;
    while (i > 0 && ahead(i, p) < 0.0) {
      --i;
    }
    while (i + 1 < samples_.size() && ahead(i + 1, p) >= 0.0) {
      ++i;
    }
    const Sample& s = samples_[i];
    const double from = ahead(i, p);
    if (from <= 0.0 || i + 1 == samples_.size()) {
      return s.t + from / s.speed;
    }
    const double to = ahead(i + 1, p);
    return s.t + (samples_[i + 1].t - s.t) * from / (from - to);
  }

  [[nodiscard]] double meanSpeed() const {
    return samples_.back().length / (samples_.back().t - samples_.front().t);
  }

private:
  struct Sample {
    double t;
    Vec3 p;
    Vec3 tangent;
    double speed;
    double length;
  };

  [[nodiscard]] double ahead(std::size_t i, const Vec3& p) const {
    return (p - samples_[i].p).dot(samples_[i].tangent);
  }

  std::vector<Sample> samples_;
};

/// φ(p) = guide parameter of the plane through p.
class GuidePlaneField : public toolpath::LayerField {
public:
  GuidePlaneField(const geometry::GuideCurve& guide, const std::vector<double>& parameters)
      : table_(guide) {
    for (const double t : parameters) {
      points_.push_back(guide.evaluate(t));
    }
  }

  [[nodiscard]] double scalar(const Vec3& p) const override { return table_.parameterOf(p); }

  [[nodiscard]] double residual(const Vec3& p, std::size_t level) const override {
    return (p - points_[level].p).dot(points_[level].d1.normalized());
  }

  [[nodiscard]] Vec3 gradient(const Vec3&, std::size_t level) const override {
    return points_[level].d1.normalized();
  }

  [[nodiscard]] double largestJump(double edgeLength) const override {
    // Inside a bend planes fan out, so that the parameter grows faster than the length; a true
    // tear, where a far part of the guide becomes the nearest, jumps by much more.
    constexpr double kFan = 20.0;
    return kFan * edgeLength / table_.meanSpeed();
  }

  [[nodiscard]] const geometry::CurvePoint& guidePoint(std::size_t level) const {
    return points_[level];
  }

private:
  GuideTable table_;
  std::vector<geometry::CurvePoint> points_;
};

/// Points that lie beyond the guide's centre of curvature: there neighbouring planes have crossed.
void reportCrossings(const toolpath::SlicedLayers& sliced,
                     const geometry::GuideCurve& guide,
                     const JobContext& context) {
  for (std::size_t l = 0; l < sliced.layers.size(); ++l) {
    const geometry::CurvePoint g = guide.evaluate(sliced.layers[l].level);
    const double speed2 = g.d1.squaredNorm();
    // κ·N of the curve: the part of d2 across the tangent, per squared speed.
    const Vec3 curvature = (g.d2 - g.d2.dot(g.d1) / speed2 * g.d1) / speed2;
    std::size_t crossed = 0;
    for (const toolpath::Contour& contour : sliced.layers[l].contours) {
      for (const toolpath::ContourPoint& point : contour.points) {
        crossed += (point.p - g.p).dot(curvature) >= 1.0 ? 1U : 0U;
      }
    }
    if (crossed > 0) {
      context.add({Severity::Warning,
                   "slicing.planes_cross",
                   text("%1 points lie where planes normal to the guide cross each other",
                        {std::to_string(crossed)}),
                   "the part is wider than the guide's radius of curvature there: use a straighter "
                   "guide or another strategy",
                   {{}, static_cast<int>(l), -1, -1},
                   {{"points", static_cast<double>(crossed)},
                    {"radius_of_curvature_mm", 1.0 / curvature.norm()}}});
    }
  }
}

class GuideSlicing : public plugin::SlicingStrategy {
public:
  [[nodiscard]] toolpath::SlicedLayers slice(const plugin::SliceInput& input,
                                             const Value& values,
                                             const JobContext& context) const override {
    const Params params = Params::schema().read(values, "slicing normal to a guide");
    if (!params.automatic && input.guide == nullptr) {
      throw Error(ErrorCode::InvalidArgument, "the operation names no guide curve",
                  "slicing normal to a guide",
                  "add a guide to the project (edge, polyline or formula) and name it in the "
                  "operation, or set automatic_guide");
    }
    if (params.automatic && input.parts.size() != 1) {
      throw Error(ErrorCode::InvalidArgument,
                  text("an automatic guide is the axis of one part, and the operation names %1",
                       {std::to_string(input.parts.size())}),
                  "slicing normal to a guide", "make one operation per part");
    }
    const std::shared_ptr<const geometry::GuideCurve> chosen =
        params.automatic ? geometry::automaticGuide(*input.parts.front(), input.substrate->up(),
                                                    context.portion(0.0, 0.3, "guide"))
                         : input.guide;
    const geometry::GuideCurve& guide = *chosen;
    const toolpath::LayerWish wish{params.step.value(), params.firstLayer, params.last,
                                   input.bead.heightMin, input.bead.heightMax};
    const double step =
        params.last == toolpath::LastLayer::Fit ? fittedStep(guide, wish, context) : wish.step;
    const std::vector<double> parameters = planeParameters(guide, step, wish.firstLayer, context);
    if (parameters.empty()) {
      throw Error(ErrorCode::JobFailed, "the guide is shorter than the first layer",
                  "slicing normal to a guide", "choose a smaller step");
    }
    std::vector<toolpath::LayerLevel> levels;
    for (const double t : parameters) {
      levels.push_back({t, guide.evaluate(t).d1.normalized(), step});
    }
    const GuidePlaneField field(guide, parameters);
    toolpath::SlicedLayers sliced = toolpath::sliceByField(
        input.parts, field, levels, *input.substrate, input.sampling, context);
    reportSteps(guide, parameters.back(), wish, step, context);
    reportCrossings(sliced, guide, context);
    return sliced;
  }

private:
  /// Lengths along a guide that are less than this are rounding of its chords, mm.
  static constexpr double kOnEnd = 1e-6;

  /// The step whose chords end on the guide's end; the wanted one where that ends there, or where
  /// the guide is too short.
  static double fittedStep(const geometry::GuideCurve& guide,
                           const toolpath::LayerWish& wish,
                           const JobContext& context) {
    const double rest = restOf(guide, planeParameters(guide, wish.step, wish.firstLayer, context));
    if (rest <= kOnEnd) {
      return wish.step;
    }
    const double length = geometry::arcLength(guide, guide.begin(), guide.end());
    const toolpath::LayerSteps arcs = toolpath::layersUpTo(length, wish, kOnEnd);
    if (arcs.step == wish.step) {
      return wish.step;
    }
    // Chords are shorter than arcs: the greatest step that still gives this many planes.
    double low = 0.5 * arcs.step;
    double high = arcs.step;
    if (planeParameters(guide, high, wish.firstLayer, context).size() >= arcs.count) {
      return high;
    }
    constexpr int kBisections = 30;
    for (int i = 0; i < kBisections; ++i) {
      const double middle = 0.5 * (low + high);
      (planeParameters(guide, middle, wish.firstLayer, context).size() >= arcs.count ? low : high) =
          middle;
    }
    return low;
  }

  /// Length of the guide beyond the last plane, mm.
  static double restOf(const geometry::GuideCurve& guide, const std::vector<double>& parameters) {
    return geometry::arcLength(guide, parameters.empty() ? guide.begin() : parameters.back(),
                               guide.end());
  }

  static void reportSteps(const geometry::GuideCurve& guide,
                          double last,
                          const toolpath::LayerWish& wish,
                          double step,
                          const JobContext& context) {
    const double length = geometry::arcLength(guide, guide.begin(), guide.end());
    const double rest = geometry::arcLength(guide, last, guide.end());
    toolpath::reportSteps({length}, {{length - rest, Vec3::UnitZ(), step}}, wish, step, kOnEnd,
                          context);
  }

  static std::vector<double> planeParameters(const geometry::GuideCurve& guide,
                                             double step,
                                             double firstLayer,
                                             const JobContext& context) {
    double from = guide.begin();
    const double offset = firstLayer * step;
    if (offset > 0.0) {
      const std::vector<double> first = geometry::chordSteps(guide, offset, from, context);
      if (first.size() < 2) {
        return {};
      }
      from = first[1];
    }
    return geometry::chordSteps(guide, step, from, context);
  }
};

void registerComponents(plugin::Registrar& registrar) {
  registrar.addSlicing(
      {.id = "wcam.slicing.guide",
       .name = "Normal to a guide",
       .summary = "Planes perpendicular to a guide curve, at a constant chord along it.",
       .version = 3,
       .params = Params::schema().params(),
       .needsGuide = true,
       .automaticGuide = "automatic_guide"},
      [] { return std::make_unique<GuideSlicing>(); });
}

}  // namespace

WCAM_PLUGIN(registerComponents);
