// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "probe.hpp"

namespace {

void registerComponents(wcam::plugin::Registrar& registrar) {
  registrar.addPost(
      {.id = "probe.throwing_factory", .name = "Probe", .summary = "For tests", .params = {}},
      []() -> std::unique_ptr<wcam::plugin::PostProcessor> { throw std::string("no"); });
}

}  // namespace

WCAM_PLUGIN(registerComponents);
