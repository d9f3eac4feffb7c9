// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Components that break one rule each when they run.
#include "probe.hpp"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <thread>

namespace {

using probe::Files;
using wcam::JobContext;

class Slicing final : public wcam::plugin::SlicingStrategy {
public:
  explicit Slicing(bool throws) : throws_(throws) {}

  [[nodiscard]] wcam::toolpath::SlicedLayers slice(const wcam::plugin::SliceInput&,
                                                   const wcam::Value&,
                                                   const JobContext&) const override {
    if (throws_) {
      throw std::out_of_range("beyond the end");
    }
    wcam::toolpath::SlicedLayers result;
    result.layers.emplace_back();
    result.layers[0].contours.emplace_back();
    result.layers[0].contours[0].points.resize(3);
    result.layers[0].contours[0].points[1].p.x() = std::numeric_limits<double>::quiet_NaN();
    return result;
  }

private:
  bool throws_;
};

Files throwsInt(const JobContext&) {
  throw 42;
}

Files throwsStandard(const JobContext&) {
  throw std::runtime_error("out of ideas");
}

Files throwsError(const JobContext&) {
  throw wcam::Error(wcam::ErrorCode::Internal, "own message", "own place", "own hint");
}

Files throwsCancel(const JobContext&) {
  throw wcam::CancelledError();
}

Files cancels(const JobContext& context) {
  context.check();
  return {{"a.txt", "a"}};
}

Files changesWithEachCall(const JobContext& context) {
  context.check();
  static int calls = 0;
  return {{"a.txt", std::to_string(++calls)}};
}

Files ignoresCancel(const JobContext&) {
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
  return {{"a.txt", "a"}};
}

void registerComponents(wcam::plugin::Registrar& registrar) {
  probe::addPost(registrar, "probe.throws_int", throwsInt);
  probe::addPost(registrar, "probe.throws_standard", throwsStandard);
  probe::addPost(registrar, "probe.throws_error", throwsError);
  probe::addPost(registrar, "probe.throws_cancel", throwsCancel);
  probe::addPost(registrar, "probe.cancels", cancels);
  probe::addPost(registrar, "probe.no_file", [](const JobContext&) { return Files{}; });
  probe::addPost(registrar, "probe.folder", [](const JobContext&) {
    return Files{{"../evil.txt", "x"}};
  });
  probe::addPost(registrar, "probe.duplicate", [](const JobContext&) {
    return Files{{"a.txt", "x"}, {"A.TXT", "y"}};
  });
  probe::addPost(registrar, "probe.repetition", changesWithEachCall);
  probe::addPost(registrar, "probe.slow_cancel", ignoresCancel);
  probe::addPost(registrar, "probe.names", [](const JobContext&) {
    return Files{{"a.txt", "!Operation inf\n!Project nan\nfinance = 1 ; info, nano\n"}};
  });
  probe::addPost(registrar, "probe.empty", [](const JobContext&) { return Files{{"a.txt", ""}}; });
  probe::addPost(registrar, "probe.prints", [](const JobContext&) {
    std::puts("G1 X1");
    return Files{{"a.txt", "x"}};
  });
  probe::addPost(registrar, "probe.crashes", [](const JobContext&) {
    std::raise(SIGSEGV);
    return Files{{"a.txt", "x"}};
  });
  probe::addPost(registrar, "probe.aborts", [](const JobContext&) -> Files { std::abort(); });
  probe::addPost(registrar, "probe.exits", [](const JobContext&) -> Files { std::exit(0); });
  probe::addPost(registrar, "probe.nan", [](const JobContext&) {
    return Files{{"a.txt", "X nan"}};
  });
  for (const bool throws : {false, true}) {
    registrar.addSlicing({.id = throws ? "probe.slicing_throws" : "probe.slicing_nan",
                          .name = "Probe",
                          .summary = "For tests",
                          .params = {}},
                         [throws] { return std::make_unique<Slicing>(throws); });
  }
}

}  // namespace

WCAM_PLUGIN(registerComponents);
