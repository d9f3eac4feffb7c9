// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "bead_order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::toolpath {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A few points of a contour, enough to tell neighbours from far ones.
std::vector<Vec3> samplesOf(const Contour& contour) {
  constexpr std::size_t kSamples = 16;
  const std::size_t n = contour.points.size();
  std::vector<Vec3> samples;
  const std::size_t count = std::min(n, kSamples);
  for (std::size_t i = 0; i < count; ++i) {
    // Both ends of an open contour are among them.
    const std::size_t at =
        contour.closed ? i * n / count : (count > 1 ? i * (n - 1) / (count - 1) : 0);
    samples.push_back(contour.points[at].p);
  }
  return samples;
}

double distanceBetween(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double best = kInfinity;
  for (const Vec3& p : a) {
    for (const Vec3& q : b) {
      best = std::min(best, (p - q).squaredNorm());
    }
  }
  return std::sqrt(best);
}

double lengthOf(const Contour& contour) {
  double length = 0.0;
  for (std::size_t i = 1; i < contour.points.size(); ++i) {
    length += (contour.points[i].p - contour.points[i - 1].p).norm();
  }
  return contour.closed ? length + (contour.points.front().p - contour.points.back().p).norm()
                        : length;
}

/// Indices of the contours, by groups in ascending order.
std::vector<std::vector<std::size_t>> groupsOf(const SlicedLayer& layer) {
  std::vector<std::size_t> order;
  for (std::size_t c = 0; c < layer.contours.size(); ++c) {
    if (!layer.contours[c].points.empty()) {
      order.push_back(c);
    }
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return layer.contours[a].group < layer.contours[b].group;
  });
  std::vector<std::vector<std::size_t>> groups;
  for (const std::size_t c : order) {
    if (groups.empty() || layer.contours[groups.back().front()].group != layer.contours[c].group) {
      groups.emplace_back();
    }
    groups.back().push_back(c);
  }
  return groups;
}

}  // namespace

BeadOrder::BeadOrder(const PathParams& params, const Substrate& substrate)
    : params_(params), seams_(params, substrate) {}

bool BeadOrder::runsBack(const Contour& contour, std::size_t layerIndex, bool asGiven) const {
  // A bead of several revolutions climbs: it has no other direction.
  if (!params_.alternate || asGiven || !contour.turns.empty()) {
    return false;
  }
  return (params_.alternateBy == AlternateBy::Layer ? layerIndex : count_) % 2 == 1;
}

/// Way from the torch to the start of a contour, which an open one may turn round.
double BeadOrder::approach(const Contour& contour, bool& reversed) const {
  if (contour.closed && contour.turns.empty()) {
    return (contour.points[nearestIndex(contour, *lastEnd_)].p - *lastEnd_).norm();
  }
  const double front = (contour.points.front().p - *lastEnd_).norm();
  const double back = (contour.points.back().p - *lastEnd_).norm();
  if (params_.reverseOpen && contour.turns.empty()) {
    reversed = back < front;
  }
  return reversed ? back : front;
}

double BeadOrder::heatFrom(const Deposited& bead, const std::vector<Vec3>& samples) const {
  return bead.length *
         std::exp(-distanceBetween(samples, bead.samples) / params_.heatReach.value() -
                  (length_ - bead.end) / params_.coolLength.value());
}

/// What the beads before left at each contour: the sum of length · e^(−distance/reach) ·
/// e^(−length deposited since/cooling).
void BeadOrder::startHeat(const SlicedLayer& layer) {
  heat_.assign(layer.contours.size(), 0.0);
  samples_.clear();
  for (std::size_t c = 0; c < layer.contours.size() && params_.order == OrderMode::ThermalSpread;
       ++c) {
    samples_.push_back(samplesOf(layer.contours[c]));
    for (const Deposited& bead : warm_) {
      heat_[c] += heatFrom(bead, samples_[c]);
    }
  }
}

/// The heat falls while a bead is deposited, and the bead adds its own.
void BeadOrder::addHeat(const Deposited& bead) {
  const double cooled = std::exp(-bead.length / params_.coolLength.value());
  for (std::size_t c = 0; c < samples_.size(); ++c) {
    heat_[c] = heat_[c] * cooled + heatFrom(bead, samples_[c]);
  }
}

/// When the place below each contour was deposited.
std::vector<double> BeadOrder::ranksOf(const SlicedLayer& layer) const {
  std::vector<double> ranks(layer.contours.size(), 0.0);
  if (params_.order != OrderMode::LeastRecent) {
    return ranks;
  }
  for (std::size_t c = 0; c < layer.contours.size(); ++c) {
    const std::vector<Vec3> samples = samplesOf(layer.contours[c]);
    double nearest = kInfinity;
    for (const Deposited& bead : below_) {
      const double distance = distanceBetween(samples, bead.samples);
      if (distance < nearest) {
        nearest = distance;
        ranks[c] = static_cast<double>(bead.sequence);
      }
    }
  }
  return ranks;
}

BeadOrder::Candidate BeadOrder::next(const SlicedLayer& layer,
                                     const std::vector<std::size_t>& open,
                                     std::size_t layerIndex,
                                     const std::vector<double>& ranks) const {
  Candidate best;
  double bestCost = kInfinity;
  for (const std::size_t c : open) {
    const Contour& contour = layer.contours[c];
    bool reversed = runsBack(contour, layerIndex, false);
    const double way = lastEnd_ ? approach(contour, reversed) : static_cast<double>(c);
    double cost = 0.0;
    switch (params_.order) {
      case OrderMode::Nearest:
        cost = way;
        break;
      case OrderMode::AsGiven:
        cost = static_cast<double>(c);
        break;
      case OrderMode::LeastRecent:
        cost = ranks[c];
        break;
      case OrderMode::ThermalSpread:
        cost = heat_[c];
        break;
    }
    if (cost < bestCost) {
      bestCost = cost;
      best = {c, reversed};
    }
  }
  return best;
}

void BeadOrder::deposit(const Contour& contour) {
  Deposited bead{samplesOf(contour), lengthOf(contour), 0.0, count_++};
  length_ += bead.length;
  bead.end = length_;
  current_.push_back(bead);
  if (params_.order == OrderMode::ThermalSpread) {
    // e^-10: the heat of what lies further back does not decide anything.
    constexpr double kForgotten = 10.0;
    std::erase_if(warm_, [&](const Deposited& old) {
      return length_ - old.end > kForgotten * params_.coolLength.value();
    });
    addHeat(bead);
    warm_.push_back(std::move(bead));
  }
  lastEnd_ = contour.closed ? contour.points.front().p : contour.points.back().p;
}

std::vector<OrderedContour> BeadOrder::arrange(const SlicedLayer& layer,
                                               std::size_t layerIndex,
                                               bool asGiven) {
  std::vector<OrderedContour> ordered;
  const std::vector<double> ranks = ranksOf(layer);
  startHeat(layer);
  for (std::vector<std::size_t>& open : groupsOf(layer)) {
    while (!open.empty()) {
      const Candidate chosen =
          asGiven ? Candidate{open.front(), false} : next(layer, open, layerIndex, ranks);
      std::erase(open, chosen.index);
      OrderedContour item{layer.contours[chosen.index], chosen.reversed};
      const bool ring = item.contour.closed && item.contour.turns.empty();
      if (ring && !asGiven) {
        item.contour = startingAt(item.contour,
                                  seams_.choose(item.contour, layerIndex, chosen.index, lastEnd_));
      }
      if (item.reversed) {
        // A closed bead keeps its start.
        std::reverse(item.contour.points.begin() + (ring ? 1 : 0), item.contour.points.end());
      }
      deposit(item.contour);
      ordered.push_back(std::move(item));
    }
  }
  seams_.endLayer();
  if (!current_.empty()) {
    below_ = std::move(current_);
    current_.clear();
  }
  return ordered;
}

}  // namespace wcam::toolpath
