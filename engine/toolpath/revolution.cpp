// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/base/text.hpp"
#include "wcam/geometry/level_set.hpp"
#include "wcam/geometry/segment_tree.hpp"
#include "wcam/toolpath/iso_parametric.hpp"
#include "wcam/toolpath/onto_parts.hpp"
#include "wcam/toolpath/slice_field.hpp"

#include "level_curve.hpp"
#include "parallels.hpp"
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace wcam::toolpath {

using geometry::PartSurface;

namespace {

/// Distance of a mesh vertex from the profile, in parts of the part's size, up to which the part is
/// a body of revolution: exact parts by the sampling of the profile, meshes by their facets.
constexpr double kExactRoundness = 2e-4;
constexpr double kMeshRoundness = 5e-3;
/// A border that misses the last layer by less than this part of a step is that layer: profiles of
/// facets are a little shorter than their surface.
constexpr double kBorder = 0.01;
/// Mean sine between normals and the axis' half planes, above which no axis fits.
constexpr double kAxisFit = 0.05;
/// On the axis, in parts of the part's size.
constexpr double kTouch = 1e-6;
/// Above the substrate, in parts of the part's size: more than the precision of a mesh file.
constexpr double kAbove = 1e-5;
/// Chords per piece of the profile: arc lengths are then exact to some 1e-8.
constexpr int kChords = 64;
constexpr int kBisections = 60;

/// The plane through the axis that cuts out the profile.
class MeridianField : public LayerField {
public:
  MeridianField(const Axis& axis, const Vec3& across) : axis_(axis), across_(across) {}

  [[nodiscard]] double scalar(const Vec3& p) const override { return across_.dot(p - axis_.point); }

  [[nodiscard]] double residual(const Vec3& p, std::size_t) const override { return scalar(p); }

  [[nodiscard]] Vec3 gradient(const Vec3&, std::size_t) const override { return across_; }

private:
  Axis axis_;
  Vec3 across_;
};

/// A place on the profile.
struct ProfilePlace {
  std::size_t piece = 0;
  double w = 0.0;
};

/// A run of pieces of a meridian curve from the substrate on.
struct Profile {
  const LevelCurve* curve = nullptr;
  std::vector<std::size_t> pieces;
  bool backwards = false;

  [[nodiscard]] ContourPoint at(const ProfilePlace& place) const {
    return curve->at(pieces[place.piece], backwards ? 1.0 - place.w : place.w);
  }
};

/// The profiles of a part: the sections with half planes through the axis.
class Meridian {
public:
  /// @param radial unit vector across the axis: the half plane's side
  Meridian(const PartSurface& part,
           const Axis& axis,
           const Vec3& radial,
           const Substrate& substrate,
           const JobContext& context)
      : axis_(axis), size_(std::max(1.0, part.mesh.bounds().diagonal())), radial_(radial) {
    field_ = std::make_unique<MeridianField>(axis, axis.direction.cross(radial_));
    if (part.exact()) {
      evaluator_.emplace(*part.brep);
    }
    std::vector<double> scalar;
    scalar.reserve(part.mesh.vertices.size());
    for (const Vec3& v : part.mesh.vertices) {
      scalar.push_back(field_->scalar(v));
    }
    const std::vector<double> zero{0.0};
    constexpr double kSnap = 1e-12;
    const auto contours =
        geometry::traceLevels(part.mesh, part.halfEdges, scalar, zero, kSnap * size_, context);
    curves_.reserve(contours[0].size());
    for (const geometry::LevelContour& contour : contours[0]) {
      curves_.emplace_back(part, evaluator_ ? &*evaluator_ : nullptr, field_.get(), 0, size_);
      curves_.back().assign(contour);
    }
    for (const LevelCurve& curve : curves_) {
      addProfiles(curve, substrate);
    }
  }

  [[nodiscard]] const std::vector<Profile>& profiles() const { return profiles_; }

  [[nodiscard]] const Vec3& radial() const { return radial_; }

private:
  /// Runs of pieces on the radial side and above the substrate, turned to begin at their lower end.
  void addProfiles(const LevelCurve& curve, const Substrate& substrate) {
    const std::size_t n = curve.pieces();
    const double touch = kTouch * size_;
    std::vector<bool> inside(n);
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3 from = curve.at(i, 0.0).p;
      const Vec3 to = curve.at(i, 1.0).p;
      // What lies on the substrate, a flat bottom, is no wall.
      const bool above =
          std::max(substrate.heightAbove(from), substrate.heightAbove(to)) > kAbove * size_;
      inside[i] = above && radial_.dot(0.5 * (from + to) - axis_.point) > touch;
    }
    std::size_t first = 0;
    while (curve.closed() && first < n && inside[(first + n - 1) % n]) {
      ++first;
    }
    Profile run{&curve, {}, false};
    const auto finish = [&] {
      if (!run.pieces.empty()) {
        const Vec3 begin = curve.at(run.pieces.front(), 0.0).p;
        const Vec3 end = curve.at(run.pieces.back(), 1.0).p;
        run.backwards = substrate.heightAbove(end) < substrate.heightAbove(begin);
        if (run.backwards) {
          std::reverse(run.pieces.begin(), run.pieces.end());
        }
        profiles_.push_back(run);
      }
      run.pieces.clear();
    };
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = (first + k) % n;
      if (inside[i]) {
        run.pieces.push_back(i);
      } else {
        finish();
      }
    }
    finish();
  }

  Axis axis_;
  double size_;
  Vec3 radial_;
  std::unique_ptr<MeridianField> field_;
  std::optional<geometry::BrepEvaluator> evaluator_;
  std::vector<LevelCurve> curves_;
  std::vector<Profile> profiles_;
};

/// (radius, height along the axis).
geometry::Vec2 meridianPlace(const Axis& axis, const Vec3& p) {
  const Vec3 d = p - axis.point;
  const double z = d.dot(axis.direction);
  return {(d - z * axis.direction).norm(), z};
}

/// How far a part may be from a body of revolution, mm.
double roundnessOf(const PartSurface& part) {
  return (part.exact() ? kExactRoundness : kMeshRoundness) *
         std::max(1.0, part.mesh.bounds().diagonal());
}

/// Directions of half planes that may cut out the whole profile: a sector is not everywhere.
std::vector<Vec3> meridianDirections(const PartSurface& part, const Axis& axis) {
  // Off the directions in which seams and mesh vertices usually lie.
  constexpr double kTurn = 1.0;
  std::vector<Vec3> directions{Eigen::AngleAxisd(kTurn, axis.direction) *
                               axis.direction.unitOrthogonal()};
  Vec3 sum = Vec3::Zero();
  double area = 0.0;
  for (const auto& c : part.mesh.triangles) {
    const Vec3& a = part.mesh.vertices[c[0]];
    const Vec3 b = part.mesh.vertices[c[1]] - a;
    const Vec3 d = part.mesh.vertices[c[2]] - a;
    Vec3 spoke = a + (b + d) / 3.0 - axis.point;
    spoke -= spoke.dot(axis.direction) * axis.direction;
    if (spoke.norm() > 0.0) {
      const double share = 0.5 * b.cross(d).norm();
      sum += share * spoke.normalized();
      area += share;
    }
  }
  // Around a whole body the spokes cancel.
  constexpr double kCancelled = 0.05;
  if (sum.norm() > kCancelled * area) {
    directions.push_back(sum.normalized());
  }
  return directions;
}

/// Refuses a part whose vertices do not lie on its profiles turned about the axis.
/// @param inside looks at the middles of the triangles too: a half plane through the corners of a
/// prism meets all its vertices
void requireRevolution(const PartSurface& part,
                       const Axis& axis,
                       const Meridian& meridian,
                       bool inside) {
  std::vector<std::array<geometry::Vec2, 2>> segments;
  for (const Profile& profile : meridian.profiles()) {
    constexpr int kParts = 8;
    for (std::size_t i = 0; i < profile.pieces.size(); ++i) {
      geometry::Vec2 last = meridianPlace(axis, profile.at({i, 0.0}).p);
      for (int k = 1; k <= kParts; ++k) {
        const geometry::Vec2 next =
            meridianPlace(axis, profile.at({i, static_cast<double>(k) / kParts}).p);
        segments.push_back({last, next});
        last = next;
      }
    }
  }
  geometry::SegmentTree tree;
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto& s : segments) {
    tree.add({Vec3(s[0][0], 0.0, s[0][1]), Vec3(s[1][0], 0.0, s[1][1])}, false);
    lowest = std::min({lowest, s[0][1], s[1][1]});
  }
  tree.build();
  const double allowed = roundnessOf(part);
  std::vector<Vec3> places = part.mesh.vertices;
  for (std::size_t t = 0; inside && t < part.mesh.triangles.size(); ++t) {
    const auto& c = part.mesh.triangles[t];
    places.push_back(
        (part.mesh.vertices[c[0]] + part.mesh.vertices[c[1]] + part.mesh.vertices[c[2]]) / 3.0);
  }
  const double facets = kMeshRoundness * std::max(1.0, part.mesh.bounds().diagonal());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vec3& v = places[i];
    const geometry::Vec2 m = meridianPlace(axis, v);
    if (m[1] < lowest - allowed || m[1] <= lowest + allowed) {
      continue;  // below the substrate, or its flat bottom
    }
    const double d = tree.distance(Vec3(m[0], 0.0, m[1]));
    if (d > (i < part.mesh.vertices.size() ? allowed : facets)) {
      throw Error(
          ErrorCode::JobFailed,
          text("the part is no body of revolution: the point (%1, %2, %3) is %4 mm off the profile",
               {formatFixed(v.x(), 3), formatFixed(v.y(), 3), formatFixed(v.z(), 3),
                formatFixed(d, 3)}),
          "iso-parametric slicing", "give the right axis, or use another strategy");
    }
  }
}

/// Walks a profile in steps.
class ProfileWalk {
public:
  /// @param tolerance by which the last step may be short, mm: then it ends on the profile's end
  ProfileWalk(const Profile& profile, const Substrate& substrate, bool arcLength, double tolerance)
      : profile_(profile), arcLength_(arcLength), tolerance_(tolerance) {
    // A part that goes through the substrate begins on it.
    if (substrate.heightAbove(point().p) < 0.0) {
      double low = 0.0;
      double high = 1.0;
      for (int k = 0; k < kBisections; ++k) {
        const double middle = 0.5 * (low + high);
        (substrate.exactHeightAbove(profile_.at({0, middle}).p).value < 0.0 ? low : high) = middle;
      }
      place_.w = high;
    }
  }

  [[nodiscard]] ContourPoint point() const { return profile_.at(place_); }

  /// Travel direction along the profile.
  /// The walk stands on the profile's end, where the last step was a little short.
  [[nodiscard]] bool atEnd() const { return atEnd_; }

  [[nodiscard]] Vec3 direction() const {
    constexpr double kNear = 1e-3;
    ProfilePlace a = place_;
    ProfilePlace b = place_;
    a.w = std::max(0.0, place_.w - kNear);
    b.w = std::min(1.0, place_.w + kNear);
    return (profile_.at(b).p - profile_.at(a).p).normalized();
  }

  /// Moves on by a step; false when the profile ends before.
  bool advance(double step) {
    if (arcLength_ ? advanceArc(step) : advanceChord(step)) {
      return true;
    }
    if (atEnd_ || toEnd() < step - tolerance_) {
      return false;
    }
    place_ = {profile_.pieces.size() - 1, 1.0};
    atEnd_ = true;
    return true;
  }

  /// What is left of the profile, measured as the steps are, mm.
  [[nodiscard]] double toEnd() const {
    const Vec3 end = profile_.at({profile_.pieces.size() - 1, 1.0}).p;
    return arcLength_ ? arcToEnd() : (end - point().p).norm();
  }

private:
  bool advanceChord(double step) {
    const Vec3 from = point().p;
    ProfilePlace low = place_;
    for (std::size_t i = place_.piece; i < profile_.pieces.size(); ++i) {
      const double start = i == place_.piece ? place_.w : 0.0;
      for (int k = 1; k <= kChords; ++k) {
        const ProfilePlace high{i, start + (1.0 - start) * k / kChords};
        if ((profile_.at(high).p - from).norm() >= step) {
          place_ = bisect(low.piece == i ? low : ProfilePlace{i, 0.0}, high, from, step);
          return true;
        }
        low = high;
      }
    }
    return false;
  }

  [[nodiscard]] ProfilePlace bisect(ProfilePlace low,
                                    ProfilePlace high,
                                    const Vec3& from,
                                    double step) const {
    for (int k = 0; k < kBisections; ++k) {
      const ProfilePlace middle{low.piece, 0.5 * (low.w + high.w)};
      ((profile_.at(middle).p - from).norm() >= step ? high : low) = middle;
    }
    return high;
  }

  [[nodiscard]] double arcToEnd() const {
    double length = 0.0;
    Vec3 last = point().p;
    for (std::size_t i = place_.piece; i < profile_.pieces.size(); ++i) {
      const double start = i == place_.piece ? place_.w : 0.0;
      for (int k = 1; k <= kChords; ++k) {
        const Vec3 p = profile_.at({i, start + (1.0 - start) * k / kChords}).p;
        length += (p - last).norm();
        last = p;
      }
    }
    return length;
  }

  bool advanceArc(double step) {
    double length = 0.0;
    Vec3 last = point().p;
    for (std::size_t i = place_.piece; i < profile_.pieces.size(); ++i) {
      const double start = i == place_.piece ? place_.w : 0.0;
      double from = start;
      for (int k = 1; k <= kChords; ++k) {
        const double to = start + (1.0 - start) * k / kChords;
        const Vec3 p = profile_.at({i, to}).p;
        const double chord = (p - last).norm();
        if (length + chord >= step) {
          place_ = {i, from + (to - from) * (step - length) / chord};
          return true;
        }
        length += chord;
        last = p;
        from = to;
      }
    }
    return false;
  }

  const Profile& profile_;
  bool arcLength_;
  double tolerance_;
  bool atEnd_ = false;
  ProfilePlace place_;
};

/// The beads on the parallel through a point of the profile; b = t × n is the direction in which it
/// grows.
void addParallels(const ContourPoint& point,
                  const Vec3& growth,
                  const Axis& axis,
                  const ParallelCutter& cutter,
                  bool onEnd,
                  int part,
                  const Sampling& sampling,
                  std::vector<Contour>& contours) {
  const double z = (point.p - axis.point).dot(axis.direction);
  Parallel parallel;
  parallel.centre = axis.point + z * axis.direction;
  const Vec3 spoke = point.p - parallel.centre;
  parallel.radius = spoke.norm();
  parallel.e1 = spoke / parallel.radius;
  parallel.e2 = axis.direction.cross(parallel.e1);
  parallel.alongAxis = growth.dot(axis.direction);
  parallel.alongSpoke = growth.dot(parallel.e1);
  // In the meridian plane: facets of a mesh look aside.
  const Vec3 n = (point.n - point.n.dot(parallel.e2) * parallel.e2).normalized();
  const double sign = n.cross(growth).dot(parallel.e2) >= 0.0 ? 1.0 : -1.0;
  int count = chordCount(parallel.radius, sampling.chordError);
  const double half = sampling.maxSpacing / (2.0 * parallel.radius);
  if (half < 1.0) {
    count = std::max(count, static_cast<int>(std::ceil(kPi / std::asin(half) - 1e-9)));
  }
  for (const ParallelArc& arc : cutter.arcs(parallel, onEnd)) {
    Contour& contour = contours.emplace_back();
    contour.closed = arc.closed;
    contour.part = part;
    const double sweep = arc.to - arc.from;
    const int chords =
        arc.closed ? count
                   : std::max(1, static_cast<int>(std::ceil(count * sweep / (2.0 * kPi) - 1e-9)));
    const double begin = sign > 0.0 ? arc.from : (arc.closed ? arc.from : arc.to);
    for (int i = 0; i < chords + (arc.closed ? 0 : 1); ++i) {
      const double angle = begin + sign * sweep * i / chords;
      const Vec3 e = std::cos(angle) * parallel.e1 + std::sin(angle) * parallel.e2;
      contour.points.push_back({parallel.centre + parallel.radius * e,
                                n.dot(parallel.e1) * e + n.dot(axis.direction) * axis.direction});
    }
  }
}

Axis axisOf(const PartSurface& part, const Substrate& substrate, const RevolutionOptions& options) {
  if (options.axis) {
    return {options.axis->point, options.axis->direction.normalized()};
  }
  const auto axis = findRevolutionAxis(part, substrate.up());
  if (!axis) {
    throw Error(ErrorCode::JobFailed,
                "the part is no body of revolution: its normals meet no common axis",
                "iso-parametric slicing", "give the axis, or use another strategy");
  }
  return *axis;
}

/// One profile on its way to layers.
struct ProfileTask {
  const Profile& profile;
  const Substrate& substrate;
  const Axis& axis;
  const Vec3& radial;
  const RevolutionOptions& options;
  double leastRadius;  ///< no circle smaller than this, mm
  double tolerance;    ///< of the part's ends, mm

  [[nodiscard]] bool inside(const ContourPoint& point) const {
    // Beyond the axis the same circles come again.
    return radial.dot(point.p - axis.point) > leastRadius;
  }

  /// Whether the profile ends in a border, not on the axis.
  [[nodiscard]] bool endsInBorder() const {
    return inside(profile.at({profile.pieces.size() - 1, 1.0}));
  }
};

/// Steps that a profile gives, and what is left beyond the last one, mm.
struct Walked {
  std::size_t layers = 0;
  double rest = 0.0;
};

/// @param tolerance as of ProfileWalk
Walked walked(const ProfileTask& task, double step, std::size_t most, double tolerance) {
  ProfileWalk walk(task.profile, task.substrate, task.options.arcLength, tolerance);
  const double first = task.options.layers.firstLayer * step;
  Walked result;
  bool more = !(first > 0.0) || walk.advance(first);
  while (more) {
    ++result.layers;
    more = result.layers < most && walk.advance(step);
  }
  result.rest = walk.toEnd();
  return result;
}

/// The step whose last layer is the profile's end.
double fittedStep(const ProfileTask& task) {
  const LayerWish& wish = task.options.layers;
  constexpr std::size_t kAll = 1000000;
  const Walked wanted = walked(task, wish.step, kAll, 0.0);
  const double first = wish.firstLayer;
  const double height =
      wanted.rest +
      (wanted.layers > 0 ? first + static_cast<double>(wanted.layers) - 1.0 : 0.0) * wish.step;
  const LayerSteps steps = layersUpTo(height, wish, task.tolerance);
  if (steps.step == wish.step || steps.count == 0) {
    return wish.step;
  }
  // Chords of another length sum up to another length: a few corrections.
  const double places = first + static_cast<double>(steps.count) - 1.0;
  double step = steps.step;
  constexpr int kCorrections = 12;
  for (int i = 0; i < kCorrections; ++i) {
    const Walked now = walked(task, step, steps.count, 0.0);
    const double missing = static_cast<double>(steps.count - now.layers) * step;
    if (missing == 0.0 && now.rest <= 0.5 * task.tolerance) {
      break;
    }
    // A little less, so that the last step is not lost again.
    step += (now.rest - missing - 0.25 * task.tolerance) / places;
  }
  return step;
}

/// Layers of one profile, appended to `layers` by their number.
void sliceProfile(const ProfileTask& task,
                  double step,
                  const ParallelCutter& cutter,
                  int part,
                  const Sampling& sampling,
                  std::vector<SlicedLayer>& layers) {
  ProfileWalk walk(task.profile, task.substrate, task.options.arcLength, task.tolerance);
  const double first = task.options.layers.firstLayer * step;
  bool more = !(first > 0.0) || walk.advance(first);
  double level = first;
  for (std::size_t l = 0; more; ++l, more = walk.advance(step), level += step) {
    const ContourPoint point = walk.point();
    if (!task.inside(point)) {
      break;
    }
    if (layers.size() <= l) {
      layers.emplace_back();
      layers.back().level = level;
      layers.back().up = task.axis.direction;
      layers.back().nominalHeight = l == 0 && first > 0.0 ? first : step;
    }
    addParallels(point, walk.direction(), task.axis, cutter, walk.atEnd(), part, sampling,
                 layers[l].contours);
  }
}

}  // namespace

std::optional<Axis> findRevolutionAxis(const PartSurface& part, const Vec3& up) {
  // Every normal line meets the axis (a, b = c × a): m·a + n·b = 0 with the moment m = p × n.
  const geometry::Box box = part.mesh.bounds();
  const Vec3 origin = 0.5 * (box.min + box.max);
  const double size = std::max(box.diagonal(), std::numeric_limits<double>::min());
  Eigen::Matrix<double, 6, 6> sum = Eigen::Matrix<double, 6, 6>::Zero();
  double weight = 0.0;
  std::optional<geometry::BrepEvaluator> evaluator;
  if (part.exact()) {
    evaluator.emplace(*part.brep);
  }
  for (std::size_t t = 0; t < part.mesh.triangles.size(); ++t) {
    const auto& c = part.mesh.triangles[t];
    const Vec3& a = part.mesh.vertices[c[0]];
    const Vec3 cross = (part.mesh.vertices[c[1]] - a).cross(Vec3(part.mesh.vertices[c[2]] - a));
    const double area = cross.norm();
    if (!(area > 0.0)) {
      continue;
    }
    Vec3 n = cross / area;
    Vec3 p = (a + part.mesh.vertices[c[1]] + part.mesh.vertices[c[2]]) / 3.0;
    if (evaluator) {
      const auto& uv = part.binding.uv[t];
      const geometry::Vec2 middle = (uv[0] + uv[1] + uv[2]) / 3.0;
      const geometry::SurfacePoint exact = evaluator->surface(part.binding.face[t], middle);
      p = exact.p;
      n = evaluator->normal(part.binding.face[t], middle, exact);
    }
    p = (p - origin) / size;
    Eigen::Matrix<double, 6, 1> line;
    line << p.cross(n), n;
    sum += area * line * line.transpose();
    weight += area;
  }
  if (!(weight > 0.0)) {
    return std::nullopt;
  }
  sum /= weight;
  const auto axisFrom = [&](const Vec3& direction, const Vec3& moment) {
    return Axis{origin + size * direction.cross(moment), direction};
  };
  // Along the build direction first, which also decides for spheres.
  Eigen::Matrix<double, 3, 2> across;
  across.col(0) = up.unitOrthogonal();
  across.col(1) = up.cross(across.col(0));
  const Eigen::Matrix2d normal = across.transpose() * sum.block<3, 3>(3, 3) * across;
  const geometry::Vec2 solved =
      normal.fullPivLu().solve(-across.transpose() * sum.block<3, 3>(3, 0) * up);
  const Vec3 moment = across * solved;
  Eigen::Matrix<double, 6, 1> candidate;
  candidate << up, moment;
  if (candidate.dot(sum * candidate) <= kAxisFit * kAxisFit) {
    return axisFrom(up, moment);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen(sum);
  for (int k = 0; k < 3; ++k) {
    const Eigen::Matrix<double, 6, 1> v = eigen.eigenvectors().col(k);
    const double length = v.head<3>().norm();
    constexpr double kNoDirection = 1e-3;
    if (length < kNoDirection) {
      continue;
    }
    const Eigen::Matrix<double, 6, 1> unit = v / length;
    if (unit.dot(sum * unit) <= kAxisFit * kAxisFit) {
      const double sign = unit.head<3>().dot(up) < 0.0 ? -1.0 : 1.0;
      return axisFrom(sign * unit.head<3>(), sign * unit.tail<3>());
    }
  }
  return std::nullopt;
}

namespace {

/// The first of the half planes whose profiles, turned about the axis, are the part.
std::unique_ptr<Meridian> meridianOf(const PartSurface& part,
                                     const Axis& axis,
                                     const Substrate& substrate,
                                     const JobContext& context) {
  std::optional<Error> refused;
  bool first = true;
  for (const Vec3& radial : meridianDirections(part, axis)) {
    const bool inside = !std::exchange(first, false);
    context.check();
    auto meridian = std::make_unique<Meridian>(part, axis, radial, substrate, context);
    if (meridian->profiles().empty()) {
      continue;
    }
    try {
      requireRevolution(part, axis, *meridian, inside);
      return meridian;
    } catch (const Error& error) {
      refused = refused ? refused : error;
    }
  }
  throw refused ? *refused
                : Error(ErrorCode::JobFailed, "the axis' half planes do not meet the part",
                        "iso-parametric slicing", "check the axis and the part's place");
}

}  // namespace

SlicedLayers sliceRevolution(const std::vector<std::shared_ptr<const PartSurface>>& parts,
                             const Substrate& substrate,
                             const RevolutionOptions& options,
                             const Sampling& sampling,
                             const JobContext& context) {
  const LayerWish& wish = options.layers;
  if (!(wish.step > 0.0)) {
    throw Error(ErrorCode::InvalidArgument, "the step must be positive", "slicing");
  }
  SlicedLayers sliced;
  sliced.curved = true;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    context.check();
    const Axis axis = axisOf(*parts[k], substrate, options);
    const std::unique_ptr<Meridian> meridian = meridianOf(*parts[k], axis, substrate, context);
    const ParallelCutter cutter(*parts[k], axis, substrate, roundnessOf(*parts[k]));
    for (const Profile& profile : meridian->profiles()) {
      const ProfileTask task{
          profile,
          substrate,
          axis,
          meridian->radial(),
          options,
          std::max(options.leastRadius, sampling.chordError),
          std::max(geometry::flatTolerance(parts[k]->mesh), kBorder * wish.step)};
      const bool border = task.endsInBorder();
      const double step = border && wish.last == LastLayer::Fit ? fittedStep(task) : wish.step;
      sliceProfile(task, step, cutter, static_cast<int>(k), sampling, sliced.layers);
      if (border) {
        const Walked all = walked(task, step, sliced.layers.size(), task.tolerance);
        const double height = (wish.firstLayer + static_cast<double>(all.layers) - 1.0) * step;
        std::vector<double> ends(k + 1, std::numeric_limits<double>::quiet_NaN());
        ends.back() = height + all.rest;
        reportSteps(ends, {{height, axis.direction, step}}, wish, step, task.tolerance, context);
      }
    }
    context.report(static_cast<double>(k + 1) / static_cast<double>(parts.size()));
  }
  sliced.layers.erase(
      std::remove_if(sliced.layers.begin(), sliced.layers.end(),
                     [](const SlicedLayer& layer) { return layer.contours.empty(); }),
      sliced.layers.end());
  if (sliced.layers.empty()) {
    throw Error(ErrorCode::JobFailed, "no layer fits on the part", "slicing",
                "choose a smaller step");
  }
  moveOntoParts(sliced, parts, sampling, context);
  return sliced;
}

}  // namespace wcam::toolpath
