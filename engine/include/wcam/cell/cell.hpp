// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/base/value.hpp"
#include "wcam/cell/arm.hpp"
#include "wcam/cell/chain.hpp"
#include "wcam/cell/shapes.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace wcam::cell {

/// Who moves what: the robot carries the torch and a positioner (with 0, 1 or 2 axes) the part, or
/// the robot carries the part under a torch that is fixed in the world.
enum class Configuration { TorchCarried, PartCarried };

class InverseKinematics;

/// A limit on a weighted sum of joints: cables or hoses that several joints wrap (Debout T2: C1 +
/// C2 of the 7-axis machine; |J4 + J6| of an arm).
struct JointSum {
  std::string name;
  std::vector<double> factors;  ///< one per joint of the cell
  double min = 0.0;             ///< rad, or mm where the joints are prismatic
  double max = 0.0;

  [[nodiscard]] double value(const JointVector& q) const;
};

/// How far the torch's cable may be twisted by axes 4 and 6 of an arm (Chalvin A33).
struct CableLimit {
  double limit = 0.0;  ///< of the twist from `zero` to both sides, rad
  double zero = 0.0;   ///< J4 + J6 of the untwisted cable, rad
};

/// Where else somebody counts the robot's joints from: shown value = controller value + offset.
/// (Carrière's scripts count the axes of the KR360 from another posture than KUKA.)
struct ZeroConvention {
  std::string name;
  JointVector offsets;  ///< one per joint of the robot, rad or mm
};

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
  Chain robot;       ///< base → flange, 6 joints, or 5 with a torch
  Chain positioner;  ///< base → table, 0 to 2 joints; unused when the robot carries the part
  Pose T_flange_tcp = Pose::Identity();  ///< torch carried
  Pose T_base_tcp = Pose::Identity();    ///< part carried: the fixed deposition point and its axis
  Pose T_flange_table = Pose::Identity();  ///< part carried
  Pose T_table_part = Pose::Identity();

  /// Closed-form inverse kinematics; empty when the robot has no spherical wrist or no parallel
  /// second and third axes; armProblem then tells why.
  std::optional<Arm> arm;
  Text armProblem;
  /// Inverse kinematics of whatever robot (wcam/cell/inverse.hpp); never null after loading.
  std::shared_ptr<const InverseKinematics> inverse;

  std::vector<JointSum> sums;
  std::optional<CableLimit> cable;  ///< of the torch; torch carried only
  std::vector<ZeroConvention> zeroConventions;

  /// The same robot in the other configuration, where the file names one (its own `other` is null).
  std::shared_ptr<const Cell> other;

  CellShapes shapes;  ///< what can collide
  Value source;       ///< the file's content with everything that is not read here

  [[nodiscard]] bool partCarried() const { return configuration == Configuration::PartCarried; }

  [[nodiscard]] int robotJoints() const { return robot.size(); }

  [[nodiscard]] int positionerJoints() const { return positioner.size(); }

  [[nodiscard]] int jointCount() const { return robot.size() + positioner.size(); }

  [[nodiscard]] const Joint& joint(int index) const;
  /// Controller values from values counted in a zero convention of the file.
  /// @throws Error(InvalidArgument) with the known names
  [[nodiscard]] JointVector fromConvention(const std::string& wanted,
                                           const JointVector& shown) const;
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
                   const Text& contextName,
                   const JobContext& context = JobContext(),
                   const std::filesystem::path& folder = {});

/// The file that a cell file names as its other configuration, resolved against its folder.
std::optional<std::filesystem::path> otherConfigurationFile(const Value& file,
                                                            const std::filesystem::path& folder);

/// Finds cell.arm and cell.inverse from the axes of cell.robot. Called by the loaders; call it
/// again after changing the chain or the tool.
void prepareArm(Cell& cell);

}  // namespace wcam::cell
