// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plan_detail.hpp"

#include <array>
#include <optional>
#include <vector>

namespace wcam::motion::detail {

/// Sample of the turn of a table, besides the exact solutions. Samples only choose between ways.
inline constexpr double kTurnSample = 2.0 * kPi / 144;

/// Turns of the table, [low, high], rad from zero.
struct TableArc {
  double low = 0.0;
  double high = 0.0;
};

/// A turn of the table in its arc, with the tilt that is best for it.
struct TableNode {
  double turn = 0.0;
  TableArc arc;
  double tilt = 0.0;
};

/// The best tilt for a turn: the angle of the vector with these components, both a constant and
/// the factors of the turn's cosine and sine.
struct TiltLaw {
  Vec3 across, along;

  [[nodiscard]] double at(double turn) const;
};

/// Where the table of a positioner with two uncoupled rotary axes may stand at a target
/// (table_reference.hpp). Angles are physical ones from zero, not controller values.
class TableArcs {
public:
  TableArcs(const Cell& cell, const MotionParams& params);

  /// True where the axes are so nearly parallel that there are no arcs.
  [[nodiscard]] bool parallel() const;

  /// Both exact solutions.
  [[nodiscard]] std::array<double, 2> exact(const Vec3& up) const;

  [[nodiscard]] TiltLaw tiltLaw(const Vec3& up) const;

  /// Nodes of a target that uses a part of what it may lean above the least.
  void nodes(const Vec3& up, double freedom, std::vector<TableNode>& nodes) const;

  /// True where the table may stand at any turn.
  [[nodiscard]] bool anyTurn(const Vec3& up, double freedom) const;

  /// All turns that the table can reach from a turn.
  [[nodiscard]] TableArc everything(double turn) const;

private:
  /// The component of `up` along the first axis is offset + radius·cos(ψ − zero).
  struct Swing {
    double offset, radius, zero;
  };

  /// Distances of a turn from the swing's zero at which it leans little enough.
  struct Reach {
    Swing swing;
    double inner, outer;

    [[nodiscard]] bool all() const { return inner == 0.0 && outer == kPi; }
  };

  [[nodiscard]] Swing swing(const Vec3& up) const;
  [[nodiscard]] Reach reach(const Vec3& up, double freedom) const;
  void addNodes(const Vec3& up, double freedom, std::vector<TableNode>& nodes) const;
  void addLifted(const TableArc& arc,
                 const std::vector<double>& centres,
                 std::vector<TableNode>& nodes) const;

  const MotionParams& params_;
  Eigen::Matrix3d R_base_part_;
  Vec3 vertical_, k1_, k2_;
  double cosine_ = 0.0;
  double level_ = 0.0;  ///< of the vertical above the plane square to the first axis
  std::optional<TableArc> limits_;
};

}  // namespace wcam::motion::detail
