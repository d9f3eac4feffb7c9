// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/text.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace wcam::toolpath {

/// How a continuous spiral begins on the flat border. Heights below h_min cannot be deposited, so a
/// seamless start is impossible: ramps make up for the gap of one layer (Diourté M20).
enum class SpiralStart {
  Exact,  ///< ramps h_min → h_max until the gap is one layer: seam step 0 from there on (variant A)
  Thesis,  ///< four ramps and a fifth that ends at h, as the thesis plots it (variant B)
  Ramp,    ///< the first revolution climbs from 0: heights under h_min, no step at all
  None     ///< every revolution starts one layer above the last: a step of one layer at each seam
};

/// How it ends at the upper border.
enum class SpiralEnd {
  Mirrored,  ///< ramps as at the start, so that the seam step stays 0 up to them
  Literal,   ///< equal steps up to the border: the seam step drifts (Diourté M22)
  Point      ///< closed part: runs out near the closure point
};

/// What the spiral is asked for. Lengths in mm.
struct SpiralWish {
  double height = 2.0;     ///< mean deposit
  double heightMin = 1.8;  ///< modulation range
  double heightMax = 2.2;
  SpiralStart start = SpiralStart::Exact;
  SpiralEnd end = SpiralEnd::Mirrored;
  bool centred = true;  ///< revolutions that bring the mean to `height`; else floor(min L / h_min)
  double endReserve = 0.0;    ///< SpiralEnd::Point: length left free before the closure point
  double secondHeight = 0.0;  ///< mean deposit of the second zone; 0: one zone (Diourté M48)
  double secondFrom = 0.0;    ///< where it begins, mm along the mean generatrix
  int transition = 1;         ///< revolutions from one deposit to the other
};

/// One revolution: arc length on every generatrix where the bead passes, and the height it adds.
struct SpiralTurn {
  std::vector<double> position;  ///< per generatrix, mm from the lower border
  std::vector<double> step;      ///< per generatrix, mm along it to what lies below
  double lowest = 0.0;   ///< modulation range that this revolution promises, mm: that of its zone;
  double highest = 0.0;  ///< 0 for ramps, which leave it on purpose
};

/// The generatrix that breaks the modulation range most.
struct SpiralExcess {
  std::size_t generatrix = 0;
  double height = 0.0;  ///< deposit that it would need, mm
};

struct SpiralPlan {
  std::vector<SpiralTurn> turns;
  std::size_t startTurns = 0;  ///< of these, the initiation
  std::size_t endTurns = 0;    ///< of these, the termination
  double regularMin = 0.0;     ///< least and greatest deposit of the regular revolutions, mm
  double regularMax = 0.0;
  double regularMean = 0.0;
  double largestSeamStep = 0.0;  ///< greatest |step| of the path at the seam in regular revolutions
  std::optional<SpiralExcess> excess;  ///< set when the range cannot be kept
};

/// Cumulated heights of the initiation: row j, fraction f in [0, 1] of a revolution.
struct Initiation {
  std::vector<double> begin;  ///< deposit at the start of each ramp, mm
  std::vector<double> end;    ///< deposit at its end
  /// Height reached after all ramps at fraction f.
  [[nodiscard]] double total(double f) const;
  /// Height reached after ramp j (from 0) at fraction f.
  [[nodiscard]] double after(std::size_t j, double f) const;
};

/// Ramps after which the end of a revolution lies `gap` above its start (Diourté M20; `gap` is the
/// pitch of the next revolution for an exactly continuous path). J = ceil(gap / (h_max − h_min)).
/// @throws Error(InvalidArgument) when the range is empty, negative, or one value only
Initiation initiation(double heightMin, double heightMax, double gap, SpiralStart start);

/// Numbers of revolutions with which every generatrix keeps the range: ceil(max / h_max) …
/// floor(min / h_min); none when first > last (Diourté A12).
struct TurnRange {
  long first = 0;
  long last = -1;

  [[nodiscard]] bool feasible() const noexcept { return first <= last; }
};

TurnRange turnRange(double shortest, double longest, double heightMin, double heightMax);

/// Places the revolutions on generatrices of these lengths (in the order of travel, the first at
/// the seam; generatrix i lies at fraction i/N of the revolution). Diourté M20–M22, M48 with the
/// corrected laws: the seam step of regular revolutions is zero because the pitch on the seam
/// generatrix equals the gap that the initiation leaves.
/// @throws Error(InvalidArgument) for an empty or reversed range, Error(JobFailed) when a
/// generatrix is shorter than the initiation needs: says which and how long it must be
SpiralPlan planSpiral(const std::vector<double>& lengths, const SpiralWish& wish);

/// A modulation range with ends as they are shown and typed: hundredths of a millimetre.
struct SpiralRange {
  double low = 0.0;   ///< mm
  double high = 0.0;  ///< mm
  friend bool operator==(const SpiralRange&, const SpiralRange&) = default;
};

/// A range whose ends are rounded outwards, so that what is shown holds what was meant.
SpiralRange roundedOutwards(double low, double high);

/// Remedy for a plan with an excess: the narrowest range about the mean deposit, in steps of about
/// a percent, with which planSpiral keeps these lengths. Tried, with its ends as they are shown.
/// Nothing when there is none.
std::optional<SpiralRange> rangeThatWouldDo(const std::vector<double>& lengths,
                                            const SpiralWish& wish);

/// "1.58 to 2.42 mm".
Text rangeText(const SpiralRange& range);

}  // namespace wcam::toolpath
