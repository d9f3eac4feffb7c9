// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/cell/cell.hpp"

namespace wcam::cell {

/// True when a full turn of the joint changes no pose, so that the turn is free to choose. (A
/// joint that drives another one by a non-integer coupling is not, nor is a prismatic one.)
bool periodicJoint(const Cell& cell, int joint);

/// value + k·period nearest to `reference`; the lower one of two that are as near up to rounding.
double nearestPeriod(double value, double reference, double period);
/// value + 2πk nearest to `reference`, likewise.
double nearestTurn(double value, double reference);

/// value + 2πk inside the joint's limits and nearest to `reference`; when no turn is inside, the
/// one that exceeds least.
double turnInLimits(const Joint& joint, double value, double reference);

/// How far a value lies outside its limits, rad; 0 inside.
double limitExcess(const Joint& joint, double value);
/// Distance to the nearest limit, rad; negative outside, infinite for an endless joint.
double limitMargin(const Joint& joint, double value);

/// Turns of all periodic joints chosen inside the limits and nearest to `previous`.
JointVector unwrapJoints(const Cell& cell, const JointVector& q, const JointVector& previous);

/// The value of each joint that is nearest to zero inside its limits.
JointVector neutralJoints(const Cell& cell);

}  // namespace wcam::cell
