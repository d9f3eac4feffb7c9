// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/placing.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/base/text.hpp"

#include <cmath>
#include <set>

namespace wcam::project {

namespace {

/// A place as named figures, in file units: the columns of both forms. Infinite are those that the
/// robot does not have (the distance to axis 1 of a Cartesian machine): null, or an empty cell.
std::vector<std::pair<const char*, double>> figuresOf(const motion::PartPlace& place) {
  return {{"dx_mm", place.move.x()},
          {"dy_mm", place.move.y()},
          {"dz_mm", place.move.z()},
          {"turn_deg", radToDeg(place.turn)},
          {"failing_points", static_cast<double>(place.failing)},
          {"score", place.score},
          {"reach_missing_mm", place.reachMissing},
          {"limit_margin_deg", radToDeg(place.limitMargin)},
          {"wrist_bend_deg", radToDeg(place.wristBend)},
          {"elbow_bend_deg", radToDeg(place.elbowBend)},
          {"axis_distance_mm", place.axisDistance},
          {"dexterity", place.dexterity},
          {"clearance_mm", place.clearance},
          {"torch_rotation_deg", radToDeg(place.torchRotation)}};
}

Value vectorOf(const std::array<double, 3>& numbers) {
  return Value(Value::Array{numbers[0], numbers[1], numbers[2]});
}

/// The placement after a move, in the form of files.
Value movedPlacement(const Placement& placement, const geometry::Pose& move) {
  const Placement moved = toPlacement(move * toPose(placement));
  return Value::object(
      {{"position_mm", vectorOf(moved.positionMm)}, {"rotation_deg", vectorOf(moved.rotationDeg)}});
}

}  // namespace

std::vector<Command> placementCommands(const Document& document,
                                       const std::string& operation,
                                       const geometry::Pose& move) {
  const Project& project = document.project();
  const Operation* wanted = project.operation(operation);
  if (wanted == nullptr) {
    throw Error(ErrorCode::InvalidArgument, text("the project has no operation '%1'", {operation}));
  }
  const Guide* guide = wanted->guide.empty() ? nullptr : project.guide(wanted->guide);
  if (!wanted->file.empty() || (guide != nullptr && guide->type != Guide::Type::Edge)) {
    throw Error(ErrorCode::ProjectInvalid,
                wanted->file.empty()
                    ? text("the guide '%1' does not move with the part", {wanted->guide})
                    : text("its path comes from a file"),
                text("operation '%1'", {operation}),
                "move the part in the cell file instead: T_table_part");
  }
  std::set<std::string> parts(wanted->parts.begin(), wanted->parts.end());
  const Substrate* substrate = project.substrate(wanted->substrate);
  if (substrate != nullptr && substrate->type == Substrate::Type::Part) {
    parts.insert(substrate->part);
  }
  std::vector<Command> commands;
  for (const std::string& id : parts) {
    commands.push_back(
        {"part.set",
         Value::object(
             {{"id", id}, {"placement", movedPlacement(project.part(id)->placement, move)}})});
  }
  if (substrate != nullptr) {
    // A substrate's placement stands among its own keys.
    Value args = movedPlacement(substrate->placement, move);
    commands.push_back({"substrate.set", args.set("id", substrate->id)});
  }
  return commands;
}

Value toValue(const motion::PlacementMap& map) {
  Value places = Value::array();
  for (const motion::PartPlace& place : map.places) {
    Value value = Value::object();
    for (const auto& [name, figure] : figuresOf(place)) {
      value.set(name, std::isfinite(figure) ? Value(figure) : Value());
    }
    places.push(value.set("branch", place.branch));
  }
  return Value::object({{"best", map.best}, {"places", places}});
}

std::string toCsv(const motion::PlacementMap& map) {
  std::string text;
  for (const auto& [name, figure] : figuresOf(motion::PartPlace())) {
    text += std::string(name) + ",";
  }
  text += "branch\n";
  for (const motion::PartPlace& place : map.places) {
    for (const auto& [name, figure] : figuresOf(place)) {
      text += (std::isfinite(figure) ? formatFixed(figure, 6) : std::string()) + ",";
    }
    text += place.branch + "\n";
  }
  return text;
}

}  // namespace wcam::project
