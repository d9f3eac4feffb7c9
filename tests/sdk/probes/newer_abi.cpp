// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "probe.hpp"

extern "C" __attribute__((visibility("default"))) const wcam_plugin_descriptor* wcam_plugin_entry(
    void) {
  static const wcam_plugin_descriptor kDescriptor = {
      sizeof(wcam_plugin_descriptor),
      WCAM_PLUGIN_ABI_MAJOR,
      WCAM_PLUGIN_ABI_MINOR + 1,
      "org.wcam.probe.newer_abi",
      "1.0.0",
      WCAM_CXX_FINGERPRINT,
      [](void* registrar) {
        probe::addPost(*static_cast<wcam::plugin::Registrar*>(registrar), "probe.newer_abi");
      }};
  return &kDescriptor;
}
