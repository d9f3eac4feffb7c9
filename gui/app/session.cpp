// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "session.hpp"

#include "wcam/base/budget.hpp"
#include "wcam/base/file_io.hpp"
#include "wcam/base/sha256.hpp"

#include "widgets/text.hpp"

#include <QCoreApplication>
#include <QMetaObject>
#include <QPointer>
#include <QStandardPaths>

namespace wcam::gui {

namespace {

// Typing and dragging make one regeneration.
constexpr int kDelayMs = 180;
constexpr int kAutosaveMs = 20000;
// Changes that rest so long are kept at once: a crash may take no more than what was just typed.
constexpr int kAutosaveSoonMs = 1500;

/// Calls functions on the thread of an object, as long as it lives.
JobRunner::Post postTo(QObject* object) {
  return [guard = QPointer<QObject>(QCoreApplication::instance()),
          object](std::function<void()> call) {
    static_cast<void>(object);
    if (guard) {
      QMetaObject::invokeMethod(guard.data(), std::move(call), Qt::QueuedConnection);
    }
  };
}

project::Command setFile(const std::string& owner, const std::string& id, const std::string& path) {
  const Value file = Value::object({{"path", path}, {"sha256", ""}});
  return owner == "cell"
             ? project::Command{"cell.set", Value::object({{"file", file}})}
             : project::Command{owner + ".set", Value::object({{"id", id}, {"file", file}})};
}

bool isInside(const std::filesystem::path& path, const std::filesystem::path& folder) {
  const std::filesystem::path relative = path.lexically_relative(folder);
  return !relative.empty() && *relative.begin() != "..";
}

/// Copies a file beside the project unless an equal one is there. @return its name in the project
std::string broughtBeside(const std::filesystem::path& source,
                          const std::filesystem::path& folder) {
  const std::filesystem::path target = folder / source.filename();
  std::error_code ignored;
  if (std::filesystem::exists(target, ignored)) {
    if (readFile(target) != readFile(source)) {
      throw Error(ErrorCode::OutputConflict, "another file of this name lies beside the project",
                  pathText(target), "rename one of them");
    }
  } else {
    writeFileAtomically(target, readFile(source));
  }
  return pathText(source.filename());
}

std::set<std::string> pathsOf(const project::Document& document) {
  std::set<std::string> paths;
  for (const project::UsedFile& used : project::usedFiles(document)) {
    paths.insert(used.ref.path);
  }
  return paths;
}

/// The commands that make a document's files reachable from another project file.
/// @param kept paths that stay as they are
std::vector<project::Command> relocate(const project::Document& document,
                                       const std::filesystem::path& from,
                                       const std::filesystem::path& to,
                                       const std::set<std::string>& kept = {}) {
  std::vector<project::Command> commands;
  const std::filesystem::path folder = std::filesystem::absolute(to).parent_path();
  const auto place = [&](const std::string& owner, const std::string& id,
                         const project::FileRef& ref) {
    if (ref.empty() || ref.path.rfind(project::kShippedPrefix, 0) == 0 ||
        kept.count(ref.path) != 0) {
      return;
    }
    if (from == to && !pathFromText(ref.path).is_absolute()) {
      return;  // in reach already
    }
    const std::filesystem::path file =
        std::filesystem::absolute(project::resolvePath(from, ref)).lexically_normal();
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) {
      return;  // stays missing, and is told by the check of the files
    }
    const std::string path = isInside(file, folder)
                                 ? file.lexically_relative(folder).generic_string()
                                 : broughtBeside(file, folder);
    if (path != ref.path) {
      commands.push_back(setFile(owner, id, path));
    }
  };
  const project::Project& project = document.project();
  place("cell", {}, project.cell);
  for (const auto& node : project.parts) {
    place("part", node.id, node.file);
  }
  for (const auto& node : project.guides) {
    place("guide", node.id, node.file);
  }
  for (const auto& node : project.processes) {
    place("process", node.id, node.file);
  }
  for (const auto& node : project.operations) {
    place("operation", node.id, node.file);
  }
  return commands;
}

}  // namespace

Session::Session(std::shared_ptr<const plugin::PluginHost> plugins, QObject* parent)
    : QObject(parent),
      plugins_(std::move(plugins)),
      // Whoever changes one thing and sees the rest again needs more of it than a single run.
      cache_(std::make_shared<project::StageCache>(
          256, static_cast<std::size_t>(budget().memoryMb << 20U) / 4)),
      generation_(std::make_unique<JobRunner>(postTo(this))),
      tasks_(std::make_unique<JobRunner>(postTo(this))) {
  setHistory(project::Document::empty(kUntitled));
  history_->markClean();
  delay_.setSingleShot(true);
  delay_.setInterval(kDelayMs);
  connect(&delay_, &QTimer::timeout, this, &Session::regenerate);
  autosave_.setInterval(kAutosaveMs);
  connect(&autosave_, &QTimer::timeout, this, &Session::autosaveNow);
  autosave_.start();
  connect(&watcher_, &QFileSystemWatcher::fileChanged, this, &Session::lookAtFile);
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, &Session::lookAtFile);
  soon_.setSingleShot(true);
  soon_.setInterval(kAutosaveSoonMs);
  connect(&soon_, &QTimer::timeout, this, &Session::autosaveNow);
}

Session::~Session() {
  // The jobs end before what they report to.
  generation_.reset();
  tasks_.reset();
}

std::filesystem::path Session::base() const {
  return file_.empty() ? std::filesystem::current_path() / "untitled.wcam" : file_;
}

void Session::setHistory(const project::Document& document) {
  ++epoch_;
  history_ = std::make_unique<project::History>(document);
}

std::vector<Diagnostic> Session::open(const std::filesystem::path& file, bool recovered) {
  const std::filesystem::path path = std::filesystem::absolute(file);
  project::LoadedProject loaded = project::loadProject(path);
  const project::Document onDisk = loaded.document;
  if (recovered) {
    if (auto saved = project::recoverable(path)) {
      loaded.document = saved->document;
    }
  }
  cancel();
  setHistory(loaded.document);
  recovered_ = recovered && !(loaded.document == onDisk);
  file_ = path;
  generated_ = {};
  first_.clear();
  autosaved_ = history_->stateId();
  autosaveThere_ = recovered_;
  savedPaths_ = pathsOf(onDisk);
  onDisk_ = loaded.sha256;
  offered_.clear();
  lock();
  watch();
  emit fileChanged();
  changed();
  return loaded.findings;
}

void Session::create(const project::Document& document) {
  cancel();
  if (file_.empty() && modified()) {
    forgetUntitled();
  }
  setHistory(document);
  file_.clear();
  recovered_ = false;
  lock_.reset();
  watch();
  lockedBy_.clear();
  generated_ = {};
  first_.clear();
  autosaved_ = history_->stateId();
  autosaveThere_ = false;
  savedPaths_.clear();
  emit fileChanged();
  changed();
}

QString Session::holderOf(const std::filesystem::path& file) const {
  const std::filesystem::path path = std::filesystem::absolute(file);
  if (path == file_ && lock_) {
    return {};
  }
  // A folder that cannot be written to has no lock, and needs none.
  const auto attempt = project::ProjectLock::attempt(path, project::ProjectLock::Use::Open);
  return attempt.holder.empty() ? QString() : qt(attempt.holder.str());
}

void Session::lock() {
  lock_.reset();
  auto attempt = project::ProjectLock::attempt(file_, project::ProjectLock::Use::Open);
  lockedBy_ = attempt.holder.empty() ? QString() : qt(attempt.holder.str());
  lock_ = std::move(attempt.lock);
}

void Session::watch() {
  if (!watcher_.files().isEmpty()) {
    watcher_.removePaths(watcher_.files());
  }
  if (!watcher_.directories().isEmpty()) {
    watcher_.removePaths(watcher_.directories());
  }
  if (!file_.empty()) {
    // Programs that replace a file rather than write it are seen in its folder.
    watcher_.addPath(qt(pathText(file_)));
    watcher_.addPath(qt(pathText(file_.parent_path())));
  }
}

void Session::lookAtFile() {
  std::error_code ignored;
  if (file_.empty() || !std::filesystem::is_regular_file(file_, ignored)) {
    return;
  }
  try {
    const std::string now = sha256OfFile(file_);
    if (now != onDisk_ && now != offered_) {
      offered_ = now;
      emit changedOnDisk();
    }
  } catch (const Error&) {
    return;  // being replaced: the next look tells
  }
  if (watcher_.files().isEmpty()) {
    watcher_.addPath(qt(pathText(file_)));
  }
}

void Session::keepOwn() {
  onDisk_ = sha256OfFile(file_);
}

void Session::save() {
  if (!lockedBy_.isEmpty()) {
    throw Error(ErrorCode::OutputConflict,
                "another program has the project open (" + utf8(lockedBy_) + ")", pathText(file_),
                "close it there, or save under another name");
  }
  bringFiles(file_, savedPaths_);
  project::saveProject(document(), file_, onDisk_);
  project::dropAutosave(file_);
  markSaved();
  emit fileChanged();
}

void Session::bringFiles(const std::filesystem::path& to, const std::set<std::string>& kept) {
  const std::vector<project::Command> commands = relocate(document(), base(), to, kept);
  if (!commands.empty()) {
    if (const auto error = applyAll(utf8(tr("Bring files to the project")), commands)) {
      throw Error(*error);
    }
  }
}

void Session::markSaved() {
  history_->markClean();
  recovered_ = false;
  autosaved_ = history_->stateId();
  autosaveThere_ = false;
  savedPaths_ = pathsOf(document());
  onDisk_ = sha256Hex(document().text());
}

void Session::saveAs(const std::filesystem::path& file) {
  const std::filesystem::path path = std::filesystem::absolute(file);
  // Its own lock is held; another project that is open elsewhere is not replaced.
  auto target = path == file_ && lock_ ? nullptr : project::ProjectLock::take(path);
  // A project that got no name of its own bears that of its first file.
  if (file_.empty() && document().project().name == kUntitled) {
    if (const auto error =
            apply({"project.rename", Value::object({{"name", pathText(path.stem())}})}, {})) {
      throw Error(*error);
    }
  }
  bringFiles(path, {});
  project::saveProject(document(), path);
  project::dropAutosave(path);
  if (file_.empty()) {
    forgetUntitled();
  } else if (file_ != path && lockedBy_.isEmpty()) {
    project::dropAutosave(file_);
  }
  file_ = path;
  markSaved();
  target.reset();
  lock();
  watch();
  emit fileChanged();
  emit documentChanged();
}

std::optional<Error> Session::apply(const project::Command& command, const std::string& mergeKey) {
  try {
    if (history_->apply(command, mergeKey)) {
      changed();
    }
    return std::nullopt;
  } catch (const Error& error) {
    return error;
  }
}

std::optional<Error> Session::applyAll(const std::string& label,
                                       const std::vector<project::Command>& commands) {
  try {
    project::History::Transaction transaction(*history_, label);
    for (const project::Command& command : commands) {
      history_->apply(command);
    }
    transaction.commit();
  } catch (const Error& error) {
    return error;
  }
  changed();
  return std::nullopt;
}

void Session::undo() {
  if (history_->undo()) {
    changed();
  }
}

void Session::redo() {
  if (history_->redo()) {
    changed();
  }
}

void Session::goTo(std::size_t position) {
  bool any = false;
  while (history_->position() > position && history_->undo()) {
    any = true;
  }
  while (history_->position() < position && history_->redo()) {
    any = true;
  }
  if (any) {
    changed();
  }
}

void Session::changed() {
  emit documentChanged();
  emit stateChanged();
  delay_.start();
  soon_.start();
}

bool Session::stale() const {
  return generated_.state != history_->stateId();
}

project::Pipeline Session::pipeline() const {
  return {document(), base(), plugins_, cache_};
}

void Session::regenerate() {
  delay_.stop();
  const std::uint64_t state = history_->stateId();
  auto result = std::make_shared<Generated>();
  const auto show = [this, state, epoch = epoch_](const Generated& partial) {
    if (epoch != epoch_) {
      return;  // of a project that was closed
    }
    // What is not there yet keeps its old picture.
    Generated next = partial;
    next.state = state;
    for (const GeneratedOperation& old : generated_.operations) {
      const project::Operation* operation = document().project().operation(old.id);
      if (next.operation(old.id) == nullptr && operation != nullptr && operation->enabled) {
        next.operations.push_back(old);
      }
    }
    for (const GeneratedPart& old : generated_.parts) {
      if (next.part(old.id) == nullptr && document().project().part(old.id) != nullptr) {
        next.parts.push_back(old);
      }
    }
    if (next.cell == nullptr) {
      next.cell = generated_.cell;
    }
    const bool whole = generated_.state == state;
    generated_ = std::move(next);
    if (!whole) {
      // Old until the whole is there.
      generated_.state = 0;
    }
    emit resultsChanged();
  };
  generation_->start({utf8(tr("Regenerate")),
                      [result, pipeline = pipeline(), first = first_, before = generated_, show,
                       runner = generation_.get()](const JobContext& context) {
                        *result = generate(pipeline, first, before, context,
                                           [&](const Generated& partial) {
                                             runner->deliver([show, partial] { show(partial); });
                                           });
                      },
                      [this, result, state, epoch = epoch_](const std::optional<Error>& error) {
                        if (epoch != epoch_) {
                          return;
                        }
                        if (error && error->code() == ErrorCode::Cancelled) {
                          emit stateChanged();
                          return;
                        }
                        if (error) {
                          result->error = error;
                          emit failed(errorText(*error));
                        }
                        result->state = state;
                        generated_ = std::move(*result);
                        emit resultsChanged();
                        emit stateChanged();
                      }});
  emit stateChanged();
}

void Session::cancel() {
  delay_.stop();
  generation_->cancel();
}

std::filesystem::path Session::untitledFile() {
  return pathFromText(
             utf8(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation))) /
         "untitled.wcam";
}

std::optional<project::Document> Session::untitledWork() {
  std::error_code ignored;
  const std::filesystem::path saved = project::autosavePath(untitledFile());
  if (!std::filesystem::exists(saved, ignored)) {
    return std::nullopt;
  }
  try {
    return project::loadProject(saved).document;
  } catch (const Error&) {
    return std::nullopt;  // damaged: there is nothing to offer
  }
}

void Session::forgetUntitled() {
  project::dropAutosave(untitledFile());
}

void Session::recover(const project::Document& document) {
  create(document);
  recovered_ = true;
  autosaved_ = 0;
  emit fileChanged();
}

void Session::autosaveNow() {
  soon_.stop();
  if (!lockedBy_.isEmpty() || autosaved_ == history_->stateId()) {
    return;
  }
  try {
    if (modified()) {
      if (file_.empty()) {
        createFolder(untitledFile().parent_path());
      }
      project::autosave(document(), autosaveOf());
      autosaveThere_ = true;
    } else if (autosaveThere_) {
      // All was undone: nothing is left to recover.
      project::dropAutosave(autosaveOf());
      autosaveThere_ = false;
    }
    autosaved_ = history_->stateId();
  } catch (const Error& error) {
    emit failed(errorText(error));
  }
}

}  // namespace wcam::gui
