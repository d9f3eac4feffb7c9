// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "occt_session.hpp"

#include "text_scanner.hpp"
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <Message_PrinterOStream.hxx>

#include <algorithm>
#include <chrono>

namespace wcam::io {

namespace {

constexpr auto kCancelInterval = std::chrono::milliseconds(50);
constexpr std::size_t kMaxMessages = 200;
constexpr std::size_t kShownMessages = 3;

std::timed_mutex& readerMutex() {
  static std::timed_mutex mutex;
  return mutex;
}

std::unique_lock<std::timed_mutex> waitForTurn(const JobContext& context) {
  std::unique_lock<std::timed_mutex> lock(readerMutex(), std::defer_lock);
  while (!lock.try_lock_for(kCancelInterval)) {
    context.check();
  }
  context.check();
  return lock;
}

}  // namespace

class OcctMessages : public Message_Printer {
public:
  [[nodiscard]] const std::vector<std::string>& texts() const { return texts_; }

protected:
  void send(const TCollection_AsciiString& string, const Message_Gravity gravity) const override {
    if (gravity < Message_Warning || texts_.size() >= kMaxMessages) {
      return;
    }
    std::string text = printableName(string.ToCString());
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) {
      text.pop_back();
    }
    if (!text.empty() && std::find(texts_.begin(), texts_.end(), text) == texts_.end()) {
      texts_.push_back(std::move(text));
    }
  }

private:
  mutable std::vector<std::string> texts_;
};

OcctSession::OcctSession(const JobContext& context)
    : lock_(waitForTurn(context)), printer_(new OcctMessages) {
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_PrinterOStream));
  Message::DefaultMessenger()->AddPrinter(printer_);
}

OcctSession::~OcctSession() {
  Message::DefaultMessenger()->RemovePrinter(printer_);
}

const std::vector<std::string>& OcctSession::messages() const {
  return printer_->texts();
}

std::string OcctSession::messageTail() const {
  std::string tail;
  for (std::size_t i = 0; i < std::min(kShownMessages, messages().size()); ++i) {
    tail += (i == 0 ? ": " : "; ") + messages()[i];
  }
  return tail;
}

void OcctProgress::Show(const Message_ProgressScope&, Standard_Boolean) {
  context_.report(GetPosition());
}

}  // namespace wcam::io
