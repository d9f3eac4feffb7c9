// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/base/value.hpp"
#include "wcam/geometry/guide_curve.hpp"
#include "wcam/geometry/part_surface.hpp"
#include "wcam/toolpath/import_table.hpp"
#include "wcam/toolpath/slicing.hpp"
#include "wcam/toolpath/substrate.hpp"

#include <memory>
#include <string>
#include <vector>

namespace wcam::plugin {

/// What a strategy works on. All geometry is in the part frame, mm; build direction and origin come
/// from the substrate.
struct SliceInput {
  std::vector<std::shared_ptr<const geometry::PartSurface>>
      parts;  ///< at least one, unless there is an imported path
  std::shared_ptr<const toolpath::Substrate> substrate;  ///< never null
  std::shared_ptr<const geometry::GuideCurve> guide;     ///< null when the operation names none
  toolpath::Sampling sampling;
  toolpath::BeadRange bead = {};  ///< what the operation's process can deposit
  /// The path that the operation's file holds; null when the operation names no file.
  std::shared_ptr<const toolpath::ImportedPath> imported = {};
};

/// Where does layer k lie on the part? One instance serves many calls, also at the same time:
/// slice() is const, re-entrant, uses no clock, locale, file or thread of its own, and looks at
/// context.check().
class SlicingStrategy {
public:
  virtual ~SlicingStrategy();
  /// @param params completed by the component's schema
  /// @throws Error (JobFailed, InvalidArgument) with the place and the remedy
  [[nodiscard]] virtual toolpath::SlicedLayers slice(const SliceInput& input,
                                                     const Value& params,
                                                     const JobContext& context) const = 0;
};

}  // namespace wcam::plugin
