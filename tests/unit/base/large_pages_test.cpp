// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/large_pages.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>

namespace wcam {
namespace {

TEST(LargePages, smallAndLargeBlocksCanBeWrittenToTheirLastByte) {
  LargePages pages;
  for (const std::size_t bytes : {std::size_t{1}, std::size_t{100}, LargePages::kPage - 1,
                                  LargePages::kPage, 3 * LargePages::kPage + 7}) {
    for (const std::size_t alignment : {std::size_t{1}, std::size_t{64}}) {
      void* memory = pages.allocate(bytes, alignment);
      const auto address = reinterpret_cast<std::uintptr_t>(memory);
      EXPECT_EQ(address % alignment, 0U);
      if (bytes >= LargePages::kPage) {
        EXPECT_EQ(address % LargePages::kPage, 0U) << bytes;
      }
      std::memset(memory, 0x5A, bytes);
      EXPECT_EQ(static_cast<unsigned char*>(memory)[bytes - 1], 0x5A);
      pages.deallocate(memory, bytes, alignment);
    }
  }
}

TEST(LargePages, anyOfThemFreesWhatAnotherGave) {
  LargePages a;
  const LargePages b;
  EXPECT_TRUE(a.is_equal(b));
  EXPECT_FALSE(a.is_equal(*std::pmr::new_delete_resource()));
}

}  // namespace
}  // namespace wcam
