// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/remedy.hpp"

#include <string_view>

namespace wcam {

namespace {
constexpr std::string_view kPrefix = "set.";
}  // namespace

std::pair<std::string, double> figureOf(const ParamSetting& setting) {
  return {std::string(kPrefix) + setting.section + "." + setting.key, setting.value};
}

std::vector<ParamSetting> settingsOf(const Diagnostic& finding) {
  std::vector<ParamSetting> settings;
  for (const auto& [name, value] : finding.data) {
    const std::size_t dot = name.find('.', kPrefix.size());
    if (name.rfind(kPrefix, 0) == 0 && dot != std::string::npos) {
      settings.push_back(
          {name.substr(kPrefix.size(), dot - kPrefix.size()), name.substr(dot + 1), value});
    }
  }
  return settings;
}

RemediedError::RemediedError(const Error& error, std::vector<ParamSetting> settings)
    : Error(error), settings_(std::move(settings)) {}

RemediedError::~RemediedError() = default;

}  // namespace wcam
