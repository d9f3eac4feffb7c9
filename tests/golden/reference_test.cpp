// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/motion/plan.hpp"
#include "wcam/toolpath/edits.hpp"

#include "example_project.hpp"
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

/// The reference page and the schemas under resources are written from the declarations of the
/// parameters (DESIGN 6). WCAM_UPDATE_GOLDEN=1 writes them anew.
namespace wcam {
namespace {

struct Section {
  std::string id;
  std::string title;
  ParamSchema schema;
};

std::vector<Section> sections() {
  std::vector<Section> all = {
      {"import", "Import of a part", io::importOptionsSchema().params()},
      {"path", "Path of an operation", toolpath::PathParams::schema().params()},
      {"process", "Deposition process", process::ProcessParams::schema().params()},
      {"motion", "Motion of an operation", motion::MotionParams::schema().params()}};
  for (const toolpath::EditTypeInfo& info : toolpath::editTypes()) {
    all.push_back({std::string("edit.") + info.key, std::string(info.name) + ". " + info.summary,
                   toolpath::editSchema(info.type).params()});
  }
  for (const plugin::ComponentEntry& component : test::hostOfPlugins()->components()) {
    if (component.id.starts_with("wcam.")) {
      const plugin::ComponentInfo info = test::hostOfPlugins()->info(component.id);
      all.push_back({info.id, info.name + ". " + info.summary, info.params});
    }
  }
  return all;
}

void expectFile(const std::filesystem::path& file, const std::string& wanted) {
  if (const char* update = std::getenv("WCAM_UPDATE_GOLDEN");
      update != nullptr && std::string(update) == "1") {
    createFolder(file.parent_path());
    writeFileAtomically(file, wanted);
  }
  EXPECT_EQ(readFile(file), wanted)
      << file << " is stale: run this test with WCAM_UPDATE_GOLDEN=1 and commit the change";
}

TEST(Reference, ParameterPageFollowsTheDeclarations) {
  std::string page =
      "# Parameters\n\nWritten from the declarations in the code. Numbers in files are in the unit "
      "given; `--set` takes any "
      "unit of the quantity (`step=0.1in`).\n";
  for (const Section& section : sections()) {
    page += "\n## " + section.id + "\n\n" + section.title + "\n\n" + section.schema.markdown();
  }
  expectFile(std::filesystem::path(WCAM_RESOURCES) / "doc" / "parameters.md", page);
}

TEST(Reference, SchemasFollowTheDeclarations) {
  for (const Section& section : sections()) {
    expectFile(std::filesystem::path(WCAM_RESOURCES) / "schema" / (section.id + ".schema.json"),
               toCanonicalJson(section.schema.jsonSchema(section.title)));
  }
}

}  // namespace
}  // namespace wcam
