// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "probe.hpp"

namespace {

void registerComponents(wcam::plugin::Registrar& registrar) {
  probe::addPost(registrar, "probe.throwing_register");
  throw 42;
}

}  // namespace

WCAM_PLUGIN(registerComponents);
