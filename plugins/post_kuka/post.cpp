// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/plugin/plugin.hpp"
#include "wcam/program/names.hpp"
#include "wcam/program/split.hpp"
#include "wcam/program/validate.hpp"
#include "wcam/program/wire.hpp"

#include "krl_writer.hpp"
#include "words.hpp"

#include <algorithm>

namespace {

using namespace kuka;
using wcam::Error;
using wcam::ErrorCode;
using wcam::Severity;
using wcam::plugin::OutputFile;
using wcam::program::Program;

/// A relative speed error above this is worth a word: it changes the layer height as much.
constexpr double kSpeedErrorWorthTelling = 0.01;
constexpr int kRobotAxes = 6;
constexpr int kMaxExternalAxes = 6;

void checkCell(const Program& program, const Dialect& dialect) {
  const auto& cell = program.cell;
  if (cell.robotJoints != kRobotAxes || cell.positionerJoints > kMaxExternalAxes) {
    throw Error(
        ErrorCode::JobFailed,
        wcam::text("a KUKA program has 6 robot axes and up to 6 external ones, the cell %1 and %2",
                   {std::to_string(cell.robotJoints), std::to_string(cell.positionerJoints)}),
        program.name, "use a cell with a KUKA robot");
  }
  const auto robotEnd =
      cell.linearJoint.begin() + (cell.linearJoint.empty() ? 0 : cell.robotJoints);
  if (std::find(cell.linearJoint.begin(), robotEnd, true) != robotEnd) {
    throw Error(ErrorCode::JobFailed,
                "a KUKA program has rotary robot axes, this robot linear ones", program.name,
                "use a post-processor for Cartesian machines");
  }
  if (cell.partCarried && dialect.base == 0) {
    throw Error(ErrorCode::JobFailed,
                "for a part that the robot carries, the base is the fixed torch, and $NULLFRAME is "
                "not",
                program.name, "measure the torch as a base and set base to its number");
  }
}

void checkTexts(const Dialect& dialect) {
  const std::string context = "post-processor wcam.post.kuka";
  const bool bits =
      dialect.status.empty() ||
      (dialect.status.size() == 3 && dialect.status.find_first_not_of("01") == std::string::npos);
  if (!bits) {
    throw Error(ErrorCode::InvalidArgument,
                wcam::text("status '%1' is not three binary digits", {dialect.status}), context,
                "write it like 010, or leave it empty");
  }
  for (const std::string& text : {dialect.arcOn, dialect.arcOff, dialect.wireVariable}) {
    const bool plain =
        std::all_of(text.begin(), text.end(), [](char c) { return c >= 0x20 && c < 0x7F; });
    if (!plain) {
      throw Error(ErrorCode::InvalidArgument,
                  wcam::text("KRL lines take printable ASCII only: '%1'",
                             {wcam::program::asciiComment(text)}),
                  context, "separate lines by '|'");
    }
  }
}

void tell(const Program& program,
          const Dialect& dialect,
          const ModalState& state,
          const wcam::JobContext& context) {
  if (dialect.mode == Mode::Joint) {
    context.add({Severity::Warning,
                 "post.dry_run",
                 "moves to axis values cannot keep the speed of a bead: the program is a dry run "
                 "and leaves the arc off",
                 "deposit with mode=cartesian",
                 {program.name},
                 {}});
  } else if (dialect.wireVariable.empty() && dialect.arc != Arc::None) {
    wcam::program::reportUnwrittenWire(
        program,
        "name the variable that hands the wire speed to the welding source (wire_variable), or "
        "plan "
        "with one wire speed: ramps and edits that keep it, wire_follows_speed off",
        context);
  }
  if (state.worstAxisSpeedError > kSpeedErrorWorthTelling) {
    context.add({Severity::Warning,
                 "post.speed_rounded",
                 wcam::text("moves to axis values run at whole percents of the axis speeds, up to "
                            "%1 % off the planned speed",
                            {wcam::formatFixed(100.0 * state.worstAxisSpeedError, 0)}),
                 "deposit with mode=cartesian",
                 {program.name},
                 {{"error_percent", 100.0 * state.worstAxisSpeedError}}});
  }
}

class KukaPost final : public wcam::plugin::PostProcessor {
public:
  [[nodiscard]] std::vector<OutputFile> post(const Program& program,
                                             const wcam::Value& params,
                                             const wcam::JobContext& context) const override {
    const Dialect dialect = dialectSchema().read(params, "post-processor wcam.post.kuka");
    checkTexts(dialect);
    context.check();
    wcam::program::requireValid(program);
    checkCell(program, dialect);
    const wcam::program::SplitLimits limits{
        dialect.maxPoints, dialect.maxLines,
        [&dialect](const wcam::program::Action& action) { return linesOf(action, dialect); },
        headLines(program, dialect),
        [&dialect](std::span<const wcam::program::Instruction> all) {
          return linesInOrder(all, dialect);
        }};
    const wcam::program::NamedParts split = wcam::program::splitNamed(
        program, limits, dialect.programName, {kLongestName, kWords}, context);
    std::vector<OutputFile> files;
    if (split.chained) {
      files.push_back(
          {split.main + ".src", printMain(split.main, program, split.calls(), dialect)});
    }
    ModalState state;
    state.configuration = program.cell.configuration;
    std::size_t done = 0;
    for (const wcam::program::NamedPart& part : split.parts) {
      files.push_back({part.name + ".src", printProgram(part, program, dialect, state, context)});
      context.report(static_cast<double>(++done) / static_cast<double>(split.parts.size()));
    }
    tell(program, dialect, state, context);
    return files;
  }
};

void registerComponents(wcam::plugin::Registrar& registrar) {
  registrar.addPost(
      {.id = "wcam.post.kuka",
       .name = "KUKA KRL (.src)",
       .summary = "KRL programs for KUKA controllers, with a mathematically coupled positioner "
                  "as external axes",
       .params = dialectSchema().params(),
       .controllers = {"KUKA"}},
      [] { return std::make_unique<KukaPost>(); });
}

}  // namespace

WCAM_PLUGIN(registerComponents);
