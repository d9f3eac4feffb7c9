// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

/// Angle conventions of the brands as pure functions between three angles (rad) and a rotation
/// matrix. Every "to" function is exact also at its gimbal lock: the matrix of the returned angles
/// is the given one, the first angle that cannot be told apart being 0. Results lie in (−π, π].
namespace wcam::cell {

using Rotation = Eigen::Matrix3d;
using Angles = Eigen::Vector3d;

Rotation rotationX(double angle);
Rotation rotationY(double angle);
Rotation rotationZ(double angle);

/// Bryant angles (R_X, R_Y, R_Z): Rx·Ry·Rz (Chalvin Eq. 3.3).
Rotation fromBryant(const Angles& bryant);
/// Chalvin A19 (Eq. B.4, corrected).
Angles toBryant(const Rotation& rotation);

/// FANUC (W, P, R): Rz(R)·Ry(P)·Rx(W).
Rotation fromFanucWpr(const Angles& wpr);
/// Chalvin A19 (Eq. B.5, corrected).
Angles toFanucWpr(const Rotation& rotation);

/// KUKA (A, B, C): Rz(A)·Ry(B)·Rx(C).
Rotation fromKukaAbc(const Angles& abc);
Angles toKukaAbc(const Rotation& rotation);

/// The rotation A with a free third Bryant angle whose third row is `axis` (unit): it turns `axis`
/// onto +Z (part carried, Chalvin A18a, Eq. 3.4–3.7).
Rotation axisToVertical(const Eigen::Vector3d& axis, double rotationAboutAxis);
/// The rotation A with a free third Bryant angle whose third column is `axis` (unit): a tool frame
/// with its z along `axis` (torch carried, Chalvin A18b, Eq. 3.11–3.13 corrected).
Rotation frameWithZ(const Eigen::Vector3d& axis, double rotationAboutAxis);

/// angle + 2πk in (−π, π].
double wrapAngle(double angle);

}  // namespace wcam::cell
