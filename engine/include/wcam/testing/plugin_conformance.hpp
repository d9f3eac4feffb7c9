// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/base/error.hpp"
#include "wcam/base/parallel.hpp"
#include "wcam/base/text.hpp"
#include "wcam/plugin/host.hpp"
#include "wcam/testing/sample_program.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

/// What every component must keep, as functions to call from any test program. They throw
/// wcam::Error(CheckFailed) that names the rule. Call them from one thread: the locale of the
/// process is changed for a moment.
namespace wcam::testing {

/// A cancelled job must come back within this time (DESIGN 4).
#ifdef WCAM_SANITIZED  // instrumented code is some twenty times slower
inline constexpr std::chrono::milliseconds kCancelTime{4000};
#else
inline constexpr std::chrono::milliseconds kCancelTime{200};
#endif

namespace detail {

[[noreturn]] inline void broken(const std::string& component, const std::string& rule) {
  throw Error(ErrorCode::CheckFailed, rule, "component " + component,
              "see the rules in plugin-sdk.md");
}

/// A locale with a decimal comma while the object lives, where the system has one.
class ForeignLocale {
public:
  ForeignLocale() : before_(std::setlocale(LC_ALL, nullptr)) {
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "fr_FR.utf8", "C.UTF-8"}) {
      if (std::setlocale(LC_ALL, name) != nullptr) {
        break;
      }
    }
  }

  ~ForeignLocale() { std::setlocale(LC_ALL, before_.c_str()); }

  ForeignLocale(const ForeignLocale&) = delete;
  ForeignLocale& operator=(const ForeignLocale&) = delete;

private:
  std::string before_;
};

/// Greatest deviation of the length of a unit vector of doubles after a few operations.
inline constexpr double kUnitTolerance = 1e-9;

inline void checkInfo(const plugin::ComponentInfo& info) {
  if (!isValidId(info.id) || info.id.find('.') == std::string::npos) {
    broken(info.id, "the id is not reverse DNS");
  }
  if (trimText(info.name).empty() || trimText(info.summary).empty()) {
    broken(info.id, "name and summary must not be empty");
  }
  if (info.version < 1) {
    broken(info.id, "the version is below 1");
  }
  const std::vector<std::string> problems = plugin::schemaProblems(info.params);
  if (!problems.empty()) {
    broken(info.id, "the parameters are not sound: " + joinText(problems, "; "));
  }
}

inline std::string fingerprint(const std::vector<plugin::OutputFile>& files) {
  std::string all;
  for (const plugin::OutputFile& file : files) {
    all += file.name + '\0' + std::to_string(file.content.size()) + '\0' + file.content;
  }
  return all;
}

/// The exact bits of every number of a slicing result.
inline std::string fingerprint(const toolpath::SlicedLayers& sliced) {
  std::string all;
  const auto number = [&all](double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    all.append(reinterpret_cast<const char*>(&bits), sizeof bits);
  };
  const auto vector = [&number](const geometry::Vec3& v) {
    number(v.x());
    number(v.y());
    number(v.z());
  };
  for (const toolpath::SlicedLayer& layer : sliced.layers) {
    number(layer.level);
    vector(layer.up);
    number(layer.nominalHeight);
    number(static_cast<double>(layer.contours.size()));
    for (const toolpath::Contour& contour : layer.contours) {
      number(contour.closed ? 1.0 : 0.0);
      number(contour.part);
      number(static_cast<double>(contour.points.size()));
      for (const toolpath::ContourPoint& point : contour.points) {
        vector(point.p);
        vector(point.n);
      }
    }
  }
  return all;
}

/// Runs a job with a stop request at once, and with one that comes while it runs.
template <class Run>
void checkCancel(const std::string& component, const Run& run) {
  const auto cancelledInTime = [&](std::chrono::microseconds delay) {
    std::stop_source stop;
    std::chrono::steady_clock::time_point asked = std::chrono::steady_clock::now();
    std::jthread canceller;
    if (delay.count() == 0) {
      stop.request_stop();
    } else {
      canceller = std::jthread([&stop, &asked, delay] {
        std::this_thread::sleep_for(delay);
        asked = std::chrono::steady_clock::now();
        stop.request_stop();
      });
    }
    bool cancelled = false;
    try {
      run(JobContext(stop.get_token()));
    } catch (const CancelledError&) {
      cancelled = true;
    }
    const auto end = std::chrono::steady_clock::now();
    if (canceller.joinable()) {
      canceller.join();
    }
    if (delay.count() == 0 && !cancelled) {
      broken(component, "a job that is cancelled before it starts must throw CancelledError");
    }
    if (cancelled && end - asked > kCancelTime) {
      broken(component, "a cancel was answered after more than " +
                            std::to_string(kCancelTime.count()) + " ms");
    }
  };
  cancelledInTime(std::chrono::microseconds(0));
  for (const int delay : {200, 2000, 20000}) {
    cancelledInTime(std::chrono::microseconds(delay));
  }
}

/// Progress between 0 and 1, never backwards.
template <class Run>
void checkProgress(const std::string& component, const Run& run) {
  double last = 0.0;
  bool sound = true;
  run(JobContext({}, [&](double fraction, const std::string&) {
    sound = sound && fraction >= last && fraction <= 1.0;
    last = fraction;
  }));
  if (!sound) {
    broken(component, "progress left [0, 1] or went backwards");
  }
}

/// The same bytes again, with 1, 2 and 8 threads, and under another locale.
template <class Run>
void checkReproducible(const std::string& component, const Run& run) {
  const std::string first = fingerprint(run(JobContext()));
  if (fingerprint(run(JobContext())) != first) {
    broken(component, "a second run gives another result");
  }
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    if (fingerprint(run(JobContext())) != first) {
      broken(component, "the result depends on the number of threads");
    }
  }
  const ForeignLocale locale;
  if (fingerprint(run(JobContext())) != first) {
    broken(component, "the result depends on the locale");
  }
}

}  // namespace detail

/// Checks a post-processor with its default parameters: sound declaration, files for a sample
/// program without "nan" and "inf", cancel, progress, repeatability; also a program without a
/// positioner.
inline void checkPost(const plugin::PostComponent& component) {
  const std::string& id = component.info.id;
  detail::checkInfo(component.info);
  const Value params = component.info.params.complete(Value::object(), id);
  const program::Program sample = sampleProgram();
  const auto run = [&](const JobContext& context) {
    return component.post->post(sample, params, context);
  };
  for (const int positionerJoints : {0, 2}) {
    SampleOptions options;
    options.positionerJoints = positionerJoints;
    // The host refuses empty files and values that are no numbers.
    (void)component.post->post(sampleProgram(options), params, JobContext());
  }
  detail::checkReproducible(id, run);
  detail::checkProgress(id, run);
  detail::checkCancel(id, run);
}

/// Checks a strategy with its default parameters on the given input, which it must be able to
/// slice: sound declaration, at least one layer with a contour, unit normals, cancel, progress,
/// repeatability.
inline void checkSlicing(const plugin::SlicingComponent& component,
                         const plugin::SliceInput& input) {
  const std::string& id = component.info.id;
  detail::checkInfo(component.info);
  const Value params = component.info.params.complete(Value::object(), id);
  const auto run = [&](const JobContext& context) {
    return component.strategy->slice(input, params, context);
  };
  bool deposits = false;
  for (const toolpath::SlicedLayer& layer : run(JobContext()).layers) {
    deposits = deposits || !layer.contours.empty();
    for (const toolpath::Contour& contour : layer.contours) {
      const bool unit =
          std::all_of(contour.points.begin(), contour.points.end(), [](const auto& point) {
            return std::abs(point.n.norm() - 1.0) <= detail::kUnitTolerance;
          });
      if (!unit) {
        detail::broken(id, "a normal is not of length 1");
      }
    }
  }
  if (!deposits) {
    detail::broken(id, "the default parameters give no contour on this input");
  }
  detail::checkReproducible(id, run);
  detail::checkProgress(id, run);
  detail::checkCancel(id, run);
}

}  // namespace wcam::testing
