// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The batch form of arm.cpp: the same formulas over blocks of poses, structure of arrays. Loops
// have fixed bounds and no branches so that the compiler makes vector code; no sine or cosine is
// computed, only arc tangents, all others follow from the sides of the triangles. Arithmetic is
// strict, so that all clones give the same bits.
//
// Compiled with options of its own: this file must include nothing with inline functions that other
// files use too (Eigen), since the linker keeps one copy of those for all.

#include "arm_kernel.hpp"

#include "wcam/base/vector_clones.hpp"

#include <cmath>
#include <cstddef>

namespace wcam::cell {

namespace {

constexpr int kN = ArmConstants::kLanes;
constexpr double kFullTurn = 6.28318530717958647692;
constexpr double kHalfTurn = 3.14159265358979323846;
/// Slack on squared reach quantities, relative: the search keeps poses at the border.
constexpr double kRelativeSlack = 1e-12;
/// Keeps a division by a squared distance finite.
constexpr double kTiny = 1e-300;
/// Squared sine below which axes 4 and 6 count as in line: axis 4 is then 0.
constexpr double kSingular2 = 1e-20;

/// atan2 without branches, within 2 units in the last place: the C library's cannot be vectorised
/// with the same bits for every width. Quotients up to kBend by the rational approximation of
/// Cephes (Moshier, atan), those up to 1 turned back by 45°, all others by the complement.
static WCAM_CLONED double arcTangent(double y, double x) {
  constexpr double kBend = 0.66;
  constexpr double kEighthTurn = kHalfTurn / 4.0;
  const double ax = std::fabs(x);
  const double ay = std::fabs(y);
  const double high = ax > ay ? ax : ay;
  const double low = ax > ay ? ay : ax;
  const bool bent = low > kBend * high;
  const double t = (bent ? low - high : low) / ((bent ? low + high : high) + kTiny);
  const double z = t * t;
  const double p = ((((-8.750608600031904122785e-1 * z - 1.615753718733365076637e1) * z -
                      7.500855792314704667340e1) *
                         z -
                     1.228866684490136173410e2) *
                        z -
                    6.485021904942025371773e1);
  const double q = (((((z + 2.485846490142306297962e1) * z + 1.650270098316988542046e2) * z +
                      4.328810604912902668951e2) *
                         z +
                     4.853903996359136964868e2) *
                        z +
                    1.945506571482613964425e2);
  const double small = t * (z * p / q) + t;
  const double sector = bent ? small + kEighthTurn : small;
  const double quadrant = ay > ax ? 2.0 * kEighthTurn - sector : sector;
  const double half = x < 0.0 ? kHalfTurn - quadrant : quadrant;
  return std::copysign(half, y);
}

/// Wrist rotation (row major) and centre in the canonical base.
struct Lanes {
  alignas(64) double r[9][kN];
  alignas(64) double p[3][kN];
};

/// Canonical angles of one branch.
struct Angles6 {
  alignas(64) double c[6][kN];
};

/// One shoulder: axis 1 and the wrist centre in its plane; row 1 of the wrist's rotation.
struct Shoulder {
  alignas(64) double sine[kN], cosine[kN], x[kN];
  alignas(64) double row1[3][kN];
};

static WCAM_CLONED void toWrist(const ArmConstants& k, const LanePoses& poses, Lanes& out) {
  for (int n = 0; n < kN; ++n) {
    double flange[12];
    for (int i = 0; i < 9; ++i) {
      flange[i] = poses.rotation[i][n];
    }
    // flange · wrist, then base · that
    double world[12];
    for (std::size_t i = 0; i < 3; ++i) {
      const double f0 = flange[3 * i];
      const double f1 = flange[3 * i + 1];
      const double f2 = flange[3 * i + 2];
      for (int j = 0; j < 3; ++j) {
        world[3 * i + j] = f0 * k.wrist[j] + f1 * k.wrist[3 + j] + f2 * k.wrist[6 + j];
      }
      world[9 + i] = f0 * k.wrist[9] + f1 * k.wrist[10] + f2 * k.wrist[11] + poses.position[i][n];
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const double* b = k.base + 3 * i;
      for (int j = 0; j < 3; ++j) {
        out.r[3 * i + j][n] = b[0] * world[j] + b[1] * world[3 + j] + b[2] * world[6 + j];
      }
      out.p[i][n] = b[0] * world[9] + b[1] * world[10] + b[2] * world[11] + k.base[9 + i];
    }
  }
}

/// Axis 1 by algebra: P = Rz(c1)·(x, b, z).
static WCAM_CLONED void solveShoulder(const ArmConstants& k,
                                      const Lanes& lanes,
                                      double side,
                                      Shoulder& out,
                                      Angles6& angles,
                                      double* reachable) {
  const double forearm2 = k.d4 * k.d4 + k.r4 * k.r4;
  const double forearm = std::sqrt(forearm2);
  const double outer = (k.a2 + forearm) * (k.a2 + forearm) * (1.0 + kRelativeSlack);
  const double inner = (k.a2 - forearm) * (k.a2 - forearm) * (1.0 - kRelativeSlack);
  for (int n = 0; n < kN; ++n) {
    const double px = lanes.p[0][n];
    const double py = lanes.p[1][n];
    const double pz = lanes.p[2][n];
    const double squared = px * px + py * py;
    const double inPlane = squared - k.b * k.b;
    const double abscissa = side * std::sqrt(inPlane > 0.0 ? inPlane : 0.0);
    const double inverse = 1.0 / (squared + kTiny);
    const double cosine = (px * abscissa + py * k.b) * inverse;
    const double sine = (py * abscissa - px * k.b) * inverse;
    const double x = abscissa - k.a1;
    const double distance2 = x * x + pz * pz;
    out.cosine[n] = cosine;
    out.sine[n] = sine;
    out.x[n] = x;
    reachable[n] = inPlane >= 0.0 && distance2 <= outer && distance2 >= inner ? 1.0 : 0.0;
    for (int j = 0; j < 3; ++j) {
      out.row1[j][n] = cosine * lanes.r[3 + j][n] - sine * lanes.r[j][n];
    }
  }
  for (int n = 0; n < kN; ++n) {
    angles.c[0][n] = arcTangent(out.sine[n], out.cosine[n]);
  }
}

/// Axes 2 and 3, then the wrist unflipped.
static WCAM_CLONED void solveElbowAndWrist(const ArmConstants& k,
                                           const Lanes& lanes,
                                           const Shoulder& shoulder,
                                           double epsilon,
                                           Angles6& angles) {
  const double forearm2 = k.d4 * k.d4 + k.r4 * k.r4;
  const double inverse3 = 1.0 / forearm2;
  alignas(64) double y2[kN], x2[kN], y3[kN], x3[kN], y4[kN], x4[kN], y5[kN], x5[kN], y6[kN], x6[kN];
  for (int n = 0; n < kN; ++n) {
    const double x = shoulder.x[n];
    const double z = lanes.p[2][n];
    const double distance2 = x * x + z * z;
    const double c = distance2 + k.a2 * k.a2 - forearm2;
    const double rest = 4.0 * k.a2 * k.a2 * distance2 - c * c;
    const double root = epsilon * std::sqrt(rest > 0.0 ? rest : 0.0);
    const double inverse2 = 1.0 / (2.0 * k.a2 * distance2 + kTiny);
    const double sin2 = (x * c + z * root) * inverse2;
    const double cos2 = (z * c - x * root) * inverse2;
    const double m = cos2 * x - sin2 * z;
    const double q = sin2 * x + cos2 * z - k.a2;
    const double sin3 = (k.r4 * m + k.d4 * q) * inverse3;
    const double cos3 = (k.r4 * q - k.d4 * m) * inverse3;
    const double sinT = sin2 * cos3 + cos2 * sin3;
    const double cosT = cos2 * cos3 - sin2 * sin3;
    y2[n] = sin2;
    x2[n] = cos2;
    y3[n] = sin3;
    x3[n] = cos3;
    // rows 0 and 2 of (Rz(c1)·Ry(c2 + c3))ᵀ·R
    double across[3];
    double along2 = 0.0;
    for (int j = 0; j < 3; ++j) {
      const double level =
          shoulder.cosine[n] * lanes.r[j][n] + shoulder.sine[n] * lanes.r[3 + j][n];
      across[j] = cosT * level - sinT * lanes.r[6 + j][n];
      along2 = sinT * level + cosT * lanes.r[6 + j][n];  // the last one, j = 2, is kept
    }
    const double u = across[2];
    const double v = shoulder.row1[2][n];
    const double h2 = u * u + v * v;
    const bool singular = h2 < kSingular2;
    const double us = singular ? 1.0 : u;
    const double vs = singular ? 0.0 : v;
    y4[n] = vs;
    x4[n] = us;
    y5[n] = std::sqrt(h2);
    x5[n] = along2;
    y6[n] = us * shoulder.row1[0][n] - vs * across[0];
    x6[n] = us * shoulder.row1[1][n] - vs * across[1];
  }
  for (int n = 0; n < kN; ++n) {
    angles.c[1][n] = arcTangent(y2[n], x2[n]);
  }
  for (int n = 0; n < kN; ++n) {
    angles.c[2][n] = arcTangent(y3[n], x3[n]);
  }
  for (int n = 0; n < kN; ++n) {
    angles.c[3][n] = arcTangent(y4[n], x4[n]);
  }
  for (int n = 0; n < kN; ++n) {
    angles.c[4][n] = arcTangent(y5[n], x5[n]);
  }
  for (int n = 0; n < kN; ++n) {
    angles.c[5][n] = arcTangent(y6[n], x6[n]);
  }
}

/// Controller values of the branch and of its flipped twin (c4 + π, −c5, c6 + π).
static WCAM_CLONED void toValues(const ArmConstants& k,
                                 const Angles6& angles,
                                 double (*plain)[kN],
                                 double (*flipped)[kN]) {
  for (int n = 0; n < kN; ++n) {
    int g = 0;
    for (int i = 0; i < 6; ++i) {
      double sum = k.zero[i];
      double twin = k.zero[i];
      for (int j = 0; j <= i; ++j) {
        const double c = angles.c[j][n];
        const double t = j == 4 ? -c : (j == 3 || j == 5 ? c + kHalfTurn : c);
        sum += k.gain[g] * c;
        twin += k.gain[g] * t;
        ++g;
      }
      plain[i][n] = sum - k.turn[i] * std::rint(sum * (1.0 / kFullTurn));
      flipped[i][n] = twin - k.turn[i] * std::rint(twin * (1.0 / kFullTurn));
    }
  }
}

}  // namespace

WCAM_VECTOR_CLONES void solveLanes(const ArmConstants& k,
                                   const LanePoses& poses,
                                   const LaneResults& result) {
  // Every lane is written before it is read: a first value would only cost time.
  // NOLINTBEGIN(cppcoreguidelines-pro-type-member-init)
  Lanes lanes;
  Shoulder shoulder;
  Angles6 angles;
  // NOLINTEND(cppcoreguidelines-pro-type-member-init)
  toWrist(k, poses, lanes);
  for (int back = 0; back < 2; ++back) {
    solveShoulder(k, lanes, back == 0 ? 1.0 : -1.0, shoulder, angles, result.reachable[back]);
    for (int down = 0; down < 2; ++down) {
      solveElbowAndWrist(k, lanes, shoulder, down == 0 ? -1.0 : 1.0, angles);
      const int branch = 2 * down + back;
      toValues(k, angles, result.joints[branch], result.joints[branch + 4]);
    }
  }
}

}  // namespace wcam::cell
