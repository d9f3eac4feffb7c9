// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/toolpath/edits.hpp"

#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

namespace {

using namespace wcam;
using namespace wcam::toolpath;

/// Three layers of a closed and an open bead.
Toolpath beads() {
  Toolpath path;
  constexpr int kPoints = 24;
  for (int l = 0; l < 3; ++l) {
    Layer layer;
    layer.level = 2.0 * (l + 1);
    for (const bool closed : {true, false}) {
      Bead bead;
      bead.closed = closed;
      for (int i = 0; i <= kPoints; ++i) {
        const double a = (closed ? 2.0 : 1.0) * kPi * (closed ? i % kPoints : i) / kPoints;
        PathPoint point;
        point.n = Vec3(std::cos(a), std::sin(a), 0.0);
        point.p = (closed ? 20.0 : 40.0) * point.n + Vec3(0.0, 0.0, layer.level);
        point.t = Vec3(std::sin(a), -std::cos(a), 0.0);
        point.distance = point.height = 2.0;
        bead.points.push_back(point);
      }
      layer.beads.push_back(bead);
    }
    path.layers.push_back(layer);
  }
  return path;
}

}  // namespace

/// A list of {"type", "params"}: a toolpath of finite points, or an error of the caller's kind.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Toolpath path = beads();
  try {
    const Value list =
        parseJson(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz.json");
    constexpr std::size_t kMostEdits = 6;  // repeated layers multiply
    std::vector<Edit> edits;
    for (std::size_t i = 0; i < std::min(kMostEdits, list.asArray().size()); ++i) {
      const Value& item = list.asArray()[i];
      if (const auto type = editTypeOf(item.at("type").asString())) {
        edits.push_back(readEdit("e", *type, item.at("params")));
        if (const Value* count = item.at("params").find("count");
            count != nullptr && count->isNumber() && count->asReal() > 20.0) {
          return 0;
        }
      }
    }
    const Toolpath edited = applyEdits(path, edits, {}, JobContext());
    for (const Layer& layer : edited.layers) {
      for (const Bead& bead : layer.beads) {
        for (const PathPoint& point : bead.points) {
          WCAM_ASSERT(point.p.allFinite() && point.t.allFinite() && point.axis.allFinite());
        }
      }
    }
  } catch (const Error& error) {
    WCAM_ASSERT(error.code() != ErrorCode::Internal);
  }
  return 0;
}
