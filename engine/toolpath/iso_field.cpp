// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/iso_field.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"
#include "wcam/geometry/cut_mesh.hpp"
#include "wcam/geometry/geodesic.hpp"
#include "wcam/geometry/harmonic.hpp"
#include "wcam/geometry/surface_point.hpp"
#include "wcam/toolpath/base_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace wcam::toolpath {

namespace {

constexpr const char* kPlace = "iso-values";
/// An upper border shorter than this part of the longest border of its piece is a hole in the wall,
/// around which the layers part, not an end that they follow.
constexpr double kHole = 0.1;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::vector<double> heightsOf(const geometry::TriangleMesh& mesh, const Substrate& substrate) {
  std::vector<double> heights;
  heights.reserve(mesh.vertices.size());
  for (const Vec3& p : mesh.vertices) {
    heights.push_back(substrate.heightAbove(p));
  }
  return heights;
}

void check(const IsoValueOptions& options) {
  if (!(options.step > 0.0) || !(options.firstLayer >= 0.0) || !(options.conductivityUp > 0.0) ||
      !(options.geodesicShare >= 0.0) || !(options.geodesicShare <= 1.0)) {
    throw Error(ErrorCode::InvalidArgument, "a parameter is out of its range", kPlace,
                "step and conduction must be positive, the geodesic share between 0 and 1");
  }
}

/// One connected piece of the wall: its triangles and its ends.
struct Piece {
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> lower;
  std::vector<const BaseLoop*> upper;
};

std::vector<Piece> piecesOf(const geometry::PartSurface& wall, const PartBase& base) {
  std::vector<Piece> pieces(base.kind.size());
  std::vector<double> longest(pieces.size(), 0.0);
  for (const auto* loops : {&base.lower, &base.upper}) {
    for (const BaseLoop& loop : *loops) {
      longest[loop.component] = std::max(longest[loop.component], loop.length);
    }
  }
  for (std::uint32_t t = 0; t < wall.mesh.triangles.size(); ++t) {
    pieces[base.component[wall.mesh.triangles[t][0]]].triangles.push_back(t);
  }
  for (const BaseLoop& loop : base.lower) {
    auto& lower = pieces[loop.component].lower;
    lower.insert(lower.end(), loop.vertices.begin(), loop.vertices.end());
  }
  for (const std::uint32_t v : base.source.vertices) {
    pieces[base.component[v]].lower.push_back(v);
  }
  for (const BaseLoop& loop : base.upper) {
    if (loop.length >= kHole * longest[loop.component]) {
      pieces[loop.component].upper.push_back(&loop);
    }
  }
  return pieces;
}

/// Area and ∫|∇φ|dA of some triangles.
struct Slope {
  double area = 0.0;
  double integral = 0.0;
  double highest = 0.0;  ///< greatest value
};

Slope slopeOf(const geometry::TriangleMesh& mesh,
              const std::vector<std::uint32_t>& triangles,
              const std::vector<double>& field,
              const std::vector<Vec3>& gradients) {
  Slope slope;
  for (const std::uint32_t t : triangles) {
    const auto& [a, b, c] = mesh.triangles[t];
    const double area =
        0.5 *
        (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
    if (gradients[t].allFinite()) {
      slope.area += area;
      slope.integral += area * gradients[t].norm();
      slope.highest = std::max({slope.highest, field[a], field[b], field[c]});
    }
  }
  return slope;
}

/// The field of all pieces on the way to its final scale.
class FieldMaker {
public:
  FieldMaker(const geometry::PartSurface& wall,
             const Substrate& substrate,
             const IsoValueOptions& options,
             const JobContext& context)
      : wall_(wall),
        substrate_(substrate),
        options_(options),
        context_(context),
        base_(findBase(wall, substrate, context)),
        pieces_(piecesOf(wall, base_)),
        distance_(distanceFromBase(wall, base_, context)) {}

  IsoField run() {
    std::vector<std::vector<double>> ends(pieces_.size());
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      ends[i] = endValues(pieces_[i]);
    }
    IsoField result;
    result.values = solve(ends);
    std::vector<double> layers = layersOf(result.values);
    bool moved = false;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      // Ends that differ are moved to the next layer, so that each border is a bead.
      const double places = layers[i] - 1.0 + options_.firstLayer;
      for (double& value : ends[i]) {
        const double rounded = (std::max(std::round(value * places - options_.firstLayer), 0.0) +
                                options_.firstLayer) /
                               places;
        moved = moved || (value != 1.0 && rounded != value);
        value = value == 1.0 ? 1.0 : rounded;
      }
    }
    if (moved) {
      result.values = solve(ends);
    }
    scale(layers, result);
    return result;
  }

private:
  /// Relative values of the upper borders of a piece, the greatest 1.
  [[nodiscard]] std::vector<double> endValues(const Piece& piece) const {
    std::vector<double> values;
    for (const BaseLoop* loop : piece.upper) {
      double mean = 0.0;
      for (const std::uint32_t v : loop->vertices) {
        mean += distance_[v] / static_cast<double>(loop->vertices.size());
      }
      values.push_back(options_.bordersByDistance ? mean : 1.0);
    }
    const double most = values.empty() ? 1.0 : *std::max_element(values.begin(), values.end());
    for (double& value : values) {
      value /= most;
    }
    return values;
  }

  [[nodiscard]] std::vector<double> solve(const std::vector<std::vector<double>>& ends) const {
    std::vector<geometry::FixedValues> fixed;
    geometry::FixedValues low;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (pieces_[i].upper.empty()) {
        continue;
      }
      low.vertices.insert(low.vertices.end(), pieces_[i].lower.begin(), pieces_[i].lower.end());
      for (std::size_t k = 0; k < ends[i].size(); ++k) {
        fixed.push_back({pieces_[i].upper[k]->vertices, ends[i][k]});
      }
    }
    std::vector<double> field(wall_.mesh.vertices.size(), kNaN);
    if (!fixed.empty()) {
      fixed.push_back(low);
      field = geometry::harmonicField(wall_.mesh, wall_.halfEdges, fixed, conductivity(), context_);
      if (options_.geodesicShare > 0.0) {
        blend(ends, field);
      }
    }
    for (const Piece& piece : pieces_) {
      if (piece.upper.empty()) {
        for (const std::uint32_t t : piece.triangles) {
          for (const std::uint32_t v : wall_.mesh.triangles[t]) {
            field[v] = std::isfinite(distance_[v]) ? distance_[v] : kNaN;
          }
        }
      }
    }
    return field;
  }

  [[nodiscard]] std::vector<geometry::Conductivity> conductivity() const {
    if (options_.conductivityUp == 1.0) {
      return {};
    }
    return std::vector<geometry::Conductivity>(wall_.mesh.triangles.size(),
                                               {1.0, substrate_.up(), options_.conductivityUp});
  }

  /// Mixes in the share of the way from the lower border to the nearest upper one: with distances a
  /// from below and bᵢ from border i of value vᵢ, the mean of vᵢ·a/(a + bᵢ) weighted by 1/bᵢ.
  void blend(const std::vector<std::vector<double>>& ends, std::vector<double>& field) const {
    const geometry::GeodesicSolver solver(wall_.mesh, wall_.halfEdges);
    std::vector<double> sum(field.size(), 0.0);
    std::vector<double> weight(field.size(), 0.0);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      for (std::size_t k = 0; k < pieces_[i].upper.size(); ++k) {
        geometry::GeodesicSource source;
        source.borderEdges = pieces_[i].upper[k]->halfEdges;
        const std::vector<double> b =
            solver.distance(source, std::numeric_limits<double>::infinity(), context_);
        for (std::size_t v = 0; v < field.size(); ++v) {
          if (!std::isfinite(b[v]) || !std::isfinite(distance_[v])) {
            continue;
          }
          const double a = std::max(distance_[v], 0.0);
          const double near = std::max(b[v], std::numeric_limits<double>::min());
          sum[v] += ends[i][k] * a / (a + near) / near;
          weight[v] += 1.0 / near;
        }
      }
    }
    for (std::size_t v = 0; v < field.size(); ++v) {
      if (weight[v] > 0.0 && std::isfinite(sum[v] / weight[v])) {
        field[v] =
            (1.0 - options_.geodesicShare) * field[v] + options_.geodesicShare * sum[v] / weight[v];
      }
    }
  }

  /// Number of layers of each piece whose mean height is nearest to the step.
  [[nodiscard]] std::vector<double> layersOf(const std::vector<double>& field) const {
    const std::vector<Vec3> gradients = geometry::triangleGradients(wall_.mesh, field);
    std::vector<double> layers;
    for (const Piece& piece : pieces_) {
      const Slope slope = slopeOf(wall_.mesh, piece.triangles, field, gradients);
      if (slope.area == 0.0) {
        layers.push_back(0.0);
        continue;
      }
      if (!(slope.integral > 0.0)) {
        throw Error(ErrorCode::JobFailed, "the field has no gradient on a piece of the part",
                    kPlace, "the borders of the wall must lie apart: check the working surface");
      }
      const double height = slope.highest * slope.area / slope.integral;
      const double wanted = height / options_.step - options_.firstLayer + 1.0;
      if (wanted < 0.5) {
        throw Error(ErrorCode::JobFailed,
                    text("the wall is only %1 mm high, less than the %2 mm of a layer",
                         {formatFixed(height, 2), formatFixed(options_.step, 2)}),
                    kPlace, "choose a smaller step");
      }
      layers.push_back(std::max(1.0, std::round(wanted)));
    }
    return layers;
  }

  void scale(const std::vector<double>& layers, IsoField& result) const {
    std::vector<double> factor(pieces_.size(), kNaN);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      double highest = 0.0;
      for (const std::uint32_t t : pieces_[i].triangles) {
        for (const std::uint32_t v : wall_.mesh.triangles[t]) {
          highest = std::isnan(result.values[v]) ? highest : std::max(highest, result.values[v]);
        }
      }
      factor[i] =
          highest > 0.0 ? (layers[i] - 1.0 + options_.firstLayer) * options_.step / highest : kNaN;
      result.layers = std::max(result.layers, static_cast<std::size_t>(layers[i]));
    }
    for (std::size_t v = 0; v < result.values.size(); ++v) {
      const std::size_t component = base_.component[v];
      result.values[v] *= component < factor.size() ? factor[component] : kNaN;
    }
  }

  const geometry::PartSurface& wall_;
  const Substrate& substrate_;
  const IsoValueOptions& options_;
  const JobContext& context_;
  PartBase base_;
  std::vector<Piece> pieces_;
  std::vector<double> distance_;
};

}  // namespace

geometry::PartSurface openWall(const geometry::PartSurface& part, const Substrate& substrate) {
  geometry::CutSurface cut{part, heightsOf(part.mesh, substrate)};
  const double lowest =
      cut.field.empty() ? 0.0 : *std::min_element(cut.field.begin(), cut.field.end());
  if (lowest < -kSubstrateContact) {
    cut = geometry::cutAtLevels(part, cut.field, {0.0});
  }
  std::vector<bool> keep(cut.surface.mesh.triangles.size());
  bool all = true;
  bool any = false;
  for (std::size_t t = 0; t < keep.size(); ++t) {
    double highest = -std::numeric_limits<double>::infinity();
    for (const std::uint32_t v : cut.surface.mesh.triangles[t]) {
      highest = std::max(highest, cut.field[v]);
    }
    // All corners on the substrate: a piece of the bottom.
    keep[t] = highest > (lowest < -kSubstrateContact ? 0.0 : kSubstrateContact);
    all = all && keep[t];
    any = any || keep[t];
  }
  if (!any) {
    throw Error(ErrorCode::CheckFailed, "the whole part lies in or below the substrate", kPlace,
                "move the part or the substrate");
  }
  return all ? cut.surface : geometry::keepTriangles(cut.surface, keep).surface;
}

IsoField isoValueField(const geometry::PartSurface& wall,
                       const Substrate& substrate,
                       const IsoValueOptions& options,
                       const JobContext& context) {
  check(options);
  return FieldMaker(wall, substrate, options, context).run();
}

IsoField isoValuesBetween(const geometry::PartSurface& piece,
                          const std::vector<std::uint32_t>& lower,
                          const std::vector<std::uint32_t>& upper,
                          double step,
                          const JobContext& context) {
  IsoField result;
  result.values = geometry::harmonicField(piece.mesh, piece.halfEdges, {{lower, 0.0}, {upper, 1.0}},
                                          {}, context);
  std::vector<std::uint32_t> all(piece.mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0U);
  const Slope slope = slopeOf(piece.mesh, all, result.values,
                              geometry::triangleGradients(piece.mesh, result.values));
  if (slope.integral > 0.0) {
    result.layers = static_cast<std::size_t>(std::round(slope.area / slope.integral / step));
  }
  for (double& value : result.values) {
    value *= static_cast<double>(result.layers) * step;
  }
  return result;
}

std::vector<LayerLevel> isoLevels(
    const std::vector<std::shared_ptr<const geometry::PartSurface>>& parts,
    const VertexField& field,
    double step,
    double firstLayer,
    std::size_t layers,
    const Vec3& up) {
  std::vector<Vec3> sums(layers, Vec3::Zero());
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const geometry::TriangleMesh& mesh = parts[k]->mesh;
    const std::vector<double>& values = field.values[k];
    const std::vector<Vec3> gradients = geometry::triangleGradients(mesh, values);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      const double slope = gradients[t].norm();
      if (!(slope > 0.0)) {
        continue;
      }
      const double area =
          (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
      const auto [low, high] = std::minmax({values[a], values[b], values[c]});
      const double first = std::max(0.0, std::ceil(low / step - firstLayer));
      for (auto l = static_cast<std::size_t>(first);
           l < layers && (static_cast<double>(l) + firstLayer) * step <= high; ++l) {
        // The curve's length in a triangle is about its area over its extent along the gradient.
        sums[l] += area / (high - low) * gradients[t];
      }
    }
  }
  std::vector<LayerLevel> levels;
  for (std::size_t l = 0; l < layers; ++l) {
    // Directions that cancel (a flat spiral of a wall) leave the substrate's.
    constexpr double kCancelled = 1e-6;
    const Vec3 direction = sums[l].norm() > kCancelled ? Vec3(sums[l].normalized()) : up;
    levels.push_back({(static_cast<double>(l) + firstLayer) * step, direction, step});
  }
  return levels;
}

}  // namespace wcam::toolpath
