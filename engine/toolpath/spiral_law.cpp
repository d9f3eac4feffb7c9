// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/spiral_law.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::toolpath {

namespace {

/// Rounding of a quotient of lengths that is meant to be an integer.
constexpr double kWhole = 1e-9;
/// A height may pass its limit by this part before it counts as outside: rounding of the sums.
constexpr double kHeightRounding = 1e-9;

[[noreturn]] void refuse(ErrorCode code, const Text& message, const Text& hint) {
  throw Error(code, message, "continuous spiral", hint);
}

void checkRange(double heightMin, double heightMax) {
  if (!(heightMin > 0.0) || !std::isfinite(heightMax)) {
    refuse(ErrorCode::InvalidArgument, "the modulation range must lie above zero",
           "give h_min and h_max as positive heights");
  }
  if (heightMin > heightMax) {
    refuse(ErrorCode::InvalidArgument,
           text("h_min (%1 mm) is above h_max (%2 mm)",
                {formatFixed(heightMin, 3), formatFixed(heightMax, 3)}),
           "exchange them");
  }
  if (!(heightMax - heightMin > kWhole * heightMax)) {
    refuse(ErrorCode::InvalidArgument, "the modulation range is a single height",
           "a spiral needs a range, such as ±10 % of the mean deposit");
  }
}

/// Ramps with a fixed number: all but the last run over the whole range, the last one makes up for
/// what is left of the gap.
Initiation fullRamps(double heightMin, double heightMax, double gap, std::size_t count) {
  Initiation result;
  result.begin.assign(count, heightMin);
  result.end.assign(count, heightMax);
  const double before = static_cast<double>(count - 1) * (heightMax - heightMin);
  result.begin.back() = std::max(heightMin, before);
  result.end.back() = result.begin.back() + gap - before;
  return result;
}

/// Ramps of equal slope.
Initiation equalRamps(double heightMin, double gap, std::size_t count) {
  Initiation result;
  result.begin.assign(count, heightMin);
  result.end.assign(count, heightMin + gap / static_cast<double>(count));
  return result;
}

bool keeps(const Initiation& ramps, double heightMin, double heightMax) {
  const double slack = kHeightRounding * heightMax;
  for (std::size_t j = 0; j < ramps.begin.size(); ++j) {
    if (ramps.end[j] < ramps.begin[j] - slack || ramps.begin[j] < heightMin - slack ||
        ramps.end[j] > heightMax + slack) {
      return false;
    }
  }
  return true;
}

/// A zone's range, scaled from the first one.
struct Range {
  double low = 0.0;
  double high = 0.0;
};

/// Relative pitch of every seam passage, 1 in the first zone.
std::vector<double> relativePitch(std::size_t first,
                                  std::size_t transition,
                                  std::size_t second,
                                  double ratio) {
  std::vector<double> pitch(first + 1, 1.0);
  for (std::size_t k = 1; k <= transition; ++k) {
    pitch.push_back(1.0 + (ratio - 1.0) * static_cast<double>(k) / static_cast<double>(transition));
  }
  pitch.insert(pitch.end(), second, ratio);
  return pitch;
}

/// The regular revolutions for one choice of their number.
struct Regular {
  Initiation start;
  Initiation end;             ///< mirrored; empty for SpiralEnd::Point
  std::vector<double> pitch;  ///< at the seam before and after each revolution, mm
  std::vector<double> scale;  ///< per generatrix
  double scaleAtEnd = 1.0;    ///< where the revolution comes back to the seam generatrix
  double least = 0.0;
  double greatest = 0.0;
  double mean = 0.0;
  double violation = 0.0;  ///< worst relative excess over the range
  SpiralExcess worst;
};

double fractionOf(std::size_t i, std::size_t count) {
  return static_cast<double>(i) / static_cast<double>(count);
}

class Planner {
public:
  Planner(const std::vector<double>& lengths, const SpiralWish& wish)
      : lengths_(lengths), wish_(wish) {
    ratio_ = wish.secondHeight > 0.0 ? wish.secondHeight / wish.height : 1.0;
    for (const double length : lengths) {
      mean_ += length / static_cast<double>(lengths.size());
    }
  }

  [[nodiscard]] double ratio() const noexcept { return ratio_; }

  [[nodiscard]] double meanLength() const noexcept { return mean_; }

  /// Regular revolutions for a sequence of relative pitches; nothing when the lengths are used up.
  [[nodiscard]] std::optional<Regular> solve(const std::vector<double>& relative) const {
    const Range last{wish_.heightMin * relative.back(), wish_.heightMax * relative.back()};
    // A start is consistent when its ramps keep the range for the gap that follows from it.
    const auto most = static_cast<std::size_t>(
        std::ceil(2.0 * wish_.heightMax / (wish_.heightMax - wish_.heightMin)) + 2.0);
    for (const bool equal : {false, true}) {
      for (std::size_t count = 1; count <= most; ++count) {
        const auto start = [&](double gap, const Range& range) {
          if (wish_.start == SpiralStart::Ramp) {
            return equalRamps(0.0, gap, 1);
          }
          return equal ? equalRamps(range.low, gap, count)
                       : fullRamps(range.low, range.high, gap, count);
        };
        // What the start takes on the seam generatrix does not depend on the gap.
        const Range first{wish_.heightMin, wish_.heightMax};
        const double c0 = start(0.0, first).total(0.0);
        const double e0 =
            wish_.end == SpiralEnd::Point ? wish_.endReserve : start(0.0, last).total(0.0);
        double sum = relative.back();
        for (std::size_t k = 0; k + 1 < relative.size(); ++k) {
          sum += relative[k];
        }
        const double gap = (lengths_.front() - c0 - e0) / sum;
        if (!(gap > 0.0)) {
          break;
        }
        Regular regular;
        regular.start = start(gap, first);
        if (wish_.end != SpiralEnd::Point) {
          regular.end = start(gap * relative.back(), last);
        }
        if (wish_.start != SpiralStart::Ramp && (!keeps(regular.start, first.low, first.high) ||
                                                 !keeps(regular.end, last.low, last.high))) {
          continue;
        }
        for (const double g : relative) {
          regular.pitch.push_back(gap * g);
        }
        measure(regular, c0, e0);
        return regular;
      }
    }
    return std::nullopt;
  }

  /// Deposit of regular revolution k (from 0) at generatrix i.
  [[nodiscard]] double deposit(const Regular& regular, std::size_t k, std::size_t i) const {
    const double f = fractionOf(i, lengths_.size());
    return regular.scale[i] * (regular.pitch[k] + (regular.pitch[k + 1] - regular.pitch[k]) * f);
  }

private:
  void measure(Regular& regular, double c0, double e0) const {
    const std::size_t n = lengths_.size();
    const double first = regular.pitch.front();
    const double last = regular.pitch.back();
    double sum = 0.0;
    for (std::size_t k = 0; k + 1 < regular.pitch.size(); ++k) {
      sum += regular.pitch[k];
    }
    for (std::size_t i = 0; i < n; ++i) {
      const double f = fractionOf(i, n);
      regular.scale.push_back((lengths_[i] - c0 - e0 - first * f - last * (1.0 - f)) /
                              (sum + f * (last - first)));
    }
    regular.scaleAtEnd = (lengths_.front() - c0 - e0 - first) / (sum + last - first);
    regular.least = std::numeric_limits<double>::infinity();
    std::size_t count = 0;
    for (std::size_t k = 0; k + 1 < regular.pitch.size(); ++k) {
      const double relative = std::min(regular.pitch[k], regular.pitch[k + 1]) / first;
      const double relativeHigh = std::max(regular.pitch[k], regular.pitch[k + 1]) / first;
      for (std::size_t i = 0; i < n; ++i) {
        const double d = deposit(regular, k, i);
        regular.least = std::min(regular.least, d);
        regular.greatest = std::max(regular.greatest, d);
        // The mean is that of the first zone, in parts of each revolution's own deposit.
        regular.mean += d / (regular.pitch[k] / first);
        ++count;
        const double excess = std::max(wish_.heightMin * relative / d - 1.0,
                                       d / (wish_.heightMax * relativeHigh) - 1.0);
        if (!(d > 0.0) || excess > regular.violation) {
          regular.violation = d > 0.0 ? excess : std::numeric_limits<double>::infinity();
          regular.worst = {i, d};
        }
      }
    }
    regular.mean /= static_cast<double>(std::max<std::size_t>(count, 1));
  }

  const std::vector<double>& lengths_;
  const SpiralWish& wish_;
  double ratio_ = 1.0;
  double mean_ = 0.0;
};

/// Of the numbers of revolutions around the expected one the feasible one with the mean nearest to
/// the wish, else the one that breaks the range least.
std::optional<std::pair<Regular, std::vector<double>>> choose(const Planner& planner,
                                                              const SpiralWish& wish) {
  const bool zones = planner.ratio() != 1.0;
  const double begin = zones ? wish.secondFrom : planner.meanLength();
  const auto expected = static_cast<long>(std::lround(begin / wish.height));
  const long rest = zones ? std::lround((planner.meanLength() - begin) / wish.secondHeight) : 0;
  // Ramps at both ends and the spread of lengths move the number by no more than this.
  const long reach = 2 + std::lround(3.0 * wish.heightMax / (wish.heightMax - wish.heightMin)) +
                     (expected + rest) / 3;
  std::optional<std::pair<Regular, std::vector<double>>> best;
  const auto better = [&](const Regular& a, const Regular& b) {
    const bool fa = a.violation <= kHeightRounding;
    const bool fb = b.violation <= kHeightRounding;
    if (fa != fb) {
      return fa;
    }
    if (!fa) {
      return a.violation < b.violation;
    }
    return std::abs(a.mean - wish.height) < std::abs(b.mean - wish.height);
  };
  const long centre = zones ? rest : expected;
  for (long n = std::max(1L, centre - reach); n <= centre + reach; ++n) {
    std::vector<double> relative =
        zones ? relativePitch(static_cast<std::size_t>(std::max(1L, expected)),
                              static_cast<std::size_t>(std::max(1, wish.transition)),
                              static_cast<std::size_t>(n), planner.ratio())
              : relativePitch(static_cast<std::size_t>(n), 0, 0, 1.0);
    auto regular = planner.solve(relative);
    if (!regular) {
      continue;
    }
    // Without centring the heights gather at h_min: as many revolutions as the range allows.
    const bool more = !wish.centred && best && regular->violation <= kHeightRounding;
    if (!best || more || better(*regular, best->first)) {
      best.emplace(std::move(*regular), std::move(relative));
    }
  }
  return best;
}

void appendRamps(SpiralPlan& plan,
                 const std::vector<double>& lengths,
                 const Initiation& ramps,
                 const std::vector<double>* until) {
  const std::size_t n = lengths.size();
  const std::size_t count = ramps.begin.size();
  for (std::size_t j = 0; j < count; ++j) {
    SpiralTurn turn;
    for (std::size_t i = 0; i < n; ++i) {
      const double f = fractionOf(i, n);
      if (until == nullptr) {
        const double below = j > 0 ? ramps.after(j - 1, f) : 0.0;
        turn.position.push_back(ramps.after(j, f));
        turn.step.push_back(ramps.after(j, f) - below);
      } else {
        // The start in reverse: what is left above this revolution is what the start had below.
        const double left = j + 1 < count ? ramps.after(count - j - 2, 1.0 - f) : 0.0;
        const double leftBelow = ramps.after(count - j - 1, 1.0 - f);
        turn.position.push_back((*until)[i] - left);
        turn.step.push_back(leftBelow - left);
      }
    }
    plan.turns.push_back(std::move(turn));
  }
}

SpiralPlan planContinuous(const std::vector<double>& lengths, const SpiralWish& wish) {
  const Planner planner(lengths, wish);
  const auto chosen = choose(planner, wish);
  // Heights that far below the range mean that the ramps alone use up the part.
  constexpr double kUsedUp = 0.5;
  if (!chosen || chosen->first.least < kUsedUp * wish.heightMin * std::min(1.0, planner.ratio())) {
    const auto shortest = std::min_element(lengths.begin(), lengths.end());
    const double need =
        2.0 * std::ceil(wish.height / (wish.heightMax - wish.heightMin)) * wish.heightMin +
        2.0 * wish.height;
    refuse(ErrorCode::JobFailed,
           text("generatrix %1 is %2 mm long, too short for the start and the end of a spiral",
                {std::to_string(shortest - lengths.begin() + 1), formatFixed(*shortest, 2)}),
           text("at ±%1 % about %2 mm are needed: widen the range, lower the deposit, or start "
                "with a simple ramp",
                {formatFixed(50.0 * (wish.heightMax - wish.heightMin) / wish.height, 0),
                 formatFixed(need, 1)}));
  }
  const Regular& regular = chosen->first;
  SpiralPlan plan;
  appendRamps(plan, lengths, regular.start, nullptr);
  plan.startTurns = plan.turns.size();
  std::vector<double> at(lengths.size());
  for (std::size_t i = 0; i < at.size(); ++i) {
    at[i] = regular.start.total(fractionOf(i, at.size()));
  }
  // Where the end of a revolution arrives on the seam generatrix, and where the next one starts.
  double arrived = regular.start.total(1.0);
  double seam = 0.0;
  for (std::size_t k = 0; k + 1 < regular.pitch.size(); ++k) {
    SpiralTurn turn;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const double d = planner.deposit(regular, k, i);
      at[i] += d;
      turn.position.push_back(at[i]);
      turn.step.push_back(d);
    }
    const auto [low, high] = std::minmax(regular.pitch[k], regular.pitch[k + 1]);
    turn.lowest = wish.heightMin * low / regular.pitch.front();
    turn.highest = wish.heightMax * high / regular.pitch.front();
    seam = std::max(seam, std::abs(turn.position.front() - arrived));
    arrived += regular.scaleAtEnd * regular.pitch[k + 1];
    plan.turns.push_back(std::move(turn));
  }
  if (wish.end == SpiralEnd::Mirrored) {
    appendRamps(plan, lengths, regular.end, &lengths);
    plan.endTurns = regular.end.begin.size();
  }
  plan.regularMin = regular.least;
  plan.regularMax = regular.greatest;
  plan.regularMean = regular.mean;
  plan.largestSeamStep = seam;
  if (regular.violation > kHeightRounding) {
    plan.excess = regular.worst;
  }
  return plan;
}

/// Equal steps on every generatrix, the revolutions linked one after the other (Diourté M21, M22).
SpiralPlan planLiteral(const std::vector<double>& lengths, const SpiralWish& wish) {
  const std::size_t n = lengths.size();
  const Initiation start =
      wish.start == SpiralStart::None
          ? Initiation{}
          : initiation(wish.heightMin, wish.heightMax, wish.height, wish.start);
  const auto at = [&](std::size_t i) {
    return n > 1 ? static_cast<double>(i) / static_cast<double>(n - 1) : 0.0;
  };
  std::vector<double> left(n);
  for (std::size_t i = 0; i < n; ++i) {
    left[i] =
        lengths[i] - start.total(at(i)) - (wish.end == SpiralEnd::Point ? wish.endReserve : 0.0);
  }
  const auto [shortest, longest] = std::minmax_element(left.begin(), left.end());
  if (!(*shortest >= wish.heightMin)) {
    refuse(ErrorCode::JobFailed,
           text("generatrix %1 is %2 mm long, too short for the start of a spiral",
                {std::to_string(shortest - left.begin() + 1),
                 formatFixed(lengths[static_cast<std::size_t>(shortest - left.begin())], 2)}),
           "widen the range, lower the deposit, or start without ramps");
  }
  auto count = static_cast<long>(std::floor(*shortest / wish.heightMin + kWhole));
  if (wish.centred) {
    const TurnRange range = turnRange(*shortest, *longest, wish.heightMin, wish.heightMax);
    double mean = 0.0;
    for (const double length : left) {
      mean += length / static_cast<double>(n);
    }
    if (range.feasible()) {
      count = std::clamp(std::lround(mean / wish.height), range.first, range.last);
    }
  }
  SpiralPlan plan;
  for (std::size_t j = 0; j < start.begin.size(); ++j) {
    SpiralTurn turn;
    for (std::size_t i = 0; i < n; ++i) {
      turn.position.push_back(start.after(j, at(i)));
      turn.step.push_back(start.after(j, at(i)) - (j > 0 ? start.after(j - 1, at(i)) : 0.0));
    }
    plan.turns.push_back(std::move(turn));
  }
  plan.startTurns = plan.turns.size();
  plan.regularMin = *shortest / static_cast<double>(count);
  plan.regularMax = *longest / static_cast<double>(count);
  for (const double length : left) {
    plan.regularMean += length / static_cast<double>(count) / static_cast<double>(n);
  }
  for (long k = 1; k <= count; ++k) {
    SpiralTurn turn;
    for (std::size_t i = 0; i < n; ++i) {
      const double step = left[i] / static_cast<double>(count);
      turn.position.push_back(start.total(at(i)) + static_cast<double>(k) * step);
      turn.step.push_back(step);
    }
    turn.lowest = wish.heightMin;
    turn.highest = wish.heightMax;
    if (k > 1) {
      plan.largestSeamStep =
          std::max(plan.largestSeamStep,
                   std::abs(turn.position.front() - plan.turns.back().position.back()));
    }
    plan.turns.push_back(std::move(turn));
  }
  const double slack = kHeightRounding * wish.heightMax;
  if (plan.regularMax > wish.heightMax + slack) {
    plan.excess = {static_cast<std::size_t>(longest - left.begin()), plan.regularMax};
  } else if (plan.regularMin < wish.heightMin - slack) {
    plan.excess = {static_cast<std::size_t>(shortest - left.begin()), plan.regularMin};
  }
  return plan;
}

}  // namespace

double Initiation::after(std::size_t j, double f) const {
  double height = 0.0;
  for (std::size_t k = 0; k <= j && k < begin.size(); ++k) {
    height += begin[k] + (end[k] - begin[k]) * f;
  }
  return height;
}

double Initiation::total(double f) const {
  return begin.empty() ? 0.0 : after(begin.size() - 1, f);
}

Initiation initiation(double heightMin, double heightMax, double gap, SpiralStart start) {
  if (start == SpiralStart::None) {
    return {};
  }
  if (start == SpiralStart::Ramp) {
    return equalRamps(0.0, gap, 1);
  }
  checkRange(heightMin, heightMax);
  const auto count =
      static_cast<std::size_t>(std::max(1.0, std::ceil(gap / (heightMax - heightMin) - kWhole)));
  Initiation result = fullRamps(heightMin, heightMax, gap, count);
  if (start == SpiralStart::Thesis) {
    result.begin.back() = heightMin;
    result.end.back() = gap;
  }
  return result;
}

TurnRange turnRange(double shortest, double longest, double heightMin, double heightMax) {
  checkRange(heightMin, heightMax);
  return {static_cast<long>(std::ceil(longest / heightMax - kWhole)),
          static_cast<long>(std::floor(shortest / heightMin + kWhole))};
}

SpiralPlan planSpiral(const std::vector<double>& lengths, const SpiralWish& wish) {
  checkRange(wish.heightMin, wish.heightMax);
  if (!(wish.height >= wish.heightMin && wish.height <= wish.heightMax)) {
    refuse(ErrorCode::InvalidArgument,
           text("the mean deposit of %1 mm lies outside the range of %2 to %3 mm",
                {formatFixed(wish.height, 3), formatFixed(wish.heightMin, 3),
                 formatFixed(wish.heightMax, 3)}),
           "choose a range around the mean deposit");
  }
  if (lengths.empty()) {
    refuse(ErrorCode::InvalidArgument, "there is no generatrix", "");
  }
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    if (!(lengths[i] > 0.0) || !std::isfinite(lengths[i])) {
      refuse(ErrorCode::JobFailed, text("generatrix %1 has no length", {std::to_string(i + 1)}),
             "check the part's borders");
    }
  }
  const bool literal = wish.start == SpiralStart::None || wish.start == SpiralStart::Thesis ||
                       wish.end == SpiralEnd::Literal;
  return literal ? planLiteral(lengths, wish) : planContinuous(lengths, wish);
}

SpiralRange roundedOutwards(double low, double high) {
  constexpr double kSteps = 100.0;  // hundredths of a millimetre, as rangeText shows them
  // An end that is such a step already, but for rounding, stays.
  return {std::floor(low * kSteps + kWhole) / kSteps, std::ceil(high * kSteps - kWhole) / kSteps};
}

std::optional<SpiralRange> rangeThatWouldDo(const std::vector<double>& lengths,
                                            const SpiralWish& wish) {
  const auto [shortest, longest] = std::minmax_element(lengths.begin(), lengths.end());
  constexpr double kLast = 0.9;
  constexpr double kPercent = 0.01;
  constexpr double kGrowth = 1.1;
  // No range is narrower than the spread of the lengths; whole revolutions need some more.
  double part = std::max((*longest - *shortest) / (*longest + *shortest), kPercent);
  for (; part < kLast; part = std::max(part + kPercent, kGrowth * part)) {
    const SpiralRange range =
        roundedOutwards(wish.height * (1.0 - part), wish.height * (1.0 + part));
    if (!(range.low > 0.0)) {
      break;
    }
    SpiralWish wider = wish;
    wider.heightMin = range.low;
    wider.heightMax = range.high;
    try {
      if (!planSpiral(lengths, wider).excess) {
        return range;
      }
    } catch (const Error&) {
      continue;  // the ramps of a narrow range use up the part
    }
  }
  return std::nullopt;
}

Text rangeText(const SpiralRange& range) {
  return text("%1 to %2 mm", {formatFixed(range.low, 2), formatFixed(range.high, 2)});
}

}  // namespace wcam::toolpath
