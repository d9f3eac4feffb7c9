// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/plugin/crash_notice.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>

namespace wcam::plugin {

namespace {

constexpr int kJobFailed = 6;
constexpr std::size_t kStack = 1U << 16U;  ///< of the handler: the stack itself may be what is full

/// Name of a call that runs, where a signal handler may read it.
struct Slot {
  std::atomic<bool> used{false};
  std::array<char, 256> name{};
};

std::array<Slot, 64> slots;
thread_local int ownSlot = -1;
const char* program = "wcam";

// Only what a signal handler may do.
void put(const char* text) {
  (void)!::write(STDERR_FILENO, text, std::strlen(text));
}

/// Of this thread; else of another one, since plugins start threads.
const char* runningCall() {
  if (ownSlot >= 0) {
    return slots[static_cast<std::size_t>(ownSlot)].name.data();
  }
  for (const Slot& slot : slots) {
    if (slot.used) {
      return slot.name.data();
    }
  }
  return nullptr;
}

void tell(const char* what) {
  if (const char* call = runningCall()) {
    put("\n");
    put(program);
    put(": error: ");
    put(call);
    put(what);
    put("\n");
  }
}

void onSignal(int signal) {
  switch (signal) {
    case SIGSEGV:
    case SIGBUS:
      tell(" crashed (it used memory that is not its own); report this to the vendor");
      break;
    case SIGFPE:
      tell(" crashed (a division by zero); report this to the vendor");
      break;
    case SIGABRT:
      tell(" gave up (abort); report this to the vendor");
      break;
    default:
      tell(" crashed; report this to the vendor");
      break;
  }
  // Installed with SA_RESETHAND: the signal now ends the program.
  (void)std::raise(signal);
}

void onExit() {
  if (runningCall() != nullptr) {
    tell(" ended the program (exit); report this to the vendor");
    ::_exit(kJobFailed);
  }
}

}  // namespace

void nameCrashes(const char* name) {
  program = name;
  (void)std::atexit(onExit);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  static std::array<char, kStack> stack;
  stack_t handlers{};
  handlers.ss_sp = stack.data();
  handlers.ss_size = stack.size();
  (void)::sigaltstack(&handlers, nullptr);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
    struct sigaction action {};

    action.sa_handler = onSignal;
    action.sa_flags = SA_RESETHAND | SA_ONSTACK | SA_NODEFER;
    (void)::sigaction(signal, &action, nullptr);
  }
#endif
}

PluginCall::PluginCall(const std::string& plugin, const std::string& component)
    : slot_(-1), before_(ownSlot) {
  for (std::size_t i = 0; i < slots.size() && slot_ < 0; ++i) {
    slot_ = slots[i].used.exchange(true) ? -1 : static_cast<int>(i);
  }
  if (slot_ >= 0) {
    const std::string text =
        "plugin " + plugin + (component.empty() ? "" : ", component " + component);
    auto& name = slots[static_cast<std::size_t>(slot_)].name;
    name.fill('\0');
    std::copy_n(text.begin(), std::min(text.size(), name.size() - 1), name.begin());
    ownSlot = slot_;
  }
}

PluginCall::~PluginCall() {
  ownSlot = before_;
  if (slot_ >= 0) {
    slots[static_cast<std::size_t>(slot_)].used = false;
  }
}

}  // namespace wcam::plugin
