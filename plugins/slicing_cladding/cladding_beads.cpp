// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cladding_beads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace wcam::cladding {

SurfaceCurve toCurve(const toolpath::Contour& contour, std::size_t line, double merge) {
  SurfaceCurve curve;
  curve.closed = contour.closed;
  curve.line = line;
  const std::size_t n = contour.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const toolpath::ContourPoint& point = contour.points[i];
    const bool near = !curve.points.empty() && (point.p - curve.points.back()).norm() < merge;
    const bool last = i + 1 == n && !contour.closed;
    if (near && last && curve.points.size() > 1) {
      // The end of an open curve stays; the point before it goes.
      curve.points.pop_back();
      curve.normals.pop_back();
    } else if (near && !last) {
      continue;
    }
    curve.points.push_back(point.p);
    curve.normals.push_back(point.n);
  }
  return curve;
}

void smoothNormals(SurfaceCurve& curve, double distance) {
  const std::size_t n = curve.points.size();
  if (n < 3) {
    return;
  }
  const auto length = [&](std::size_t i) {
    return (curve.points[(i + 1) % n] - curve.points[i]).norm();
  };
  // Share of the curve that a point stands for.
  std::vector<double> share(n, 0.0);
  const std::size_t edges = curve.closed ? n : n - 1;
  for (std::size_t i = 0; i < edges; ++i) {
    share[i] += 0.5 * length(i);
    share[(i + 1) % n] += 0.5 * length(i);
  }
  std::vector<Vec3> smooth(n);
  for (std::size_t i = 0; i < n; ++i) {
    Vec3 sum = share[i] * curve.normals[i];
    // On an open curve both sides reach equally far, or the mean would lean inwards; at its ends a
    // small lean is better than the normal of one facet.
    constexpr double kLeastReach = 0.5;
    double reach = distance;
    for (const bool forward : {true, false}) {
      double room = 0.0;
      for (std::size_t k = i; !curve.closed && room < distance && (forward ? k + 1 < n : k > 0);) {
        room += length(forward ? k : k - 1);
        k = forward ? k + 1 : k - 1;
      }
      reach = curve.closed ? reach : std::min(reach, room);
    }
    reach = std::max(reach, kLeastReach * distance);
    for (const bool forward : {true, false}) {
      double way = 0.0;
      std::size_t k = i;
      for (std::size_t steps = 0; steps + 1 < n; ++steps) {
        if (!curve.closed && (forward ? k + 1 >= n : k == 0)) {
          break;
        }
        const std::size_t next = forward ? (k + 1) % n : (k + n - 1) % n;
        way += length(forward ? k : next);
        if (way > reach) {
          break;
        }
        sum += share[next] * curve.normals[next];
        k = next;
      }
    }
    smooth[i] = sum.norm() > 0.0 ? Vec3(sum.normalized()) : curve.normals[i];
  }
  curve.normals = std::move(smooth);
}

double curveLength(const SurfaceCurve& curve) {
  double length = 0.0;
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    length += (curve.points[i] - curve.points[i - 1]).norm();
  }
  return curve.closed && !curve.points.empty()
             ? length + (curve.points.front() - curve.points.back()).norm()
             : length;
}

namespace {

void reverse(SurfaceCurve& curve) {
  std::reverse(curve.points.begin(), curve.points.end());
  std::reverse(curve.normals.begin(), curve.normals.end());
}

/// Goes over from the end of a curve to the start of the next.
void bridge(SurfaceCurve& curve,
            const SurfaceCurve& next,
            const geometry::AabbTree& surface,
            double maxSpacing) {
  const Vec3 a = curve.points.back();
  const Vec3 na = curve.normals.back();
  const Vec3 d = next.points.front() - a;
  // A few points at least, so that the bead follows a curved surface.
  constexpr double kLeastPieces = 4.0;
  const auto pieces = static_cast<int>(std::max(kLeastPieces, std::ceil(d.norm() / maxSpacing)));
  for (int k = 1; k < pieces; ++k) {
    const double s = static_cast<double>(k) / pieces;
    const auto hit = surface.closestPoint(a + s * d);
    curve.points.push_back(hit ? hit->p : Vec3(a + s * d));
    curve.normals.push_back((na + s * (next.normals.front() - na)).normalized());
  }
  curve.points.insert(curve.points.end(), next.points.begin(), next.points.end());
  curve.normals.insert(curve.normals.end(), next.normals.begin(), next.normals.end());
}

struct Pair {
  std::size_t chain = 0;
  std::size_t curve = 0;
  double distance = 0.0;
};

}  // namespace

std::vector<SurfaceCurve> insideBorder(const SurfaceCurve& curve,
                                       const geometry::SegmentTree& border,
                                       double margin) {
  const std::size_t n = curve.points.size();
  if (border.empty() || !(margin > 0.0) || n < 2) {
    return {curve};
  }
  // On its way between two points a curve may come near a corner of the border.
  constexpr double kLook = 0.25;
  constexpr double kRounding = 1e-10;
  const double least = (1.0 - kRounding) * margin;
  const auto inside = [&](const Vec3& p) { return border.distance(p, 2.0 * margin) >= least; };
  const auto at = [&](std::size_t i, double w) {
    const std::size_t j = (i + 1) % n;
    const Vec3 normal = (1.0 - w) * curve.normals[i] + w * curve.normals[j];
    return std::pair<Vec3, Vec3>{
        curve.points[i] + w * (curve.points[j] - curve.points[i]),
        normal.norm() > 0.0 ? Vec3(normal.normalized()) : curve.normals[i]};
  };
  std::vector<SurfaceCurve> pieces;
  SurfaceCurve piece;
  piece.line = curve.line;
  bool whole = true;
  const auto push = [&](const std::pair<Vec3, Vec3>& place) {
    piece.points.push_back(place.first);
    piece.normals.push_back(place.second);
  };
  const auto finish = [&] {
    if (piece.points.size() > 1) {
      pieces.push_back(piece);
    }
    piece.points.clear();
    piece.normals.clear();
  };
  bool in = inside(curve.points[0]);
  const bool startsInside = in;
  if (in) {
    push(at(0, 0.0));
  }
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i) {
    const double length = (curve.points[(i + 1) % n] - curve.points[i]).norm();
    const auto steps = static_cast<int>(std::max(1.0, std::ceil(length / (kLook * margin))));
    for (int k = 1; k <= steps; ++k) {
      double low = static_cast<double>(k - 1) / steps;
      double high = static_cast<double>(k) / steps;
      const bool next = inside(at(i, high).first);
      if (next != in) {
        whole = false;
        constexpr int kBisections = 40;
        for (int b = 0; b < kBisections; ++b) {
          const double middle = 0.5 * (low + high);
          (inside(at(i, middle).first) == in ? low : high) = middle;
        }
        push(at(i, in ? low : high));
        if (in) {
          finish();
        }
        in = next;
      }
    }
    if (in) {
      push({curve.points[(i + 1) % n], curve.normals[(i + 1) % n]});
    }
  }
  if (whole) {
    return in ? std::vector<SurfaceCurve>{curve} : std::vector<SurfaceCurve>{};
  }
  // A closed curve that begins inside: its last piece goes on in its first one.
  if (curve.closed && startsInside && in && !pieces.empty()) {
    SurfaceCurve& first = pieces.front();
    piece.points.insert(piece.points.end(), first.points.begin() + 1, first.points.end());
    piece.normals.insert(piece.normals.end(), first.normals.begin() + 1, first.normals.end());
    first = piece;
    return pieces;
  }
  finish();
  return pieces;
}

std::vector<SurfaceCurve> zigzag(const std::vector<SurfaceCurve>& curves,
                                 const geometry::AabbTree& surface,
                                 double reach,
                                 double maxSpacing) {
  std::vector<SurfaceCurve> chains;  // `line` is that of the last curve
  for (std::size_t from = 0; from < curves.size();) {
    std::size_t to = from;
    while (to < curves.size() && curves[to].line == curves[from].line) {
      ++to;
    }
    std::vector<SurfaceCurve> row(curves.begin() + static_cast<long>(from),
                                  curves.begin() + static_cast<long>(to));
    for (SurfaceCurve& curve : row) {
      if (!curve.closed && curve.line % 2 == 1) {
        reverse(curve);
      }
    }
    std::vector<Pair> pairs;
    for (std::size_t c = 0; c < chains.size(); ++c) {
      for (std::size_t r = 0; r < row.size(); ++r) {
        const bool follows = chains[c].line + 1 == row[r].line;
        if (follows && !chains[c].closed && !row[r].closed) {
          pairs.push_back({c, r, (row[r].points.front() - chains[c].points.back()).norm()});
        }
      }
    }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
    std::vector<char> taken(row.size(), 0);
    for (const Pair& pair : pairs) {
      if (pair.distance > reach || taken[pair.curve] != 0 ||
          chains[pair.chain].line == row[pair.curve].line) {
        continue;
      }
      bridge(chains[pair.chain], row[pair.curve], surface, maxSpacing);
      chains[pair.chain].line = row[pair.curve].line;
      taken[pair.curve] = 1;
    }
    for (std::size_t r = 0; r < row.size(); ++r) {
      if (taken[r] == 0) {
        chains.push_back(std::move(row[r]));
      }
    }
    from = to;
  }
  return chains;
}

toolpath::Contour raised(const SurfaceCurve& curve,
                         double height,
                         double layerHeight,
                         double width,
                         const toolpath::FillRoom& room,
                         std::size_t& folded) {
  toolpath::Contour contour;
  contour.closed = curve.closed;
  contour.feature = toolpath::BeadFeature::Cladding;
  const std::size_t n = curve.points.size();
  std::vector<Vec3> points(n);
  for (std::size_t i = 0; i < n; ++i) {
    points[i] = curve.points[i] + height * curve.normals[i];
  }
  const auto before = [&](std::size_t i) { return i > 0 ? i - 1 : (curve.closed ? n - 1 : 0); };
  const auto after = [&](std::size_t i) { return i + 1 < n ? i + 1 : (curve.closed ? 0 : n - 1); };
  const auto direction = [](const Vec3& d) {
    return d.norm() > 0.0 ? Vec3(d.normalized()) : Vec3(Vec3::Zero());
  };
  // What a bead has to fill is known per length of the curve on the surface.
  const auto lengthAround = [&](const std::vector<Vec3>& on, std::size_t i) {
    return (on[after(i)] - on[i]).norm() + (on[i] - on[before(i)]).norm();
  };
  constexpr double kMostStretch = 10.0;
  double s = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 on = curve.points[after(i)] - curve.points[before(i)];
    const Vec3 moved = points[after(i)] - points[before(i)];
    folded += moved.dot(on) < 0.0 ? 1U : 0U;
    // Halfway between both directions: within a right angle of every tangent at a corner.
    const Vec3 ahead = direction(curve.points[after(i)] - curve.points[i]);
    Vec3 t = direction(curve.points[i] - curve.points[before(i)]) + ahead;
    constexpr double kTurnsBack = 1e-6;
    t = t.norm() > kTurnsBack ? t : ahead;
    const Vec3& normal = curve.normals[i];
    Vec3 across = normal.cross(t);
    across = across.norm() > kTurnsBack ? Vec3(across.normalized()) : normal.unitOrthogonal();
    contour.points.push_back({points[i], across, layerHeight, width});
    s += i > 0 ? (curve.points[i] - curve.points[i - 1]).norm() : 0.0;
    const double flat = lengthAround(curve.points, i);
    const double stretch =
        flat > 0.0 ? std::clamp(lengthAround(points, i) / flat, 1.0 / kMostStretch, kMostStretch)
                   : 1.0;
    contour.points.back().fillWidth = room.at(s) / stretch;
  }
  return contour;
}

namespace {

toolpath::ContourPoint between(const toolpath::ContourPoint& a,
                               const toolpath::ContourPoint& b,
                               double w) {
  toolpath::ContourPoint point = a;
  point.p += w * (b.p - a.p);
  const Vec3 n = (1.0 - w) * a.n + w * b.n;
  point.n = n.norm() > 0.0 ? Vec3(n.normalized()) : a.n;
  point.fillWidth += w * (b.fillWidth - a.fillWidth);
  return point;
}

}  // namespace

std::vector<toolpath::Contour> aboveSubstrate(const toolpath::Contour& contour,
                                              const toolpath::Substrate& substrate) {
  const std::size_t n = contour.points.size();
  std::vector<double> height;
  height.reserve(n);
  for (const toolpath::ContourPoint& point : contour.points) {
    height.push_back(substrate.heightAbove(point.p));
  }
  const auto below = [&](std::size_t i) { return height[i] < 0.0; };
  std::size_t first = 0;
  while (first < n && !below(first)) {
    ++first;
  }
  if (first == n) {
    return {contour};
  }
  // A closed bead is opened at a point below, so that no piece runs over its start.
  const std::size_t start = contour.closed ? first : 0;
  const std::size_t count = contour.closed ? n + 1 : n;
  std::vector<toolpath::Contour> pieces;
  toolpath::Contour piece = contour;
  piece.closed = false;
  piece.points.clear();
  const auto finish = [&] {
    if (piece.points.size() > 1) {
      pieces.push_back(piece);
    }
    piece.points.clear();
  };
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = (start + k) % n;
    if (k > 0) {
      const std::size_t before = (start + k - 1) % n;
      if (below(i) != below(before)) {
        const double w = height[before] / (height[before] - height[i]);
        // A point on the substrate itself is its own crossing.
        constexpr double kSamePoint = 1e-9;
        if (w > kSamePoint && w < 1.0 - kSamePoint) {
          piece.points.push_back(between(contour.points[before], contour.points[i], w));
        }
      }
    }
    if (below(i)) {
      finish();
    } else {
      piece.points.push_back(contour.points[i]);
    }
  }
  finish();
  return pieces;
}

void densify(toolpath::Contour& contour, double maxSpacing) {
  constexpr double kMostPieces = 1e6;  // a kilometre by millimetres
  const std::size_t n = contour.points.size();
  std::vector<toolpath::ContourPoint> points;
  points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const toolpath::ContourPoint& here = contour.points[i];
    points.push_back(here);
    if (i + 1 == n && !contour.closed) {
      break;
    }
    const toolpath::ContourPoint& next = contour.points[(i + 1) % n];
    const double wanted = std::ceil((next.p - here.p).norm() / maxSpacing - 1e-9);
    const auto pieces = static_cast<int>(std::clamp(wanted, 1.0, kMostPieces));
    for (int k = 1; k < pieces; ++k) {
      points.push_back(between(here, next, static_cast<double>(k) / pieces));
    }
  }
  contour.points = std::move(points);
}

}  // namespace wcam::cladding
