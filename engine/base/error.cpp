// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace wcam {

namespace {
Text compose(const Text& message, const Text& context) {
  return context.empty() ? message : text("%1: %2", {context, message});
}
}  // namespace

const char* toString(ErrorCode code) noexcept {
  switch (code) {
    case ErrorCode::InvalidArgument:
      return "invalid-argument";
    case ErrorCode::InputNotFound:
      return "input-not-found";
    case ErrorCode::InputInvalid:
      return "input-invalid";
    case ErrorCode::ProjectInvalid:
      return "project-invalid";
    case ErrorCode::ProjectReadOnly:
      return "project-read-only";
    case ErrorCode::OutputConflict:
      return "output-conflict";
    case ErrorCode::CheckFailed:
      return "check-failed";
    case ErrorCode::JobFailed:
      return "job-failed";
    case ErrorCode::PluginMissing:
      return "plugin-missing";
    case ErrorCode::PluginRefused:
      return "plugin-refused";
    case ErrorCode::Cancelled:
      return "cancelled";
    case ErrorCode::Internal:
      return "internal";
  }
  return "internal";
}

int exitCodeOf(ErrorCode code) noexcept {
  switch (code) {
    case ErrorCode::InvalidArgument:
      return 1;
    case ErrorCode::InputNotFound:
    case ErrorCode::InputInvalid:
    case ErrorCode::ProjectInvalid:
    case ErrorCode::ProjectReadOnly:
      return 3;
    case ErrorCode::OutputConflict:
      return 4;
    case ErrorCode::CheckFailed:
      return 5;
    case ErrorCode::JobFailed:
      return 6;
    case ErrorCode::PluginMissing:
    case ErrorCode::PluginRefused:
      return 7;
    case ErrorCode::Cancelled:
      return 130;
    case ErrorCode::Internal:
      return 2;
  }
  return 2;
}

Error::Error(ErrorCode code, Text message, Text context, Text hint)
    : std::runtime_error(compose(message, context).str()),
      code_(code),
      messageText_(std::move(message)),
      contextText_(std::move(context)),
      hintText_(std::move(hint)),
      message_(messageText_.str()),
      context_(contextText_.str()),
      hint_(hintText_.str()) {}

Error::~Error() = default;

Text Error::whatText() const {
  return compose(messageText_, contextText_);
}

CancelledError::CancelledError() : Error(ErrorCode::Cancelled, "cancelled") {}

CancelledError::~CancelledError() = default;

void assertionFailed(const char* expression, const char* file, int line) {
  std::fprintf(stderr, "wcam: internal error: %s does not hold (%s:%d)\n", expression, file, line);
  std::abort();
}

}  // namespace wcam
