// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "project_tree.hpp"

#include "text.hpp"

#include <QContextMenuEvent>
#include <QHeaderView>

#include <set>

namespace wcam::gui {

namespace {

constexpr int kListRole = Qt::UserRole + 1;
constexpr int kIdRole = Qt::UserRole + 2;
constexpr int kIconRole = Qt::UserRole + 3;

QStandardItem* itemOf(const NodeRef& node, const QString& text, const QString& iconName) {
  auto* item = new QStandardItem(icon(iconName), text);
  item->setData(qt(node.list), kListRole);
  item->setData(qt(node.id), kIdRole);
  item->setData(iconName, kIconRole);
  item->setEditable(false);
  return item;
}

QStandardItem* badgeItem(const NodeRef& node) {
  auto* item = new QStandardItem;
  item->setData(qt(node.list), kListRole);
  item->setData(qt(node.id), kIdRole);
  item->setEditable(false);
  return item;
}

}  // namespace

NodeRef editRef(const std::string& operation, const std::string& edit) {
  return {"edits", operation + "/" + edit};
}

std::string operationOf(const NodeRef& edit) {
  return edit.id.substr(0, edit.id.find('/'));
}

std::string editIdOf(const NodeRef& edit) {
  return edit.id.substr(edit.id.find('/') + 1);
}

template <class Visit>
void ProjectTree::forNodes(const Visit& visit, const QModelIndex& parent) const {
  for (int i = 0; i < model_.rowCount(parent); ++i) {
    const QModelIndex index = model_.index(i, 0, parent);
    visit(index);
    forNodes(visit, index);
  }
}

ProjectTree::ProjectTree(QWidget* parent) : QTreeView(parent) {
  setObjectName("projectTree");
  setAccessibleName(tr("Project"));
  setModel(&model_);
  setHeaderHidden(true);
  setUniformRowHeights(true);
  setIndentation(14);
  setIconSize({18, 18});
  setSelectionMode(QAbstractItemView::SingleSelection);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  connect(selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this](const QModelIndex& current) {
            if (!filling_) {
              emit nodeSelected(nodeOf(current));
            }
          });
  connect(&model_, &QStandardItemModel::itemChanged, this, [this](QStandardItem* item) {
    if (!filling_ && item->isCheckable()) {
      emit enabledChanged(nodeOf(item->index()), item->checkState() == Qt::Checked);
    }
  });
}

NodeRef ProjectTree::nodeOf(const QModelIndex& index) {
  return {utf8(index.data(kListRole).toString()), utf8(index.data(kIdRole).toString())};
}

NodeRef ProjectTree::selected() const {
  return nodeOf(currentIndex());
}

QModelIndex ProjectTree::indexOf(const NodeRef& node) const {
  QModelIndex found;
  forNodes([&](const QModelIndex& index) {
    if (!found.isValid() && nodeOf(index) == node) {
      found = index;
    }
  });
  return found;
}

void ProjectTree::select(const NodeRef& node) {
  const QModelIndex index = indexOf(node);
  if (index.isValid()) {
    setCurrentIndex(index);
    scrollTo(index);
  }
}

void ProjectTree::setDocument(const project::Document& document) {
  document_ = document;
  const NodeRef before = selected();
  std::set<NodeRef> closed;
  forNodes([&](const QModelIndex& index) {
    if (model_.hasChildren(index) && !isExpanded(index)) {
      closed.insert(nodeOf(index));
    }
  });
  filling_ = true;
  model_.clear();
  model_.setColumnCount(2);
  const project::Project& project = document.project();
  const auto addTop = [this](const NodeRef& node, const QString& text, const QString& iconName) {
    QStandardItem* item = itemOf(node, text, iconName);
    QFont font = item->font();
    font.setBold(true);
    item->setFont(font);
    model_.appendRow({item, badgeItem(node)});
    return item;
  };
  const auto addList = [&](const char* list, const QString& title, const QString& iconName,
                           const auto& nodes) {
    QStandardItem* top = addTop({list, {}}, title, iconName);
    for (const auto& node : nodes) {
      const NodeRef ref{list, node.id};
      QStandardItem* item = itemOf(ref, qt(node.id), iconName);
      if constexpr (requires { node.enabled; }) {
        item->setCheckable(true);
        item->setCheckState(node.enabled ? Qt::Checked : Qt::Unchecked);
      }
      if constexpr (requires { node.edits; }) {
        item->setToolTip(tr("Strategy: %1").arg(qt(node.strategy)));
        for (const project::OperationEdit& edit : node.edits) {
          const NodeRef own = editRef(node.id, edit.id);
          QStandardItem* child = itemOf(own, qt(edit.id), "edit");
          child->setCheckable(true);
          child->setCheckState(edit.enabled ? Qt::Checked : Qt::Unchecked);
          child->setToolTip(engineText(toolpath::infoOf(edit.type).name));
          item->appendRow({child, badgeItem(own)});
        }
      }
      top->appendRow({item, badgeItem(ref)});
    }
  };
  QString cell = qt(project.cell.path);
  cell =
      cell.isEmpty() ? tr("Cell: none") : tr("Cell: %1").arg(cell.section('/', -1).remove(".json"));
  addTop({"cell", {}}, cell, "cell")->setToolTip(qt(project.cell.path));
  addList("parts", tr("Parts"), "part", project.parts);
  addList("substrates", tr("Substrates"), "substrate", project.substrates);
  addList("guides", tr("Guide curves"), "guide", project.guides);
  addList("processes", tr("Processes"), "process", project.processes);
  addList("operations", tr("Operations"), "operation", project.operations);
  addList("outputs", tr("Outputs"), "output", project.outputs);
  forNodes([&](const QModelIndex& index) { setExpanded(index, closed.count(nodeOf(index)) == 0); });
  header()->setStretchLastSection(false);
  header()->setMinimumSectionSize(20);
  header()->setSectionResizeMode(0, QHeaderView::Stretch);
  header()->setSectionResizeMode(1, QHeaderView::Fixed);
  header()->resizeSection(1, 28);
  showBadges();
  if (const QModelIndex index = indexOf(before); index.isValid()) {
    setCurrentIndex(index);
  }
  filling_ = false;
  if (selected() != before) {
    emit nodeSelected(selected());
  }
}

void ProjectTree::setBadges(const std::map<NodeRef, Badge>& badges) {
  badges_ = badges;
  filling_ = true;
  showBadges();
  filling_ = false;
}

void ProjectTree::showBadges() {
  const auto show = [this](const QModelIndex& index) {
    const Badge own = badge(nodeOf(index));
    QStandardItem* item = model_.itemFromIndex(index.siblingAtColumn(1));
    item->setIcon(statusIcon(own.status));
    item->setToolTip(own.tip);
  };
  forNodes(show);
}

Badge ProjectTree::badge(const NodeRef& node) const {
  const auto found = badges_.find(node);
  return found != badges_.end() ? found->second : Badge{};
}

void ProjectTree::updateIcons() {
  setDocument(project::Document(document_));
}

void ProjectTree::contextMenuEvent(QContextMenuEvent* event) {
  // From the keyboard the menu opens at the current node.
  if (event->reason() == QContextMenuEvent::Keyboard) {
    const QRect box = visualRect(currentIndex());
    emit nodeMenu(selected(), viewport()->mapToGlobal(box.center()));
    return;
  }
  const QModelIndex index = indexAt(event->pos());
  emit nodeMenu(index.isValid() ? nodeOf(index) : NodeRef{}, event->globalPos());
}

}  // namespace wcam::gui
