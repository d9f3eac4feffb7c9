// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/toolpath.hpp"

namespace wcam::toolpath {

const char* toString(BeadFeature feature) noexcept {
  switch (feature) {
    case BeadFeature::Wall:
      return "wall";
    case BeadFeature::Inset:
      return "inset";
    case BeadFeature::Fill:
      return "fill";
    case BeadFeature::Junction:
      return "junction";
    case BeadFeature::Cladding:
      return "cladding";
    case BeadFeature::Imported:
      return "imported";
  }
  return "wall";
}

double Bead::length() const {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += (points[i].p - points[i - 1].p).norm();
  }
  return length;
}

std::size_t Toolpath::beadCount() const {
  std::size_t count = 0;
  for (const Layer& layer : layers) {
    count += layer.beads.size();
  }
  return count;
}

std::size_t Toolpath::pointCount() const {
  std::size_t count = 0;
  for (const Layer& layer : layers) {
    for (const Bead& bead : layer.beads) {
      count += bead.points.size();
    }
  }
  return count;
}

}  // namespace wcam::toolpath
