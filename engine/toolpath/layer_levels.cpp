// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/layer_levels.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/base/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace wcam::toolpath {

namespace {

constexpr double kMostLayers = 1e6;
/// A height of less than this many steps is no layer.
constexpr double kLeastHeight = 0.5;

bool inside(double step, const LayerWish& wish) {
  constexpr double kRounding = 1e-9;
  return step >= wish.heightMin * (1.0 - kRounding) && step <= wish.heightMax * (1.0 + kRounding);
}

/// The step that divides the height, of the number of layers nearest to the wanted one.
LayerSteps fitted(double height, const LayerWish& wish) {
  const double nearest = std::max(0.0, std::round(height / wish.step - wish.firstLayer));
  const auto stepOf = [&](double count) { return height / (wish.firstLayer + count); };
  double count = nearest;
  if (inside(wish.step, wish) && !inside(stepOf(nearest), wish)) {
    for (const double other : {nearest + 1.0, nearest - 1.0}) {
      if (other >= 0.0 && wish.firstLayer + other > 0.0 && inside(stepOf(other), wish)) {
        count = other;
      }
    }
  }
  if (!(wish.firstLayer + count > 0.0)) {
    return {wish.step, 1};
  }
  return {stepOf(count), static_cast<std::size_t>(count) + 1};
}

}  // namespace

LayerSteps layersUpTo(double height, const LayerWish& wish, double tolerance) {
  const double places = (height + tolerance) / wish.step - wish.firstLayer;
  if (places >= kMostLayers) {
    throw Error(ErrorCode::InvalidArgument, "the step gives more than a million layers", "step",
                "choose a larger step");
  }
  const LayerSteps kept{wish.step,
                        places < 0.0 ? 0 : static_cast<std::size_t>(std::floor(places)) + 1};
  if (wish.last == LastLayer::Leave || height < kLeastHeight * wish.step) {
    return kept;
  }
  const double rest =
      height - (wish.firstLayer + static_cast<double>(kept.count) - 1.0) * wish.step;
  return kept.count > 0 && rest <= tolerance ? kept : fitted(height, wish);
}

bool endsFlat(const geometry::TriangleMesh& mesh,
              const geometry::HalfEdges& halfEdges,
              std::span<const double> values,
              double tolerance) {
  double most = -std::numeric_limits<double>::infinity();
  for (const double value : values) {
    most = std::isnan(value) ? most : std::max(most, value);
  }
  const auto high = [&](std::uint32_t v) { return values[v] >= most - tolerance; };
  double area = 0.0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& c = mesh.triangles[t];
    const std::array<bool, 3> on{high(c[0]), high(c[1]), high(c[2])};
    if (on[0] && on[1] && on[2]) {
      const Vec3& a = mesh.vertices[c[0]];
      area += 0.5 * (mesh.vertices[c[1]] - a).cross(Vec3(mesh.vertices[c[2]] - a)).norm();
    }
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (on[k] && on[(k + 1) % 3] && halfEdges.twin(3 * t + k) == geometry::HalfEdges::kNone) {
        return true;
      }
    }
  }
  // The cap of a dome as high as the tolerance is no face: a sphere of radius r has an area of
  // 2π·r·h there, and no radius of a part is greater than half its size.
  return area > kPi * mesh.bounds().diagonal() * tolerance;
}

EndBorder endBorderOf(const PartBase& base, const std::vector<double>& distance, double step) {
  // Distances on a mesh miss the true ones by a small part of an edge. A border whose distances
  // differ by more than this part of a step on both sides is slanted or wavy.
  constexpr double kEven = 0.05;
  EndBorder end;
  for (const BaseLoop& loop : base.upper) {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    for (const std::uint32_t v : loop.vertices) {
      low = std::min(low, distance[v]);
      high = std::max(high, distance[v]);
    }
    const double middle = 0.5 * (low + high);
    if (std::isfinite(middle) && !(middle <= end.distance)) {
      end = {middle, 0.5 * (high - low)};
    }
  }
  return end.spread <= kEven * step ? end : EndBorder{};
}

void reportSteps(const std::vector<double>& ends,
                 const std::vector<LayerLevel>& levels,
                 const LayerWish& wish,
                 double step,
                 double tolerance,
                 const JobContext& context) {
  if (step != wish.step) {
    context.add({Severity::Information,
                 "slicing.step_fitted",
                 text("the step is %1 mm instead of %2 mm, so that the last layer lies on the "
                      "part's end",
                      {formatFixed(step, 4), formatFixed(wish.step, 4)}),
                 "",
                 {},
                 {{"step_mm", step}, {"wanted_mm", wish.step}}});
  }
  for (std::size_t k = 0; k < ends.size(); ++k) {
    double last = -std::numeric_limits<double>::infinity();
    for (const LayerLevel& level : levels) {
      last = level.value <= ends[k] + tolerance ? std::max(last, level.value) : last;
    }
    const double rest = ends[k] - last;
    if (!std::isfinite(rest) || rest <= tolerance) {
      continue;
    }
    LayerWish fit = wish;
    fit.last = LastLayer::Fit;
    context.add({Severity::Warning,
                 "slicing.rest",
                 text("part %1 goes on for %2 mm above its last layer",
                      {std::to_string(k + 1), formatFixed(rest, 3)}),
                 text("a step of %1 mm ends on the part's end",
                      {formatFixed(fitted(ends[k], fit).step, 4)}),
                 {},
                 {{"rest_mm", rest}, {"step_mm", fitted(ends[k], fit).step}}});
  }
}

}  // namespace wcam::toolpath
