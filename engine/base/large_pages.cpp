// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/large_pages.hpp"

#include <sys/mman.h>

#include <algorithm>

namespace wcam {

namespace {

std::size_t alignmentOf(std::size_t bytes, std::size_t alignment) {
  return bytes >= LargePages::kPage ? std::max(LargePages::kPage, alignment) : alignment;
}

}  // namespace

void* LargePages::do_allocate(std::size_t bytes, std::size_t alignment) {
  void* memory = std::pmr::new_delete_resource()->allocate(bytes, alignmentOf(bytes, alignment));
  if (bytes >= kPage) {
    // A wish: where it is not granted, the memory works all the same.
    (void)::madvise(memory, bytes / kPage * kPage, MADV_HUGEPAGE);
  }
  return memory;
}

void LargePages::do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) {
  std::pmr::new_delete_resource()->deallocate(memory, bytes, alignmentOf(bytes, alignment));
}

bool LargePages::do_is_equal(const std::pmr::memory_resource& other) const noexcept {
  return dynamic_cast<const LargePages*>(&other) != nullptr;
}

}  // namespace wcam
