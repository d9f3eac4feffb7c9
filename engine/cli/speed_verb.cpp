// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/output_set.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/base/text.hpp"
#include "wcam/cell/cell.hpp"
#include "wcam/cell/joint_text.hpp"
#include "wcam/motion/trace.hpp"
#include "wcam/plugin/locations.hpp"

#include "verbs.hpp"

#include <cmath>
#include <cstdio>

namespace wcam::cli {

namespace {

/// A cell file, or the name of one that comes with the program.
cell::Cell cellOf(const std::string& name, const JobContext& context) {
  const std::filesystem::path file = pathFromText(name);
  if (!std::filesystem::exists(file) && isValidId(name)) {
    const std::filesystem::path shipped = plugin::dataFolder() / "cells" / (name + ".json");
    if (std::filesystem::exists(shipped)) {
      return cell::loadCell(shipped, context);
    }
  }
  return cell::loadCell(file, context);
}

cell::JointVector initialJoints(const cell::Cell& cell, const Options& options) {
  const std::vector<std::string> words = splitText(options.joints, ',');
  if (words.size() != static_cast<std::size_t>(cell.jointCount())) {
    throw Error(ErrorCode::InvalidArgument,
                "--joints: expected " + std::to_string(cell.jointCount()) + " values, got " +
                    std::to_string(options.joints.empty() ? 0 : words.size()),
                "cell " + cell.name,
                "give the joint values at the first row, degrees or mm, separated by commas");
  }
  cell::JointVector q(cell.jointCount());
  for (int j = 0; j < cell.jointCount(); ++j) {
    const std::string& word = words[static_cast<std::size_t>(j)];
    const auto value = parseReal(trimText(word));
    if (!value) {
      throw Error(ErrorCode::InvalidArgument,
                  "--joints: '" + word + "' of joint " + cell.joint(j).name + " is not a number",
                  "cell " + cell.name, "write plain numbers with a decimal point");
    }
    q(j) = cell::fromJointUnit(cell.joint(j), *value);
  }
  return options.zero.empty() ? q : cell.fromConvention(options.zero, q);
}

/// A speed with or without its unit; 0 when not given.
double wantedSpeed(const std::string& text) {
  if (text.empty()) {
    return 0.0;
  }
  const double speed = parseQuantity(text, QuantityKind::Speed);
  if (!(speed > 0.0)) {
    throw Error(ErrorCode::InvalidArgument, "--speed: '" + text + "' is not a speed above 0", {},
                "write for example 8mm/s or 0.5m/min");
  }
  return speed;
}

void tell(const Console& console,
          const motion::TraceSummary& summary,
          const motion::TcpTrace& trace) {
  console.say("speed in the part: least " + formatFixed(summary.minSpeed, 3) + " mm/s at " +
              formatFixed(summary.minTime, 3) + " s, mean " + formatFixed(summary.meanSpeed, 3) +
              " mm/s, greatest " + formatFixed(summary.maxSpeed, 3) + " mm/s at " +
              formatFixed(summary.maxTime, 3) + " s; " + formatFixed(summary.length, 1) +
              " mm in " + formatFixed(summary.duration, 3) + " s");
  constexpr std::size_t kMost = 20;
  for (std::size_t i = 0; i < summary.events.size() && i < kMost; ++i) {
    const motion::SpeedEvent& event = summary.events[i];
    console.say(std::string(event.peak ? "peak" : "dip") + " at " +
                formatFixed(trace.time[event.index], 3) +
                " s: " + formatFixed(trace.speed[event.index], 3) + " mm/s, " +
                formatFixed(event.ratio * 100.0, 1) + " % of " + formatFixed(summary.wanted, 3) +
                " mm/s");
  }
  if (summary.events.size() > kMost) {
    console.say("… and " + std::to_string(summary.events.size() - kMost) + " more; see --json");
  }
}

}  // namespace

int speedVerb(const Session& session) {
  const Options& options = session.options;
  const cell::Cell cell = cellOf(options.cell, session.context);
  const double wanted = wantedSpeed(options.speed);
  const cell::JointVector initial = initialJoints(cell, options);
  const std::filesystem::path file = pathFromText(options.file);
  OutputPlan plan;
  plan.keep(file, "the recording");
  plan.keep(pathFromText(options.cell), "the cell");
  plan.write(pathFromText(options.output), "the table");
  const motion::MotorTrace motors =
      motion::parseMotorTrace(readFile(file), cell, pathText(file), session.context);
  const motion::TcpTrace trace = motion::reconstructTcp(motors, cell, initial, session.context);
  const motion::TraceSummary summary = motion::summarise(trace, wanted, options.tolerance);
  const std::string table = traceTable(trace, cell);
  session.console.endProgress();
  if (!options.output.empty()) {
    writeResult(pathFromText(options.output), table);
  } else if (!options.json) {
    std::fputs(table.c_str(), stdout);
  }
  const std::vector<Diagnostic> findings = session.context.diagnostics().items();
  if (options.json) {
    Value value = summaryValue(summary, trace);
    Value list = Value::array();
    for (const Diagnostic& finding : findings) {
      list.push(toValue(finding));
    }
    value.set("diagnostics", list);
    std::fputs(toCanonicalJson(value).c_str(), stdout);
  }
  tell(session.console, summary, trace);
  session.console.findings(findings);
  return 0;
}

}  // namespace wcam::cli
