// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/value.hpp"

#include "process.hpp"
#include "test_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace wcam::testing {

using Files = std::map<std::string, std::string>;

/// Relative path and content of every file below a folder; empty when there is no such folder.
Files filesBelow(const std::filesystem::path& folder);

/// Text with every `from` replaced; fails the test when there is none.
std::string replaced(std::string text, std::string_view from, std::string_view to);

/// Folder of an example project as it comes with the program.
std::filesystem::path shippedExample(const std::string& name);
/// Folder with a copy of an example project with a constant rotation about the torch, which plans
/// quickly; the same one for the life of the process.
std::filesystem::path exampleFolder(const std::string& name);

/// Rows of a table by column name.
struct Table {
  std::string header;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;

  [[nodiscard]] std::size_t column(const std::string& name) const;
  [[nodiscard]] double number(std::size_t row, const std::string& name) const;
};

Table readTable(const std::filesystem::path& file);

/// A folder with copies of projects, and camcli in it.
class CamcliTest : public ::testing::Test {
protected:
  /// Runs camcli in the test's folder, away from the plugins and settings of the user.
  ProcessResult camcli(std::vector<std::string> arguments, ProcessRequest request = {}) const;
  /// Copies an example project (exampleFolder) below the test's folder. @return its project file
  std::filesystem::path example(const std::string& name, const std::string& folder = {}) const;
  /// A copy of the elbow with a changed text in its project file.
  std::filesystem::path elbowWith(std::string_view from, std::string_view to) const;
  /// Runs a project into `out`, expects the exit code, nothing on stdout and no file.
  std::string refusedRun(const std::filesystem::path& project,
                         int exitCode,
                         std::vector<std::string> more = {}) const;

  TestFolder folder_;
};

}  // namespace wcam::testing
