// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/base/text.hpp"
#include "wcam/geometry/aabb_tree.hpp"
#include "wcam/geometry/level_set.hpp"
#include "wcam/toolpath/iso_parametric.hpp"

#include "front_base.hpp"
#include "surface_patch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::toolpath {

using geometry::PartSurface;
using geometry::Vec2;

namespace {

/// An iso-curve leads away from the base when it climbs at less than this angle to the growth
/// direction: beyond, layers would crawl along the base.
constexpr double kLeadsAway = 0.5;
/// The next face's curve continues one when their directions agree within this cosine (some 8
/// degrees).
constexpr double kContinues = 0.99;
/// Part of a step in which a curve is scanned for the end of the chord.
constexpr double kScan = 0.25;
constexpr int kBisections = 60;
/// A point farther from the tessellation than this many times its own deviation from the exact
/// surface has left the part (faces are cut out of larger surfaces).
constexpr double kOffPart = 2.0;
/// Ends of faces meet within this part of the part's size.
constexpr double kMeets = 1e-5;
/// A point lies on the face beside its own within this part of the part's size.
constexpr double kOnOther = 1e-9;
constexpr std::size_t kMostLayers = 1000000;

/// A point that climbs along an iso-curve.
struct Climber {
  std::int32_t face = -1;
  Vec2 uv = Vec2::Zero();
  int parameter = 0;  ///< 0: u changes, 1: v
  double sign = 1.0;
  bool alive = true;
  double rest = 0.0;  ///< of a dead one: chord to where its curve ends, mm
  ContourPoint point;
};

class FaceClimb {
public:
  FaceClimb(const PartSurface& part, IsoDirection direction)
      : part_(part),
        evaluator_(*part.brep),
        patch_(part),
        tree_(part.mesh),
        size_(std::max(1.0, part.mesh.bounds().diagonal())),
        direction_(direction) {
    for (std::size_t t = 0; t < part.mesh.triangles.size(); ++t) {
      const auto& v = part.mesh.triangles[t];
      const auto& uv = part.binding.uv[t];
      const Vec3 centre =
          (part.mesh.vertices[v[0]] + part.mesh.vertices[v[1]] + part.mesh.vertices[v[2]]) / 3.0;
      const Vec2 middle = (uv[0] + uv[1] + uv[2]) / 3.0;
      deviation_ = std::max(deviation_,
                            (evaluator_.surface(part.binding.face[t], middle).p - centre).norm());
    }
  }

  /// Places the samples of a base curve on their faces and turns them to where the layers grow.
  std::vector<Climber> start(const Contour& base) {
    std::vector<Climber> climbers;
    for (std::size_t i = 0; i < base.points.size(); ++i) {
      Climber climber;
      locate(base.points[i].p, climber.face, climber.uv);
      climber.point = base.points[i];
      climbers.push_back(climber);
    }
    const std::size_t n = climbers.size();
    std::vector<Vec3> growth(n);
    std::vector<std::array<double, 2>> share(static_cast<std::size_t>(part_.brep->faceCount()));
    std::vector<std::size_t> count(share.size());
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3 t = base.points[(i + 1 < n || base.closed) ? (i + 1) % n : i].p -
                     base.points[(i > 0 || base.closed) ? (i + n - 1) % n : i].p;
      // b = t × n.
      growth[i] = t.cross(base.points[i].n).normalized();
      const auto face = static_cast<std::size_t>(climbers[i].face);
      for (int k = 0; k < 2; ++k) {
        share[face][static_cast<std::size_t>(k)] +=
            std::abs(growth[i].dot(tangent(climbers[i].face, climbers[i].uv, k)));
      }
      ++count[face];
    }
    for (std::size_t i = 0; i < n; ++i) {
      Climber& climber = climbers[i];
      const auto face = static_cast<std::size_t>(climber.face);
      climber.parameter = direction_ == IsoDirection::Auto
                              ? (share[face][1] > share[face][0] ? 1 : 0)
                              : (direction_ == IsoDirection::V ? 1 : 0);
      const double mean = share[face][static_cast<std::size_t>(climber.parameter)] /
                          static_cast<double>(count[face]);
      if (mean < kLeadsAway) {
        refuse(climber.face, climber.parameter, mean);
      }
      climber.sign =
          growth[i].dot(tangent(climber.face, climber.uv, climber.parameter)) < 0.0 ? -1.0 : 1.0;
    }
    return climbers;
  }

  /// Moves a climber on until its chord is `step`; it dies where its curve ends before. One that
  /// is short by the tolerance stands on the end.
  void climb(Climber& climber, double step, double tolerance) {
    const Vec3 from = climber.point.p;
    Climber at = climber;
    const Way way = follow(at, step);
    if (way == Way::Whole) {
      climber = at;
      return;
    }
    climber.rest = way == Way::Ended ? (at.point.p - from).norm() : chordOnPart(climber, step);
    climber.alive = false;
    if (climber.rest >= step - tolerance) {
      follow(climber, climber.rest);
      climber.alive = true;
    }
  }

private:
  /// How a climb went: by the whole chord, to the end of the curve, or off the part.
  enum class Way { Whole, Ended, Off };

  Way follow(Climber& at, double step) {
    const Vec3 from = at.point.p;
    // A curve may cross many small faces, but not return to where it was.
    constexpr int kMostFaces = 64;
    for (int faces = 0; faces < kMostFaces; ++faces) {
      if (climbOnFace(at, from, step)) {
        return onPart(at) ? Way::Whole : Way::Off;
      }
      if (!enterNextFace(at)) {
        return Way::Ended;
      }
    }
    return Way::Off;
  }

  /// The greatest chord that keeps a climber on the part.
  double chordOnPart(const Climber& climber, double step) {
    double low = 0.0;
    double high = step;
    constexpr int kHalvings = 30;
    for (int i = 0; i < kHalvings; ++i) {
      Climber at = climber;
      const double middle = 0.5 * (low + high);
      (follow(at, middle) == Way::Whole ? low : high) = middle;
    }
    return low;
  }

  /// False where the climber has gone over the edge of its face: nothing of the part is near, or
  /// another face that does not pass through the climber.
  [[nodiscard]] bool onPart(const Climber& at) const {
    const auto hit = tree_.closestPoint(at.point.p);
    if (!hit || hit->distance > kOffPart * deviation_ + kMeets * size_) {
      return false;
    }
    if (part_.binding.face[hit->triangle] == at.face) {
      return true;
    }
    std::int32_t face = -1;
    Vec2 uv;
    locate(at.point.p, face, uv);
    return (evaluator_.surface(face, uv).p - at.point.p).norm() <= kOnOther * size_;
  }

  [[nodiscard]] Vec3 tangent(std::int32_t face, const Vec2& uv, int parameter) const {
    const geometry::SurfacePoint s = evaluator_.surface(face, uv);
    const Vec3& d = parameter == 0 ? s.du : s.dv;
    return d.norm() > 0.0 ? Vec3(d.normalized()) : Vec3(Vec3::Zero());
  }

  void locate(const Vec3& p, std::int32_t& face, Vec2& uv) const {
    const auto hit = tree_.closestPoint(p);
    const std::uint32_t t = hit->triangle;
    face = part_.binding.face[t];
    const auto& c = part_.mesh.triangles[t];
    const Vec3& a = part_.mesh.vertices[c[0]];
    const Vec3 e1 = part_.mesh.vertices[c[1]] - a;
    const Vec3 e2 = part_.mesh.vertices[c[2]] - a;
    const auto w = solveMetric({a, e1, e2}, Vec2((hit->p - a).dot(e1), (hit->p - a).dot(e2)));
    const auto& corners = part_.binding.uv[t];
    uv = corners[0];
    if (w) {
      uv += (*w)[0] * (corners[1] - corners[0]) + (*w)[1] * (corners[2] - corners[0]);
    }
    uv = patch_.project(t, uv, p);
  }

  [[noreturn]] void refuse(std::int32_t face, int parameter, double mean) const {
    const geometry::BrepFaceInfo& info = part_.brep->face(face);
    throw Error(ErrorCode::JobFailed,
                text("face %1 (%2%3) has no iso-parametric curves that lead away from the base: "
                     "those of %4 climb at %5 degrees to the growth direction",
                     {std::to_string(face), info.surfaceType,
                      (info.name.empty() ? "" : ", " + info.name), (parameter == 0 ? "u" : "v"),
                      formatFixed(radToDeg(std::acos(std::min(1.0, mean))), 0)}),
                "iso-parametric slicing", "choose the other parameter or another strategy");
  }

  /// True when the chord is reached on this face; else the climber stands at the face's end.
  bool climbOnFace(Climber& at, const Vec3& from, double step) {
    const auto& b = part_.brep->face(at.face).uvBounds;
    const auto k = static_cast<std::size_t>(at.parameter);
    const double end = at.sign > 0.0 ? b[2 * k + 1] : b[2 * k];
    double low = at.uv[at.parameter];
    const auto point = [&](double value) {
      Vec2 uv = at.uv;
      uv[at.parameter] = value;
      return evaluator_.surface(at.face, uv);
    };
    while ((end - low) * at.sign > 0.0) {
      const geometry::SurfacePoint s = point(low);
      const double speed = (at.parameter == 0 ? s.du : s.dv).norm();
      const double most = std::abs(b[2 * k + 1] - b[2 * k]) * kScan;
      const double increment = speed > 0.0 ? std::min(most, kScan * step / speed) : most;
      double high = low + at.sign * increment;
      high = (end - high) * at.sign < 0.0 ? end : high;
      if ((point(high).p - from).norm() >= step) {
        for (int i = 0; i < kBisections; ++i) {
          const double middle = 0.5 * (low + high);
          ((point(middle).p - from).norm() >= step ? high : low) = middle;
        }
        place(at, high);
        return true;
      }
      low = high;
    }
    place(at, end);
    return false;
  }

  void place(Climber& at, double value) {
    at.uv[at.parameter] = value;
    const geometry::SurfacePoint s = evaluator_.surface(at.face, at.uv);
    at.point.p = s.p;
    at.point.n = evaluator_.normal(at.face, at.uv, s);
  }

  /// Goes over to a face whose iso-curve continues the climber's; false when there is none.
  bool enterNextFace(Climber& at) {
    const Vec3 direction = at.sign * tangent(at.face, at.uv, at.parameter);
    // A little ahead the nearest triangle is one of the next face.
    const Vec3 ahead = at.point.p + 10.0 * kMeets * size_ * direction;
    std::int32_t face = -1;
    Vec2 uv;
    locate(ahead, face, uv);
    if (face == at.face) {
      return false;
    }
    for (int parameter = 0; parameter < 2; ++parameter) {
      const Vec3 t = tangent(face, uv, parameter);
      if (std::abs(t.dot(direction)) < kContinues) {
        continue;
      }
      const auto& b = part_.brep->face(face).uvBounds;
      const auto k = static_cast<std::size_t>(parameter);
      Climber next = at;
      next.face = face;
      next.uv = uv;
      next.parameter = parameter;
      next.sign = t.dot(direction) < 0.0 ? -1.0 : 1.0;
      place(next, next.sign > 0.0 ? b[2 * k] : b[2 * k + 1]);
      if ((next.point.p - at.point.p).norm() <= kMeets * size_) {
        at = next;
        return true;
      }
    }
    return false;
  }

  const PartSurface& part_;
  geometry::BrepEvaluator evaluator_;
  SurfacePatch patch_;
  geometry::AabbTree tree_;
  double size_;
  IsoDirection direction_;
  double deviation_ = 0.0;  ///< of the tessellation from the exact surface, mm
};

/// Runs of neighbouring climbers that are still on the part.
void addContours(const std::vector<Climber>& climbers,
                 bool ring,
                 int part,
                 std::vector<Contour>& contours) {
  const std::size_t n = climbers.size();
  const auto alive = [&](std::size_t i) { return climbers[i % n].alive; };
  std::size_t first = 0;
  while (first < n && alive(first)) {
    ++first;
  }
  Contour contour;
  contour.part = part;
  if (first == n) {
    contour.closed = ring;
    for (const Climber& climber : climbers) {
      contour.points.push_back(climber.point);
    }
    contours.push_back(std::move(contour));
    return;
  }
  const std::size_t begin = ring ? first : 0;
  for (std::size_t k = 0; k <= n; ++k) {
    const bool go = k < n && alive(begin + k);
    if (go) {
      contour.points.push_back(climbers[(begin + k) % n].point);
    } else {
      if (contour.points.size() > 1) {
        contours.push_back(contour);
      }
      contour.points.clear();
    }
  }
}

/// Length of the contours, mm.
double lengthOf(const std::vector<Contour>& contours) {
  double length = 0.0;
  for (const Contour& contour : contours) {
    for (std::size_t i = 0; i + (contour.closed ? 0 : 1) < contour.points.size(); ++i) {
      length += (contour.points[(i + 1) % contour.points.size()].p - contour.points[i].p).norm();
    }
  }
  return length;
}

double areaAbove(const geometry::TriangleMesh& mesh, const Substrate& substrate) {
  double area = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3& a = mesh.vertices[t[0]];
    const Vec3 ab = mesh.vertices[t[1]] - a;
    const Vec3 ac = mesh.vertices[t[2]] - a;
    if (substrate.heightAbove(a + (ab + ac) / 3.0) >= 0.0) {
      area += 0.5 * ab.cross(ac).norm();
    }
  }
  return area;
}

/// Lengths of the iso-curves from the base to their ends, in chords of a step.
struct CurveLengths {
  double mean = 0.0;
  double spread = 0.0;  ///< to both sides, mm
};

/// One base curve of a part on its way to layers.
class FaceLayers {
public:
  FaceLayers(const PartSurface& part,
             int index,
             const Substrate& substrate,
             const FaceIsoOptions& options,
             const JobContext& context)
      : index_(index),
        substrate_(substrate),
        options_(options),
        context_(context),
        climb_(part, options.direction),
        area_(areaAbove(part.mesh, substrate)),
        tolerance_(geometry::flatTolerance(part.mesh)) {}

  void slice(const TracedCurve& traced,
             const Sampling& sampling,
             std::vector<SlicedLayer>& layers) {
    Contour first;
    first.closed = traced.curve->closed();
    first.points = sampleCurve(*traced.curve, sampling);
    const std::vector<Climber> climbers = climb_.start(first);
    const LayerWish& wish = options_.layers;
    double step = wish.step;
    std::vector<std::vector<Contour>> made = climbAll(climbers, first.closed, step, tolerance_);
    // Curves that end so unevenly end in a slanted or wavy border.
    constexpr double kEven = 0.05;
    // A border that misses the last layer by less than this part of a step is that layer.
    constexpr double kBorder = 0.01;
    if (lengths_.spread > kEven * step) {
      append(std::move(made), step, layers);
      return;
    }
    const double tolerance = std::max(tolerance_, kBorder * step + 2.0 * lengths_.spread);
    const double length = lengths_.mean;
    if (wish.last == LastLayer::Fit) {
      step = layersUpTo(length, wish, tolerance).step;
      if (step != wish.step || tolerance > tolerance_) {
        made = climbAll(climbers, first.closed, step, tolerance);
      }
    }
    const double level = (wish.firstLayer + static_cast<double>(made.size()) - 1.0) * step;
    std::vector<double> ends(static_cast<std::size_t>(index_) + 1,
                             std::numeric_limits<double>::quiet_NaN());
    ends.back() = length;
    reportSteps(ends, {{level, Vec3::UnitZ(), step}}, wish, step, tolerance, context_);
    append(std::move(made), step, layers);
  }

private:
  /// The contours of all layers; measures the curves.
  std::vector<std::vector<Contour>> climbAll(std::vector<Climber> climbers,
                                             bool ring,
                                             double wanted,
                                             double tolerance) {
    std::vector<std::vector<Contour>> layers;
    std::vector<double> lengths(climbers.size(), 0.0);
    double laid = laid_;
    for (std::size_t l = 0; l < kMostLayers; ++l) {
      context_.check();
      const double step = l == 0 ? options_.layers.firstLayer * wanted : wanted;
      for (std::size_t i = 0; step > 0.0 && i < climbers.size(); ++i) {
        if (climbers[i].alive) {
          climb_.climb(climbers[i], step, tolerance);
          lengths[i] += climbers[i].alive ? step : climbers[i].rest;
          // What comes back to the substrate has reached the part's end.
          climbers[i].alive =
              climbers[i].alive && substrate_.heightAbove(climbers[i].point.p) >= 0.0;
        }
      }
      std::vector<Contour> contours;
      addContours(climbers, ring, index_, contours);
      if (contours.empty()) {
        break;
      }
      laid += wanted * lengthOf(contours);
      requireOnce(laid);
      layers.push_back(std::move(contours));
    }
    const auto [low, high] = std::minmax_element(lengths.begin(), lengths.end());
    lengths_ =
        lengths.empty() ? CurveLengths{} : CurveLengths{0.5 * (*low + *high), 0.5 * (*high - *low)};
    return layers;
  }

  /// Refuses curves that run over the surface again, as those from two ends of a bow or around a
  /// torus do.
  void requireOnce(double laid) const {
    // Curves that climb askew lie nearer to each other than the step, by some tenths in the mean.
    constexpr double kMostCoverage = 1.8;
    if (laid > kMostCoverage * area_) {
      throw Error(
          ErrorCode::JobFailed,
          "the iso-parametric curves run over the surface more than once: they meet each "
          "other or return to where they began",
          "iso-parametric slicing",
          "choose the other parameter (direction=u or v), pick the faces to build, or slice "
          "by the geodesic distance from the base");
    }
  }

  void append(std::vector<std::vector<Contour>> made,
              double wanted,
              std::vector<SlicedLayer>& layers) {
    double level = 0.0;
    for (std::size_t l = 0; l < made.size(); ++l) {
      const double step = l == 0 ? options_.layers.firstLayer * wanted : wanted;
      laid_ += wanted * lengthOf(made[l]);
      level += step;
      if (layers.size() <= l) {
        layers.emplace_back();
        layers.back().level = level;
        layers.back().up = Vec3::Zero();
        layers.back().nominalHeight = step > 0.0 ? step : wanted;
      }
      for (Contour& contour : made[l]) {
        for (std::size_t i = 0; i + 1 < contour.points.size(); ++i) {
          layers[l].up +=
              (contour.points[i + 1].p - contour.points[i].p).cross(contour.points[i].n);
        }
        layers[l].contours.push_back(std::move(contour));
      }
    }
  }

  int index_;
  const Substrate& substrate_;
  const FaceIsoOptions& options_;
  const JobContext& context_;
  FaceClimb climb_;
  double area_;        ///< of the part above the substrate, mm²
  double laid_ = 0.0;  ///< of all base curves up to now, mm²
  double tolerance_;   ///< of the part's ends, mm
  CurveLengths lengths_;
};

}  // namespace

SlicedLayers sliceFaceIso(const std::vector<std::shared_ptr<const PartSurface>>& parts,
                          const Substrate& substrate,
                          const FaceIsoOptions& options,
                          const Sampling& sampling,
                          const JobContext& context) {
  if (!(options.layers.step > 0.0)) {
    throw Error(ErrorCode::InvalidArgument, "the step must be positive", "slicing");
  }
  SlicedLayers sliced;
  sliced.curved = true;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (!parts[k]->exact()) {
      throw Error(ErrorCode::JobFailed, "the part is a mesh: it has no parameters to follow",
                  "iso-parametric slicing",
                  "use the CAD file of the part, or slice at constant distance");
    }
    const JobContext portion =
        context.portion(static_cast<double>(k) / static_cast<double>(parts.size()),
                        static_cast<double>(k + 1) / static_cast<double>(parts.size()));
    const SurfacePatch patch(*parts[k]);
    const FrontBase base = findFrontBase(patch, substrate, portion);
    FaceLayers faces(*parts[k], static_cast<int>(k), substrate, options, portion);
    for (const TracedCurve& traced : base.curves) {
      faces.slice(traced, sampling, sliced.layers);
    }
  }
  if (sliced.layers.empty()) {
    throw Error(ErrorCode::JobFailed, "no layer fits on the part", "slicing",
                "choose a smaller step");
  }
  for (SlicedLayer& layer : sliced.layers) {
    layer.up = layer.up.norm() > 0.0 ? Vec3(layer.up.normalized()) : substrate.up();
  }
  return sliced;
}

}  // namespace wcam::toolpath
