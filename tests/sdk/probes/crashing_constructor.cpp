// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Ends the program as soon as it is loaded.
#include "probe.hpp"

#include <csignal>
#include <cstdlib>

namespace {

const bool kEnded = [] {
  std::raise(SIGSEGV);
  return true;
}();

void registerComponents(wcam::plugin::Registrar& registrar) {
  if (kEnded) {
    probe::addPost(registrar, "probe.crashing_constructor");
  }
}

}  // namespace

WCAM_PLUGIN(registerComponents);
