// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/model.hpp"

#include "wcam/base/quantity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace wcam::project {

namespace {

template <class T>
const T* byId(const std::vector<T>& nodes, std::string_view id) noexcept {
  const auto found =
      std::find_if(nodes.begin(), nodes.end(), [id](const T& node) { return node.id == id; });
  return found == nodes.end() ? nullptr : &*found;
}

constexpr std::array<std::pair<const char*, std::optional<geometry::WallSide>>, 4> kWallSides = {{
    {"whole", std::nullopt},
    {"outer", geometry::WallSide::Outer},
    {"inner", geometry::WallSide::Inner},
    {"middle", geometry::WallSide::Middle},
}};

}  // namespace

std::optional<geometry::WallSide> wallSideOf(const std::string& word) {
  for (const auto& [name, side] : kWallSides) {
    if (word == name) {
      return side;
    }
  }
  return std::nullopt;
}

const std::vector<std::string>& wallSideWords() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> names;
    for (const auto& [name, side] : kWallSides) {
      names.emplace_back(name);
    }
    return names;
  }();
  return words;
}

const Part* Project::part(std::string_view id) const noexcept {
  return byId(parts, id);
}

const Substrate* Project::substrate(std::string_view id) const noexcept {
  return byId(substrates, id);
}

const Guide* Project::guide(std::string_view id) const noexcept {
  return byId(guides, id);
}

const Process* Project::process(std::string_view id) const noexcept {
  return byId(processes, id);
}

const Operation* Project::operation(std::string_view id) const noexcept {
  return byId(operations, id);
}

const Output* Project::output(std::string_view id) const noexcept {
  return byId(outputs, id);
}

namespace {

/// Sine and cosine of degrees, exact at the quarter turns: a part turned by 90° stays on its axes.
std::pair<double, double> sinCosDeg(double degrees) {
  const double turn = std::remainder(degrees, 360.0);
  const double quarter = std::nearbyint(turn / 90.0);
  const double rest = degToRad(turn - 90.0 * quarter);
  const double s = std::sin(rest);
  const double c = std::cos(rest);
  switch (static_cast<int>(quarter)) {
    case 1:
      return {c, -s};
    case -1:
      return {-c, s};
    case 2:
    case -2:
      return {-s, -c};
    default:
      return {s, c};
  }
}

}  // namespace

geometry::Pose toPose(const Placement& placement) {
  const auto [sx, cx] = sinCosDeg(placement.rotationDeg[0]);
  const auto [sy, cy] = sinCosDeg(placement.rotationDeg[1]);
  const auto [sz, cz] = sinCosDeg(placement.rotationDeg[2]);
  Eigen::Matrix3d rx;
  rx << 1, 0, 0, 0, cx, -sx, 0, sx, cx;
  Eigen::Matrix3d ry;
  ry << cy, 0, sy, 0, 1, 0, -sy, 0, cy;
  Eigen::Matrix3d rz;
  rz << cz, -sz, 0, sz, cz, 0, 0, 0, 1;
  geometry::Pose pose = geometry::Pose::Identity();
  pose.linear() = rx * ry * rz;
  pose.translation() = geometry::Vec3(placement.positionMm.data());
  return pose;
}

Placement toPlacement(const geometry::Pose& pose) {
  // R = Rx·Ry·Rz: R02 = sin y, R12 = −sin x cos y, R22 = cos x cos y, R01 = −cos y sin z,
  // R00 = cos y cos z.
  const Eigen::Matrix3d r = pose.linear();
  const double cosY = std::hypot(r(0, 0), r(0, 1));
  // Below it the first and the third angle turn about the same axis within double precision.
  constexpr double kLocked = 1e-12;
  double x = 0.0;
  double z = 0.0;
  if (cosY > kLocked) {
    x = std::atan2(-r(1, 2), r(2, 2));
    z = std::atan2(-r(0, 1), r(0, 0));
  } else {
    x = std::atan2(r(2, 1), r(1, 1));
  }
  Placement placement;
  placement.positionMm = {pose.translation().x(), pose.translation().y(), pose.translation().z()};
  placement.rotationDeg = {radToDeg(x), radToDeg(std::atan2(r(0, 2), cosY)), radToDeg(z)};
  return placement;
}

}  // namespace wcam::project
