// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "read_job.hpp"

namespace wcam::test {

/// Reads KRL programs, following calls from the first one. Files are given as (file name, text).
ReadJob readKrl(const std::vector<std::pair<std::string, std::string>>& files, int arcOutput = 1);

}  // namespace wcam::test
