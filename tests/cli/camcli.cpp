// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "camcli.hpp"

#include "wcam/base/text.hpp"
#include "wcam/project/project_file.hpp"

#include "quick_motion.hpp"

#include <algorithm>
#include <stdexcept>

namespace wcam::testing {

namespace fs = std::filesystem;

Files filesBelow(const fs::path& folder) {
  Files files;
  if (fs::exists(folder)) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.is_regular_file()) {
        files[fs::relative(entry.path(), folder).native()] = readFile(entry.path());
      }
    }
  }
  return files;
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << "no '" << from << "' in\n" << text;
  while (place != std::string::npos) {
    text.replace(place, from.size(), to);
    place = text.find(from, place + to.size());
  }
  return text;
}

fs::path shippedExample(const std::string& name) {
  return fs::path(WCAM_RESOURCES) / "projects" / name;
}

fs::path exampleFolder(const std::string& name) {
  static const TestFolder folder;
  const fs::path target = folder / name;
  if (!fs::exists(target)) {
    fs::copy(shippedExample(name), target, fs::copy_options::recursive);
    for (const auto& entry : fs::recursive_directory_iterator(target)) {
      fs::permissions(entry.path(), fs::perms::owner_write, fs::perm_options::add);
    }
    const fs::path project = target / (name + ".wcam");
    writeFileAtomically(project,
                        test::withQuickMotion(project::loadProject(project).document).text());
  }
  return target;
}

std::size_t Table::column(const std::string& name) const {
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end()) {
    throw std::out_of_range("the table has no column " + name);
  }
  return static_cast<std::size_t>(found - columns.begin());
}

double Table::number(std::size_t row, const std::string& name) const {
  const std::string& text = rows.at(row).at(column(name));
  const auto number = parseReal(text);
  if (!number) {
    throw std::invalid_argument("'" + text + "' in column " + name + " is no number");
  }
  return *number;
}

Table readTable(const fs::path& file) {
  const std::string text = readFile(file);
  EXPECT_TRUE(text.ends_with('\n'));
  EXPECT_EQ(text.find('\r'), std::string::npos);
  std::vector<std::string> lines = splitText(text, '\n');
  lines.pop_back();
  Table table;
  table.header = lines.at(0);
  table.columns = splitText(table.header, ',');
  for (std::size_t i = 1; i < lines.size(); ++i) {
    table.rows.push_back(splitText(lines[i], ','));
    EXPECT_EQ(table.rows.back().size(), table.columns.size()) << lines[i];
  }
  return table;
}

ProcessResult CamcliTest::camcli(std::vector<std::string> arguments, ProcessRequest request) const {
  request.program = WCAM_CAMCLI;
  request.arguments = std::move(arguments);
  if (request.folder.empty()) {
    request.folder = folder_.path();
  }
  request.environment.emplace("XDG_DATA_HOME", (folder_ / "no-user-data").native());
  request.environment.emplace("WCAM_PLUGIN_PATH", "");
  ProcessResult result = runProcess(request);
  EXPECT_FALSE(result.timedOut) << result.err;
  return result;
}

fs::path CamcliTest::example(const std::string& name, const std::string& folder) const {
  const fs::path target = folder_ / (folder.empty() ? name : folder);
  fs::create_directories(target);
  fs::copy(exampleFolder(name), target, fs::copy_options::recursive);
  for (const auto& entry : fs::recursive_directory_iterator(target)) {
    fs::permissions(entry.path(), fs::perms::owner_write, fs::perm_options::add);
  }
  return target / (name + ".wcam");
}

fs::path CamcliTest::elbowWith(std::string_view from, std::string_view to) const {
  const fs::path project = example("elbow");
  writeFileAtomically(project, replaced(readFile(project), from, to));
  return project;
}

std::string CamcliTest::refusedRun(const fs::path& project,
                                   int exitCode,
                                   std::vector<std::string> more) const {
  const Files before = filesBelow(folder_.path());
  std::vector<std::string> arguments = {"--project", project.native(), "--output", "out",
                                        "--table"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const ProcessResult result = camcli(arguments);
  EXPECT_EQ(result.exitCode, exitCode) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_TRUE(result.err.starts_with("camcli: error: ")) << result.err;
  EXPECT_EQ(filesBelow(folder_.path()), before) << "files were written or changed";
  EXPECT_FALSE(fs::exists(folder_ / "out"));
  return result.err;
}

}  // namespace wcam::testing
