// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory_resource>

namespace wcam {

/// Memory in large pages where the system has them: a hundred megabytes that are written once cost
/// tenths of a second in page faults otherwise. What is smaller than a large page comes from the
/// heap. Stateless, may be shared between threads.
class LargePages : public std::pmr::memory_resource {
public:
  static constexpr std::size_t kPage = std::size_t{1} << 21;

private:
  void* do_allocate(std::size_t bytes, std::size_t alignment) override;
  void do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) override;
  [[nodiscard]] bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override;
};

}  // namespace wcam
