// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "speed_law_detail.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::motion::detail {

namespace {

constexpr std::size_t kCheckEvery = 4096;

/// Appends a time with constant acceleration over `length` from x = a to x = b. The acceleration is
/// given: of a very short ramp the difference of speeds would be rounding.
void addRamp(
    double length, double a, double b, double acceleration, std::vector<SpeedInterval>& intervals) {
  const double va = std::sqrt(a);
  const double vb = std::sqrt(b);
  if (!(length > 0.0) || !(va + vb > 0.0)) {
    return;
  }
  intervals.push_back({2.0 * length / (va + vb), va, acceleration});
}

/// A straight piece as straightTime in speed_law.cpp goes it.
void addStraight(double length,
                 double a,
                 double b,
                 double gain,
                 double cap,
                 std::vector<SpeedInterval>& intervals) {
  const double top = std::max({std::min(cap, 0.5 * (a + b) + gain * length), a, b});
  const double up = std::min((top - a) / (2.0 * gain), length);
  const double down = std::min((top - b) / (2.0 * gain), length - up);
  addRamp(up, a, top, gain, intervals);
  addRamp(length - up - down, top, top, 0.0, intervals);
  addRamp(down, top, b, -gain, intervals);
}

/// Way and its integral over time of a law made of intervals, evaluated at growing times.
class WayOverTime {
public:
  WayOverTime(const std::vector<SpeedInterval>& intervals, double start)
      : intervals_(intervals), start_(start), into_(-start) {}

  /// Goes on to a time not before the last one.
  void advance(double time) {
    while (index_ < intervals_.size() && time >= start_ + intervals_[index_].time) {
      const SpeedInterval& interval = intervals_[index_];
      const double t = interval.time;
      area_ += t * (way_ + t * (0.5 * interval.speed + t * interval.acceleration / 6.0));
      way_ += t * (interval.speed + 0.5 * t * interval.acceleration);
      start_ += t;
      ++index_;
    }
    into_ = time - start_;
  }

  /// Before the start everything rests at 0, after the end at the whole way.
  [[nodiscard]] double way() const {
    return resting() ? way_ : way_ + into_ * (now().speed + 0.5 * into_ * now().acceleration);
  }

  [[nodiscard]] double area() const {
    return resting() ? area_ + std::max(into_, 0.0) * way_
                     : area_ + into_ * (way_ + into_ * (0.5 * now().speed +
                                                        into_ * now().acceleration / 6.0));
  }

  [[nodiscard]] double speed() const {
    return resting() ? 0.0 : now().speed + into_ * now().acceleration;
  }

  [[nodiscard]] double acceleration() const { return resting() ? 0.0 : now().acceleration; }

  /// Time at which the present interval ends (the sum that advance compares with); infinite after
  /// the last.
  [[nodiscard]] double nextBreak() const {
    return into_ < 0.0                  ? start_
           : index_ < intervals_.size() ? start_ + intervals_[index_].time
                                        : std::numeric_limits<double>::infinity();
  }

private:
  [[nodiscard]] bool resting() const { return into_ < 0.0 || index_ >= intervals_.size(); }

  [[nodiscard]] const SpeedInterval& now() const { return intervals_[index_]; }

  const std::vector<SpeedInterval>& intervals_;
  std::size_t index_ = 0;
  double start_;
  double way_ = 0.0;
  double area_ = 0.0;
  double into_;
};

/// A moment of the averaged law.
struct Moment {
  double time = 0.0;
  double way = 0.0;
  double speed = 0.0;
  double acceleration = 0.0;
  double jerk = 0.0;  ///< from here on
};

/// Checks moments against the limits at the place where they happen.
class ShareCheck {
public:
  ShareCheck(const SpeedPath& path,
             const SpeedLimits& limits,
             const SpeedPieces& pieces,
             FilteredLaw& result)
      : path_(path), limits_(limits), pieces_(pieces), result_(result) {}

  void add(const Moment& moment) {
    const std::size_t n = path_.size();
    while (segment_ + 1 < n && moment.way > end_ + path_.length[segment_]) {
      end_ += path_.length[segment_++];
    }
    // The two points whose zones the place may lie in.
    const double into = moment.way - end_;
    const double half = 0.5 * path_.length[segment_];
    const std::size_t corner = into < half ? segment_ - 1 : segment_;
    const double toCorner = into < half ? into : path_.length[segment_] - into;
    const double zone = 0.5 * pieces_.zone[corner];
    const bool inZone = zone > 0.0 && toCorner < zone;
    const double x = moment.speed * moment.speed;
    const double cap = inZone ? pieces_.zoneCap[corner] : pieces_.cap[segment_];
    result_.speedShare = std::max(result_.speedShare, std::sqrt(x / cap));
    addJoints(moment, segment_, inZone ? corner : 0, into < half ? toCorner : -toCorner);
  }

private:
  /// @param corner 0 on a straight piece
  void addJoints(const Moment& moment, std::size_t segment, std::size_t corner, double beyond) {
    const auto joints = static_cast<std::size_t>(path_.joints);
    const auto width = static_cast<std::size_t>(pieces_.width);
    const double x = moment.speed * moment.speed;
    for (std::size_t j = 0; j < joints; ++j) {
      double slope = pieces_.slope[segment * width + j];
      double curvature = 0.0;
      if (corner > 0) {
        const double k0 = pieces_.slope[corner * width + j];
        const double k1 = pieces_.slope[(corner + 1) * width + j];
        curvature = (k1 - k0) / pieces_.zone[corner];
        slope = 0.5 * (k0 + k1) + curvature * beyond;
      }
      const double gain = std::abs(slope * moment.acceleration + curvature * x);
      result_.accelerationShare = std::max(result_.accelerationShare, gain);
      const JointBounds& bounds = limits_.joints[j];
      if (std::isfinite(bounds.jerk) && std::isfinite(bounds.acceleration)) {
        const double jerk =
            std::abs(slope * moment.jerk + 3.0 * curvature * moment.speed * moment.acceleration);
        result_.jerkShare = std::max(result_.jerkShare, jerk * bounds.acceleration / bounds.jerk);
      }
    }
  }

  const SpeedPath& path_;
  const SpeedLimits& limits_;
  const SpeedPieces& pieces_;
  FilteredLaw& result_;
  std::size_t segment_ = 1;
  double end_ = 0.0;  ///< way at the start of the segment
};

/// The average (1/T)·∫ of a law over the last T seconds: its way is a cubic of time between breaks.
class Average {
public:
  Average(const std::vector<SpeedInterval>& intervals, double window)
      : now_(intervals, 0.0), then_(intervals, window), window_(window) {
    go(0.0);
  }

  void go(double time) {
    time_ = time;
    now_.advance(time);
    then_.advance(time);
  }

  [[nodiscard]] Moment moment() const {
    return {time_, (now_.area() - then_.area()) / window_, (now_.way() - then_.way()) / window_,
            (now_.speed() - then_.speed()) / window_,
            (now_.acceleration() - then_.acceleration()) / window_};
  }

  [[nodiscard]] double nextBreak() const { return std::min(now_.nextBreak(), then_.nextBreak()); }

private:
  WayOverTime now_;
  WayOverTime then_;
  double window_;
  double time_ = 0.0;
};

/// Time after `from` at which its cubic reaches a way; between 0 and `length`.
double timeOf(const Moment& from, double way, double length) {
  double low = 0.0;
  double high = length;
  double t = 0.5 * length;
  constexpr int kSteps = 100;
  for (int step = 0; step < kSteps; ++step) {
    const double speed = from.speed + t * (from.acceleration + 0.5 * t * from.jerk);
    const double gap =
        from.way + t * (from.speed + t * (0.5 * from.acceleration + t * from.jerk / 6.0)) - way;
    (gap > 0.0 ? high : low) = t;
    double next = speed > 0.0 ? t - gap / speed : 0.5 * (low + high);
    if (!(next > low && next < high)) {
      next = 0.5 * (low + high);
    }
    if (std::abs(next - t) <= 1e-15 * length || next == t) {
      return next;
    }
    t = next;
  }
  return t;
}

}  // namespace

void speedIntervals(const SpeedPieces& pieces,
                    const SpeedNodes& nodes,
                    std::vector<SpeedInterval>& intervals,
                    std::vector<std::size_t>& marks) {
  const std::size_t n = pieces.cap.size();
  marks.assign(n, 0);
  for (std::size_t i = 1; i < n; ++i) {
    if (pieces.straight[i] > 0.0) {
      addStraight(pieces.straight[i], nodes.after[i - 1], nodes.before[i], pieces.gain[i],
                  pieces.cap[i], intervals);
    }
    marks[i] = intervals.size();
    const double zone = pieces.zone[i];
    addRamp(zone, nodes.before[i], nodes.after[i],
            zone > 0.0 ? (nodes.after[i] - nodes.before[i]) / (2.0 * zone) : 0.0, intervals);
  }
}

FilteredLaw averageLaw(const SpeedPath& path,
                       const SpeedLimits& limits,
                       const SpeedPieces& pieces,
                       const std::vector<SpeedInterval>& intervals,
                       double window,
                       const JobContext& context) {
  const std::size_t n = path.size();
  FilteredLaw result;
  result.law.time.assign(n, 0.0);
  result.law.speed.assign(n, 0.0);
  ShareCheck check(path, limits, pieces, result);
  Average average(intervals, window);
  Moment moment = average.moment();
  double duration = window;
  for (const SpeedInterval& interval : intervals) {
    duration += interval.time;
  }
  std::size_t point = 1;
  double target = n > 1 ? path.length[1] : 0.0;
  std::size_t steps = 0;
  while (moment.time < duration) {
    if (++steps % kCheckEvery == 0) {
      context.check();
    }
    check.add(moment);
    const double next = std::min(average.nextBreak(), duration);
    const double length = next - moment.time;
    average.go(next);
    const Moment ahead = average.moment();
    while (point + 1 < n && target <= ahead.way) {
      const double t = timeOf(moment, target, length);
      result.law.time[point] = moment.time + t;
      result.law.speed[point] =
          std::max(moment.speed + t * (moment.acceleration + 0.5 * t * moment.jerk), 0.0);
      target += path.length[++point];
    }
    Moment last = ahead;
    last.jerk = moment.jerk;  // the end of this stretch, before the break
    check.add(last);
    if (!(next > moment.time)) {
      break;
    }
    moment = ahead;
  }
  for (; point < n; ++point) {
    result.law.time[point] = duration;
    result.law.speed[point] = 0.0;
  }
  result.law.duration = duration;
  return result;
}

}  // namespace wcam::motion::detail
