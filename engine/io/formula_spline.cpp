// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formula_spline.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/figure.hpp"
#include "wcam/base/text.hpp"

#include <Eigen/Dense>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <algorithm>
#include <cmath>
#include <vector>

namespace wcam::io {

using geometry::Vec3;

namespace {

constexpr int kDegree = 5;
constexpr int kFirstIntervals = 16;
constexpr int kMostIntervals = 512;
/// What is aimed at, in parts of the size.
constexpr double kAimedAccuracy = 1e-9;
/// What is still accepted at the finest grid, in parts of the size and in mm: a hundredth of a
/// chord error.
constexpr double kNeededRelative = 1e-7;
constexpr double kNeeded = 1e-4;

bool nearEnough(double deviation, double size) {
  return deviation <= std::max(kNeededRelative * size, kNeeded);
}

/// Ends of a closed direction agree to this part of the size; up to what is accepted otherwise they
/// are joined.
constexpr double kClosed = 1e-9;
/// Places inside an interval where function and spline are compared: the middle, where the error of
/// an odd degree is largest, and one beside it.
constexpr std::array<double, 2> kProbes = {0.5, 0.27};

[[noreturn]] void notSmooth(const std::string& place, double deviation) {
  throw Error(ErrorCode::InputInvalid,
              text("the surface cannot be met exactly: %1 spans leave a distance of %2 mm",
                   {std::to_string(kMostIntervals), formatFixed(deviation, 9)}),
              place, "split the range where the formula has a corner or a vertical tangent");
}

/// Distinct knots of the interpolating spline on n uniform intervals: the data sites without the
/// two next to each end (not-a-knot).
std::vector<double> distinctKnots(double from, double to, int n) {
  std::vector<double> knots;
  for (int i = 0; i <= n; ++i) {
    if (i == 0 || i == n || (i > kDegree / 2 && i < n - kDegree / 2)) {
      knots.push_back(i == n ? to : from + (to - from) * i / n);
    }
  }
  return knots;
}

/// Values of all basis functions at the data sites: row i for site i.
Eigen::MatrixXd collocation(double from, double to, int n) {
  const std::vector<double> distinct = distinctKnots(from, to, n);
  std::vector<double> knots(kDegree, distinct.front());
  knots.insert(knots.end(), distinct.begin(), distinct.end());
  knots.insert(knots.end(), kDegree, distinct.back());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + 1, n + 1);
  for (int i = 0; i <= n; ++i) {
    const double x = i == n ? to : from + (to - from) * i / n;
    int span = kDegree;
    while (span < n && x >= knots[static_cast<std::size_t>(span) + 1]) {
      ++span;
    }
    const auto knot = [&](int k) { return knots[static_cast<std::size_t>(k)]; };
    std::array<double, kDegree + 1> basis{1.0};
    for (int d = 1; d <= kDegree; ++d) {
      double saved = 0.0;
      for (int r = 0; r < d; ++r) {
        const double right = knot(span + r + 1) - x;
        const double left = x - knot(span + 1 - d + r);
        const double part = basis[static_cast<std::size_t>(r)] / (right + left);
        basis[static_cast<std::size_t>(r)] = saved + right * part;
        saved = left * part;
      }
      basis[static_cast<std::size_t>(d)] = saved;
    }
    for (int r = 0; r <= kDegree; ++r) {
      matrix(i, span - kDegree + r) = basis[static_cast<std::size_t>(r)];
    }
  }
  return matrix;
}

struct KnotArrays {
  TColStd_Array1OfReal knots;
  TColStd_Array1OfInteger multiplicities;

  explicit KnotArrays(const std::vector<double>& distinct)
      : knots(1, static_cast<int>(distinct.size())),
        multiplicities(1, static_cast<int>(distinct.size())) {
    for (int i = 1; i <= knots.Length(); ++i) {
      knots(i) = distinct[static_cast<std::size_t>(i) - 1];
      multiplicities(i) = i == 1 || i == knots.Length() ? kDegree + 1 : 1;
    }
  }
};

double siteAt(const std::array<double, 2>& range, double i, int n) {
  return i >= n ? range[1] : range[0] + (range[1] - range[0]) * i / n;
}

Vec3 finite(const Vec3& p, const std::string& where, const std::string& place) {
  if (!p.allFinite()) {
    throw Error(ErrorCode::InputInvalid, text("the formula has no finite value at %1", {where}),
                place, "change the formula or its range");
  }
  return p;
}

class SurfaceFit {
public:
  SurfaceFit(const SurfaceFunction& function,
             const std::array<double, 2>& u,
             const std::array<double, 2>& v,
             bool closedU,
             bool closedV,
             const std::string& place)
      : function_(function), u_(u), v_(v), closedU_(closedU), closedV_(closedV), place_(place) {}

  void interpolate(int nu, int nv) {
    std::array<Eigen::MatrixXd, 3> grid;
    grid.fill(Eigen::MatrixXd(nu + 1, nv + 1));
    geometry::Box box;
    for (int i = 0; i <= nu; ++i) {
      for (int j = 0; j <= nv; ++j) {
        const Vec3 p = value(siteAt(u_, i, nu), siteAt(v_, j, nv));
        box.add(p);
        for (int c = 0; c < 3; ++c) {
          grid[static_cast<std::size_t>(c)](i, j) = p[c];
        }
      }
    }
    size_ = box.diagonal();
    if (!(size_ > 0.0)) {
      throw Error(ErrorCode::InputInvalid, "the surface is a single point", place_,
                  "check the formulas");
    }
    joined_ = 0.0;
    if (closedU_) {
      close(grid, true);
    }
    if (closedV_) {
      close(grid, false);
    }
    const Eigen::PartialPivLU<Eigen::MatrixXd> alongU(collocation(u_[0], u_[1], nu));
    const Eigen::PartialPivLU<Eigen::MatrixXd> alongV(collocation(v_[0], v_[1], nv));
    TColgp_Array2OfPnt poles(1, nu + 1, 1, nv + 1);
    for (int c = 0; c < 3; ++c) {
      const Eigen::MatrixXd& values = grid[static_cast<std::size_t>(c)];
      Eigen::MatrixXd solved = alongU.solve(values);
      Eigen::MatrixXd result = alongV.solve(solved.transpose()).transpose();
      copyClosed(result);
      for (int i = 0; i <= nu; ++i) {
        for (int j = 0; j <= nv; ++j) {
          poles(i + 1, j + 1).SetCoord(c + 1, result(i, j));
        }
      }
    }
    const KnotArrays ku(distinctKnots(u_[0], u_[1], nu));
    const KnotArrays kv(distinctKnots(v_[0], v_[1], nv));
    spline_ = new Geom_BSplineSurface(poles, ku.knots, kv.knots, ku.multiplicities,
                                      kv.multiplicities, kDegree, kDegree);
    nu_ = nu;
    nv_ = nv;
  }

  /// Largest distance between function and spline at places off the grid in the chosen directions.
  [[nodiscard]] double deviation(bool offU, bool offV) const {
    double largest = 0.0;
    for (const double probe : kProbes) {
      for (int i = 0; i < nu_ + (offU ? 0 : 1); ++i) {
        for (int j = 0; j < nv_ + (offV ? 0 : 1); ++j) {
          const double u = siteAt(u_, i + (offU ? probe : 0.0), nu_);
          const double v = siteAt(v_, j + (offV ? probe : 0.0), nv_);
          gp_Pnt p;
          spline_->D0(u, v, p);
          largest = std::max(largest, (value(u, v) - Vec3(p.X(), p.Y(), p.Z())).norm());
        }
      }
    }
    return largest;
  }

  [[nodiscard]] double size() const { return size_; }

  /// By how much ends of closed directions were moved, mm.
  [[nodiscard]] double joined() const { return joined_; }

  [[nodiscard]] const Handle(Geom_BSplineSurface) & spline() const { return spline_; }

private:
  [[nodiscard]] Vec3 at(double u, double v) const {
    return finite(function_(u, v), "u = " + formatFixed(u, 6) + ", v = " + formatFixed(v, 6),
                  place_);
  }

  /// The function, with the gap of a closed direction spread over its range.
  [[nodiscard]] Vec3 value(double u, double v) const {
    Vec3 p = at(u, v);
    if (closedU_) {
      p -= (u - u_[0]) / (u_[1] - u_[0]) * (at(u_[1], v) - at(u_[0], v));
    }
    if (closedV_) {
      p -= (v - v_[0]) / (v_[1] - v_[0]) * (at(u, v_[1]) - at(u, v_[0]));
    }
    return p;
  }

  /// Refuses a direction that does not close, and makes its ends equal to the last bit.
  void close(std::array<Eigen::MatrixXd, 3>& grid, bool alongU) {
    const Eigen::Index n = alongU ? grid[0].cols() : grid[0].rows();
    const std::array<double, 2>& other = alongU ? v_ : u_;
    double gap = 0.0;
    for (Eigen::Index k = 0; k < n; ++k) {
      const double place = siteAt(other, static_cast<double>(k), static_cast<int>(n) - 1);
      gap = std::max(gap, alongU ? (at(u_[1], place) - at(u_[0], place)).norm()
                                 : (at(place, v_[1]) - at(place, v_[0])).norm());
    }
    if (gap > kClosed * size_ && !nearEnough(gap, size_)) {
      throw Error(ErrorCode::InputInvalid,
                  text("the surface is not closed in %1: its ends are %2 mm apart",
                       {alongU ? "u" : "v", formatFigure(gap)}),
                  place_, "correct the range, or do not declare it as closed");
    }
    joined_ = std::max(joined_, gap > kClosed * size_ ? gap : 0.0);
    for (Eigen::MatrixXd& values : grid) {
      if (alongU) {
        values.row(values.rows() - 1) = values.row(0);
      } else {
        values.col(values.cols() - 1) = values.col(0);
      }
    }
  }

  void copyClosed(Eigen::MatrixXd& poles) const {
    if (closedU_) {
      poles.row(poles.rows() - 1) = poles.row(0);
    }
    if (closedV_) {
      poles.col(poles.cols() - 1) = poles.col(0);
    }
  }

  const SurfaceFunction& function_;
  std::array<double, 2> u_;
  std::array<double, 2> v_;
  bool closedU_;
  bool closedV_;
  const std::string& place_;
  double size_ = 0.0;
  double joined_ = 0.0;
  int nu_ = 0;
  int nv_ = 0;
  Handle(Geom_BSplineSurface) spline_;
};

}  // namespace

Fitted<Geom_BSplineSurface> fitSurface(const SurfaceFunction& function,
                                       const std::array<double, 2>& u,
                                       const std::array<double, 2>& v,
                                       bool closedU,
                                       bool closedV,
                                       const std::string& place,
                                       const JobContext& context) {
  SurfaceFit fit(function, u, v, closedU, closedV, place);
  int nu = kFirstIntervals;
  int nv = kFirstIntervals;
  while (true) {
    context.check();
    fit.interpolate(nu, nv);
    const double aimed = kAimedAccuracy * fit.size();
    const bool moreU = fit.deviation(true, false) > aimed && nu < kMostIntervals;
    const bool moreV = fit.deviation(false, true) > aimed && nv < kMostIntervals;
    if (!moreU && !moreV) {
      break;
    }
    nu *= moreU ? 2 : 1;
    nv *= moreV ? 2 : 1;
  }
  const double deviation =
      std::max({fit.deviation(true, true), fit.deviation(true, false), fit.deviation(false, true)});
  if (!nearEnough(deviation, fit.size())) {
    notSmooth(place, deviation);
  }
  return {fit.spline(), std::max(deviation, fit.joined())};
}

Fitted<Geom_BSplineCurve> fitCurve(const CurveFunction& function,
                                   double size,
                                   const std::string& place,
                                   const JobContext& context) {
  constexpr std::array<double, 2> kRange = {0.0, 1.0};
  for (int n = kFirstIntervals;; n *= 2) {
    context.check();
    Eigen::MatrixXd values(n + 1, 3);
    for (int i = 0; i <= n; ++i) {
      values.row(i) = function(siteAt(kRange, i, n)).transpose();
    }
    Eigen::MatrixXd solved =
        Eigen::PartialPivLU<Eigen::MatrixXd>(collocation(0.0, 1.0, n)).solve(values);
    solved.row(0) = values.row(0);
    solved.row(n) = values.row(n);
    TColgp_Array1OfPnt poles(1, n + 1);
    for (int i = 0; i <= n; ++i) {
      poles(i + 1) = gp_Pnt(solved(i, 0), solved(i, 1), solved(i, 2));
    }
    const KnotArrays knots(distinctKnots(0.0, 1.0, n));
    const Handle(Geom_BSplineCurve) curve =
        new Geom_BSplineCurve(poles, knots.knots, knots.multiplicities, kDegree);
    double deviation = 0.0;
    for (const double probe : kProbes) {
      for (int i = 0; i < n; ++i) {
        const double s = siteAt(kRange, i + probe, n);
        const gp_Pnt p = curve->Value(s);
        deviation = std::max(deviation, (function(s) - Vec3(p.X(), p.Y(), p.Z())).norm());
      }
    }
    if (deviation <= kAimedAccuracy * size) {
      return {curve, deviation};
    }
    if (n >= kMostIntervals) {
      if (!nearEnough(deviation, size)) {
        notSmooth(place, deviation);
      }
      return {curve, deviation};
    }
  }
}

}  // namespace wcam::io
