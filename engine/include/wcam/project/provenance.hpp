// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/project/run.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace wcam::project {

/// What a run is made from: {"wcam", "project" with "file" and "sha256", "inputs" with "path" and
/// "sha256", "plugins" with "id", "version", "origin", "file" and "sha256", "settings"}. The hash
/// of the project is that of its canonical text, before the settings of the run.
Value provenance(const Pipeline& pipeline,
                 const RunRequest& request,
                 const std::vector<std::string>& operations,
                 const std::vector<Output>& outputs);

/// Is an output folder whole: the files of its report are there, unchanged, and no others? Given a
/// pipeline, also: is it made from that project, these settings, inputs, plugins and this version?
/// @return findings `output.*`, violations where programs must not be used as they are
/// @throws Error(InputNotFound / InputInvalid) when the folder has no report that can be read
std::vector<Diagnostic> checkOutputs(const std::filesystem::path& folder,
                                     const Pipeline* pipeline,
                                     const RunRequest& request);

}  // namespace wcam::project
