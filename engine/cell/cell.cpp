// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/cell.hpp"

#include "wcam/base/error.hpp"

#include "inverse_detail.hpp"

namespace wcam::cell {

const Joint& Cell::joint(int index) const {
  WCAM_ASSERT(index >= 0 && index < jointCount());
  return index < robotJoints() ? robot.joints[static_cast<std::size_t>(index)]
                               : positioner.joints[static_cast<std::size_t>(index - robotJoints())];
}

JointVector Cell::fromConvention(const std::string& wanted, const JointVector& shown) const {
  std::string names;
  for (const ZeroConvention& convention : zeroConventions) {
    if (convention.name == wanted) {
      JointVector q = shown;
      q.head(convention.offsets.size()) -= convention.offsets;
      return q;
    }
    names += (names.empty() ? "" : ", ") + convention.name;
  }
  throw Error(ErrorCode::InvalidArgument, text("there is no zero convention '%1'", {wanted}),
              text("cell %1", {name}),
              names.empty() ? text("the cell file declares none")
                            : text("the cell file declares: %1", {names}));
}

Vec3 Cell::verticalInBase() const {
  return T_world_base.linear().row(2).transpose();
}

double JointSum::value(const JointVector& q) const {
  double sum = 0.0;
  for (std::size_t j = 0; j < factors.size(); ++j) {
    sum += factors[j] * q(static_cast<Eigen::Index>(j));
  }
  return sum;
}

void prepareArm(Cell& cell) {
  cell.arm.reset();
  cell.armProblem = {};
  try {
    cell.arm = reduceArm(cell.robot);
  } catch (const Error& error) {
    cell.armProblem = text("%1; %2", {error.messageText(), error.hintText()});
  }
  cell.inverse = detail::makeInverse(cell);
}

}  // namespace wcam::cell
