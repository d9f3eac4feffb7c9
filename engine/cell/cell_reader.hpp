// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/base/param.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/base/value.hpp"
#include "wcam/cell/chain.hpp"

#include <array>
#include <string>
#include <vector>

/// How cell files are read. Private to this module.
namespace wcam::cell::detail {

std::string joinPath(const std::string& path, const std::string& key);

/// Reads values and collects every problem with its path instead of stopping at the first one.
class Reader {
public:
  Reader(Text contextName, const JobContext& job)
      : contextName_(std::move(contextName)), job_(job) {}

  void problem(const std::string& path, const Text& message) {
    problems_.push_back({path, message, false});
  }

  void finish() const { throwProblems(problems_, ErrorCode::ProjectInvalid, contextName_); }

  /// The member as an object; null (with a problem, when required) if it is none.
  const Value* object(const Value& parent,
                      const std::string& parentPath,
                      const std::string& key,
                      bool required);

  const Value* member(const Value& parent,
                      const std::string& parentPath,
                      const std::string& key,
                      bool required);

  /// A number in the file unit of its kind, within the plausible range of it.
  double number(const Value& value,
                const std::string& path,
                QuantityKind kind,
                double fallback = 0.0);

  double number(const Value& parent,
                const std::string& parentPath,
                const std::string& key,
                QuantityKind kind,
                bool required,
                double fallback);

  /// A number that must be above zero.
  double positive(const Value& parent,
                  const std::string& parentPath,
                  const std::string& key,
                  QuantityKind kind,
                  bool required,
                  double fallback);

  std::string text(const Value& parent,
                   const std::string& parentPath,
                   const std::string& key,
                   bool required);

  Vec3 vector(const Value& value, const std::string& path, QuantityKind kind);

  /// Keys that nothing reads are mistakes: a mistyped "limits" must not pass as "no limits".
  void knownKeys(const Value& object, const std::string& path, std::vector<std::string> keys);

  Pose pose(const Value& parent,
            const std::string& parentPath,
            const std::string& key,
            bool required);

private:
  Eigen::Matrix3d rotation(const Value& value, const std::string& path);
  Eigen::Matrix3d orthonormal(const Eigen::Matrix3d& printed, const std::string& path);
  Eigen::Matrix3d axes(const Value& value, const std::string& path);
  Pose matrix(const Value& value, const std::string& path);

  Text contextName_;
  const JobContext& job_;
  std::vector<ParamProblem> problems_;
};

/// [min, max] in the file unit of the kind.
std::array<double, 2> readRange(Reader& reader,
                                const Value& value,
                                const std::string& path,
                                QuantityKind kind);

/// What the values and limits of a joint measure.
inline QuantityKind lengthOrAngle(const Joint& joint) {
  return joint.prismatic() ? QuantityKind::Length : QuantityKind::Angle;
}

/// The joints of a robot or positioner, in the file's order.
void readJoints(Reader& reader, const Value& parent, const std::string& path, Chain& chain);

}  // namespace wcam::cell::detail
