// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/program/wire.hpp"

#include "wcam/base/quantity.hpp"
#include "wcam/base/text.hpp"

#include <algorithm>
#include <cmath>

namespace wcam::program {

namespace {

/// Wire speeds that differ by less (relative) are one: rounding of factors.
constexpr double kSameSpeed = 1e-6;

double metresPerMinute(double speed) {
  return toFileUnit(QuantityKind::WireSpeed, speed);
}

}  // namespace

WireSpeeds wireSpeeds(const Program& program) {
  WireSpeeds speeds;
  double last = -1.0;
  for (const Instruction& instruction : program.instructions) {
    const auto* set = std::get_if<SetProcess>(&instruction.action);
    if (set == nullptr) {
      continue;
    }
    const bool first = last < 0.0;
    speeds.least = first ? set->wireSpeed : std::min(speeds.least, set->wireSpeed);
    speeds.greatest = first ? set->wireSpeed : std::max(speeds.greatest, set->wireSpeed);
    speeds.changes +=
        !first && std::abs(set->wireSpeed - last) > kSameSpeed * std::max(last, set->wireSpeed)
            ? 1U
            : 0U;
    last = set->wireSpeed;
  }
  return speeds;
}

void reportUnwrittenWire(const Program& program, const Text& remedy, const JobContext& context) {
  const WireSpeeds speeds = wireSpeeds(program);
  if (speeds.changes == 0) {
    return;
  }
  context.add(
      {Severity::Violation,
       "post.wire_not_written",
       text("the wire speed changes %1 times, between %2 and %3 m/min, and the program does "
            "not write it",
            {std::to_string(speeds.changes), formatFixed(metresPerMinute(speeds.least), 2),
             formatFixed(metresPerMinute(speeds.greatest), 2)}),
       remedy,
       {program.name},
       {{"changes", static_cast<double>(speeds.changes)},
        {"least_m_min", metresPerMinute(speeds.least)},
        {"greatest_m_min", metresPerMinute(speeds.greatest)}}});
}

}  // namespace wcam::program
