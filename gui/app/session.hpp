// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/project/history.hpp"
#include "wcam/project/project_file.hpp"
#include "wcam/project/project_lock.hpp"

#include "model/generation.hpp"
#include "model/job_runner.hpp"

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>

namespace wcam::gui {

/// The open project: its history, its file with autosave and lock, and what it gives. Every change
/// is a Command; everything that takes time runs in the background. Knows no widgets.
class Session : public QObject {
  Q_OBJECT

public:
  /// Name of a project that was never saved.
  static constexpr const char* kUntitled = "untitled";

  explicit Session(std::shared_ptr<const plugin::PluginHost> plugins, QObject* parent = nullptr);
  ~Session() override;

  [[nodiscard]] const project::Document& document() const { return history_->current(); }

  [[nodiscard]] project::History& history() { return *history_; }

  [[nodiscard]] const plugin::PluginHost& plugins() const { return *plugins_; }

  [[nodiscard]] const std::shared_ptr<const plugin::PluginHost>& sharedPlugins() const {
    return plugins_;
  }

  /// Empty for a project that was never saved.
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

  /// Against which the files of the document are resolved.
  [[nodiscard]] std::filesystem::path base() const;

  [[nodiscard]] bool modified() const { return recovered_ || !history_->isClean(); }

  // Files. Errors are those of the engine.
  /// @param recovered take the autosave of the file instead of the file
  /// @throws Error
  std::vector<Diagnostic> open(const std::filesystem::path& file, bool recovered = false);
  void create(const project::Document& document);
  /// Files outside of the project's folder that were added since the last time are copied beside
  /// it. @throws Error, also when another program has changed the file
  void save();
  /// Saving replaces what another program has written.
  void keepOwn();
  /// Tells when the file is not what was read or saved.
  void lookAtFile();
  /// Files of the project that would be out of reach are copied beside it. @throws Error
  void saveAs(const std::filesystem::path& file);

  /// Who holds the lock of a file; empty: nobody, or this session.
  [[nodiscard]] QString holderOf(const std::filesystem::path& file) const;

  /// Who holds the lock of the file when it is not this program; empty: nobody.
  [[nodiscard]] QString lockedBy() const { return lockedBy_; }

  // Changes.
  /// @return what was wrong; nothing when the command was applied
  std::optional<Error> apply(const project::Command& command, const std::string& mergeKey = {});
  /// Several commands as one step.
  std::optional<Error> applyAll(const std::string& label,
                                const std::vector<project::Command>& commands);
  void undo();
  void redo();
  /// Undoes or redoes until so many steps are done.
  void goTo(std::size_t position);

  // Results.
  [[nodiscard]] const Generated& generated() const { return generated_; }

  /// The results belong to an older document.
  [[nodiscard]] bool stale() const;

  /// The operation to compute before the others.
  void setFirst(const std::string& operation) { first_ = operation; }

  void regenerate();
  void cancel();

  [[nodiscard]] JobRunner& generation() { return *generation_; }

  /// For exports and imports, beside the regeneration.
  [[nodiscard]] JobRunner& tasks() { return *tasks_; }

  [[nodiscard]] project::Pipeline pipeline() const;

  void setAutosaveInterval(int ms) { autosave_.setInterval(ms); }

  /// Work that was never saved is kept here, in the user's data folder.
  [[nodiscard]] static std::filesystem::path untitledFile();
  /// The document of a program that ended badly before its project was saved.
  [[nodiscard]] static std::optional<project::Document> untitledWork();
  void forgetUntitled();
  /// A document that is not saved anywhere.
  void recover(const project::Document& document);

  /// Writes the autosave now when there is something to save.
  void autosaveNow();

signals:
  void documentChanged();
  void fileChanged();
  void changedOnDisk();  ///< by another program
  /// More results are there, or all.
  void resultsChanged();
  void stateChanged();  ///< running, stale, cancelled
  void failed(const QString& message);

private:
  void setHistory(const project::Document& document);
  void changed();
  void lock();
  void watch();
  void markSaved();
  /// Copies files that lie elsewhere beside a project file, as one step.
  void bringFiles(const std::filesystem::path& to, const std::set<std::string>& kept);

  [[nodiscard]] std::filesystem::path autosaveOf() const {
    return file_.empty() ? untitledFile() : file_;
  }

  std::shared_ptr<const plugin::PluginHost> plugins_;
  std::shared_ptr<project::StageCache> cache_;
  std::unique_ptr<project::History> history_;
  std::filesystem::path file_;
  std::unique_ptr<project::ProjectLock> lock_;
  QFileSystemWatcher watcher_;
  std::string onDisk_;   ///< hash of the file as it was read or saved
  std::string offered_;  ///< hash of the changed file that was told last
  QString lockedBy_;
  QTimer autosave_;
  QTimer soon_;  ///< an autosave when the changes rest
  QTimer delay_;
  std::uint64_t autosaved_ = 0;
  bool autosaveThere_ = false;        ///< this session wrote one that is still there
  std::set<std::string> savedPaths_;  ///< files that the project on disk names
  bool recovered_ = false;            ///< the document came from an autosave and is not on disk
  std::uint64_t epoch_ = 0;           ///< raised with every project that is opened
  Generated generated_;
  std::string first_;
  std::unique_ptr<JobRunner> generation_;
  std::unique_ptr<JobRunner> tasks_;
};

}  // namespace wcam::gui
