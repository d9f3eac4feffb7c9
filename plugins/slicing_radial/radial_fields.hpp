// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/quantity.hpp"
#include "wcam/toolpath/slice_field.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace wcam::radial {

using geometry::Vec3;

enum class Shape {
  Cylinder,  ///< distance from the axis
  Cone,      ///< distance from a cone about the axis
  Sphere,    ///< distance from the origin
  Angle      ///< half-planes through the axis
};

/// The axis with two directions across it.
struct Axis {
  Vec3 origin = Vec3::Zero();
  Vec3 z = Vec3::UnitZ();
  Vec3 x = Vec3::UnitX();
  Vec3 y = Vec3::UnitY();

  [[nodiscard]] Vec3 radial(const Vec3& p) const {
    const Vec3 d = p - origin;
    return d - d.dot(z) * z;
  }

  /// Unit vector away from the axis; x on the axis itself.
  [[nodiscard]] Vec3 outward(const Vec3& p) const {
    const Vec3 r = radial(p);
    return r.norm() > 0.0 ? Vec3(r.normalized()) : x;
  }

  [[nodiscard]] double angle(const Vec3& p) const {
    const Vec3 r = radial(p);
    const double a = std::atan2(r.dot(y), r.dot(x));
    return a < 0.0 ? a + 2.0 * kPi : a;
  }
};

/// Heights above surfaces of revolution: φ = h·(cos α along the axis, sin α away from it), or the
/// distance from the origin.
class RevolvedField : public toolpath::LayerField {
public:
  RevolvedField(const Axis& axis, Shape shape, double coneAngle)
      : axis_(axis), shape_(shape), cosine_(std::cos(coneAngle)), sine_(std::sin(coneAngle)) {}

  void setLevels(const std::vector<toolpath::LayerLevel>& levels) { levels_ = &levels; }

  /// Values at the vertices of each part, empty for those of scalar().
  void setValues(std::vector<std::vector<double>> values) { values_ = std::move(values); }

  [[nodiscard]] std::vector<double> vertexValues(std::size_t part) const override {
    return values_.empty() ? std::vector<double>{} : values_[part];
  }

  [[nodiscard]] double scalar(const Vec3& p) const override {
    switch (shape_) {
      case Shape::Sphere:
        return (p - axis_.origin).norm();
      case Shape::Cone:
        return cosine_ * (p - axis_.origin).dot(axis_.z) + sine_ * axis_.radial(p).norm();
      default:
        return axis_.radial(p).norm();
    }
  }

  [[nodiscard]] double residual(const Vec3& p, std::size_t level) const override {
    return scalar(p) - (*levels_)[level].value;
  }

  [[nodiscard]] Vec3 gradient(const Vec3& p, std::size_t) const override {
    switch (shape_) {
      case Shape::Sphere: {
        const Vec3 d = p - axis_.origin;
        return d.norm() > 0.0 ? Vec3(d.normalized()) : axis_.z;
      }
      case Shape::Cone:
        return cosine_ * axis_.z + sine_ * axis_.outward(p);
      default:
        return axis_.outward(p);
    }
  }

private:
  Axis axis_;
  Shape shape_;
  double cosine_;
  double sine_;
  std::vector<std::vector<double>> values_;
  const std::vector<toolpath::LayerLevel>* levels_ = nullptr;
};

/// Angle about the axis from a start; torn where it jumps by a whole turn.
class AngleField : public toolpath::LayerField {
public:
  AngleField(const Axis& axis, double start, double least)
      : axis_(axis), start_(start), least_(least) {}

  void setLevels(const std::vector<toolpath::LayerLevel>& levels) { levels_ = &levels; }

  [[nodiscard]] double scalar(const Vec3& p) const override {
    const double a = axis_.angle(p) - start_;
    return a - 2.0 * kPi * std::floor(a / (2.0 * kPi));
  }

  /// Distance from the half-plane, so that the residual is a length.
  [[nodiscard]] double residual(const Vec3& p, std::size_t level) const override {
    return axis_.radial(p).dot(acrossOf(level));
  }

  [[nodiscard]] Vec3 gradient(const Vec3&, std::size_t level) const override {
    return acrossOf(level);
  }

  [[nodiscard]] double largestJump(double edgeLength) const override {
    // An edge at the part's least radius spans this angle at most, a tear nearly a whole turn.
    return std::min(
        kPi, least_ > 0.0 ? 2.0 * std::asin(std::min(1.0, 0.5 * edgeLength / least_)) + 0.1 : kPi);
  }

  [[nodiscard]] Vec3 acrossOf(std::size_t level) const {
    const double a = (*levels_)[level].value + start_;
    return std::cos(a) * axis_.y - std::sin(a) * axis_.x;
  }

private:
  Axis axis_;
  double start_;
  double least_;
  const std::vector<toolpath::LayerLevel>* levels_ = nullptr;
};

}  // namespace wcam::radial
