// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/base/value.hpp"
#include "wcam/cell/arm.hpp"
#include "wcam/cell/chain.hpp"
#include "wcam/cell/shapes.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace wcam::cell {

/// Who moves what: the robot carries the torch and a positioner (with 0, 1 or 2 axes) the part, or
/// the robot carries the part under a torch that is fixed in the world.
enum class Configuration { TorchCarried, PartCarried };

/// A robot cell (DESIGN 8). A value; derived data (closed-form arm) is found at load time. Joint
/// vectors hold the robot's joints, then the positioner's, in controller values.
///
/// Frames: world (z vertical, up), base (robot), flange, tcp (z = tool axis, from the part towards
/// the torch), table, part.
struct Cell {
  static constexpr int kFormatVersion = 1;

  std::string name;
  std::string description;
  Configuration configuration = Configuration::TorchCarried;
  std::string robotName;
  std::string positionerName;
  std::string torchName;

  Pose T_world_base = Pose::Identity();
  Chain robot;       ///< base → flange, 6 joints
  Chain positioner;  ///< base → table, 0 to 2 joints; unused when the robot carries the part
  Pose T_flange_tcp = Pose::Identity();  ///< torch carried
  Pose T_base_tcp = Pose::Identity();    ///< part carried: the fixed deposition point and its axis
  Pose T_flange_table = Pose::Identity();  ///< part carried
  Pose T_table_part = Pose::Identity();

  /// Closed-form inverse kinematics; empty when the robot has no spherical wrist or no parallel
  /// second and third axes; armProblem then tells why.
  std::optional<Arm> arm;
  std::string armProblem;

  CellShapes shapes;  ///< what can collide
  Value source;       ///< the file's content with everything that is not read here

  [[nodiscard]] bool partCarried() const { return configuration == Configuration::PartCarried; }

  [[nodiscard]] int robotJoints() const { return robot.size(); }

  [[nodiscard]] int positionerJoints() const { return positioner.size(); }

  [[nodiscard]] int jointCount() const { return robot.size() + positioner.size(); }

  [[nodiscard]] const Joint& joint(int index) const;
  /// Unit vector of the vertical (world z) in the robot base frame.
  [[nodiscard]] Vec3 verticalInBase() const;
};

/// Reads a cell file (resources/doc/cell-format.md): mm and degrees. Printed axes that are not
/// orthonormal are replaced by the nearest rotation with the diagnostic cell.frame_not_orthonormal.
/// @throws Error(InputNotFound, InputInvalid) for the file, Error(ProjectInvalid) with all format
/// problems and their paths
Cell loadCell(const std::filesystem::path& file, const JobContext& context = JobContext());
/// The same from a parsed file; `contextName` names it in messages, meshes are looked for in
/// `folder`.
Cell cellFromValue(const Value& value,
                   const std::string& contextName,
                   const JobContext& context = JobContext(),
                   const std::filesystem::path& folder = {});

/// Finds cell.arm from the axes of cell.robot. Called by the loaders; call it again after changing
/// the chain.
void prepareArm(Cell& cell);

}  // namespace wcam::cell
