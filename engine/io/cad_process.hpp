// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "part_builder.hpp"

namespace wcam::io {

/// buildCadPart() in a process of its own: a damaged file that makes the CAD library crash, loop or
/// ask for all memory ends in an error, and a cancel is answered at once whatever the library is
/// doing. The worker program stands beside the engine library in wcam/wcam-cad-worker; without it
/// the file is read in this process. The result is the same.
/// @throws Error, CancelledError
geometry::PartSurface buildCadPartApart(std::string_view bytes,
                                        const ImportJob& job,
                                        ImportReport& report,
                                        const JobContext& context);

/// The worker's program: reads the part that `request` asks for and answers on kWorkerAnswer.
/// @return exit code
int runCadWorker(const char* request);

}  // namespace wcam::io
