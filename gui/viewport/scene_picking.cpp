// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scene_impl.hpp"

#include <vtkGenericCell.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

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

/// Something within reach of the pixel. The nearest to the eye goes first; one pixel off counts
/// like a small step in depth, so that among equally near ones (a bead's own points) the one that
/// is aimed at wins.
struct Candidate {
  double score = 0.0;
  Pick pick;
  double room = 0.0;  ///< mm around it that hide nothing: its own bead and the one on top of it

  Candidate(double pixels, double depth, Pick found, double own)
      : score(depth + 2e-3 * pixels), pick(found), room(own) {}
};

double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Point between(const Point& from, const Point& to) {
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

double length(const Point& a) {
  return std::sqrt(dot(a, a));
}

/// Square of the least distance between two segments, from p along u and from q along v.
double distance2(const Point& p, const Point& u, const Point& q, const Point& v) {
  const Point w = between(q, p);
  const double a = dot(u, u);
  const double b = dot(u, v);
  const double c = dot(v, v);
  const double d = dot(u, w);
  const double e = dot(v, w);
  const double denominator = a * c - b * b;
  double s =
      denominator > 1e-12 * a * c ? std::clamp((b * e - c * d) / denominator, 0.0, 1.0) : 0.0;
  const double t = c > 0.0 ? std::clamp((b * s + e) / c, 0.0, 1.0) : 0.0;
  s = a > 0.0 ? std::clamp((b * t - d) / a, 0.0, 1.0) : 0.0;
  Point gap{};
  for (std::size_t i = 0; i < 3; ++i) {
    gap[i] = w[i] + s * u[i] - t * v[i];
  }
  return dot(gap, gap);
}

/// A bead hides what lies behind its core: half of the lesser side of its section.
constexpr double kCore = 0.5;
/// Its own section and that of the beads around it do not hide a point inside the wall that they
/// make: the wall is seen, and the point stands for it.
constexpr double kOwnRoom = 1.5;
/// Candidates that are looked at: a pixel has hardly more beads behind each other.
constexpr std::size_t kMostCandidates = 24;
constexpr double kFar = 1e6;  // mm: beyond every cell

}  // namespace

/// What the eye sees of the scene, in the part frame.
class Scene::Sight {
public:
  Sight(const Impl& scene, const Ray& ray) : scene_(scene), pose_(valuesOf(scene.partPose)) {
    vtkNew<vtkMatrix4x4> inverse;
    vtkMatrix4x4::Invert(scene.partPose, inverse);
    back_ = valuesOf(inverse);
    eye_ = map(ray.eye, 1.0);
    along_ = map(ray.direction, 0.0);
  }

  [[nodiscard]] const Matrix& pose() const { return pose_; }

  [[nodiscard]] const Point& eye() const { return eye_; }

  [[nodiscard]] const Point& along() const { return along_; }

  /// The section takes a point away. @param world in the world, where sections are
  [[nodiscard]] bool isCut(const Point& world) const {
    if (!scene_.section) {
      return false;
    }
    const double* origin = scene_.plane->GetOrigin();
    const double* normal = scene_.plane->GetNormal();
    double side = 0.0;
    for (int i = 0; i < 3; ++i) {
      side += (world[static_cast<std::size_t>(i)] - origin[i]) * normal[i];
    }
    return side < 0.0;
  }

  /// The first triangle on a segment that no section takes away. @return its place on the segment,
  /// or more than 1
  double firstHit(const PreparedMesh& mesh,
                  const Point& from,
                  const Point& to,
                  bool sections,
                  vtkIdType& cell,
                  Point& at) const {
    // A section lies between few surfaces; what is cut is passed.
    constexpr int kMostPassed = 64;
    double begin = 0.0;
    for (int passed = 0; passed < kMostPassed; ++passed) {
      double start[3];
      double end[3];
      for (std::size_t i = 0; i < 3; ++i) {
        start[i] = from[i] + begin * (to[i] - from[i]);
        end[i] = to[i];
      }
      double t = 0.0;
      double x[3];
      double local[3];
      int sub = 0;
      vtkNew<vtkGenericCell> generic;
      if (mesh.locator->IntersectWithLine(start, end, 1e-6, t, x, local, sub, cell, generic) == 0) {
        break;
      }
      at = {x[0], x[1], x[2]};
      const float local3[3] = {static_cast<float>(x[0]), static_cast<float>(x[1]),
                               static_cast<float>(x[2])};
      const double place = begin + t * (1.0 - begin);
      if (!sections || !isCut(placed(pose_, local3))) {
        return place;
      }
      const double step = 1e-3 / std::max(length(between(from, to)), 1e-3);  // a micrometre on
      begin = place + step;
      if (begin >= 1.0) {
        break;
      }
    }
    return 2.0;
  }

  /// The substrate stands before a place on a segment from the eye.
  [[nodiscard]] bool plateBefore(const Point& to, double share) const {
    vtkIdType cell = -1;
    Point at{};
    return scene_.substrateMesh && scene_.substrateVisible &&
           firstHit(*scene_.substrateMesh, eye_, to, false, cell, at) < share;
  }

  /// Nothing opaque stands between the eye and a candidate.
  [[nodiscard]] bool sees(const Candidate& candidate) const {
    const Point target = map(candidate.pick.position, 1.0);
    const Point way = between(eye_, target);
    const double far = length(way);
    if (far <= candidate.room) {
      return true;
    }
    const double share = 1.0 - candidate.room / far;
    Point end{};
    for (std::size_t i = 0; i < 3; ++i) {
      end[i] = eye_[i] + share * way[i];
    }
    vtkIdType cell = -1;
    Point at{};
    if (scene_.partStyle == PartStyle::Solid) {
      for (const PartItem& part : scene_.parts) {
        if (firstHit(*part.prepared, eye_, end, true, cell, at) <= 1.0) {
          return false;
        }
      }
    }
    return !plateBefore(end, 1.0) && !hiddenByBeads(end);
  }

private:
  [[nodiscard]] Point map(const Point& p, double w) const {
    Point out{};
    for (std::size_t i = 0; i < 3; ++i) {
      out[i] = back_[4 * i] * p[0] + back_[4 * i + 1] * p[1] + back_[4 * i + 2] * p[2] +
               back_[4 * i + 3] * w;
    }
    return out;
  }

  [[nodiscard]] bool hiddenByBeads(const Point& end) const {
    if (!scene_.path || scene_.asLines()) {
      return false;  // lines hide nothing
    }
    const PathData& path = *scene_.path->data;
    const Point way = between(eye_, end);
    for (std::size_t i = std::max<std::size_t>(scene_.begin, 1);
         i < std::min(scene_.end, path.size()); ++i) {
      if (path.deposits[i] == 0) {
        continue;
      }
      const float* a = &path.positions[3 * (i - 1)];
      const float* b = &path.positions[3 * i];
      const double core = kCore * std::min(path.heights[i], path.widths[i]);
      // The section hangs below the point.
      const double down = 0.5 * static_cast<double>(path.heights[i]);
      Point from{};
      Point along{};
      for (std::size_t k = 0; k < 3; ++k) {
        from[k] = a[k] - down * path.build[3 * i + k];
        along[k] = static_cast<double>(b[k]) - a[k];
      }
      if (distance2(eye_, way, from, along) < core * core &&
          !(scene_.section && isCut(placed(pose_, b)))) {
        return true;
      }
    }
    return false;
  }

  const Impl& scene_;
  Matrix pose_;
  Matrix back_;
  Point eye_{};
  Point along_{};
};

namespace {

/// The first candidate that is seen.
template <class Sight>
Pick firstSeen(std::vector<Candidate> candidates, const Sight& sight) {
  const std::size_t count = std::min(candidates.size(), kMostCandidates);
  std::partial_sort(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(count),
                    candidates.end(),
                    [](const Candidate& a, const Candidate& b) { return a.score < b.score; });
  for (std::size_t i = 0; i < count; ++i) {
    if (sight.sees(candidates[i])) {
      return candidates[i].pick;
    }
  }
  return {};
}

}  // namespace

Pick Scene::pickMove(const Ray& ray) const {
  if (!impl_->path) {
    return {};
  }
  const PathData& path = *impl_->path->data;
  const Sight sight(*impl_, ray);
  const Projector project(ray, sight.pose());
  std::vector<Candidate> candidates;
  for (std::size_t i = impl_->begin; i < std::min(impl_->end, path.size()); ++i) {
    // First points of beads are picked as well: the move after them deposits.
    if (path.deposits[i] == 0 && (i + 1 >= path.size() || path.deposits[i + 1] == 0)) {
      continue;
    }
    double x = 0.0;
    double y = 0.0;
    double depth = 0.0;
    if (!project(&path.positions[3 * i], x, y, depth)) {
      continue;
    }
    const double off = std::hypot(x - ray.x, y - ray.y);
    const Point at = placed(sight.pose(), &path.positions[3 * i]);
    if (off <= ray.reach && !sight.isCut(at)) {
      const double room = kOwnRoom * std::max(path.heights[i], path.widths[i]);
      candidates.emplace_back(off, depth, Pick{Pick::Kind::Move, -1, static_cast<int>(i), at},
                              room);
    }
  }
  return firstSeen(std::move(candidates), sight);
}

Pick Scene::pickEdge(const Ray& ray) const {
  if (impl_->partStyle == PartStyle::Hidden) {
    return {};
  }
  // An edge lies on the surface that it borders: so much of it hides nothing, mm.
  constexpr double kOnSurface = 0.5;
  const Sight sight(*impl_, ray);
  const Projector project(ray, sight.pose());
  std::vector<Candidate> candidates;
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
        if (off > 0.6 * ray.reach) {
          continue;
        }
        float p[3];
        for (std::size_t k = 0; k < 3; ++k) {
          p[k] = static_cast<float>((1.0 - t) * mesh.edgePositions[3 * i + k] +
                                    t * mesh.edgePositions[3 * (i + 1) + k]);
        }
        const Point at = placed(sight.pose(), p);
        if (!sight.isCut(at)) {
          const int edge = mesh.edgeIds.empty() ? static_cast<int>(e) : mesh.edgeIds[e];
          candidates.emplace_back(off, a[2] + t * (b[2] - a[2]),
                                  Pick{Pick::Kind::Edge, static_cast<int>(part), edge, at},
                                  kOnSurface);
        }
      }
    }
  }
  return firstSeen(std::move(candidates), sight);
}

Pick Scene::pickFace(const Ray& ray) const {
  Pick pick;
  if (impl_->partStyle != PartStyle::Solid && impl_->partStyle != PartStyle::Translucent) {
    return pick;
  }
  const Sight sight(*impl_, ray);
  const Point from = sight.eye();
  Point to{};
  for (std::size_t i = 0; i < 3; ++i) {
    to[i] = from[i] + kFar * sight.along()[i];
  }
  double best = 1.0;
  for (std::size_t i = 0; i < impl_->parts.size(); ++i) {
    const PartItem& part = impl_->parts[i];
    vtkIdType cell = -1;
    Point at{};
    const double t = sight.firstHit(*part.prepared, from, to, true, cell, at);
    if (t < best) {
      best = t;
      pick.kind = Pick::Kind::Face;
      pick.part = static_cast<int>(i);
      pick.index = part.prepared->mesh.faces.empty()
                       ? -1
                       : part.prepared->mesh.faces[static_cast<std::size_t>(cell)];
      const float hit[3] = {static_cast<float>(at[0]), static_cast<float>(at[1]),
                            static_cast<float>(at[2])};
      pick.position = placed(sight.pose(), hit);
    }
  }
  // A part stands on its plate: where both are met at once the part is meant.
  constexpr double kOnPlate = 0.5 / kFar;
  return sight.plateBefore(to, best - kOnPlate) ? Pick{} : pick;
}

}  // namespace wcam::viewport
