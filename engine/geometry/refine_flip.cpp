// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine_patch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace wcam::geometry {

namespace {

constexpr std::uint32_t kNone = HalfEdges::kNone;
/// Sine of the angle by which two opposite corners must exceed 180° together: corners on one circle
/// keep their edge whatever the rounding.
constexpr double kDelaunaySlack = 1e-6;
/// How far a flip may move the surface of a mesh, in parts of the edge's length.
constexpr double kShapeChange = 1e-4;
/// Sagitta of a flipped edge over a CAD face in parts of its length: adds less than 0.03 % to a
/// distance.
constexpr double kSagitta = 0.01;
/// (u,v) of the two sides count as the same below this part of the edge's own (u,v) length.
constexpr double kSameUv = 1e-9;
/// Normals before and after a flip: beyond 60° the flip would fold the surface.
constexpr double kFoldCosine = 0.5;
constexpr int kMostRounds = 100;

struct Flip {
  double gain = 0.0;
  Vec3 middle = Vec3::Zero();  ///< of the edge: breaks ties
  std::uint32_t halfEdge = 0;
};

class Flipper {
public:
  Flipper(RefinePatch& patch, double maxEdge) : patch_(patch), maxEdge_(maxEdge) {
    if (patch.exact()) {
      evaluator_.emplace(*patch.brep);
    }
  }

  void run(const JobContext& context) {
    std::vector<std::uint32_t> active;
    for (std::uint32_t h = 0; h < patch_.twin.size(); ++h) {
      if (patch_.twin[h] != kNone && h < patch_.twin[h]) {
        active.push_back(h);
      }
    }
    std::vector<int> touched(patch_.mesh.triangles.size(), -1);
    for (int round = 0; round < kMostRounds && !active.empty(); ++round) {
      context.check();
      active = runRound(active, touched, round);
    }
  }

private:
  [[nodiscard]] const Vec3& vertex(std::uint32_t v) const { return patch_.mesh.vertices[v]; }

  /// One round: the worst edges first, each triangle at most once.
  /// @return the edges to look at in the next round
  std::vector<std::uint32_t> runRound(const std::vector<std::uint32_t>& active,
                                      std::vector<int>& touched,
                                      int round) {
    std::vector<Flip> flips;
    for (const std::uint32_t h : active) {
      const double gain = gainOf(h);
      if (gain > 0.0 && allowed(h)) {
        flips.push_back({gain, vertex(patch_.startOf(h)) + vertex(patch_.endOf(h)), h});
      }
    }
    std::sort(flips.begin(), flips.end(), [](const Flip& a, const Flip& b) {
      return a.gain != b.gain ? a.gain > b.gain : pointLess(a.middle, b.middle);
    });
    std::vector<std::uint32_t> changed;  // triangles
    for (const Flip& flip : flips) {
      const std::uint32_t a = flip.halfEdge / 3;
      const std::uint32_t b = patch_.twin[flip.halfEdge] / 3;
      if (touched[a] == round || touched[b] == round || wouldDouble(flip.halfEdge)) {
        continue;
      }
      doFlip(flip.halfEdge);
      touched[a] = touched[b] = round;
      changed.insert(changed.end(), {a, b});
    }
    std::vector<std::uint32_t> next;
    for (const std::uint32_t t : changed) {
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        if (patch_.twin[h] != kNone) {
          next.push_back(std::min(h, patch_.twin[h]));
        }
      }
    }
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    return next;
  }

  /// By how much the edge fails Delaunay's condition; not positive when it holds, or when the edge
  /// must stay.
  [[nodiscard]] double gainOf(std::uint32_t h) const {
    const std::uint32_t other = patch_.twin[h];
    if (other == kNone || other / 3 == h / 3) {
      return 0.0;
    }
    if (patch_.exact() && (patch_.binding.edge[h] >= 0 || patch_.binding.edge[other] >= 0 ||
                           patch_.binding.face[h / 3] != patch_.binding.face[other / 3])) {
      return 0.0;
    }
    if (patch_.exact() && inverted(h / 3) != inverted(other / 3)) {
      return 4.0;  // before any other
    }
    const auto [sineP, cosineP] = angleAt(patch_.oppositeOf(h), h);
    const auto [sineQ, cosineQ] = angleAt(patch_.oppositeOf(other), h);
    const double sine = sineP * cosineQ + cosineP * sineQ;
    // Sum of the angles above 180°: how far goes by 1 − cos, so that 360° is worst.
    return sine < -kDelaunaySlack ? 1.0 + (cosineP * cosineQ - sineP * sineQ) + 1e-300 : 0.0;
  }

  /// Sine and cosine of the angle under which a corner sees an edge.
  [[nodiscard]] std::array<double, 2> angleAt(std::uint32_t corner, std::uint32_t h) const {
    const Vec3 a = vertex(patch_.startOf(h)) - vertex(corner);
    const Vec3 b = vertex(patch_.endOf(h)) - vertex(corner);
    const double scale = a.norm() * b.norm();
    return {a.cross(b).norm() / scale, a.dot(b) / scale};
  }

  [[nodiscard]] bool inverted(std::uint32_t t) const {
    const auto& uv = patch_.binding.uv[t];
    return patch_.uvArea(patch_.binding.face[t], uv[0], uv[1], uv[2]) <= 0.0;
  }

  [[nodiscard]] bool allowed(std::uint32_t h) const {
    const std::uint32_t other = patch_.twin[h];
    const std::uint32_t p = patch_.oppositeOf(h);
    const std::uint32_t q = patch_.oppositeOf(other);
    if (p == q || (patch_.irregular[p] != 0 && patch_.irregular[q] != 0)) {
      return false;
    }
    const double before = (vertex(patch_.endOf(h)) - vertex(patch_.startOf(h))).norm();
    const double after = (vertex(q) - vertex(p)).norm();
    return after <= std::max(before, maxEdge_) &&
           (patch_.exact() ? keepsFace(h, before, after) : keepsMesh(h, before));
  }

  /// Both new triangles stand like the two old ones, and none is degenerate.
  [[nodiscard]] bool keepsSide(std::uint32_t h) const {
    const Vec3& u = vertex(patch_.startOf(h));
    const Vec3& v = vertex(patch_.endOf(h));
    const Vec3& p = vertex(patch_.oppositeOf(h));
    const Vec3& q = vertex(patch_.oppositeOf(patch_.twin[h]));
    const Vec3 before = (v - u).cross(p - u) + (q - u).cross(v - u);
    const Vec3 first = (q - u).cross(p - u);
    const Vec3 second = (v - q).cross(p - q);
    const double scale = before.norm();
    constexpr double kDegenerate = 1e-9;
    const double least = kDegenerate * scale;
    return first.norm() > least && second.norm() > least &&
           first.dot(before) > kFoldCosine * first.norm() * scale &&
           second.dot(before) > kFoldCosine * second.norm() * scale;
  }

  [[nodiscard]] bool keepsMesh(std::uint32_t h, double length) const {
    const Vec3 edge = vertex(patch_.endOf(h)) - vertex(patch_.startOf(h));
    const Vec3 p = vertex(patch_.oppositeOf(h)) - vertex(patch_.startOf(h));
    const Vec3 diagonal = vertex(patch_.oppositeOf(patch_.twin[h])) - vertex(patch_.oppositeOf(h));
    const Vec3 common = edge.cross(diagonal);
    const double scale = common.norm();
    return scale > 0.0 && std::abs(p.dot(common)) <= kShapeChange * length * scale && keepsSide(h);
  }

  [[nodiscard]] bool keepsFace(std::uint32_t h, double before, double after) const {
    const std::uint32_t other = patch_.twin[h];
    const auto& uvA = patch_.binding.uv[h / 3];
    const auto& uvB = patch_.binding.uv[other / 3];
    const Vec2& u = uvA[h % 3];
    const Vec2& v = uvA[(h % 3 + 1) % 3];
    const Vec2& p = uvA[(h % 3 + 2) % 3];
    const Vec2& q = uvB[(other % 3 + 2) % 3];
    const double same = kSameUv * (v - u).norm();
    if ((uvB[other % 3] - v).norm() > same || (uvB[(other % 3 + 1) % 3] - u).norm() > same) {
      return false;
    }
    const std::int32_t face = patch_.binding.face[h / 3];
    if (patch_.uvArea(face, u, q, p) <= 0.0 || patch_.uvArea(face, q, v, p) <= 0.0) {
      return false;
    }
    const bool repairs = inverted(h / 3) || inverted(other / 3);
    if (!repairs && !keepsSide(h)) {
      return false;
    }
    const double sagitta = sagittaOf(face, patch_.oppositeOf(h), patch_.oppositeOf(other), p, q);
    return repairs || sagitta <= kSagitta * after ||
           sagitta / after <= sagittaOf(face, patch_.startOf(h), patch_.endOf(h), u, v) / before;
  }

  [[nodiscard]] double sagittaOf(
      std::int32_t face, std::uint32_t a, std::uint32_t b, const Vec2& uvA, const Vec2& uvB) const {
    const Vec3 chord = vertex(b) - vertex(a);
    const Vec3 middle = evaluator_->surface(face, 0.5 * (uvA + uvB)).p - vertex(a);
    const double length = chord.norm();
    return length > 0.0 ? middle.cross(chord).norm() / length : middle.norm();
  }

  /// Whether the new edge exists already elsewhere.
  [[nodiscard]] bool wouldDouble(std::uint32_t h) const {
    const std::uint32_t p = patch_.oppositeOf(h);
    const std::uint32_t q = patch_.oppositeOf(patch_.twin[h]);
    const std::uint32_t corner = h - h % 3 + (h % 3 + 2) % 3;  // half-edge that starts at p
    const bool fromP = patch_.irregular[p] == 0;
    const std::uint32_t qCorner =
        patch_.twin[h] - patch_.twin[h] % 3 + (patch_.twin[h] % 3 + 2) % 3;
    return fromP ? hasNeighbour(corner, q) : hasNeighbour(qCorner, p);
  }

  [[nodiscard]] bool hasNeighbour(std::uint32_t start, std::uint32_t wanted) const {
    const auto previous = [](std::uint32_t h) { return h - h % 3 + (h % 3 + 2) % 3; };
    const auto next = [](std::uint32_t h) { return h - h % 3 + (h % 3 + 1) % 3; };
    for (std::uint32_t h = start;;) {
      if (patch_.endOf(h) == wanted || patch_.oppositeOf(h) == wanted) {
        return true;
      }
      h = patch_.twin[previous(h)];
      if (h == start) {
        return false;
      }
      if (h == kNone) {
        break;
      }
    }
    for (std::uint32_t h = start; patch_.twin[h] != kNone;) {
      h = next(patch_.twin[h]);
      if (patch_.endOf(h) == wanted || patch_.oppositeOf(h) == wanted) {
        return true;
      }
    }
    return false;
  }

  /// What a half-edge carries besides its vertices.
  struct Side {
    std::uint32_t twin = kNone;
    std::int32_t edge = -1;
    std::array<double, 2> param{0.0, 0.0};
  };

  [[nodiscard]] Side sideOf(std::uint32_t h) const {
    return patch_.exact()
               ? Side{patch_.twin[h], patch_.binding.edge[h], patch_.binding.edgeParam[h]}
               : Side{patch_.twin[h], -1, {0.0, 0.0}};
  }

  void setSide(std::uint32_t h, const Side& side) {
    patch_.twin[h] = side.twin;
    if (side.twin != kNone) {
      patch_.twin[side.twin] = h;
    }
    if (patch_.exact()) {
      patch_.binding.edge[h] = side.edge;
      patch_.binding.edgeParam[h] = side.param;
    }
  }

  /// Triangles (u,v,p) and (v,u,q) become (u,q,p) and (q,v,p).
  void doFlip(std::uint32_t h) {
    const std::uint32_t other = patch_.twin[h];
    const std::uint32_t a = h / 3;
    const std::uint32_t b = other / 3;
    const std::uint32_t u = patch_.startOf(h);
    const std::uint32_t v = patch_.endOf(h);
    const std::uint32_t p = patch_.oppositeOf(h);
    const std::uint32_t q = patch_.oppositeOf(other);
    const Side vp = sideOf(3 * a + (h % 3 + 1) % 3);
    const Side pu = sideOf(3 * a + (h % 3 + 2) % 3);
    const Side uq = sideOf(3 * b + (other % 3 + 1) % 3);
    const Side qv = sideOf(3 * b + (other % 3 + 2) % 3);
    if (patch_.exact()) {
      const auto uvA = patch_.binding.uv[a];
      const auto uvB = patch_.binding.uv[b];
      const Vec2 uvU = uvA[h % 3];
      const Vec2 uvV = uvA[(h % 3 + 1) % 3];
      const Vec2 uvP = uvA[(h % 3 + 2) % 3];
      const Vec2 uvQ = uvB[(other % 3 + 2) % 3];
      patch_.binding.uv[a] = {uvU, uvQ, uvP};
      patch_.binding.uv[b] = {uvQ, uvV, uvP};
    }
    patch_.mesh.triangles[a] = {u, q, p};
    patch_.mesh.triangles[b] = {q, v, p};
    setSide(3 * a, uq);
    setSide(3 * a + 2, pu);
    setSide(3 * b, qv);
    setSide(3 * b + 1, vp);
    setSide(3 * a + 1, {3 * b + 2, -1, {0.0, 0.0}});
    setSide(3 * b + 2, {3 * a + 1, -1, {0.0, 0.0}});
    if (patch_.exact()) {
      patch_.freePoles(a);
      patch_.freePoles(b);
    }
  }

  RefinePatch& patch_;
  double maxEdge_;
  std::optional<BrepEvaluator> evaluator_;
};

}  // namespace

void flipToDelaunay(RefinePatch& patch, double maxEdge, const JobContext& context) {
  Flipper(patch, maxEdge).run(context);
}

}  // namespace wcam::geometry
