// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/project/document.hpp"

#include "icons.hpp"

#include <QStandardItemModel>
#include <QTreeView>

#include <functional>
#include <map>
#include <string>

namespace wcam::gui {

/// A node of the project: list "parts" and id, "cell" without id, or a list alone. An edit of an
/// operation has the list "edits" and the id "operation/edit".
struct NodeRef {
  std::string list;
  std::string id;
  friend auto operator<=>(const NodeRef&, const NodeRef&) = default;

  [[nodiscard]] bool empty() const { return list.empty(); }
};

/// The node of an edit, and what it names.
NodeRef editRef(const std::string& operation, const std::string& edit);
std::string operationOf(const NodeRef& edit);
std::string editIdOf(const NodeRef& edit);

struct Badge {
  Status status = Status::None;
  QString tip;
};

/// The project as a tree: cell, parts, substrates, guides, processes, operations with their edits,
/// outputs, each with a badge. Selection and open branches stay over changes of the document.
class ProjectTree : public QTreeView {
  Q_OBJECT

public:
  explicit ProjectTree(QWidget* parent = nullptr);

  void setDocument(const project::Document& document);
  void setBadges(const std::map<NodeRef, Badge>& badges);
  [[nodiscard]] NodeRef selected() const;
  void select(const NodeRef& node);
  [[nodiscard]] Badge badge(const NodeRef& node) const;
  void updateIcons();

signals:
  void nodeSelected(const wcam::gui::NodeRef& node);
  void nodeMenu(const wcam::gui::NodeRef& node, const QPoint& global);
  void enabledChanged(const wcam::gui::NodeRef& node, bool enabled);

protected:
  void contextMenuEvent(QContextMenuEvent* event) override;

private:
  [[nodiscard]] QModelIndex indexOf(const NodeRef& node) const;
  [[nodiscard]] static NodeRef nodeOf(const QModelIndex& index);
  void showBadges();
  /// Calls visit(index) for every node, parents first.
  template <class Visit>
  void forNodes(const Visit& visit, const QModelIndex& parent = {}) const;

  QStandardItemModel model_;
  std::map<NodeRef, Badge> badges_;
  project::Document document_;
  bool filling_ = false;
};

}  // namespace wcam::gui
