// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Plugins that are missing, refused or that throw, as camcli tells them.
#include "camcli.hpp"

namespace wcam::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

std::string probe(const std::string& name) {
  return std::string(WCAM_PROBES) + "/org.wcam.probe." + name + ".so";
}

class Plugins : public CamcliTest {
protected:
  const fs::path elbow_ = exampleFolder("elbow") / "elbow.wcam";
};

TEST_F(Plugins, ListTellsVerdicts) {
  const ProcessResult text = camcli({"plugins", "list"});
  EXPECT_EQ(text.exitCode, 0);
  EXPECT_THAT(text.out,
              AllOf(HasSubstr("loaded  org.wcam.slicing.planar"), HasSubstr("wcam.post.fanuc")));
  ProcessRequest withProbes;
  withProbes.environment["WCAM_PLUGIN_PATH"] = WCAM_PROBES;
  const ProcessResult probes = camcli({"plugins", "list", "--json"}, withProbes);
  EXPECT_EQ(probes.exitCode, 0);
  EXPECT_EQ(probes.err, "");
  std::map<std::string, std::string> verdicts;
  const Value tree = parseJson(probes.out);
  for (const Value& plugin : tree.at("plugins").asArray()) {
    verdicts[plugin.at("id").asString()] = plugin.at("verdict").asString();
    if (plugin.at("verdict").asString() == "refused") {
      EXPECT_NE(plugin.at("reason").asString(), "");
    }
  }
  EXPECT_EQ(verdicts["org.wcam.post.kuka"], "loaded");
  EXPECT_EQ(verdicts["org.wcam.probe.misbehaving"], "loaded");
  EXPECT_EQ(verdicts["org.wcam.probe.wrong_abi"], "refused");
  EXPECT_EQ(verdicts["org.wcam.probe.no_entry"], "refused");
  EXPECT_EQ(verdicts["org.wcam.probe.throwing_register"], "refused");
}

TEST_F(Plugins, MissingOneIsNamed) {
  const fs::path project = elbowWith("wcam.slicing.guide", "com.acme.slicing.spiral");
  // The other operation does not need it.
  const ProcessResult partly = camcli({"--project", project, "--output", "partly"});
  EXPECT_EQ(partly.exitCode, 7);
  EXPECT_THAT(partly.err, AllOf(HasSubstr("operation 'guide': no plugin provides the strategy "
                                          "'com.acme.slicing.spiral'"),
                                HasSubstr("its maker is the owner of acme.com")));
  EXPECT_TRUE(fs::exists(folder_ / "partly/fanuc/PLANAR.LS"));
  EXPECT_FALSE(fs::exists(folder_ / "partly/fanuc/GUIDE.LS"));
  EXPECT_THAT(refusedRun(project, 7, {"--operation", "guide"}),
              HasSubstr("'com.acme.slicing.spiral'"));
  const fs::path project2 = example("elbow", "second");
  writeFileAtomically(project2, replaced(readFile(project2), "wcam.post.fanuc", "com.acme.post"));
  EXPECT_THAT(refusedRun(project2, 7), HasSubstr("'com.acme.post'"));
}

TEST_F(Plugins, VersionsThatTheProjectNamesAreChecked) {
  const auto naming = [&](const std::string& id, const std::string& version) {
    const fs::path project = example("elbow", id + version);
    Value tree = parseJson(readFile(project));
    tree.set("plugins", Value(Value::Array{Value::object({{"id", id}, {"version", version}})}));
    writeFileAtomically(project, toCanonicalJson(tree));
    return project;
  };
  // One that is too old stops what needs it, and nothing else.
  const fs::path later = naming("org.wcam.slicing.guide", "99.1.0");
  const ProcessResult partly = camcli({"--project", later, "--output", "partly"});
  EXPECT_EQ(partly.exitCode, 7);
  EXPECT_THAT(partly.err,
              AllOf(HasSubstr("operation 'guide': the project needs version 99.1.0 of the plugin "
                              "org.wcam.slicing.guide; version "),
                    HasSubstr("install version 99.1.0 or a later one")));
  EXPECT_TRUE(fs::exists(folder_ / "partly/fanuc/PLANAR.LS"));
  EXPECT_FALSE(fs::exists(folder_ / "partly/fanuc/GUIDE.LS"));
  const ProcessResult earlier =
      camcli({"--project", naming("org.wcam.slicing.guide", "0.0.1"), "--check"});
  EXPECT_EQ(earlier.exitCode, 0) << earlier.err;
  EXPECT_THAT(earlier.out + earlier.err, HasSubstr("project.plugin_newer"));
  const ProcessResult foreign = camcli({"--project", naming("com.acme.other", "1.0.0"), "--check"});
  EXPECT_EQ(foreign.exitCode, 0) << foreign.err;
  EXPECT_THAT(foreign.out + foreign.err, HasSubstr("project.plugin_missing"));
}

TEST_F(Plugins, RefusedOnesThatAreNamedEndTheRun) {
  for (const char* name : {"wrong_abi", "newer_abi", "wrong_fingerprint", "no_entry"}) {
    const std::string id = "probe." + std::string(name);
    const ProcessResult needed =
        camcli({"--project", elbow_, "--output", "out", "--plugin", probe(name), "--post", id});
    EXPECT_EQ(needed.exitCode, 7) << name << needed.err;
    EXPECT_THAT(needed.err, HasSubstr("camcli: error: ")) << name;
    EXPECT_THAT(needed.err, HasSubstr(id)) << name;
    EXPECT_FALSE(fs::exists(folder_ / "out"));
    const ProcessResult idle = camcli({"--project", elbow_, "--check", "--plugin", probe(name)});
    EXPECT_EQ(idle.exitCode, 7) << name;
    EXPECT_THAT(idle.err, AllOf(HasSubstr("the plugin is refused: "), HasSubstr(name)));
    // The list shows them, to see why.
    const ProcessResult list = camcli({"plugins", "list", "--plugin", probe(name)});
    EXPECT_EQ(list.exitCode, 0) << list.err;
    EXPECT_THAT(list.out, HasSubstr("refused  org.wcam.probe." + std::string(name)));
  }
}

TEST_F(Plugins, LibraryThatIsNone) {
  writeFileAtomically(folder_ / "none.so", "no library");
  for (const char* file : {"none.so", "missing.so"}) {
    const ProcessResult result = camcli({"--project", elbow_, "--check", "--plugin", file});
    EXPECT_EQ(result.exitCode, 7);
    EXPECT_THAT(result.err, AllOf(HasSubstr(file), HasSubstr("is refused")));
  }
}

TEST_F(Plugins, PostThatThrowsFailsItsJob) {
  for (const char* id : {"probe.throws_int", "probe.throws_standard", "probe.throws_error"}) {
    const ProcessResult result =
        camcli({"--project", elbow_, "--output", "out", "--plugin", probe("misbehaving"), "--post",
                id, "--operation", "guide", "--post", "fanuc"});
    EXPECT_EQ(result.exitCode, 6) << id << result.err;
    EXPECT_THAT(result.err,
                AllOf(HasSubstr("output '" + std::string(id) + "'"), HasSubstr("operation 'guide'"),
                      HasSubstr("org.wcam.probe.misbehaving")));
    // The other output is not harmed, and the report tells the failure.
    EXPECT_TRUE(fs::exists(folder_ / "out/fanuc/GUIDE.LS"));
    const Value report = parseJson(readFile(folder_ / "out/report.json"));
    EXPECT_EQ(report.at("errors").asArray().at(0).at("code").asString(), "job-failed");
    fs::remove_all(folder_ / "out");
  }
}

TEST_F(Plugins, PluginThatEndsTheProgramIsNamed) {
  for (const auto& [id, what] :
       {std::pair{"probe.crashes", " crashed"}, std::pair{"probe.aborts", " gave up (abort)"},
        std::pair{"probe.exits", " ended the program (exit)"}}) {
    const ProcessResult result =
        camcli({"--project", elbow_, "--output", "out", "--plugin", probe("misbehaving"), "--post",
                id, "--operation", "planar"});
    EXPECT_NE(result.exitCode, 0) << id;
    EXPECT_THAT(result.err,
                HasSubstr("camcli: error: plugin org.wcam.probe.misbehaving, component " +
                          std::string(id) + what));
    EXPECT_TRUE(filesBelow(folder_ / "out").empty());
  }
}

TEST_F(Plugins, ReplacingAnInstalledComponentIsAnnounced) {
  const ProcessResult result = camcli({"--project", elbow_, "--output", "out", "--plugin",
                                       probe("replacing"), "--operation", "planar"});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("camcli: warning: the installed plugin org.wcam.post.fanuc is "
                                    "not used: its component 'wcam.post.fanuc' is already provided "
                                    "by plugin org.wcam.probe.replacing"));
  EXPECT_TRUE(fs::exists(folder_ / "out/fanuc/another.ls"));
}

TEST_F(Plugins, PostThatPretendsACancelIsNoCancel) {
  const ProcessResult result = camcli({"--project", elbow_, "--output", "out", "--plugin",
                                       probe("misbehaving"), "--post", "probe.throws_cancel"});
  EXPECT_EQ(result.exitCode, 6) << result.err;
}

TEST_F(Plugins, PostCannotWriteElsewhere) {
  const ProcessResult result = camcli({"--project", elbow_, "--output", "a/out", "--plugin",
                                       probe("misbehaving"), "--post", "probe.folder"});
  EXPECT_EQ(result.exitCode, 6) << result.err;
  EXPECT_FALSE(fs::exists(folder_ / "a/evil.txt"));
}

TEST_F(Plugins, StrategyThatThrowsOrGivesNoNumbers) {
  for (const char* id : {"probe.slicing_throws", "probe.slicing_nan"}) {
    const fs::path project = elbowWith("wcam.slicing.planar", id);
    const ProcessResult result = camcli({"--project", project, "--output", "out", "--plugin",
                                         probe("misbehaving"), "--operation", "planar"});
    EXPECT_EQ(result.exitCode, 6) << id << result.err;
    EXPECT_THAT(result.err, HasSubstr("operation 'planar'"));
    EXPECT_FALSE(fs::exists(folder_ / "out"));
    fs::remove_all(project.parent_path());
  }
}

TEST_F(Plugins, SchemaOfARefusedComponent) {
  const ProcessResult result =
      camcli({"schema", "probe.wrong_abi", "--plugin", probe("wrong_abi")});
  EXPECT_EQ(result.exitCode, 7);
  EXPECT_EQ(result.out, "");
}

}  // namespace
}  // namespace wcam::testing
