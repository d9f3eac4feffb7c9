// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace wcam::program {

/// UTF-8 text in ASCII: Latin letters lose their marks (é e, Ä A, ß ss, Œ OE), dashes, quotation
/// marks and the like become their plain form; what has none, as letters of other scripts, becomes
/// `unknown`, one for each character. Independent of the locale.
std::string toAscii(std::string_view text, char unknown);

}  // namespace wcam::program
