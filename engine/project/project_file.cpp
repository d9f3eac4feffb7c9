// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/project_file.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/sha256.hpp"
#include "wcam/base/text.hpp"
#include "wcam/plugin/locations.hpp"

#include "file_schema.hpp"

#include <algorithm>
#include <array>
#include <system_error>

namespace wcam::project {

namespace {

std::optional<std::int64_t> versionOf(const Value& tree) {
  const Value* version = tree.find("format_version");
  return version != nullptr && version->isInteger() ? std::optional(version->asInteger())
                                                    : std::nullopt;
}

/// Takes the tree through all steps from its version on. Stops where no step fits: the reader of
/// documents says then what is wrong.
Value migrate(Value tree,
              const std::vector<Migration>& migrations,
              const std::string& context,
              std::vector<Diagnostic>& findings) {
  for (const Migration& step : migrations) {
    const auto version = versionOf(tree);
    if (!version || *version != step.from || *version >= kFormatVersion) {
      continue;
    }
    try {
      tree = step.apply(std::move(tree));
      tree.set("format_version", step.from + 1);
    } catch (const Error& error) {
      throw Error(ErrorCode::ProjectInvalid,
                  text("format version %1 cannot be brought up to date: %2",
                       {std::to_string(step.from), error.whatText()}),
                  context, "the file does not keep the rules of its own version");
    }
    findings.push_back(
        {Severity::Information,
         "project.migrated",
         text("format version %1 was read as version %2: %3",
              {std::to_string(step.from), std::to_string(step.from + 1), step.summary}),
         "save the project to keep the new version",
         {},
         {}});
  }
  return tree;
}

bool isPresent(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  return !error && std::filesystem::exists(status) && !std::filesystem::is_directory(status);
}

/// Hash of every file, in the order of use; all missing ones are named together.
std::vector<std::string> hashesOf(const std::vector<UsedFile>& files,
                                  const std::filesystem::path& project) {
  std::vector<Text> missing;
  for (const UsedFile& file : files) {
    if (!isPresent(resolvePath(project, file.ref))) {
      missing.push_back(
          text("%1 needs the file '%2', which does not exist (looked for %3)",
               {file.owner, file.ref.path, pathText(resolvePath(project, file.ref))}));
    }
  }
  if (!missing.empty()) {
    throw Error(ErrorCode::InputNotFound, joinTexts(missing, "\n  "), pathText(project),
                "put the file there or correct its path in the project");
  }
  std::map<std::string, std::string> known;
  std::vector<std::string> hashes;
  for (const UsedFile& file : files) {
    auto [entry, fresh] = known.try_emplace(file.ref.path);
    if (fresh) {
      entry->second = sha256OfFile(resolvePath(project, file.ref));
    }
    hashes.push_back(entry->second);
  }
  return hashes;
}

}  // namespace

const std::vector<Migration>& releasedMigrations() {
  static const std::vector<Migration> kNone;
  return kNone;
}

LoadedProject parseProject(std::string_view text,
                           const std::filesystem::path& file,
                           const std::vector<Migration>& migrations) {
  const std::string context = pathText(file);
  LoadedProject loaded;
  loaded.file = file;
  loaded.sha256 = sha256Hex(text);
  Value tree = migrate(parseJson(text, context), migrations, context, loaded.findings);
  loaded.migrated = !loaded.findings.empty();
  loaded.document = Document::parse(std::move(tree), context);
  const auto& findings = loaded.document.findings();
  loaded.findings.insert(loaded.findings.end(), findings.begin(), findings.end());
  return loaded;
}

LoadedProject loadProject(const std::filesystem::path& file,
                          const std::vector<Migration>& migrations) {
  const std::string extension = file.extension().string();
  constexpr std::array kParts = {".step", ".stp", ".STEP", ".STP", ".stl",
                                 ".STL",  ".obj", ".ply",  ".3mf", ".wsurf"};
  std::string content = readFile(file);
  if (std::find(kParts.begin(), kParts.end(), extension) != kParts.end()) {
    throw Error(ErrorCode::InputInvalid, "is a part, not a project", pathText(file),
                text("make a project of it: camcli new %1.wcam --part %2",
                     {pathText(file.stem()), pathText(file)}));
  }
  return parseProject(content, file, migrations);
}

void saveProject(const Document& document,
                 const std::filesystem::path& file,
                 const std::string& expected) {
  if (document.readOnly()) {
    throw Error(ErrorCode::ProjectReadOnly,
                "the project was written by a newer version and cannot be saved by this one",
                pathText(file), "use the newer version of WCAM");
  }
  if (!expected.empty() && (!isPresent(file) || sha256OfFile(file) != expected)) {
    throw Error(ErrorCode::OutputConflict,
                "another program has changed or removed the file since it was read", pathText(file),
                "read it again, or save under another name");
  }
  writeFileAtomically(file, document.text());
}

std::string checkCanonical(const std::filesystem::path& file) {
  const std::string text = readFile(file);
  const LoadedProject loaded = parseProject(text, file);
  const std::string canonical = loaded.document.text();
  if (text == canonical) {
    return {};
  }
  const auto [own, other] =
      std::mismatch(text.begin(), text.end(), canonical.begin(), canonical.end());
  const auto line = 1 + std::count(text.begin(), own, '\n');
  return pathText(file) + ": saving would change line " + std::to_string(line);
}

std::filesystem::path autosavePath(const std::filesystem::path& file) {
  std::filesystem::path path = file;
  path.replace_filename("." + file.filename().native() + ".autosave");
  return path;
}

void autosave(const Document& document, const std::filesystem::path& file) {
  if (!document.readOnly()) {
    writeFileAtomically(autosavePath(file), document.text());
  }
}

void dropAutosave(const std::filesystem::path& file) noexcept {
  std::error_code ignored;
  std::filesystem::remove(autosavePath(file), ignored);
}

std::optional<LoadedProject> recoverable(const std::filesystem::path& file) {
  const std::filesystem::path saved = autosavePath(file);
  if (!isPresent(saved)) {
    return std::nullopt;
  }
  try {
    const std::string text = readFile(saved);
    if (isPresent(file)) {
      std::error_code error;
      const auto ownTime = std::filesystem::last_write_time(file, error);
      const auto savedTime = std::filesystem::last_write_time(saved, error);
      if (error || savedTime < ownTime || readFile(file) == text) {
        return std::nullopt;
      }
    }
    LoadedProject loaded = parseProject(text, file);
    return loaded;
  } catch (const Error&) {
    return std::nullopt;
  }
}

std::vector<UsedFile> usedFiles(const Document& document) {
  std::vector<UsedFile> files;
  const Project& project = document.project();
  if (!project.cell.empty()) {
    files.push_back({"cell", "cell", project.cell});
  }
  const auto collect = [&files](const auto& nodes, const char* list, const char* noun) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (!nodes[i].file.empty()) {
        files.push_back({text("%1 '%2'", {noun, nodes[i].id}),
                         std::string(list) + "[" + std::to_string(i) + "].file", nodes[i].file});
      }
    }
  };
  collect(project.parts, "parts", "part");
  collect(project.guides, "guides", "guide");
  collect(project.processes, "processes", "process");
  collect(project.operations, "operations", "operation");
  return files;
}

std::filesystem::path resolvePath(const std::filesystem::path& project, const FileRef& ref) {
  if (ref.path.starts_with(kShippedPrefix)) {
    return (plugin::dataFolder() /
            pathFromText(ref.path.substr(std::string_view(kShippedPrefix).size())))
        .lexically_normal();
  }
  return (project.parent_path() / pathFromText(ref.path)).lexically_normal();
}

std::vector<Diagnostic> checkFiles(const Document& document, const std::filesystem::path& project) {
  const std::vector<UsedFile> files = usedFiles(document);
  const std::vector<std::string> hashes = hashesOf(files, project);
  std::vector<Diagnostic> findings;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (!files[i].ref.sha256.empty() && files[i].ref.sha256 != hashes[i]) {
      findings.push_back({Severity::Warning,
                          "project.hash_changed",
                          text("%1: the file '%2' is not the one that the project was made with",
                               {files[i].owner, files[i].ref.path}),
                          "restore the file, or pin the new content with the command file.pin",
                          {},
                          {}});
    }
  }
  return findings;
}

std::map<std::string, std::string> hashFiles(const Document& document,
                                             const std::filesystem::path& project) {
  const std::vector<UsedFile> files = usedFiles(document);
  const std::vector<std::string> hashes = hashesOf(files, project);
  std::map<std::string, std::string> byPath;
  for (std::size_t i = 0; i < files.size(); ++i) {
    byPath[files[i].ref.path] = hashes[i];
  }
  return byPath;
}

}  // namespace wcam::project
