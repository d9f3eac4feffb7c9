// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/field_heights.hpp"

#include "wcam/base/parallel.hpp"
#include "wcam/base/text.hpp"
#include "wcam/geometry/aabb_tree.hpp"
#include "wcam/geometry/surface_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::toolpath {

namespace {

/// Heights that miss the range by less than this part of it are on it: the field is linear on each
/// triangle and knows its gradient no better.
constexpr double kHeightSlack = 0.01;

/// |∇φ| at the vertices: the mean over the triangles about each, by area; NaN without any.
std::vector<double> vertexSlopes(const geometry::TriangleMesh& mesh,
                                 const std::vector<double>& field) {
  const std::vector<Vec3> gradients = geometry::triangleGradients(mesh, field);
  std::vector<double> slope(mesh.vertices.size(), 0.0);
  std::vector<double> weight(mesh.vertices.size(), 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const double area =
        (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
    if (!gradients[t].allFinite() || !(area > 0.0)) {
      continue;
    }
    for (const std::uint32_t v : mesh.triangles[t]) {
      slope[v] += area * gradients[t].norm();
      weight[v] += area;
    }
  }
  for (std::size_t v = 0; v < slope.size(); ++v) {
    slope[v] /= weight[v];
  }
  return slope;
}

/// Barycentric weights of a point in the plane of a triangle, clamped to the triangle.
geometry::MeshPoint locate(const geometry::TriangleMesh& mesh,
                           std::uint32_t triangle,
                           const Vec3& p) {
  const auto& t = mesh.triangles[triangle];
  const Vec3& a = mesh.vertices[t[0]];
  const Vec3 ab = mesh.vertices[t[1]] - a;
  const Vec3 ac = mesh.vertices[t[2]] - a;
  const Vec3 n = ab.cross(ac);
  geometry::MeshPoint point{triangle, {1.0, 0.0, 0.0}};
  if (n.squaredNorm() > 0.0) {
    const double v = std::clamp((p - a).cross(ac).dot(n) / n.squaredNorm(), 0.0, 1.0);
    const double w = std::clamp(ab.cross(p - a).dot(n) / n.squaredNorm(), 0.0, 1.0 - v);
    point.weights = {1.0 - v - w, v, w};
  }
  return point;
}

}  // namespace

void setFieldHeights(SlicedLayers& sliced,
                     const std::vector<std::shared_ptr<const geometry::PartSurface>>& parts,
                     const VertexField& field,
                     double step) {
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const geometry::TriangleMesh& mesh = parts[k]->mesh;
    const std::vector<double> slopes = vertexSlopes(mesh, field.values[k]);
    const geometry::AabbTree tree(mesh);
    std::vector<ContourPoint*> points;
    for (SlicedLayer& layer : sliced.layers) {
      for (Contour& contour : layer.contours) {
        if (contour.part == static_cast<int>(k)) {
          for (ContourPoint& point : contour.points) {
            points.push_back(&point);
          }
        }
      }
    }
    constexpr std::size_t kGrain = 256;
    parallelFor(points.size(), kGrain, [&](std::size_t i) {
      const auto hit = tree.closestPoint(points[i]->p);
      if (hit) {
        const double slope =
            geometry::valueAt(mesh, slopes, locate(mesh, hit->triangle, points[i]->p));
        points[i]->height = slope > 0.0 ? step / slope : points[i]->height;
      }
    });
  }
}

void reportHeights(const SlicedLayers& sliced,
                   const BeadRange& bead,
                   double step,
                   const Text& otherwise,
                   const JobContext& context) {
  double least = std::numeric_limits<double>::infinity();
  double greatest = 0.0;
  double worst = 0.0;
  Place place;
  Vec3 where = Vec3::Zero();
  std::size_t outside = 0;
  std::size_t all = 0;
  const double slack = kHeightSlack * bead.heightMax;
  for (std::size_t l = 0; l < sliced.layers.size(); ++l) {
    for (std::size_t c = 0; c < sliced.layers[l].contours.size(); ++c) {
      const Contour& contour = sliced.layers[l].contours[c];
      for (std::size_t i = 0; i < contour.points.size(); ++i) {
        const double height = contour.points[i].height;
        if (!(height > 0.0)) {
          continue;
        }
        ++all;
        least = std::min(least, height);
        greatest = std::max(greatest, height);
        const double excess = std::max(bead.heightMin - height, height - bead.heightMax);
        outside += excess > slack ? 1U : 0U;
        if (excess > worst) {
          worst = excess;
          where = contour.points[i].p;
          place = {{}, static_cast<int>(l), static_cast<int>(c), static_cast<int>(i)};
        }
      }
    }
  }
  if (outside == 0) {
    return;
  }
  // Heights grow with the step, so that any step in between brings all of them into the range.
  const double from = step * bead.heightMin / least;
  const double to = step * bead.heightMax / greatest;
  const Text remedy =
      from <= to
          ? text("a step between %1 and %2 mm would do", {formatFixed(from, 2), formatFixed(to, 2)})
          : text(
                "the part needs a process whose greatest height is %1 times the least one; "
                "%2",
                {formatFixed(greatest / least, 2), otherwise});
  context.add(
      {Severity::Warning,
       "slicing.height_out_of_range",
       text("%1 % of the points need a height outside of %2 to %3 mm, by up to %4 mm at (%5, %6, "
            "%7)",
            {formatFixed(100.0 * static_cast<double>(outside) / static_cast<double>(all), 1),
             formatFixed(bead.heightMin, 2), formatFixed(bead.heightMax, 2), formatFixed(worst, 2),
             formatFixed(where.x(), 1), formatFixed(where.y(), 1), formatFixed(where.z(), 1)}),
       remedy,
       place,
       {{"points", static_cast<double>(outside)},
        {"least_mm", least},
        {"greatest_mm", greatest},
        {"excess_mm", worst}}});
}

void reportDownward(const SlicedLayers& sliced, const Vec3& up, const JobContext& context) {
  // A layer that leans by less than 6° below the horizon is as good as a level one.
  constexpr double kHorizon = -0.1;
  std::size_t count = 0;
  std::size_t first = 0;
  for (std::size_t l = 0; l < sliced.layers.size(); ++l) {
    if (sliced.layers[l].up.dot(up) < kHorizon) {
      first = count == 0 ? l : first;
      ++count;
    }
  }
  if (count > 0) {
    const Vec3& p = sliced.layers[first].contours.front().points.front().p;
    context.add({Severity::Warning,
                 "slicing.grows_down",
                 text("%1 layers grow downwards, the first at (%2, %3, %4)",
                      {std::to_string(count), formatFixed(p.x(), 1), formatFixed(p.y(), 1),
                       formatFixed(p.z(), 1)}),
                 "turn the part with a positioner, or let planes across the build direction cut it",
                 {{}, static_cast<int>(first), -1, -1},
                 {{"layers", static_cast<double>(count)}}});
  }
}

}  // namespace wcam::toolpath
