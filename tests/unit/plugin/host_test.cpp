// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/plugin/host.hpp"

#include "wcam/base/context.hpp"
#include "wcam/base/file_io.hpp"
#include "wcam/base/parallel.hpp"
#include "wcam/plugin/abi.h"
#include "wcam/plugin/locations.hpp"
#include "wcam/testing/sample_program.hpp"

#include "error_matchers.hpp"
#include "test_folder.hpp"
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

using namespace wcam;
using namespace wcam::plugin;
using ::testing::HasSubstr;
using wcam::testing::errorOf;
using wcam::testing::TestFolder;
namespace fs = std::filesystem;

namespace {

const fs::path kProbes = WCAM_PROBES;
const fs::path kBuiltIn = installedPluginFolder();

/// Sets an environment variable while it lives.
class Environment {
public:
  Environment(const char* name, const std::string& value) : name_(name) {
    const char* before = std::getenv(name);
    had_ = before != nullptr;
    before_ = had_ ? before : "";
    ::setenv(name, value.c_str(), 1);
  }

  ~Environment() { had_ ? ::setenv(name_, before_.c_str(), 1) : ::unsetenv(name_); }

  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

private:
  const char* name_;
  bool had_ = false;
  std::string before_;
};

PluginSearch only(std::vector<fs::path> files) {
  return {std::move(files), {}};
}

PluginSearch folders(std::initializer_list<fs::path> paths) {
  PluginSearch search;
  for (const fs::path& path : paths) {
    search.folders.push_back({path, PluginOrigin::Environment});
  }
  return search;
}

void copyPlugin(const fs::path& from, const std::string& name, const fs::path& to) {
  createFolder(to);
  for (const char* extension : {".so", ".json"}) {
    fs::copy_file(from / (name + extension), to / (name + extension));
  }
}

void replaceInFile(const fs::path& file, const std::string& from, const std::string& to) {
  std::string text = readFile(file);
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  writeFileAtomically(file, text.replace(at, from.size(), to));
}

fs::path probe(const std::string& name) {
  return kProbes / ("org.wcam.probe." + name + ".so");
}

}  // namespace

TEST(PluginHost, RefusesBrokenPluginsWithTheirReason) {
  const std::pair<const char*, const char*> cases[] = {
      {"wrong_abi", "built for plugin ABI 99.0, this program has 1.0; install a newer WCAM"},
      {"newer_abi", "built for plugin ABI 1.1, this program has 1.0; install a newer WCAM"},
      {"wrong_fingerprint", "eigen32;plain', this program with '"},
      {"no_entry", "no entry point wcam_plugin_entry"},
      {"null_descriptor", "returned no descriptor"},
      {"short_descriptor", "its descriptor has 8 bytes"},
      {"wrong_id",
       "the library says id 'org.wcam.probe.another', the manifest 'org.wcam.probe.wrong_id'"},
      {"wrong_version", "the library says version '2.0.0', the manifest '1.0.0'"},
      {"throwing_register", "its register function failed: an exception of unknown type"},
      {"throwing_factory", "the factory of component 'probe.throwing_factory' failed"},
      {"unregistered", "'probe.unregistered' of the manifest was not registered"},
      {"twice", "component 'probe.twice' is registered twice"},
      {"bad_schema", "'Bad Key' is not a snake_case key"},
  };
  for (const auto& [name, reason] : cases) {
    const PluginHost host(only({probe(name)}));
    ASSERT_EQ(host.reports().size(), 1U);
    EXPECT_EQ(host.reports()[0].verdict, PluginVerdict::Available) << name;
    const std::string id = std::string("probe.") + name;
    EXPECT_THAT(errorOf(ErrorCode::PluginRefused, [&] { (void)host.findPost(id); }),
                HasSubstr(reason));
    const PluginReport report = host.reports()[0];
    EXPECT_EQ(report.verdict, PluginVerdict::Refused) << name;
    EXPECT_EQ(report.id, std::string("org.wcam.probe.") + name);
    EXPECT_THAT(report.reason, HasSubstr(reason));
    EXPECT_TRUE(host.components().empty());
  }
}

TEST(PluginHost, OneBrokenPluginDoesNotHarmTheOthers) {
  PluginSearch search = folders({kProbes, kBuiltIn});
  const PluginHost host(search);
  host.loadAll();
  std::size_t refused = 0;
  for (const PluginReport& report : host.reports()) {
    refused += report.verdict == PluginVerdict::Refused ? 1 : 0;
    EXPECT_NE(report.verdict, PluginVerdict::Available) << report.id;
    EXPECT_EQ(report.reason.empty(), report.verdict == PluginVerdict::Loaded) << report.id;
  }
  // A factory that throws is found out only when its component is asked for.
  EXPECT_EQ(refused, 15U);
  EXPECT_NE(host.findPost("wcam.post.fanuc"), nullptr);
  EXPECT_NE(host.findSlicing("wcam.slicing.planar"), nullptr);
}

TEST(PluginHost, ReportsInTheOrderOfTheSearch) {
  const PluginHost host(folders({kBuiltIn}));
  std::vector<std::string> names;
  for (const PluginReport& report : host.reports()) {
    names.push_back(report.path.filename().string());
  }
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  EXPECT_GE(names.size(), 5U);
  const auto components = host.components();
  EXPECT_TRUE(std::is_sorted(components.begin(), components.end(),
                             [](const auto& a, const auto& b) { return a.id < b.id; }));
}

TEST(PluginHost, LoadsOnlyWhatIsNeeded) {
  const PluginHost host(folders({kBuiltIn}));
  (void)host.findPost("wcam.post.kuka");
  for (const PluginReport& report : host.reports()) {
    EXPECT_EQ(report.verdict == PluginVerdict::Loaded, report.id == "org.wcam.post.kuka")
        << report.id;
  }
}

TEST(PluginHost, ThreadsShareOneLibrary) {
  const PluginHost host(folders({kBuiltIn}));
  std::vector<std::shared_ptr<const PostComponent>> found(16);
  const ThreadLimit limit(8);
  parallelFor(found.size(), 1, [&](std::size_t i) {
    found[i] = host.findPost(i % 2 == 0 ? "wcam.post.kuka" : "wcam.post.fanuc");
    (void)host.reports();
  });
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_NE(found[i], nullptr);
    EXPECT_EQ(found[i]->plugin, i % 2 == 0 ? "org.wcam.post.kuka" : "org.wcam.post.fanuc");
  }
}

TEST(PluginHost, TheFirstOfTwoWins) {
  const TestFolder folder;
  copyPlugin(kBuiltIn, "org.example.post.csv", folder / "a");
  copyPlugin(kBuiltIn, "org.example.post.csv", folder / "b");
  const PluginHost host(folders({folder / "a", folder / "b"}));
  const auto reports = host.reports();
  ASSERT_EQ(reports.size(), 2U);
  EXPECT_EQ(reports[0].verdict, PluginVerdict::Available);
  EXPECT_EQ(reports[1].verdict, PluginVerdict::Shadowed);
  EXPECT_THAT(reports[1].reason, HasSubstr((folder / "a" / "org.example.post.csv.json").string()));
  EXPECT_EQ(host.components().size(), 1U);
}

TEST(PluginHost, ARefusedOneDoesNotShadow) {
  const TestFolder folder;
  copyPlugin(kBuiltIn, "org.example.post.csv", folder / "a");
  copyPlugin(kBuiltIn, "org.example.post.csv", folder / "b");
  fs::remove(folder / "a" / "org.example.post.csv.so");
  const PluginHost host(folders({folder / "a", folder / "b"}));
  EXPECT_NE(host.findPost("example.post.csv"), nullptr);
  EXPECT_EQ(host.reports()[0].verdict, PluginVerdict::Refused);
  EXPECT_THAT(host.reports()[0].reason, HasSubstr("does not exist"));
  EXPECT_EQ(host.reports()[1].verdict, PluginVerdict::Loaded);
}

TEST(PluginHost, AFolderThatIsNamedTwiceCountsOnce) {
  EXPECT_EQ(PluginHost(folders({kBuiltIn, kBuiltIn / "."})).reports().size(),
            PluginHost(folders({kBuiltIn})).reports().size());
}

TEST(PluginHost, TwoPluginsCannotProvideOneComponent) {
  const TestFolder folder;
  copyPlugin(kBuiltIn, "org.example.post.csv", folder / "a");
  copyPlugin(kBuiltIn, "org.example.post.csv", folder / "b");
  replaceInFile(folder / "b" / "org.example.post.csv.json", "org.example.post.csv",
                "org.example.copy");
  const PluginHost host(folders({folder / "a", folder / "b"}));
  const auto reports = host.reports();
  EXPECT_EQ(reports[1].verdict, PluginVerdict::Refused);
  EXPECT_THAT(reports[1].reason,
              HasSubstr("'example.post.csv' is already provided by plugin org.example.post.csv"));
}

TEST(PluginHost, ReportsWhatHasNoReadableManifest) {
  const TestFolder folder;
  createFolder(folder / "p");
  fs::copy_file(kBuiltIn / "org.example.post.csv.so", folder / "p" / "alone.so");
  writeFileAtomically(folder / "p" / "bad.json", "{\"id\": 1");
  writeFileAtomically(folder / "p" / "empty.json", "{}");
  writeFileAtomically(folder / "p" / "readme.txt", "not a plugin");
  const PluginHost host(folders({folder / "p", folder / "missing"}));
  const auto reports = host.reports();
  ASSERT_EQ(reports.size(), 4U);
  EXPECT_EQ(reports[0].path.filename(), "bad.json");
  EXPECT_EQ(reports[1].path.filename(), "empty.json");
  EXPECT_THAT(reports[1].reason, HasSubstr("9 problems"));
  EXPECT_EQ(reports[2].path.filename(), "alone.so");
  EXPECT_THAT(reports[2].reason, HasSubstr("no manifest alone.json"));
  EXPECT_THAT(reports[3].reason, HasSubstr("folder that does not exist"));
  for (const PluginReport& report : reports) {
    EXPECT_EQ(report.verdict, PluginVerdict::Refused);
  }
}

TEST(PluginHost, AWrongAbiInTheManifestIsSeenWithoutLoading) {
  const TestFolder folder;
  copyPlugin(kBuiltIn, "org.example.post.csv", folder / "a");
  replaceInFile(folder / "a" / "org.example.post.csv.json", "\"abi\": \"1.0\"", "\"abi\": \"0.9\"");
  const PluginHost host(folders({folder / "a"}));
  EXPECT_EQ(host.reports()[0].verdict, PluginVerdict::Refused);
  EXPECT_THAT(host.reports()[0].reason,
              HasSubstr("ABI 0.9, this program has 1.0; rebuild the plugin"));
}

TEST(PluginHost, ALibraryThatIsNoLibraryIsRefused) {
  const TestFolder folder;
  copyPlugin(kBuiltIn, "org.example.post.csv", folder / "a");
  const fs::path library = folder / "a" / "org.example.post.csv.so";
  for (const std::string& content :
       {std::string(), std::string("not an ELF file"), readFile(library).substr(0, 5000)}) {
    fs::remove(library);
    std::ofstream(library, std::ios::binary) << content;
    const PluginHost host(folders({folder / "a"}));
    EXPECT_THAT(errorOf(ErrorCode::PluginRefused, [&] { (void)host.findPost("example.post.csv"); }),
                HasSubstr("cannot be loaded"));
  }
}

TEST(PluginHost, RequestedFilesComeFirst) {
  const TestFolder folder;
  copyPlugin(kBuiltIn, "org.example.post.csv", folder / "a");
  PluginSearch search = folders({kBuiltIn});
  for (const char* extension : {".so", ".json"}) {
    search.files = {folder / "a" / (std::string("org.example.post.csv") + extension)};
    const PluginHost host(search);
    EXPECT_EQ(host.reports()[0].origin, PluginOrigin::Requested);
    EXPECT_EQ(host.reports()[0].verdict, PluginVerdict::Available);
    EXPECT_EQ(host.findPost("example.post.csv")->plugin, "org.example.post.csv");
    EXPECT_EQ(host.reports()[0].verdict, PluginVerdict::Loaded);
  }
  search.files = {folder / "none.so"};
  EXPECT_THAT(PluginHost(search).reports()[0].reason, HasSubstr("does not exist"));
}

TEST(PluginHost, OnlyARequestedPluginTakesThePlaceOfAnInstalledOne) {
  const TestFolder folder;
  copyPlugin(kBuiltIn, "org.example.post.csv", folder / "same");
  copyPlugin(kProbes, "org.wcam.probe.replacing", folder / "other");
  PluginSearch search = folders({folder / "same", folder / "other"});
  search.folders.push_back({kBuiltIn, PluginOrigin::Installed});
  const PluginHost host(search);
  EXPECT_EQ(host.reports()[0].verdict, PluginVerdict::Refused);
  EXPECT_THAT(host.reports()[0].reason, HasSubstr("would take the place of the installed plugin"));
  EXPECT_EQ(host.reports()[1].verdict, PluginVerdict::Refused);
  EXPECT_THAT(host.reports()[1].reason, HasSubstr("its component 'wcam.post.fanuc' would take"));
  EXPECT_EQ(host.findPost("wcam.post.fanuc")->plugin, "org.wcam.post.fanuc");
  search.files = {folder / "other" / "org.wcam.probe.replacing.so"};
  const PluginHost asked(search);
  EXPECT_EQ(asked.findPost("wcam.post.fanuc")->plugin, "org.wcam.probe.replacing");
}

TEST(PluginHost, WhatOthersCanWriteIsNotLoaded) {
  const TestFolder folder;
  const std::string name = "org.example.post.csv";
  copyPlugin(kBuiltIn, name, folder / "a");
  const auto reasonOf = [&](const fs::path& where) {
    const PluginHost host(folders({where}));
    return errorOf(ErrorCode::PluginRefused, [&] { (void)host.findPost("example.post.csv"); });
  };
  EXPECT_NE(PluginHost(folders({folder / "a"})).findPost("example.post.csv"), nullptr);
  fs::permissions(folder / "a", fs::perms::others_write, fs::perm_options::add);
  EXPECT_THAT(reasonOf(folder / "a"), HasSubstr("everybody can write " + (folder / "a").string()));
  fs::permissions(folder / "a", fs::perms::others_write, fs::perm_options::remove);
  fs::permissions(folder / "a" / (name + ".so"), fs::perms::others_write, fs::perm_options::add);
  EXPECT_THAT(reasonOf(folder / "a"), HasSubstr(name + ".so; take that right away"));
  // A link to a library elsewhere; a folder below one that everybody can change.
  createFolder(folder / "b");
  fs::copy_file(folder / "a" / (name + ".json"), folder / "b" / (name + ".json"));
  fs::create_symlink(kBuiltIn / (name + ".so"), folder / "b" / (name + ".so"));
  EXPECT_THAT(reasonOf(folder / "b"), HasSubstr("a link out of its folder"));
  copyPlugin(kBuiltIn, name, folder / "open" / "c");
  fs::permissions(folder / "open", fs::perms::others_write, fs::perm_options::add);
  EXPECT_THAT(reasonOf(folder / "open" / "c"), HasSubstr("everybody can write"));
  // A folder that depends on where the program is started.
  const PluginHost relative(folders({"a"}));
  EXPECT_THAT(relative.reports()[0].reason, HasSubstr("name its whole path"));
}

TEST(PluginHost, ALibraryThatEndsTheProgramIsTriedApart) {
  for (const auto& [name, reason] : {std::pair{"crashing_constructor", "loading it crashes"},
                                     std::pair{"exiting_constructor", "ends the program"}}) {
    const PluginHost host(only({probe(name)}));
    host.loadAll();
    EXPECT_EQ(host.reports()[0].verdict, PluginVerdict::Refused);
    EXPECT_THAT(host.reports()[0].reason, HasSubstr(reason));
  }
}

TEST(PluginHost, UnknownComponentsAreNamedWithTheNearestAndThePlaces) {
  const PluginHost host(folders({kBuiltIn}));
  const std::string text =
      errorOf(ErrorCode::PluginMissing, [&] { (void)host.findPost("wcam.post.fanucc"); });
  EXPECT_THAT(text, HasSubstr("no plugin provides the post-processor 'wcam.post.fanucc'"));
  EXPECT_THAT(text, HasSubstr("did you mean 'wcam.post.fanuc'?"));
  EXPECT_THAT(text, HasSubstr(pathText(kBuiltIn)));
  EXPECT_THAT(errorOf(ErrorCode::PluginMissing, [&] { (void)host.findSlicing("wcam.post.fanuc"); }),
              HasSubstr("it is of kind post"));
  EXPECT_THAT(
      errorOf(ErrorCode::PluginMissing, [&] { (void)PluginHost(PluginSearch{}).findPost("a.b"); }),
      HasSubstr("looked in: nowhere"));
}

TEST(PluginHost, DescribesComponents) {
  const PluginHost host(folders({kBuiltIn}));
  EXPECT_EQ(host.info("wcam.slicing.planar").id, "wcam.slicing.planar");
  EXPECT_NE(host.info("wcam.post.kuka").params.find("coupled"), nullptr);
  EXPECT_THROW((void)host.info("wcam.post.none"), Error);
}

TEST(DefaultPluginSearch, FollowsTheEnvironment) {
  const TestFolder folder;
  const Environment path("WCAM_PLUGIN_PATH",
                         (folder / "x").string() + "::" + (folder / "y").string());
  const Environment data("XDG_DATA_HOME", folder.path().string());
  const PluginSearch search = defaultPluginSearch({"a.so"});
  EXPECT_EQ(search.files, (std::vector<fs::path>{"a.so"}));
  ASSERT_EQ(search.folders.size(), 4U);
  EXPECT_EQ(search.folders[0].path, folder / "x");
  EXPECT_EQ(search.folders[1].path, folder / "y");
  EXPECT_EQ(search.folders[2].path, folder.path() / "wcam/plugins/1");
  EXPECT_EQ(search.folders[2].origin, PluginOrigin::User);
  EXPECT_EQ(search.folders[3].path, kBuiltIn);
  EXPECT_EQ(search.folders[3].origin, PluginOrigin::Installed);
  const PluginSearch plain = defaultPluginSearch({}, false);
  ASSERT_EQ(plain.folders.size(), 1U);
  EXPECT_EQ(plain.folders[0].origin, PluginOrigin::Installed);
}

TEST(DefaultPluginSearch, FallsBackToTheHomeFolder) {
  const Environment relative("XDG_DATA_HOME", "not/absolute");
  const Environment home("HOME", "/home/someone");
  EXPECT_EQ(userPluginFolder(), "/home/someone/.local/share/wcam/plugins/1");
}

TEST(Locations, BuildTreeHasTheInstalledLayout) {
  EXPECT_TRUE(fs::exists(engineFolder() / "libwcam-engine.so"));
  EXPECT_TRUE(fs::exists(kBuiltIn / "org.wcam.post.fanuc.json"));
  EXPECT_TRUE(fs::exists(dataFolder() / "cells"));
}

TEST(Guard, RefusesProgramsThatAreNone) {
  const PluginHost host(only({probe("misbehaving")}));
  const auto text = [&](const std::string& id) {
    return errorOf(ErrorCode::JobFailed, [&] {
      (void)host.findPost(id)->post->post(wcam::testing::sampleProgram(), Value::object(),
                                          JobContext());
    });
  };
  EXPECT_THAT(text("probe.empty"), HasSubstr("output file 'a.txt' is empty"));
  EXPECT_THAT(text("probe.prints"), HasSubstr("writes to standard output, beginning with 'G1 X1'"));
  EXPECT_THAT(text("probe.nan"), HasSubstr("no number (nan or inf) in line 1"));
  // Names and parts of words are none.
  EXPECT_EQ(host.findPost("probe.names")
                ->post->post(wcam::testing::sampleProgram(), Value::object(), JobContext())
                .size(),
            1U);
}

TEST(Guard, TurnsEveryExceptionIntoAJobFailure) {
  const PluginHost host(only({probe("misbehaving")}));
  const auto text = [&](const std::string& id) {
    return errorOf(ErrorCode::JobFailed, [&] {
      (void)host.findPost(id)->post->post(wcam::testing::sampleProgram(), Value::object(),
                                          JobContext());
    });
  };
  for (const char* id :
       {"probe.throws_int", "probe.throws_standard", "probe.throws_error", "probe.throws_cancel"}) {
    EXPECT_THAT(text(id),
                HasSubstr("plugin org.wcam.probe.misbehaving, component " + std::string(id)));
  }
  EXPECT_THAT(text("probe.throws_int"), HasSubstr("an exception of unknown type"));
  EXPECT_THAT(text("probe.throws_standard"), HasSubstr("out of ideas"));
  EXPECT_THAT(text("probe.throws_error"), HasSubstr("own message"));
  EXPECT_THAT(text("probe.throws_error"), HasSubstr("own hint"));
  EXPECT_THAT(text("probe.throws_cancel"), HasSubstr("nobody asked for it"));
}

TEST(Guard, LetsARealCancelPass) {
  const PluginHost host(only({probe("misbehaving")}));
  std::stop_source stop;
  stop.request_stop();
  const JobContext context(stop.get_token());
  for (const char* id : {"probe.cancels", "probe.throws_cancel"}) {
    EXPECT_THROW((void)host.findPost(id)->post->post(wcam::testing::sampleProgram(),
                                                     Value::object(), context),
                 CancelledError);
  }
}

TEST(Guard, ChecksFileNames) {
  const PluginHost host(only({probe("misbehaving")}));
  const auto text = [&](const std::string& id) {
    return errorOf(ErrorCode::JobFailed, [&] {
      (void)host.findPost(id)->post->post(wcam::testing::sampleProgram(), Value::object(),
                                          JobContext());
    });
  };
  EXPECT_THAT(text("probe.no_file"), HasSubstr("wrote no file"));
  EXPECT_THAT(text("probe.folder"), HasSubstr("'../evil.txt' contains a folder"));
  EXPECT_THAT(text("probe.duplicate"), HasSubstr("'A.TXT' appears twice"));
}

TEST(Guard, RefusesNumbersThatAreNotFinite) {
  const PluginHost host(only({probe("misbehaving")}));
  SliceInput input;
  input.parts.resize(1);
  const auto text = [&](const std::string& id) {
    return errorOf(ErrorCode::JobFailed, [&] {
      (void)host.findSlicing(id)->strategy->slice(input, Value::object(), JobContext());
    });
  };
  EXPECT_THAT(text("probe.slicing_nan"),
              HasSubstr("layer 1 contour 1 has a number that is not finite at point 2"));
  EXPECT_THAT(text("probe.slicing_throws"), HasSubstr("beyond the end"));
  input.parts.clear();
  EXPECT_THAT(text("probe.slicing_nan"), HasSubstr("names part 0, which does not exist"));
}
