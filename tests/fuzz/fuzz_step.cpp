// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz_mesh.hpp"
#include "step_tessellation.hpp"
#include "step_text.hpp"

/// The text of a STEP file before the CAD library sees it, and the triangles that it does not read.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  (void)wcam::io::externalFilesOf(bytes);
  if (const auto recoded = wcam::io::recodeStep(bytes)) {
    WCAM_ASSERT(!wcam::io::recodeStep(recoded->text));
  }
  wcam::fuzz::checkReader(wcam::io::parseTessellatedStep, data, size, "fuzz.step");
  return 0;
}
