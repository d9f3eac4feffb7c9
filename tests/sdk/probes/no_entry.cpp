// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// A library without the entry point.
extern "C" __attribute__((visibility("default"))) int somethingElse() {
  return 0;
}
