/* SPDX-FileCopyrightText: 2026 The WCAM developers
   SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WCAM_PLUGIN_ABI_H
#define WCAM_PLUGIN_ABI_H

/* C names and C headers on purpose. NOLINTBEGIN */
#include <stdint.h>

/* The C handshake of a plugin. The host calls wcam_plugin_entry() and checks every field before any
   C++ object crosses the border. This header is plain C99.

   A plugin fits when abi_major is equal and abi_minor is not newer than the host's. The layout of
   this struct never changes within a major number; new fields are added at its end and struct_size
   tells which of them are there. */

#define WCAM_PLUGIN_ABI_MAJOR 1
#define WCAM_PLUGIN_ABI_MINOR 0

/* Name of the one exported symbol. */
#define WCAM_PLUGIN_ENTRY_NAME "wcam_plugin_entry"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct wcam_plugin_descriptor {
  uint32_t struct_size; /* sizeof(wcam_plugin_descriptor) of the plugin's build */
  uint32_t abi_major;
  uint32_t abi_minor;
  const char* id;              /* as in the manifest, UTF-8 */
  const char* version;         /* as in the manifest */
  const char* cxx_fingerprint; /* WCAM_CXX_FINGERPRINT of the plugin's build */
  /* Called once when all of the above fits. `registrar` is a wcam::plugin::Registrar*. */
  void (*register_components)(void* registrar);
} wcam_plugin_descriptor;

/* Returns a descriptor that lives as long as the process. */
typedef const wcam_plugin_descriptor* (*wcam_plugin_entry_function)(void);

#ifdef __cplusplus
}
#endif

/* NOLINTEND */

#endif
