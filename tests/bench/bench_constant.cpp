// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/parallel.hpp"
#include "wcam/geometry/segment_tree.hpp"
#include "wcam/io/import.hpp"
#include "wcam/toolpath/constant_distance.hpp"
#include "wcam/toolpath/layer_distance.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>

/// The general tube of Chalvin (P6) at a constant distance of 1 mm on one core, against the method
/// of the thesis: on each line of the surface the next point by bisection of its distance to all
/// segments of the layer below (A11, A12), 200 points per layer. The layers must agree.
namespace {

using namespace wcam;
using geometry::Vec2;
using geometry::Vec3;

constexpr double kStep = 1.0;
constexpr int kPoints = 200;
/// Sagitta of the reference's chords, which it hands on from layer to layer, mm.
constexpr double kAgreement = 0.02;

double seconds(const std::chrono::steady_clock::time_point& from) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
}

double distanceTo(const std::vector<Vec3>& layer, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < layer.size(); ++i) {
    least =
        std::min(least, geometry::distanceToSegment(p, layer[i], layer[(i + 1) % layer.size()]));
  }
  return least;
}

/// Layers by bisection along the lines v = const, as long as all of them reach the next layer.
std::vector<std::vector<Vec3>> reference(const geometry::PartSurface& part) {
  geometry::BrepEvaluator evaluator(*part.brep);
  const auto& bounds = part.brep->face(0).uvBounds;
  const auto at = [&](double t, int i) {
    const double v = bounds[2] + (bounds[3] - bounds[2]) * i / kPoints;
    return evaluator.surface(0, Vec2(t, v)).p;
  };
  std::vector<std::vector<Vec3>> layers(1);
  std::vector<double> t(kPoints, bounds[0]);
  for (int i = 0; i < kPoints; ++i) {
    layers[0].push_back(at(t[static_cast<std::size_t>(i)], i));
  }
  while (true) {
    std::vector<Vec3> next;
    for (int i = 0; i < kPoints; ++i) {
      double& parameter = t[static_cast<std::size_t>(i)];
      double low = parameter;
      double high = std::min(bounds[1], parameter + 2.0 * kStep);
      if (distanceTo(layers.back(), at(high, i)) < kStep) {
        return layers;
      }
      for (int k = 0; k < 40; ++k) {
        const double middle = 0.5 * (low + high);
        (distanceTo(layers.back(), at(middle, i)) < kStep ? low : high) = middle;
      }
      parameter = 0.5 * (low + high);
      next.push_back(at(parameter, i));
    }
    layers.push_back(std::move(next));
  }
}

}  // namespace

int main() {
  const ThreadLimit oneCore(1);
  const auto part = io::importPart(std::string(WCAM_TEST_DATA) + "/formula/p6_tube_extended.wsurf",
                                   {}, geometry::Pose::Identity(), JobContext())
                        .surface;
  const toolpath::Substrate plate(geometry::Pose::Identity(), Vec3(200, 200, 10));
  toolpath::ConstantDistanceOptions options;
  options.step = kStep;
  options.firstLayer = 0.0;
  auto start = std::chrono::steady_clock::now();
  const toolpath::SlicedLayers sliced = toolpath::sliceConstantDistance({part}, plate, options, {});
  const double own = seconds(start);
  start = std::chrono::steady_clock::now();
  const auto layers = reference(*part);
  const double thesis = seconds(start);
  double worst = 0.0;
  for (std::size_t l = 0; l < layers.size(); ++l) {
    for (const double d : toolpath::layerDistance(layers[l], sliced.layers[l].contours)) {
      worst = std::max(worst, d);
    }
  }
  std::printf("constant distance, P6 at 1 mm: %zu layers, %.3f s\n", sliced.layers.size(), own);
  std::printf("bisection per point, %d points, %zu layers: %.3f s\n", kPoints, layers.size(),
              thesis);
  std::printf("largest difference %.4f mm\nratio %.2f\n", worst, thesis / own);
  const bool equal = layers.size() > 40 && worst <= kAgreement;
  if (!equal) {
    std::printf("the results differ\n");
  }
  return equal ? 0 : 1;
}
