// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/text.hpp"

#include <stdexcept>
#include <string>

namespace wcam {

/// Why something could not go on. The class of error decides camcli's exit code (exitCodeOf).
enum class ErrorCode {
  InvalidArgument,  ///< a caller's mistake, a parameter out of range
  InputNotFound,    ///< a file or an object that is named does not exist
  InputInvalid,     ///< a file that cannot be understood, or geometry that cannot be used
  ProjectInvalid,   ///< a project, cell or process file that breaks its format
  ProjectReadOnly,  ///< a project written by a newer version
  OutputConflict,   ///< a file or folder that cannot be written
  CheckFailed,      ///< the result violates a check
  JobFailed,        ///< a stage of the pipeline could not produce its result
  PluginMissing,    ///< a component that no plugin provides
  PluginRefused,    ///< a plugin that is broken or not compatible
  Cancelled,        ///< stopped on request
  Internal          ///< a defect of this program
};

/// Stable lower-case name, for example "input-not-found".
const char* toString(ErrorCode code) noexcept;

/// The process exit code of DESIGN 10: 1 usage, 2 internal, 3 input or project, 4 output conflict,
/// 5 check violations, 6 job failed, 7 plugin, 130 cancelled.
int exitCodeOf(ErrorCode code) noexcept;

/// What cannot go on. what() is the message with its context; `hint` tells the remedy. Strings are
/// English; the texts can be rendered in another language (wcam::render).
class Error : public std::runtime_error {
public:
  /// @param context the place: a file, a path in a project, a stage
  Error(ErrorCode code, Text message, Text context = {}, Text hint = {});
  ~Error() override;

  [[nodiscard]] ErrorCode code() const noexcept { return code_; }

  [[nodiscard]] const std::string& message() const noexcept { return message_; }

  [[nodiscard]] const std::string& context() const noexcept { return context_; }

  [[nodiscard]] const std::string& hint() const noexcept { return hint_; }

  [[nodiscard]] const Text& messageText() const noexcept { return messageText_; }

  [[nodiscard]] const Text& contextText() const noexcept { return contextText_; }

  [[nodiscard]] const Text& hintText() const noexcept { return hintText_; }

  /// what() as a text.
  [[nodiscard]] Text whatText() const;

private:
  ErrorCode code_;
  Text messageText_;
  Text contextText_;
  Text hintText_;
  std::string message_;
  std::string context_;
  std::string hint_;
};

/// Thrown by JobContext::check() after a cancel request; never shown as a failure.
class CancelledError : public Error {
public:
  CancelledError();
  ~CancelledError() override;
};

[[noreturn]] void assertionFailed(const char* expression, const char* file, int line);

}  // namespace wcam

/// Invariant that holds in every build: a stop is better than a wrong robot program.
#define WCAM_ASSERT(expression) \
  ((expression) ? static_cast<void>(0) : ::wcam::assertionFailed(#expression, __FILE__, __LINE__))
