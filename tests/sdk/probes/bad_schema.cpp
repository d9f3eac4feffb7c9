// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "probe.hpp"

namespace {

void registerComponents(wcam::plugin::Registrar& registrar) {
  wcam::ParamDef def;
  def.info = {.key = "Bad Key", .label = "", .min = 2.0, .max = 1.0, .enabledIf = "nothing=1"};
  def.defaultValue = "text";
  registrar.addPost({.id = "probe.bad_schema",
                     .name = "Probe",
                     .summary = "For tests",
                     .params = wcam::ParamSchema({def})},
                    [] { return std::make_unique<probe::Post>(probe::Post::Function()); });
}

}  // namespace

WCAM_PLUGIN(registerComponents);
