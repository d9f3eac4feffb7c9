// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "piece_order.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace wcam::branches {

namespace {

using toolpath::SlicedLayer;

/// A layer by its piece and its place there.
struct Step {
  std::size_t piece = 0;
  std::size_t layer = 0;
};

std::vector<Step> byLevel(const std::vector<PieceLayers>& pieces) {
  std::vector<Step> steps;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    for (std::size_t l = 0; l < pieces[p].layers.size(); ++l) {
      steps.push_back({p, l});
    }
  }
  std::sort(steps.begin(), steps.end(), [&](const Step& a, const Step& b) {
    return std::make_tuple(pieces[a.piece].levels[a.layer], a.piece, a.layer) <
           std::make_tuple(pieces[b.piece].levels[b.layer], b.piece, b.layer);
  });
  return steps;
}

/// Distance from a point to the nearest point of a piece's first layer; infinite without layers.
double distanceTo(const PieceLayers& piece, const toolpath::Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  if (!piece.layers.empty()) {
    for (const toolpath::Contour& contour : piece.layers.front().contours) {
      for (const toolpath::ContourPoint& point : contour.points) {
        least = std::min(least, (point.p - p).norm());
      }
    }
  }
  return least;
}

class PieceOrder {
public:
  PieceOrder(const std::vector<PieceLayers>& pieces, Order order)
      : pieces_(pieces), order_(order), done_(pieces.size(), false) {}

  std::vector<std::size_t> run() {
    std::vector<std::size_t> sequence;
    while (const std::optional<std::size_t> piece = next()) {
      done_[*piece] = true;
      sequence.push_back(*piece);
      last_ = piece;
      if (!pieces_[*piece].layers.empty()) {
        const auto& contour = pieces_[*piece].layers.back().contours.back();
        end_ = contour.closed ? contour.points.front().p : contour.points.back().p;
      }
    }
    return sequence;
  }

private:
  [[nodiscard]] bool ready(std::size_t p) const {
    return !done_[p] && std::all_of(pieces_[p].below.begin(), pieces_[p].below.end(),
                                    [&](std::size_t q) { return done_[q]; });
  }

  /// Key of a piece that is ready: the least goes first.
  [[nodiscard]] std::tuple<double, double, std::size_t> key(std::size_t p) const {
    double first = 0.0;
    if (order_ == Order::Depth && last_) {
      const auto& above = pieces_[*last_].above;
      first = std::find(above.begin(), above.end(), p) != above.end() ? 0.0 : 1.0;
    } else if (order_ == Order::Nearest && end_) {
      first = distanceTo(pieces_[p], *end_);
    }
    return {first, pieces_[p].from, p};
  }

  [[nodiscard]] std::optional<std::size_t> next() const {
    std::optional<std::size_t> best;
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      if (ready(p) && (!best || key(p) < key(*best))) {
        best = p;
      }
    }
    return best;
  }

  const std::vector<PieceLayers>& pieces_;
  Order order_;
  std::vector<bool> done_;
  std::optional<std::size_t> last_;
  std::optional<toolpath::Vec3> end_;
};

std::vector<Step> byPiece(const std::vector<PieceLayers>& pieces, Order order) {
  std::vector<Step> steps;
  for (const std::size_t p : PieceOrder(pieces, order).run()) {
    for (std::size_t l = 0; l < pieces[p].layers.size(); ++l) {
      steps.push_back({p, l});
    }
  }
  return steps;
}

/// The pieces with layers that lie next below a piece: those without are looked through.
void collectBelow(const std::vector<PieceLayers>& pieces,
                  std::size_t p,
                  std::set<std::size_t>& seen,
                  std::vector<std::size_t>& found) {
  for (const std::size_t q : pieces[p].below) {
    if (!seen.insert(q).second) {
      continue;
    }
    if (pieces[q].layers.empty()) {
      collectBelow(pieces, q, seen, found);
    } else {
      found.push_back(q);
    }
  }
}

}  // namespace

toolpath::SlicedLayers arrange(std::vector<PieceLayers> pieces, Order order) {
  const std::vector<Step> steps = order == Order::Level ? byLevel(pieces) : byPiece(pieces, order);
  std::vector<std::vector<std::size_t>> indexOf(pieces.size());
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    indexOf[p].resize(pieces[p].layers.size());
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    indexOf[steps[i].piece][steps[i].layer] = i;
  }
  toolpath::SlicedLayers result;
  for (const auto& [p, l] : steps) {
    std::vector<std::size_t> below;
    if (l > 0) {
      below.push_back(indexOf[p][l - 1]);
    } else {
      std::set<std::size_t> seen;
      std::vector<std::size_t> found;
      collectBelow(pieces, p, seen, found);
      for (const std::size_t q : found) {
        below.push_back(indexOf[q].back());
      }
      std::sort(below.begin(), below.end());
    }
    SlicedLayer layer = std::move(pieces[p].layers[l]);
    layer.below = std::move(below);
    result.layers.push_back(std::move(layer));
  }
  return result;
}

}  // namespace wcam::branches
