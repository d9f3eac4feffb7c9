// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/document.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/json.hpp"

#include "file_schema.hpp"
#include "model_reader.hpp"

#include <algorithm>
#include <limits>

namespace wcam::project {

struct Document::State {
  Value tree;
  Project project;
  std::vector<Diagnostic> findings;
  bool readOnly = false;
};

namespace {

/// What makes a tree a project file of some version. @return its version
std::int64_t checkHead(const Value& tree, std::vector<ParamProblem>& problems) {
  if (!tree.isObject()) {
    problems.push_back({"format", "the file holds no object, so it is no WCAM project", false});
    return 0;
  }
  const Value* format = tree.find("format");
  if (format == nullptr || !format->isString() || format->asString() != kFormatName) {
    problems.push_back({"format", "must be \"wcam-project\"; this file is no WCAM project", false});
  }
  const Value* version = tree.find("format_version");
  if (version == nullptr || !version->isInteger() || version->asInteger() < 0 ||
      version->asInteger() > std::numeric_limits<int>::max()) {
    problems.push_back({"format_version", "must be an integer from 0", false});
    return 0;
  }
  return version->asInteger();
}

}  // namespace

Document::Document() : Document(empty({})) {}

Document Document::empty(const std::string& name) {
  return parse(Value::object(
      {{"format", kFormatName}, {"format_version", kFormatVersion}, {"name", Value(name)}}));
}

Document Document::parse(Value tree, const std::string& context) {
  std::vector<ParamProblem> problems;
  checkWritable(tree, {}, problems);
  const std::int64_t version = checkHead(tree, problems);
  throwProblems(problems, ErrorCode::ProjectInvalid, context);
  if (version < kFormatVersion) {
    throw Error(ErrorCode::ProjectInvalid,
                wcam::text("format version %1 is not known", {std::to_string(version)}), context,
                wcam::text("the oldest version is %1", {std::to_string(kFormatVersion)}));
  }
  ReadModel model = readModel(tree);
  auto state = std::make_shared<State>();
  if (version > kFormatVersion) {
    state->readOnly = true;
    state->findings.push_back(
        {Severity::Warning,
         "project.newer_version",
         wcam::text("the project was written by a newer version (format %1, "
                    "this program knows %2): it can be looked at, not changed",
                    {std::to_string(version), std::to_string(kFormatVersion)}),
         "open it with the newer version of WCAM",
         {},
         {}});
    // A newer version may know them.
    std::erase_if(model.findings,
                  [](const Diagnostic& finding) { return finding.code == "project.unknown_key"; });
    for (const ParamProblem& problem : model.problems) {
      state->findings.push_back({Severity::Warning,
                                 "project.not_understood",
                                 wcam::text("%1: %2", {problem.path, problem.message}),
                                 "open it with the newer version of WCAM",
                                 {},
                                 {}});
    }
  } else {
    throwProblems(model.problems, ErrorCode::ProjectInvalid, context);
  }
  state->findings.insert(state->findings.end(), model.findings.begin(), model.findings.end());
  state->tree = std::move(tree);
  state->project = std::move(model.project);
  return Document(std::move(state));
}

const Value& Document::tree() const noexcept {
  return state_->tree;
}

const Project& Document::project() const noexcept {
  return state_->project;
}

bool Document::readOnly() const noexcept {
  return state_->readOnly;
}

const std::vector<Diagnostic>& Document::findings() const noexcept {
  return state_->findings;
}

std::string Document::text() const {
  return toCanonicalJson(state_->tree);
}

namespace {

const Value* nodeById(const Value* list, std::string_view id) {
  if (list == nullptr || !list->isArray()) {
    return nullptr;
  }
  for (const Value& node : list->asArray()) {
    const Value* own = node.find("id");
    if (own != nullptr && own->isString() && own->asString() == id) {
      return &node;
    }
  }
  return nullptr;
}

/// Ids of `list` that also stand in `other`, in the order of `list`.
std::vector<std::string> commonIds(const Value* list, const Value* other) {
  std::vector<std::string> ids;
  if (list != nullptr && list->isArray()) {
    for (const Value& node : list->asArray()) {
      const Value* id = node.find("id");
      if (id != nullptr && id->isString() && nodeById(other, id->asString()) != nullptr) {
        ids.push_back(id->asString());
      }
    }
  }
  return ids;
}

void addMissing(const Value* list, const Value* other, std::vector<std::string>& ids) {
  if (list == nullptr || !list->isArray()) {
    return;
  }
  for (const Value& node : list->asArray()) {
    const Value* id = node.find("id");
    if (id != nullptr && id->isString() && nodeById(other, id->asString()) == nullptr) {
      ids.push_back(id->asString());
    }
  }
}

ListChange diffList(const char* name, const Value* before, const Value* after) {
  ListChange change;
  change.list = name;
  addMissing(after, before, change.added);
  addMissing(before, after, change.removed);
  const std::vector<std::string> kept = commonIds(after, before);
  for (const std::string& id : kept) {
    if (*nodeById(before, id) != *nodeById(after, id)) {
      change.changed.push_back(id);
    }
  }
  change.reordered = kept != commonIds(before, after);
  return change;
}

}  // namespace

ChangeSet diff(const Document& before, const Document& after) {
  ChangeSet changes;
  const auto differs = [](const Value* a, const Value* b) {
    return (a == nullptr) != (b == nullptr) || (a != nullptr && *a != *b);
  };
  for (const NodeType& type : nodeTypes()) {
    const Value* a = before.tree().find(type.list);
    const Value* b = after.tree().find(type.list);
    if (!differs(a, b)) {
      continue;
    }
    ListChange change = diffList(type.list, a, b);
    if (!change.added.empty() || !change.removed.empty() || !change.changed.empty() ||
        change.reordered) {
      changes.lists.push_back(std::move(change));
    }
  }
  const auto compareKeys = [&](const Document& from, const Document& to, bool onlyMissing) {
    for (const auto& [key, value] : from.tree().asObject()) {
      const Value* other = to.tree().find(key);
      if (nodeTypeOfList(key) == nullptr &&
          (onlyMissing ? other == nullptr : differs(&value, other))) {
        changes.keys.push_back(key);
      }
    }
  };
  compareKeys(after, before, false);
  compareKeys(before, after, true);
  return changes;
}

}  // namespace wcam::project
