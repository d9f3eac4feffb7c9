// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include <filesystem>
#include <string>

class QListWidget;

namespace wcam::gui {

/// Chooses the robot cell: those that come with the program by their names, or a file.
class CellDialog : public QDialog {
  Q_OBJECT

public:
  /// @param present path of the project's cell, which is chosen first
  /// @param folder where files are looked for
  CellDialog(const std::string& present,
             const std::filesystem::path& folder,
             QWidget* parent = nullptr);

  /// The path for the project, or the file that was chosen; empty when nothing is.
  [[nodiscard]] std::string path() const;

private:
  void chooseFile(const std::filesystem::path& folder);

  QListWidget* cells_;
};

}  // namespace wcam::gui
