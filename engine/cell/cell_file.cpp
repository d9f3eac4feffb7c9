// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/param.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/base/text.hpp"
#include "wcam/cell/angles.hpp"
#include "wcam/cell/cell.hpp"
#include "wcam/cell/joint_text.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace wcam::cell {

namespace {

/// Printed axes within this deviation of RᵀR from the identity are taken as rounding of the file;
/// more is told.
constexpr double kOrthonormal = 1e-9;
/// Beyond this the axes are no rotation with rounding errors but a mistake.
constexpr double kNotARotation = 0.05;
constexpr int kRobotJoints = 6;
/// A machine whose tool cannot turn about its own axis; with a torch only.
constexpr int kFewestRobotJoints = 5;
constexpr int kMaxPositionerJoints = 2;
/// Joints that a JointVector holds.
constexpr int kMostJoints = 12;

std::string joinPath(const std::string& path, const std::string& key) {
  return path.empty() ? key : path + "." + key;
}

/// Reads values and collects every problem with its path instead of stopping at the first one.
class Reader {
public:
  Reader(std::string contextName, const JobContext& job)
      : contextName_(std::move(contextName)), job_(job) {}

  void problem(const std::string& path, const std::string& message) {
    problems_.push_back({path, message, false});
  }

  void finish() const { throwProblems(problems_, ErrorCode::ProjectInvalid, contextName_); }

  /// The member as an object; null (with a problem, when required) if it is none.
  const Value* object(const Value& parent,
                      const std::string& parentPath,
                      const std::string& key,
                      bool required) {
    const Value* value = member(parent, parentPath, key, required);
    if (value != nullptr && !value->isObject()) {
      problem(joinPath(parentPath, key),
              std::string("expected an object, got ") + toString(value->type()));
      return nullptr;
    }
    return value;
  }

  const Value* member(const Value& parent,
                      const std::string& parentPath,
                      const std::string& key,
                      bool required) {
    const Value* value = parent.find(key);
    if (value == nullptr && required) {
      problem(joinPath(parentPath, key), "is missing");
    }
    return value;
  }

  double number(const Value& value, const std::string& path, double fallback = 0.0) {
    if (!value.isNumber() || !std::isfinite(value.asReal())) {
      problem(path, value.isNumber()
                        ? "is not a finite number"
                        : std::string("expected a number, got ") + toString(value.type()));
      return fallback;
    }
    return value.asReal();
  }

  double number(const Value& parent,
                const std::string& parentPath,
                const std::string& key,
                bool required,
                double fallback) {
    const Value* value = member(parent, parentPath, key, required);
    return value == nullptr ? fallback : number(*value, joinPath(parentPath, key), fallback);
  }

  /// A number that must be above zero.
  double positive(const Value& parent,
                  const std::string& parentPath,
                  const std::string& key,
                  bool required,
                  double fallback) {
    const double value = number(parent, parentPath, key, required, fallback);
    if (parent.contains(key) && parent.find(key)->isNumber() && !(value > 0.0)) {
      problem(joinPath(parentPath, key), "must be greater than 0");
      return fallback;
    }
    return value;
  }

  std::string text(const Value& parent,
                   const std::string& parentPath,
                   const std::string& key,
                   bool required) {
    const Value* value = member(parent, parentPath, key, required);
    if (value == nullptr) {
      return {};
    }
    if (!value->isString()) {
      problem(joinPath(parentPath, key),
              std::string("expected a text, got ") + toString(value->type()));
      return {};
    }
    if (required && value->asString().empty()) {
      problem(joinPath(parentPath, key), "is empty");
    }
    return value->asString();
  }

  Vec3 vector(const Value& value, const std::string& path) {
    Vec3 result = Vec3::Zero();
    if (!value.isArray() || value.size() != 3) {
      problem(path, "expected a list of 3 numbers");
      return result;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      result(static_cast<Eigen::Index>(i)) =
          number(value.asArray()[i], path + "[" + std::to_string(i) + "]");
    }
    return result;
  }

  /// Keys that nothing reads are mistakes: a mistyped "limits" must not pass as "no limits".
  void knownKeys(const Value& object, const std::string& path, std::vector<std::string> keys) {
    keys.emplace_back("comment");
    for (const auto& [key, value] : object.asObject()) {
      if (std::find(keys.begin(), keys.end(), key) == keys.end() && !key.starts_with("x-")) {
        const auto near = nearestName(key, keys);
        problem(joinPath(path, key),
                "is not known here" + (near ? "; did you mean '" + *near + "'?" : std::string()) +
                    " (notes go into \"comment\" or keys that begin with x-)");
      }
    }
  }

  Pose pose(const Value& parent,
            const std::string& parentPath,
            const std::string& key,
            bool required);

private:
  Eigen::Matrix3d rotation(const Value& value, const std::string& path);
  Eigen::Matrix3d orthonormal(const Eigen::Matrix3d& printed, const std::string& path);
  Eigen::Matrix3d axes(const Value& value, const std::string& path);
  Pose matrix(const Value& value, const std::string& path);

  std::string contextName_;
  const JobContext& job_;
  std::vector<ParamProblem> problems_;
};

/// The nearest rotation (SVD), with a finding when the printed one is off by more than rounding.
Eigen::Matrix3d Reader::orthonormal(const Eigen::Matrix3d& printed, const std::string& path) {
  const Eigen::Matrix3d gram = printed.transpose() * printed - Eigen::Matrix3d::Identity();
  const double deviation = gram.cwiseAbs().maxCoeff();
  if (!(deviation <= kNotARotation) || printed.determinant() <= 0.0) {
    problem(path, printed.determinant() <= 0.0 && deviation <= kNotARotation
                      ? "the axes are left-handed"
                      : "the axes are not perpendicular unit vectors (off by " +
                            formatFixed(deviation, 4) + ")");
    return Eigen::Matrix3d::Identity();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(printed, Eigen::ComputeFullU | Eigen::ComputeFullV);
  if (deviation > kOrthonormal) {
    job_.add({Severity::Warning,
              "cell.frame_not_orthonormal",
              contextName_ + ": the printed axes of " + path +
                  " are not perpendicular unit vectors; the nearest rotation is used",
              "write the axes with more digits or as angles",
              {},
              {{"deviation", deviation}}});
  }
  return svd.matrixU() * svd.matrixV().transpose();
}

Eigen::Matrix3d Reader::axes(const Value& value, const std::string& path) {
  Eigen::Matrix3d printed = Eigen::Matrix3d::Identity();
  if (!value.isObject()) {
    problem(path, "expected an object with the vectors x, y and z");
    return printed;
  }
  knownKeys(value, path, {"x", "y", "z"});
  Eigen::Index column = 0;
  const std::size_t before = problems_.size();
  for (const char* key : {"x", "y", "z"}) {
    const Value* axis = member(value, path, key, true);
    if (axis != nullptr) {
      printed.col(column) = vector(*axis, joinPath(path, key));
    }
    ++column;
  }
  return problems_.size() == before ? orthonormal(printed, path) : Eigen::Matrix3d::Identity();
}

Pose Reader::matrix(const Value& value, const std::string& path) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  bool good = value.isArray() && value.size() == 4;
  for (std::size_t i = 0; good && i < 4; ++i) {
    const Value& row = value.asArray()[i];
    good = row.isArray() && row.size() == 4;
    for (std::size_t k = 0; good && k < 4; ++k) {
      const Value& item = row.asArray()[k];
      good = item.isNumber() && std::isfinite(item.asReal());
      m(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = good ? item.asReal() : 0.0;
    }
  }
  Pose pose = Pose::Identity();
  if (!good || m.row(3) != Eigen::RowVector4d(0, 0, 0, 1)) {
    problem(path, "expected 4 rows of 4 numbers, the last row 0 0 0 1");
    return pose;
  }
  pose.linear() = orthonormal(m.topLeftCorner<3, 3>(), path);
  pose.translation() = m.topRightCorner<3, 1>();
  return pose;
}

Eigen::Matrix3d Reader::rotation(const Value& value, const std::string& path) {
  struct Convention {
    const char* key;
    Rotation (*toMatrix)(const Angles&);
  };

  static constexpr Convention kConventions[] = {
      {"wpr", &fromFanucWpr}, {"abc", &fromKukaAbc}, {"bryant", &fromBryant}};
  Eigen::Matrix3d result = Eigen::Matrix3d::Identity();
  int found = 0;
  for (const Convention& convention : kConventions) {
    if (const Value* angles = value.find(convention.key); angles != nullptr) {
      ++found;
      const Vec3 degrees = vector(*angles, joinPath(path, convention.key));
      result = convention.toMatrix(degrees * (kPi / 180.0));
    }
  }
  if (const Value* printed = value.find("axes"); printed != nullptr) {
    ++found;
    result = axes(*printed, joinPath(path, "axes"));
  }
  if (found > 1) {
    problem(path, "gives its rotation more than once; keep one of wpr, abc, bryant, axes");
  }
  return result;
}

Pose Reader::pose(const Value& parent,
                  const std::string& parentPath,
                  const std::string& key,
                  bool required) {
  const std::string path = joinPath(parentPath, key);
  const Value* value = object(parent, parentPath, key, required);
  if (value == nullptr) {
    return Pose::Identity();
  }
  knownKeys(*value, path, {"xyz", "wpr", "abc", "bryant", "axes", "matrix"});
  if (const Value* m = value->find("matrix"); m != nullptr) {
    if (value->contains("xyz") || value->contains("wpr") || value->contains("abc") ||
        value->contains("bryant") || value->contains("axes")) {
      problem(path, "gives a matrix beside other parts; keep the matrix alone");
    }
    return matrix(*m, joinPath(path, "matrix"));
  }
  Pose result = Pose::Identity();
  if (const Value* xyz = member(*value, path, "xyz", true); xyz != nullptr) {
    result.translation() = vector(*xyz, joinPath(path, "xyz"));
  }
  result.linear() = rotation(*value, path);
  return result;
}

/// [min, max] in the file's unit.
std::array<double, 2> readRange(Reader& reader,
                                const Value& value,
                                const std::string& path,
                                const std::string& unit) {
  if (!value.isArray() || value.size() != 2) {
    reader.problem(path, "expected [min, max] in " + unit);
    return {-1.0, 1.0};
  }
  const std::array<double, 2> range = {reader.number(value.asArray()[0], path + "[0]"),
                                       reader.number(value.asArray()[1], path + "[1]")};
  if (!(range[0] < range[1]) && value.asArray()[0].isNumber() && value.asArray()[1].isNumber()) {
    reader.problem(path, "the minimum must be below the maximum");
  }
  return range;
}

void readLimits(Reader& reader, const Value& value, const std::string& path, Joint& joint) {
  const Value* limits = value.find("limits");
  const Value* endless = value.find("endless");
  const std::string unit = joint.prismatic() ? "mm" : "degrees";
  joint.endless = endless != nullptr && endless->isBool() && endless->asBool();
  if (endless != nullptr && !endless->isBool()) {
    reader.problem(joinPath(path, "endless"), "expected true or false");
  }
  if (joint.endless && joint.prismatic()) {
    reader.problem(joinPath(path, "endless"), "a prismatic joint ends somewhere; give its limits");
    return;
  }
  if (limits == nullptr) {
    if (!joint.endless) {
      reader.problem(path, "needs \"limits\": [min, max] in " + unit +
                               (joint.prismatic() ? "" : " or \"endless\": true"));
    }
    return;
  }
  if (joint.endless) {
    reader.problem(path, "has limits and is endless; keep one");
    return;
  }
  const auto range = readRange(reader, *limits, joinPath(path, "limits"), unit);
  joint.min = fromJointUnit(joint, range[0]);
  joint.max = fromJointUnit(joint, range[1]);
}

void readType(Reader& reader, const Value& value, const std::string& path, Joint& joint) {
  if (!value.contains("type")) {
    return;
  }
  const std::string type = reader.text(value, path, "type", false);
  if (type == "prismatic") {
    joint.type = JointType::Prismatic;
  } else if (type != "revolute" && value.find("type")->isString()) {
    reader.problem(joinPath(path, "type"), "is neither revolute nor prismatic, but '" + type + "'");
  }
}

void readCoupling(Reader& reader,
                  const Value& value,
                  const std::string& path,
                  const std::vector<Joint>& before,
                  Joint& joint) {
  const Value* coupling = reader.object(value, path, "coupling", false);
  if (coupling == nullptr) {
    return;
  }
  for (const auto& [name, factor] : coupling->asObject()) {
    const auto it = std::find_if(before.begin(), before.end(),
                                 [&name = name](const Joint& other) { return other.name == name; });
    const std::string place = joinPath(joinPath(path, "coupling"), name);
    if (it == before.end()) {
      reader.problem(place, "is not the name of a joint before this one");
      continue;
    }
    joint.coupling.resize(
        std::max(joint.coupling.size(), static_cast<std::size_t>(it - before.begin()) + 1));
    joint.coupling[static_cast<std::size_t>(it - before.begin())] = reader.number(factor, place);
  }
}

Joint readJoint(Reader& reader,
                const Value& value,
                const std::string& path,
                const std::vector<Joint>& before) {
  Joint joint;
  if (!value.isObject()) {
    reader.problem(path, std::string("expected an object, got ") + toString(value.type()));
    return joint;
  }
  reader.knownKeys(
      value, path,
      {"name", "type", "alpha", "d", "theta", "r", "sign", "coupling", "limits", "endless",
       "max_speed", "max_acceleration", "max_jerk", "ratio", "resolution", "backlash"});
  joint.name = reader.text(value, path, "name", true);
  readType(reader, value, path, joint);
  joint.alpha = degToRad(reader.number(value, path, "alpha", true, 0.0));
  joint.d = reader.number(value, path, "d", true, 0.0);
  joint.theta = degToRad(reader.number(value, path, "theta", true, 0.0));
  joint.r = reader.number(value, path, "r", true, 0.0);
  joint.sign = reader.number(value, path, "sign", false, 1.0);
  if (std::abs(joint.sign) != 1.0) {
    reader.problem(joinPath(path, "sign"), "must be 1 or -1");
    joint.sign = 1.0;
  }
  readCoupling(reader, value, path, before, joint);
  readLimits(reader, value, path, joint);
  const auto positive = [&](const char* key, bool required, double fallback) {
    return fromJointUnit(joint, reader.positive(value, path, key, required, fallback));
  };
  const double inf = std::numeric_limits<double>::infinity();
  joint.maxSpeed = positive("max_speed", true, 1.0);
  joint.maxAcceleration = positive("max_acceleration", false, inf);
  joint.maxJerk = positive("max_jerk", false, inf);
  joint.ratio = reader.positive(value, path, "ratio", false, 0.0);
  joint.resolution = positive("resolution", false, 0.0);
  joint.backlash = positive("backlash", false, 0.0);
  return joint;
}

void readJoints(Reader& reader, const Value& parent, const std::string& path, Chain& chain) {
  const Value* joints = reader.member(parent, path, "joints", true);
  if (joints == nullptr) {
    return;
  }
  const std::string place = joinPath(path, "joints");
  if (!joints->isArray()) {
    reader.problem(place, std::string("expected a list, got ") + toString(joints->type()));
    return;
  }
  for (std::size_t i = 0; i < joints->size(); ++i) {
    const std::string jointPath = place + "[" + std::to_string(i) + "]";
    chain.joints.push_back(readJoint(reader, joints->asArray()[i], jointPath, chain.joints));
  }
}

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
      reader.problem(path, "expected a list of " + std::to_string(cell.robot.size()) +
                               " offsets, one per joint");
      continue;
    }
    ZeroConvention convention{name, JointVector(cell.robot.size())};
    for (int j = 0; j < cell.robot.size(); ++j) {
      const auto i = static_cast<std::size_t>(j);
      convention.offsets(j) =
          fromJointUnit(cell.robot.joints[i],
                        reader.number(offsets.asArray()[i], path + "[" + std::to_string(j) + "]"));
    }
    cell.zeroConventions.push_back(std::move(convention));
  }
}

void readRobot(Reader& reader, const Value& file, Cell& cell) {
  const Value* robot = reader.object(file, "", "robot", true);
  if (robot == nullptr) {
    return;
  }
  reader.knownKeys(
      *robot, "robot",
      {"name", "T_world_base", "joints", "T_last_flange", "zero_conventions", "collision"});
  cell.robotName = reader.text(*robot, "robot", "name", true);
  cell.T_world_base = reader.pose(*robot, "robot", "T_world_base", false);
  cell.robot.T_last_tip = reader.pose(*robot, "robot", "T_last_flange", false);
  readJoints(reader, *robot, "robot", cell.robot);
  if (cell.robot.size() <= kMostJoints) {
    readZeroConventions(reader, *robot, cell);
  }
  if (robot->contains("joints") && robot->at("joints").isArray() &&
      cell.robot.size() != kRobotJoints &&
      (cell.partCarried() || cell.robot.size() != kFewestRobotJoints)) {
    reader.problem("robot.joints", "expected 6 joints" +
                                       std::string(cell.partCarried() ? "" : " (or 5)") + ", got " +
                                       std::to_string(cell.robot.size()));
  }
}

void readTorch(Reader& reader, const Value& file, Cell& cell) {
  const Value* torch = reader.object(file, "", "torch", true);
  if (torch == nullptr) {
    return;
  }
  const char* poseKey = cell.partCarried() ? "T_base_tcp" : "T_flange_tcp";
  reader.knownKeys(*torch, "torch", {"name", poseKey, "neck", "collision"});
  cell.torchName = reader.text(*torch, "torch", "name", true);
  (cell.partCarried() ? cell.T_base_tcp : cell.T_flange_tcp) =
      reader.pose(*torch, "torch", poseKey, true);
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
    reader.problem("positioner.joints",
                   "expected 0, 1 or 2 joints, got " + std::to_string(cell.positioner.size()));
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
    reader.problem("configuration", "'" + text + "' is neither torch_carried nor part_carried");
  }
}

void checkVersion(const Value& file, const std::string& contextName) {
  const Value* version = file.find("format_version");
  if (version == nullptr || !version->isInteger() || version->asInteger() < 1) {
    throw Error(ErrorCode::ProjectInvalid,
                "format_version: expected the integer " + std::to_string(Cell::kFormatVersion),
                contextName, "this does not look like a cell file");
  }
  if (version->asInteger() > Cell::kFormatVersion) {
    throw Error(ErrorCode::ProjectInvalid,
                "the cell file has format version " + std::to_string(version->asInteger()) +
                    "; this program reads versions up to " + std::to_string(Cell::kFormatVersion),
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
  reading.problem = [&](const std::string& path, const std::string& message) {
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
                     "the joint name '" + name + "' is used twice");
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
    reader.problem(path, std::string("expected an object, got ") + toString(value.type()));
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
      sum.factors[static_cast<std::size_t>(j)] = reader.number(factor, place);
    }
    if (linear && rotary) {
      reader.problem(joinPath(path, "joints"), "adds lengths to angles");
    }
  }
  if (const Value* limits = reader.member(value, path, "limits", true); limits != nullptr) {
    const auto range =
        readRange(reader, *limits, joinPath(path, "limits"), linear ? "mm" : "degrees");
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
    reader.problem("sum_limits", std::string("expected a list, got ") + toString(sums->type()));
    return;
  }
  for (std::size_t i = 0; i < sums->size(); ++i) {
    readSum(reader, sums->asArray()[i], "sum_limits[" + std::to_string(i) + "]", cell);
  }
}

}  // namespace

Cell cellFromValue(const Value& value,
                   const std::string& contextName,
                   const JobContext& context,
                   const std::filesystem::path& folder) {
  if (!value.isObject()) {
    throw Error(ErrorCode::ProjectInvalid,
                std::string("expected an object, got ") + toString(value.type()), contextName,
                "this does not look like a cell file");
  }
  checkVersion(value, contextName);
  Reader reader(contextName, context);
  Cell cell;
  cell.source = value;
  reader.knownKeys(value, "",
                   {"format_version", "name", "description", "configuration", "robot", "torch",
                    "positioner", "part_holder", "sum_limits", "obstacles"});
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
  reader.finish();
  prepareArm(cell);
  return cell;
}

Cell loadCell(const std::filesystem::path& file, const JobContext& context) {
  const std::string name = pathText(file);
  return cellFromValue(parseJson(readFile(file), name), "cell file " + name, context,
                       file.parent_path());
}

}  // namespace wcam::cell
