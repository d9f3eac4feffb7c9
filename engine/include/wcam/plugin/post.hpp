// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/base/value.hpp"
#include "wcam/program/program.hpp"

#include <string>
#include <vector>

namespace wcam::plugin {

struct OutputFile {
  std::string name;     ///< file name, no folders
  std::string content;  ///< bytes
};

/// Prints a program in a robot language: no geometry, no clock, no locale (DESIGN 9). const and
/// re-entrant.
class PostProcessor {
public:
  virtual ~PostProcessor();
  /// @param params completed by the component's schema
  [[nodiscard]] virtual std::vector<OutputFile> post(const program::Program& program,
                                                     const Value& params,
                                                     const JobContext& context) const = 0;
};

}  // namespace wcam::plugin
