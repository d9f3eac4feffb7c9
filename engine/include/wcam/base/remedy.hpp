// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/diagnostic.hpp"
#include "wcam/base/error.hpp"

#include <string>
#include <utility>
#include <vector>

/// Remedies that can be applied: parameters of the operation that a stage has tried, with the very
/// figures that it tells.
namespace wcam {

/// A parameter of an operation, in file units.
struct ParamSetting {
  std::string section;  ///< "params", "path", "motion"
  std::string key;
  double value = 0.0;
  friend bool operator==(const ParamSetting&, const ParamSetting&) = default;
};

/// Keeps a setting among the figures of a finding: ("set.params.height_min", 1.58).
std::pair<std::string, double> figureOf(const ParamSetting& setting);
/// The settings among the figures of a finding, in their order.
std::vector<ParamSetting> settingsOf(const Diagnostic& finding);

/// An error with settings that put it right. They were tried; without them a hint is only a hint.
class RemediedError : public Error {
public:
  RemediedError(const Error& error, std::vector<ParamSetting> settings);
  ~RemediedError() override;

  [[nodiscard]] const std::vector<ParamSetting>& settings() const noexcept { return settings_; }

private:
  std::vector<ParamSetting> settings_;
};

}  // namespace wcam
