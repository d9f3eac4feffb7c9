// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/base/value.hpp"
#include "wcam/cell/cell.hpp"

#include <string>
#include <string_view>
#include <vector>

/// The TCP speed in the part frame from recorded motor speeds (TCP-velocity article, M43 and M44).
namespace wcam::motion {

using cell::JointVector;
using geometry::Vec3;

/// Motor speeds over time, as a controller records them.
struct MotorTrace {
  std::vector<double> time;      ///< s, growing
  std::vector<JointVector> rpm;  ///< of all joints of the cell, in its order
};

/// Reads a table with a header line: `time_s` and `<joint>_rpm` for every joint of the cell in any
/// order; comma, semicolon or tab between columns; columns whose names begin with x- are skipped.
/// Findings: trace.uneven_time (warning) where a step is over 1.5 times the median one.
/// @throws Error(InputInvalid) naming line and column: missing, unknown or double columns, rows
/// of another width, no or bad numbers, time that does not grow, fewer than 2 rows
MotorTrace parseMotorTrace(std::string_view text,
                           const cell::Cell& cell,
                           const std::string& contextName,
                           const JobContext& context);

/// Where the torch was.
struct TcpTrace {
  std::vector<double> time;
  std::vector<JointVector> joints;
  std::vector<Vec3> position;  ///< of the TCP in the part frame, mm
  std::vector<Vec3> velocity;  ///< mm/s
  std::vector<double> speed;   ///< mm/s
};

/// Joint speeds by the reduction ratios, integrated by trapezoids from the initial values; position
/// by forward kinematics, velocity by the Jacobian. Linear.
/// @throws Error(InvalidArgument) when a ratio is unknown, naming all joints without one, or the
/// initial values do not fit the cell
TcpTrace reconstructTcp(const MotorTrace& trace,
                        const cell::Cell& cell,
                        const JointVector& initial,
                        const JobContext& context = JobContext());

/// A stretch in which the speed lies outside the tolerance around the wanted one.
struct SpeedEvent {
  bool peak = false;      ///< else a dip
  std::size_t index = 0;  ///< where it is worst
  double ratio = 1.0;     ///< there
  std::size_t first = 0;  ///< of the stretch
  std::size_t last = 0;
  bool atStart = false;  ///< the stretch begins with the series
  bool atEnd = false;    ///< the stretch ends with it
};

/// Dips and peaks of a series of ratios to the wanted value, in order.
std::vector<SpeedEvent> speedEvents(const std::vector<double>& ratio, double tolerance);

/// Figures of a trace.
struct TraceSummary {
  double duration = 0.0;
  double length = 0.0;  ///< of the way, mm
  double minSpeed = 0.0;
  double meanSpeed = 0.0;  ///< way over time
  double maxSpeed = 0.0;
  double minTime = 0.0;  ///< s, where the least and greatest speeds are
  double maxTime = 0.0;
  double wanted = 0.0;  ///< what the events compare with: given, or the median of the speeds
  std::vector<SpeedEvent> events;
};

/// @param wanted mm/s; 0: the median of the speeds
TraceSummary summarise(const TcpTrace& trace, double wanted, double tolerance);

/// time_s, the joints (j1_deg or j1_mm …), x_mm … z_mm, vx_mm_s … vz_mm_s, speed_mm_s.
std::string traceTable(const TcpTrace& trace, const cell::Cell& cell);
Value summaryValue(const TraceSummary& summary, const TcpTrace& trace);

}  // namespace wcam::motion
