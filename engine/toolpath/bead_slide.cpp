// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bead_slide.hpp"

#include "wcam/base/text.hpp"
#include "wcam/geometry/segment_tree.hpp"

#include "frames.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace wcam::toolpath {

namespace {

/// A wall that leans by more than this tangent is nearly flat: it would slide away from its place,
/// and stays.
constexpr double kSteepest = 4.0;
/// Steps towards the height on a curved substrate; a plate needs one.
constexpr int kSteps = 8;
/// They end when they are this small against the half width.
constexpr double kNear = 1e-9;
/// A bead that is farther from the substrate than this many layer heights does not stand on it.
constexpr double kStands = 2.0;

/// How far a place of a wall slides, and along which direction.
struct Slide {
  double way = 0.0;  ///< mm
  Vec3 up = Vec3::Zero();
};

/// A contour, or one revolution of one, with the slides of its points.
struct Strand {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
  std::vector<Slide> slides;
  bool closed = false;
};

/// Slides along strands, linear between their points.
class SlideMap {
public:
  void add(const Strand& strand) {
    tree_.add(strand.points, strand.closed);
    for (std::size_t i = 0; i < strand.points.size(); ++i) {
      slides_.emplace(key(strand.points[i]), strand.slides[i]);
    }
  }

  void build() { tree_.build(); }

  [[nodiscard]] bool empty() const { return tree_.empty(); }

  [[nodiscard]] double distance(const Vec3& p) const { return tree_.distance(p); }

  [[nodiscard]] Vec3 foot(const Vec3& p) const { return tree_.nearest(p); }

  [[nodiscard]] Slide at(const Vec3& p) const {
    const geometry::SegmentTree::Nearest near = tree_.nearestSegment(p);
    const Slide& a = slides_.at(key(near.a));
    const Slide& b = slides_.at(key(near.b));
    const Vec3 up = (1.0 - near.fraction) * a.up + near.fraction * b.up;
    return {(1.0 - near.fraction) * a.way + near.fraction * b.way,
            up.norm() > 0.0 ? Vec3(up.normalized()) : a.up};
  }

private:
  static std::array<double, 3> key(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

  geometry::SegmentTree tree_;
  std::map<std::array<double, 3>, Slide> slides_;
};

/// Points of a contour from one index to another, with their build directions.
Strand strandOf(const Contour& contour, std::size_t begin, std::size_t end) {
  Strand strand;
  const std::size_t n = contour.points.size();
  strand.closed = contour.closed && end - begin == n;
  for (std::size_t i = begin; i < end; ++i) {
    const bool first = i == 0 && !contour.closed;
    const bool last = i + 1 == n && !contour.closed;
    const Vec3 t = tangentAt(contour.points[first ? i : (i + n - 1) % n].p, contour.points[i].p,
                             contour.points[last ? i : (i + 1) % n].p);
    const Vec3 b = t.cross(contour.points[i].n);
    strand.points.push_back(contour.points[i].p);
    strand.normals.push_back(contour.points[i].n);
    strand.slides.push_back({0.0, b.norm() > 0.0 ? Vec3(b.normalized()) : Vec3::Zero()});
  }
  return strand;
}

class Slider {
public:
  Slider(const Substrate& substrate, double sign, double width)
      : substrate_(substrate), sign_(sign), width_(width) {}

  /// Slides of the walls of a layer above what lies below it.
  [[nodiscard]] std::vector<Strand> strandsOf(const SlicedLayer& layer,
                                              const SlideMap& below) const {
    std::vector<Strand> strands;
    for (const Contour& contour : layer.contours) {
      const std::size_t count = contour.points.size();
      if (contour.feature != BeadFeature::Wall || count < 2) {
        continue;
      }
      std::vector<std::size_t> begins = contour.turns;
      begins.resize(std::max<std::size_t>(1, begins.size()), 0);
      for (std::size_t k = 0; k < begins.size(); ++k) {
        const std::size_t end = k + 1 < begins.size() ? begins[k + 1] : count;
        Strand strand = strandOf(contour, begins[k], end);
        SlideMap before;
        if (k > 0) {
          before.add(strands.back());
          before.build();
        }
        for (std::size_t i = 0; i < strand.points.size(); ++i) {
          const double own = contour.points[begins[k] + i].width;
          slide(strand, i, 0.5 * sign_ * (own > 0.0 ? own : width_), layer.nominalHeight,
                k > 0 ? before : below);
        }
        strands.push_back(std::move(strand));
      }
    }
    return strands;
  }

private:
  void slide(
      Strand& strand, std::size_t i, double offset, double height, const SlideMap& below) const {
    const Vec3& p = strand.points[i];
    Slide& slide = strand.slides[i];
    const Substrate::Foot foot = substrate_.nearest(p);
    const double descent = slide.up.dot(foot.direction);
    const double toPath =
        below.empty() ? std::numeric_limits<double>::infinity() : below.distance(p);
    // As the distances are measured (build.cpp): what is met first against the build direction.
    // What hangs far above it has no height that could be kept.
    const bool stands = foot.distance <= kStands * height;
    if (!stands && below.empty()) {
      return;
    }
    if (!(stands && descent > 0.0 && foot.distance < descent * toPath)) {
      slide.way = below.empty() ? 0.0 : below.at(p).way;
      return;
    }
    const Vec3 moved = p + offset * strand.normals[i];
    double way = 0.0;
    for (int k = 0; k < kSteps; ++k) {
      const Substrate::Foot now = substrate_.nearest(moved + way * slide.up);
      const double slope = slide.up.dot(now.direction);
      if (!(slope > 0.0)) {
        return;
      }
      const double step = (foot.distance - now.distance) / slope;
      way += step;
      if (std::abs(way) > kSteepest * std::abs(offset)) {
        return;
      }
      if (std::abs(step) <= kNear * std::abs(offset)) {
        slide.way = way;
        return;
      }
    }
    slide.way = way;
  }

  const Substrate& substrate_;
  double sign_;
  double width_;
};

std::vector<std::size_t> below(const SlicedLayers& sliced, std::size_t layer) {
  if (sliced.layers[layer].below) {
    return *sliced.layers[layer].below;
  }
  return layer > 0 ? std::vector<std::size_t>{layer - 1} : std::vector<std::size_t>{};
}

/// Half a step more or less at the upper end is what a layer more or less would correct.
void reportTop(
    const SlicedLayer& layer, int index, double lowest, double highest, const JobContext& context) {
  const double worst = -lowest > highest ? lowest : highest;
  if (std::abs(worst) <= 0.5 * layer.nominalHeight) {
    return;
  }
  context.add(
      {Severity::Warning,
       "toolpath.top_moved",
       text(worst > 0.0
                ? "the last layer lies up to %1 mm higher than the part: the wall leans, and "
                  "its beads lie beside it"
                : "the last layer lies up to %1 mm lower than the part: the wall leans, and "
                  "its beads lie beside it",
            {formatFixed(std::abs(worst), 2)}),
       "put the bead on the centre of the contour, or change the height of the part's "
       "upper edge by as much",
       {{}, index, -1, -1},
       {{"top_moved_mm", worst}}});
}

}  // namespace

void slideToSubstrate(const SlicedLayers& sliced,
                      const Substrate& substrate,
                      double sign,
                      double width,
                      SlicedLayers& moved,
                      const JobContext& context) {
  const Slider slider(substrate, sign, width);
  std::vector<std::vector<Strand>> strands(sliced.layers.size());
  for (std::size_t l = 0; l < sliced.layers.size(); ++l) {
    context.check();
    SlideMap under;
    for (const std::size_t k : below(sliced, l)) {
      // Layers are listed from below; what is named out of order has no slide to pass on.
      for (const Strand& strand : k < l ? strands[k] : std::vector<Strand>{}) {
        under.add(strand);
      }
    }
    under.build();
    strands[l] = slider.strandsOf(sliced.layers[l], under);
    SlideMap own;
    for (const Strand& strand : strands[l]) {
      own.add(strand);
    }
    own.build();
    if (own.empty()) {
      continue;
    }
    double lowest = 0.0;
    double highest = 0.0;
    for (Contour& contour : moved.layers[l].contours) {
      if (contour.feature != BeadFeature::Wall) {
        continue;
      }
      for (ContourPoint& point : contour.points) {
        const Slide slide = own.at(point.p);
        const Vec3 from = own.foot(point.p);
        point.p += slide.way * slide.up;
        const double rise = substrate.up().dot(point.p - from);
        lowest = std::min(lowest, rise);
        highest = std::max(highest, rise);
      }
    }
    if (l + 1 == sliced.layers.size()) {
      reportTop(sliced.layers[l], static_cast<int>(l), lowest, highest, context);
    }
  }
}

}  // namespace wcam::toolpath
