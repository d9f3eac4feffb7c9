// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz_mesh.hpp"

/// A sound mesh comes out, or an error of the file's kind.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  wcam::fuzz::checkReader(wcam::io::parseObj, data, size, "fuzz.obj");
  return 0;
}
