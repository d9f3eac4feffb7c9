// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Carries the precompiled headers of the tests (packaging/cmake/WcamTest.cmake); does nothing.
int main() {
  return 0;
}
