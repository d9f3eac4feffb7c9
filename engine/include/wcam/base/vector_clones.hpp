// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Macros for inner loops on plain arrays; includes nothing, so that files with compiler options of
/// their own can use it.

/// One clone of the function per instruction set, chosen at load time. Sanitizers do not stand the
/// resolvers.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define WCAM_VECTOR_CLONES \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define WCAM_VECTOR_CLONES
#endif

/// What a clone calls must become a part of it.
#define WCAM_CLONED inline __attribute__((always_inline))
