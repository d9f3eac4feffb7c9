// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/process/process.hpp"

#include "wcam/base/text.hpp"

#include "touching_beads.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace wcam::process {

namespace {

double wireArea(const ProcessParams& params) noexcept {
  return kPi / 4.0 * params.wireDiameter.value() * params.wireDiameter.value();
}

/// Matter fed, mm³/s.
double feedRate(const ProcessParams& params) noexcept {
  return wireArea(params) * params.wireSpeed.value();
}

void checkWindows(const ProcessParams& params) {
  if (params.speedMin > params.speedMax) {
    throw Error(ErrorCode::InvalidArgument, "the smallest travel speed is above the greatest",
                "process", "exchange speed_min and speed_max");
  }
  if (params.heightMin > params.heightMax) {
    throw Error(ErrorCode::InvalidArgument, "the smallest layer height is above the greatest",
                "process", "exchange height_min and height_max");
  }
}

/// Worst value outside a window, with the count; reported once per layer.
struct Outside {
  std::size_t count = 0;
  double worst = 0.0;
  double worstExcess = 0.0;
  int bead = -1;
  int point = -1;

  /// @return true when this is the worst value so far
  bool add(double value, double low, double high, std::size_t beadIndex, std::size_t pointIndex) {
    const double excess = std::max(low - value, value - high);
    if (excess <= 0.0) {
      return false;
    }
    ++count;
    if (bead >= 0 && excess <= worstExcess) {
      return false;
    }
    worst = value;
    worstExcess = excess;
    bead = static_cast<int>(beadIndex);
    point = static_cast<int>(pointIndex);
    return true;
  }
};

}  // namespace

const Schema<ProcessParams>& ProcessParams::schema() {
  static const Schema<ProcessParams> schema =
      Schema<ProcessParams>{}
          .add(&ProcessParams::wireDiameter, {.key = "wire_diameter",
                                              .label = "Wire diameter",
                                              .group = "Wire",
                                              .min = 0.1,
                                              .max = 10.0})
          .add(&ProcessParams::wireSpeed, {.key = "wire_speed",
                                           .label = "Wire feed speed",
                                           .help = "Constant over the whole operation.",
                                           .group = "Wire",
                                           .min = 0.05,
                                           .max = 60.0})
          .add(&ProcessParams::wireSpeedMin,
               {.key = "wire_speed_min",
                .label = "Minimum wire feed speed",
                .help =
                    "Where even the maximum travel speed deposits too much, as in thin layers or "
                    "in beads side by side, the wire feed of the whole operation is lowered, "
                    "but not below this value. Set it to the wire feed speed to keep the feed "
                    "as it is.",
                .group = "Wire",
                .level = ParamLevel::Advanced,
                .min = 0.0,
                .max = 60.0})
          .add(&ProcessParams::beadWidth, {.key = "bead_width",
                                           .label = "Bead width",
                                           .help = "Stabilised width of a wall of one bead.",
                                           .group = "Bead",
                                           .min = 0.1,
                                           .max = 100.0})
          .add(&ProcessParams::speedMin, {.key = "speed_min",
                                          .label = "Smallest travel speed",
                                          .group = "Window",
                                          .min = 0.01,
                                          .max = 1000.0})
          .add(&ProcessParams::speedMax, {.key = "speed_max",
                                          .label = "Greatest travel speed",
                                          .help = "Above, the bead humps.",
                                          .group = "Window",
                                          .min = 0.01,
                                          .max = 1000.0})
          .add(&ProcessParams::heightMin, {.key = "height_min",
                                           .label = "Smallest layer height",
                                           .group = "Window",
                                           .min = 0.0,
                                           .max = 100.0})
          .add(&ProcessParams::heightMax, {.key = "height_max",
                                           .label = "Greatest layer height",
                                           .group = "Window",
                                           .min = 0.0,
                                           .max = 100.0})
          .add(&ProcessParams::density,
               {.key = "density",
                .label = "Density of the wire",
                .group = "Wire",
                .min = 0.1,
                .max = 25.0},
               ParamType::Real, QuantityKind::Density)
          .add(&ProcessParams::job, {.key = "job",
                                     .label = "Job number of the welding source",
                                     .group = "Source",
                                     .min = 0,
                                     .max = 999})
          .add(&ProcessParams::craterTime, {.key = "crater_time",
                                            .label = "Crater fill time",
                                            .group = "Source",
                                            .min = 0.0,
                                            .max = 60.0});
  return schema;
}

double wallSection(double height, double width) noexcept {
  const double r = 0.5 * width;
  const double h = std::clamp(height, 0.0, width);
  return h * std::sqrt(std::max(0.0, r * r - 0.25 * h * h)) +
         2.0 * r * r * std::asin(std::min(1.0, h / (2.0 * r)));
}

double beadSection(const toolpath::PathPoint& point) noexcept {
  return point.fillWidth > 0.0 ? point.fillWidth * point.height
                               : wallSection(point.height, point.width);
}

namespace {

/// Keeps quotients finite; far below any section (mm²) or speed (mm/s) of a process.
constexpr double kVanishing = 1e-12;

}  // namespace

double travelSpeed(double height, const ProcessParams& params) noexcept {
  return travelSpeed(height, params.beadWidth.value(), params);
}

double travelSpeed(double height, double width, const ProcessParams& params) noexcept {
  // The section of a vanishing height is 0: the speed window bounds what follows.
  const double section = std::max(wallSection(height, width), kVanishing);
  return feedRate(params) / section;
}

double depositedHeight(double speed, const ProcessParams& params) noexcept {
  const double width = params.beadWidth.value();
  const double section = feedRate(params) / std::max(speed, kVanishing);
  double low = 0.0;
  double high = width;
  constexpr int kBisections = 100;  // down to rounding
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    (wallSection(middle, width) < section ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

namespace {

/// Width of a bead of a height whose section is given: the inverse of wallSection. A bead is at
/// least as wide as high; a smaller section gives the width = height.
double widthOfSection(double section, double height) noexcept {
  double low = height;
  if (wallSection(height, low) >= section) {
    return low;
  }
  double high = std::max(2.0 * height, kVanishing);
  // A section grows at least in proportion to the width: a few doublings reach any.
  constexpr int kDoublings = 60;
  for (int i = 0; i < kDoublings && wallSection(height, high) < section; ++i) {
    high *= 2.0;
  }
  constexpr int kBisections = 60;  // down to rounding
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    (wallSection(height, middle) < section ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// What the process wants of a move, before windows and ramps.
struct Wanted {
  double speed = 0.0;
  double wire = 0.0;
};

Wanted plannedAt(const toolpath::PathPoint& point, const ProcessParams& params) {
  return {feedRate(params) / std::max(beadSection(point), kVanishing), params.wireSpeed.value()};
}

Wanted wantedAt(const toolpath::PathPoint& point, const ProcessParams& params) {
  Wanted wanted = plannedAt(point, params);
  const toolpath::ProcessChange& change = point.change;
  if (change.section == toolpath::SectionRule::Plan) {
    return wanted;
  }
  const double low = params.speedMin.value();
  const double high = params.speedMax.value();
  const double base = std::clamp(wanted.speed, low, high);
  wanted.speed = change.speedIsValue ? change.speed : base * change.speed;
  wanted.wire = change.wireIsValue ? change.wire : wanted.wire * change.wire;
  const double section = std::max(beadSection(point), kVanishing);
  if (change.section == toolpath::SectionRule::Wire) {
    wanted.wire = section * std::clamp(wanted.speed, low, high) / wireArea(params);
  } else if (change.section == toolpath::SectionRule::Speed) {
    wanted.speed = wireArea(params) * wanted.wire / section;
  }
  return wanted;
}

/// The bead takes the width that speed and wire make of its height.
void followWidth(toolpath::PathPoint& point, const Wanted& wanted, const ProcessParams& params) {
  if (point.change.section == toolpath::SectionRule::Width && point.height > 0.0) {
    const double speed = std::clamp(wanted.speed, params.speedMin.value(), params.speedMax.value());
    const double section = wireArea(params) * wanted.wire / speed;
    if (point.fillWidth > 0.0) {
      // Beside neighbours the bead keeps its shape: all of its widths grow alike.
      const double grown = section / (point.fillWidth * point.height);
      point.width *= grown;
      point.fillWidth *= grown;
    } else {
      point.width = widthOfSection(section, point.height);
    }
  }
}

/// Beads that edits leave too little for: even as narrow as high they would need more.
struct Starved {
  std::size_t count = 0;
  double worst = 1.0;  ///< least part of the section that is there
  int bead = -1;
  int point = -1;

  void add(const toolpath::PathPoint& at,
           const Wanted& wanted,
           const ProcessParams& params,
           std::size_t beadIndex,
           std::size_t pointIndex) {
    if (at.change.section != toolpath::SectionRule::Width || !(at.height > 0.0)) {
      return;
    }
    const double speed = std::clamp(wanted.speed, params.speedMin.value(), params.speedMax.value());
    const double part = wireArea(params) * wanted.wire / speed / wallSection(at.height, at.height);
    if (part >= 1.0) {
      return;
    }
    ++count;
    if (bead < 0 || part < worst) {
      worst = part;
      bead = static_cast<int>(beadIndex);
      point = static_cast<int>(pointIndex);
    }
  }

  void report(int layer, const JobContext& context) const {
    if (count > 0) {
      constexpr double kPercent = 100.0;
      context.add({Severity::Warning,
                   "process.section_too_small",
                   text("%1 points get only %2 % or more of the wire that the narrowest bead of "
                        "their height needs",
                        {std::to_string(count), formatFixed(kPercent * worst, 0)}),
                   "lower the speed or raise the wire feed in the edit, or let the other follow",
                   {{}, layer, bead, point},
                   {{"points", static_cast<double>(count)}, {"worst_ratio", worst}}});
    }
  }
};

}  // namespace

namespace {

constexpr double kMetrePerMinute = 1000.0 / 60.0;  // in mm/s

/// A move that the plan alone decides.
struct PlannedMove {
  double section = 0.0;  ///< mm²
  double length = 0.0;   ///< mm
};

void reportLowered(double lowered, const ProcessParams& params, const JobContext& context) {
  const std::string shown = formatFixed(lowered / kMetrePerMinute, 2);
  context.add(
      {Severity::Warning,
       "process.wire_lowered",
       text("at the maximum travel speed of %1 mm/s the wire feed of %2 m/min would deposit too "
            "much, and %3 m/min is used",
            {formatFixed(params.speedMax.value(), 2),
             formatFixed(params.wireSpeed.value() / kMetrePerMinute, 2), shown}),
       text("set wire_speed to %1 m/min, with the job of the welding source for it", {shown}),
       {},
       {{"wire_m_min", lowered / kMetrePerMinute}}});
}

}  // namespace

double operationWireSpeed(const toolpath::Toolpath& path, const ProcessParams& params) {
  std::vector<PlannedMove> moves;
  double wanted = 0.0;
  for (const toolpath::Layer& layer : path.layers) {
    for (const toolpath::Bead& bead : layer.beads) {
      for (std::size_t i = 1; i < bead.points.size(); ++i) {
        const toolpath::PathPoint& point = bead.points[i];
        if (!point.arc) {
          continue;
        }
        const double width = point.width > 0.0 ? point.width : params.beadWidth.value();
        const double section = point.fillWidth > 0.0 ? point.fillWidth * point.height
                                                     : wallSection(point.height, width);
        const PlannedMove move{section, (point.p - bead.points[i - 1].p).norm()};
        wanted += move.section * move.length;
        if (point.change.section == toolpath::SectionRule::Plan) {
          moves.push_back(move);
        }
      }
    }
  }
  /// Material too much at the maximum travel speed, mm³.
  const auto excess = [&](double wire) {
    const double least = wireArea(params) * wire / params.speedMax.value();
    double sum = 0.0;
    for (const PlannedMove& move : moves) {
      sum += std::max(0.0, least - move.section) * move.length;
    }
    return sum;
  };
  constexpr double kBearable = 0.01;  // of the material
  double high = params.wireSpeed.value();
  if (moves.empty() || excess(high) <= kBearable * wanted) {
    return high;
  }
  /// Material that is missing at the minimum travel speed, mm³.
  const auto shortage = [&](double wire) {
    const double most = wireArea(params) * wire / params.speedMin.value();
    double sum = 0.0;
    for (const PlannedMove& move : moves) {
      sum += std::max(0.0, move.section - most) * move.length;
    }
    return sum;
  };
  double low = std::min(params.wireSpeedMin.value(), high);
  // Where thick places would lose more than thin ones gain, the feed stays above.
  double below = low;
  double above = high;
  constexpr int kThirds = 100;
  for (int i = 0; i < kThirds; ++i) {
    const double third = (above - below) / 3.0;
    const auto wrong = [&](double wire) { return excess(wire) + shortage(wire); };
    if (wrong(below + third) < wrong(above - third)) {
      above -= third;
    } else {
      below += third;
    }
  }
  constexpr int kBisections = 60;  // down to rounding
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    (excess(middle) <= kBearable * wanted ? low : high) = middle;
  }
  low = std::max(low, above);
  // What is shown is what is used.
  constexpr double kShown = 0.01 * kMetrePerMinute;
  return std::max(std::min(params.wireSpeedMin.value(), low), std::floor(low / kShown) * kShown);
}

toolpath::Toolpath applyProcess(toolpath::Toolpath path,
                                const ProcessParams& wanted,
                                const JobContext& context) {
  checkWindows(wanted);
  shareTouchingBeads(path, wanted.beadWidth.value(), context);
  ProcessParams params = wanted;
  params.wireSpeed = WireSpeed(operationWireSpeed(path, wanted));
  if (params.wireSpeed.value() < wanted.wireSpeed.value()) {
    reportLowered(params.wireSpeed.value(), wanted, context);
  }
  for (std::size_t l = 0; l < path.layers.size(); ++l) {
    context.check();
    Outside speeds;
    Outside heights;
    Starved starved;
    double worstLimit = params.heightMax.value();
    auto& beads = path.layers[l].beads;
    for (std::size_t b = 0; b < beads.size(); ++b) {
      for (std::size_t i = 0; i < beads[b].points.size(); ++i) {
        toolpath::PathPoint& point = beads[b].points[i];
        point.width = point.width > 0.0 ? point.width : params.beadWidth.value();
        const Wanted wanted = wantedAt(point, params);
        const double low = params.speedMin.value();
        const double high = params.speedMax.value();
        point.wireSpeed = point.arc ? wanted.wire * point.wireFactor : 0.0;
        point.speed =
            std::clamp(std::clamp(wanted.speed, low, high) * point.speedFactor, low, high);
        if (!point.arc) {
          continue;
        }
        starved.add(point, wanted, params, b, i);
        followWidth(point, wanted, params);
        speeds.add(wanted.speed, params.speedMin.value(), params.speedMax.value(), b, i);
        // A bead is never higher than wide: its discs would no longer touch.
        const double heightMax = std::min(params.heightMax.value(), point.width);
        if (heights.add(point.height, params.heightMin.value(), heightMax, b, i)) {
          worstLimit = heightMax;
        }
      }
    }
    const auto layer = static_cast<int>(l);
    starved.report(layer, context);
    if (heights.count > 0) {
      context.add(
          {Severity::Warning,
           "process.height_out_of_range",
           text("%1 points have a layer height outside the process window, worst %2 mm",
                {std::to_string(heights.count), formatFixed(heights.worst, 3)}),
           text("change the layer step or the strategy so that the distance between layers stays "
                "between %1 and %2 mm",
                {formatFixed(params.heightMin.value(), 2), formatFixed(worstLimit, 2)}),
           {{}, layer, heights.bead, heights.point},
           {{"points", static_cast<double>(heights.count)}, {"worst_height_mm", heights.worst}}});
    }
    if (speeds.count > 0) {
      context.add(
          {Severity::Warning,
           "process.speed_clamped",
           text("%1 points want a travel speed outside the process window, worst %2 mm/s; the "
                "window's limit is used",
                {std::to_string(speeds.count), formatFixed(speeds.worst, 2)}),
           "change the wire feed speed, the layer step or the window",
           {{}, layer, speeds.bead, speeds.point},
           {{"points", static_cast<double>(speeds.count)}, {"worst_speed_mm_s", speeds.worst}}});
    }
  }
  return path;
}

ProcessStatistics processStatistics(const toolpath::Toolpath& path, const ProcessParams& wanted) {
  ProcessStatistics s;
  ProcessParams params = wanted;
  params.wireSpeed = WireSpeed(operationWireSpeed(path, wanted));
  for (const toolpath::Layer& layer : path.layers) {
    for (const toolpath::Bead& bead : layer.beads) {
      for (std::size_t i = 0; i < bead.points.size(); ++i) {
        const toolpath::PathPoint& point = bead.points[i];
        if (!point.arc) {
          continue;
        }
        const double speed = plannedAt(point, params).speed;
        const bool planned = point.change.section == toolpath::SectionRule::Plan;
        s.clampedPoints +=
            planned && (speed < params.speedMin.value() || speed > params.speedMax.value()) ? 1U
                                                                                            : 0U;
        if (i > 0) {
          const double length = (point.p - bead.points[i - 1].p).norm();
          s.length += length;
          s.time += length / point.speed;
          s.wireLength += point.wireSpeed * length / point.speed;
          s.wantedVolume += beadSection(point) * length;
        }
      }
    }
  }
  s.wireVolume = s.wireLength * wireArea(params);
  constexpr double kMm3PerCm3 = 1000.0;
  s.mass = s.wireVolume / kMm3PerCm3 * params.density;
  return s;
}

}  // namespace wcam::process
