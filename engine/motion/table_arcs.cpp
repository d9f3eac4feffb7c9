// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "table_arcs.hpp"

#include "vertical_tolerance.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::motion::detail {

namespace {

constexpr double kTurn = 2.0 * kPi;
/// Axes that are parallel to within this sine have no arcs.
constexpr double kParallel = 1e-3;
/// Radius (of sines) below which a direction has no azimuth about the table's axis.
constexpr double kNoAzimuth = 1e-12;

void addSampled(const TableArc& arc,
                const TableArc& sampled,
                const std::vector<double>& centres,
                std::vector<TableNode>& nodes) {
  for (auto k = static_cast<int>(std::ceil(sampled.low / kTurnSample));
       k * kTurnSample <= sampled.high; ++k) {
    nodes.push_back({k * kTurnSample, arc});
  }
  for (const double centre : centres) {
    nodes.push_back({std::clamp(centre, arc.low, arc.high), arc});
  }
}

}  // namespace

double TiltLaw::at(double turn) const {
  const Vec3 factors(1.0, std::cos(turn), std::sin(turn));
  return std::atan2(across.dot(factors), along.dot(factors));
}

TableArcs::TableArcs(const Cell& cell, const MotionParams& params)
    : params_(params), vertical_(cell.verticalInBase()) {
  const PositionerValues zero{};
  const cell::ChainAxes axes = cell::chainAxes(cell.positioner, zero.data());
  R_base_part_ = axes.T_root_tip.linear() * cell.T_table_part.linear();
  k1_ = axes.directions[0];
  k2_ = axes.directions[1];
  cosine_ = k1_.dot(k2_);
  level_ = std::asin(std::clamp(k1_.dot(vertical_), -1.0, 1.0));
  const cell::Joint& last = cell.joint(cell.jointCount() - 1);
  if (!last.endless) {
    limits_ = TableArc{std::min(last.sign * last.min, last.sign * last.max),
                       std::max(last.sign * last.min, last.sign * last.max)};
  }
}

bool TableArcs::parallel() const {
  return k1_.cross(k2_).norm() < kParallel;
}

TableArcs::Swing TableArcs::swing(const Vec3& up) const {
  const Vec3 p = R_base_part_ * up;
  const Vec3 from = p - k2_ * k2_.dot(p);
  const Vec3 to = k1_ - k2_ * cosine_;
  return {cosine_ * k2_.dot(p), from.norm() * to.norm(),
          std::atan2(k2_.dot(from.cross(to)), from.dot(to))};
}

std::array<double, 2> TableArcs::exact(const Vec3& up) const {
  const Swing s = swing(up);
  const double x = s.radius > kNoAzimuth
                       ? std::acos(std::clamp((std::sin(level_) - s.offset) / s.radius, -1.0, 1.0))
                       : 0.5 * kPi;
  return {s.zero + x, s.zero - x};
}

TiltLaw TableArcs::tiltLaw(const Vec3& up) const {
  const Vec3 p = R_base_part_ * up;
  const Vec3 axial = k2_ * k2_.dot(p);
  const Vec3 parts[] = {axial, p - axial, k2_.cross(p)};
  const Vec3 along = vertical_ - k1_ * k1_.dot(vertical_);
  const Vec3 across = along.cross(k1_);
  TiltLaw law;
  for (int k = 0; k < 3; ++k) {
    law.across(k) = across.dot(parts[k]);
    law.along(k) = along.dot(parts[k]);
  }
  return law;
}

void TableArcs::nodes(const Vec3& up, double freedom, std::vector<TableNode>& nodes) const {
  addNodes(up, freedom, nodes);
  const TiltLaw law = tiltLaw(up);
  for (TableNode& node : nodes) {
    node.tilt = law.at(node.turn);
  }
}

bool TableArcs::anyTurn(const Vec3& up, double freedom) const {
  return freedom > 0.0 && reach(up, freedom).all();
}

TableArc TableArcs::everything(double turn) const {
  constexpr double kEndless = 1e3;
  return limits_ ? *limits_ : TableArc{turn - kEndless, turn + kEndless};
}

TableArcs::Reach TableArcs::reach(const Vec3& up, double freedom) const {
  const Swing s = swing(up);
  const auto angle = [](double sine) { return std::asin(std::clamp(sine, -1.0, 1.0)); };
  const double least =
      std::max({0.0, angle(s.offset - s.radius) - level_, level_ - angle(s.offset + s.radius)});
  const double most = least + freedom * (allowedVerticalError(params_, least) - least);
  const double low = std::sin(std::max(level_ - most, -0.5 * kPi)) - s.offset;
  const double high = std::sin(std::min(level_ + most, 0.5 * kPi)) - s.offset;
  const double inner = high >= s.radius ? 0.0 : std::acos(std::clamp(high / s.radius, -1.0, 1.0));
  const double outer = low <= -s.radius ? kPi : std::acos(std::clamp(low / s.radius, -1.0, 1.0));
  return {s, inner, outer};
}

void TableArcs::addNodes(const Vec3& up, double freedom, std::vector<TableNode>& nodes) const {
  nodes.clear();
  const std::array<double, 2> centres = exact(up);
  if (!(freedom > 0.0)) {
    addLifted({centres[0], centres[0]}, {centres[0]}, nodes);
    addLifted({centres[1], centres[1]}, {centres[1]}, nodes);
    return;
  }
  const Reach r = reach(up, freedom);
  const auto [s, inner, outer] = r;
  const std::vector<double> both(centres.begin(), centres.end());
  if (r.all()) {
    const TableArc all = everything(0.0);
    addSampled(all, limits_ ? all : TableArc{0.0, kTurn - 0.5 * kTurnSample}, {}, nodes);
  } else if (inner == 0.0) {
    addLifted({s.zero - outer, s.zero + outer}, both, nodes);
  } else if (outer == kPi) {
    // Around the far side.
    addLifted({s.zero + inner, s.zero + kTurn - inner}, {centres[0], centres[1] + kTurn}, nodes);
  } else {
    addLifted({s.zero + inner, s.zero + outer}, {centres[0]}, nodes);
    addLifted({s.zero - outer, s.zero - inner}, {centres[1]}, nodes);
  }
}

/// An arc with all its full turns inside the limits.
void TableArcs::addLifted(const TableArc& arc,
                          const std::vector<double>& centres,
                          std::vector<TableNode>& nodes) const {
  if (!limits_) {
    addSampled(arc, arc, centres, nodes);
    return;
  }
  const auto first = static_cast<int>(std::ceil((limits_->low - arc.high) / kTurn));
  const auto last = static_cast<int>(std::floor((limits_->high - arc.low) / kTurn));
  for (int k = first; k <= last; ++k) {
    const TableArc own{std::max(arc.low + k * kTurn, limits_->low),
                       std::min(arc.high + k * kTurn, limits_->high)};
    std::vector<double> lifted = centres;
    for (double& centre : lifted) {
      centre += k * kTurn;
    }
    addSampled(own, own, lifted, nodes);
  }
}

}  // namespace wcam::motion::detail
