// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/cell/cell.hpp"
#include "wcam/cell/joint_text.hpp"

#include "cell_reader.hpp"

#include <set>

namespace wcam::cell {

namespace {

using detail::joinPath;
using detail::lengthOrAngle;
using detail::Reader;
using detail::readJoints;
using detail::readRange;

constexpr int kRobotJoints = 6;
/// A machine whose tool cannot turn about its own axis; with a torch only.
constexpr int kFewestRobotJoints = 5;
constexpr int kMaxPositionerJoints = 2;
/// Joints that a JointVector holds.
constexpr int kMostJoints = 12;

/// After the joints, whose units the offsets have.
void readZeroConventions(Reader& reader, const Value& robot, Cell& cell) {
  const Value* conventions = reader.object(robot, "robot", "zero_conventions", false);
  if (conventions == nullptr) {
    return;
  }
  for (const auto& [name, offsets] : conventions->asObject()) {
    if (name == "comment") {
      continue;
    }
    const std::string path = "robot.zero_conventions." + name;
    if (!offsets.isArray() || offsets.size() != cell.robot.joints.size()) {
      reader.problem(path, wcam::text("expected a list of %1 offsets, one per joint",
                                      {std::to_string(cell.robot.size())}));
      continue;
    }
    ZeroConvention convention{name, JointVector(cell.robot.size())};
    for (int j = 0; j < cell.robot.size(); ++j) {
      const auto i = static_cast<std::size_t>(j);
      convention.offsets(j) =
          fromJointUnit(cell.robot.joints[i],
                        reader.number(offsets.asArray()[i], path + "[" + std::to_string(j) + "]",
                                      lengthOrAngle(cell.robot.joints[i])));
    }
    cell.zeroConventions.push_back(std::move(convention));
  }
}

void readRobot(Reader& reader, const Value& file, Cell& cell) {
  const Value* robot = reader.object(file, "", "robot", true);
  if (robot == nullptr) {
    return;
  }
  reader.knownKeys(*robot, "robot",
                   {"name", "controller", "T_world_base", "joints", "T_last_flange",
                    "zero_conventions", "collision"});
  cell.robotName = reader.text(*robot, "robot", "name", true);
  (void)reader.text(*robot, "robot", "controller", false);  // controllerOf() reads it
  cell.T_world_base = reader.pose(*robot, "robot", "T_world_base", false);
  cell.robot.T_last_tip = reader.pose(*robot, "robot", "T_last_flange", false);
  readJoints(reader, *robot, "robot", cell.robot);
  if (cell.robot.size() <= kMostJoints) {
    readZeroConventions(reader, *robot, cell);
  }
  if (robot->contains("joints") && robot->at("joints").isArray() &&
      cell.robot.size() != kRobotJoints &&
      (cell.partCarried() || cell.robot.size() != kFewestRobotJoints)) {
    reader.problem("robot.joints", text(cell.partCarried() ? "expected 6 joints, got %1"
                                                           : "expected 6 joints (or 5), got %1",
                                        {std::to_string(cell.robot.size())}));
  }
}

void readTorch(Reader& reader, const Value& file, Cell& cell) {
  const Value* torch = reader.object(file, "", "torch", true);
  if (torch == nullptr) {
    return;
  }
  const char* poseKey = cell.partCarried() ? "T_base_tcp" : "T_flange_tcp";
  reader.knownKeys(*torch, "torch", {"name", poseKey, "neck", "collision", "cable"});
  cell.torchName = reader.text(*torch, "torch", "name", true);
  (cell.partCarried() ? cell.T_base_tcp : cell.T_flange_tcp) =
      reader.pose(*torch, "torch", poseKey, true);
  const Value* cable = reader.object(*torch, "torch", "cable", false);
  if (cable == nullptr) {
    return;
  }
  if (cell.partCarried()) {
    reader.problem("torch.cable", "belongs to a torch that the robot carries");
    return;
  }
  reader.knownKeys(*cable, "torch.cable", {"limit", "zero"});
  cell.cable = CableLimit{
      degToRad(reader.positive(*cable, "torch.cable", "limit", QuantityKind::Angle, true, 1.0)),
      degToRad(reader.number(*cable, "torch.cable", "zero", QuantityKind::Angle, false, 0.0))};
}

void readPositioner(Reader& reader, const Value& file, Cell& cell) {
  const Value* positioner = reader.object(file, "", "positioner", true);
  if (positioner == nullptr) {
    return;
  }
  reader.knownKeys(
      *positioner, "positioner",
      {"name", "T_base_positioner", "joints", "T_last_table", "T_table_part", "collision"});
  cell.positionerName = reader.text(*positioner, "positioner", "name", true);
  cell.positioner.T_root_first = reader.pose(*positioner, "positioner", "T_base_positioner", true);
  cell.positioner.T_last_tip = reader.pose(*positioner, "positioner", "T_last_table", false);
  cell.T_table_part = reader.pose(*positioner, "positioner", "T_table_part", false);
  readJoints(reader, *positioner, "positioner", cell.positioner);
  if (cell.positioner.size() > kMaxPositionerJoints) {
    reader.problem("positioner.joints", wcam::text("expected 0, 1 or 2 joints, got %1",
                                                   {std::to_string(cell.positioner.size())}));
  }
}

void readPartHolder(Reader& reader, const Value& file, Cell& cell) {
  const Value* holder = reader.object(file, "", "part_holder", true);
  if (holder == nullptr) {
    return;
  }
  reader.knownKeys(*holder, "part_holder", {"name", "T_flange_table", "T_table_part", "collision"});
  cell.positionerName = reader.text(*holder, "part_holder", "name", true);
  cell.T_flange_table = reader.pose(*holder, "part_holder", "T_flange_table", true);
  cell.T_table_part = reader.pose(*holder, "part_holder", "T_table_part", false);
}

void readConfiguration(Reader& reader, const Value& file, Cell& cell) {
  const std::string text = reader.text(file, "", "configuration", true);
  if (text == "part_carried") {
    cell.configuration = Configuration::PartCarried;
  } else if (text != "torch_carried" && !text.empty()) {
    reader.problem("configuration",
                   wcam::text("'%1' is neither torch_carried nor part_carried", {text}));
  }
}

void checkVersion(const Value& file, const Text& contextName) {
  const Value* version = file.find("format_version");
  if (version == nullptr || !version->isInteger() || version->asInteger() < 1) {
    throw Error(ErrorCode::ProjectInvalid,
                wcam::text("format_version: expected the integer %1",
                           {std::to_string(Cell::kFormatVersion)}),
                contextName, "this does not look like a cell file");
  }
  if (version->asInteger() > Cell::kFormatVersion) {
    throw Error(
        ErrorCode::ProjectInvalid,
        wcam::text("the cell file has format version %1; this program reads versions up to %2",
                   {std::to_string(version->asInteger()), std::to_string(Cell::kFormatVersion)}),
        contextName, "use a newer program");
  }
}

/// Frames that shapes can be fixed to.
std::vector<std::string> frameNames(const Cell& cell) {
  std::vector<std::string> names = {"world", "base", "flange", "tcp", "table"};
  for (int j = 0; j < cell.jointCount(); ++j) {
    names.push_back(cell.joint(j).name);
  }
  return names;
}

CellShapes readCellShapes(Reader& reader,
                          const Value& file,
                          const Cell& cell,
                          const std::filesystem::path& folder,
                          const JobContext& context) {
  ShapeReading reading;
  reading.problem = [&](const std::string& path, const Text& message) {
    reader.problem(path, message);
  };
  reading.pose = [&](const Value& parent, const std::string& path, const std::string& key) {
    return reader.pose(parent, path, key, false);
  };
  reading.frames = frameNames(cell);
  reading.folder = folder;
  return readShapes(file, reading, context);
}

void checkNames(Reader& reader, const Cell& cell) {
  std::set<std::string> names;
  for (int j = 0; j < cell.jointCount(); ++j) {
    const std::string& name = cell.joint(j).name;
    if (!name.empty() && !names.insert(name).second) {
      reader.problem(j < cell.robotJoints() ? "robot.joints" : "positioner.joints",
                     wcam::text("the joint name '%1' is used twice", {name}));
    }
  }
}

/// Index of a joint by its name; the number of joints when there is none.
int jointIndex(const Cell& cell, const std::string& name) {
  int j = 0;
  while (j < cell.jointCount() && cell.joint(j).name != name) {
    ++j;
  }
  return j;
}

void readSum(Reader& reader, const Value& value, const std::string& path, Cell& cell) {
  if (!value.isObject()) {
    reader.problem(path, wcam::text("expected an object, got %1", {toString(value.type())}));
    return;
  }
  reader.knownKeys(value, path, {"name", "joints", "limits"});
  JointSum sum;
  sum.name = reader.text(value, path, "name", true);
  sum.factors.assign(static_cast<std::size_t>(cell.jointCount()), 0.0);
  bool linear = false;
  bool rotary = false;
  if (const Value* joints = reader.object(value, path, "joints", true); joints != nullptr) {
    for (const auto& [name, factor] : joints->asObject()) {
      const std::string place = joinPath(joinPath(path, "joints"), name);
      const int j = jointIndex(cell, name);
      if (j == cell.jointCount()) {
        reader.problem(place, "is not the name of a joint");
        continue;
      }
      (cell.joint(j).prismatic() ? linear : rotary) = true;
      sum.factors[static_cast<std::size_t>(j)] = reader.number(factor, place, QuantityKind::Ratio);
    }
    if (linear && rotary) {
      reader.problem(joinPath(path, "joints"), "adds lengths to angles");
    }
  }
  if (const Value* limits = reader.member(value, path, "limits", true); limits != nullptr) {
    const auto range = readRange(reader, *limits, joinPath(path, "limits"),
                                 linear ? QuantityKind::Length : QuantityKind::Angle);
    sum.min = linear ? range[0] : degToRad(range[0]);
    sum.max = linear ? range[1] : degToRad(range[1]);
  }
  cell.sums.push_back(std::move(sum));
}

void readSums(Reader& reader, const Value& file, Cell& cell) {
  const Value* sums = file.find("sum_limits");
  if (sums == nullptr) {
    return;
  }
  if (!sums->isArray()) {
    reader.problem("sum_limits", wcam::text("expected a list, got %1", {toString(sums->type())}));
    return;
  }
  for (std::size_t i = 0; i < sums->size(); ++i) {
    readSum(reader, sums->asArray()[i], "sum_limits[" + std::to_string(i) + "]", cell);
  }
}

}  // namespace

namespace {

Cell readCell(const Value& value,
              const Text& contextName,
              const JobContext& context,
              const std::filesystem::path& folder,
              bool withOther);

/// The cell in the other configuration. Its findings are told where it is used itself.
void readOther(Reader& reader,
               const Value& file,
               const std::filesystem::path& folder,
               const JobContext& context,
               Cell& cell) {
  (void)reader.text(file, "", "other_configuration", false);
  const auto other = otherConfigurationFile(file, folder);
  if (!other || folder.empty()) {
    return;  // a value without a place has no files beside it
  }
  if (!std::filesystem::exists(*other)) {
    // A cell that was copied alone works; only one remedy fewer is tried.
    context.add({Severity::Information,
                 "cell.other_configuration_missing",
                 wcam::text("the cell's other_configuration %1 does not exist", {pathText(*other)}),
                 "copy it beside the cell file, or remove the key",
                 {},
                 {}});
    return;
  }
  try {
    const std::string name = pathText(*other);
    cell.other = std::make_shared<const Cell>(
        readCell(parseJson(readFile(*other), name), wcam::text("cell file %1", {name}),
                 context.withOwnDiagnostics(), other->parent_path(), false));
    if (cell.other->configuration == cell.configuration) {
      reader.problem("other_configuration", wcam::text("%1 has the same configuration", {name}));
    }
  } catch (const CancelledError&) {
    throw;
  } catch (const Error& error) {
    reader.problem("other_configuration", error.messageText());
  }
}

Cell readCell(const Value& value,
              const Text& contextName,
              const JobContext& context,
              const std::filesystem::path& folder,
              bool withOther) {
  if (!value.isObject()) {
    throw Error(ErrorCode::ProjectInvalid,
                wcam::text("expected an object, got %1", {toString(value.type())}), contextName,
                "this does not look like a cell file");
  }
  checkVersion(value, contextName);
  Reader reader(contextName, context);
  Cell cell;
  cell.source = value;
  reader.knownKeys(value, "",
                   {"format_version", "name", "description", "configuration", "robot", "torch",
                    "positioner", "part_holder", "sum_limits", "obstacles", "other_configuration"});
  cell.name = reader.text(value, "", "name", true);
  cell.description = reader.text(value, "", "description", false);
  readConfiguration(reader, value, cell);
  readRobot(reader, value, cell);
  readTorch(reader, value, cell);
  if (cell.partCarried()) {
    readPartHolder(reader, value, cell);
  } else {
    readPositioner(reader, value, cell);
  }
  const char* other = cell.partCarried() ? "positioner" : "part_holder";
  if (value.contains(other)) {
    reader.problem(other, "does not belong to this configuration");
  }
  checkNames(reader, cell);
  readSums(reader, value, cell);
  cell.shapes = readCellShapes(reader, value, cell, folder, context);
  if (withOther) {
    readOther(reader, value, folder, context, cell);
  }
  reader.finish();
  prepareArm(cell);
  return cell;
}

}  // namespace

std::optional<std::filesystem::path> otherConfigurationFile(const Value& file,
                                                            const std::filesystem::path& folder) {
  const Value* name = file.isObject() ? file.find("other_configuration") : nullptr;
  if (name == nullptr || !name->isString() || name->asString().empty()) {
    return std::nullopt;
  }
  return folder / pathFromText(name->asString());
}

Cell cellFromValue(const Value& value,
                   const Text& contextName,
                   const JobContext& context,
                   const std::filesystem::path& folder) {
  return readCell(value, contextName, context, folder, true);
}

Cell loadCell(const std::filesystem::path& file, const JobContext& context) {
  const std::string name = pathText(file);
  return cellFromValue(parseJson(readFile(file), name), wcam::text("cell file %1", {name}), context,
                       file.has_parent_path() ? file.parent_path() : ".");
}

}  // namespace wcam::cell
