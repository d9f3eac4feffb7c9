// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wcam {

std::vector<std::string> splitText(std::string_view text, char separator);
std::string_view trimText(std::string_view text) noexcept;
std::string joinText(const std::vector<std::string>& parts, std::string_view separator);
/// Locale-free; the whole text must be a finite number.
std::optional<double> parseReal(std::string_view text) noexcept;
/// Fixed number of decimals, locale-free, "-0.000" written as "0.000".
std::string formatFixed(double number, int decimals);
/// The candidate with the smallest edit distance, when close enough to be a likely typing error.
std::optional<std::string> nearestName(std::string_view name,
                                       const std::vector<std::string>& candidates);
/// True for 1..64 characters of [a-z0-9_.-] that start with a letter or digit: ids in projects and
/// plugins.
bool isValidId(std::string_view id) noexcept;

}  // namespace wcam
