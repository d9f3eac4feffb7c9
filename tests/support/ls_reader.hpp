// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "read_job.hpp"

namespace wcam::test {

/// Reads FANUC TP programs in ASCII form, following CALL from the first one. Files are given as
/// (file name, text).
/// @param provenance the comments must say the frames that the program was planned with
ReadJob readLs(const std::vector<std::pair<std::string, std::string>>& files,
               std::size_t longestName = 36,
               bool provenance = true);

}  // namespace wcam::test
