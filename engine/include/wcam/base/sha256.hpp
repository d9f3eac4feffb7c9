// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace wcam {

/// Incremental SHA-256 with typed feeds, used for file identity and stage keys.
class Sha256 {
public:
  Sha256();
  ~Sha256();
  Sha256(Sha256&&) noexcept;
  Sha256& operator=(Sha256&&) noexcept;

  Sha256& bytes(const void* data, std::size_t size);
  /// Length-prefixed, so that ("ab","c") and ("a","bc") differ.
  Sha256& text(std::string_view text);
  Sha256& number(double number);
  Sha256& integer(std::int64_t number);
  /// 64 lower-case hexadecimal digits. The object can be fed no further.
  std::string hex();

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

std::string sha256Hex(std::string_view data);
/// @throws Error(InputNotFound) naming the file
std::string sha256OfFile(const std::filesystem::path& file);

}  // namespace wcam
