// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_boolean.hpp"

#include "wcam/base/quantity.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace wcam::geometry {

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// Bodies with more triangles than this together are told, not united.
constexpr std::size_t kMaxUnited = 2000000;

/// Nothing when the triangles make no closed two-sided surface.
std::optional<CgalMesh> toCgal(const TriangleMesh& mesh) {
  std::vector<Kernel::Point_3> points;
  points.reserve(mesh.vertices.size());
  for (const Vec3& p : mesh.vertices) {
    points.emplace_back(p.x(), p.y(), p.z());
  }
  std::vector<std::array<std::size_t, 3>> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) {
      triangles.push_back({t[0], t[1], t[2]});
    }
  }
  // Takes points apart where bodies touch in an edge or a point.
  pmp::orient_polygon_soup(points, triangles);
  if (!pmp::is_polygon_soup_a_polygon_mesh(triangles)) {
    return std::nullopt;
  }
  CgalMesh result;
  pmp::polygon_soup_to_polygon_mesh(points, triangles, result);
  if (result.is_empty() || !CGAL::is_closed(result)) {
    return std::nullopt;
  }
  return result;
}

TriangleMesh fromCgal(const CgalMesh& mesh) {
  TriangleMesh result;
  std::vector<std::uint32_t> index(mesh.num_vertices() + mesh.number_of_removed_vertices());
  for (const auto v : mesh.vertices()) {
    index[v] = static_cast<std::uint32_t>(result.vertices.size());
    const auto& p = mesh.point(v);
    result.vertices.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto f : mesh.faces()) {
    std::array<std::uint32_t, 3> t{};
    std::size_t corner = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) {
      t[corner++] = index[v];
    }
    result.triangles.push_back(t);
  }
  return result;
}

void append(TriangleMesh& mesh, const TriangleMesh& other) {
  const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& t : other.triangles) {
    mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
}

double signedVolume(const TriangleMesh& mesh, const std::vector<std::uint32_t>& triangles) {
  const Vec3& o = mesh.vertices[mesh.triangles[triangles.front()][0]];
  double volume6 = 0.0;
  for (const std::uint32_t t : triangles) {
    const auto& v = mesh.triangles[t];
    const Vec3 a = mesh.vertices[v[0]] - o;
    volume6 += a.dot((mesh.vertices[v[1]] - o).cross(mesh.vertices[v[2]] - o));
  }
  return volume6 / 6.0;
}

/// Winding number of the triangles around a point.
double windingOf(const TriangleMesh& mesh,
                 const std::vector<std::uint32_t>& triangles,
                 const Vec3& p) {
  double half = 0.0;
  for (const std::uint32_t t : triangles) {
    const auto& v = mesh.triangles[t];
    const Vec3 a = mesh.vertices[v[0]] - p;
    const Vec3 b = mesh.vertices[v[1]] - p;
    const Vec3 c = mesh.vertices[v[2]] - p;
    const double la = a.norm();
    const double lb = b.norm();
    const double lc = c.norm();
    half +=
        std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return half / (2.0 * kPi);
}

bool boxesMeet(const Box& a, const Box& b) {
  return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
}

bool contains(const Box& outer, const Box& inner) {
  return (outer.min.array() <= inner.min.array()).all() &&
         (outer.max.array() >= inner.max.array()).all();
}

/// A closed piece that points outwards, with the pieces pointing inwards that lie in it.
struct Body {
  std::vector<std::uint32_t> triangles;
  std::size_t outerTriangles = 0;  ///< of the outer piece, at the beginning
  Box box;
};

class OverlapFinder {
public:
  OverlapFinder(const TriangleMesh& mesh,
                const HalfEdges& halfEdges,
                double tolerance,
                const JobContext& context)
      : mesh_(mesh), halfEdges_(halfEdges), tolerance_(tolerance), context_(context) {}

  Overlaps run() {
    collectBodies();
    if (bodies_.size() < 2) {
      return {};
    }
    relateBodies();
    replaced_.assign(bodies_.size(), false);
    for (const std::vector<std::size_t>& group : groups()) {
      unite(group);
    }
    if (result_.any() && !failed_) {
      result_.united = rest();
    }
    return std::move(result_);
  }

private:
  static std::uint32_t rootOf(std::vector<std::uint32_t>& parent, std::uint32_t v) {
    while (parent[v] != v) {
      parent[v] = parent[parent[v]];
      v = parent[v];
    }
    return v;
  }

  /// Pieces joined by twins, without the open ones.
  std::vector<std::vector<std::uint32_t>> closedPieces() {
    const auto count = static_cast<std::uint32_t>(mesh_.triangles.size());
    std::vector<std::uint32_t> parent(count);
    std::iota(parent.begin(), parent.end(), 0U);
    std::vector<bool> open(count, false);
    for (std::uint32_t h = 0; h < 3 * count; ++h) {
      const std::uint32_t twin = halfEdges_.twin(h);
      if (twin == HalfEdges::kNone) {
        open[h / 3] = true;
      } else if (h < twin) {
        const std::uint32_t a = rootOf(parent, h / 3);
        const std::uint32_t b = rootOf(parent, twin / 3);
        parent[std::max(a, b)] = std::min(a, b);
      }
    }
    std::vector<std::uint32_t> pieceOf(count, HalfEdges::kNone);
    std::vector<std::vector<std::uint32_t>> pieces;
    std::vector<bool> openPiece;
    for (std::uint32_t t = 0; t < count; ++t) {
      std::uint32_t& piece = pieceOf[rootOf(parent, t)];
      if (piece == HalfEdges::kNone) {
        piece = static_cast<std::uint32_t>(pieces.size());
        pieces.emplace_back();
        openPiece.push_back(false);
      }
      pieces[piece].push_back(t);
      openPiece[piece] = openPiece[piece] || open[t];
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (!openPiece[i]) {
        pieces[kept++].swap(pieces[i]);
      }
    }
    pieces.resize(kept);
    return pieces;
  }

  [[nodiscard]] Box boxOf(const std::vector<std::uint32_t>& triangles) const {
    Box box;
    for (const std::uint32_t t : triangles) {
      for (const std::uint32_t v : mesh_.triangles[t]) {
        box.add(mesh_.vertices[v]);
      }
    }
    return box;
  }

  [[nodiscard]] const Vec3& pointOf(const std::vector<std::uint32_t>& triangles) const {
    return mesh_.vertices[mesh_.triangles[triangles.front()][0]];
  }

  void collectBodies() {
    std::vector<std::vector<std::uint32_t>> cavities;
    for (std::vector<std::uint32_t>& piece : closedPieces()) {
      if (signedVolume(mesh_, piece) > 0.0) {
        const std::size_t size = piece.size();
        bodies_.push_back({std::move(piece), size, {}});
        bodies_.back().box = boxOf(bodies_.back().triangles);
      } else {
        cavities.push_back(std::move(piece));
      }
    }
    if (bodies_.size() < 2) {
      return;
    }
    for (const std::vector<std::uint32_t>& cavity : cavities) {
      const Box box = boxOf(cavity);
      Body* home = nullptr;
      for (Body& body : bodies_) {
        const bool smaller = home == nullptr || contains(home->box, body.box);
        if (smaller && contains(body.box, box) &&
            windingOf(mesh_, body.triangles, pointOf(cavity)) > 0.5) {
          home = &body;
        }
      }
      if (home != nullptr) {
        home->triangles.insert(home->triangles.end(), cavity.begin(), cavity.end());
      }
    }
  }

  /// Pairs whose boxes meet, by a sweep along x; those that share space or touch are related.
  void relateBodies() {
    std::vector<std::size_t> order(bodies_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      const double xa = bodies_[a].box.min.x();
      const double xb = bodies_[b].box.min.x();
      return xa != xb ? xa < xb : a < b;
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
      context_.check();
      for (std::size_t k = i + 1;
           k < order.size() && bodies_[order[k]].box.min.x() <= bodies_[order[i]].box.max.x();
           ++k) {
        const auto [a, b] = std::minmax(order[i], order[k]);
        if (!boxesMeet(bodies_[a].box, bodies_[b].box)) {
          continue;
        }
        if (surfacesMeet(bodies_[a], bodies_[b])) {
          related_.push_back({a, b, false});
        } else if (isInside(bodies_[a], bodies_[b]) || isInside(bodies_[b], bodies_[a])) {
          related_.push_back({a, b, true});
        }
      }
    }
  }

  /// The whole of `inner`, whose surface does not meet that of `outer`, lies in its material.
  [[nodiscard]] bool isInside(const Body& inner, const Body& outer) const {
    return contains(outer.box, inner.box) &&
           windingOf(mesh_, outer.triangles, pointOf(inner.triangles)) > 0.5;
  }

  using Triangle = std::pair<Kernel::Triangle_3, CGAL::Bbox_3>;

  [[nodiscard]] std::vector<Triangle> trianglesIn(const Body& body, const Box& box) const {
    std::vector<Triangle> list;
    for (const std::uint32_t t : body.triangles) {
      Box own;
      std::array<Kernel::Point_3, 3> corner;
      for (std::size_t c = 0; c < 3; ++c) {
        const Vec3& p = mesh_.vertices[mesh_.triangles[t][c]];
        own.add(p);
        corner[c] = {p.x(), p.y(), p.z()};
      }
      const Kernel::Triangle_3 triangle(corner[0], corner[1], corner[2]);
      if (boxesMeet(own, box) && !triangle.is_degenerate()) {
        list.emplace_back(triangle, triangle.bbox());
      }
    }
    return list;
  }

  [[nodiscard]] bool surfacesMeet(const Body& a, const Body& b) const {
    Box common;
    common.add(a.box.min.cwiseMax(b.box.min));
    common.add(a.box.max.cwiseMin(b.box.max));
    std::vector<Triangle> ofA = trianglesIn(a, common);
    std::vector<Triangle> ofB = trianglesIn(b, common);
    using CgalBox = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, Triangle*>;
    std::array<std::vector<CgalBox>, 2> boxes;
    for (Triangle& t : ofA) {
      boxes[0].emplace_back(t.second, &t);
    }
    for (Triangle& t : ofB) {
      boxes[1].emplace_back(t.second, &t);
    }
    bool meet = false;
    std::size_t work = 0;
    CGAL::box_intersection_d(boxes[0].begin(), boxes[0].end(), boxes[1].begin(), boxes[1].end(),
                             [&](const CgalBox& p, const CgalBox& q) {
                               constexpr std::size_t kCheckInterval = 1 << 16;
                               if (++work % kCheckInterval == 0) {
                                 context_.check();
                               }
                               meet =
                                   meet || CGAL::do_intersect(p.handle()->first, q.handle()->first);
                             });
    return meet;
  }

  /// Bodies that relations connect, each in ascending order.
  [[nodiscard]] std::vector<std::vector<std::size_t>> groups() const {
    std::vector<std::uint32_t> parent(bodies_.size());
    std::iota(parent.begin(), parent.end(), 0U);
    for (const Relation& relation : related_) {
      const std::uint32_t a = rootOf(parent, static_cast<std::uint32_t>(relation.a));
      const std::uint32_t b = rootOf(parent, static_cast<std::uint32_t>(relation.b));
      parent[std::max(a, b)] = std::min(a, b);
    }
    std::vector<std::vector<std::size_t>> of(bodies_.size());
    for (std::uint32_t i = 0; i < bodies_.size(); ++i) {
      of[rootOf(parent, i)].push_back(i);
    }
    of.erase(std::remove_if(of.begin(), of.end(), [](const auto& g) { return g.size() < 2; }),
             of.end());
    return of;
  }

  [[nodiscard]] TriangleMesh meshOf(const Body& body) const {
    TriangleMesh mesh;
    std::vector<std::uint32_t> used;
    for (const std::uint32_t t : body.triangles) {
      used.insert(used.end(), mesh_.triangles[t].begin(), mesh_.triangles[t].end());
    }
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (const std::uint32_t v : used) {
      mesh.vertices.push_back(mesh_.vertices[v]);
    }
    const auto at = [&](std::uint32_t v) {
      return static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), v) -
                                        used.begin());
    };
    for (const std::uint32_t t : body.triangles) {
      const auto& v = mesh_.triangles[t];
      mesh.triangles.push_back({at(v[0]), at(v[1]), at(v[2])});
    }
    return mesh;
  }

  /// A body, or several united ones.
  struct Part {
    CgalMesh mesh;
    std::vector<std::size_t> bodies;
    double area = 0.0;
  };

  void unite(const std::vector<std::size_t>& group) {
    std::size_t triangles = 0;
    for (const std::size_t i : group) {
      triangles += bodies_[i].triangles.size();
    }
    if (triangles > kMaxUnited) {
      notUnited(group);
      return;
    }
    std::vector<Part> parts;
    for (const std::size_t i : group) {
      std::optional<CgalMesh> mesh = toCgal(meshOf(bodies_[i]));
      if (!mesh) {
        notUnited(group);
        return;
      }
      Part current{std::move(*mesh), {i}, 0.0};
      current.area = CGAL::to_double(pmp::area(current.mesh));
      for (std::size_t k = 0; k < parts.size();) {
        context_.check();
        if (!areRelated(parts[k], current)) {
          ++k;
          continue;
        }
        const Step step = merge(parts[k], current);
        if (step == Step::Failed) {
          notUnited(group);
          return;
        }
        if (step == Step::Apart) {
          ++k;
          continue;
        }
        parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(k));
      }
      parts.push_back(std::move(current));
    }
    for (const Part& part : parts) {
      if (part.bodies.size() > 1) {
        append(united_, fromCgal(part.mesh));
        for (const std::size_t i : part.bodies) {
          replaced_[i] = true;
        }
        countBodies(part.bodies);
      }
    }
  }

  [[nodiscard]] bool areRelated(const Part& a, const Part& b) const {
    return std::any_of(related_.begin(), related_.end(), [&](const Relation& relation) {
      const auto has = [](const Part& part, std::size_t body) {
        return std::find(part.bodies.begin(), part.bodies.end(), body) != part.bodies.end();
      };
      return (has(a, relation.a) && has(b, relation.b)) ||
             (has(a, relation.b) && has(b, relation.a));
    });
  }

  enum class Step { Apart, Merged, Failed };

  /// Results of one comparison of two bodies; the volumes are empty when they could not be had.
  struct Comparison {
    std::optional<CgalMesh> sum;
    std::optional<CgalMesh> common;
  };

  static Comparison compare(CgalMesh a, CgalMesh b) {
    CgalMesh sum;
    CgalMesh common;
    std::array<boost::optional<CgalMesh*>, 4> out;
    out[pmp::Corefinement::UNION] = &sum;
    out[pmp::Corefinement::INTERSECTION] = &common;
    Comparison result;
    try {
      const std::array<bool, 4> done = pmp::corefine_and_compute_boolean_operations(
          a, b, out, CGAL::parameters::throw_on_self_intersection(true));
      if (done[pmp::Corefinement::UNION]) {
        result.sum = std::move(sum);
      }
      if (done[pmp::Corefinement::INTERSECTION]) {
        result.common = std::move(common);
      }
    } catch (const std::exception&) {
      return {};
    }
    return result;
  }

  static double volumeOf(const CgalMesh& mesh) {
    return mesh.is_empty() ? 0.0 : CGAL::to_double(pmp::volume(mesh));
  }

  /// Unites `other` into `current` when they share more than their surfaces are off. Where the
  /// union would touch itself in an edge, one of them is moved by what the surfaces are off.
  Step merge(const Part& other, Part& current) {
    Comparison result = compare(other.mesh, current.mesh);
    const double negligible = tolerance_ * std::min(other.area, current.area);
    if (result.common && volumeOf(*result.common) <= negligible) {
      return Step::Apart;
    }
    for (const double step : {1.0, -1.0, 2.0}) {
      if (result.sum && result.common) {
        break;
      }
      CgalMesh moved = current.mesh;
      const Kernel::Vector_3 offset(step * tolerance_, 0.618 * step * tolerance_,
                                    0.382 * step * tolerance_);
      for (const auto v : moved.vertices()) {
        moved.point(v) = moved.point(v) + offset;
      }
      Comparison again = compare(other.mesh, std::move(moved));
      if (again.sum && again.common) {
        result = std::move(again);
      }
    }
    if (!result.sum && !result.common) {
      return Step::Failed;
    }
    const double shared =
        result.common ? volumeOf(*result.common)
                      : volumeOf(other.mesh) + volumeOf(current.mesh) - volumeOf(*result.sum);
    if (shared <= negligible) {
      return Step::Apart;
    }
    noteOverlap(shared, result.common ? *result.common : CgalMesh());
    if (!result.sum) {
      return Step::Failed;
    }
    current.mesh = std::move(*result.sum);
    current.area = CGAL::to_double(pmp::area(current.mesh));
    current.bodies.insert(current.bodies.end(), other.bodies.begin(), other.bodies.end());
    return Step::Merged;
  }

  void noteOverlap(double shared, const CgalMesh& common) {
    if (result_.volume == 0.0 && !common.is_empty()) {
      const Box box = fromCgal(common).bounds();
      result_.place = 0.5 * (box.min + box.max);
    }
    result_.volume += shared;
  }

  /// Bodies that only lie in others count as nested.
  void countBodies(const std::vector<std::size_t>& bodies) {
    for (const std::size_t i : bodies) {
      const bool crosses =
          std::any_of(related_.begin(), related_.end(), [&](const Relation& relation) {
            return !relation.nested && (relation.a == i || relation.b == i);
          });
      const bool inner =
          std::any_of(related_.begin(), related_.end(), [&](const Relation& relation) {
            const std::size_t other = relation.a == i ? relation.b : relation.a;
            return relation.nested && (relation.a == i || relation.b == i) &&
                   contains(bodies_[other].box, bodies_[i].box);
          });
      result_.crossing += crosses ? 1 : 0;
      result_.nested += !crosses && inner ? 1 : 0;
    }
  }

  void notUnited(const std::vector<std::size_t>& group) {
    failed_ = true;
    countBodies(group);
    if (result_.volume == 0.0) {
      const Box& box = bodies_[group.front()].box;
      result_.place = 0.5 * (box.min + box.max);
    }
  }

  /// What was not replaced, open pieces too, with the united bodies.
  [[nodiscard]] TriangleMesh rest() const {
    std::vector<bool> drop(mesh_.triangles.size(), false);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      for (const std::uint32_t t : bodies_[i].triangles) {
        drop[t] = replaced_[i];
      }
    }
    TriangleMesh mesh;
    mesh.vertices = mesh_.vertices;
    for (std::size_t t = 0; t < drop.size(); ++t) {
      if (!drop[t]) {
        mesh.triangles.push_back(mesh_.triangles[t]);
      }
    }
    append(mesh, united_);
    return mesh;
  }

  struct Relation {
    std::size_t a, b;
    bool nested;
  };

  const TriangleMesh& mesh_;
  const HalfEdges& halfEdges_;
  double tolerance_;
  const JobContext& context_;
  std::vector<Body> bodies_;
  std::vector<Relation> related_;
  std::vector<bool> replaced_;
  TriangleMesh united_;
  Overlaps result_;
  bool failed_ = false;
};

}  // namespace

std::optional<TriangleMesh> subtract(const TriangleMesh& a, const TriangleMesh& b) {
  std::optional<CgalMesh> from = toCgal(a);
  std::optional<CgalMesh> cutter = toCgal(b);
  if (!from || !cutter) {
    return std::nullopt;
  }
  try {
    pmp::orient_to_bound_a_volume(*from);
    pmp::orient_to_bound_a_volume(*cutter);
    CgalMesh rest;
    const bool done = pmp::corefine_and_compute_difference(
        *from, *cutter, rest, CGAL::parameters::throw_on_self_intersection(true));
    return done ? std::optional(fromCgal(rest)) : std::nullopt;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

Overlaps findOverlaps(const TriangleMesh& mesh,
                      const HalfEdges& halfEdges,
                      double tolerance,
                      const JobContext& context) {
  return OverlapFinder(mesh, halfEdges, tolerance, context).run();
}

}  // namespace wcam::geometry
