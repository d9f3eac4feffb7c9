// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cell_reader.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/plausible.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/base/text.hpp"
#include "wcam/cell/angles.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace wcam::cell::detail {

namespace {

/// Printed axes within this deviation of RᵀR from the identity are taken as rounding of the file;
/// more is told.
constexpr double kOrthonormal = 1e-9;
/// Beyond this the axes are no rotation with rounding errors but a mistake.
constexpr double kNotARotation = 0.05;

}  // namespace

std::string joinPath(const std::string& path, const std::string& key) {
  return path.empty() ? key : path + "." + key;
}

const Value* Reader::object(const Value& parent,
                            const std::string& parentPath,
                            const std::string& key,
                            bool required) {
  const Value* value = member(parent, parentPath, key, required);
  if (value != nullptr && !value->isObject()) {
    problem(joinPath(parentPath, key),
            wcam::text("expected an object, got %1", {toString(value->type())}));
    return nullptr;
  }
  return value;
}

const Value* Reader::member(const Value& parent,
                            const std::string& parentPath,
                            const std::string& key,
                            bool required) {
  const Value* value = parent.find(key);
  if (value == nullptr && required) {
    problem(joinPath(parentPath, key), "is missing");
  }
  return value;
}

double Reader::number(const Value& value,
                      const std::string& path,
                      QuantityKind kind,
                      double fallback) {
  if (!value.isNumber()) {
    problem(path, wcam::text("expected a number, got %1", {toString(value.type())}));
    return fallback;
  }
  if (const Text wrong = implausible(value.asReal(), kind); !wrong.empty()) {
    problem(path, wrong);
    return fallback;
  }
  return value.asReal();
}

double Reader::number(const Value& parent,
                      const std::string& parentPath,
                      const std::string& key,
                      QuantityKind kind,
                      bool required,
                      double fallback) {
  const Value* value = member(parent, parentPath, key, required);
  return value == nullptr ? fallback : number(*value, joinPath(parentPath, key), kind, fallback);
}

double Reader::positive(const Value& parent,
                        const std::string& parentPath,
                        const std::string& key,
                        QuantityKind kind,
                        bool required,
                        double fallback) {
  const double value = number(parent, parentPath, key, kind, required, fallback);
  const Value* given = parent.find(key);
  if (given != nullptr && given->isNumber() && !(given->asReal() > 0.0)) {
    problem(joinPath(parentPath, key), "must be greater than 0");
    return fallback;
  }
  return value;
}

std::string Reader::text(const Value& parent,
                         const std::string& parentPath,
                         const std::string& key,
                         bool required) {
  const Value* value = member(parent, parentPath, key, required);
  if (value == nullptr) {
    return {};
  }
  if (!value->isString()) {
    problem(joinPath(parentPath, key),
            wcam::text("expected a text, got %1", {toString(value->type())}));
    return {};
  }
  if (required && value->asString().empty()) {
    problem(joinPath(parentPath, key), "is empty");
  }
  return value->asString();
}

Vec3 Reader::vector(const Value& value, const std::string& path, QuantityKind kind) {
  Vec3 result = Vec3::Zero();
  if (!value.isArray() || value.size() != 3) {
    problem(path, "expected a list of 3 numbers");
    return result;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    result(static_cast<Eigen::Index>(i)) =
        number(value.asArray()[i], path + "[" + std::to_string(i) + "]", kind);
  }
  return result;
}

void Reader::knownKeys(const Value& object,
                       const std::string& path,
                       std::vector<std::string> keys) {
  keys.emplace_back("comment");
  for (const auto& [key, value] : object.asObject()) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end() && !key.starts_with("x-")) {
      const auto near = nearestName(key, keys);
      problem(
          joinPath(path, key),
          near ? wcam::text("is not known here; did you mean '%1'? (notes go into \"comment\" or "
                            "keys that begin with x-)",
                            {*near})
               : wcam::text("is not known here (notes go into \"comment\" or keys that begin "
                            "with x-)"));
    }
  }
}

/// The nearest rotation (SVD), with a finding when the printed one is off by more than rounding.
Eigen::Matrix3d Reader::orthonormal(const Eigen::Matrix3d& printed, const std::string& path) {
  const Eigen::Matrix3d gram = printed.transpose() * printed - Eigen::Matrix3d::Identity();
  const double deviation = gram.cwiseAbs().maxCoeff();
  if (!(deviation <= kNotARotation) || printed.determinant() <= 0.0) {
    problem(path, printed.determinant() <= 0.0 && deviation <= kNotARotation
                      ? wcam::text("the axes are left-handed")
                      : wcam::text("the axes are not perpendicular unit vectors (off by %1)",
                                   {formatFixed(deviation, 4)}));
    return Eigen::Matrix3d::Identity();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(printed, Eigen::ComputeFullU | Eigen::ComputeFullV);
  if (deviation > kOrthonormal) {
    job_.add(
        {Severity::Warning,
         "cell.frame_not_orthonormal",
         wcam::text("%1: the printed axes of %2 are not perpendicular unit vectors; the nearest "
                    "rotation is used",
                    {contextName_, path}),
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
      printed.col(column) = vector(*axis, joinPath(path, key), QuantityKind::Ratio);
    }
    ++column;
  }
  return problems_.size() == before ? orthonormal(printed, path) : Eigen::Matrix3d::Identity();
}

Pose Reader::matrix(const Value& value, const std::string& path) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  bool good = value.isArray() && value.size() == 4;
  Text wrong;
  for (std::size_t i = 0; good && i < 4; ++i) {
    const Value& row = value.asArray()[i];
    good = row.isArray() && row.size() == 4;
    for (std::size_t k = 0; good && k < 4; ++k) {
      const Value& item = row.asArray()[k];
      good = item.isNumber() && std::isfinite(item.asReal());
      m(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = good ? item.asReal() : 0.0;
      if (good && k == 3 && wrong.empty()) {
        wrong = implausible(item.asReal(), QuantityKind::Length);
      }
    }
  }
  Pose pose = Pose::Identity();
  if (!good || m.row(3) != Eigen::RowVector4d(0, 0, 0, 1)) {
    problem(path, "expected 4 rows of 4 numbers, the last row 0 0 0 1");
    return pose;
  }
  if (!wrong.empty()) {
    problem(path, wrong);
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
      const Vec3 degrees = vector(*angles, joinPath(path, convention.key), QuantityKind::Angle);
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
    result.translation() = vector(*xyz, joinPath(path, "xyz"), QuantityKind::Length);
  }
  result.linear() = rotation(*value, path);
  return result;
}

std::array<double, 2> readRange(Reader& reader,
                                const Value& value,
                                const std::string& path,
                                QuantityKind kind) {
  if (!value.isArray() || value.size() != 2) {
    reader.problem(path, wcam::text("expected [min, max] in %1", {fileUnit(kind)}));
    return {-1.0, 1.0};
  }
  const std::array<double, 2> range = {reader.number(value.asArray()[0], path + "[0]", kind, -1.0),
                                       reader.number(value.asArray()[1], path + "[1]", kind, 1.0)};
  if (!(range[0] < range[1]) && value.asArray()[0].isNumber() && value.asArray()[1].isNumber()) {
    reader.problem(path, "the minimum must be below the maximum");
  }
  return range;
}

}  // namespace wcam::cell::detail
