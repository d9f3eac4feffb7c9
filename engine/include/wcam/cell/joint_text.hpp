// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/cell/chain.hpp"

#include <string>

/// Values of joints as files and people get them: degrees of revolute joints, mm of prismatic ones.
namespace wcam::cell {

/// "deg" or "mm".
const char* jointUnit(const Joint& joint);
/// rad or mm to deg or mm; also of speeds and steps.
double toJointUnit(const Joint& joint, double value);
/// deg or mm to rad or mm.
double fromJointUnit(const Joint& joint, double value);
/// "12.345 deg", "12.345 mm".
std::string jointText(const Joint& joint, double value, int decimals = 3);

}  // namespace wcam::cell
