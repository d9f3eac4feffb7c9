// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wcam::program {

/// A name that a robot controller accepts: letters, digits and '_', beginning with a letter, upper
/// case, at most `maxLength` characters (at least 6). Latin letters lose their marks (toAscii),
/// other foreign characters become '_'. A longer name ends in
/// '_' and three characters of its hash, so that names that begin alike stay different.
/// @param fallback used when nothing of the text is left
std::string controllerName(std::string_view text,
                           std::size_t maxLength,
                           std::string_view fallback = "PROGRAM");

/// What names of a controller's programs have to keep to.
struct NameRules {
  std::size_t longest = 8;  ///< characters
  /// Words of the language and of its system programs, in capitals: they do not compile as names,
  /// or hide what is called.
  std::span<const std::string_view> reserved = {};
};

/// True for a word of the language and for a device of Windows (CON, AUX, COM1, …), whose name no
/// file may bear. `name` as controllerName() gives it.
bool isReserved(std::string_view name, const NameRules& rules);

/// Names of a main program and its numbered parts, all different: the main name, then
/// <name>_1, <name>_2, … with numbers of equal width. A reserved name gets P_ in front.
/// @throws Error(InvalidArgument) when the longest name leaves no room for the numbers
std::vector<std::string> partNames(std::string_view text,
                                   std::size_t parts,
                                   const NameRules& rules);

/// True where a name differs from the wanted one by capitals alone, and by '_' for blanks, hyphens
/// and points: what everybody expects.
bool keepsName(std::string_view text, std::string_view name);

/// ASCII text for comments (toAscii): characters without a spelling become '?', control characters
/// blanks.
std::string asciiComment(std::string_view text);
/// Cut into pieces of at most `width` characters, at blanks where possible.
std::vector<std::string> wrapComment(std::string_view text, std::size_t width);

}  // namespace wcam::program
