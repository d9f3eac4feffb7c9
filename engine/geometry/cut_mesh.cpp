// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/cut_mesh.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/sha256.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace wcam::geometry {

namespace {

constexpr std::uint32_t kNone = HalfEdges::kNone;
/// Vertices nearer to a level than this part of the field's range lie on it.
constexpr double kSnap = 1e-9;

/// A corner of a new triangle.
struct Corner {
  std::uint32_t vertex = 0;
  Vec2 uv = Vec2::Zero();
};

/// What a half-edge of a new triangle inherits.
struct Side {
  std::int32_t edge = -1;
  std::array<double, 2> param{0.0, 0.0};
};

/// Cuts a surface at one level.
class LevelCut {
public:
  LevelCut(const PartSurface& surface, std::vector<double> field, double level)
      : in_(surface), level_(level) {
    out_.field = std::move(field);
    out_.surface.brep = surface.brep;
    out_.surface.mesh.vertices = surface.mesh.vertices;
    if (surface.exact()) {
      evaluator_.emplace(*surface.brep);
    }
    nodeOf_.assign(surface.halfEdges.edgeCount(), kNone);
  }

  CutSurface run() {
    for (std::uint32_t t = 0; t < in_.mesh.triangles.size(); ++t) {
      splitTriangle(t);
    }
    out_.surface.halfEdges = HalfEdges(out_.surface.mesh);
    return std::move(out_);
  }

private:
  [[nodiscard]] int sideOf(std::uint32_t vertex) const {
    const double value = out_.field[vertex];
    return value < level_ ? -1 : value > level_ ? 1 : 0;
  }

  [[nodiscard]] Corner corner(std::uint32_t t, std::uint32_t c) const {
    return {in_.mesh.triangles[t][c], in_.exact() ? in_.binding.uv[t][c] : Vec2(Vec2::Zero())};
  }

  [[nodiscard]] Side side(std::uint32_t h) const {
    return in_.exact() ? Side{in_.binding.edge[h], in_.binding.edgeParam[h]} : Side{};
  }

  [[nodiscard]] std::uint32_t startOf(std::uint32_t h) const {
    return in_.mesh.triangles[h / 3][h % 3];
  }

  [[nodiscard]] std::uint32_t endOf(std::uint32_t h) const {
    return in_.mesh.triangles[h / 3][(h % 3 + 1) % 3];
  }

  /// Fraction of the level from the start of a half-edge.
  [[nodiscard]] double along(std::uint32_t h) const {
    const double a = out_.field[startOf(h)];
    const double b = out_.field[endOf(h)];
    return (level_ - a) / (b - a);
  }

  /// (u,v) of a half-edge's node in its own face. On a CAD edge it is moved to where the surface
  /// meets the edge's point.
  [[nodiscard]] Vec2 uvAt(std::uint32_t h, const Vec3* onEdge) const {
    if (!in_.exact()) {
      return Vec2::Zero();
    }
    const std::uint32_t t = h / 3;
    const double w = along(h);
    Vec2 uv = (1.0 - w) * in_.binding.uv[t][h % 3] + w * in_.binding.uv[t][(h % 3 + 1) % 3];
    // The chord of a curved edge in (u,v) is off by its sagitta; Gauss-Newton takes that back.
    constexpr int kSteps = 5;
    for (int i = 0; onEdge != nullptr && i < kSteps; ++i) {
      const SurfacePoint s = evaluator_->surface(in_.binding.face[t], uv);
      Eigen::Matrix<double, 3, 2> jacobian;
      jacobian << s.du, s.dv;
      const Vec2 delta = jacobian.colPivHouseholderQr().solve(*onEdge - s.p);
      if (!delta.allFinite()) {
        break;
      }
      uv += delta;
    }
    return uv;
  }

  /// The new vertex on a half-edge's edge.
  std::uint32_t node(std::uint32_t h) {
    std::uint32_t& known = nodeOf_[in_.halfEdges.edgeOf(h)];
    if (known == kNone) {
      known = static_cast<std::uint32_t>(out_.surface.mesh.vertices.size());
      out_.surface.mesh.vertices.push_back(place(h));
      out_.field.push_back(level_);
    }
    return known;
  }

  [[nodiscard]] Vec3 place(std::uint32_t h) const {
    const double w = along(h);
    if (in_.exact()) {
      const Side s = side(h);
      return s.edge >= 0 ? evaluator_->curve(s.edge, (1.0 - w) * s.param[0] + w * s.param[1]).p
                         : evaluator_->surface(in_.binding.face[h / 3], uvAt(h, nullptr)).p;
    }
    // Counted from the lower vertex, so that both sides get the same digits.
    const auto& [a, b] = in_.halfEdges.edgeVertices(in_.halfEdges.edgeOf(h));
    const double v = (level_ - out_.field[a]) / (out_.field[b] - out_.field[a]);
    return (1.0 - v) * in_.mesh.vertices[a] + v * in_.mesh.vertices[b];
  }

  Corner nodeCorner(std::uint32_t h) {
    const std::uint32_t vertex = node(h);
    const bool onEdge = in_.exact() && in_.binding.edge[h] >= 0;
    return {vertex, uvAt(h, onEdge ? &out_.surface.mesh.vertices[vertex] : nullptr)};
  }

  /// The two parts of a half-edge that the level cuts.
  [[nodiscard]] std::array<Side, 2> halves(std::uint32_t h) const {
    const Side whole = side(h);
    if (whole.edge < 0) {
      return {whole, whole};
    }
    const double w = along(h);
    const double middle = (1.0 - w) * whole.param[0] + w * whole.param[1];
    return {Side{whole.edge, {whole.param[0], middle}}, Side{whole.edge, {middle, whole.param[1]}}};
  }

  void add(std::uint32_t parent,
           const std::array<Corner, 3>& corners,
           const std::array<Side, 3>& sides) {
    BrepBinding& binding = out_.surface.binding;
    out_.surface.mesh.triangles.push_back(
        {corners[0].vertex, corners[1].vertex, corners[2].vertex});
    if (in_.exact()) {
      binding.face.push_back(in_.binding.face[parent]);
      binding.uv.push_back({corners[0].uv, corners[1].uv, corners[2].uv});
      for (const Side& s : sides) {
        binding.edge.push_back(s.edge);
        binding.edgeParam.push_back(s.param);
      }
    }
  }

  void splitTriangle(std::uint32_t t) {
    std::array<int, 3> sides{};
    for (std::uint32_t c = 0; c < 3; ++c) {
      sides[c] =
          std::isnan(out_.field[in_.mesh.triangles[t][c]]) ? 2 : sideOf(in_.mesh.triangles[t][c]);
    }
    std::array<bool, 3> cut{};
    std::uint32_t cuts = 0;
    for (std::uint32_t c = 0; c < 3; ++c) {
      cut[c] = sides[c] * sides[(c + 1) % 3] == -1;
      cuts += cut[c] ? 1U : 0U;
    }
    const bool outside = sides[0] == 2 || sides[1] == 2 || sides[2] == 2;
    if (cuts == 0 || outside) {
      add(t, {corner(t, 0), corner(t, 1), corner(t, 2)},
          {side(3 * t), side(3 * t + 1), side(3 * t + 2)});
    } else if (cuts == 1) {
      const std::uint32_t c = cut[0] ? 0 : cut[1] ? 1 : 2;
      splitInTwo(t, c);
    } else {
      const std::uint32_t whole = !cut[0] ? 0 : !cut[1] ? 1 : 2;
      splitInThree(t, whole);
    }
  }

  /// Half-edge c is cut and the corner opposite to it lies on the level.
  void splitInTwo(std::uint32_t t, std::uint32_t c) {
    const std::uint32_t n = (c + 1) % 3;
    const std::uint32_t p = (c + 2) % 3;
    const Corner middle = nodeCorner(3 * t + c);
    const std::array<Side, 2> half = halves(3 * t + c);
    add(t, {corner(t, c), middle, corner(t, p)}, {half[0], Side{}, side(3 * t + p)});
    add(t, {middle, corner(t, n), corner(t, p)}, {half[1], side(3 * t + n), Side{}});
  }

  /// Half-edge c is whole, the two others are cut.
  void splitInThree(std::uint32_t t, std::uint32_t c) {
    const std::uint32_t n = (c + 1) % 3;
    const std::uint32_t p = (c + 2) % 3;
    const Corner first = nodeCorner(3 * t + n);   // from the end of c to the apex
    const Corner second = nodeCorner(3 * t + p);  // from the apex to the start of c
    const std::array<Side, 2> rising = halves(3 * t + n);
    const std::array<Side, 2> falling = halves(3 * t + p);
    add(t, {first, corner(t, p), second}, {rising[1], falling[0], Side{}});
    const Corner a = corner(t, c);
    const Corner b = corner(t, n);
    const auto at = [&](const Corner& k) { return out_.surface.mesh.vertices[k.vertex]; };
    // The shorter diagonal; ties the same way for every numbering of the corners do not matter,
    // since the quadrangle is inside one triangle.
    if ((at(a) - at(first)).squaredNorm() <= (at(b) - at(second)).squaredNorm()) {
      add(t, {a, b, first}, {side(3 * t + c), rising[0], Side{}});
      add(t, {a, first, second}, {Side{}, Side{}, falling[1]});
    } else {
      add(t, {a, b, second}, {side(3 * t + c), Side{}, falling[1]});
      add(t, {b, first, second}, {rising[0], Side{}, Side{}});
    }
  }

  const PartSurface& in_;
  double level_;
  CutSurface out_;
  std::optional<BrepEvaluator> evaluator_;
  std::vector<std::uint32_t> nodeOf_;  ///< per edge
};

std::pair<double, double> rangeOf(const std::vector<double>& field) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double value : field) {
    if (std::isfinite(value)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  return {low, high};
}

}  // namespace

SubSurface keepTriangles(const PartSurface& surface, const std::vector<bool>& keep) {
  WCAM_ASSERT(keep.size() == surface.mesh.triangles.size());
  SubSurface result;
  PartSurface& part = result.surface;
  part.brep = surface.brep;
  std::vector<std::uint32_t> newIndex(surface.mesh.vertices.size(), kNone);
  Sha256 hash;
  hash.text("triangles").text(surface.hash);
  for (std::size_t t = 0; t < keep.size(); ++t) {
    if (!keep[t]) {
      continue;
    }
    hash.integer(static_cast<std::int64_t>(t));
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t v = surface.mesh.triangles[t][c];
      if (newIndex[v] == kNone) {
        newIndex[v] = static_cast<std::uint32_t>(result.vertexOf.size());
        result.vertexOf.push_back(v);
        part.mesh.vertices.push_back(surface.mesh.vertices[v]);
      }
      corners[c] = newIndex[v];
    }
    part.mesh.triangles.push_back(corners);
    if (surface.exact()) {
      part.binding.face.push_back(surface.binding.face[t]);
      part.binding.uv.push_back(surface.binding.uv[t]);
      for (std::size_t h = 3 * t; h < 3 * t + 3; ++h) {
        part.binding.edge.push_back(surface.binding.edge[h]);
        part.binding.edgeParam.push_back(surface.binding.edgeParam[h]);
      }
    }
  }
  part.halfEdges = HalfEdges(part.mesh);
  part.hash = hash.hex();
  return result;
}

CutSurface cutAtLevels(const PartSurface& surface,
                       const std::vector<double>& field,
                       const std::vector<double>& levels) {
  if (field.size() != surface.mesh.vertices.size()) {
    throw Error(ErrorCode::InvalidArgument, "the field must have one value per vertex",
                "cut at levels");
  }
  const auto [low, high] = rangeOf(field);
  const double snap = kSnap * (high - low);
  CutSurface cut{surface, field};
  for (const double level : levels) {
    for (double& value : cut.field) {
      value = std::abs(value - level) <= snap ? level : value;
    }
    CutSurface next = LevelCut(cut.surface, cut.field, level).run();
    next.surface.hash = cut.surface.hash;
    cut = std::move(next);
  }
  return cut;
}

}  // namespace wcam::geometry
