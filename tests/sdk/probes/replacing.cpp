// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Provides a component that comes with WCAM.
#include "probe.hpp"

namespace {

void registerComponents(wcam::plugin::Registrar& registrar) {
  probe::addPost(registrar, "wcam.post.fanuc", [](const wcam::JobContext&) {
    return probe::Files{{"another.ls", "/PROG"}};
  });
}

}  // namespace

WCAM_PLUGIN(registerComponents);
