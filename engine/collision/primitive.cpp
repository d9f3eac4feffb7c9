// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "primitive.hpp"

#include "wcam/base/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace wcam::collision::detail {

namespace {

/// Growth of the spheres of a round shape over its radius: finer covers cost more spheres and free
/// little more.
constexpr double kGrowth = 0.1;
/// Nothing is covered more finely than this, mm: below the bead's own spread.
constexpr double kLeastGrowth = 1.0;
const double kGolden = 0.5 * (std::sqrt(5.0) - 1.0);

/// Squared distance of two segments and where on the second (Ericson, clamped closed form).
double segmentDistance(const Vec3& p1, const Vec3& q1, const Vec3& p2, const Vec3& q2, Vec3* at2) {
  const Vec3 d1 = q1 - p1;
  const Vec3 d2 = q2 - p2;
  const Vec3 r = p1 - p2;
  const double a = d1.squaredNorm();
  const double e = d2.squaredNorm();
  const double f = d2.dot(r);
  double s = 0.0;
  double t = 0.0;
  if (a > 0.0 && e > 0.0) {
    const double b = d1.dot(d2);
    const double c = d1.dot(r);
    const double denominator = a * e - b * b;
    s = denominator > 0.0 ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
    t = (b * s + f) / e;
    if (t < 0.0 || t > 1.0) {
      t = std::clamp(t, 0.0, 1.0);
      s = std::clamp((b * t - c) / a, 0.0, 1.0);
    }
  } else if (e > 0.0) {
    t = std::clamp(f / e, 0.0, 1.0);
  } else if (a > 0.0) {
    s = std::clamp(-d1.dot(r) / a, 0.0, 1.0);
  }
  *at2 = p2 + t * d2;
  return (p1 + s * d1 - *at2).norm();
}

void addAlong(double from, double to, double radius, std::vector<CoverSphere>& cover) {
  // Spheres at equal spacing hold the cylinder between from and to.
  const double grown = radius + std::max(kGrowth * radius, kLeastGrowth);
  const double reach = std::sqrt(grown * grown - radius * radius);
  const int count = std::max(1, static_cast<int>(std::ceil((to - from) / (2.0 * reach))));
  const double half = 0.5 * (to - from) / count;
  for (int i = 0; i < count; ++i) {
    cover.push_back({Vec3(0, 0, from + (2 * i + 1) * half), std::hypot(radius, half)});
  }
}

std::vector<CoverSphere> coverCapsule(const Shape& shape) {
  std::vector<CoverSphere> cover;
  const double half = 0.5 * shape.length;
  addAlong(-half, half, shape.radius, cover);
  for (const double z : {-half, half}) {
    cover.push_back({Vec3(0, 0, z), shape.radius});
  }
  return cover;
}

std::vector<CoverSphere> coverBox(const Vec3& size);

std::vector<CoverSphere> coverCylinder(const Shape& shape) {
  std::vector<CoverSphere> cover;
  const double half = 0.5 * shape.length;
  if (half < 0.5 * shape.radius) {
    // A disc: what a box around it needs, less the cubes beside the disc.
    cover = coverBox(Vec3(2.0 * shape.radius, 2.0 * shape.radius, shape.length));
    std::erase_if(cover, [&](const CoverSphere& sphere) {
      return sphere.centre.head<2>().norm() > shape.radius + sphere.radius;
    });
    return cover;
  }
  // The end pieces as long as two radii: their spheres stand out at the flat ends by 0.41 radii,
  // sideways too.
  const double end = std::min(shape.radius, 0.5 * half);
  const double ball = std::hypot(shape.radius, end);
  cover.push_back({Vec3(0, 0, -half + end), ball});
  cover.push_back({Vec3(0, 0, half - end), ball});
  if (half - 2.0 * end > 0.0) {
    addAlong(-half + 2.0 * end, half - 2.0 * end, shape.radius, cover);
  }
  return cover;
}

std::vector<CoverSphere> coverBox(const Vec3& size) {
  // Cubes of equal edge, the smallest that keep the number.
  double edge = size.minCoeff();
  std::array<int, 3> count{};
  for (;; edge *= 1.1) {
    double total = 1.0;
    for (int k = 0; k < 3; ++k) {
      count[static_cast<std::size_t>(k)] = static_cast<int>(std::ceil(size(k) / edge));
      total *= std::ceil(size(k) / edge);
    }
    if (total <= kMaxCover) {
      break;
    }
  }
  const Vec3 step(size.x() / count[0], size.y() / count[1], size.z() / count[2]);
  std::vector<CoverSphere> cover;
  for (int i = 0; i < count[0]; ++i) {
    for (int j = 0; j < count[1]; ++j) {
      for (int k = 0; k < count[2]; ++k) {
        const Vec3 corner = Vec3(i, j, k).cwiseProduct(step) - 0.5 * size;
        cover.push_back({corner + 0.5 * step, 0.5 * step.norm()});
      }
    }
  }
  return cover;
}

/// Cells of a grid that the boxes of triangles meet.
std::vector<CoverSphere> coverMesh(const geometry::TriangleMesh& mesh) {
  const geometry::Box bounds = mesh.bounds();
  const double longest = (bounds.max - bounds.min).maxCoeff();
  for (int cells = 16;; --cells) {
    const double edge = std::max(longest / cells, kLeastGrowth);
    std::set<std::array<int, 3>> used;
    for (const auto& triangle : mesh.triangles) {
      geometry::Box box;
      for (const std::uint32_t v : triangle) {
        box.add(mesh.vertices[v]);
      }
      const Eigen::Vector3i low = ((box.min - bounds.min) / edge).array().floor().cast<int>();
      const Eigen::Vector3i high = ((box.max - bounds.min) / edge).array().floor().cast<int>();
      for (int i = low.x(); i <= high.x(); ++i) {
        for (int j = low.y(); j <= high.y(); ++j) {
          for (int k = low.z(); k <= high.z(); ++k) {
            used.insert({i, j, k});
          }
        }
      }
      if (cells > 1 && used.size() > kMaxCover) {
        break;
      }
    }
    if (cells > 1 && used.size() > kMaxCover) {
      continue;
    }
    std::vector<CoverSphere> cover;
    for (const auto& cell : used) {
      const Vec3 low = bounds.min + edge * Vec3(cell[0], cell[1], cell[2]);
      cover.push_back({low + Vec3::Constant(0.5 * edge), 0.5 * std::sqrt(3.0) * edge});
    }
    return cover;
  }
}

}  // namespace

Primitive primitiveOf(const Shape& shape) {
  return {shape.kind, shape.radius, 0.5 * shape.length, 0.5 * shape.size};
}

double signedDistance(const Primitive& solid, const Vec3& p) {
  switch (solid.kind) {
    case ShapeKind::Sphere:
      return p.norm() - solid.radius;
    case ShapeKind::Capsule: {
      const double z = p.z() - std::clamp(p.z(), -solid.half, solid.half);
      return std::sqrt(p.x() * p.x() + p.y() * p.y() + z * z) - solid.radius;
    }
    case ShapeKind::Cylinder: {
      const double side = std::sqrt(p.x() * p.x() + p.y() * p.y()) - solid.radius;
      const double end = std::abs(p.z()) - solid.half;
      const double outSide = std::max(side, 0.0);
      const double outEnd = std::max(end, 0.0);
      return std::min(std::max(side, end), 0.0) + std::sqrt(outSide * outSide + outEnd * outEnd);
    }
    case ShapeKind::Box: {
      const Vec3 d = p.cwiseAbs() - solid.halves;
      return std::min(d.maxCoeff(), 0.0) + d.cwiseMax(0.0).norm();
    }
    case ShapeKind::Mesh:
      break;
  }
  WCAM_ASSERT(false);
}

double outerRadius(const Primitive& solid) {
  switch (solid.kind) {
    case ShapeKind::Sphere:
      return solid.radius;
    case ShapeKind::Capsule:
      return solid.radius + solid.half;
    case ShapeKind::Cylinder:
      return std::hypot(solid.radius, solid.half);
    case ShapeKind::Box:
      return solid.halves.norm();
    case ShapeKind::Mesh:
      break;
  }
  WCAM_ASSERT(false);
}

RodDistance rodDistance(const Primitive& solid, const Rod& rod) {
  RodDistance result;
  if (solid.kind == ShapeKind::Sphere || solid.kind == ShapeKind::Capsule) {
    const Vec3 end(0, 0, solid.kind == ShapeKind::Sphere ? 0.0 : solid.half);
    result.value =
        segmentDistance(-end, end, rod.a, rod.b, &result.point) - solid.radius - rod.radius;
    return result;
  }
  const Vec3 d = rod.b - rod.a;
  const double length = d.norm();
  const auto at = [&](double s) { return signedDistance(solid, rod.a + s * d); };
  double low = 0.0;
  double high = 1.0;
  double s1 = 1.0 - kGolden;
  double s2 = kGolden;
  double f1 = at(s1);
  double f2 = at(s2);
  while ((high - low) * length > kSectionTolerance) {
    if (f1 <= f2) {
      high = s2;
      s2 = s1;
      f2 = f1;
      s1 = low + (1.0 - kGolden) * (high - low);
      f1 = at(s1);
    } else {
      low = s1;
      s1 = s2;
      f1 = f2;
      s2 = low + kGolden * (high - low);
      f2 = at(s2);
    }
  }
  double best = 0.5 * (low + high);
  double value = at(best);
  for (const double s : {0.0, 1.0}) {
    if (at(s) < value) {
      value = at(s);
      best = s;
    }
  }
  return {value - rod.radius, rod.a + best * d};
}

std::vector<CoverSphere> coverOf(const Shape& shape) {
  switch (shape.kind) {
    case ShapeKind::Sphere:
      return {{Vec3::Zero(), shape.radius}};
    case ShapeKind::Capsule:
      return coverCapsule(shape);
    case ShapeKind::Cylinder:
      return coverCylinder(shape);
    case ShapeKind::Box:
      return coverBox(shape.size);
    case ShapeKind::Mesh:
      return coverMesh(*shape.mesh);
  }
  return {};
}

}  // namespace wcam::collision::detail
