// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "end_signals.hpp"

#include "session.hpp"
#include <sys/socket.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QSocketNotifier>

#include <array>
#include <cerrno>
#include <csignal>

namespace wcam::gui {

namespace {

constexpr std::array<int, 3> kSignals = {SIGTERM, SIGINT, SIGHUP};
/// What a shell reports for a program that a signal ended.
constexpr int kEndedBySignal = 128;

/// A handler may hardly do anything: it wakes the event loop through a pair of sockets.
std::array<int, 2> wake = {-1, -1};

void onSignal(int number) {
  const int saved = errno;
  const char byte = static_cast<char>(number);
  // A full socket has woken the loop already.
  [[maybe_unused]] const ssize_t written = ::write(wake[0], &byte, 1);
  errno = saved;
}

}  // namespace

EndSignals::EndSignals(Session& session) : session_(session) {
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, wake.data()) != 0) {
    return;  // the signals do what they do by default; the autosave is some seconds old then
  }
  notifier_ = new QSocketNotifier(wake[1], QSocketNotifier::Read, this);
  connect(notifier_, &QSocketNotifier::activated, this, &EndSignals::end);
  for (const int number : kSignals) {
    struct sigaction action = {};
    action.sa_handler = onSignal;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    ::sigaction(number, &action, nullptr);
  }
}

EndSignals::~EndSignals() {
  if (notifier_ == nullptr) {
    return;
  }
  for (const int number : kSignals) {
    std::signal(number, SIG_DFL);
  }
  delete notifier_;
  ::close(wake[0]);
  ::close(wake[1]);
  wake = {-1, -1};
}

void EndSignals::end() {
  char number = 0;
  if (::read(wake[1], &number, 1) == 1) {
    session_.autosaveNow();
    QCoreApplication::exit(kEndedBySignal + number);
  }
}

}  // namespace wcam::gui
