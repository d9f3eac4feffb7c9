// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/base/error.hpp"

#include <Message_ProgressIndicator.hxx>
#include <Standard_Failure.hxx>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace wcam::io {

class OcctMessages;

/// Alone with OpenCASCADE's readers while it lives: they share static data. Their messages are
/// collected instead of printed.
class OcctSession {
public:
  /// Waits for its turn. @throws CancelledError
  explicit OcctSession(const JobContext& context);
  ~OcctSession();
  OcctSession(const OcctSession&) = delete;
  OcctSession& operator=(const OcctSession&) = delete;

  /// Warnings and failures so far, each text once, in their order.
  [[nodiscard]] const std::vector<std::string>& messages() const;
  /// The first messages as the end of a sentence, ": a; b; c", or nothing.
  [[nodiscard]] std::string messageTail() const;

private:
  std::unique_lock<std::timed_mutex> lock_;
  opencascade::handle<OcctMessages> printer_;
};

/// Passes progress and cancel on to OpenCASCADE.
class OcctProgress : public Message_ProgressIndicator {
public:
  explicit OcctProgress(JobContext context) : context_(std::move(context)) {}

  Standard_Boolean UserBreak() override { return context_.cancelled(); }

protected:
  void Show(const Message_ProgressScope& scope, Standard_Boolean force) override;

private:
  JobContext context_;
};

/// Runs work that calls OpenCASCADE; its exceptions become Error(InputInvalid) naming the file.
template <class Work>
auto guardOcct(const std::string& file, const Text& act, const JobContext& context, Work&& work) {
  try {
    return work();
  } catch (const Standard_Failure& failure) {
    context.check();  // a break may surface as a failure
    const char* message = failure.GetMessageString();
    const std::string tail =
        message != nullptr && *message != '\0' ? std::string(": ") + message : std::string();
    throw Error(ErrorCode::InputInvalid,
                wcam::text("%1 failed: %2%3", {act, failure.DynamicType()->Name(), tail}), file,
                "check the part in the CAD system and export it again");
  }
}

}  // namespace wcam::io
