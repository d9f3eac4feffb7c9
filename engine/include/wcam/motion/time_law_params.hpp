// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/quantity.hpp"

namespace wcam::motion {

/// Parameters of the prediction of time and speed; part of MotionParams.
struct TimeLawParams {
  Length cornerRadius{1.0};  ///< greatest distance from a corner at which it is rounded
  double tcpAcceleration =
      0.0;  ///< greatest acceleration of the TCP in the part frame, mm/s²; 0: none
  /// Time in which a joint without an acceleration in the cell file reaches its greatest speed;
  /// 0: at once.
  double accelerationTime = 0.0;
  double speedTolerance = 0.05;  ///< part of the wanted speed by which the predicted may differ
  /// Part of the wanted speed below which a burning torch makes an operation unfit.
  double minSpeedRatio = 0.5;
  bool wireFollowsSpeed = false;  ///< the wire feed follows the predicted speed
  double leastWireRatio = 0.5;    ///< down to this part of the wanted feed
  Length reversalEffect{0.1};     ///< of a joint's backlash on the TCP, above which it is told
};

}  // namespace wcam::motion
