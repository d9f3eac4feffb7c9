// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "portions.hpp"

#include <vtkObjectFactory.h>

#include <algorithm>

namespace wcam::viewport {

vtkStandardNewMacro(PortionCuller);

double PortionCuller::Cull(vtkRenderer* /*renderer*/,
                           vtkProp** props,
                           int& count,
                           int& /*initialized*/) {
  double time = 0.0;
  int kept = 0;
  for (int i = 0; i < count; ++i) {
    if (chosen.count(props[i]) != 0) {
      props[kept++] = props[i];
      time += props[i]->GetRenderTimeMultiplier();
    }
  }
  count = kept;
  return time;
}

void Portions::begin(std::vector<Drawable> drawables) {
  drawables_ = std::move(drawables);
  std::stable_partition(drawables_.begin(), drawables_.end(),
                        [](const Drawable& d) { return !d.translucent; });
  at_ = 0;
}

double Portions::next(double capacity, std::unordered_set<vtkProp*>& chosen) {
  chosen.clear();
  double sum = 0.0;
  while (at_ < drawables_.size()) {
    // What is translucent is mixed in one go.
    std::size_t end = at_ + 1;
    double triangles = drawables_[at_].triangles;
    while (drawables_[at_].translucent && end < drawables_.size()) {
      triangles += drawables_[end++].triangles;
    }
    if (!chosen.empty() && sum + triangles > capacity) {
      break;
    }
    for (; at_ < end; ++at_) {
      chosen.insert(drawables_[at_].prop);
    }
    sum += triangles;
  }
  return sum;
}

}  // namespace wcam::viewport
