// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/version.h"
#include "wcam/plugin/abi.h"
#include "wcam/plugin/registrar.hpp"

#include <Eigen/Core>

#define WCAM_DETAIL_TEXT_OF(x) #x
#define WCAM_DETAIL_TEXT(x) WCAM_DETAIL_TEXT_OF(x)

#ifdef _GLIBCXX_DEBUG
#define WCAM_DETAIL_CONTAINERS "debug"
#else
#define WCAM_DETAIL_CONTAINERS "plain"
#endif

#ifdef __GLIBCXX__
#define WCAM_DETAIL_STANDARD_LIBRARY "libstdc++-cxx11abi" WCAM_DETAIL_TEXT(_GLIBCXX_USE_CXX11_ABI)
#else
#define WCAM_DETAIL_STANDARD_LIBRARY "other"
#endif

/// What two builds must share before C++ objects may cross between them: WCAM's version (until 1.0
/// its structs change with every one), the compiler's C++ ABI, the standard library and its string
/// ABI, the alignment of Eigen's fixed-size types (-march changes it), and debug containers.
#define WCAM_CXX_FINGERPRINT                              \
  "wcam" WCAM_VERSION ";gxx" WCAM_DETAIL_TEXT(            \
      __GXX_ABI_VERSION) ";" WCAM_DETAIL_STANDARD_LIBRARY \
                         ";eigen" WCAM_DETAIL_TEXT(       \
                             EIGEN_MAX_STATIC_ALIGN_BYTES) ";" WCAM_DETAIL_CONTAINERS

/// Writes the entry point of a plugin; once per library, at file scope outside any namespace.
/// `registerFunction` is a function void(wcam::plugin::Registrar&) that adds the components named
/// in the manifest. wcam_add_plugin() defines WCAM_PLUGIN_ID and WCAM_PLUGIN_VERSION as it writes
/// them into the manifest.
#define WCAM_PLUGIN(registerFunction)                                             \
  extern "C" __attribute__((visibility("default"))) const wcam_plugin_descriptor* \
  wcam_plugin_entry(void) {                                                       \
    static const wcam_plugin_descriptor kDescriptor = {                           \
        sizeof(wcam_plugin_descriptor),                                           \
        WCAM_PLUGIN_ABI_MAJOR,                                                    \
        WCAM_PLUGIN_ABI_MINOR,                                                    \
        WCAM_PLUGIN_ID,                                                           \
        WCAM_PLUGIN_VERSION,                                                      \
        WCAM_CXX_FINGERPRINT,                                                     \
        [](void* registrar) {                                                     \
          registerFunction(*static_cast<::wcam::plugin::Registrar*>(registrar));  \
        }};                                                                       \
    return &kDescriptor;                                                          \
  }                                                                               \
  static_assert(true, "a semicolon follows WCAM_PLUGIN")
