// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/edits.hpp"

#include "wcam/base/text.hpp"
#include "wcam/toolpath/edit_findings.hpp"

#include "edit_steps.hpp"

#include <algorithm>

namespace wcam::toolpath {

namespace detail {

Text nameOf(const Edit& edit) {
  return text("the edit '%1' (%2)", {edit.id, std::string(infoOf(edit.type).key)});
}

namespace {

int resolved(int index, std::size_t layers) {
  return index < 0 ? index + static_cast<int>(layers) : index;
}

/// As people write it: from 1, and from the top with negative numbers.
std::string layerText(int index) {
  return std::to_string(index < 0 ? index : index + 1);
}

}  // namespace

std::optional<std::pair<std::size_t, std::size_t>> layersOf(std::size_t layers, const Edit& edit) {
  const int from = std::max(resolved(edit.params.firstLayer, layers), 0);
  const int to = std::min(resolved(edit.params.lastLayer, layers), static_cast<int>(layers) - 1);
  if (from > to) {
    return std::nullopt;
  }
  return std::pair{static_cast<std::size_t>(from), static_cast<std::size_t>(to)};
}

std::optional<std::pair<std::size_t, std::size_t>> layersOf(const Toolpath& path,
                                                            const Edit& edit,
                                                            const JobContext& context) {
  const std::size_t count = path.layers.size();
  const auto range = layersOf(count, edit);
  if (!range) {
    return std::nullopt;
  }
  const auto from = static_cast<int>(range->first);
  const auto to = static_cast<int>(range->second);
  if (from != resolved(edit.params.firstLayer, count) ||
      to != resolved(edit.params.lastLayer, count)) {
    context.add({Severity::Information,
                 "edit.range_clipped",
                 text("%1 names layers %2 to %3, of which there are %4 to %5",
                      {nameOf(edit), layerText(edit.params.firstLayer),
                       layerText(edit.params.lastLayer), layerText(from), layerText(to)}),
                 "fit first_layer and last_layer to the layers that there are",
                 {{}, from, -1, -1},
                 {{"layers", static_cast<double>(count)}}});
  }
  return range;
}

namespace {

/// Beads, moves and axes: edits that leave the layers as they are.
std::size_t editBeads(Toolpath& path,
                      const Edit& edit,
                      const ZoneParams& zones,
                      const JobContext& context) {
  const auto range = layersOf(path, edit, context);
  if (!range) {
    return 0;
  }
  std::size_t changed = 0;
  std::size_t limited = 0;
  for (std::size_t l = range->first; l <= range->second; ++l) {
    context.check();
    Layer& layer = path.layers[l];
    // From the last one down: a pause may put a bead behind its own.
    for (std::size_t b = layer.beads.size(); b-- > 0;) {
      const bool meant = edit.params.bead < 0 || static_cast<std::size_t>(edit.params.bead) == b;
      if (!meant || layer.beads[b].points.empty()) {
        continue;
      }
      switch (edit.type) {
        case EditType::MoveSeam:
          changed += moveSeam(layer.beads[b], layer.up, edit, zones);
          break;
        case EditType::Reverse:
          changed += reverseBead(layer.beads[b], edit, zones);
          break;
        case EditType::Pause:
          changed += pauseBead(layer.beads, b, edit, zones);
          break;
        case EditType::SetSpeed:
        case EditType::SetWire:
          changed += changeProcess(layer.beads[b], edit);
          break;
        default:
          changed += tiltAxes(layer.beads[b], edit, limited);
          break;
      }
    }
  }
  if (limited > 0) {
    context.add({Severity::Warning,
                 "edit.tilt_limited",
                 text("%1 wants the torch to lean by more than 80 degrees at %2 points; it leans "
                      "by 80 there",
                      {nameOf(edit), std::to_string(limited)}),
                 "take a smaller angle, or replace the planned one instead of adding to it",
                 {{}, static_cast<int>(range->first), -1, -1},
                 {{"points", static_cast<double>(limited)}}});
  }
  return changed;
}

}  // namespace
}  // namespace detail

Toolpath applyEdit(const Toolpath& path,
                   const Edit& edit,
                   const ZoneParams& zones,
                   const JobContext& context) {
  context.check();
  Toolpath edited = path;
  std::size_t changed = 0;
  switch (edit.type) {
    case EditType::DeleteLayers:
      changed = detail::deleteLayers(edited, edit, context);
      break;
    case EditType::RepeatLayers:
      changed = detail::repeatLayers(edited, edit, context);
      break;
    default:
      changed = detail::editBeads(edited, edit, zones, context);
      break;
  }
  if (changed == 0) {
    context.add({Severity::Warning,
                 "edit.selects_nothing",
                 text("%1 finds nothing to change in the %2 layers of the toolpath",
                      {detail::nameOf(edit), std::to_string(path.layers.size())}),
                 "fit its layers, bead or region to the present toolpath, or remove it",
                 {},
                 {{"layers", static_cast<double>(path.layers.size())}}});
  }
  return edited;
}

Toolpath applyEdits(const Toolpath& path,
                    const std::vector<Edit>& edits,
                    const ZoneParams& zones,
                    const JobContext& context) {
  Toolpath edited = path;
  std::vector<Diagnostic> findings;
  for (std::size_t i = 0; i < edits.size(); ++i) {
    const JobContext own = context.withOwnDiagnostics();
    const std::size_t layers = edited.layers.size();
    edited = applyEdit(edited, edits[i], zones, own);
    // What an edit found must still be found where it is after the ones that follow.
    findings = findingsAfter(std::move(findings), layers, {edits[i]});
    const std::vector<Diagnostic> found = own.diagnostics().items();
    findings.insert(findings.end(), found.begin(), found.end());
    context.report(static_cast<double>(i + 1) / static_cast<double>(edits.size()));
  }
  context.diagnostics().append(findings);
  if (edited.beadCount() == 0 && path.beadCount() > 0) {
    context.add({Severity::Warning,
                 "edit.nothing_left",
                 "the edits leave no layer to build",
                 "leave out one of the edits that delete layers",
                 {},
                 {{"layers_before", static_cast<double>(path.layers.size())}}});
  }
  return edited;
}

}  // namespace wcam::toolpath
