// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "path_model.hpp"

#include "wcam/base/quantity.hpp"
#include "wcam/cell/kinematics.hpp"
#include "wcam/cell/unwrap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::gui {

namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

double degreesBetween(const geometry::Vec3& a, const geometry::Vec3& b) {
  return radToDeg(std::atan2(a.cross(b).norm(), a.dot(b)));
}

/// Canonical joint values of the arm (see cell::Arm).
cell::Vector6 canonical(const cell::Arm& arm, const cell::JointVector& q) {
  return arm.gain * q.head<6>() + arm.offset;
}

/// How far the wrist centre may still move outwards, mm.
double reachMargin(const cell::Arm& arm, const cell::JointVector& q) {
  const cell::Vector6 c = canonical(arm, q);
  const geometry::Vec3 wrist = (arm.T_base_canonical.inverse() * cell::forwardArm(arm, q.data()) *
                                arm.T_wrist_flange.inverse())
                                   .translation();
  const geometry::Vec3 shoulder(arm.a1 * std::cos(c[0]), arm.a1 * std::sin(c[0]), 0.0);
  return cell::armReach(arm) - (wrist - shoulder).norm();
}

}  // namespace

const char* unitOf(Quantity quantity) noexcept {
  switch (quantity) {
    case Quantity::Height:
    case Quantity::Distance:
    case Quantity::Width:
    case Quantity::ReachMargin:
    case Quantity::Clearance:
      return "mm";
    case Quantity::TravelSpeed:
    case Quantity::TcpSpeed:
      return "mm/s";
    case Quantity::WireSpeed:
      return "m/min";
    case Quantity::Tilt:
    case Quantity::Overhang:
    case Quantity::Singularity:
    case Quantity::LimitMargin:
      return "°";
    case Quantity::Time:
      return "s";
    case Quantity::Layer:
    case Quantity::Feature:
    case Quantity::Finding:
      break;
  }
  return "";
}

PathModel::PathModel(std::shared_ptr<const project::OperationResult> result)
    : result_(std::move(result)) {
  auto data = std::make_shared<viewport::PathData>();
  layerBegin_.push_back(0);
  if (result_->motion != nullptr && !result_->motion->motion.waypoints.empty()) {
    fromMotion(*data);
  } else if (result_->path != nullptr) {
    fromPath(*data);
  }
  if (result_->path != nullptr) {
    layerBegin_.resize(result_->path->layers.size() + 1, size());
    layerBegin_.back() = size();
  }
  data_ = std::move(data);
  prepared_ = viewport::prepare(data_);
}

void PathModel::addMove(int layer,
                        int bead,
                        int point,
                        double time,
                        const toolpath::PathPoint* like,
                        const geometry::Vec3& p,
                        bool deposits,
                        viewport::PathData& data) {
  while (static_cast<int>(layerBegin_.size()) <= layer) {
    layerBegin_.push_back(size());
  }
  const geometry::Vec3 build = like != nullptr ? like->b : geometry::Vec3::UnitZ();
  const geometry::Vec3 side = like != nullptr ? like->n : geometry::Vec3::UnitX();
  for (int i = 0; i < 3; ++i) {
    data.positions.push_back(static_cast<float>(p[i]));
    data.build.push_back(static_cast<float>(build[i]));
    data.side.push_back(static_cast<float>(side[i]));
  }
  data.heights.push_back(like != nullptr ? static_cast<float>(like->height) : 0.0F);
  data.widths.push_back(like != nullptr ? static_cast<float>(like->width) : 0.0F);
  data.deposits.push_back(deposits ? 1 : 0);
  data.layers.push_back(static_cast<std::uint32_t>(layer));
  layer_.push_back(layer);
  bead_.push_back(bead);
  point_.push_back(point);
  time_.push_back(time);
}

void PathModel::fromMotion(viewport::PathData& data) {
  const auto& waypoints = result_->motion->motion.waypoints;
  // A move between beads belongs to the layer that it leads to.
  std::vector<int> layers(waypoints.size(), 0);
  int next = -1;
  for (std::size_t i = waypoints.size(); i-- > 0;) {
    if (waypoints[i].point >= 0) {
      next = waypoints[i].layer;
    }
    layers[i] = next;
  }
  int last = 0;
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    const motion::Waypoint& w = waypoints[i];
    last = std::max(last, layers[i]);
    const toolpath::PathPoint* point = nullptr;
    if (w.point >= 0) {
      point = &result_->path->layers[static_cast<std::size_t>(w.layer)]
                   .beads[static_cast<std::size_t>(w.bead)]
                   .points[static_cast<std::size_t>(w.point)];
    }
    const bool deposits = w.arc && w.point > 0 && i > 0 && waypoints[i - 1].point >= 0;
    addMove(last, w.point >= 0 ? w.bead : -1, w.point, w.time, point,
            point != nullptr ? point->p : geometry::Vec3(w.T_part_tcp.translation()), deposits,
            data);
  }
}

void PathModel::fromPath(viewport::PathData& data) {
  double time = 0.0;
  for (std::size_t l = 0; l < result_->path->layers.size(); ++l) {
    const auto& beads = result_->path->layers[l].beads;
    for (std::size_t b = 0; b < beads.size(); ++b) {
      const auto& points = beads[b].points;
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (i > 0 && points[i].speed > 0.0) {
          time += (points[i].p - points[i - 1].p).norm() / points[i].speed;
        }
        addMove(static_cast<int>(l), static_cast<int>(b), static_cast<int>(i), time, &points[i],
                points[i].p, i > 0 && points[i].arc, data);
      }
    }
  }
}

std::size_t PathModel::moveAt(double time) const {
  const auto found = std::lower_bound(time_.begin(), time_.end(), time);
  return std::min(static_cast<std::size_t>(found - time_.begin()), size() - 1);
}

std::optional<std::size_t> PathModel::find(int layer, int bead, int point) const {
  if (layer < 0 || layer >= layerCount()) {
    return std::nullopt;
  }
  std::optional<std::size_t> best;
  for (std::size_t i = layerBegin(layer); i < layerBegin(layer + 1); ++i) {
    if (point_[i] < 0 || (bead >= 0 && bead_[i] != bead)) {
      continue;
    }
    if (point < 0 || point_[i] == point) {
      return i;
    }
    best = i;
  }
  return best;
}

const toolpath::PathPoint* PathModel::pathPoint(std::size_t move) const {
  if (move >= size() || point_[move] < 0) {
    return nullptr;
  }
  return &result_->path->layers[static_cast<std::size_t>(layer_[move])]
              .beads[static_cast<std::size_t>(bead_[move])]
              .points[static_cast<std::size_t>(point_[move])];
}

const motion::Waypoint* PathModel::waypoint(std::size_t move) const {
  if (result_->motion == nullptr || move >= result_->motion->motion.waypoints.size()) {
    return nullptr;
  }
  return &result_->motion->motion.waypoints[move];
}

viewport::Point PathModel::position(std::size_t move) const {
  const float* p = &data_->positions[3 * move];
  return {p[0], p[1], p[2]};
}

std::vector<float> PathModel::findings() const {
  // 0: nothing, 1: information, 2: warning, 3: violation; a finding without a point marks its bead
  // or layer.
  std::vector<float> marks(size(), 0.0F);
  for (const Diagnostic& d : result_->findings) {
    const auto mark = static_cast<float>(1 + static_cast<int>(d.severity));
    if (d.place.layer < 0 || d.place.layer >= layerCount()) {
      continue;
    }
    for (std::size_t i = layerBegin(d.place.layer); i < layerBegin(d.place.layer + 1); ++i) {
      if ((d.place.bead < 0 || bead_[i] == d.place.bead) && point_[i] >= 0 &&
          (d.place.point < 0 || std::abs(point_[i] - d.place.point) <= 1)) {
        marks[i] = std::max(marks[i], mark);
      }
    }
  }
  return marks;
}

std::vector<float> PathModel::values(Quantity quantity) const {
  if (quantity == Quantity::Finding) {
    return findings();
  }
  const geometry::Vec3 up =
      result_->substrate != nullptr ? result_->substrate->up() : geometry::Vec3::UnitZ();
  const cell::Cell* cell = result_->cell.get();
  const auto ofPoint = [&](const toolpath::PathPoint& p) -> double {
    switch (quantity) {
      case Quantity::Height:
        return p.height;
      case Quantity::Distance:
        return p.distance;
      case Quantity::Width:
        return p.width;
      case Quantity::TravelSpeed:
        return p.speed;
      case Quantity::WireSpeed:
        return toFileUnit(QuantityKind::WireSpeed, p.wireSpeed);
      case Quantity::Tilt:
        return degreesBetween(p.axis, p.up);
      case Quantity::Overhang:
        return degreesBetween(p.b, up);
      default:
        return kNone;
    }
  };
  const auto ofWaypoint = [&](const motion::Waypoint& w) -> double {
    switch (quantity) {
      case Quantity::TcpSpeed:
        return w.tcpSpeed;
      case Quantity::LimitMargin: {
        double margin = std::numeric_limits<double>::infinity();
        for (int j = 0; j < cell->jointCount(); ++j) {
          // Degrees and mm do not compare: of the joints that turn.
          if (!cell->joint(j).prismatic()) {
            margin = std::min(margin, cell::limitMargin(cell->joint(j), w.joints[j]));
          }
        }
        return std::isfinite(margin) ? radToDeg(margin) : kNone;
      }
      case Quantity::Singularity:
        return cell->arm && w.reachable
                   ? radToDeg(std::asin(
                         std::min(1.0, std::abs(std::sin(canonical(*cell->arm, w.joints)[4])))))
                   : kNone;
      case Quantity::ReachMargin:
        return cell->arm && w.reachable ? reachMargin(*cell->arm, w.joints) : kNone;
      default:
        return kNone;
    }
  };
  const bool motionNeeded = quantity == Quantity::TcpSpeed || quantity == Quantity::LimitMargin ||
                            quantity == Quantity::Singularity || quantity == Quantity::ReachMargin;
  std::vector<float> values(size(), kNone);
  if (quantity == Quantity::Clearance) {
    const std::vector<float>& distance = result_->collisions.distance;
    std::copy_n(distance.begin(), std::min(distance.size(), size()), values.begin());
    return values;
  }
  for (std::size_t i = 0; i < size(); ++i) {
    if (quantity == Quantity::Layer) {
      values[i] = static_cast<float>(layer_[i]);
    } else if (quantity == Quantity::Time) {
      values[i] = static_cast<float>(time_[i]);
    } else if (point_[i] < 0) {
      continue;
    } else if (quantity == Quantity::Feature) {
      values[i] = static_cast<float>(result_->path->layers[static_cast<std::size_t>(layer_[i])]
                                         .beads[static_cast<std::size_t>(bead_[i])]
                                         .feature);
    } else if (motionNeeded) {
      if (const motion::Waypoint* w = waypoint(i); w != nullptr && cell != nullptr) {
        values[i] = static_cast<float>(ofWaypoint(*w));
      }
    } else {
      values[i] = static_cast<float>(ofPoint(*pathPoint(i)));
    }
  }
  return values;
}

}  // namespace wcam::gui
