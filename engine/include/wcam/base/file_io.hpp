// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace wcam {

/// Whole file as bytes. @throws Error(InputNotFound / InputInvalid) naming the file
std::string readFile(const std::filesystem::path& file);

/// @throws Error(InputInvalid) for a file that is larger than the budget has for one
void requireFileSize(std::uint64_t bytes, const std::filesystem::path& file);

/// Replaces a file or leaves the old one untouched: temporary file beside it, fsync, rename, fsync
/// of the folder. @throws Error(OutputConflict) naming the file and the cause (no space, no
/// permission, ...)
void writeFileAtomically(const std::filesystem::path& file, std::string_view content);

/// Neither marked as read-only nor out of reach; a file that does not exist may be made.
bool mayReplace(const std::filesystem::path& file);

/// Creates a folder with its parents. @throws Error(OutputConflict)
void createFolder(const std::filesystem::path& folder);

/// UTF-8 text of a path, for messages and files.
std::string pathText(const std::filesystem::path& path);
/// Path from UTF-8 text.
std::filesystem::path pathFromText(std::string_view text);

}  // namespace wcam
