// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/plugin/manifest.hpp"

#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"

#include "error_matchers.hpp"
#include "test_folder.hpp"
#include <gtest/gtest.h>

using namespace wcam;
using namespace wcam::plugin;
using ::testing::HasSubstr;
using wcam::testing::errorOf;

namespace {

Value sound() {
  return parseJson(R"({
    "id": "com.acme.post.demo", "name": "Demo", "version": "1.2.3", "vendor": "Acme",
    "licence": "GPL-3.0-or-later", "abi": "1.0", "library": "demo.so", "kinds": ["post", "slicing"],
    "components": [{"id": "acme.demo", "kind": "post", "name": "Demo post"},
                   {"id": "acme.slice", "kind": "slicing", "name": "Demo slicing"}]})");
}

std::string problemOf(const Value& manifest) {
  return errorOf(ErrorCode::PluginRefused,
                 [&] { (void)parseManifest(toCompactJson(manifest), "demo.json"); });
}

Value with(const char* key, Value value) {
  Value manifest = sound();
  manifest.set(key, std::move(value));
  return manifest;
}

}  // namespace

TEST(Manifest, ReadsASoundOne) {
  Value value = sound();
  value.set("x-own", 1);
  const Manifest manifest = parseManifest(toCanonicalJson(value), "demo.json");
  EXPECT_EQ(manifest.id, "com.acme.post.demo");
  EXPECT_EQ(manifest.version, "1.2.3");
  EXPECT_EQ(manifest.abiMajor, 1);
  EXPECT_EQ(manifest.abiMinor, 0);
  ASSERT_EQ(manifest.components.size(), 2U);
  EXPECT_EQ(manifest.components[1].kind, ComponentKind::Slicing);
}

TEST(Manifest, EveryKeyIsRequired) {
  const Value all = sound();
  for (const Value::Member& member : all.asObject()) {
    Value manifest = sound();
    manifest.remove(member.first);
    EXPECT_THAT(problemOf(manifest), HasSubstr(member.first + ": is missing"));
  }
}

TEST(Manifest, NamesWhatIsWrong) {
  EXPECT_THAT(problemOf(with("id", "nodots")), HasSubstr("id: 'nodots' is not a reverse-DNS id"));
  EXPECT_THAT(problemOf(with("id", "Com.Acme")), HasSubstr("is not a reverse-DNS id"));
  EXPECT_THAT(problemOf(with("name", "  ")), HasSubstr("name: must have 1 to 200 characters"));
  EXPECT_THAT(problemOf(with("name", "a\nb")), HasSubstr("no control characters"));
  EXPECT_THAT(problemOf(with("vendor", 3)), HasSubstr("vendor: expected a text"));
  for (const char* version :
       {"1.2", "1.2.3.4", "1.02.3", "a.b.c", "1.-2.3", "", "99999999999.0.0"}) {
    EXPECT_THAT(problemOf(with("version", version)), HasSubstr("version: ")) << version;
  }
  for (const char* abi : {"1", "1.0.0", "x.y", "01.0"}) {
    EXPECT_THAT(problemOf(with("abi", abi)), HasSubstr("is not MAJOR.MINOR")) << abi;
  }
  for (const char* library : {"../demo.so", "/usr/lib/demo.so", "demo.dll", ".so"}) {
    EXPECT_THAT(problemOf(with("library", library)), HasSubstr("is not the name of a .so file"))
        << library;
  }
  EXPECT_THAT(problemOf(with("kinds", Value::Array{"post"})), HasSubstr("kinds: does not list"));
  EXPECT_THAT(problemOf(with("kinds", Value::Array{"post", "post"})),
              HasSubstr("kinds[1]: appears twice"));
  EXPECT_THAT(problemOf(with("kinds", Value::Array{"widget"})),
              HasSubstr("kinds[0]: is not one of"));
  EXPECT_THAT(problemOf(with("components", Value::array())),
              HasSubstr("components: expected a list"));
  EXPECT_THAT(problemOf(with("components", Value::Array{"a"})),
              HasSubstr("components[0]: expected an object"));
  EXPECT_THAT(problemOf(with("licens", "x")),
              HasSubstr("licens: is not a key of a manifest; did you mean 'licence'?"));
}

TEST(Manifest, NamesWhatIsWrongInComponents) {
  const auto component = [](const char* id, const char* kind, const char* name) {
    return Value::object({{"id", id}, {"kind", kind}, {"name", name}});
  };
  EXPECT_THAT(problemOf(with("components", Value::Array{component("a.b", "post", "x"),
                                                        component("a.b", "post", "y")})),
              HasSubstr("components[1].id: 'a.b' appears twice"));
  EXPECT_THAT(problemOf(with("components", Value::Array{component("a.b", "posts", "x")})),
              HasSubstr("components[0].kind: 'posts' is not one of"));
  EXPECT_THAT(problemOf(with("components", Value::Array{component("ab", "post", "x")})),
              HasSubstr("components[0].id: 'ab' is not"));
}

TEST(Manifest, TellsAllProblemsAtOnce) {
  Value manifest = sound();
  manifest.set("id", "x").set("version", "x").set("abi", "x").set("library", "x").set("typo", 1);
  const std::string text = problemOf(manifest);
  for (const char* part :
       {"5 problems", "demo.json", "id: ", "version: ", "abi: ", "library: ", "typo: "}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
}

TEST(Manifest, RefusesTextThatIsNoObject) {
  for (const char* text :
       {"", "[]", "1", "null", "{", "{\"id\": \"a.b\",}", "\xff\xfe", "{\"id\":1}{}"}) {
    errorOf(ErrorCode::PluginRefused, [&] { (void)parseManifest(text, "demo.json"); });
  }
}

TEST(Manifest, RefusesFilesThatCannotBeRead) {
  const wcam::testing::TestFolder folder;
  errorOf(ErrorCode::PluginRefused, [&] { (void)readManifest(folder / "missing.json"); });
  errorOf(ErrorCode::PluginRefused, [&] { (void)readManifest(folder.path()); });
  writeFileAtomically(folder / "long.json", std::string(kMaxManifestSize + 1, ' '));
  EXPECT_THAT(errorOf(ErrorCode::PluginRefused, [&] { (void)readManifest(folder / "long.json"); }),
              HasSubstr("is longer than"));
}
