// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/plugin/manifest.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/param.hpp"
#include "wcam/base/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <set>

namespace wcam::plugin {

namespace {

constexpr std::size_t kMaxTextLength = 200;
constexpr std::size_t kMaxComponents = 1000;
constexpr std::array<std::string_view, 9> kKeys = {
    "id", "name", "version", "vendor", "licence", "abi", "library", "kinds", "components"};
constexpr std::array<std::string_view, 3> kComponentKeys = {"id", "kind", "name"};

/// Up to `count` numbers separated by dots, without signs or leading zeros.
std::optional<std::vector<int>> dottedNumbers(std::string_view text, std::size_t count) {
  std::vector<int> numbers;
  for (const std::string& part : splitText(text, '.')) {
    int number = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
    if (error != std::errc{} || end != part.data() + part.size() || number < 0 ||
        (part.size() > 1 && part.front() == '0')) {
      return std::nullopt;
    }
    numbers.push_back(number);
  }
  return numbers.size() == count ? std::optional(numbers) : std::nullopt;
}

std::optional<ComponentKind> kindFrom(std::string_view text) {
  for (const ComponentKind kind : {ComponentKind::Slicing, ComponentKind::Post}) {
    if (text == toString(kind)) {
      return kind;
    }
  }
  return std::nullopt;
}

bool isPrintable(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return code >= 0x20 && code != 0x7F;
  });
}

/// Collects problems while the fields of a manifest are read.
class Reader {
public:
  std::vector<ParamProblem> problems;

  void problem(const std::string& path, const Text& message) {
    problems.push_back({path, message, false});
  }

  /// Text of a required member; empty when it is missing or wrong, which is then reported.
  std::string text(const Value& object, std::string_view key, const std::string& path) {
    const Value* value = object.find(key);
    if (value == nullptr) {
      problem(path, "is missing");
      return {};
    }
    if (!value->isString()) {
      problem(path, wcam::text("expected a text, got %1", {toString(value->type())}));
      return {};
    }
    const std::string& result = value->asString();
    if (trimText(result).empty() || result.size() > kMaxTextLength || !isPrintable(result)) {
      problem(path, wcam::text("must have 1 to %1 characters and no control characters",
                               {std::to_string(kMaxTextLength)}));
      return {};
    }
    return result;
  }

  std::string id(const Value& object, const std::string& path) {
    std::string result = text(object, "id", path);
    if (!result.empty() && (!isValidId(result) || result.find('.') == std::string::npos)) {
      problem(path,
              wcam::text("'%1' is not a reverse-DNS id: 1 to 64 characters of a-z 0-9 _ - . with "
                         "at least one dot, such as com.acme.post.demo",
                         {result}));
      return {};
    }
    return result;
  }

  template <std::size_t N>
  void unknownKeys(const Value& object,
                   const std::array<std::string_view, N>& known,
                   const std::string& path) {
    for (const auto& [key, value] : object.asObject()) {
      if (!key.starts_with("x-") && std::find(known.begin(), known.end(), key) == known.end()) {
        const auto near = nearestName(key, std::vector<std::string>(known.begin(), known.end()));
        problem(path + key,
                near ? wcam::text("is not a key of a manifest; did you mean '%1'?", {*near})
                     : wcam::text("is not a key of a manifest"));
      }
    }
  }
};

void readAbi(Reader& reader, const Value& root, Manifest& manifest) {
  const std::string abi = reader.text(root, "abi", "abi");
  if (abi.empty()) {
    return;
  }
  const auto numbers = dottedNumbers(abi, 2);
  if (!numbers) {
    reader.problem("abi", wcam::text("'%1' is not MAJOR.MINOR, such as 1.0", {abi}));
    return;
  }
  manifest.abiMajor = numbers->at(0);
  manifest.abiMinor = numbers->at(1);
}

void readLibrary(Reader& reader, const Value& root, Manifest& manifest) {
  manifest.library = reader.text(root, "library", "library");
  if (!manifest.library.empty() &&
      (manifest.library.find('/') != std::string::npos || !manifest.library.ends_with(".so") ||
       manifest.library == ".so")) {
    reader.problem("library", wcam::text("'%1' is not the name of a .so file beside the manifest",
                                         {manifest.library}));
  }
}

void readComponents(Reader& reader, const Value& root, Manifest& manifest) {
  const Value* list = root.find("components");
  if (list == nullptr || !list->isArray() || list->size() == 0 || list->size() > kMaxComponents) {
    reader.problem("components", list == nullptr
                                     ? wcam::text("is missing")
                                     : wcam::text("expected a list of 1 to %1 components",
                                                  {std::to_string(kMaxComponents)}));
    return;
  }
  std::set<std::string> seen;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const Value& item = list->asArray()[i];
    const std::string path = "components[" + std::to_string(i) + "]";
    if (!item.isObject()) {
      reader.problem(path, wcam::text("expected an object, got %1", {toString(item.type())}));
      continue;
    }
    reader.unknownKeys(item, kComponentKeys, path + ".");
    ComponentEntry entry;
    entry.id = reader.id(item, path + ".id");
    entry.name = reader.text(item, "name", path + ".name");
    const std::string kind = reader.text(item, "kind", path + ".kind");
    if (const auto known = kindFrom(kind)) {
      entry.kind = *known;
    } else if (!kind.empty()) {
      reader.problem(path + ".kind", wcam::text("'%1' is not one of: slicing, post", {kind}));
    }
    if (!entry.id.empty() && !seen.insert(entry.id).second) {
      reader.problem(path + ".id", wcam::text("'%1' appears twice", {entry.id}));
    }
    manifest.components.push_back(std::move(entry));
  }
}

/// `kinds` repeats which kinds the components have; it must agree with them.
void readKinds(Reader& reader, const Value& root, const Manifest& manifest) {
  const Value* list = root.find("kinds");
  if (list == nullptr || !list->isArray() || list->size() == 0) {
    reader.problem("kinds", list == nullptr ? "is missing" : "expected a list of slicing, post");
    return;
  }
  std::set<std::string> named;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const Value& item = list->asArray()[i];
    if (!item.isString() || !kindFrom(item.asString())) {
      reader.problem("kinds[" + std::to_string(i) + "]", "is not one of: slicing, post");
    } else if (!named.insert(item.asString()).second) {
      reader.problem("kinds[" + std::to_string(i) + "]", "appears twice");
    }
  }
  std::set<std::string> used;
  for (const ComponentEntry& entry : manifest.components) {
    used.insert(toString(entry.kind));
  }
  if (reader.problems.empty() && named != used) {
    reader.problem("kinds", "does not list the kinds of the components");
  }
}

}  // namespace

const char* toString(ComponentKind kind) noexcept {
  return kind == ComponentKind::Slicing ? "slicing" : "post";
}

Manifest parseManifest(std::string_view text, const std::string& context) {
  Value root;
  try {
    root = parseJson(text, context);
  } catch (const Error& error) {
    throw Error(ErrorCode::PluginRefused, error.messageText(), error.contextText(),
                "the manifest must be a JSON object; wcam_add_plugin() writes it");
  }
  if (!root.isObject()) {
    throw Error(ErrorCode::PluginRefused,
                wcam::text("expected an object, got %1", {toString(root.type())}), context);
  }
  Reader reader;
  Manifest manifest;
  reader.unknownKeys(root, kKeys, "");
  manifest.id = reader.id(root, "id");
  manifest.name = reader.text(root, "name", "name");
  manifest.version = reader.text(root, "version", "version");
  if (!manifest.version.empty() && !dottedNumbers(manifest.version, 3)) {
    reader.problem("version", wcam::text("'%1' is not MAJOR.MINOR.PATCH", {manifest.version}));
  }
  manifest.vendor = reader.text(root, "vendor", "vendor");
  manifest.licence = reader.text(root, "licence", "licence");
  readAbi(reader, root, manifest);
  readLibrary(reader, root, manifest);
  readComponents(reader, root, manifest);
  readKinds(reader, root, manifest);
  throwProblems(reader.problems, ErrorCode::PluginRefused, context);
  return manifest;
}

Manifest readManifest(const std::filesystem::path& file) {
  const std::string name = pathText(file);
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  if (!error && size > kMaxManifestSize) {
    throw Error(ErrorCode::PluginRefused,
                wcam::text("is longer than %1 bytes", {std::to_string(kMaxManifestSize)}), name);
  }
  std::string text;
  try {
    text = readFile(file);
  } catch (const Error& problem) {
    throw Error(ErrorCode::PluginRefused, problem.messageText(), problem.contextText(),
                problem.hintText());
  }
  return parseManifest(text, name);
}

}  // namespace wcam::plugin
