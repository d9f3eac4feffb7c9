// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/budget.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/text.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>

namespace wcam {

namespace {

constexpr const char* kVariable = "WCAM_BUDGET";

constexpr std::array kItems = {
    BudgetItem{"memory_mb", &Budget::memoryMb, "memory of the program, MiB"},
    BudgetItem{"file_mb", &Budget::fileMb, "size of one input file, MiB"},
    BudgetItem{"json_values", &Budget::jsonValues, "values of one JSON file"},
    BudgetItem{"layers", &Budget::layers, "layers of one operation"},
    BudgetItem{"points", &Budget::points, "points of the path of one operation"},
    BudgetItem{"parts", &Budget::parts, "parts of one operation"},
};

const BudgetItem* itemOf(std::string_view key) noexcept {
  const auto* it = std::find_if(kItems.begin(), kItems.end(),
                                [key](const BudgetItem& item) { return key == item.key; });
  return it != kItems.end() ? it : nullptr;
}

std::string itemNames() {
  std::vector<std::string> names;
  for (const BudgetItem& item : kItems) {
    names.emplace_back(item.key);
  }
  return joinText(names, ", ");
}

/// The one budget of the process.
Budget& current() {
  static Budget budget = [] {
    const char* text = std::getenv(kVariable);
    return parseBudget(text != nullptr ? text : "");
  }();
  return budget;
}

}  // namespace

std::span<const BudgetItem> budgetItems() noexcept {
  return kItems;
}

const Budget& budget() {
  return current();
}

Budget parseBudget(std::string_view words, const Budget& before) {
  Budget budget = before;
  for (const std::string& word : splitText(words, ',')) {
    const std::string_view item = trimText(word);
    if (item.empty()) {
      continue;
    }
    const std::size_t equal = item.find('=');
    const BudgetItem* known = itemOf(trimText(item.substr(0, equal)));
    const std::string_view number =
        equal == std::string_view::npos ? std::string_view() : trimText(item.substr(equal + 1));
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (known == nullptr || number.empty() || error != std::errc{} ||
        end != number.data() + number.size() || value == 0) {
      throw Error(ErrorCode::InvalidArgument,
                  text("'%1' is no item of the budget", {std::string(item)}), "budget",
                  text("write KEY=N with a whole number above 0; keys: %1", {itemNames()}));
    }
    budget.*known->member = value;
  }
  return budget;
}

void setBudget(std::string_view words) {
  Budget& budget = current();
  budget = parseBudget(words, budget);
  std::string all;
  for (const BudgetItem& item : kItems) {
    all += (all.empty() ? "" : ",") + std::string(item.key) + "=" +
           std::to_string(budget.*item.member);
  }
  ::setenv(kVariable, all.c_str(), 1);
}

void requireBudget(
    std::uint64_t count, const char* key, const Text& what, const Text& place, ErrorCode code) {
  const BudgetItem* item = itemOf(key);
  WCAM_ASSERT(item != nullptr);
  const std::uint64_t most = budget().*item->member;
  if (count > most) {
    throw Error(code, text("%1; the budget is %2", {what, std::to_string(most)}), place,
                text("make it less, or raise the budget: WCAM_BUDGET=%1=%2",
                     {std::string(key), std::to_string(count)}));
  }
}

void limitMemory() {
#ifndef WCAM_SANITIZED  // shadow memory is larger than any machine
  const auto machine = static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) *
                       static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  const auto most = static_cast<rlim_t>(std::min(budget().memoryMb << 20U, machine));

  struct rlimit limit {};

  // What the program writes: address space that it only reserves does not count.
  if (::getrlimit(RLIMIT_DATA, &limit) == 0 &&
      (limit.rlim_cur == RLIM_INFINITY || limit.rlim_cur > most)) {
    limit.rlim_cur = most;
    ::setrlimit(RLIMIT_DATA, &limit);
  }
#endif
}

Error outOfMemory() {
  return Error(ErrorCode::JobFailed,
               text("the run needs more than the %1 MiB of memory that it may take",
                    {std::to_string(budget().memoryMb)}),
               {},
               "use a coarser part, step or spacing; with more memory in the machine, raise "
               "memory_mb in WCAM_BUDGET");
}

}  // namespace wcam
