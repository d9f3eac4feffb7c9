// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/text.hpp"
#include "wcam/cell/joint_text.hpp"
#include "wcam/motion/speed_law.hpp"
#include "wcam/motion/trace.hpp"

#include "plan_detail.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::motion::detail {

namespace {

constexpr std::size_t kCheckEvery = 4096;
/// A joint that uses this part of its greatest speed is what holds the torch back.
constexpr double kAtSpeed = 0.999;

/// What holds the torch back at a waypoint.
struct Limiter {
  int joint = -1;
  double share = 0.0;  ///< of the limit that is used
  bool bySpeed = false;
  bool byTorch = false;  ///< the acceleration of the torch itself, no joint
};

Limiter limiterAt(const Motion& motion,
                  const std::vector<JointBounds>& bounds,
                  const MotionParams& params,
                  std::size_t i) {
  const std::vector<Waypoint>& points = motion.waypoints;
  Limiter limiter;
  const std::size_t last = std::min(i + 1, points.size() - 1);
  const double before = points[i].time - points[i - 1].time;
  const double after = points[last].time - points[i].time;
  for (std::size_t j = 0; j < bounds.size(); ++j) {
    const auto k = static_cast<Eigen::Index>(j);
    const double v0 = before > 0.0 ? (points[i].joints(k) - points[i - 1].joints(k)) / before : 0.0;
    const double v1 = after > 0.0 ? (points[last].joints(k) - points[i].joints(k)) / after : v0;
    const double speedShare = std::max(std::abs(v0), std::abs(v1)) / bounds[j].speed;
    const double gain = before + after > 0.0 ? 2.0 * std::abs(v1 - v0) / (before + after) : 0.0;
    const double gainShare =
        std::isfinite(bounds[j].acceleration) ? gain / bounds[j].acceleration : 0.0;
    if (std::max(speedShare, gainShare) > limiter.share) {
      limiter = {static_cast<int>(j), std::max(speedShare, gainShare), speedShare >= gainShare};
    }
  }
  if (params.tcpAcceleration > 0.0 && before + after > 0.0) {
    const auto at = [&](std::size_t k) -> Vec3 { return points[k].T_part_tcp.translation(); };
    const Vec3 v0 = before > 0.0 ? Vec3((at(i) - at(i - 1)) / before) : Vec3::Zero();
    const Vec3 v1 = after > 0.0 ? Vec3((at(last) - at(i)) / after) : v0;
    const double share = 2.0 * (v1 - v0).norm() / (before + after) / params.tcpAcceleration;
    if (share > limiter.share) {
      limiter = {-1, share, false, true};
    }
  }
  return limiter;
}

/// Ratios of predicted to wanted speed along the points of a bead on which the arc burns.
struct BeadSpeeds {
  std::vector<double> ratio;
  std::vector<std::size_t> waypoint;
};

/// Beads of a path without a process are as wide as its default, mm.
constexpr double kUnknownWidth = 8.0;

/// A bead shorter than it is wide is all start and end: it may take this many times as long.
constexpr double kDot = 3.0;

/// The stretch of a bead on which the torch loses most time.
struct Crawl {
  std::size_t waypoint = 0;  ///< the slowest of the stretch
  double length = 0.0;       ///< mm
  double time = 0.0;         ///< s
  double wanted = 0.0;       ///< s at the wanted speed
  double excess = 0.0;       ///< s beyond what the minimum speed allows
};

/// Looks at all stretches of a bead that are as long as it is wide. A shorter slow-down, as at ends
/// and corners, melts into one pool with what is beside it; there counts how much time it takes
/// against a stretch of that length, so that a halt is found however short its way is.
Crawl worstCrawl(const std::vector<Waypoint>& points,
                 const std::vector<std::size_t>& bead,
                 double width,
                 double minRatio) {
  std::vector<double> length{0.0};
  std::vector<double> wanted{0.0};
  std::vector<double> time{0.0};
  for (const std::size_t i : bead) {
    const double way =
        (points[i].T_part_tcp.translation() - points[i - 1].T_part_tcp.translation()).norm();
    length.push_back(length.back() + way);
    wanted.push_back(wanted.back() + way / points[i].speed);
    time.push_back(time.back() + points[i].time - points[i - 1].time);
  }
  Crawl worst;
  std::size_t begin = 0;
  for (std::size_t end = 1; end < length.size(); ++end) {
    while (begin + 1 < end && length[end] - length[begin + 1] >= width) {
      ++begin;
    }
    const double own = wanted[end] - wanted[begin];
    const double taken = time[end] - time[begin];
    const double pool = std::max(own, width / points[bead[end - 1]].speed);
    const bool dot = length[end] - length[begin] < width;
    const double excess = taken - own - (dot ? kDot : 1.0) * pool * (1.0 / minRatio - 1.0);
    if (excess > worst.excess) {
      worst = {bead[end - 1], length[end] - length[begin], taken, own, excess};
      for (std::size_t k = begin; k < end; ++k) {
        const std::size_t i = bead[k];
        worst.waypoint = points[i].tcpSpeed < points[worst.waypoint].tcpSpeed ? i : worst.waypoint;
      }
    }
  }
  return worst;
}

double widthOf(const toolpath::Toolpath& path, const Waypoint& point) {
  if (point.layer < 0 || point.bead < 0 || point.point < 0) {
    return kUnknownWidth;
  }
  const double width = path.layers[static_cast<std::size_t>(point.layer)]
                           .beads[static_cast<std::size_t>(point.bead)]
                           .points[static_cast<std::size_t>(point.point)]
                           .width;
  return width > 0.0 ? width : kUnknownWidth;
}

class Reporter {
public:
  Reporter(const Cell& cell,
           const Motion& motion,
           const MotionParams& params,
           std::string operation,
           const JobContext& context)
      : cell_(cell),
        motion_(motion),
        params_(params),
        bounds_(jointBounds(cell, params)),
        operation_(std::move(operation)),
        context_(context) {}

  void bead(const BeadSpeeds& speeds) const {
    std::size_t dips = 0;
    std::size_t peaks = 0;
    const SpeedEvent* dip = nullptr;
    const SpeedEvent* peak = nullptr;
    const std::vector<SpeedEvent> events = speedEvents(speeds.ratio, params_.speedTolerance);
    for (const SpeedEvent& event : events) {
      // The torch starts and ends every bead at rest; joints at full speed are told elsewhere.
      const bool ramp = (event.atStart || event.atEnd) && !(event.atStart && event.atEnd);
      const Limiter limiter = limiterAt(motion_, bounds_, params_, speeds.waypoint[event.index]);
      if (event.peak) {
        ++peaks;
        peak = peak == nullptr || event.ratio > peak->ratio ? &event : peak;
      } else if (!ramp && !(limiter.bySpeed && limiter.share >= kAtSpeed)) {
        ++dips;
        dip = dip == nullptr || event.ratio < dip->ratio ? &event : dip;
      }
    }
    if (dip != nullptr) {
      report(*dip, speeds.waypoint[dip->index], dips);
    }
    if (peak != nullptr) {
      report(*peak, speeds.waypoint[peak->index], peaks);
    }
  }

  void crawl(const BeadSpeeds& speeds, double width) const {
    const Crawl worst =
        worstCrawl(motion_.waypoints, speeds.waypoint, width, params_.minSpeedRatio);
    if (!(worst.excess > 0.0)) {
      return;
    }
    const Waypoint& point = motion_.waypoints[worst.waypoint];
    const Limiter limiter = limiterAt(motion_, bounds_, params_, worst.waypoint);
    const double mean = worst.length / worst.time;
    const double ratio = worst.wanted / worst.time;
    context_.add(
        {Severity::Violation,
         "motion.too_slow",
         text(limiter.byTorch
                  ? "the torch needs %1 s for %2 mm with the arc on, %3 mm/s or %4 % of the wanted "
                    "speed, and %5 mm/s at the slowest point; nearest to its limit is the "
                    "acceleration of the torch"
              : limiter.joint < 0
                  ? "the torch needs %1 s for %2 mm with the arc on, %3 mm/s or %4 % of the wanted "
                    "speed, and %5 mm/s at the slowest point"
                  : "the torch needs %1 s for %2 mm with the arc on, %3 mm/s or %4 % of the wanted "
                    "speed, and %5 mm/s at the slowest point; nearest to its limit is joint %6",
              {formatFixed(worst.time, 2), formatFixed(worst.length, 1), formatFixed(mean, 2),
               formatFixed(ratio * 100.0, 1), formatFixed(point.tcpSpeed, 2),
               limiter.joint < 0 ? std::string() : cell_.joint(limiter.joint).name}),
         crawlRemedy(limiter),
         {operation_, point.layer, point.bead, point.point},
         {{"speed_mm_s", point.tcpSpeed},
          {"mean_speed_mm_s", mean},
          {"speed_ratio", ratio},
          {"length_mm", worst.length},
          {"time_s", worst.time},
          {"joint", limiter.joint + 1.0}}});
  }

  void reversals(const std::vector<Reversal>& all) const {
    for (const Reversal& reversal : all) {
      const Waypoint& point = motion_.waypoints[reversal.waypoint];
      const double effect = reversal.effect.norm();
      if (!point.arc || !(effect > params_.reversalEffect.value())) {
        continue;
      }
      context_.add({Severity::Information,
                    "motion.reversal",
                    text("joint %1 turns round; its backlash moves the torch by %2 mm",
                         {cell_.joint(reversal.joint).name, formatFixed(effect, 3)}),
                    "place the part so that the joint keeps its direction, or expect a mark",
                    {operation_, point.layer, point.bead, point.point},
                    {{"joint", reversal.joint + 1.0},
                     {"direction", static_cast<double>(reversal.direction)},
                     {"time_s", reversal.time},
                     {"effect_mm", effect}}});
    }
  }

private:
  /// By what holds the torch back.
  [[nodiscard]] Text crawlRemedy(const Limiter& limiter) const {
    if (limiter.byTorch) {
      return text(
          "raise tcp_acceleration if the robot can do more, smooth the path, allow more rounding "
          "of corners (corner_radius) or lower the travel speed; lower min_speed_ratio only where "
          "the process bears it");
    }
    const bool assumed = limiter.joint >= 0 && !limiter.bySpeed && params_.accelerationTime > 0.0 &&
                         !std::isfinite(cell_.joint(limiter.joint).maxAcceleration);
    if (assumed) {
      return text(
          "shorten acceleration_time if the robot's axes are faster, smooth the path, allow more "
          "rounding of corners (corner_radius) or lower the travel speed; lower min_speed_ratio "
          "only where the process bears it");
    }
    return text(
        params_.mode == RedundancyMode::Optimized
            ? "smooth the path (axis_rate bounds the turn of its build direction), raise "
              "vertical_tolerance or lower the travel speed; lower min_speed_ratio only where the "
              "process bears it"
            : "use the mode optimized, smooth the path (axis_rate bounds the turn of its build "
              "direction), raise vertical_tolerance or lower the travel speed; lower "
              "min_speed_ratio only where the process bears it");
  }

  void report(const SpeedEvent& event, std::size_t waypoint, std::size_t count) const {
    const Waypoint& point = motion_.waypoints[waypoint];
    const Limiter limiter = limiterAt(motion_, bounds_, params_, waypoint);
    const Text name = limiter.byTorch     ? text("the acceleration of the torch (tcp_acceleration)")
                      : limiter.joint < 0 ? text("no joint")
                                          : text("joint %1", {cell_.joint(limiter.joint).name});
    const std::string speed = formatFixed(point.tcpSpeed, 2);
    const std::string percent = formatFixed(event.ratio * 100.0, 1);
    const std::string places = std::to_string(count);
    std::vector<std::pair<std::string, double>> data = {
        {"speed_mm_s", point.tcpSpeed}, {"speed_ratio", event.ratio},
        {"joint", limiter.joint + 1.0}, {"limit_share", limiter.share},
        {"time_s", point.time},         {"places", static_cast<double>(count)}};
    const Place place{operation_, point.layer, point.bead, point.point};
    if (event.peak) {
      context_.add({Severity::Warning, "motion.speed_peak",
                    text(count > 1 ? "the torch is predicted to run at %1 mm/s, %2 % of the wanted "
                                     "speed, the worst of %3 places"
                                   : "the torch is predicted to run at %1 mm/s, %2 % of the wanted "
                                     "speed",
                         {speed, percent, places}),
                    "let the length of the path lead the motion, not an axis", place, data});
    } else {
      context_.add(
          {Severity::Warning, "motion.speed_dip",
           text(count > 1 ? "the torch is predicted to slow down to %1 mm/s, %2 % of the wanted "
                            "speed; nearest to its limit is %4, the worst of %3 places"
                          : "the torch is predicted to slow down to %1 mm/s, %2 % of the wanted "
                            "speed; nearest to its limit is %4",
                {speed, percent, places, name}),
           "smooth the path, allow more rounding of corners, lower the travel speed, or "
           "let the wire feed follow (wire_follows_speed)",
           place, data});
    }
  }

  const Cell& cell_;
  const Motion& motion_;
  const MotionParams& params_;
  std::vector<JointBounds> bounds_;
  std::string operation_;
  const JobContext& context_;
};

}  // namespace

void reportSpeeds(const Cell& cell,
                  const Motion& motion,
                  const toolpath::Toolpath& path,
                  const MotionParams& params,
                  const std::string& operationId,
                  const std::vector<Reversal>& reversals,
                  const JobContext& context) {
  const Reporter reporter(cell, motion, params, operationId, context);
  BeadSpeeds speeds;
  const std::vector<Waypoint>& points = motion.waypoints;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (i % kCheckEvery == 0) {
      context.check();
    }
    const Waypoint& point = points[i];
    if (point.arc && point.speed > 0.0 && point.kind == MoveKind::Linear && point.reachable &&
        points[i - 1].reachable) {
      speeds.ratio.push_back(point.tcpSpeed / point.speed);
      speeds.waypoint.push_back(i);
    }
    const bool ends = i + 1 == points.size() || !points[i + 1].arc ||
                      points[i + 1].bead != point.bead || points[i + 1].layer != point.layer;
    if (ends && !speeds.ratio.empty()) {
      reporter.bead(speeds);
      reporter.crawl(speeds, widthOf(path, point));
      speeds = {};
    }
  }
  reporter.reversals(reversals);
}

}  // namespace wcam::motion::detail
