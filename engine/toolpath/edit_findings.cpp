// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/edit_findings.hpp"

#include "edit_steps.hpp"

namespace wcam::toolpath {

namespace {

/// Where a place is after an edit.
/// @return false when it is gone
bool follow(Place& place, const Edit& edit, std::size_t first, std::size_t last) {
  const auto layer = static_cast<std::size_t>(place.layer);
  const auto size = static_cast<int>(last - first) + 1;
  const bool inside = layer >= first && layer <= last;
  switch (edit.type) {
    case EditType::DeleteLayers:
      place.layer -= layer > last ? size : 0;
      return !inside;
    case EditType::RepeatLayers:
      place.layer += layer > last ? size * edit.params.count : 0;
      return true;
    case EditType::MoveSeam:
    case EditType::Reverse:
      if (inside && (edit.params.bead < 0 || edit.params.bead == place.bead)) {
        place.point = -1;
      }
      return true;
    case EditType::Pause:
      // At a length the bead is cut in two, and those behind it have other numbers.
      if (inside && edit.params.where == PausePlace::AtLength &&
          (edit.params.bead < 0 || edit.params.bead <= place.bead)) {
        place.bead = place.point = -1;
      }
      return true;
    case EditType::SetSpeed:
    case EditType::SetWire:
    case EditType::SetLead:
    case EditType::SetLateral:
      // A region cuts moves at its border.
      if (inside && edit.params.region != EditRegion::Everywhere) {
        place.point = -1;
      }
      return true;
  }
  return true;
}

}  // namespace

std::vector<Diagnostic> findingsAfter(std::vector<Diagnostic> findings,
                                      std::size_t layers,
                                      const std::vector<Edit>& edits) {
  for (const Edit& edit : edits) {
    const auto range = detail::layersOf(layers, edit);
    if (!range) {
      continue;
    }
    const auto [first, last] = *range;
    std::vector<Diagnostic> kept;
    for (Diagnostic& finding : findings) {
      if (finding.place.layer < 0 || follow(finding.place, edit, first, last)) {
        kept.push_back(std::move(finding));
      }
    }
    findings = std::move(kept);
    const std::size_t size = last - first + 1;
    if (edit.type == EditType::DeleteLayers) {
      layers -= size;
    } else if (edit.type == EditType::RepeatLayers) {
      layers += size * static_cast<std::size_t>(edit.params.count);
    }
  }
  return findings;
}

}  // namespace wcam::toolpath
