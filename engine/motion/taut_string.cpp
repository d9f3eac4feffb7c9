// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "taut_string.hpp"

#include <algorithm>
#include <cstddef>

namespace wcam::motion::detail {

namespace {

/// Free ends: the string is held this many times its length away, where any slope is as good as
/// none.
constexpr double kFar = 1e6;

struct Vertex {
  double time;
  double value;
};

double slope(const Vertex& a, const Vertex& b) {
  return (b.value - a.value) / (b.time - a.time);
}

/// Shortest path from the apex to one end of the last gate.
struct Chain {
  std::vector<Vertex> vertices;
  std::size_t apex = 0;

  [[nodiscard]] std::size_t size() const { return vertices.size() - apex; }

  [[nodiscard]] const Vertex& front() const { return vertices[apex]; }
};

class Funnel {
public:
  explicit Funnel(const Vertex& start) : upper_{{start}}, lower_{{start}}, path_{start} {}

  void add(const Gate& gate) {
    extend(upper_, lower_, {gate.time, gate.high}, 1.0);
    extend(lower_, upper_, {gate.time, gate.low}, -1.0);
  }

  /// The path to the last gate's low end.
  std::vector<Vertex> finish() {
    path_.insert(path_.end(),
                 lower_.vertices.begin() + static_cast<std::ptrdiff_t>(lower_.apex) + 1,
                 lower_.vertices.end());
    return path_;
  }

private:
  /// @param sign 1 where `own` leads to the upper ends: its slopes ascend
  void extend(Chain& own, Chain& other, const Vertex& end, double sign) {
    std::vector<Vertex>& v = own.vertices;
    while (own.size() > 1 &&
           sign * (slope(v[v.size() - 2], v.back()) - slope(v.back(), end)) >= 0) {
      v.pop_back();
    }
    if (own.size() == 1) {
      // Beyond the other side: the path bends there.
      while (other.size() > 1 && sign * (slope(other.front(), end) -
                                         slope(other.front(), other.vertices[other.apex + 1])) <
                                     0.0) {
        ++other.apex;
        path_.push_back(other.front());
      }
      v.back() = other.front();
    }
    v.push_back(end);
  }

  Chain upper_, lower_;
  std::vector<Vertex> path_;
};

double middle(const Gate& gate) {
  return 0.5 * (gate.low + gate.high);
}

}  // namespace

std::vector<double> tautString(const std::vector<Gate>& gates) {
  if (gates.empty()) {
    return {};
  }
  const Gate& first = gates.front();
  const Gate& last = gates.back();
  const double far = kFar * (1.0 + last.time - first.time);
  Funnel funnel({first.time - far, middle(first)});
  for (const Gate& gate : gates) {
    funnel.add(gate);
  }
  funnel.add({last.time + far, middle(last), middle(last)});
  const std::vector<Vertex> path = funnel.finish();
  std::vector<double> values(gates.size());
  std::size_t k = 0;
  for (std::size_t i = 0; i < gates.size(); ++i) {
    while (k + 2 < path.size() && path[k + 1].time < gates[i].time) {
      ++k;
    }
    const Vertex& a = path[k];
    const Vertex& b = path[k + 1];
    // From the nearer end: the far ones would cost digits.
    const double time = gates[i].time;
    const double value = time - a.time < b.time - time ? a.value + slope(a, b) * (time - a.time)
                                                       : b.value - slope(a, b) * (b.time - time);
    values[i] = std::clamp(value, gates[i].low, gates[i].high);
  }
  return values;
}

}  // namespace wcam::motion::detail
