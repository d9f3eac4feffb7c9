// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/parallel.hpp"

#include "refine_patch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace wcam::geometry {

namespace {

constexpr std::uint32_t kNone = HalfEdges::kNone;
constexpr std::size_t kEdgeGrain = 1024;
/// A middle in the parameter that divides the length worse than 1 : 2 is moved.
constexpr double kUneven = 0.5;
constexpr int kBalanceSteps = 40;
/// Two evaluations of one place agree to this part of the edge's length.
constexpr double kSamePlace = 1e-9;
constexpr int kFootSteps = 12;

/// The middle of an edge: its place, and where it is on the edge's parameter line.
struct Middle {
  Vec3 p = Vec3::Zero();
  double fraction = 0.5;
};

/// Fraction at which `at` divides the way from a to b about evenly: 0.5 unless the parameter runs
/// very unevenly.
template <class PlaceAt>
Middle evenMiddle(const Vec3& a, const Vec3& b, const PlaceAt& at) {
  Middle middle{at(0.5), 0.5};
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < kBalanceSteps; ++i) {
    const double toA = (middle.p - a).norm();
    const double toB = (middle.p - b).norm();
    if (std::min(toA, toB) >= kUneven * std::max(toA, toB)) {
      break;
    }
    (toA < toB ? low : high) = middle.fraction;
    middle.fraction = 0.5 * (low + high);
    middle.p = at(middle.fraction);
  }
  return middle;
}

/// Splits the marked edges of a patch in one sweep.
class Splitter {
public:
  Splitter(RefinePatch& patch, double maxEdge) : patch_(patch), halfEdges_(patch.mesh) {
    const auto edges = static_cast<std::uint32_t>(halfEdges_.edgeCount());
    middleOf_.assign(edges, kNone);
    auto next = static_cast<std::uint32_t>(patch.mesh.vertices.size());
    for (std::uint32_t edge = 0; edge < edges; ++edge) {
      const auto& [a, b] = halfEdges_.edgeVertices(edge);
      if ((patch.mesh.vertices[b] - patch.mesh.vertices[a]).norm() > maxEdge) {
        middleOf_[edge] = next++;
        split_.push_back(edge);
      }
    }
  }

  std::size_t run(const JobContext& context) {
    if (split_.empty()) {
      return 0;
    }
    placeMiddles(context);
    if (patch_.exact()) {
      placeParameters(context);
    }
    makeTriangles();
    markVertices();
    const HalfEdges after(patch_.mesh);
    patch_.twin.resize(3 * patch_.mesh.triangles.size());
    for (std::uint32_t h = 0; h < patch_.twin.size(); ++h) {
      patch_.twin[h] = after.twin(h);
    }
    return split_.size();
  }

private:
  [[nodiscard]] const Vec3& vertex(std::uint32_t v) const { return patch_.mesh.vertices[v]; }

  /// (u,v) at the ends of a half-edge; a pole takes the free parameter of the other end, since the
  /// edge is a line of that parameter.
  [[nodiscard]] std::array<Vec2, 2> endUv(std::uint32_t h) const {
    const auto& uv = patch_.binding.uv[h / 3];
    std::array<Vec2, 2> ends{uv[h % 3], uv[(h % 3 + 1) % 3]};
    const int freeA = patch_.freeParameter[patch_.startOf(h)];
    const int freeB = patch_.freeParameter[patch_.endOf(h)];
    if (freeA >= 0 && freeB < 0) {
      ends[0][freeA] = ends[1][freeA];
    } else if (freeB >= 0 && freeA < 0) {
      ends[1][freeB] = ends[0][freeB];
    }
    return ends;
  }

  /// The half-edge whose parameters place the middle: the one that starts at the lesser of the two
  /// ends, so that the choice follows the shape.
  [[nodiscard]] std::uint32_t leadingHalfEdge(std::uint32_t edge) const {
    const std::uint32_t first = halfEdges_.halfEdgeOf(edge);
    const std::uint32_t other = halfEdges_.twin(first);
    if (other == kNone) {
      return first;
    }
    return pointLess(vertex(patch_.startOf(other)), vertex(patch_.startOf(first))) ? other : first;
  }

  [[nodiscard]] Middle middleOf(std::uint32_t h, const BrepEvaluator& evaluator) const {
    const Vec3& a = vertex(patch_.startOf(h));
    const Vec3& b = vertex(patch_.endOf(h));
    const BrepBinding& binding = patch_.binding;
    if (binding.edge[h] >= 0) {
      const double t0 = binding.edgeParam[h][0];
      const double t1 = binding.edgeParam[h][1];
      return evenMiddle(a, b, [&](double w) {
        return evaluator.curve(binding.edge[h], (1.0 - w) * t0 + w * t1).p;
      });
    }
    const auto [uvA, uvB] = endUv(h);
    return evenMiddle(a, b, [&, from = uvA, to = uvB](double w) {
      return evaluator.surface(binding.face[h / 3], Vec2((1.0 - w) * from + w * to)).p;
    });
  }

  void placeMiddles(const JobContext& context) {
    patch_.mesh.vertices.resize(patch_.mesh.vertices.size() + split_.size());
    middles_.resize(split_.size());
    leader_.resize(split_.size());
    parallelForChunks(
        split_.size(), kEdgeGrain,
        [&](std::size_t begin, std::size_t end) {
          std::optional<BrepEvaluator> evaluator;
          if (patch_.exact()) {
            evaluator.emplace(*patch_.brep);
          }
          for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t h = leadingHalfEdge(split_[i]);
            leader_[i] = h;
            middles_[i].p = 0.5 * (vertex(patch_.startOf(h)) + vertex(patch_.endOf(h)));
            if (evaluator) {
              middles_[i] = middleOf(h, *evaluator);
            }
            patch_.mesh.vertices[middleOf_[split_[i]]] = middles_[i].p;
          }
        },
        context);
    firstMiddle_ = static_cast<std::uint32_t>(patch_.mesh.vertices.size() - split_.size());
  }

  /// (u,v) of the point p of a face, near a guess.
  static Vec2 footPoint(const BrepEvaluator& evaluator, std::int32_t face, Vec2 uv, const Vec3& p) {
    double best = std::numeric_limits<double>::infinity();
    Vec2 bestUv = uv;
    for (int i = 0; i < kFootSteps; ++i) {
      const SurfacePoint s = evaluator.surface(face, uv);
      const Vec3 miss = p - s.p;
      if (!(miss.norm() < best)) {
        break;
      }
      best = miss.norm();
      bestUv = uv;
      const double uu = s.du.squaredNorm();
      const double vv = s.dv.squaredNorm();
      const double mixed = s.du.dot(s.dv);
      const double det = uu * vv - mixed * mixed;
      constexpr double kParallel = 1e-14;
      if (det <= kParallel * uu * vv || det <= 0.0) {
        break;
      }
      const double gu = miss.dot(s.du);
      const double gv = miss.dot(s.dv);
      uv += Vec2((vv * gu - mixed * gv) / det, (uu * gv - mixed * gu) / det);
    }
    return bestUv;
  }

  /// (u,v) of the middles for each half-edge: both sides of a seam keep their own.
  void placeParameters(const JobContext& context) {
    const std::size_t count = 3 * patch_.mesh.triangles.size();
    middleUv_.resize(count);
    middleParam_.resize(count);
    parallelForChunks(
        count, 3 * kEdgeGrain,
        [&](std::size_t begin, std::size_t end) {
          const BrepEvaluator evaluator(*patch_.brep);
          for (std::size_t i = begin; i < end; ++i) {
            const auto h = static_cast<std::uint32_t>(i);
            if (middleOf_[halfEdges_.edgeOf(h)] != kNone) {
              placeParameter(h, evaluator);
            }
          }
        },
        context);
  }

  void placeParameter(std::uint32_t h, const BrepEvaluator& evaluator) {
    const std::size_t index = middleOf_[halfEdges_.edgeOf(h)] - firstMiddle_;
    const Middle& middle = middles_[index];
    const bool sameWay = patch_.startOf(leader_[index]) == patch_.startOf(h);
    const double w = sameWay ? middle.fraction : 1.0 - middle.fraction;
    const auto& [t0, t1] = patch_.binding.edgeParam[h];
    middleParam_[h] = (1.0 - w) * t0 + w * t1;
    const auto [uvA, uvB] = endUv(h);
    middleUv_[h] = (1.0 - w) * uvA + w * uvB;
    if (h == leader_[index] && patch_.binding.edge[h] < 0) {
      return;
    }
    const std::int32_t face = patch_.binding.face[h / 3];
    const double length = (vertex(patch_.endOf(h)) - vertex(patch_.startOf(h))).norm();
    if ((evaluator.surface(face, middleUv_[h]).p - middle.p).norm() > kSamePlace * length) {
      middleUv_[h] = footPoint(evaluator, face, middleUv_[h], middle.p);
    }
  }

  /// Corners 0 to 2 of a triangle and the middles 3 to 5 of its edges, which follow the corners.
  struct Places {
    std::array<std::uint32_t, 6> vertex;
    std::array<Vec2, 6> uv;
  };

  [[nodiscard]] Places placesOf(std::uint32_t t) const {
    Places places{};
    for (std::uint32_t c = 0; c < 3; ++c) {
      places.vertex[c] = patch_.mesh.triangles[t][c];
      places.vertex[3 + c] = middleOf_[halfEdges_.edgeOf(3 * t + c)];
      if (patch_.exact()) {
        places.uv[c] = patch_.binding.uv[t][c];
        places.uv[3 + c] = middleUv_[3 * t + c];
      }
    }
    return places;
  }

  /// The edge (0 to 2) on which two neighbouring places lie, or 3 for a line inside.
  static std::uint32_t edgeBetween(std::uint32_t i, std::uint32_t j) {
    for (std::uint32_t c = 0; c < 3; ++c) {
      const auto on = [c](std::uint32_t k) { return k == c || k == 3 + c || k == (c + 1) % 3; };
      if (on(i) && on(j)) {
        return c;
      }
    }
    return 3;
  }

  [[nodiscard]] double paramAt(std::uint32_t h, std::uint32_t place) const {
    if (place >= 3) {
      return middleParam_[h];
    }
    return patch_.binding.edgeParam[h][place == h % 3 ? 0 : 1];
  }

  void emit(std::uint32_t t, const Places& places, const std::array<std::uint32_t, 3>& corners) {
    triangles_.push_back(
        {places.vertex[corners[0]], places.vertex[corners[1]], places.vertex[corners[2]]});
    if (!patch_.exact()) {
      return;
    }
    binding_.face.push_back(patch_.binding.face[t]);
    binding_.uv.push_back({places.uv[corners[0]], places.uv[corners[1]], places.uv[corners[2]]});
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t i = corners[c];
      const std::uint32_t j = corners[(c + 1) % 3];
      const std::uint32_t edge = edgeBetween(i, j);
      const std::uint32_t h = 3 * t + edge;
      if (edge < 3 && patch_.binding.edge[h] >= 0) {
        binding_.edge.push_back(patch_.binding.edge[h]);
        binding_.edgeParam.push_back({paramAt(h, i), paramAt(h, j)});
      } else {
        binding_.edge.push_back(-1);
        binding_.edgeParam.push_back({0.0, 0.0});
      }
    }
  }

  /// Whether the diagonal ab is to be taken rather than cd: the shorter one, on a tie the one with
  /// the lesser end.
  [[nodiscard]] bool better(std::uint32_t a,
                            std::uint32_t b,
                            std::uint32_t c,
                            std::uint32_t d) const {
    const double first = (vertex(a) - vertex(b)).squaredNorm();
    const double second = (vertex(c) - vertex(d)).squaredNorm();
    if (first != second) {
      return first < second;
    }
    const auto lesser = [this](std::uint32_t i, std::uint32_t j) {
      return pointLess(vertex(i), vertex(j)) ? vertex(i) : vertex(j);
    };
    return pointLess(lesser(a, b), lesser(c, d));
  }

  void emitTwo(std::uint32_t t, const Places& places, std::uint32_t whole) {
    const std::uint32_t a = whole;
    const std::uint32_t b = (whole + 1) % 3;
    const std::uint32_t apex = (whole + 2) % 3;
    const std::uint32_t onB = 3 + b;     // between b and the apex
    const std::uint32_t onA = 3 + apex;  // between the apex and a
    emit(t, places, {onB, apex, onA});
    if (better(places.vertex[a], places.vertex[onB], places.vertex[b], places.vertex[onA])) {
      emit(t, places, {a, b, onB});
      emit(t, places, {a, onB, onA});
    } else {
      emit(t, places, {a, b, onA});
      emit(t, places, {b, onB, onA});
    }
  }

  void makeTriangles() {
    const auto count = static_cast<std::uint32_t>(patch_.mesh.triangles.size());
    triangles_.reserve(2 * std::size_t{count});
    for (std::uint32_t t = 0; t < count; ++t) {
      const Places places = placesOf(t);
      std::uint32_t splits = 0;
      std::uint32_t lastSplit = 0;
      std::uint32_t lastWhole = 0;
      for (std::uint32_t c = 0; c < 3; ++c) {
        const bool split = places.vertex[3 + c] != kNone;
        splits += split ? 1 : 0;
        (split ? lastSplit : lastWhole) = c;
      }
      if (splits == 0) {
        emit(t, places, {0, 1, 2});
      } else if (splits == 1) {
        const std::uint32_t c = lastSplit;
        emit(t, places, {c, 3 + c, (c + 2) % 3});
        emit(t, places, {3 + c, (c + 1) % 3, (c + 2) % 3});
      } else if (splits == 2) {
        emitTwo(t, places, lastWhole);
      } else {
        emit(t, places, {0, 3, 5});
        emit(t, places, {3, 1, 4});
        emit(t, places, {5, 4, 2});
        emit(t, places, {3, 4, 5});
      }
    }
    patch_.mesh.triangles = std::move(triangles_);
    patch_.binding = std::move(binding_);
  }

  /// A middle is never a pole; it is irregular on a non-manifold edge.
  void markVertices() {
    const std::size_t count = patch_.mesh.vertices.size();
    patch_.freeParameter.resize(count, -1);
    patch_.irregular.resize(count, 0);
    for (const std::uint32_t edge : halfEdges_.nonManifoldEdges()) {
      if (middleOf_[edge] != kNone) {
        patch_.irregular[middleOf_[edge]] = 1;
      }
    }
    if (patch_.exact()) {
      for (std::uint32_t t = 0; t < patch_.mesh.triangles.size(); ++t) {
        patch_.freePoles(t);
      }
    }
  }

  RefinePatch& patch_;
  HalfEdges halfEdges_;
  std::vector<std::uint32_t> split_;     ///< edges
  std::vector<std::uint32_t> middleOf_;  ///< per edge: the new vertex
  std::vector<Middle> middles_;          ///< per split edge
  std::vector<std::uint32_t> leader_;    ///< per split edge
  std::uint32_t firstMiddle_ = 0;
  std::vector<Vec2> middleUv_;       ///< per half-edge
  std::vector<double> middleParam_;  ///< per half-edge
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  BrepBinding binding_;
};

}  // namespace

std::size_t splitLongEdges(RefinePatch& patch, double maxEdge, const JobContext& context) {
  return Splitter(patch, maxEdge).run(context);
}

}  // namespace wcam::geometry
