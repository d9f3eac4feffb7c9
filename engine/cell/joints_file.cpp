// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/plausible.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/cell/joint_text.hpp"

#include "cell_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::cell::detail {

namespace {

/// Beyond what any drive gives, per s² and s³: damage, or another unit.
constexpr double kMostAcceleration = 1e9;
constexpr double kMostJerk = 1e12;

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
      reader.problem(
          path, text(joint.prismatic() ? "needs \"limits\": [min, max] in %1"
                                       : "needs \"limits\": [min, max] in %1 or \"endless\": true",
                     {unit}));
    }
    return;
  }
  if (joint.endless) {
    reader.problem(path, "has limits and is endless; keep one");
    return;
  }
  const auto range = readRange(reader, *limits, joinPath(path, "limits"), lengthOrAngle(joint));
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
    reader.problem(joinPath(path, "type"),
                   wcam::text("is neither revolute nor prismatic, but '%1'", {type}));
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
    joint.coupling[static_cast<std::size_t>(it - before.begin())] =
        reader.number(factor, place, QuantityKind::Ratio);
  }
}

Joint readJoint(Reader& reader,
                const Value& value,
                const std::string& path,
                const std::vector<Joint>& before) {
  Joint joint;
  if (!value.isObject()) {
    reader.problem(path, wcam::text("expected an object, got %1", {toString(value.type())}));
    return joint;
  }
  reader.knownKeys(
      value, path,
      {"name", "type", "alpha", "d", "theta", "r", "sign", "coupling", "limits", "endless",
       "max_speed", "max_acceleration", "max_jerk", "ratio", "resolution", "backlash"});
  joint.name = reader.text(value, path, "name", true);
  readType(reader, value, path, joint);
  joint.alpha = degToRad(reader.number(value, path, "alpha", QuantityKind::Angle, true, 0.0));
  joint.d = reader.number(value, path, "d", QuantityKind::Length, true, 0.0);
  joint.theta = degToRad(reader.number(value, path, "theta", QuantityKind::Angle, true, 0.0));
  joint.r = reader.number(value, path, "r", QuantityKind::Length, true, 0.0);
  joint.sign = reader.number(value, path, "sign", QuantityKind::Ratio, false, 1.0);
  if (std::abs(joint.sign) != 1.0) {
    reader.problem(joinPath(path, "sign"), "must be 1 or -1");
    joint.sign = 1.0;
  }
  readCoupling(reader, value, path, before, joint);
  readLimits(reader, value, path, joint);
  const auto positive = [&](const char* key, QuantityKind kind, bool required, double fallback) {
    return fromJointUnit(joint, reader.positive(value, path, key, kind, required, fallback));
  };
  const double inf = std::numeric_limits<double>::infinity();
  const QuantityKind way = lengthOrAngle(joint);
  const QuantityKind rate = joint.prismatic() ? QuantityKind::Speed : QuantityKind::AngularSpeed;
  joint.maxSpeed = positive("max_speed", rate, true, 1.0);
  joint.maxAcceleration = positive("max_acceleration", QuantityKind::None, false, inf);
  joint.maxJerk = positive("max_jerk", QuantityKind::None, false, inf);
  const std::string unit = fileUnit(lengthOrAngle(joint));
  const auto notBeyond = [&](const char* key, double most, const std::string& perTime) {
    const Value* given = value.find(key);
    // What is not above 0 is reported already.
    if (given != nullptr && given->isNumber() && given->asReal() > 0.0) {
      const Text wrong = outOfRange(given->asReal(), {0.0, most}, unit + perTime);
      if (!wrong.empty()) {
        reader.problem(joinPath(path, key), wrong);
      }
    }
  };
  notBeyond("max_acceleration", kMostAcceleration, "/s2");
  notBeyond("max_jerk", kMostJerk, "/s3");
  joint.ratio = reader.positive(value, path, "ratio", QuantityKind::Ratio, false, 0.0);
  joint.resolution = positive("resolution", way, false, 0.0);
  joint.backlash = positive("backlash", way, false, 0.0);
  return joint;
}

}  // namespace

void readJoints(Reader& reader, const Value& parent, const std::string& path, Chain& chain) {
  const Value* joints = reader.member(parent, path, "joints", true);
  if (joints == nullptr) {
    return;
  }
  const std::string place = joinPath(path, "joints");
  if (!joints->isArray()) {
    reader.problem(place, wcam::text("expected a list, got %1", {toString(joints->type())}));
    return;
  }
  for (std::size_t i = 0; i < joints->size(); ++i) {
    const std::string jointPath = place + "[" + std::to_string(i) + "]";
    chain.joints.push_back(readJoint(reader, joints->asArray()[i], jointPath, chain.joints));
  }
}

}  // namespace wcam::cell::detail
