// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/project/commands.hpp"
#include "wcam/project/document.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wcam::project {

/// Undo and redo as a list of snapshots that share their unchanged nodes. Belongs to one thread.
class History {
public:
  /// Called with one line of JSON (without line feed) for everything that changes the current
  /// document; a file of these lines can be replayed.
  using LogSink = std::function<void(const std::string& line)>;

  static constexpr std::size_t kDefaultByteBudget = std::size_t{256} << 20;

  /// @param byteBudget the oldest snapshots are forgotten beyond it; the current and the previous
  /// one stay
  explicit History(Document initial, std::size_t byteBudget = kDefaultByteBudget);

  void setLog(LogSink sink) { log_ = std::move(sink); }

  /// The document to show and to work on; inside a transaction with its commands so far.
  [[nodiscard]] const Document& current() const noexcept;

  /// Applies a command as one step, or inside the open transaction. Commands with the same
  /// non-empty `mergeKey` that follow each other make one step (slider drags).
  /// @return false when the document stays as it was; then there is no step
  /// @throws as project::apply; nothing changes then
  bool apply(const Command& command, const std::string& mergeKey = {});

  [[nodiscard]] bool canUndo() const noexcept;
  [[nodiscard]] bool canRedo() const noexcept;
  [[nodiscard]] Text undoLabel() const;  ///< empty when there is nothing to undo
  [[nodiscard]] Text redoLabel() const;
  bool undo();  ///< false when there is nothing to undo or a transaction is open
  bool redo();

  /// Says that the current document is the one on disk.
  void markClean() noexcept;
  [[nodiscard]] bool isClean() const noexcept;
  /// Another number after every change; the same again after undo and redo.
  [[nodiscard]] std::uint64_t stateId() const noexcept;

  /// Labels of the steps that are kept, oldest first; the first position() of them are done.
  [[nodiscard]] std::vector<Text> labels() const;
  [[nodiscard]] std::size_t position() const noexcept;
  /// Estimated memory of the snapshots.
  [[nodiscard]] std::size_t bytes() const noexcept;

  /// Groups commands into one step. Without commit(), for example when an exception passes, the
  /// document is as before. Only one at a time: @throws Error(Internal)
  class Transaction {
  public:
    Transaction(History& history, Text label);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    /// @return false when the group changed nothing
    bool commit();

  private:
    History& history_;
    bool open_ = true;
  };

  /// Replays a session log: one JSON object per line, a command {"command", "args"}, a group
  /// {"transaction", "commands"}, {"command": "undo"} or {"command": "redo"}; blank lines and lines
  /// that start with '#' are skipped.
  /// @param context names the log in messages
  /// @return how many lines were applied
  /// @throws Error with the code of the failure, naming the line; the history keeps what was
  /// applied before it
  std::size_t replay(std::string_view log, const std::string& context);

private:
  struct Snapshot {
    Document document;
    Text label;            ///< of the step that led here
    std::string mergeKey;  ///< empty: nothing may be merged into this step
    std::uint64_t id = 0;
    std::size_t bytes = 0;
  };

  struct Group {
    Text label;
    Document document;
    std::vector<Command> commands;
  };

  void push(Document document, Text label, std::string mergeKey);
  void replaceTop(Document document);
  void forgetBeyondBudget();
  void replayLine(const Value& line);
  void write(const Value& line) const;

  std::vector<Snapshot> snapshots_;  ///< never empty; what is undone stands after position_
  std::size_t position_ = 0;
  std::size_t byteBudget_;
  std::size_t bytes_ = 0;
  std::uint64_t nextId_ = 1;
  std::optional<std::uint64_t> cleanId_;
  std::optional<Group> group_;
  LogSink log_;
};

}  // namespace wcam::project
