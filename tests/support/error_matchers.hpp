// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace wcam::testing {

/// Message, context and hint of the error that a call throws: "what | hint". Fails the test when it
/// throws none or one with another code.
template <class Call>
std::string errorOf(ErrorCode code, const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_STREQ(toString(error.code()), toString(code)) << error.what();
    return std::string(error.what()) + " | " + error.hint();
  }
  ADD_FAILURE() << "no error";
  return {};
}

}  // namespace wcam::testing
