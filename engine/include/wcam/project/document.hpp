// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/diagnostic.hpp"
#include "wcam/base/value.hpp"
#include "wcam/project/model.hpp"

#include <memory>
#include <string>
#include <vector>

namespace wcam::project {

inline constexpr int kFormatVersion = 1;
inline constexpr const char* kFormatName = "wcam-project";

/// A project at one moment: an immutable value. It holds the JSON tree of the .wcam file (key order
/// and unknown keys kept at every level) and the typed model read from it. A copy costs a pointer;
/// the tree shares unchanged nodes with the document it was made from.
class Document {
public:
  /// An empty, valid project without a name.
  Document();
  [[nodiscard]] static Document empty(const std::string& name);

  /// Reads and checks a tree of the current format version; a newer version gives a read-only
  /// document, of which the parts that are understood are in the model.
  /// @param context names the file in messages
  /// @throws Error(ProjectInvalid) listing every problem with its JSON path
  [[nodiscard]] static Document parse(Value tree, const std::string& context = {});

  [[nodiscard]] const Value& tree() const noexcept;
  [[nodiscard]] const Project& project() const noexcept;
  /// Written by a newer version: it can be looked at, not changed and not saved.
  [[nodiscard]] bool readOnly() const noexcept;
  /// What is valid but doubtful: paths that leave the project's folder, a newer version.
  [[nodiscard]] const std::vector<Diagnostic>& findings() const noexcept;
  /// The bytes of the .wcam file.
  [[nodiscard]] std::string text() const;

  /// Compares the trees, which decide everything else.
  friend bool operator==(const Document& a, const Document& b) {
    return a.state_ == b.state_ || a.tree() == b.tree();
  }

private:
  struct State;

  explicit Document(std::shared_ptr<const State> state) : state_(std::move(state)) {}

  std::shared_ptr<const State> state_;
};

/// Which nodes differ between two documents, by list and id; for views that update only what
/// changed. Costs little for documents that share their nodes.
struct ListChange {
  std::string list;  ///< "parts", "operations", ...
  std::vector<std::string> added;
  std::vector<std::string> removed;
  std::vector<std::string> changed;
  bool reordered = false;  ///< the nodes present in both stand in another order
};

struct ChangeSet {
  std::vector<ListChange> lists;  ///< only those that differ
  std::vector<std::string> keys;  ///< other top-level keys that differ

  [[nodiscard]] bool empty() const noexcept { return lists.empty() && keys.empty(); }
};

ChangeSet diff(const Document& before, const Document& after);

}  // namespace wcam::project
