// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/motion/trace.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/plausible.hpp"
#include "wcam/base/text.hpp"
#include "wcam/cell/joint_text.hpp"
#include "wcam/cell/kinematics.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::motion {

namespace {

constexpr std::size_t kCheckEvery = 4096;
/// A time step that is longer than the median one by this factor has lost samples.
constexpr double kLongStep = 1.5;
constexpr int kDecimals = 6;
/// Beyond what any motor turns.
constexpr PlausibleRange kPlausibleRpm{-1e6, 1e6};
constexpr std::string_view kTimeColumn = "time_s";
constexpr int kTimeIndex = -1;
constexpr int kSkipped = -2;

class TraceReader {
public:
  TraceReader(std::string_view text,
              const cell::Cell& cell,
              const std::string& source,
              const JobContext& context)
      : rest_(text), cell_(cell), source_(source), context_(context) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (rest_.starts_with(kByteOrderMark)) {
      rest_.remove_prefix(kByteOrderMark.size());
    }
  }

  MotorTrace read() {
    readHeader();
    while (nextLine()) {
      if (trace_.time.size() % kCheckEvery == 0) {
        context_.check();
      }
      readRow();
    }
    if (trace_.time.size() < 2) {
      line_ = 0;
      fail("the recording has fewer than 2 rows", "record longer");
    }
    tellUnevenTime();
    return std::move(trace_);
  }

private:
  [[noreturn]] void fail(const Text& message, const Text& hint) const {
    throw Error(ErrorCode::InputInvalid, message,
                line_ > 0 ? text("%1, line %2", {source_, std::to_string(line_)}) : Text(source_),
                hint);
  }

  /// The next line that is not empty.
  bool nextLine() {
    while (!rest_.empty()) {
      const std::size_t end = rest_.find('\n');
      text_ = rest_.substr(0, end);
      rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
      ++line_;
      if (!trimText(text_).empty()) {
        return true;
      }
    }
    return false;
  }

  std::vector<std::string_view> cells() const {
    std::vector<std::string_view> result;
    std::string_view rest = text_;
    for (;;) {
      const std::size_t end = rest.find(separator_);
      result.push_back(trimText(rest.substr(0, end)));
      if (end == std::string_view::npos) {
        return result;
      }
      rest = rest.substr(end + 1);
    }
  }

  /// Joint of a column, kTimeIndex or kSkipped.
  int columnOf(std::string_view name) {
    if (name == kTimeColumn) {
      return kTimeIndex;
    }
    if (name.starts_with("x-")) {
      return kSkipped;
    }
    std::vector<std::string> names = {std::string(kTimeColumn)};
    for (int j = 0; j < cell_.jointCount(); ++j) {
      names.push_back(cell_.joint(j).name + "_rpm");
      if (names.back() == name) {
        return j;
      }
    }
    const auto near = nearestName(name, names);
    fail(near ? text("the column '%1' is not known; did you mean '%2'?", {std::string(name), *near})
              : text("the column '%1' is not known", {std::string(name)}),
         text("name the columns %1; others begin with x-", {joinText(names, ", ")}));
  }

  void readHeader() {
    if (!nextLine()) {
      fail("the recording is empty", "write a header line and one row per sample");
    }
    separator_ = text_.find(';') != std::string_view::npos    ? ';'
                 : text_.find('\t') != std::string_view::npos ? '\t'
                                                              : ',';
    for (const std::string_view name : cells()) {
      const int column = columnOf(name);
      if (column != kSkipped &&
          std::find(columns_.begin(), columns_.end(), column) != columns_.end()) {
        fail(text("the column '%1' stands twice", {std::string(name)}), "keep one");
      }
      columns_.push_back(column);
    }
    std::vector<std::string> missing;
    for (int j = kTimeIndex; j < cell_.jointCount(); ++j) {
      if (std::find(columns_.begin(), columns_.end(), j) == columns_.end()) {
        missing.push_back(j == kTimeIndex ? std::string(kTimeColumn)
                                          : cell_.joint(j).name + "_rpm");
      }
    }
    if (!missing.empty()) {
      fail(text(missing.size() == 1 ? "the column %1 is missing" : "the columns %1 are missing",
                {joinText(missing, ", ")}),
           "record the time and the motor speed of every joint of the cell; 0 for those that rest");
    }
  }

  void readRow() {
    const std::vector<std::string_view> row = cells();
    if (row.size() != columns_.size()) {
      fail(text("the row has %1 columns, the header %2",
                {std::to_string(row.size()), std::to_string(columns_.size())}),
           "separate the columns as in the header and write decimal points");
    }
    double time = 0.0;
    JointVector rpm = JointVector::Zero(cell_.jointCount());
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (columns_[k] == kSkipped) {
        continue;
      }
      const auto number = parseReal(row[k]);
      if (!number) {
        fail(text("column %1: '%2' is not a finite number",
                  {std::to_string(k + 1), std::string(row[k])}),
             "write plain numbers with a decimal point");
      }
      if (const Text wrong = columns_[k] == kTimeIndex ? implausible(*number, QuantityKind::Time)
                                                       : outOfRange(*number, kPlausibleRpm, "rpm");
          !wrong.empty()) {
        fail(text("column %1: %2", {std::to_string(k + 1), wrong}), "correct the row, or its unit");
      }
      (columns_[k] == kTimeIndex ? time : rpm(columns_[k])) = *number;
    }
    if (!trace_.time.empty() && !(time > trace_.time.back())) {
      fail(text("the time %1 s is not after %2 s of the row before",
                {formatFixed(time, kDecimals), formatFixed(trace_.time.back(), kDecimals)}),
           "sort the rows by time and remove repeated ones");
    }
    trace_.time.push_back(time);
    trace_.rpm.push_back(rpm);
  }

  void tellUnevenTime() const {
    std::vector<double> steps;
    for (std::size_t i = 1; i < trace_.time.size(); ++i) {
      steps.push_back(trace_.time[i] - trace_.time[i - 1]);
    }
    std::vector<double> sorted = steps;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const double usual = *middle;
    std::size_t count = 0;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      if (steps[i] > kLongStep * usual) {
        ++count;
        worst = steps[i] > steps[worst] ? i : worst;
      }
    }
    if (count > 0) {
      context_.add(
          {Severity::Warning,
           "trace.uneven_time",
           text(count == 1 ? "%1: %2 step is longer than the others; the longest is %3 s at %4 s "
                             "instead of %5 s"
                           : "%1: %2 steps are longer than the others; the longest is %3 s at %4 s "
                             "instead of %5 s",
                {source_, std::to_string(count), formatFixed(steps[worst], kDecimals),
                 formatFixed(trace_.time[worst], kDecimals), formatFixed(usual, kDecimals)}),
           "samples are lost there: joint values are uncertain from that time on",
           {},
           {{"steps", static_cast<double>(count)},
            {"time_s", trace_.time[worst]},
            {"step_s", steps[worst]},
            {"usual_step_s", usual}}});
    }
  }

  std::string_view rest_;
  std::string_view text_;
  const cell::Cell& cell_;
  std::string source_;
  const JobContext& context_;
  int line_ = 0;
  char separator_ = ',';
  std::vector<int> columns_;
  MotorTrace trace_;
};

void checkRatios(const cell::Cell& cell) {
  std::vector<std::string> missing;
  for (int j = 0; j < cell.jointCount(); ++j) {
    if (!(cell.joint(j).ratio > 0.0)) {
      missing.push_back(cell.joint(j).name);
    }
  }
  if (!missing.empty()) {
    throw Error(ErrorCode::InvalidArgument,
                text("the reduction ratio is unknown of %1", {joinText(missing, ", ")}),
                text("cell %1", {cell.name}), "add \"ratio\" to these joints in the cell file");
  }
}

}  // namespace

MotorTrace parseMotorTrace(std::string_view text,
                           const cell::Cell& cell,
                           const std::string& contextName,
                           const JobContext& context) {
  return TraceReader(text, cell, contextName, context).read();
}

TcpTrace reconstructTcp(const MotorTrace& trace,
                        const cell::Cell& cell,
                        const JointVector& initial,
                        const JobContext& context) {
  checkRatios(cell);
  if (initial.size() != cell.jointCount()) {
    throw Error(ErrorCode::InvalidArgument,
                text("expected %1 initial joint values, got %2",
                     {std::to_string(cell.jointCount()), std::to_string(initial.size())}),
                text("cell %1", {cell.name}), "give one value per joint, the robot's first");
  }
  TcpTrace result;
  JointVector q = initial;
  JointVector before;
  for (std::size_t i = 0; i < trace.time.size(); ++i) {
    if (i % kCheckEvery == 0) {
      context.check();
    }
    const JointVector speeds = cell::jointSpeedsFromMotors(cell, trace.rpm[i]);
    if (i > 0) {
      q += 0.5 * (trace.time[i] - trace.time[i - 1]) * (speeds + before);
    }
    before = speeds;
    const Vec3 velocity = cell::partJacobian(cell, q) * speeds;
    result.time.push_back(trace.time[i]);
    result.joints.push_back(q);
    result.position.emplace_back(cell::T_part_tcp(cell, q).translation());
    result.velocity.push_back(velocity);
    result.speed.push_back(velocity.norm());
  }
  return result;
}

std::vector<SpeedEvent> speedEvents(const std::vector<double>& ratio, double tolerance) {
  std::vector<SpeedEvent> events;
  const auto side = [&](std::size_t i) {
    return ratio[i] > 1.0 + tolerance ? 1 : ratio[i] < 1.0 - tolerance ? -1 : 0;
  };
  for (std::size_t i = 0; i < ratio.size();) {
    const int kind = side(i);
    SpeedEvent event{kind > 0, i, ratio[i], i, i, i == 0, false};
    for (; i < ratio.size() && side(i) == kind; ++i) {
      if (kind > 0 ? ratio[i] > event.ratio : ratio[i] < event.ratio) {
        event.index = i;
        event.ratio = ratio[i];
      }
      event.last = i;
    }
    event.atEnd = i == ratio.size();
    if (kind != 0) {
      events.push_back(event);
    }
  }
  return events;
}

TraceSummary summarise(const TcpTrace& trace, double wanted, double tolerance) {
  TraceSummary summary;
  const std::vector<double>& speed = trace.speed;
  if (speed.empty()) {
    return summary;
  }
  const auto [least, most] = std::minmax_element(speed.begin(), speed.end());
  summary.duration = trace.time.back() - trace.time.front();
  for (std::size_t i = 1; i < speed.size(); ++i) {
    summary.length += 0.5 * (speed[i] + speed[i - 1]) * (trace.time[i] - trace.time[i - 1]);
  }
  summary.minSpeed = *least;
  summary.maxSpeed = *most;
  summary.minTime = trace.time[static_cast<std::size_t>(least - speed.begin())];
  summary.maxTime = trace.time[static_cast<std::size_t>(most - speed.begin())];
  summary.meanSpeed = summary.duration > 0.0 ? summary.length / summary.duration : speed.front();
  summary.wanted = wanted;
  if (!(wanted > 0.0)) {
    std::vector<double> sorted = speed;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    summary.wanted = *middle;
  }
  if (summary.wanted > 0.0) {
    std::vector<double> ratio;
    for (const double v : speed) {
      ratio.push_back(v / summary.wanted);
    }
    summary.events = speedEvents(ratio, tolerance);
  }
  return summary;
}

std::string traceTable(const TcpTrace& trace, const cell::Cell& cell) {
  std::string out = "time_s";
  for (int j = 0; j < cell.jointCount(); ++j) {
    out += ",j" + std::to_string(j + 1) + "_" + cell::jointUnit(cell.joint(j));
  }
  out += ",x_mm,y_mm,z_mm,vx_mm_s,vy_mm_s,vz_mm_s,speed_mm_s\n";
  for (std::size_t i = 0; i < trace.time.size(); ++i) {
    out += formatFixed(trace.time[i], kDecimals);
    for (int j = 0; j < cell.jointCount(); ++j) {
      out += "," + formatFixed(cell::toJointUnit(cell.joint(j), trace.joints[i](j)), kDecimals);
    }
    for (const Vec3& v : {trace.position[i], trace.velocity[i]}) {
      for (int k = 0; k < 3; ++k) {
        out += "," + formatFixed(v(k), kDecimals);
      }
    }
    out += "," + formatFixed(trace.speed[i], kDecimals) + "\n";
  }
  return out;
}

Value summaryValue(const TraceSummary& summary, const TcpTrace& trace) {
  Value events = Value::array();
  for (const SpeedEvent& event : summary.events) {
    events.push(Value::object({{"kind", event.peak ? "peak" : "dip"},
                               {"time_s", trace.time[event.index]},
                               {"speed_mm_s", trace.speed[event.index]},
                               {"ratio", event.ratio},
                               {"from_s", trace.time[event.first]},
                               {"to_s", trace.time[event.last]}}));
  }
  return Value::object({{"samples", trace.time.size()},
                        {"duration_s", summary.duration},
                        {"length_mm", summary.length},
                        {"min_speed_mm_s", summary.minSpeed},
                        {"min_time_s", summary.minTime},
                        {"mean_speed_mm_s", summary.meanSpeed},
                        {"max_speed_mm_s", summary.maxSpeed},
                        {"max_time_s", summary.maxTime},
                        {"wanted_speed_mm_s", summary.wanted},
                        {"events", events}});
}

}  // namespace wcam::motion
