// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace wcam {

/// How much one run may take. What exceeds it is refused with its figure, before the memory of the
/// machine ends. Everything that a file can make large is counted here and nowhere else.
struct Budget {
  std::uint64_t memoryMb = 8192;         ///< memory of the program, MiB
  std::uint64_t fileMb = 4096;           ///< one input file, MiB
  std::uint64_t jsonValues = 5'000'000;  ///< values of one JSON file
  std::uint64_t layers = 1'000'000;      ///< of one operation
  std::uint64_t points = 20'000'000;     ///< of the path of one operation
  std::uint64_t parts = 20'000;          ///< of one operation
};

/// A member of the budget with its name in WCAM_BUDGET and `--budget`.
struct BudgetItem {
  const char* key;
  std::uint64_t Budget::*member;
  const char* help;
};

std::span<const BudgetItem> budgetItems() noexcept;

/// The budget of this process: the defaults, changed by what the environment variable WCAM_BUDGET
/// says when it is first asked for, such as "memory_mb=4096,points=1000000".
const Budget& budget();

/// Reads such a text. @throws Error(InvalidArgument) naming the item
Budget parseBudget(std::string_view text, const Budget& before = {});

/// Sets the budget of this process and of the programs it starts.
/// @throws Error(InvalidArgument) naming the item
void setBudget(std::string_view text);

/// Throws Error(code) when there is more of something than the budget has, such as "the path has
/// 30000000 points; the budget is 20000000".
/// @param what a whole sentence with the count in it
void requireBudget(std::uint64_t count,
                   const char* key,
                   const Text& what,
                   const Text& place,
                   ErrorCode code = ErrorCode::InputInvalid);

/// Makes memory beyond the budget (or the machine's) unobtainable, so that it ends in
/// std::bad_alloc rather than in the death of other programs.
void limitMemory();
/// What to say when it has come to that.
Error outOfMemory();

}  // namespace wcam
