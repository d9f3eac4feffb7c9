// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/collision/cell_collision.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/parallel.hpp"

#include "deposit.hpp"
#include "overlap.hpp"
#include "scene.hpp"
#include "standing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::collision {

namespace {

using detail::BodyPoses;
using detail::CoverSphere;
using detail::Item;
using detail::Pair;
using geometry::Pose;
using geometry::Vec3;

constexpr std::size_t kGrain = 64;
/// Overlaps smaller than this are contacts that rounding makes (a bead's top in the plane of the
/// nozzle's end), mm.
constexpr double kTouch = 1e-6;
/// Balls of the deposit that stand for it against the fixed cell.
constexpr std::size_t kDepositBalls = 64;
/// The exact stage looks this much farther than the safety distance, mm: beyond it a state that the
/// grids could not free is free enough.
constexpr double kRefinedReach = 10.0;
/// Spheres up to this radius use the fine grid; larger ones (links) a coarse one, mm.
constexpr double kFineRadius = 32.0;

/// The part as it grows, in its own frame: shared by all places where the part is put.
struct DepositModel {
  std::vector<DepositRod> rods;
  detail::DepositTree tree;
  std::vector<detail::DepositTree::Ball> balls;
  detail::DepositField fine;
  detail::DepositField coarse;
  Vec3 centre = Vec3::Zero();  ///< of the ball around the whole deposit
  double ball = 0.0;
};

/// Big boxes and the like are no good as spheres: the deposit's balls are taken to them.
bool takesBalls(const Item& item) {
  return item.kind == BodyKind::Obstacle || item.kind == BodyKind::Positioner ||
         (item.kind == BodyKind::Robot && item.body == 0);
}

std::shared_ptr<const DepositModel> depositModel(const toolpath::Toolpath& path,
                                                 const detail::Scene& scene,
                                                 const CollisionSettings& settings,
                                                 const JobContext& context) {
  auto model = std::make_shared<DepositModel>();
  model->rods = depositRods(path);
  if (scene.items().empty() || model->rods.empty()) {
    return model;
  }
  model->tree = detail::DepositTree(model->rods);
  model->balls = model->tree.balls(kDepositBalls);
  const auto whole = model->tree.balls(1);
  model->centre = whole[0].centre;
  model->ball = whole[0].radius;
  double least = std::numeric_limits<double>::infinity();
  double greatestFine = 0.0;
  double greatest = 0.0;
  for (const int i : scene.all().againstPart) {
    const Item& item = scene.items()[static_cast<std::size_t>(i)];
    if (takesBalls(item)) {
      continue;
    }
    for (const CoverSphere& sphere : item.cover) {
      least = std::min(least, sphere.radius);
      greatest = std::max(greatest, sphere.radius);
      if (sphere.radius <= kFineRadius) {
        greatestFine = std::max(greatestFine, sphere.radius);
      }
    }
  }
  const double margin = settings.safetyDistance;
  if (greatestFine > 0.0) {
    // From a little below the least distance that frees a sphere: nearer ones are asked exactly.
    const double near = std::max(0.5 * least, 0.5);
    const double far = greatestFine + margin + 0.25 * settings.reach;
    model->fine = detail::DepositField(model->rods, near, far, settings.maxVoxels, context);
  }
  if (greatest > kFineRadius) {
    model->coarse =
        detail::DepositField(model->rods, 0.75 * kFineRadius, greatest + margin + settings.reach,
                             settings.maxVoxels / 4, context);
  }
  return model;
}

}  // namespace

struct CellCollision::Impl {
  CollisionSettings settings;
  detail::Scene scene;
  std::shared_ptr<const DepositModel> deposit;

  /// What evaluate() works with for one state.
  struct Placed {
    BodyPoses bodies;
    BodyPoses inverses;         ///< of the bodies that are taken as fields
    BodyPoses inPart;           ///< of the bodies that are compared with the deposit
    std::vector<Vec3> centres;  ///< of the items' balls, base frame
    Pose T_part_base = Pose::Identity();
    std::uint32_t deposited = 0;
  };

  void place(const CellState& state, Placed& placed) const {
    scene.place(state.joints.data(), placed.bodies);
    placed.T_part_base =
        (placed.bodies[static_cast<std::size_t>(scene.partBody())] * scene.T_body_part())
            .inverse(Eigen::Isometry);
    finish(state.deposited, scene.all(), placed);
  }

  /// The torch alone at a pose of the tool in the part.
  void place(const ToolState& state, Placed& placed) const {
    // The part's body puts the base into the part frame, the torch's body follows from the TCP; no
    // other body is looked at.
    placed.bodies[static_cast<std::size_t>(scene.partBody())] = scene.T_part_body();
    placed.bodies[static_cast<std::size_t>(scene.torchBody())] =
        state.T_part_tcp * scene.T_tcp_body();
    placed.T_part_base = Pose::Identity();
    finish(state.deposited, scene.torch(), placed);
  }

  void finish(std::size_t deposited, const detail::Selection& of, Placed& placed) const {
    placed.deposited =
        static_cast<std::uint32_t>(std::min<std::size_t>(deposited, detail::kNever - 1));
    for (const int body : of.partBodies) {
      const auto k = static_cast<std::size_t>(body);
      placed.inPart[k] = placed.T_part_base * placed.bodies[k];
    }
    for (const int body : of.bodies) {
      const auto k = static_cast<std::size_t>(body);
      placed.inverses[k] = placed.bodies[k].inverse(Eigen::Isometry);
    }
    placed.centres.resize(scene.items().size());
    for (const int i : of.items) {
      const Item& item = scene.items()[static_cast<std::size_t>(i)];
      placed.centres[static_cast<std::size_t>(i)] = bodyOf(placed, item) * item.centre;
    }
  }

  [[nodiscard]] static const Pose& bodyOf(const Placed& placed, const Item& item) {
    return placed.bodies[static_cast<std::size_t>(item.body)];
  }

  [[nodiscard]] static float fieldDistance(const Item& item, const Vec3& p) {
    return item.isMesh() ? item.field->distance(p)
                         : static_cast<float>(detail::signedDistance(item.solid, p));
  }

  /// Lower bound of the distance of two items, no better than `limit`.
  [[nodiscard]] float boundOf(const Placed& placed, const Pair& pair, float limit) const {
    const Item& spheres = scene.items()[static_cast<std::size_t>(pair.spheres)];
    const Item& field = scene.items()[static_cast<std::size_t>(pair.field)];
    const Vec3& centre = placed.centres[static_cast<std::size_t>(pair.spheres)];
    const double apart = limit + spheres.ball + field.ball;
    if (apart <= 0.0 ||
        (centre - placed.centres[static_cast<std::size_t>(pair.field)]).squaredNorm() >=
            apart * apart) {
      return limit;
    }
    const Pose& T_fieldBody_base = placed.inverses[static_cast<std::size_t>(field.body)];
    if (fieldDistance(field, field.T_shape_body * (T_fieldBody_base * centre)) - spheres.ball >=
        limit) {
      return limit;
    }
    const Pose T_field_a = field.T_shape_body * (T_fieldBody_base * bodyOf(placed, spheres));
    float least = limit;
    for (const CoverSphere& sphere : spheres.cover) {
      least = std::min(least, fieldDistance(field, T_field_a * sphere.centre) -
                                  static_cast<float>(sphere.radius));
    }
    return least;
  }

  /// The same for an item and the deposit; ends as soon as it falls below `stop`.
  [[nodiscard]] float partBound(const Placed& placed,
                                const Item& item,
                                float limit,
                                float stop = -std::numeric_limits<float>::infinity()) const {
    if (deposit->rods.empty()) {
      return limit;
    }
    const Pose& T_part_body = placed.inPart[static_cast<std::size_t>(item.body)];
    const double apart = limit + item.ball + deposit->ball;
    if (apart <= 0.0 ||
        (T_part_body * item.centre - deposit->centre).squaredNorm() >= apart * apart) {
      return limit;
    }
    float least = limit;
    if (takesBalls(item)) {
      const Pose T_shape_part = item.T_shape_body * T_part_body.inverse(Eigen::Isometry);
      for (const auto& ball : deposit->balls) {
        if (ball.order <= placed.deposited) {
          least = std::min(least, fieldDistance(item, T_shape_part * ball.centre) -
                                      static_cast<float>(ball.radius));
        }
      }
      return least;
    }
    // Floats are good for what the grids allow for.
    const Eigen::Matrix3f turn = T_part_body.linear().cast<float>();
    const Eigen::Vector3f move = T_part_body.translation().cast<float>();
    if (item.ball > kFineRadius && !deposit->coarse.empty() &&
        deposit->coarse.distance(turn * item.centre.cast<float>() + move, placed.deposited) -
                static_cast<float>(item.ball) >=
            least) {
      return least;
    }
    // Spheres follow one another along the shape: what the distance at the last one that was looked
    // up leaves to the next one often does without a look-up, and without changing the least.
    Eigen::Vector3f known = Eigen::Vector3f::Zero();
    float knownDistance = -std::numeric_limits<float>::infinity();
    for (const CoverSphere& sphere : item.cover) {
      const auto radius = static_cast<float>(sphere.radius);
      const Eigen::Vector3f centre = sphere.centre.cast<float>();
      const float left = knownDistance - radius - least;
      if (left >= 0.0F && (centre - known).squaredNorm() <= left * left) {
        continue;
      }
      const detail::DepositField& field =
          sphere.radius <= kFineRadius ? deposit->fine : deposit->coarse;
      known = centre;
      knownDistance = field.distance(turn * centre + move, placed.deposited);
      least = std::min(least, knownDistance - radius);
      if (least < stop) {
        return least;
      }
    }
    return least;
  }

  /// Bound over everything of a selection by the grids alone; negative as soon as anything is not
  /// free.
  [[nodiscard]] float coarseClearance(const Placed& placed, const detail::Selection& of) const {
    const auto safety = static_cast<float>(settings.safetyDistance);
    float least = static_cast<float>(settings.reach) + safety;
    for (const int i : of.againstPart) {
      least = partBound(placed, scene.items()[static_cast<std::size_t>(i)], least, safety);
      if (least < safety) {
        return least - safety;
      }
    }
    for (const Pair& pair : of.pairs) {
      least = boundOf(placed, pair, least);
      if (least < safety) {
        break;
      }
    }
    return least - safety;
  }

  /// @param bound from the grids: how deep deep solids overlap, FCL only guesses
  [[nodiscard]] detail::ExactDistance pairDistance(const Placed& placed,
                                                   const Pair& pair,
                                                   float bound) const {
    detail::ExactDistance found = pairDistance(placed, pair);
    found.value = std::max(found.value, static_cast<double>(bound) - kTouch);
    return found;
  }

  [[nodiscard]] detail::ExactDistance pairDistance(const Placed& placed, const Pair& pair) const {
    const Item& a = scene.items()[static_cast<std::size_t>(pair.spheres)];
    const Item& b = scene.items()[static_cast<std::size_t>(pair.field)];
    const Pose T_a = bodyOf(placed, a) * a.T_body_shape;
    const Pose T_b = bodyOf(placed, b) * b.T_body_shape;
    for (const auto& [rod, T_rod, other, T_other] :
         {std::tuple{&a, &T_a, &b, &T_b}, std::tuple{&b, &T_b, &a, &T_a}}) {
      const bool round =
          rod->shape.kind == cell::ShapeKind::Sphere || rod->shape.kind == cell::ShapeKind::Capsule;
      if (round && !other->isMesh()) {
        const Pose T_other_rod = T_other->inverse(Eigen::Isometry) * *T_rod;
        const Vec3 end(0, 0, 0.5 * rod->shape.length);
        const detail::RodDistance found = detail::rodDistance(
            other->solid, {T_other_rod * Vec3(-end), T_other_rod * end, rod->shape.radius});
        return {found.value, *T_other * found.point};
      }
      if (rod->isMesh()) {
        const Vec3 inside = T_rod->inverse(Eigen::Isometry) * T_other->translation();
        if (rod->field->inside(inside)) {
          return {static_cast<double>(rod->field->distance(inside)), T_other->translation()};
        }
      }
    }
    return detail::exactDistance(a.exact, T_a, b.exact, T_b);
  }

  /// The nearest rod to an item below `limit`; material of the contact zone that does not touch is
  /// left out for the torch.
  [[nodiscard]] detail::DepositTree::Hit partDistance(const Placed& placed,
                                                      const Item& item,
                                                      double limit) const {
    const Pose& T_part_body = placed.inPart[static_cast<std::size_t>(item.body)];
    const Pose T_part_shape = T_part_body * item.T_body_shape;
    if (item.isMesh()) {
      return meshToPart(placed, item, T_part_shape, limit);
    }
    if (item.kind != BodyKind::Torch) {
      return deposit->tree.nearest(item.solid, T_part_shape, placed.deposited, limit);
    }
    return deposit->tree.nearest(item.solid, T_part_shape, placed.deposited, limit,
                                 contactZone(placed));
  }

  [[nodiscard]] std::function<bool(const DepositRod&, double)> contactZone(
      const Placed& placed) const {
    const Pose T_part_tcp = placed.T_part_base * scene.T_base_tcp(placed.bodies);
    const Vec3 axis = T_part_tcp.linear().col(2);
    const double level = axis.dot(T_part_tcp.translation()) + kTouch;
    return [axis, level](const DepositRod& rod, double distance) {
      return distance >= -kTouch &&
             std::max(rod.a.dot(axis), rod.b.dot(axis)) + rod.radius <= level;
    };
  }

  /// A mesh against the rods that its grid cannot rule out, the likely ones first.
  [[nodiscard]] detail::DepositTree::Hit meshToPart(const Placed& placed,
                                                    const Item& item,
                                                    const Pose& T_part_shape,
                                                    double limit) const {
    detail::DepositTree::Hit best;
    best.distance = limit;
    const Pose T_shape_part = T_part_shape.inverse(Eigen::Isometry);
    std::vector<std::pair<double, std::uint32_t>> likely;
    deposit->tree.visit(T_part_shape * (item.T_shape_body * item.centre), item.ball + limit,
                        placed.deposited, [&](std::uint32_t k) {
                          const DepositRod& rod = deposit->rods[k];
                          const Vec3 middle = T_shape_part * Vec3(0.5 * (rod.a + rod.b));
                          const double bound = item.field->distance(middle) - rod.radius -
                                               0.5 * (rod.b - rod.a).norm();
                          if (item.field->inside(middle)) {
                            likely.emplace_back(bound - item.ball, k);
                          } else if (bound < limit) {
                            likely.emplace_back(bound, k);
                          }
                        });
    std::sort(likely.begin(), likely.end());
    const auto zone = contactZone(placed);
    for (const auto& [bound, k] : likely) {
      if (bound >= best.distance) {
        break;
      }
      const detail::Rod rod{deposit->rods[k].a, deposit->rods[k].b, deposit->rods[k].radius};
      detail::ExactDistance found = detail::exactDistance(
          item.exact, T_part_shape, detail::ExactShape(rod), detail::poseOf(rod));
      const Vec3 middle = 0.5 * (rod.a + rod.b);
      if (item.field->inside(T_shape_part * middle)) {
        found = {-rod.radius, middle};
      }
      const bool waived = item.kind == BodyKind::Torch && zone(deposit->rods[k], found.value);
      if (found.value < best.distance && !waived) {
        best = {found.value, found.point, k};
      }
    }
    return best;
  }

  /// Exact where the grids cannot free.
  [[nodiscard]] float refinedClearance(const Placed& placed, const detail::Selection& of) const {
    const double safety = settings.safetyDistance;
    double least = settings.reach + safety;
    const auto wanted = static_cast<float>(safety);
    for (const int i : of.againstPart) {
      const Item& item = scene.items()[static_cast<std::size_t>(i)];
      const float known = static_cast<float>(least);
      const float bound = partBound(placed, item, known);
      if (bound < std::min(known, wanted)) {
        // No farther than it is worth knowing.
        const double limit = std::min(least, safety + kRefinedReach);
        least = std::min(least, partDistance(placed, item, limit).distance);
      } else {
        least = std::min(least, static_cast<double>(bound));
      }
    }
    for (const Pair& pair : of.pairs) {
      const float known = static_cast<float>(least);
      const float bound = boundOf(placed, pair, known);
      least =
          std::min(least, bound < std::min(known, wanted) ? pairDistance(placed, pair, bound).value
                                                          : static_cast<double>(bound));
    }
    // Rounded down: what is just free by rounding is not called free.
    return static_cast<float>(least - safety - kTouch);
  }

  template <class State>
  void evaluate(std::span<const State> states,
                std::span<float> clearance,
                const detail::Selection& of) const {
    WCAM_ASSERT(states.size() == clearance.size());
    parallelForChunks(states.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      Placed placed;
      for (std::size_t i = begin; i < end; ++i) {
        place(states[i], placed);
        clearance[i] = coarseClearance(placed, of);
        if (clearance[i] < 0.0F && settings.refine) {
          // The bound of the grids ends at the first thing that is not free: it bounds nothing
          // else.
          clearance[i] = refinedClearance(placed, of);
        }
      }
    });
  }

  [[nodiscard]] std::vector<Contact> contacts(const Placed& placed,
                                              double within,
                                              const detail::Selection& of) const {
    const auto limit = static_cast<float>(within);
    std::vector<Contact> result;
    for (const int i : of.againstPart) {
      const Item& item = scene.items()[static_cast<std::size_t>(i)];
      if (partBound(placed, item, limit) >= limit) {
        continue;
      }
      auto hit = partDistance(placed, item, within);
      if (hit.rod != detail::kNever) {
        if (hit.distance < 0.0 && !item.isMesh()) {
          const DepositRod& deposited = deposit->rods[hit.rod];
          const detail::Rod rod{deposited.a, deposited.b, deposited.radius};
          const Pose& T_part_body = placed.inPart[static_cast<std::size_t>(item.body)];
          hit.distance =
              -std::max(detail::leastTranslation(item.solid, T_part_body * item.T_body_shape,
                                                 detail::primitiveOf(rod), detail::poseOf(rod))
                            .depth,
                        0.0);
        }
        result.push_back({item.label, "part", item.kind, BodyKind::Part, hit.distance, hit.point,
                          static_cast<std::ptrdiff_t>(hit.rod)});
      }
    }
    for (const Pair& pair : of.pairs) {
      const float bound = boundOf(placed, pair, limit);
      if (bound >= limit) {
        continue;
      }
      auto found = pairDistance(placed, pair, bound);
      if (found.value < within) {
        const Item& spheres = scene.items()[static_cast<std::size_t>(pair.spheres)];
        const Item& field = scene.items()[static_cast<std::size_t>(pair.field)];
        if (found.value < 0.0 && !spheres.isMesh() && !field.isMesh()) {
          found.value = -std::max(detail::leastTranslation(
                                      spheres.solid, bodyOf(placed, spheres) * spheres.T_body_shape,
                                      field.solid, bodyOf(placed, field) * field.T_body_shape)
                                      .depth,
                                  0.0);
        }
        // The torch first, the substrate last.
        const int low = std::min(pair.spheres, pair.field);
        const int high = std::max(pair.spheres, pair.field);
        const Item& a = scene.items()[static_cast<std::size_t>(low)];
        const Item& b = scene.items()[static_cast<std::size_t>(high)];
        result.push_back(
            {a.label, b.label, a.kind, b.kind, found.value, placed.T_part_base * found.point, -1});
      }
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const Contact& a, const Contact& b) { return a.distance < b.distance; });
    return result;
  }
};

CellCollision::CellCollision(const cell::Cell& cell,
                             const toolpath::Toolpath& path,
                             const toolpath::Substrate* substrate,
                             const CollisionSettings& settings,
                             const JobContext& context)
    : impl_(std::make_unique<Impl>(
          Impl{settings, detail::Scene(cell, substrate, settings, context), nullptr})) {
  impl_->deposit = depositModel(path, impl_->scene, settings, context);
}

CellCollision::CellCollision(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

std::unique_ptr<CellCollision> CellCollision::moved(const geometry::Pose& T_table_part) const {
  return std::unique_ptr<CellCollision>(new CellCollision(std::make_unique<Impl>(
      Impl{impl_->settings, impl_->scene.moved(T_table_part), impl_->deposit})));
}

CellCollision::~CellCollision() = default;

bool CellCollision::anything() const {
  return !impl_->scene.items().empty();
}

const CollisionSettings& CellCollision::settings() const {
  return impl_->settings;
}

const std::vector<DepositRod>& CellCollision::deposit() const {
  return impl_->deposit->rods;
}

void CellCollision::evaluate(std::span<const CellState> states, std::span<float> clearance) const {
  impl_->evaluate(states, clearance, impl_->scene.all());
}

void CellCollision::evaluateTorch(std::span<const ToolState> states,
                                  std::span<float> clearance) const {
  impl_->evaluate(states, clearance, impl_->scene.torch());
}

std::vector<Contact> CellCollision::contacts(const CellState& state, double within) const {
  Impl::Placed placed;
  impl_->place(state, placed);
  return impl_->contacts(placed, within, impl_->scene.all());
}

std::vector<Contact> CellCollision::torchContacts(const ToolState& state, double within) const {
  Impl::Placed placed;
  impl_->place(state, placed);
  return impl_->contacts(placed, within, impl_->scene.torch());
}

std::vector<StandingContact> CellCollision::standingContacts(const toolpath::Toolpath& path,
                                                             std::span<const CellState> states,
                                                             const JobContext& context) const {
  return detail::standingContacts(impl_->scene, path, states, context);
}

std::vector<PlacedShape> CellCollision::placedShapes(const cell::JointVector& joints) const {
  BodyPoses bodies;
  impl_->scene.place(joints.data(), bodies);
  std::vector<PlacedShape> result;
  for (const Item& item : impl_->scene.items()) {
    result.push_back({&item.shape, item.kind, item.label,
                      bodies[static_cast<std::size_t>(item.body)] * item.T_body_shape});
  }
  return result;
}

bool CellCollision::compares(std::ptrdiff_t first, std::ptrdiff_t second) const {
  if (first < 0 || second < 0) {
    const auto other = static_cast<int>(std::max(first, second));
    const std::vector<int>& list = impl_->scene.all().againstPart;
    return std::find(list.begin(), list.end(), other) != list.end();
  }
  return std::any_of(impl_->scene.all().pairs.begin(), impl_->scene.all().pairs.end(),
                     [&](const Pair& pair) {
                       return (pair.spheres == first && pair.field == second) ||
                              (pair.spheres == second && pair.field == first);
                     });
}

}  // namespace wcam::collision
