// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/plugin/plugin.hpp"
#include "wcam/program/split.hpp"
#include "wcam/program/validate.hpp"
#include "wcam/program/wire.hpp"

#include "ls_writer.hpp"
#include "words.hpp"

#include <algorithm>

namespace {

using namespace fanuc;
using wcam::Diagnostic;
using wcam::Error;
using wcam::ErrorCode;
using wcam::Severity;
using wcam::plugin::OutputFile;
using wcam::program::Program;

/// A relative speed error above this is worth a word: it changes the layer height as much.
constexpr double kSpeedErrorWorthTelling = 0.01;
/// A motion group has at most 9 axes.
constexpr int kMaxGroupAxes = 9;

void checkCell(const Program& program, const Dialect& dialect) {
  const auto& cell = program.cell;
  if (cell.robotJoints > kMaxGroupAxes) {
    throw Error(ErrorCode::JobFailed,
                wcam::text("a FANUC motion group has at most 9 axes, the robot has %1",
                           {std::to_string(cell.robotJoints)}),
                program.name, "use a cell with a FANUC robot");
  }
  if (dialect.mode != Mode::Cartesian) {
    return;
  }
  if (cell.robotJoints != 6) {
    throw Error(ErrorCode::JobFailed,
                wcam::text("Cartesian positions need a robot with 6 joints, this one has %1",
                           {std::to_string(cell.robotJoints)}),
                program.name, "set mode=joint");
  }
  const auto robotEnd =
      cell.linearJoint.begin() + (cell.linearJoint.empty() ? 0 : cell.robotJoints);
  if (std::find(cell.linearJoint.begin(), robotEnd, true) != robotEnd) {
    throw Error(ErrorCode::JobFailed, "Cartesian positions need an arm; this robot has linear axes",
                program.name, "set mode=joint");
  }
}

void tell(const Program& program,
          const Dialect& dialect,
          const ModalState& state,
          const wcam::JobContext& context) {
  if (dialect.wireRegister == 0) {
    wcam::program::reportUnwrittenWire(
        program,
        "name the register that hands the wire speed to the welding source (wire_register), or "
        "plan "
        "with one wire speed: ramps and edits that keep it, wire_follows_speed off",
        context);
  }
  // The turn numbers of a configuration are -8 to 7.
  constexpr int kLeastTurn = -8;
  constexpr int kMostTurn = 7;
  if (state.farthestTurn < kLeastTurn || state.farthestTurn > kMostTurn) {
    context.add({Severity::Violation,
                 "post.turn_out_of_range",
                 wcam::text("axis J%1 is %2 turns from its zero; the turn numbers of a position go "
                            "from -8 to 7",
                            {std::to_string(state.farthestTurnAxis + 1),
                             std::to_string(state.farthestTurn)}),
                 "split the operation so that the axis turns back between its parts, or let beads "
                 "change their direction (alternate)",
                 {program.name},
                 {{"turn", static_cast<double>(state.farthestTurn)}}});
  }
  if (state.worstSpeedError > kSpeedErrorWorthTelling) {
    constexpr double kPercent = 100.0;
    context.add({Severity::Warning,
                 "post.speed_rounded",
                 wcam::text("the speeds of the program differ from the planned ones by up to %1 %",
                            {wcam::formatFixed(kPercent * state.worstSpeedError, 1)}),
                 dialect.speedUnit == SpeedUnit::CmPerMinute
                     ? wcam::Text("write speeds with more decimals (speed_decimals)")
                     : wcam::Text("write speeds in cm/min (speed_unit) or with more decimals "
                                  "(speed_decimals)"),
                 {program.name},
                 {{"error_percent", 100.0 * state.worstSpeedError}}});
  }
}

class FanucPost final : public wcam::plugin::PostProcessor {
public:
  [[nodiscard]] std::vector<OutputFile> post(const Program& program,
                                             const wcam::Value& params,
                                             const wcam::JobContext& context) const override {
    const Dialect dialect = dialectSchema().read(params, "post-processor wcam.post.fanuc");
    context.check();
    wcam::program::requireValid(program);
    checkCell(program, dialect);
    const wcam::program::SplitLimits limits{
        dialect.maxPoints, dialect.maxLines,
        [&dialect](const wcam::program::Action& action) { return linesOf(action, dialect); },
        headLines(program, dialect)};
    const wcam::program::NamedParts split = wcam::program::splitNamed(
        program, limits, dialect.programName, {dialect.longestName(), kWords}, context);
    std::vector<OutputFile> files;
    if (split.chained) {
      files.push_back({split.main + ".LS",
                       printMain(split.main, program.name, program, split.calls(), dialect)});
    }
    ModalState state;
    state.configuration = program.cell.configuration;
    std::size_t done = 0;
    for (const wcam::program::NamedPart& part : split.parts) {
      files.push_back(
          {part.name + ".LS", printPart(part, program.name, program, dialect, state, context)});
      context.report(static_cast<double>(++done) / static_cast<double>(split.parts.size()));
    }
    tell(program, dialect, state, context);
    return files;
  }
};

void registerComponents(wcam::plugin::Registrar& registrar) {
  registrar.addPost(
      {.id = "wcam.post.fanuc",
       .name = "FANUC TP (.LS)",
       .summary = "TP programs in ASCII form for FANUC controllers, with the positioner as "
                  "motion group 2",
       .params = dialectSchema().params(),
       .controllers = {"FANUC"}},
      [] { return std::make_unique<FanucPost>(); });
}

}  // namespace

WCAM_PLUGIN(registerComponents);
