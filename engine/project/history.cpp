// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/history.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/text.hpp"

#include <algorithm>

namespace wcam::project {

namespace {

/// Memory of a value without what it may share with others.
std::size_t sizeOf(const Value& value) {
  std::size_t size = sizeof(Value);
  if (value.isString()) {
    size += value.asString().capacity();
  } else if (value.isArray()) {
    for (const Value& item : value.asArray()) {
      size += sizeOf(item);
    }
  } else if (value.isObject()) {
    for (const auto& [key, member] : value.asObject()) {
      size += sizeof(std::string) + key.capacity() + sizeOf(member);
    }
  }
  return size;
}

/// Memory that a document needs beside the one before it: its lists, the nodes that changed, and
/// its model, which is not shared.
std::size_t costOf(const Document& document, const Document& before) {
  // The typed model of a node is about as large as its tree without parameters.
  constexpr std::size_t kModelOfNode = 1024;
  std::size_t cost = sizeof(Document);
  for (const auto& [key, value] : document.tree().asObject()) {
    const Value* old = before.tree().find(key);
    cost += sizeof(Value::Member) + key.capacity();
    if (!value.isArray()) {
      cost += old != nullptr && *old == value ? 0 : sizeOf(value);
      continue;
    }
    const bool listShared = old != nullptr && *old == value;
    for (std::size_t i = 0; i < value.size(); ++i) {
      const bool nodeShared = listShared || (old != nullptr && old->isArray() && i < old->size() &&
                                             old->asArray()[i] == value.asArray()[i]);
      cost += kModelOfNode + (nodeShared ? sizeof(Value) : sizeOf(value.asArray()[i]));
    }
  }
  return cost;
}

}  // namespace

History::History(Document initial, std::size_t byteBudget) : byteBudget_(byteBudget) {
  Snapshot first{std::move(initial), {}, {}, nextId_++, 0};
  first.bytes = sizeOf(first.document.tree());
  bytes_ = first.bytes;
  cleanId_ = first.id;
  snapshots_.push_back(std::move(first));
}

const Document& History::current() const noexcept {
  return group_ ? group_->document : snapshots_[position_].document;
}

bool History::apply(const Command& command, const std::string& mergeKey) {
  Document next = project::apply(current(), command);
  if (next == current()) {
    return false;
  }
  if (group_) {
    group_->document = std::move(next);
    group_->commands.push_back(command);
    return true;
  }
  const Snapshot& top = snapshots_[position_];
  const bool merged = !mergeKey.empty() && top.mergeKey == mergeKey && !isClean() && !canRedo();
  Value line = toValue(command);
  if (merged) {
    line.set("merged", true);
    replaceTop(std::move(next));
  } else {
    push(std::move(next), labelOf(command), mergeKey);
  }
  write(line);
  return true;
}

void History::push(Document document, Text label, std::string mergeKey) {
  while (snapshots_.size() > position_ + 1) {
    bytes_ -= snapshots_.back().bytes;
    snapshots_.pop_back();
  }
  Snapshot next{std::move(document), std::move(label), std::move(mergeKey), nextId_++, 0};
  next.bytes = costOf(next.document, snapshots_.back().document);
  bytes_ += next.bytes;
  snapshots_.push_back(std::move(next));
  ++position_;
  forgetBeyondBudget();
}

void History::replaceTop(Document document) {
  Snapshot& top = snapshots_[position_];
  bytes_ -= top.bytes;
  top.document = std::move(document);
  top.id = nextId_++;
  top.bytes = costOf(top.document, snapshots_[position_ - 1].document);
  bytes_ += top.bytes;
  forgetBeyondBudget();
}

void History::forgetBeyondBudget() {
  std::size_t forgotten = 0;
  while (bytes_ > byteBudget_ && forgotten + 1 < position_) {
    bytes_ -= snapshots_[forgotten++].bytes;
  }
  snapshots_.erase(snapshots_.begin(), snapshots_.begin() + static_cast<std::ptrdiff_t>(forgotten));
  position_ -= forgotten;
}

bool History::canUndo() const noexcept {
  return !group_ && position_ > 0;
}

bool History::canRedo() const noexcept {
  return !group_ && position_ + 1 < snapshots_.size();
}

Text History::undoLabel() const {
  return canUndo() ? snapshots_[position_].label : Text();
}

Text History::redoLabel() const {
  return canRedo() ? snapshots_[position_ + 1].label : Text();
}

bool History::undo() {
  if (!canUndo()) {
    return false;
  }
  // A drag that goes on after an undo or a redo is a new step.
  snapshots_[position_].mergeKey.clear();
  --position_;
  snapshots_[position_].mergeKey.clear();
  write(Value::object({{"command", "undo"}}));
  return true;
}

bool History::redo() {
  if (!canRedo()) {
    return false;
  }
  ++position_;
  snapshots_[position_].mergeKey.clear();
  write(Value::object({{"command", "redo"}}));
  return true;
}

void History::markClean() noexcept {
  cleanId_ = stateId();
}

bool History::isClean() const noexcept {
  return cleanId_ == stateId() && (!group_ || group_->commands.empty());
}

std::uint64_t History::stateId() const noexcept {
  return snapshots_[position_].id;
}

std::vector<Text> History::labels() const {
  std::vector<Text> labels;
  for (std::size_t i = 1; i < snapshots_.size(); ++i) {
    labels.push_back(snapshots_[i].label);
  }
  return labels;
}

std::size_t History::position() const noexcept {
  return position_;
}

std::size_t History::bytes() const noexcept {
  return bytes_;
}

void History::write(const Value& line) const {
  if (log_) {
    log_(toCompactJson(line));
  }
}

History::Transaction::Transaction(History& history, Text label) : history_(history) {
  if (history.group_) {
    throw Error(ErrorCode::Internal, "a transaction is open already");
  }
  history.group_ = Group{std::move(label), history.current(), {}};
}

History::Transaction::~Transaction() {
  if (open_) {
    history_.group_.reset();
  }
}

bool History::Transaction::commit() {
  WCAM_ASSERT(open_);
  open_ = false;
  Group group = std::move(*history_.group_);
  history_.group_.reset();
  if (group.document == history_.current()) {
    return false;
  }
  Value commands = Value::array();
  for (const Command& command : group.commands) {
    commands.push(toValue(command));
  }
  history_.push(std::move(group.document), group.label, {});
  history_.write(
      Value::object({{"transaction", Value(group.label.str())}, {"commands", commands}}));
  return true;
}

void History::replayLine(const Value& line) {
  if (const Value* label = line.find("transaction")) {
    Transaction transaction(*this, label->asString());
    for (const Value& command : line.at("commands").asArray()) {
      apply(commandFromValue(command));
    }
    transaction.commit();
    return;
  }
  const Command command = commandFromValue(line);
  if (command.id == "undo" || command.id == "redo") {
    if (!(command.id == "undo" ? undo() : redo())) {
      throw Error(ErrorCode::InvalidArgument, command.id == "undo"
                                                  ? text("there is nothing to undo")
                                                  : text("there is nothing to redo"));
    }
    return;
  }
  const Value* merged = line.find("merged");
  if (merged == nullptr || !merged->asBool() || !canUndo()) {
    apply(command);
    return;
  }
  Document next = project::apply(current(), command);
  if (!(next == current())) {
    replaceTop(std::move(next));
    write(line);
  }
}

std::size_t History::replay(std::string_view log, const std::string& context) {
  std::size_t applied = 0;
  std::size_t number = 0;
  while (!log.empty()) {
    const std::size_t end = log.find('\n');
    const std::string_view line = trimText(log.substr(0, end));
    log = end == std::string_view::npos ? std::string_view() : log.substr(end + 1);
    ++number;
    if (line.empty() || line.front() == '#') {
      continue;
    }
    const Text place = text("%1, line %2", {context, std::to_string(number)});
    Value parsed;
    try {
      parsed = parseJson(line);
    } catch (const Error& error) {
      throw Error(ErrorCode::InputInvalid, error.messageText(), place,
                  "every line is a JSON object");
    }
    try {
      replayLine(parsed);
    } catch (const Error& error) {
      // A wrong command is a mistake of the file, not of the command line.
      throw Error(
          error.code() == ErrorCode::InvalidArgument ? ErrorCode::InputInvalid : error.code(),
          error.whatText(), place, error.hintText());
    }
    ++applied;
  }
  return applied;
}

}  // namespace wcam::project
