// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/file_io.hpp"

#include "cad_process.hpp"
#include "cad_transfer.hpp"
#include "file_bytes.hpp"
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <new>

namespace wcam::io {

namespace {

constexpr std::size_t kMebibyte = std::size_t{1} << 20U;
/// Processor time, seconds: a healthy file of a mebibyte is read in about one.
constexpr std::size_t kBaseSeconds = 600;
constexpr std::size_t kSecondsPerMebibyte = 60;
/// Memory: healthy files need some twenty times their size, and their triangles.
constexpr std::size_t kBaseMemory = 8192 * kMebibyte;
constexpr std::size_t kMemoryPerByte = 256;
constexpr auto kProgressInterval = std::chrono::milliseconds(20);

void limit(int resource, std::size_t most) {
  struct rlimit current {};

  getrlimit(static_cast<__rlimit_resource>(resource), &current);
  if (current.rlim_cur == RLIM_INFINITY || current.rlim_cur > most) {
    current.rlim_cur = most;
    setrlimit(static_cast<__rlimit_resource>(resource), &current);
  }
}

void limitResources(std::size_t fileSize) {
  limit(RLIMIT_CPU, kBaseSeconds + kSecondsPerMebibyte * (fileSize / kMebibyte));
  limit(RLIMIT_CORE, 0);
#ifndef WCAM_SANITIZED  // shadow memory is larger than any machine
  const std::size_t machine = static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) *
                              static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  limit(RLIMIT_AS, std::min(machine, kBaseMemory + kMemoryPerByte * fileSize));
#endif
}

/// Writes one frame; ends the process when nobody listens any more.
void send(FrameKind kind, std::string_view content) {
  std::string frame(1, static_cast<char>(kind));
  const std::uint64_t length = content.size();
  frame.append(reinterpret_cast<const char*>(&length), sizeof(length));
  for (std::string_view rest : {std::string_view(frame), content}) {
    while (!rest.empty()) {
      const ssize_t written = ::write(kWorkerAnswer, rest.data(), rest.size());
      if (written < 0 && errno != EINTR) {
        _exit(1);
      }
      rest.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
    }
  }
}

void work(const char* text) {
  const WorkerRequest request = decodeRequest(text);
  auto last = std::chrono::steady_clock::time_point{};
  const JobContext context({}, [&last](double fraction, const std::string& label) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last >= kProgressInterval) {
      last = now;
      send(FrameKind::Progress, encodeProgress(fraction, label));
    }
  });
  const FileBytes bytes(request.file, JobContext());
  limitResources(bytes.view().size());
  ImportReport report;
  report.format = toString(request.format);
  const ImportJob job{request.file, pathText(request.file), request.format, request.options,
                      request.T_part_file};
  const geometry::PartSurface surface = buildCadPart(bytes.view(), job, report, context);
  send(FrameKind::Result, encodePart(surface, report, context.diagnostics().items()));
}

}  // namespace

int runCadWorker(const char* request) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  try {
    work(request);
    return 0;
  } catch (const Error& error) {
    send(FrameKind::Failure, encodeError(error));
  } catch (const std::bad_alloc&) {
    send(FrameKind::Failure,
         encodeError(Error(ErrorCode::InputInvalid,
                           "the CAD file asks for more memory than it can need",
                           pathText(decodeRequest(request).file),
                           "the file is damaged, or the chord tolerance is too small for it")));
  } catch (const std::exception& error) {
    send(
        FrameKind::Failure,
        encodeError(Error(
            ErrorCode::InputInvalid, text("the CAD library fails on this file: %1", {error.what()}),
            pathText(decodeRequest(request).file), "the file is damaged; export the part again")));
  }
  return 1;
}

}  // namespace wcam::io
