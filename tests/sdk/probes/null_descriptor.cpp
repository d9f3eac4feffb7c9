// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "probe.hpp"

extern "C" __attribute__((visibility("default"))) const wcam_plugin_descriptor* wcam_plugin_entry(
    void) {
  return nullptr;
}
