// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

namespace wcam::io {

enum class FileFormat { Step, Iges, BrepText, BrepBinary, Stl, Obj, Ply, ThreeMf, Formula };

/// Name for messages and reports: "STEP", "IGES", "BREP", "STL", "OBJ", "PLY", "3MF",
/// "formula".
const char* toString(FileFormat format) noexcept;

/// By content where the format has a signature, else by extension.
/// @throws Error(InputInvalid) naming the file, what its extension promises and what is known
FileFormat detectFormat(const std::filesystem::path& file, std::string_view bytes);

}  // namespace wcam::io
