// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace wcam::collision {

/// Rotation of a nozzle about the travel direction through the TCP that frees one point (Diourté
/// M34, general 3D version; Eq. 4.8 for standOff = 0): the nozzle is a cylinder of radius `radius`
/// about the tool axis that begins `standOff` above the TCP; the point is (x along the travel, y
/// across, z along the tool axis), mm. 0 for a point outside of the nozzle. The nozzle turns away
/// from the point: towards −y for y > 0. rad, never negative.
/// Out through the flat end or the side, whichever comes first.
double exitAngle(double x, double y, double z, double radius, double standOff);

/// The same out through the flat end only, as a wall that begins at the TCP must leave: for
/// standOff = 0 Eq. 4.8, atan(z / |y|).
double exitAngleThroughEnd(double y, double z, double standOff);

}  // namespace wcam::collision
