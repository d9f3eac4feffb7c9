// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scene_impl.hpp"

#include <vtkGenericCell.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::viewport {

namespace {

/// Pixel and depth of a point, or nothing when it lies behind the eye.
struct Projector {
  explicit Projector(const Scene::Ray& r, const Matrix& partPose) : ray(r) {
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        double sum = 0.0;
        for (int k = 0; k < 4; ++k) {
          sum += r.worldToClip[4 * i + k] * partPose[4 * k + j];
        }
        m[4 * i + j] = sum;
      }
    }
  }

  bool operator()(const float* p, double& x, double& y, double& depth) const {
    const auto row = [&](int i) {
      return m[4 * i] * p[0] + m[4 * i + 1] * p[1] + m[4 * i + 2] * p[2] + m[4 * i + 3];
    };
    const double w = row(3);
    if (w <= 0.0) {
      return false;
    }
    x = (row(0) / w + 1.0) * 0.5 * ray.width;
    y = (row(1) / w + 1.0) * 0.5 * ray.height;
    depth = row(2) / w;
    return depth >= -1.0 && depth <= 1.0;
  }

  const Scene::Ray& ray;
  Matrix m{};
};

Matrix valuesOf(const vtkMatrix4x4* matrix) {
  Matrix values{};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      values[4 * i + j] = matrix->GetElement(i, j);
    }
  }
  return values;
}

Point placed(const Matrix& m, const float* p) {
  Point out{};
  for (int i = 0; i < 3; ++i) {
    out[i] = m[4 * i] * p[0] + m[4 * i + 1] * p[1] + m[4 * i + 2] * p[2] + m[4 * i + 3];
  }
  return out;
}

/// The nearest to the eye of what lies within reach of the pixel; among equally near ones (a bead's
/// own points) the one that is nearest to the pixel.
struct Nearest {
  double best = std::numeric_limits<double>::infinity();

  bool take(double pixels, double depth, double reach) {
    // One pixel off counts like a small step in depth, so that the point aimed at wins.
    const double score = depth + 2e-3 * pixels;
    if (pixels > reach || score >= best) {
      return false;
    }
    best = score;
    return true;
  }
};

}  // namespace

Pick Scene::pickMove(const Ray& ray) const {
  Pick pick;
  if (!impl_->path) {
    return pick;
  }
  const PathData& path = *impl_->path->data;
  const Matrix pose = valuesOf(impl_->partPose);
  const Projector project(ray, pose);
  Nearest nearest;
  for (std::size_t i = impl_->begin; i < std::min(impl_->end, path.size()); ++i) {
    // First points of beads are picked as well: the move after them deposits.
    if (path.deposits[i] == 0 && (i + 1 >= path.size() || path.deposits[i + 1] == 0)) {
      continue;
    }
    double x = 0.0;
    double y = 0.0;
    double depth = 0.0;
    if (project(&path.positions[3 * i], x, y, depth) &&
        nearest.take(std::hypot(x - ray.x, y - ray.y), depth, ray.reach)) {
      pick.kind = Pick::Kind::Move;
      pick.index = static_cast<int>(i);
    }
  }
  if (pick.kind == Pick::Kind::Move) {
    pick.position = placed(pose, &path.positions[3 * static_cast<std::size_t>(pick.index)]);
  }
  return pick;
}

Pick Scene::pickEdge(const Ray& ray) const {
  Pick pick;
  if (impl_->partStyle == PartStyle::Hidden) {
    return pick;
  }
  const Matrix pose = valuesOf(impl_->partPose);
  const Projector project(ray, pose);
  Nearest nearest;
  for (std::size_t part = 0; part < impl_->parts.size(); ++part) {
    const MeshData& mesh = impl_->parts[static_cast<std::size_t>(part)].prepared->mesh;
    for (std::size_t e = 0; e + 1 < mesh.edgeBegin.size(); ++e) {
      for (std::size_t i = mesh.edgeBegin[e]; i + 1 < mesh.edgeBegin[e + 1]; ++i) {
        std::array<double, 3> a{};
        std::array<double, 3> b{};
        if (!project(&mesh.edgePositions[3 * i], a[0], a[1], a[2]) ||
            !project(&mesh.edgePositions[3 * (i + 1)], b[0], b[1], b[2])) {
          continue;
        }
        const double dx = b[0] - a[0];
        const double dy = b[1] - a[1];
        const double length2 = dx * dx + dy * dy;
        const double t =
            length2 > 0.0
                ? std::clamp(((ray.x - a[0]) * dx + (ray.y - a[1]) * dy) / length2, 0.0, 1.0)
                : 0.0;
        const double off = std::hypot(a[0] + t * dx - ray.x, a[1] + t * dy - ray.y);
        if (nearest.take(off, a[2] + t * (b[2] - a[2]), 0.6 * ray.reach)) {
          pick.kind = Pick::Kind::Edge;
          pick.part = static_cast<int>(part);
          pick.index = mesh.edgeIds.empty() ? static_cast<int>(e) : mesh.edgeIds[e];
          const float* p = &mesh.edgePositions[3 * (t < 0.5 ? i : i + 1)];
          pick.position = placed(pose, p);
        }
      }
    }
  }
  return pick;
}

Pick Scene::pickFace(const Ray& ray) const {
  Pick pick;
  if (impl_->partStyle != PartStyle::Solid && impl_->partStyle != PartStyle::Translucent) {
    return pick;
  }
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(impl_->partPose, inverse);
  const Matrix back = valuesOf(inverse);
  const auto map = [&back](const Point& p, double w) {
    Point out{};
    for (int i = 0; i < 3; ++i) {
      out[i] = back[4 * i] * p[0] + back[4 * i + 1] * p[1] + back[4 * i + 2] * p[2] +
               back[4 * i + 3] * w;
    }
    return out;
  };
  const Point from = map(ray.eye, 1.0);
  const Point along = map(ray.direction, 0.0);
  constexpr double kFar = 1e6;  // mm: beyond every cell
  double to[3] = {from[0] + kFar * along[0], from[1] + kFar * along[1], from[2] + kFar * along[2]};
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < impl_->parts.size(); ++i) {
    const PartItem& part = impl_->parts[i];
    double t = 0.0;
    double x[3];
    double local[3];
    int sub = 0;
    vtkIdType cell = -1;
    vtkNew<vtkGenericCell> generic;
    double start[3] = {from[0], from[1], from[2]};
    if (part.prepared->locator->IntersectWithLine(start, to, 1e-6, t, x, local, sub, cell,
                                                  generic) != 0 &&
        t < best) {
      best = t;
      pick.kind = Pick::Kind::Face;
      pick.part = static_cast<int>(i);
      pick.index = part.prepared->mesh.faces.empty()
                       ? -1
                       : part.prepared->mesh.faces[static_cast<std::size_t>(cell)];
      const float hit[3] = {static_cast<float>(x[0]), static_cast<float>(x[1]),
                            static_cast<float>(x[2])};
      pick.position = placed(valuesOf(impl_->partPose), hit);
    }
  }
  return pick;
}

}  // namespace wcam::viewport
