// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/guide_curve.hpp"

#include "wcam/base/budget.hpp"
#include "wcam/base/error.hpp"
#include "wcam/base/file_io.hpp"
#include "wcam/base/plausible.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/base/text.hpp"

#include "formula.hpp"
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <mutex>

namespace wcam::geometry {

GuideCurve::~GuideCurve() = default;

namespace {

class EdgeGuide : public GuideCurve {
public:
  EdgeGuide(std::shared_ptr<const Brep> brep, int edge, bool reversed)
      : brep_(std::move(brep)),
        evaluator_(*brep_),
        edge_(edge),
        range_(brep_->edge(edge).range),
        reversed_(reversed) {}

  [[nodiscard]] double begin() const override { return range_[0]; }

  [[nodiscard]] double end() const override { return range_[1]; }

  [[nodiscard]] CurvePoint evaluate(double t) const override {
    const std::lock_guard lock(mutex_);
    if (!reversed_) {
      return evaluator_.curve(edge_, t);
    }
    CurvePoint point = evaluator_.curve(edge_, range_[0] + range_[1] - t);
    point.d1 = -point.d1;
    return point;
  }

private:
  std::shared_ptr<const Brep> brep_;
  mutable std::mutex mutex_;
  BrepEvaluator evaluator_;
  int edge_;
  std::array<double, 2> range_;
  bool reversed_;
};

/// Cubic spline with not-a-knot ends (natural for three points or fewer) over the chord length.
class SplineGuide : public GuideCurve {
public:
  explicit SplineGuide(std::vector<Vec3> points) : points_(std::move(points)) {
    knots_.push_back(0.0);
    for (std::size_t i = 1; i < points_.size(); ++i) {
      knots_.push_back(knots_.back() + (points_[i] - points_[i - 1]).norm());
    }
    solveSecondDerivatives();
  }

  [[nodiscard]] double begin() const override { return knots_.front(); }

  [[nodiscard]] double end() const override { return knots_.back(); }

  [[nodiscard]] CurvePoint evaluate(double t) const override {
    const auto upper = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, t);
    const auto i = static_cast<std::size_t>(upper - knots_.begin()) - 1;
    const double h = knots_[i + 1] - knots_[i];
    const double a = (knots_[i + 1] - t) / h;
    const double b = (t - knots_[i]) / h;
    CurvePoint c;
    c.p = a * points_[i] + b * points_[i + 1] +
          ((a * a * a - a) * second_[i] + (b * b * b - b) * second_[i + 1]) * (h * h / 6.0);
    c.d1 = (points_[i + 1] - points_[i]) / h +
           ((3.0 * b * b - 1.0) * second_[i + 1] - (3.0 * a * a - 1.0) * second_[i]) * (h / 6.0);
    c.d2 = a * second_[i] + b * second_[i + 1];
    return c;
  }

private:
  void solveSecondDerivatives() {
    const auto n = static_cast<Eigen::Index>(points_.size());
    second_.assign(points_.size(), Vec3::Zero());
    if (n < 3) {
      return;
    }
    const auto step = [this](Eigen::Index i) {
      return knots_[static_cast<std::size_t>(i) + 1] - knots_[static_cast<std::size_t>(i)];
    };
    // Tridiagonal but for the not-a-knot rows; guides have few points, so a dense solve is fine.
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(n, n);
    Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(n, 3);
    for (Eigen::Index i = 1; i + 1 < n; ++i) {
      const double h0 = step(i - 1);
      const double h1 = step(i);
      m(i, i - 1) = h0 / 6.0;
      m(i, i) = (h0 + h1) / 3.0;
      m(i, i + 1) = h1 / 6.0;
      const auto k = static_cast<std::size_t>(i);
      rhs.row(i) =
          ((points_[k + 1] - points_[k]) / h1 - (points_[k] - points_[k - 1]) / h0).transpose();
    }
    if (n > 3) {
      m(0, 0) = step(1);
      m(0, 1) = -(step(0) + step(1));
      m(0, 2) = step(0);
      m(n - 1, n - 3) = step(n - 2);
      m(n - 1, n - 2) = -(step(n - 3) + step(n - 2));
      m(n - 1, n - 1) = step(n - 3);
    } else {
      m(0, 0) = 1.0;
      m(n - 1, n - 1) = 1.0;
    }
    const Eigen::MatrixXd solution = m.partialPivLu().solve(rhs);
    for (Eigen::Index i = 0; i < n; ++i) {
      second_[static_cast<std::size_t>(i)] = solution.row(i).transpose();
    }
  }

  std::vector<Vec3> points_;
  std::vector<double> knots_;
  std::vector<Vec3> second_;
};

/// Formulas; derivatives by central differences with Richardson extrapolation.
class FormulaGuide : public GuideCurve {
public:
  FormulaGuide(const std::array<std::string, 3>& xyz, double begin, double end)
      : begin_(begin), end_(end) {
    for (std::size_t i = 0; i < 3; ++i) {
      formulas_.emplace_back(xyz[i], std::vector<std::string>{"t"},
                             "guide formula " + std::string(1, "xyz"[i]) + "(t)");
    }
    constexpr int kProbes = 64;
    Vec3 before = value(begin);
    for (int i = 1; i <= kProbes; ++i) {
      const double from = begin + (end - begin) * (i - 1) / kProbes;
      const double to = begin + (end - begin) * i / kProbes;
      const Vec3 here = value(to);
      requireUnbroken(from, before, to, here);
      before = here;
    }
  }

  [[nodiscard]] double begin() const override { return begin_; }

  [[nodiscard]] double end() const override { return end_; }

  [[nodiscard]] CurvePoint evaluate(double t) const override {
    const std::lock_guard lock(mutex_);
    // Sixth-order differences: the step balances truncation (h^6) against rounding (eps/h, eps/h²).
    constexpr double kStepOfRange = 2e-3;
    const double h = (end_ - begin_) * kStepOfRange;
    CurvePoint c = differences(t, h);
    if (!c.d1.allFinite() || !c.d2.allFinite()) {
      // The formula ends at the end of the range: the nearest place with all neighbours inside.
      c = differences(std::clamp(t, begin_ + 3 * h, end_ - 3 * h), h);
    }
    c.p = value(t);
    return c;
  }

private:
  [[nodiscard]] CurvePoint differences(double t, double h) const {
    const Vec3 p = raw(t);
    const Vec3 a1 = raw(t + h), b1 = raw(t - h), a2 = raw(t + 2 * h), b2 = raw(t - 2 * h),
               a3 = raw(t + 3 * h), b3 = raw(t - 3 * h);
    CurvePoint c;
    c.p = p;
    c.d1 = (45.0 * (a1 - b1) - 9.0 * (a2 - b2) + (a3 - b3)) / (60.0 * h);
    c.d2 = (270.0 * (a1 + b1) - 27.0 * (a2 + b2) + 2.0 * (a3 + b3) - 490.0 * p) / (180.0 * h * h);
    return c;
  }

  [[nodiscard]] Vec3 raw(double t) const {
    return {formulas_[0](t), formulas_[1](t), formulas_[2](t)};
  }

  /// Follows the larger half of a stretch down to rounding: there a smooth curve has all but
  /// stopped, a jump is as large as ever, and a pole has left the range.
  void requireUnbroken(double low, Vec3 atLow, double high, Vec3 atHigh) const {
    constexpr int kHalvings = 44;
    constexpr double kStopped = 1e-3;
    const double whole = (atHigh - atLow).norm();
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (low + high);
      const Vec3 atMiddle = value(middle);
      const bool first = (atMiddle - atLow).norm() > (atHigh - atMiddle).norm();
      (first ? high : low) = middle;
      (first ? atHigh : atLow) = atMiddle;
    }
    if ((atHigh - atLow).norm() > kStopped * whole && whole > kStillJump) {
      throw Error(ErrorCode::InvalidArgument,
                  text("the formula jumps by %1 mm at t = %2",
                       {formatFixed((atHigh - atLow).norm(), 3), formatFixed(low, 6)}),
                  "guide formula", "change the formula or its range: a guide is one smooth curve");
    }
  }

  [[nodiscard]] Vec3 value(double t) const {
    const Vec3 p = raw(t);
    for (const double x : p) {
      if (const Text wrong = implausible(x, QuantityKind::Length); !wrong.empty()) {
        throw Error(ErrorCode::InvalidArgument,
                    text("the guide leaves its range at t = %1: %2", {formatFixed(t, 6), wrong}),
                    "guide formula", "change the formula or its range");
      }
    }
    return p;
  }

  /// Differences below are rounding of formulas, mm.
  static constexpr double kStillJump = 1e-6;

  double begin_;
  double end_;
  mutable std::mutex mutex_;
  std::vector<Formula> formulas_;
};

}  // namespace

std::shared_ptr<const GuideCurve> guideFromEdge(std::shared_ptr<const Brep> brep,
                                                int edge,
                                                bool reversed) {
  if (brep == nullptr) {
    throw Error(ErrorCode::InvalidArgument, "the part is a mesh and has no CAD edges", "guide",
                "use a polyline or a formula");
  }
  if (edge < 0 || edge >= brep->edgeCount()) {
    throw Error(ErrorCode::InvalidArgument, text("there is no edge %1", {std::to_string(edge)}),
                "guide",
                text("edges are numbered 0 to %1; `camcli info` lists them",
                     {std::to_string(brep->edgeCount() - 1)}));
  }
  return std::make_shared<EdgeGuide>(std::move(brep), edge, reversed);
}

std::shared_ptr<const GuideCurve> guideFromPoints(std::vector<Vec3> points) {
  if (points.size() < 2) {
    throw Error(ErrorCode::InputInvalid, "a guide needs at least two points", "guide");
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0 && points[i] == points[i - 1]) {
      throw Error(ErrorCode::InputInvalid,
                  text("point %1 repeats the one before it", {std::to_string(i + 1)}), "guide",
                  "remove the point");
    }
    for (const double x : points[i]) {
      if (const Text wrong = implausible(x, QuantityKind::Length); !wrong.empty()) {
        throw Error(ErrorCode::InputInvalid, text("point %1: %2", {std::to_string(i + 1), wrong}),
                    "guide", "correct the point");
      }
    }
  }
  return std::make_shared<SplineGuide>(std::move(points));
}

namespace {

/// Commas between digits beside another separator: "1,5;2,5;3" or "1,5 2,5 3".
bool isDecimalComma(std::string_view line) {
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  bool between = false;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    between = between || (line[i] == ',' && isDigit(line[i - 1]) && isDigit(line[i + 1]));
  }
  return between && trimText(line).find_first_of("; \t") != std::string_view::npos &&
         line.find(", ") == std::string_view::npos;
}

}  // namespace

std::shared_ptr<const GuideCurve> guideFromFile(const std::string& file) {
  return guideFromText(readFile(pathFromText(file)), file);
}

std::shared_ptr<const GuideCurve> guideFromText(std::string_view text, const std::string& file) {
  std::vector<Vec3> points;
  int lineNumber = 0;
  for (const std::string& raw : splitText(text, '\n')) {
    ++lineNumber;
    std::string line(trimText(raw.substr(0, raw.find('#'))));
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == ',' || c == ';' || c == '\t'; }, ' ');
    std::vector<std::string> words = splitText(line, ' ');
    std::erase(words, "");
    if (words.empty()) {
      continue;
    }
    std::vector<double> numbers;
    for (const std::string& word : words) {
      if (const auto number = parseReal(word)) {
        numbers.push_back(*number);
      }
    }
    if (numbers.empty() && points.empty()) {
      continue;  // the header line
    }
    if (isDecimalComma(raw.substr(0, raw.find('#')))) {
      throw Error(ErrorCode::InputInvalid,
                  wcam::text("line %1: decimal commas", {std::to_string(lineNumber)}), file,
                  "write decimal points, and x y z in mm, one point per line");
    }
    if (words.size() != 3 || numbers.size() != 3) {
      throw Error(ErrorCode::InputInvalid,
                  wcam::text("line %1 is not three numbers", {std::to_string(lineNumber)}), file,
                  "write x y z in mm, one point per line");
    }
    points.emplace_back(numbers[0], numbers[1], numbers[2]);
  }
  try {
    return guideFromPoints(std::move(points));
  } catch (const Error& error) {
    throw Error(error.code(), error.messageText(), file, error.hintText());
  }
}

std::shared_ptr<const GuideCurve> guideFromFormula(const std::array<std::string, 3>& xyz,
                                                   double begin,
                                                   double end) {
  if (!(begin < end) || !std::isfinite(begin) || !std::isfinite(end)) {
    throw Error(ErrorCode::InvalidArgument, "the range must ascend", "guide formula",
                "give begin < end");
  }
  return std::make_shared<FormulaGuide>(xyz, begin, end);
}

CurveFrame frenetFrame(const CurvePoint& point, bool* valid) {
  CurveFrame frame;
  frame.tangent = point.d1.normalized();
  const Vec3 binormal = point.d1.cross(point.d2);
  // Below this the curvature is rounding noise: a radius of more than a million times the speed
  // scale.
  constexpr double kFlat = 1e-9;
  const bool curved =
      binormal.norm() > kFlat * point.d1.norm() * std::max(point.d1.norm(), point.d2.norm());
  if (valid != nullptr) {
    *valid = curved;
  }
  frame.binormal = curved ? binormal.normalized() : frame.tangent.unitOrthogonal();
  frame.normal = frame.binormal.cross(frame.tangent);
  return frame;
}

std::vector<CurveFrame> rotationMinimisingFrames(const GuideCurve& curve,
                                                 const std::vector<double>& parameters,
                                                 const Vec3& seed) {
  std::vector<CurveFrame> frames;
  CurvePoint previous;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const CurvePoint point = curve.evaluate(parameters[i]);
    CurveFrame frame;
    frame.tangent = point.d1.normalized();
    Vec3 normal = seed;
    if (i > 0) {
      const Vec3 v1 = point.p - previous.p;
      const Vec3& n0 = frames.back().normal;
      const Vec3& t0 = frames.back().tangent;
      const double c1 = v1.squaredNorm();
      if (c1 > 0.0) {
        const Vec3 nL = n0 - (2.0 / c1) * v1.dot(n0) * v1;
        const Vec3 tL = t0 - (2.0 / c1) * v1.dot(t0) * v1;
        const Vec3 v2 = frame.tangent - tL;
        const double c2 = v2.squaredNorm();
        normal = c2 > 0.0 ? Vec3(nL - (2.0 / c2) * v2.dot(nL) * v2) : nL;
      } else {
        normal = n0;
      }
    }
    normal -= normal.dot(frame.tangent) * frame.tangent;
    frame.normal = normal.norm() > 0.0 ? Vec3(normal.normalized()) : frame.tangent.unitOrthogonal();
    frame.binormal = frame.tangent.cross(frame.normal);
    frames.push_back(frame);
    previous = point;
  }
  return frames;
}

double arcLength(const GuideCurve& curve, double from, double to) {
  // Gauss-Legendre with five nodes on 64 panels: error of order (h^10), far below 1e-10 for guides.
  constexpr std::array<double, 5> kNode = {0.0, 0.5384693101056831, -0.5384693101056831,
                                           0.9061798459386640, -0.9061798459386640};
  constexpr std::array<double, 5> kWeight = {0.5688888888888889, 0.4786286704993665,
                                             0.4786286704993665, 0.2369268850561891,
                                             0.2369268850561891};
  constexpr int kPanels = 64;
  double length = 0.0;
  const double half = (to - from) / (2.0 * kPanels);
  for (int i = 0; i < kPanels; ++i) {
    const double middle = from + (2 * i + 1) * half;
    for (std::size_t k = 0; k < kNode.size(); ++k) {
      length += kWeight[k] * half * curve.evaluate(middle + half * kNode[k]).d1.norm();
    }
  }
  return length;
}

std::vector<double> chordSteps(const GuideCurve& curve,
                               double step,
                               double from,
                               const JobContext& context) {
  WCAM_ASSERT(step > 0.0);
  std::vector<double> parameters{from};
  const double range = curve.end() - curve.begin();
  // A scan step that no chord of `step` can jump over, then bisection down to rounding.
  constexpr double kScanOfRange = 1e-2;
  constexpr double kScanOfStep = 0.1;
  constexpr double kRounding = 1e-15;
  constexpr int kBisections = 100;
  constexpr std::size_t kCheckEvery = 256;
  const std::size_t kMostChords = budget().layers;
  const double length = arcLength(curve, curve.begin(), curve.end());
  const double scan = length > 0.0 ? range * std::min(kScanOfRange, kScanOfStep * step / length)
                                   : range * kScanOfRange;
  while (true) {
    const double start = parameters.back();
    const Vec3 origin = curve.evaluate(start).p;
    double low = start;
    double high = start;
    bool found = false;
    for (std::size_t k = 0; high < curve.end(); ++k) {
      if (k % kCheckEvery == 0) {
        context.check();
      }
      high = std::min(curve.end(), low + scan);
      if ((curve.evaluate(high).p - origin).norm() >= step) {
        found = true;
        break;
      }
      low = high;
    }
    if (!found) {
      // A chord that rounding keeps from the end ends there.
      constexpr double kOnEnd = 1e-9;
      if (start < curve.end() &&
          (curve.evaluate(curve.end()).p - origin).norm() >= (1.0 - kOnEnd) * step) {
        parameters.push_back(curve.end());
      }
      return parameters;
    }
    for (int i = 0; i < kBisections && high - low > kRounding * range; ++i) {
      const double middle = 0.5 * (low + high);
      ((curve.evaluate(middle).p - origin).norm() >= step ? high : low) = middle;
    }
    parameters.push_back(0.5 * (low + high));
    if (parameters.size() > kMostChords) {
      throw Error(ErrorCode::JobFailed,
                  text("the guide has more than %1 layers of %2 mm",
                       {std::to_string(kMostChords), formatFixed(step, 6)}),
                  "guide", "shorten the guide or raise the step");
    }
  }
}

}  // namespace wcam::geometry
