// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/project_file.hpp"

#include "wcam/base/file_io.hpp"
#include "wcam/base/sha256.hpp"

#include "sample_project.hpp"

#include <chrono>

namespace wcam::project {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::vector<std::string> codesOf(const std::vector<Diagnostic>& findings) {
  std::vector<std::string> codes;
  for (const Diagnostic& finding : findings) {
    codes.push_back(finding.code);
  }
  return codes;
}

std::string canonicalSample() {
  return toCanonicalJson(sampleTree());
}

class ProjectFile : public ::testing::Test {
protected:
  TestFolder folder_;
  std::filesystem::path file_ = folder_ / "élbow 1.wcam";
};

TEST_F(ProjectFile, SavingALoadedFileChangesNoByte) {
  writeFileAtomically(file_, canonicalSample());
  const LoadedProject loaded = loadProject(file_);
  EXPECT_FALSE(loaded.migrated);
  EXPECT_EQ(checkCanonical(file_), "");
  saveProject(loaded.document, file_);
  EXPECT_EQ(readFile(file_), canonicalSample());
}

TEST_F(ProjectFile, TellsWhereAFileIsNotCanonical) {
  std::string text = canonicalSample();
  text.insert(text.find("\"name\""), " ");
  writeFileAtomically(file_, text);
  EXPECT_THAT(checkCanonical(file_), HasSubstr("line 4"));
  writeFileAtomically(file_, canonicalSample() + "\n");
  EXPECT_THAT(checkCanonical(file_), HasSubstr("saving would change"));
}

TEST_F(ProjectFile, BadFilesAreNamed) {
  const std::string name = pathText(file_);
  EXPECT_THAT(errorOf(ErrorCode::InputNotFound, [&] { (void)loadProject(file_); }),
              HasSubstr(name));
  for (const char* text :
       {"", " \n", "{", "nonsense", "{\"format\": \"wcam-project\"", "\xff\xfe", "[1,]"}) {
    writeFileAtomically(file_, text);
    EXPECT_THAT(errorOf(ErrorCode::InputInvalid, [&] { (void)loadProject(file_); }),
                HasSubstr(name));
  }
  for (const char* text : {"1", "[]", "{}", "\"wcam-project\"", "null"}) {
    writeFileAtomically(file_, text);
    EXPECT_THAT(errorOf(ErrorCode::ProjectInvalid, [&] { (void)loadProject(file_); }),
                HasSubstr(name));
  }
  EXPECT_THAT(errorOf(ErrorCode::InputInvalid, [&] { (void)loadProject(folder_.path()); }),
              HasSubstr("folder"));
}

TEST_F(ProjectFile, EveryTruncationIsRefused) {
  const std::string text = canonicalSample();
  // Without the last line feed the file is still complete.
  for (std::size_t size = 0; size + 2 < text.size(); size += 7) {
    EXPECT_THROW((void)parseProject(std::string_view(text).substr(0, size), file_), Error) << size;
  }
}

TEST_F(ProjectFile, NewerVersionOpensReadOnlyAndIsNotSaved) {
  const std::string text = toCanonicalJson(sampleTree().set("format_version", 2));
  writeFileAtomically(file_, text);
  const LoadedProject loaded = loadProject(file_);
  EXPECT_TRUE(loaded.document.readOnly());
  EXPECT_THAT(codesOf(loaded.findings), ElementsAre("project.newer_version"));
  EXPECT_THAT(errorOf(ErrorCode::ProjectReadOnly, [&] { saveProject(loaded.document, file_); }),
              HasSubstr("newer version"));
  autosave(loaded.document, file_);
  EXPECT_FALSE(std::filesystem::exists(autosavePath(file_)));
  EXPECT_EQ(readFile(file_), text);
}

std::vector<Migration> fakeMigrations() {
  return {{0, "'title' is now 'name'", [](Value tree) {
             const Value title = tree.at("title");
             tree.remove("title");
             return tree.set("name", title);
           }}};
}

TEST_F(ProjectFile, OlderVersionIsMigratedInMemory) {
  const std::string text =
      "{\"format\": \"wcam-project\", \"format_version\": 0, \"title\": \"old\", \"x_1\": 1}";
  writeFileAtomically(file_, text);
  const LoadedProject loaded = loadProject(file_, fakeMigrations());
  EXPECT_TRUE(loaded.migrated);
  EXPECT_FALSE(loaded.document.readOnly());
  EXPECT_EQ(loaded.document.project().name, "old");
  EXPECT_EQ(loaded.document.project().formatVersion, 1);
  EXPECT_FALSE(loaded.document.tree().contains("title"));
  EXPECT_TRUE(loaded.document.tree().contains("x_1"));
  ASSERT_THAT(codesOf(loaded.findings), ElementsAre("project.migrated"));
  EXPECT_THAT(loaded.findings[0].message, HasSubstr("'title' is now 'name'"));
  EXPECT_EQ(readFile(file_), text) << "opening an old file must not rewrite it";
  saveProject(loaded.document, file_);
  EXPECT_FALSE(loadProject(file_, fakeMigrations()).migrated);
}

TEST_F(ProjectFile, OlderVersionThatBreaksItsRulesIsNamed) {
  writeFileAtomically(file_, "{\"format\": \"wcam-project\", \"format_version\": 0}");
  EXPECT_THAT(
      errorOf(ErrorCode::ProjectInvalid, [&] { (void)loadProject(file_, fakeMigrations()); }),
      AllOf(HasSubstr("format version 0"), HasSubstr("'title'"), HasSubstr(pathText(file_))));
  EXPECT_THAT(errorOf(ErrorCode::ProjectInvalid, [&] { (void)loadProject(file_); }),
              HasSubstr("format version 0 is not known"));
}

TEST_F(ProjectFile, SaveThatFailsKeepsTheOldFile) {
  writeFileAtomically(file_, canonicalSample());
  const auto missing = folder_ / "nowhere/x.wcam";
  EXPECT_THAT(errorOf(ErrorCode::OutputConflict, [&] { saveProject(Document(), missing); }),
              HasSubstr(pathText(missing)));
  EXPECT_EQ(readFile(file_), canonicalSample());
}

TEST_F(ProjectFile, AutosaveIsOfferedOnlyWhenItIsNewer) {
  using std::chrono::seconds;
  const Document saved = Document::empty("saved");
  const Document edited = Document::empty("edited");
  EXPECT_EQ(autosavePath(file_).filename(), ".élbow 1.wcam.autosave");
  EXPECT_EQ(autosavePath(file_).parent_path(), folder_.path());
  autosave(edited, file_);
  ASSERT_TRUE(recoverable(file_)) << "a project that was never saved";
  saveProject(saved, file_);
  EXPECT_TRUE(std::filesystem::exists(autosavePath(file_))) << "it is the window's";
  dropAutosave(file_);
  EXPECT_FALSE(recoverable(file_));
  autosave(saved, file_);
  EXPECT_FALSE(recoverable(file_)) << "the same content";
  autosave(edited, file_);
  const auto found = recoverable(file_);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->document, edited);
  EXPECT_EQ(found->file, file_);
  const auto time = std::filesystem::last_write_time(file_);
  std::filesystem::last_write_time(autosavePath(file_), time - seconds(5));
  EXPECT_FALSE(recoverable(file_)) << "older than the file";
  writeFileAtomically(autosavePath(file_), "{\"damaged\"");
  EXPECT_FALSE(recoverable(file_));
  dropAutosave(file_);
  EXPECT_FALSE(std::filesystem::exists(autosavePath(file_)));
  dropAutosave(file_);
}

class UsedFiles : public ProjectFile {
protected:
  void SetUp() override {
    for (const char* name :
         {"cells/arcmate.json", "elbow.step", "base.stl", "guide.csv", "processes/shop.json"}) {
      createFolder((folder_ / name).parent_path());
      writeFileAtomically(folder_ / name, name);
    }
  }
};

TEST_F(UsedFiles, AreListedWithTheirOwners) {
  std::vector<std::string> lines;
  for (const UsedFile& file : usedFiles(sampleDocument())) {
    lines.push_back(file.owner.str() + " " + file.jsonPath + " " + file.ref.path);
  }
  EXPECT_THAT(lines,
              ElementsAre("cell cell cells/arcmate.json", "part 'elbow' parts[0].file elbow.step",
                          "part 'base.part' parts[1].file base.stl",
                          "guide 'line' guides[3].file guide.csv",
                          "process 'shop' processes[1].file processes/shop.json"));
}

TEST_F(UsedFiles, AreResolvedFromTheProjectFolder) {
  EXPECT_EQ(resolvePath("/a/b/x.wcam", {"c/../d.step", ""}), "/a/b/d.step");
  EXPECT_EQ(resolvePath("x.wcam", {"d.step", ""}), "d.step");
  EXPECT_EQ(resolvePath("/a/x.wcam", {"/d.step", ""}), "/d.step");
  EXPECT_THAT(checkFiles(sampleDocument(), file_), IsEmpty());
}

TEST_F(UsedFiles, AllMissingOnesAreNamedWithTheirOwners) {
  std::filesystem::remove(folder_ / "elbow.step");
  std::filesystem::remove(folder_ / "guide.csv");
  std::filesystem::create_directory(folder_ / "guide.csv");
  EXPECT_THAT(
      errorOf(ErrorCode::InputNotFound, [&] { (void)checkFiles(sampleDocument(), file_); }),
      AllOf(HasSubstr("part 'elbow' needs the file 'elbow.step'"), HasSubstr("guide 'line'"),
            HasSubstr(pathText(folder_ / "elbow.step")), Not(HasSubstr("base.stl"))));
}

TEST_F(UsedFiles, ChangedContentIsAFinding) {
  Value tree = sampleTree();
  tree.findMutable("parts")->mutableArray()[0].findMutable("file")->set("sha256",
                                                                        sha256Hex("elbow.step"));
  tree.findMutable("parts")->mutableArray()[1].findMutable("file")->set("sha256", sha256Hex("old"));
  const auto findings = checkFiles(Document::parse(tree), file_);
  ASSERT_THAT(codesOf(findings), ElementsAre("project.hash_changed"));
  EXPECT_THAT(findings[0].message, AllOf(HasSubstr("part 'base.part'"), HasSubstr("base.stl")));
  EXPECT_EQ(findings[0].severity, Severity::Warning);
}

TEST_F(UsedFiles, AreHashed) {
  const auto hashes = hashFiles(sampleDocument(), file_);
  EXPECT_EQ(hashes.size(), 5U);
  EXPECT_EQ(hashes.at("base.stl"), sha256Hex("base.stl"));
}

}  // namespace
}  // namespace wcam::project
