// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/joint_text.hpp"

#include "wcam/base/quantity.hpp"
#include "wcam/base/text.hpp"

namespace wcam::cell {

const char* jointUnit(const Joint& joint) {
  return joint.prismatic() ? "mm" : "deg";
}

double toJointUnit(const Joint& joint, double value) {
  return joint.prismatic() ? value : radToDeg(value);
}

double fromJointUnit(const Joint& joint, double value) {
  return joint.prismatic() ? value : degToRad(value);
}

std::string jointText(const Joint& joint, double value, int decimals) {
  return formatFixed(toJointUnit(joint, value), decimals) + " " + jointUnit(joint);
}

}  // namespace wcam::cell
