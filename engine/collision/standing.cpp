// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "standing.hpp"

#include "wcam/base/quantity.hpp"
#include "wcam/geometry/aabb_tree.hpp"

#include "overlap.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>

namespace wcam::collision::detail {

namespace {

/// Positions of a joint that are told apart: rad, mm.
const double kTurn = degToRad(1.0);
constexpr double kStroke = 2.0;
/// Points of a solid that are taken to a mesh: so many along each of its sides.
constexpr int kLattice = 16;
/// Triangles are looked at in pieces down to this part of the smaller body.
constexpr double kPiece = 1.0 / 16.0;
constexpr int kMostSplits = 6;
/// A bead's section in round rods side by side, at most.
constexpr int kMostRods = 8;
/// Beads whose path knows neither width nor height, mm.
constexpr double kUnknownSize = 2.0;
constexpr std::size_t kCheckEvery = 4096;

/// Where the part is against an item: the item's shape in the part frame, and how much is
/// deposited by then.
struct Position {
  Pose T_part_shape = Pose::Identity();
  std::size_t deposited = 0;
};

/// The depth to which something reaches into an item.
struct Depth {
  double value = 0.0;
  Vec3 point = Vec3::Zero();  ///< part frame
  Vec3 way = Vec3::Zero();
};

/// A shape as the signed distance from it and points that stand for it, in its own frame.
class Body {
public:
  explicit Body(const Item& item) : item_(item) {
    if (item.isMesh()) {
      tree_ = std::make_shared<const geometry::AabbTree>(*item.shape.mesh);
    }
  }

  /// Negative inside. A mesh is entered a voxel of its grid below its surface.
  [[nodiscard]] double distance(const Vec3& p) const {
    if (!item_.isMesh()) {
      return signedDistance(item_.solid, p);
    }
    const auto nearest = tree_->closestPoint(p);
    const double away = nearest ? nearest->distance : item_.ball;
    return item_.field->inside(p) ? -away : away;
  }

  template <class Visit>
  void points(double fineness, const Visit& visit) const {
    if (item_.isMesh()) {
      const geometry::TriangleMesh& mesh = *item_.shape.mesh;
      for (const auto& t : mesh.triangles) {
        split(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]], fineness, kMostSplits,
              visit);
      }
      return;
    }
    const Vec3 half = halves();
    for (int x = 0; x <= kLattice; ++x) {
      for (int y = 0; y <= kLattice; ++y) {
        for (int z = 0; z <= kLattice; ++z) {
          const Vec3 p = half.cwiseProduct(Vec3(Vec3(x, y, z) * (2.0 / kLattice)) - Vec3::Ones());
          if (signedDistance(item_.solid, p) <= 0.0) {
            visit(p);
          }
        }
      }
    }
  }

private:
  [[nodiscard]] Vec3 halves() const {
    const Primitive& solid = item_.solid;
    if (solid.kind == ShapeKind::Box) {
      return solid.halves;
    }
    const double end = solid.kind == ShapeKind::Cylinder  ? solid.half
                       : solid.kind == ShapeKind::Capsule ? solid.half + solid.radius
                                                          : solid.radius;
    return {solid.radius, solid.radius, end};
  }

  template <class Visit>
  static void split(
      const Vec3& a, const Vec3& b, const Vec3& c, double fineness, int depth, const Visit& visit) {
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    if (longest <= fineness || depth == 0) {
      visit(a);
      visit(b);
      visit(c);
      visit(Vec3((a + b + c) / 3.0));
      return;
    }
    const Vec3 ab = 0.5 * (a + b);
    const Vec3 bc = 0.5 * (b + c);
    const Vec3 ca = 0.5 * (c + a);
    split(a, ab, ca, fineness, depth - 1, visit);
    split(ab, b, bc, fineness, depth - 1, visit);
    split(ca, bc, c, fineness, depth - 1, visit);
    split(ab, bc, ca, fineness, depth - 1, visit);
  }

  const Item& item_;
  std::shared_ptr<const geometry::AabbTree> tree_;
};

/// The positions that an item takes against the part: one where nothing moves between them, else
/// each that the joint between them reaches, with the most that is deposited there.
std::vector<Position> positionsOf(const Scene& scene,
                                  const Standing::With& with,
                                  std::span<const CellState> states,
                                  bool prismatic) {
  const Item& item = scene.items()[static_cast<std::size_t>(with.item)];
  if (with.joint < 0) {
    const std::size_t all = states.empty() ? 0 : states.back().deposited;
    return {{scene.T_part_body() * item.T_body_shape, std::max<std::size_t>(all, 1)}};
  }
  std::map<long, const CellState*> bins;
  for (const CellState& state : states) {
    const long bin = std::lround(state.joints(with.joint) / (prismatic ? kStroke : kTurn));
    const CellState*& own = bins[bin];
    own = own == nullptr || state.deposited >= own->deposited ? &state : own;
  }
  std::vector<Position> result;
  BodyPoses poses;
  for (const auto& [bin, state] : bins) {
    scene.place(state->joints.data(), poses);
    const Pose part = poses[static_cast<std::size_t>(scene.partBody())] * scene.T_body_part();
    result.push_back({part.inverse(Eigen::Isometry) * poses[static_cast<std::size_t>(item.body)] *
                          item.T_body_shape,
                      state->deposited});
  }
  return result;
}

/// Bodies of items, made when they are first asked for.
class Bodies {
public:
  explicit Bodies(const Scene& scene) : scene_(scene), bodies_(scene.items().size()) {}

  const Body& of(int item) {
    const auto k = static_cast<std::size_t>(item);
    if (!bodies_[k]) {
      bodies_[k].emplace(scene_.items()[k]);
    }
    return *bodies_[k];
  }

private:
  const Scene& scene_;
  std::vector<std::optional<Body>> bodies_;
};

Depth solidInSolid(const Item& a, const Pose& T_a, const Item& b, const Pose& T_b) {
  const Overlap found = leastTranslation(a.solid, T_a, b.solid, T_b, kStandingContact);
  return {found.depth, found.point, found.way};
}

/// The deepest of the points of one body in the other.
void pointsInBody(const Body& a,
                  const Pose& T_part_a,
                  double fineness,
                  const Body& b,
                  const Pose& T_part_b,
                  Depth& deepest) {
  const Pose T_b_a = T_part_b.inverse(Eigen::Isometry) * T_part_a;
  a.points(fineness, [&](const Vec3& p) {
    const double depth = -b.distance(T_b_a * p);
    if (depth > deepest.value) {
      deepest = {depth, T_part_a * p, Vec3::Zero()};
    }
  });
}

Depth depthOf(
    const Item& a, const Pose& T_a, const Item& b, const Pose& T_b, Bodies& bodies, int i, int k) {
  if (!a.isMesh() && !b.isMesh()) {
    return solidInSolid(a, T_a, b, T_b);
  }
  Depth deepest;
  const double fineness = 2.0 * kPiece * std::min(a.ball, b.ball);
  pointsInBody(bodies.of(i), T_a, fineness, bodies.of(k), T_b, deepest);
  pointsInBody(bodies.of(k), T_b, fineness, bodies.of(i), T_a, deepest);
  return deepest;
}

/// Centre of an item's ball with its shape at a pose.
Vec3 centreAt(const Item& item, const Pose& T_part_shape) {
  return T_part_shape * (item.T_shape_body * item.centre);
}

/// A piece of a bead with the section that it has.
struct Piece {
  std::vector<Rod> rods;
  Vec3 centre = Vec3::Zero();
  double reach = 0.0;
  std::size_t order = 0;
};

/// Round rods side by side, or one over the other, that fill the bead's width and height.
void sectionRods(const toolpath::PathPoint& from, const toolpath::PathPoint& to, Piece& piece) {
  const auto known = [](double a, double b) {
    const double least = std::min(a, b);
    return least > 0.0 ? least : std::max(a, b) > 0.0 ? std::max(a, b) : kUnknownSize;
  };
  const double width = known(from.width, to.width);
  const double height = known(from.height, to.height);
  const double radius = 0.5 * std::min(width, height);
  const bool wide = width > height;
  const double room = std::max(width, height) - 2.0 * radius;
  const int count = std::min(static_cast<int>(std::ceil(room / (2.0 * radius))) + 1, kMostRods);
  piece.rods.clear();
  for (int k = 0; k < count; ++k) {
    const double s = count > 1 ? static_cast<double>(k) / (count - 1) : 0.5;
    const double across = wide ? (s - 0.5) * room : 0.0;
    const double down = wide ? radius : radius + s * room;
    piece.rods.push_back(
        {from.p + across * from.n - down * from.b, to.p + across * to.n - down * to.b, radius});
  }
  const Vec3 middleFrom = from.p - 0.5 * height * from.b;
  const Vec3 middleTo = to.p - 0.5 * height * to.b;
  piece.centre = 0.5 * (middleFrom + middleTo);
  piece.reach = 0.5 * (middleTo - middleFrom).norm() + 0.5 * std::hypot(width, height);
}

template <class Visit>
void visitPieces(const toolpath::Toolpath& path, const Visit& visit) {
  Piece piece;
  for (const toolpath::Layer& layer : path.layers) {
    for (const toolpath::Bead& bead : layer.beads) {
      for (std::size_t i = 0; i < bead.points.size(); ++i) {
        ++piece.order;
        if (i > 0 && bead.points[i].arc) {
          sectionRods(bead.points[i - 1], bead.points[i], piece);
          visit(piece);
        }
      }
    }
  }
}

/// How deep a rod lies in a body: its axis less its radius; quick, never more than the overlap.
double rodDepth(const Item& item, const Body* mesh, const Rod& rod) {
  if (mesh == nullptr) {
    return -rodDistance(item.solid, rod).value;
  }
  const int steps = std::clamp(
      static_cast<int>(std::ceil((rod.b - rod.a).norm() / std::max(rod.radius, 0.1))), 1, 64);
  double depth = 0.0;
  for (int k = 0; k <= steps; ++k) {
    const Vec3 p = rod.a + (rod.b - rod.a) * (static_cast<double>(k) / steps);
    depth = std::max(depth, rod.radius - mesh->distance(p));
  }
  return depth;
}

void addBeads(const Scene& scene,
              const toolpath::Toolpath& path,
              const Standing::With& with,
              const std::vector<Position>& positions,
              Bodies& bodies,
              const JobContext& context,
              std::vector<StandingContact>& result) {
  const Item& item = scene.items()[static_cast<std::size_t>(with.item)];
  StandingContact found;
  std::vector<Vec3> centres;
  for (const Position& position : positions) {
    centres.push_back(centreAt(item, position.T_part_shape));
  }
  std::size_t count = 0;
  visitPieces(path, [&](const Piece& piece) {
    if (++count % kCheckEvery == 0) {
      context.check();
    }
    double deepest = 0.0;
    // A bead melts onto what it is laid on, and leans: its core must be inside.
    const double limit = std::max(kStandingContact, piece.rods.front().radius);
    for (std::size_t k = 0; k < positions.size(); ++k) {
      const Position& position = positions[k];
      const double apart = item.ball + piece.reach;
      // With one position alone everything is there in the end.
      if ((with.joint >= 0 && piece.order > position.deposited) ||
          (piece.centre - centres[k]).squaredNorm() >= apart * apart) {
        continue;
      }
      const Pose T_shape_part = position.T_part_shape.inverse(Eigen::Isometry);
      const Body* mesh = item.isMesh() ? &bodies.of(with.item) : nullptr;
      for (const Rod& rod : piece.rods) {
        const Rod own{T_shape_part * rod.a, T_shape_part * rod.b, rod.radius};
        const double depth = rodDepth(item, mesh, own);
        if (depth > deepest) {
          deepest = depth;
          if (depth > std::max(found.depth, limit)) {
            found.depth = depth;
            found.point = 0.5 * (rod.a + rod.b);
            found.beadPoint = piece.order - 1;
          }
        }
      }
    }
    found.points += deepest > limit ? 1 : 0;
  });
  if (found.points > 0) {
    found.first = "part";
    found.firstKind = BodyKind::Part;
    found.second = item.label;
    result.push_back(std::move(found));
  }
}

}  // namespace

std::vector<StandingContact> standingContacts(const Scene& scene,
                                              const toolpath::Toolpath& path,
                                              std::span<const CellState> states,
                                              const JobContext& context) {
  std::vector<StandingContact> result;
  Bodies bodies(scene);
  const Standing& standing = scene.standing();
  const auto positions = [&](const Standing::With& with) {
    return positionsOf(scene, with, states, with.joint >= 0 && scene.prismatic(with.joint));
  };
  for (const Standing::With& with : standing.withSubstrate) {
    context.check();
    const Item& substrate = scene.items()[static_cast<std::size_t>(standing.substrate)];
    const Item& item = scene.items()[static_cast<std::size_t>(with.item)];
    const Pose T_part_substrate = scene.T_part_body() * substrate.T_body_shape;
    StandingContact found;
    found.depth = kStandingContact;
    for (const Position& position : positions(with)) {
      const double apart = item.ball + substrate.ball;
      if ((centreAt(item, position.T_part_shape) - centreAt(substrate, T_part_substrate))
              .squaredNorm() >= apart * apart) {
        continue;
      }
      const Depth depth = depthOf(substrate, T_part_substrate, item, position.T_part_shape, bodies,
                                  standing.substrate, with.item);
      if (depth.value > found.depth) {
        found.depth = depth.value;
        found.point = depth.point;
        found.way = depth.way;
      }
    }
    if (found.depth > kStandingContact) {
      found.first = substrate.label;
      found.firstKind = BodyKind::Substrate;
      found.second = item.label;
      result.push_back(std::move(found));
    }
  }
  for (const Standing::With& with : standing.withPart) {
    addBeads(scene, path, with, positions(with), bodies, context, result);
  }
  return result;
}

}  // namespace wcam::collision::detail
