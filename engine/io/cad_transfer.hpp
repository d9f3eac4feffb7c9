// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/diagnostic.hpp"
#include "wcam/base/error.hpp"
#include "wcam/geometry/part_surface.hpp"

#include "part_builder.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

// What the CAD worker and the engine tell each other. Both are the same build on the same machine,
// so numbers travel as they lie in memory.
namespace wcam::io {

/// Descriptor that the worker answers on; standard output belongs to the CAD library.
inline constexpr int kWorkerAnswer = 3;

enum class FrameKind : char { Progress = 'p', Result = 'r', Failure = 'f' };

/// What the worker is asked for: one argument of its command line.
std::string encodeRequest(const ImportJob& job);

/// A request with its own copies.
struct WorkerRequest {
  std::filesystem::path file;
  FileFormat format = FileFormat::Step;
  ImportOptions options;
  geometry::Pose T_part_file = geometry::Pose::Identity();
};

/// @throws Error(InvalidArgument)
WorkerRequest decodeRequest(std::string_view text);

/// A part with what buildCadPart() put into the report, and its findings.
std::string encodePart(const geometry::PartSurface& surface,
                       const ImportReport& report,
                       const std::vector<Diagnostic>& findings);

/// @throws Error(Internal) for bytes that encodePart() did not write
geometry::PartSurface decodePart(std::string_view bytes,
                                 ImportReport& report,
                                 std::vector<Diagnostic>& findings);

std::string encodeError(const Error& error);
Error decodeError(std::string_view bytes);

std::string encodeProgress(double fraction, const std::string& label);
std::pair<double, std::string> decodeProgress(std::string_view bytes);

}  // namespace wcam::io
