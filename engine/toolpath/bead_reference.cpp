// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bead_reference.hpp"

#include "wcam/base/parallel.hpp"
#include "wcam/geometry/segment_tree.hpp"

#include "bead_slide.hpp"
#include "contour_points.hpp"
#include "frames.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace wcam::toolpath {

namespace {

/// Two sides that turn by less belong to one smooth curve.
const double kSmooth = degToRad(20.0);

/// Sides are subdivided down to this part of the bead width: places that a bead does not reach are
/// seldom smaller.
constexpr double kSpacing = 0.125;

/// A point of the moved contour before loops are cut out.
struct Moved {
  ContourPoint point;
  Vec3 t = Vec3::Zero();  ///< direction of travel of the contour there
  double offset = 0.0;    ///< how far it was moved, mm, positive
  bool original = true;   ///< comes from a point of the contour, not from a subdivision
};

struct Source {
  ContourPoint point;
  bool original = true;
};

/// The contour's points with long sides subdivided: what is cut away is found between points.
std::vector<Source> subdivided(const Contour& contour, double spacing) {
  std::vector<Source> result;
  const std::size_t n = contour.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    result.push_back({contour.points[i], true});
    if (i + 1 == n && !contour.closed) {
      break;
    }
    const ContourPoint& next = contour.points[(i + 1) % n];
    const double length = (next.p - contour.points[i].p).norm();
    const int pieces = std::max(1, static_cast<int>(std::ceil(length / spacing)));
    for (int k = 1; k < pieces; ++k) {
      result.push_back({between(contour.points[i], next, static_cast<double>(k) / pieces), false});
    }
  }
  return result;
}

class Mover {
public:
  Mover(const Contour& contour,
        const Vec3& up,
        bool curved,
        double sign,
        double width,
        const Sampling& sampling)
      : closed_(contour.closed),
        up_(up),
        curved_(curved),
        sign_(sign),
        width_(width),
        sampling_(sampling),
        source_(subdivided(contour, std::min(sampling.maxSpacing, kSpacing * width))) {
    double agreement = 0.0;
    for (std::size_t i = 0; i + 1 < contour.points.size(); ++i) {
      const Vec3 along = contour.points[i + 1].p - contour.points[i].p;
      agreement += up.cross(along).dot(contour.points[i].n + contour.points[i + 1].n);
    }
    outward_ = agreement < 0.0 ? -1.0 : 1.0;
  }

  std::vector<Moved> move() {
    for (std::size_t i = 0; i < source_.size(); ++i) {
      addPoint(i);
    }
    return std::move(moved_);
  }

private:
  [[nodiscard]] double offsetAt(std::size_t i) const {
    const double own = source_[i].point.width;
    return 0.5 * (own > 0.0 ? own : width_);
  }

  /// Outward direction inside the layer at a point, across a direction of travel.
  [[nodiscard]] Vec3 outward(std::size_t i, const Vec3& t) const {
    const Vec3& n = source_[i].point.n;
    Vec3 m = curved_ ? Vec3(n - n.dot(t) * t) : Vec3(outward_ * up_.cross(t));
    return m.norm() > 0.0 ? Vec3(m.normalized()) : t.unitOrthogonal();
  }

  void put(std::size_t i, const Vec3& direction) {
    Moved moved{source_[i].point, t_, offsetAt(i), source_[i].original};
    moved.point.p += sign_ * moved.offset * direction;
    moved_.push_back(moved);
  }

  void addPoint(std::size_t i) {
    const std::size_t n = source_.size();
    const bool first = !closed_ && i == 0;
    const bool last = !closed_ && i + 1 == n;
    const Vec3& p = source_[i].point.p;
    const Vec3& before = source_[first ? i : (i + n - 1) % n].point.p;
    const Vec3& after = source_[last ? i : (i + 1) % n].point.p;
    const Vec3 t = t_ = tangentAt(before, p, after);
    const Vec3 in = before == p ? t : Vec3((p - before).normalized());
    const Vec3 out = after == p ? t : Vec3((after - p).normalized());
    const double turn = std::atan2(in.cross(out).norm(), in.dot(out));
    if (turn < kSmooth) {
      addSmooth(i, t, turn);
      return;
    }
    const Vec3 m1 = outward(i, in);
    const Vec3 m2 = outward(i, out);
    const Vec3 axis = m1.cross(m2);
    const bool opens = (out - in).dot(sign_ * (m1 + m2)) < 0.0;
    if (!opens || axis.norm() == 0.0) {
      put(i, m1);
      put(i, m2);
      return;
    }
    // An arc around the corner, its sagitta inside the chord error.
    const double step = 2.0 * std::acos(1.0 - std::min(1.0, sampling_.chordError / offsetAt(i)));
    const double angle = std::atan2(axis.norm(), m1.dot(m2));
    const int pieces = std::max(1, static_cast<int>(std::ceil(angle / step)));
    for (int k = 0; k <= pieces; ++k) {
      put(i, Eigen::AngleAxisd(angle * k / pieces, axis.normalized()) * m1);
    }
  }

  void addSmooth(std::size_t i, const Vec3& t, double turn) {
    const Vec3 fromTravel = outward(i, t);
    const Vec3& n = source_[i].point.n;
    const Vec3 inLayer = curved_ ? n : Vec3(n - n.dot(up_) * up_);
    // The surface's own normal is exact where it fits the contour; on facets it is that of one
    // side.
    constexpr double kFits = 0.25;
    constexpr double kAlmostStraight = 1e-3;
    const bool exact = inLayer.norm() > 0.0 &&
                       (inLayer.normalized() - fromTravel).norm() <= kFits * turn + kAlmostStraight;
    put(i, exact ? Vec3(inLayer.normalized()) : fromTravel);
  }

  bool closed_;
  Vec3 up_;
  bool curved_;
  double sign_;
  double width_;
  Sampling sampling_;
  double outward_ = 1.0;  ///< −1 for a contour that runs the other way round its normal
  Vec3 t_ = Vec3::Zero();
  std::vector<Source> source_;
  std::vector<Moved> moved_;
};

/// A part of the moved contour that keeps its distance. A cut end knows the line that leads on.
struct Piece {
  std::vector<Moved> points;
  bool cutBegin = false;
  bool cutEnd = false;
  Vec3 beginDirection = Vec3::Zero();
  Vec3 endDirection = Vec3::Zero();
};

class Cutter {
public:
  Cutter(const Contour& contour, std::vector<Moved> moved, const Sampling& sampling)
      : moved_(std::move(moved)), closed_(contour.closed), chordError_(sampling.chordError) {
    std::vector<Vec3> polyline;
    for (const ContourPoint& point : contour.points) {
      polyline.push_back(point.p);
    }
    tree_.add(polyline, contour.closed);
    tree_.build();
    valid_.resize(moved_.size());
    for (std::size_t i = 0; i < moved_.size(); ++i) {
      valid_[i] = keepsDistance(moved_[i].point.p, moved_[i].offset) ? 1 : 0;
    }
  }

  std::vector<Piece> pieces() const {
    std::vector<Piece> result;
    const std::size_t n = moved_.size();
    const std::size_t invalid =
        static_cast<std::size_t>(std::find(valid_.begin(), valid_.end(), 0) - valid_.begin());
    if (invalid == n) {
      result.push_back({moved_, false, false, {}, {}});
      return result;
    }
    // A closed contour is walked from a removed point on, once around.
    const std::size_t first = closed_ ? invalid : 0;
    bool inside = false;
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = (first + k) % n;
      const std::size_t before = (i + n - 1) % n;
      const bool hasBefore = closed_ || k > 0;
      if (valid_[i] != 0 && !inside) {
        result.emplace_back();
        if (hasBefore) {
          begin(result.back(), before, i);
        }
        inside = true;
      } else if (valid_[i] == 0 && inside) {
        end(result.back(), before, i);
        inside = false;
      }
      if (inside) {
        result.back().points.push_back(moved_[i]);
      }
    }
    if (inside && closed_) {
      end(result.back(), (first + n - 1) % n, first);
    }
    return result;
  }

private:
  [[nodiscard]] bool keepsDistance(const Vec3& p, double offset) const {
    // Chords lie inside their curve by up to the chord error; turns of a smooth curve shorten the
    // distance by 1 − cos of half the turn at most.
    const double tolerance = chordError_ + (1.0 - std::cos(0.5 * kSmooth)) * offset;
    return tree_.distance(p) >= offset - tolerance;
  }

  [[nodiscard]] Moved border(std::size_t removed, std::size_t kept) const {
    double low = 0.0;
    double high = 1.0;
    Moved best = moved_[kept];
    constexpr int kBisections = 40;
    for (int i = 0; i < kBisections; ++i) {
      const double s = 0.5 * (low + high);
      Moved moved{between(moved_[removed].point, moved_[kept].point, s), moved_[kept].t,
                  (1.0 - s) * moved_[removed].offset + s * moved_[kept].offset, true};
      if (keepsDistance(moved.point.p, moved.offset)) {
        high = s;
        best = moved;
      } else {
        low = s;
      }
    }
    return best;
  }

  void begin(Piece& piece, std::size_t removed, std::size_t kept) const {
    piece.cutBegin = true;
    piece.beginDirection = moved_[kept].point.p - moved_[removed].point.p;
    piece.points.push_back(border(removed, kept));
  }

  void end(Piece& piece, std::size_t kept, std::size_t removed) const {
    piece.cutEnd = true;
    piece.endDirection = moved_[removed].point.p - moved_[kept].point.p;
    piece.points.push_back(border(removed, kept));
  }

  std::vector<Moved> moved_;
  std::vector<char> valid_;
  geometry::SegmentTree tree_;
  bool closed_;
  double chordError_;
};

/// Where the lines of two cut ends come together: half way between their nearest points, when that
/// is near; else half way between the ends.
Vec3 meeting(const Vec3& a, const Vec3& u, const Vec3& b, const Vec3& v, double reach) {
  const Vec3 middle = 0.5 * (a + b);
  const double uu = u.squaredNorm();
  const double vv = v.squaredNorm();
  const double uv = u.dot(v);
  const double det = uu * vv - uv * uv;
  // Lines within a degree of each other meet nowhere that rounding leaves alone.
  constexpr double kParallel = 3e-4;
  if (!(det > kParallel * uu * vv)) {
    return middle;
  }
  const Vec3 w = b - a;
  const double s = (vv * u.dot(w) - uv * v.dot(w)) / det;
  const double r = (uv * u.dot(w) - uu * v.dot(w)) / det;
  const Vec3 meet = 0.5 * (a + s * u + b + r * v);
  return (meet - middle).norm() <= reach ? meet : middle;
}

/// Which piece follows each one: the cut begins nearest to the cut ends, nearest pairs first.
std::vector<std::size_t> successors(const std::vector<Piece>& pieces) {
  const std::size_t none = pieces.size();
  std::vector<std::size_t> next(pieces.size(), none);
  std::vector<char> taken(pieces.size(), 0);

  struct Pair {
    double distance;
    std::size_t end;
    std::size_t begin;
  };

  std::vector<Pair> pairs;
  for (std::size_t e = 0; e < pieces.size(); ++e) {
    for (std::size_t b = 0; b < pieces.size(); ++b) {
      if (pieces[e].cutEnd && pieces[b].cutBegin) {
        pairs.push_back(
            {(pieces[e].points.back().point.p - pieces[b].points.front().point.p).norm(), e, b});
      }
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& x, const Pair& y) { return x.distance < y.distance; });
  for (const Pair& pair : pairs) {
    if (next[pair.end] == none && taken[pair.begin] == 0) {
      next[pair.end] = pair.begin;
      taken[pair.begin] = 1;
    }
  }
  return next;
}

/// Replaces the end of `chain` and the begin of `piece` by the point where they meet, and goes on.
void append(std::vector<Moved>& chain, const Vec3& direction, const Piece& piece) {
  const Moved& begin = piece.points.front();
  const Vec3 meet =
      meeting(chain.back().point.p, direction, begin.point.p, piece.beginDirection, begin.offset);
  chain.back().point = between(chain.back().point, begin.point, 0.5);
  chain.back().point.p = meet;
  chain.insert(chain.end(), piece.points.begin() + 1, piece.points.end());
}

Contour contourFrom(const Contour& source, const std::vector<Moved>& chain, bool closed) {
  Contour contour = source;
  contour.closed = closed;
  contour.points.clear();
  for (const Moved& moved : chain) {
    // Pieces that run backwards are loops smaller than the tolerance.
    const bool onwards =
        contour.points.empty() || (moved.point.p - contour.points.back().p).dot(moved.t) > 0.0;
    if (moved.original && onwards) {
      contour.points.push_back(moved.point);
    }
  }
  if (closed && contour.points.size() > 1 && contour.points.front().p == contour.points.back().p) {
    contour.points.pop_back();
  }
  return contour;
}

/// What is too short to be a bead: less than this part of the bead width.
constexpr double kShortest = 0.5;

bool worthKeeping(const Contour& contour, double width) {
  double length = 0.0;
  for (std::size_t i = 1; i < contour.points.size(); ++i) {
    length += (contour.points[i].p - contour.points[i - 1].p).norm();
  }
  return length > kShortest * width && contour.points.size() >= (contour.closed ? 3U : 2U);
}

std::vector<Contour> joined(const Contour& source, const std::vector<Piece>& pieces, double width) {
  std::vector<Contour> result;
  if (pieces.size() == 1 && !pieces[0].cutBegin && !pieces[0].cutEnd) {
    result.push_back(contourFrom(source, pieces[0].points, source.closed));
  } else {
    const std::vector<std::size_t> next = successors(pieces);
    std::vector<char> used(pieces.size(), 0);
    // Chains that begin at an open end first, rings after them.
    for (const bool open : {true, false}) {
      for (std::size_t first = 0; first < pieces.size(); ++first) {
        if (used[first] != 0 || pieces[first].points.empty() || (open && pieces[first].cutBegin)) {
          continue;
        }
        std::vector<Moved> chain = pieces[first].points;
        used[first] = 1;
        std::size_t at = first;
        while (next[at] != pieces.size() && used[next[at]] == 0) {
          append(chain, pieces[at].endDirection, pieces[next[at]]);
          at = next[at];
          used[at] = 1;
        }
        const bool ring = next[at] == first;
        if (ring) {
          chain.front().point.p =
              meeting(chain.back().point.p, pieces[at].endDirection, chain.front().point.p,
                      pieces[first].beginDirection, chain.front().offset);
          chain.pop_back();
        }
        result.push_back(contourFrom(source, chain, ring));
      }
    }
  }
  std::erase_if(result, [&](const Contour& contour) { return !worthKeeping(contour, width); });
  return result;
}

/// A bead of several revolutions: its neighbours are other revolutions, so only pieces that run
/// backwards are taken out.
Contour movedSpiral(const Contour& source, const std::vector<Moved>& moved) {
  Contour result = source;
  result.points.clear();
  result.turns.clear();
  std::size_t turn = 0;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const bool starts = turn < source.turns.size() && source.turns[turn] <= i;
    const bool backwards = !result.points.empty() && i > 0 && i + 1 < moved.size() &&
                           i < source.points.size() &&
                           (moved[i].point.p - result.points.back().p)
                                   .dot(source.points[i].p - source.points[i - 1].p) <= 0.0;
    if (starts) {
      result.turns.push_back(result.points.size());
      ++turn;
    }
    if (!backwards) {
      result.points.push_back(moved[i].point);
    }
  }
  return result;
}

}  // namespace

std::vector<Contour> offsetContour(const Contour& contour,
                                   const SlicedLayer& layer,
                                   bool curved,
                                   double sign,
                                   double width,
                                   const Sampling& sampling) {
  if (contour.points.size() < 2) {
    return {};
  }
  if (!contour.turns.empty()) {
    // Point by point: every point keeps its place in the revolutions.
    std::vector<Moved> moved;
    for (const ContourPoint& point : contour.points) {
      Moved item{point, Vec3::Zero(), 0.5 * (point.width > 0.0 ? point.width : width), true};
      const Vec3 direction = curved ? point.n : Vec3(point.n - point.n.dot(layer.up) * layer.up);
      item.point.p += sign * item.offset * direction.normalized();
      moved.push_back(item);
    }
    return {movedSpiral(contour, moved)};
  }
  std::vector<Moved> moved = Mover(contour, layer.up, curved, sign, width, sampling).move();
  const Cutter cutter(contour, std::move(moved), sampling);
  return joined(contour, cutter.pieces(), width);
}

SlicedLayers withBeadReference(const SlicedLayers& sliced,
                               const Substrate& substrate,
                               const PathParams& params,
                               double width,
                               const JobContext& context) {
  if (params.beadReference == BeadReference::Centre) {
    return sliced;
  }
  const double sign = params.beadReference == BeadReference::Inside ? 1.0 : -1.0;
  const Sampling sampling = params.sampling(width, 0.0);
  SlicedLayers result = sliced;
  std::vector<std::size_t> vanished(sliced.layers.size(), 0);
  parallelFor(
      sliced.layers.size(), 1,
      [&](std::size_t l) {
        result.layers[l].contours.clear();
        for (const Contour& contour : sliced.layers[l].contours) {
          // Only walls are given by a surface; fills and junctions lie where the bead's centre is.
          if (contour.feature != BeadFeature::Wall) {
            result.layers[l].contours.push_back(contour);
            continue;
          }
          std::vector<Contour> moved =
              offsetContour(contour, sliced.layers[l], sliced.curved, sign, width, sampling);
          vanished[l] += moved.empty() ? 1U : 0U;
          std::move(moved.begin(), moved.end(), std::back_inserter(result.layers[l].contours));
        }
      },
      context);
  for (std::size_t l = 0; l < vanished.size(); ++l) {
    if (vanished[l] > 0) {
      context.add({Severity::Warning,
                   "toolpath.contour_vanished",
                   text("%1 contours are too narrow for half a bead on this side: nothing is "
                        "deposited there",
                        {std::to_string(vanished[l])}),
                   "put the bead on the centre or on the other side of the contour, or take a "
                   "narrower bead",
                   {{}, static_cast<int>(l), -1, -1},
                   {{"contours", static_cast<double>(vanished[l])}}});
    }
  }
  if (sliced.curved && sliced.onSubstrate) {
    slideToSubstrate(sliced, substrate, sign, width, result, context);
  }
  return result;
}

}  // namespace wcam::toolpath
