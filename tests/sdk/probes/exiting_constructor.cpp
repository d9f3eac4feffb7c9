// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Ends the program as soon as it is loaded.
#include "probe.hpp"

#include <csignal>
#include <cstdlib>

namespace {

const bool kEnded = [] {
  std::exit(0);
  return true;
}();

void registerComponents(wcam::plugin::Registrar& registrar) {
  if (kEnded) {
    probe::addPost(registrar, "probe.exiting_constructor");
  }
}

}  // namespace

WCAM_PLUGIN(registerComponents);
