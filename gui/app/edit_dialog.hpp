// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/project/commands.hpp"

#include <QDialog>

#include <string>

class QComboBox;
class QLineEdit;
class QListWidget;

namespace wcam::gui {

/// Chooses what an edit does, with a picture and a sentence each, and the operation that it
/// changes.
class EditDialog : public QDialog {
  Q_OBJECT

public:
  EditDialog(const project::Document& document,
             const std::string& operation,
             QWidget* parent = nullptr);
  [[nodiscard]] std::string operation() const;
  [[nodiscard]] std::string id() const;
  [[nodiscard]] std::string type() const;

private:
  void proposeId();

  project::Document document_;
  QListWidget* types_;
  QComboBox* operation_;
  QLineEdit* id_;
};

/// An id that no edit of the operation has, from a wanted text.
std::string freeEditId(const project::Document& document,
                       const std::string& operation,
                       const std::string& wanted);

}  // namespace wcam::gui
