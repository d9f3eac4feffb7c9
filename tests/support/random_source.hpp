// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace wcam::testing {

/// Random numbers of a test: the same on every platform for the same seed (the distributions of the
/// standard library are not). Print seed() with every failure.
class RandomSource {
public:
  explicit RandomSource(std::uint64_t seed) : seed_(seed), engine_(seed) {}

  [[nodiscard]] std::uint64_t seed() const noexcept { return seed_; }

  /// 0 … count − 1
  std::size_t below(std::size_t count) { return count == 0 ? 0 : engine_() % count; }

  bool chance(double probability) { return real(0.0, 1.0) < probability; }

  double real(double from, double to) {
    return from + (to - from) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }

  std::uint64_t bits() { return engine_(); }

  template <class T>
  const T& pick(const std::vector<T>& items) {
    return items[below(items.size())];
  }

private:
  std::uint64_t seed_;
  std::mt19937_64 engine_;
};

/// Seeds of a property test: a fixed range, or only the one in WCAM_TEST_SEED to look at a failure.
inline std::vector<std::uint64_t> testSeeds(std::uint64_t count) {
  if (const char* seed = std::getenv("WCAM_TEST_SEED")) {
    return {std::strtoull(seed, nullptr, 10)};
  }
  std::vector<std::uint64_t> seeds;
  for (std::uint64_t i = 1; i <= count; ++i) {
    seeds.push_back(i);
  }
  return seeds;
}

}  // namespace wcam::testing
