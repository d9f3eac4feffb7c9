// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/project/history.hpp"
#include "wcam/project/project_file.hpp"

#include <cstdint>
#include <string_view>

namespace {

using wcam::Error;
using wcam::ErrorCode;
namespace project = wcam::project;

/// Saving what was loaded and loading it again gives the same bytes.
void checkRoundTrip(const project::Document& document) {
  const std::string text = document.text();
  WCAM_ASSERT(project::parseProject(text, "fuzz.wcam").document.text() == text);
}

/// What follows a line "%%" is a session log for the project before it.
void checkProject(std::string_view input) {
  constexpr std::string_view kSeparator = "\n%%\n";
  const std::size_t end = input.find(kSeparator);
  const project::LoadedProject loaded = project::parseProject(input.substr(0, end), "fuzz.wcam");
  checkRoundTrip(loaded.document);
  (void)project::usedFiles(loaded.document);
  if (end == std::string_view::npos || loaded.document.readOnly()) {
    return;
  }
  const std::string before = loaded.document.text();
  project::History history(loaded.document);
  try {
    history.replay(input.substr(end + kSeparator.size()), "fuzz.jsonl");
  } catch (const Error& error) {
    WCAM_ASSERT(error.code() == ErrorCode::InvalidArgument ||
                error.code() == ErrorCode::InputInvalid);
  }
  checkRoundTrip(history.current());
  while (history.undo()) {
  }
  WCAM_ASSERT(history.current().text() == before);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    checkProject(std::string_view(reinterpret_cast<const char*>(data), size));
  } catch (const Error& error) {
    WCAM_ASSERT(error.code() == ErrorCode::ProjectInvalid ||
                error.code() == ErrorCode::InputInvalid);
  }
  return 0;
}
