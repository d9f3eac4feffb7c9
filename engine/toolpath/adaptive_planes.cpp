// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/toolpath/adaptive_planes.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"
#include "wcam/toolpath/layer_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::toolpath {

using geometry::PartSurface;

namespace {

/// The distance is met within this part of the step.
constexpr double kMet = 1e-4;
constexpr int kTrials = 30;

using Parts = std::vector<std::shared_ptr<const PartSurface>>;

class PlaneSearch {
public:
  PlaneSearch(const Parts& parts,
              const Substrate& substrate,
              const PlaneStack& frame,
              const Sampling& sampling)
      : parts_(parts), substrate_(substrate), frame_(frame), sampling_(sampling) {}

  /// The contours at a height; none where no part is.
  [[nodiscard]] std::vector<Contour> section(double height) const {
    PlaneStack stack = frame_;
    stack.levels = {{height, frame_.up, 0.0}};
    try {
      return sliceByField(parts_, PlaneField(stack), stack.levels, substrate_, sampling_,
                          JobContext())
          .layers.at(0)
          .contours;
    } catch (const Error& error) {
      if (error.code() != ErrorCode::JobFailed && error.code() != ErrorCode::CheckFailed) {
        throw;
      }
      return {};
    }
  }

  /// Greatest distance of the section's points to the contours below; infinite for
  /// an empty section.
  [[nodiscard]] static double distance(const std::vector<Contour>& section,
                                       const std::vector<Contour>& below) {
    std::vector<Vec3> points;
    for (const Contour& contour : section) {
      for (const ContourPoint& point : contour.points) {
        points.push_back(point.p);
      }
    }
    const std::vector<double> distances = layerDistance(points, below);
    return distances.empty() ? std::numeric_limits<double>::infinity()
                             : *std::max_element(distances.begin(), distances.end());
  }

private:
  const Parts& parts_;
  const Substrate& substrate_;
  const PlaneStack& frame_;
  const Sampling& sampling_;
};

/// What is chosen for one layer.
struct Choice {
  double height = 0.0;    ///< above the plane below
  double distance = 0.0;  ///< greatest one
  std::vector<Contour> contours;
};

/// The height at which the greatest distance is `wanted`, inside [least, most]; the distance grows
/// with the height. Without contours where the part ends.
Choice chooseHeight(const PlaneSearch& search,
                    const std::vector<Contour>& below,
                    double from,
                    double least,
                    double most,
                    double wanted) {
  const auto at = [&](double height) {
    Choice choice{height, 0.0, search.section(from + height)};
    choice.distance = PlaneSearch::distance(choice.contours, below);
    return choice;
  };
  Choice high = at(most);
  if (high.distance <= wanted * (1.0 + kMet)) {
    return high;
  }
  Choice low = at(least);
  if (low.contours.empty() || low.distance >= wanted * (1.0 - kMet)) {
    return low;
  }
  for (int i = 0; i < kTrials && high.height - low.height > 1e-9 * most; ++i) {
    // Secant where both ends are known, halved towards the middle so that it cannot stick.
    const double share =
        std::isfinite(high.distance) && i % 3 != 2
            ? std::clamp((wanted - low.distance) / (high.distance - low.distance), 0.02, 0.98)
            : 0.5;
    Choice middle = at(low.height + share * (high.height - low.height));
    if (std::abs(middle.distance - wanted) <= kMet * wanted) {
      return middle;
    }
    (middle.distance > wanted ? high : low) = std::move(middle);
  }
  // The part ends less than a step higher, and no wall leans before: that is no layer.
  return high.contours.empty() ? Choice{} : low;
}

/// Lays a last plane on the end of the highest part. A rest that is thinner than a layer shares the
/// height of the last two.
void endOnTop(const BeadRange& range, PlaneStack& stack) {
  double top = -std::numeric_limits<double>::infinity();
  for (const double end : stack.ends) {
    top = std::isnan(end) ? top : std::max(top, end);
  }
  LayerLevel last = stack.levels.back();
  const double rest = top - last.value;
  if (!std::isfinite(rest) || rest <= stack.tolerance) {
    return;
  }
  if (rest < range.heightMin) {
    if (stack.levels.size() < 2) {
      return;
    }
    LayerLevel& moved = stack.levels.back();
    const double below = stack.levels[stack.levels.size() - 2].value;
    const double half = 0.5 * (top - below);
    if (half < range.heightMin) {
      return;
    }
    moved.value = below + half;
  }
  last.value = top;
  stack.levels.push_back(last);
}

}  // namespace

PlaneStack adaptivePlanes(const Parts& parts,
                          const Substrate& substrate,
                          const PlaneStackOptions& options,
                          const BeadRange& range,
                          const Sampling& sampling,
                          const JobContext& context) {
  if (!(range.heightMin > 0.0) || !(range.heightMin <= range.heightMax)) {
    throw Error(ErrorCode::InvalidArgument, "the process's layer heights do not ascend",
                "adaptive planes", "correct the height range of the process file");
  }
  if (options.layers.step < range.heightMin || options.layers.step > range.heightMax) {
    throw Error(ErrorCode::InvalidArgument,
                text("the step of %1 mm is outside the process's layer heights of %2 to %3 mm",
                     {formatFixed(options.layers.step, 3), formatFixed(range.heightMin, 3),
                      formatFixed(range.heightMax, 3)}),
                "adaptive planes", "choose a step inside the range");
  }
  PlaneStackOptions whole = options;
  whole.layers.last = LastLayer::Leave;
  PlaneStack stack = planeStack(parts, substrate, whole);
  if (stack.levels.empty()) {
    return stack;
  }
  const LayerLevel last = stack.levels.back();
  // The stack ends less than a step above its last level.
  const double end = last.value + options.layers.step;
  stack.levels.resize(1);
  const PlaneSearch search(parts, substrate, stack, sampling);
  std::vector<Contour> below = search.section(stack.levels[0].value);
  const double bottom = stack.levels[0].value;
  while (true) {
    context.check();
    const double from = stack.levels.back().value;
    context.report(std::min(1.0, (from - bottom) / (end - bottom)));
    Choice choice = chooseHeight(search, below, from, range.heightMin, options.layers.step,
                                 options.layers.step);
    if (choice.contours.empty()) {
      if (options.layers.last == LastLayer::Fit) {
        endOnTop(range, stack);
      }
      return stack;
    }
    if (choice.distance > options.layers.step * (1.0 + 2.0 * kMet)) {
      context.add(
          {Severity::Warning,
           "slicing.step_not_kept",
           text("the layer at %1 mm lies up to %2 mm from the layer below, although the planes are "
                "as near as the process allows",
                {formatFixed(from + choice.height, 3), std::isfinite(choice.distance)
                                                           ? Text(formatFixed(choice.distance, 3))
                                                           : text("far more than")}),
           "use curved layers there, or a process with thinner layers",
           {{}, static_cast<int>(stack.levels.size()), -1, -1},
           std::isfinite(choice.distance)
               ? std::vector<std::pair<std::string, double>>{{"distance_mm", choice.distance}}
               : std::vector<std::pair<std::string, double>>{}});
    }
    stack.levels.push_back({from + choice.height, stack.up, options.layers.step});
    if (options.endHeight > 0.0 && stack.levels.back().value > options.endHeight) {
      stack.levels.pop_back();
      return stack;
    }
    below = std::move(choice.contours);
  }
}

}  // namespace wcam::toolpath
