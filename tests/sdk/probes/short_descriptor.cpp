// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "probe.hpp"

extern "C" __attribute__((visibility("default"))) const wcam_plugin_descriptor* wcam_plugin_entry(
    void) {
  static const wcam_plugin_descriptor kDescriptor = {
      8,
      WCAM_PLUGIN_ABI_MAJOR,
      WCAM_PLUGIN_ABI_MINOR,
      "org.wcam.probe.short_descriptor",
      "1.0.0",
      WCAM_CXX_FINGERPRINT,
      [](void* registrar) {
        probe::addPost(*static_cast<wcam::plugin::Registrar*>(registrar), "probe.short_descriptor");
      }};
  return &kDescriptor;
}
