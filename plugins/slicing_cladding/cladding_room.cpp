// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cladding_room.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace wcam::cladding {

namespace {

/// Length of the pieces of a bead, in widths.
constexpr double kPiece = 0.25;
/// Size of the smallest pieces of surface along the bisector of two beads, in spacings; more where
/// the beads are very long, in parts of their length.
constexpr double kFine = 1.0 / 48.0;
constexpr double kFineOfLength = 2e-6;
/// Size of the largest pieces of surface, in spacings.
constexpr double kCoarse = 0.5;
/// A bead on the border lies as near to it, in spacings.
constexpr double kOnBorder = 0.05;
/// Narrowest room of a bead, in spacings.
constexpr double kNarrowest = 0.05;

std::vector<Vec3> vertexNormals(const geometry::TriangleMesh& mesh) {
  std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
  for (const auto& t : mesh.triangles) {
    const Vec3& a = mesh.vertices[t[0]];
    const Vec3 cross = (mesh.vertices[t[1]] - a).cross(Vec3(mesh.vertices[t[2]] - a));
    for (const std::uint32_t v : t) {
      normals[v] += cross;
    }
  }
  for (Vec3& n : normals) {
    n = n.norm() > 0.0 ? Vec3(n.normalized()) : n;
  }
  return normals;
}

}  // namespace

/// Gives every piece of the surface to the bead nearest to it.
class SurfaceRoom::Sharer {
public:
  Sharer(const std::vector<SurfaceCurve>& curves, const RoomOptions& options, SurfaceRoom& room)
      : options_(options), room_(room) {
    double length = 0.0;
    for (const SurfaceCurve& curve : curves) {
      const std::size_t n = curve.points.size();
      double s = 0.0;
      for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i) {
        const Vec3& a = curve.points[i];
        const Vec3& b = curve.points[(i + 1) % n];
        tree_.add(a, b);
        places_.push_back({room_.rooms_.size(), s, (b - a).norm()});
        s += places_.back().length;
      }
      Room& made = room_.rooms_.emplace_back();
      made.length = s;
      made.closed = curve.closed;
      made.pieces.resize(
          static_cast<std::size_t>(std::max(1.0, std::ceil(s / (kPiece * options.width)))));
      length += s;
    }
    tree_.build();
    fine_ = std::max(kFine * options.spacing, kFineOfLength * length);
  }

  /// @param growth area of the triangle at the height h, in parts of it: 1 + growth[0]·h +
  /// growth[1]·h²
  void share(const std::array<Vec3, 3>& corners, const std::array<double, 2>& growth) {
    growth_ = growth;
    give(corners, {nearest(corners[0]), nearest(corners[1]), nearest(corners[2])});
  }

  /// What a bead on the border fills beyond it.
  void addStock(const std::vector<SurfaceCurve>& curves, const geometry::SegmentTree& border) {
    std::size_t segment = 0;
    for (const SurfaceCurve& curve : curves) {
      const std::size_t n = curve.points.size();
      for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i, ++segment) {
        const Vec3 middle = 0.5 * (curve.points[i] + curve.points[(i + 1) % n]);
        const double near = kOnBorder * options_.spacing;
        if (border.distance(middle, 2.0 * near) < near) {
          const Place& place = places_[segment];
          add({place.curve, place.s + 0.5 * place.length, 0.0}, options_.stock * place.length,
              {0.0, 0.0});
        }
      }
    }
  }

private:
  /// A segment of a curve.
  struct Place {
    std::size_t curve = 0;
    double s = 0.0;  ///< of its start
    double length = 0.0;
  };

  /// The nearest place of a bead.
  struct Foot {
    std::size_t curve = 0;
    double s = 0.0;
    double distance = std::numeric_limits<double>::infinity();
  };

  [[nodiscard]] Foot nearest(const Vec3& p) const {
    const geometry::SegmentTree::Nearest found = tree_.nearestSegment(p);
    const Place& place = places_[found.number];
    return {place.curve, place.s + found.fraction * place.length,
            (p - (found.a + found.fraction * (found.b - found.a))).norm()};
  }

  void give(const std::array<Vec3, 3>& corners, const std::array<Foot, 3>& feet) {
    double longest = 0.0;
    bool same = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t j = (k + 1) % 3;
      const double edge = (corners[j] - corners[k]).norm();
      longest = std::max(longest, edge);
      same = same && feet[k].curve == feet[j].curve && apart(feet[k], feet[j]) <= 2.0 * edge;
    }
    const bool far =
        std::min({feet[0].distance, feet[1].distance, feet[2].distance}) > options_.reach + longest;
    const bool near =
        std::max({feet[0].distance, feet[1].distance, feet[2].distance}) <= options_.reach;
    if (far || longest <= fine_ || (same && near && longest <= kCoarse * options_.spacing)) {
      const Vec3 centre = (corners[0] + corners[1] + corners[2]) / 3.0;
      const double area =
          0.5 * (corners[1] - corners[0]).cross(Vec3(corners[2] - corners[0])).norm();
      const Foot foot = far ? feet[0] : nearest(centre);
      if (foot.distance > options_.reach) {
        room_.uncovered_ += area;
      } else {
        add(foot, area, growth_);
      }
      return;
    }
    std::array<Vec3, 3> middle;
    std::array<Foot, 3> between;
    for (std::size_t k = 0; k < 3; ++k) {
      middle[k] = 0.5 * (corners[k] + corners[(k + 1) % 3]);
      between[k] = nearest(middle[k]);
    }
    give({corners[0], middle[0], middle[2]}, {feet[0], between[0], between[2]});
    give({corners[1], middle[1], middle[0]}, {feet[1], between[1], between[0]});
    give({corners[2], middle[2], middle[1]}, {feet[2], between[2], between[1]});
    give(middle, between);
  }

  /// Distance along a curve.
  [[nodiscard]] double apart(const Foot& a, const Foot& b) const {
    const double way = std::abs(a.s - b.s);
    const Room& room = room_.rooms_[a.curve];
    return room.closed ? std::min(way, room.length - way) : way;
  }

  void add(const Foot& foot, double area, const std::array<double, 2>& growth) {
    Room& room = room_.rooms_[foot.curve];
    const auto n = static_cast<double>(room.pieces.size());
    const double place = room.length > 0.0 ? std::floor(foot.s / room.length * n) : 0.0;
    Piece& piece = room.pieces[static_cast<std::size_t>(std::clamp(place, 0.0, n - 1.0))];
    piece.a += area;
    piece.b += area * growth[0];
    piece.c += area * growth[1];
  }

  const RoomOptions& options_;
  SurfaceRoom& room_;
  geometry::SegmentTree tree_;
  std::vector<Place> places_;
  double fine_ = 0.0;
  std::array<double, 2> growth_{0.0, 0.0};
};

SurfaceRoom::SurfaceRoom(const geometry::PartSurface& part,
                         const std::vector<SurfaceCurve>& curves,
                         const std::function<bool(std::uint32_t)>& counts,
                         const geometry::SegmentTree& border,
                         const RoomOptions& options)
    : options_(options) {
  if (curves.empty()) {
    return;
  }
  const geometry::TriangleMesh& mesh = part.mesh;
  const std::vector<Vec3> normals = vertexNormals(mesh);
  Sharer sharer(curves, options_, *this);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!counts(t)) {
      continue;
    }
    const auto& c = mesh.triangles[t];
    const std::array<Vec3, 3> corners{mesh.vertices[c[0]], mesh.vertices[c[1]],
                                      mesh.vertices[c[2]]};
    const Vec3 e = corners[1] - corners[0];
    const Vec3 f = corners[2] - corners[0];
    const Vec3 de = normals[c[1]] - normals[c[0]];
    const Vec3 df = normals[c[2]] - normals[c[0]];
    const Vec3 cross = e.cross(f);
    const double square = cross.squaredNorm();
    if (square > 0.0) {
      sharer.share(corners, {cross.dot(Vec3(e.cross(df) + de.cross(f))) / square,
                             cross.dot(de.cross(df)) / square});
    }
  }
  if (options.stock > 0.0) {
    sharer.addStock(curves, border);
  }
}

toolpath::FillRoom SurfaceRoom::at(std::size_t curve, double height) const {
  const Room& room = rooms_[curve];
  const auto n = static_cast<double>(room.pieces.size());
  std::vector<toolpath::RoomShare> shares;
  shares.reserve(room.pieces.size());
  for (std::size_t k = 0; k < room.pieces.size(); ++k) {
    const Piece& piece = room.pieces[k];
    shares.push_back({(static_cast<double>(k) + 0.5) * room.length / n,
                      std::max(0.0, piece.a + height * (piece.b + height * piece.c))});
  }
  return toolpath::averagedRoom(
      shares, {room.length, room.length, kPiece * options_.width, options_.width, room.closed},
      {kNarrowest * options_.spacing, std::numeric_limits<double>::infinity(),
       std::numeric_limits<double>::infinity()});
}

}  // namespace wcam::cladding
