// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "param_form.hpp"

#include "wcam/base/json.hpp"

#include "icons.hpp"
#include "text.hpp"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHelpEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QRegularExpression>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QSignalBlocker>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QStylePainter>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace wcam::gui {

namespace {

/// Rows whose widgets are made in one turn of the event loop.
constexpr std::size_t kRowsAtOnce = 8;
/// Lines of a list of objects; a longer one is scrolled.
constexpr int kMostListLines = 6;

/// A choice that the wheel does not change while the form is scrolled, with a list as wide as its
/// entries.
class CalmComboBox : public QComboBox {
public:
  using QComboBox::QComboBox;

  void showPopup() override {
    const int bar = style()->pixelMetric(QStyle::PM_ScrollBarExtent);
    const QRect room = screen()->availableGeometry();
    view()->setMinimumWidth(std::min(view()->sizeHintForColumn(0) + bar, room.width()));
    QComboBox::showPopup();
    // A list that is wider than its box stays on the screen.
    QWidget* list = view()->window();
    if (list != window() && list->frameGeometry().right() > room.right()) {
      list->move(std::max(room.left(), room.right() + 1 - list->frameGeometry().width()),
                 list->y());
    }
  }

protected:
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }

  /// A text that has no room ends in an ellipsis …
  void paintEvent(QPaintEvent*) override {
    QStylePainter painter(this);
    QStyleOptionComboBox option;
    initStyleOption(&option);
    painter.drawComplexControl(QStyle::CC_ComboBox, option);
    option.currentText =
        fontMetrics().elidedText(option.currentText, Qt::ElideRight, roomForText(option));
    painter.drawControl(QStyle::CE_ComboBoxLabel, option);
  }

  /// … and stands in full in the tip.
  bool event(QEvent* event) override {
    if (event->type() == QEvent::ToolTip) {
      QStyleOptionComboBox option;
      initStyleOption(&option);
      if (fontMetrics().horizontalAdvance(currentText()) > roomForText(option)) {
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(),
                           "<b>" + currentText().toHtmlEscaped() + "</b><br/>" + toolTip(), this);
        return true;
      }
    }
    return QComboBox::event(event);
  }

private:
  [[nodiscard]] int roomForText(const QStyleOptionComboBox& option) const {
    constexpr int kMargins = 4;
    return style()
               ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this)
               .width() -
           kMargins;
  }
};

QString numberText(double value) {
  // Without a sign that only rounding has left.
  QString text = qt(formatReal(value == 0.0 ? 0.0 : value));
  if (text.endsWith(".0")) {
    text.chop(2);
  }
  return localFigure(text);
}

QString valueText(const Value& value) {
  if (value.isString()) {
    return qt(value.asString());
  }
  if (value.isBool()) {
    return value.asBool() ? ParamForm::tr("yes") : ParamForm::tr("no");
  }
  if (value.isInteger()) {
    return QString::number(value.asInteger());
  }
  if (value.isNumber()) {
    return numberText(value.asReal());
  }
  if (value.isArray()) {
    QStringList items;
    for (const Value& item : value.asArray()) {
      items.append(valueText(item));
    }
    return items.join(listSeparator());
  }
  return {};
}

/// Numbers as some languages write them, in the way of files: a comma between digits is their
/// decimal point, and ';' stands between numbers.
QString withDecimalPoints(QString text) {
  static const QRegularExpression kDecimalComma("(?<=\\d),(?=\\d)");
  return text.replace(kDecimalComma, ".").replace(';', ',');
}

/// A text as files write it, or else as the user's language does.
Value parsed(const ParamSchema& schema,
             const ParamDef& def,
             const QString& text,
             const QLocale& locale) {
  const std::string& key = def.info.key;
  const bool isNumber = def.type == ParamType::Real || def.type == ParamType::Vector3;
  if (!isNumber || locale.decimalPoint() != ",") {
    return schema.parse(key, utf8(text));
  }
  try {
    return schema.parse(key, utf8(text));
  } catch (const Error& error) {
    const QString pointed = withDecimalPoints(text);
    if (pointed == text) {
      throw;
    }
    try {
      return schema.parse(key, utf8(pointed));
    } catch (const Error&) {
      throw Error(error);  // about what was typed
    }
  }
}

/// The ids of a text like "a, b".
QStringList idsOf(const Value& value) {
  QStringList ids;
  const QString text = value.isString() ? qt(value.asString()) : QString();
  for (const QString& id : text.split(',', Qt::SkipEmptyParts)) {
    ids.append(id.trimmed());
  }
  return ids;
}

QString limitsText(const ParamDef& def) {
  const bool low = std::isfinite(def.info.min);
  const bool high = std::isfinite(def.info.max);
  // An integer's own range says nothing.
  constexpr double kAny = 2e9;
  if (low && high && std::abs(def.info.max) < kAny) {
    return ParamForm::tr("%1 to %2").arg(numberText(def.info.min), numberText(def.info.max));
  }
  if (low && std::abs(def.info.min) < kAny) {
    return ParamForm::tr("at least %1").arg(numberText(def.info.min));
  }
  if (high && std::abs(def.info.max) < kAny) {
    return ParamForm::tr("at most %1").arg(numberText(def.info.max));
  }
  return {};
}

QString tipOf(const ParamDef& def, bool isIndex) {
  QString tip = "<b>" + engineText(def.info.label).toHtmlEscaped() + "</b>";
  if (!def.info.help.empty()) {
    tip += "<br/>" + engineText(def.info.help).toHtmlEscaped();
  }
  const QString unit = qt(fileUnit(def.quantity));
  const QString limits = isIndex ? QString() : limitsText(def);
  if (!limits.isEmpty()) {
    tip += "<br/>" + limits.toHtmlEscaped() + (unit.isEmpty() ? QString() : " " + unit);
  }
  const bool counts = isIndex && def.defaultValue.isInteger() && def.defaultValue.asInteger() >= 0;
  const QString standard =
      counts ? QString::number(def.defaultValue.asInteger() + 1) : valueText(def.defaultValue);
  tip += "<br/>" + ParamForm::tr("Default: %1").arg(standard.toHtmlEscaped()) +
         (unit.isEmpty() ? QString() : " " + unit);
  tip += "<br/><code>" + qt(def.info.key).toHtmlEscaped() + "</code>";
  return tip;
}

}  // namespace

ParamForm::ParamForm(QWidget* parent) : QWidget(parent) {
  setObjectName("paramForm");
  title_ = new QLabel(this);
  title_->setObjectName("formTitle");
  title_->setWordWrap(true);
  search_ = new QLineEdit(this);
  search_->setObjectName("formSearch");
  search_->setPlaceholderText(tr("Search parameters"));
  search_->setClearButtonEnabled(true);
  level_ = new QComboBox(this);
  level_->setObjectName("formLevel");
  level_->setAccessibleName(tr("Level of the parameters shown"));
  level_->setToolTip(level_->accessibleName());
  level_->addItem(tr("Basic"));
  level_->addItem(tr("Advanced"));
  level_->addItem(tr("Expert"));
  level_->setCurrentIndex(QSettings().value("form/level", 0).toInt());
  scroll_ = new QScrollArea(this);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);

  auto* top = new QHBoxLayout;
  top->addWidget(search_, 1);
  top->addWidget(level_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 6, 4, 4);
  layout->addWidget(title_);
  layout->addLayout(top);
  layout->addWidget(scroll_, 1);
  building_.setSingleShot(true);
  connect(&building_, &QTimer::timeout, this, [this] { buildSome(kRowsAtOnce); });
  connect(search_, &QLineEdit::textChanged, this, &ParamForm::filter);
  connect(level_, &QComboBox::currentIndexChanged, this, [this](int index) {
    QSettings().setValue("form/level", index);
    filter();
  });
  clear();
}

void ParamForm::clear() {
  setSections({}, tr("Nothing is selected"), {});
}

void ParamForm::setSections(const std::string& identity,
                            const QString& title,
                            std::vector<FormSection> sections) {
  title_->setText("<b>" + title.toHtmlEscaped() + "</b>");
  const auto sameKeys = [](const FormSection& a, const FormSection& b) {
    const auto& x = a.schema.defs();
    const auto& y = b.schema.defs();
    const auto sameChoices = [](const std::vector<ParamChoice>& c,
                                const std::vector<ParamChoice>& d) {
      return std::equal(c.begin(), c.end(), d.begin(), d.end(),
                        [](const ParamChoice& p, const ParamChoice& q) {
                          return p.key == q.key && p.label == q.label;
                        });
    };
    return a.id == b.id && a.readOnly == b.readOnly && a.indices == b.indices &&
           std::equal(a.lists.begin(), a.lists.end(), b.lists.begin(), b.lists.end(),
                      [&](const auto& p, const auto& q) {
                        return p.first == q.first && sameChoices(p.second, q.second);
                      }) &&
           x.size() == y.size() &&
           std::equal(x.begin(), x.end(), y.begin(), [&](const ParamDef& p, const ParamDef& q) {
             return p.info.key == q.info.key && p.type == q.type && p.info.label == q.info.label &&
                    sameChoices(p.info.choices, q.info.choices);
           });
  };
  const bool same = identity == identity_ && sections.size() == sections_.size() &&
                    std::equal(sections.begin(), sections.end(), sections_.begin(), sameKeys);
  identity_ = identity;
  sections_ = std::move(sections);
  if (!same || body_ == nullptr) {
    rebuild();
  }
  takeValues();
  filter();
  if (!complete_) {
    building_.start(0);
  }
}

void ParamForm::buildSome(std::size_t most) {
  std::size_t made = 0;
  for (Row& row : rows_) {
    if (row.shown && row.field == nullptr) {
      if (made == most) {
        building_.start(0);
        return;
      }
      fill(row);
      ++made;
    }
  }
  if (made > 0 && most < rows_.size()) {
    building_.start(0);  // laying them out takes a turn of its own
    return;
  }
  complete_ = true;
  filter();
  scroll_->setWidget(body_);
}

void ParamForm::buildRest() {
  if (!complete_) {
    building_.stop();
    buildSome(rows_.size());
  }
}

void ParamForm::rebuild() {
  ++builds_;
  complete_ = false;
  rows_.clear();
  groups_.clear();
  // The field that was edited may be one of the old ones, and is still in its signal.
  if (QWidget* old = scroll_->takeWidget()) {
    old->hide();
    old->deleteLater();
  }
  body_ = new QWidget;
  auto* layout = new QVBoxLayout(body_);
  layout->setContentsMargins(0, 2, 6, 8);
  layout->setSpacing(4);
  for (const FormSection& section : sections_) {
    // Groups in the order of their first parameter.
    std::vector<std::string> names;
    for (const ParamDef& def : section.schema.defs()) {
      if (std::find(names.begin(), names.end(), def.info.group) == names.end()) {
        names.push_back(def.info.group);
      }
    }
    for (const std::string& name : names) {
      auto* group = new QWidget(body_);
      auto* inside = new QVBoxLayout(group);
      inside->setContentsMargins(0, 0, 0, 0);
      inside->setSpacing(3);
      auto* head = new QToolButton(group);
      const QString title = name == "General" || engineText(name) == section.title
                                ? section.title
                                : section.title + " · " + engineText(name);
      head->setText(title);
      head->setObjectName("formGroup");
      head->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
      head->setCheckable(true);
      head->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
      const std::string key = section.id + "/" + name;
      head->setChecked(!collapsed_[key]);
      head->setArrowType(head->isChecked() ? Qt::DownArrow : Qt::RightArrow);
      connect(head, &QToolButton::toggled, this, [this, head, key](bool open) {
        head->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
        collapsed_[key] = !open;
        filter();
      });
      inside->addWidget(head);
      layout->addWidget(group);
      groups_.push_back({group, {}});
      for (const ParamDef& def : section.schema.defs()) {
        if (def.info.group == name) {
          groups_.back().second.push_back(rows_.size());
          addRow(section, def, head, inside);
        }
      }
    }
  }
  layout->addStretch(1);
}

void ParamForm::addRow(const FormSection& section,
                       const ParamDef& def,
                       QToolButton* group,
                       QVBoxLayout* layout) {
  Row row;
  row.section = section.id;
  row.def = def;
  row.readOnly = section.readOnly;
  if (const auto list = section.lists.find(def.info.key); list != section.lists.end()) {
    row.isList = true;
    row.items = list->second;
  }
  row.isIndex = section.indices.count(def.info.key) != 0;
  row.group = group;
  row.box = new QWidget(body_);
  row.box->hide();
  layout->addWidget(row.box);
  rows_.push_back(std::move(row));
}

void ParamForm::fill(Row& row) {
  if (row.field != nullptr) {
    return;
  }
  const ParamDef& def = row.def;
  const QString tip = tipOf(def, row.isIndex);
  const QString label = engineText(def.info.label);
  auto* lines = new QVBoxLayout(row.box);
  lines->setContentsMargins(10, 0, 0, 0);
  lines->setSpacing(1);
  auto* line = new QHBoxLayout;
  line->setSpacing(4);
  row.label = new QLabel(label, row.box);
  row.label->setToolTip(tip);
  row.label->setWordWrap(true);
  row.field = makeField(row);
  row.field->setObjectName(QString("%1.%2").arg(qt(row.section), qt(def.info.key)));
  row.field->setToolTip(tip);
  row.field->setAccessibleName(label);
  row.label->setBuddy(row.field);
  line->addWidget(row.label, 4);
  line->addWidget(row.field, 5);
  auto* unit = new QLabel(qt(fileUnit(def.quantity)), row.box);
  unit->setObjectName("formUnit");
  unit->setFixedWidth(unit->fontMetrics().horizontalAdvance("m/min") + 4);
  line->addWidget(unit);
  row.reset = new QToolButton(row.box);
  row.reset->setIcon(icon("reset"));
  row.reset->setAutoRaise(true);
  row.reset->setToolTip(tr("Back to the default"));
  row.reset->setAccessibleName(tr("Reset %1").arg(label));
  row.reset->setFixedSize(22, 22);
  QSizePolicy keep = row.reset->sizePolicy();
  keep.setRetainSizeWhenHidden(true);
  row.reset->setSizePolicy(keep);
  line->addWidget(row.reset);
  lines->addLayout(line);
  row.error = new QLabel(row.box);
  row.error->setObjectName("formError");
  row.error->setWordWrap(true);
  row.error->hide();
  lines->addWidget(row.error);
  connect(row.reset, &QToolButton::clicked, this, [this, id = row.section, key = def.info.key] {
    if (Row* r = find(id, key)) {
      r->error->hide();
    }
    emit edited(id, key, Value());
  });
  showValue(row, true);
}

QString ParamForm::textOf(const Row& row) {
  const bool counts = row.isIndex && row.value.isInteger() && row.value.asInteger() >= 0;
  return counts ? QString::number(row.value.asInteger() + 1) : valueText(row.value);
}

QWidget* ParamForm::makeList(Row& row) {
  auto* list = new QListWidget(row.box);
  list->setSelectionMode(QAbstractItemView::SingleSelection);
  list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list->setTextElideMode(Qt::ElideMiddle);
  list->setWordWrap(false);
  const auto add = [list](const std::string& id, const QString& label) {
    auto* item = new QListWidgetItem(label, list);
    item->setData(Qt::UserRole, qt(id));
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(Qt::Unchecked);
  };
  for (const ParamChoice& choice : row.items) {
    add(choice.key, qt(choice.label.empty() ? choice.key : choice.label));
  }
  // What is listed but not there can be unchecked.
  for (const QString& id : idsOf(row.value)) {
    const bool known = std::any_of(row.items.begin(), row.items.end(),
                                   [&](const ParamChoice& choice) { return qt(choice.key) == id; });
    if (!known) {
      add(utf8(id), tr("%1 (missing)").arg(id));
    }
  }
  const int lines = std::clamp(list->count(), 1, kMostListLines);
  list->setFixedHeight(lines * std::max(list->sizeHintForRow(0), 18) + 2 * list->frameWidth() + 2);
  connect(list, &QListWidget::itemChanged, this,
          [this, section = row.section, key = row.def.info.key, list] {
            const Row* own = find(section, key);
            if (own == nullptr) {
              return;
            }
            // The order of the file stays; what is new comes last.
            QStringList ids = idsOf(own->value);
            for (int i = 0; i < list->count(); ++i) {
              const QString id = list->item(i)->data(Qt::UserRole).toString();
              if (list->item(i)->checkState() != Qt::Checked) {
                ids.removeAll(id);
              } else if (!ids.contains(id)) {
                ids.append(id);
              }
            }
            emit edited(std::string(section), std::string(key), Value(utf8(ids.join(", "))));
          });
  return list;
}

QWidget* ParamForm::makeField(Row& row) {
  const std::string section = row.section;
  const std::string key = row.def.info.key;
  if (row.isList) {
    return makeList(row);
  }
  switch (row.def.type) {
    case ParamType::Bool: {
      auto* box = new QCheckBox(row.box);
      connect(box, &QCheckBox::clicked, this,
              [this, section, key](bool on) { emit edited(section, key, Value(on)); });
      return box;
    }
    case ParamType::Choice: {
      auto* box = new CalmComboBox(row.box);
      box->setMinimumContentsLength(6);
      box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
      for (const ParamChoice& choice : row.def.info.choices) {
        box->addItem(engineText(choice.label.empty() ? choice.key : choice.label), qt(choice.key));
      }
      connect(box, &QComboBox::activated, this, [this, section, key, box] {
        emit edited(section, key, Value(utf8(box->currentData().toString())));
      });
      return box;
    }
    default: {
      auto* line = new QLineEdit(row.box);
      line->setMinimumWidth(50);
      if (row.def.type == ParamType::Real || row.def.type == ParamType::Integer) {
        line->setAlignment(Qt::AlignRight);
      }
      connect(line, &QLineEdit::editingFinished, this,
              [this, section, key, line] { commitText(section, key, line->text()); });
      if (row.def.type == ParamType::File) {
        QAction* browse = line->addAction(icon("open"), QLineEdit::TrailingPosition);
        browse->setToolTip(tr("Choose a file"));
        connect(browse, &QAction::triggered, this, [this, section, key, line] {
          const QString file =
              QFileDialog::getOpenFileName(this, tr("Choose a file"), line->text());
          if (!file.isEmpty()) {
            line->setText(file);
            commitText(section, key, file);
          }
        });
      }
      return line;
    }
  }
}

void ParamForm::commitText(const std::string& section,
                           const std::string& key,
                           const QString& text) {
  Row* row = find(section, key);
  if (row == nullptr || row->readOnly || text == textOf(*row)) {
    if (row != nullptr && text == textOf(*row)) {
      row->error->hide();
    }
    return;
  }
  const auto found = std::find_if(sections_.begin(), sections_.end(),
                                  [&](const FormSection& s) { return s.id == section; });
  try {
    Value value = parsed(found->schema, row->def, text.trimmed(), locale());
    if (row->isIndex && value.isInteger() && value.asInteger() >= 0) {
      if (value.asInteger() == 0) {
        showError(section, key, tr("Counted from 1"));
        return;
      }
      value = Value(value.asInteger() - 1);
    }
    Value object = Value::object();
    object.set(key, value);
    const std::vector<ParamProblem> problems = found->schema.validate(object);
    if (!problems.empty()) {
      showError(section, key, engineText(problems.front().message));
      return;
    }
    row->error->hide();
    // The document may answer at once and rebuild this form.
    emit edited(std::string(section), std::string(key), value);
  } catch (const Error& error) {
    showError(section, key, engineText(error.messageText()));
  }
}

void ParamForm::showError(const std::string& section,
                          const std::string& key,
                          const QString& error) {
  if (Row* row = find(section, key)) {
    row->error->setText(error);
    row->error->setVisible(!error.isEmpty());
  }
}

QString ParamForm::errorAt(const std::string& section, const std::string& key) {
  const Row* row = find(section, key);
  return row != nullptr && !row->error->isHidden() ? row->error->text() : QString();
}

void ParamForm::takeValues() {
  for (const FormSection& section : sections_) {
    Value completed;
    try {
      completed = section.schema.complete(section.values);
    } catch (const Error&) {
      // Wrong values are shown as they stand, each with its own message.
      completed = Value::object();
      for (const ParamDef& def : section.schema.defs()) {
        const Value* own = section.values.find(def.info.key);
        completed.set(def.info.key, own != nullptr ? *own : def.defaultValue);
      }
    }
    const std::vector<ParamProblem> problems = section.schema.validate(section.values);
    for (Row& row : rows_) {
      if (row.section != section.id) {
        continue;
      }
      bool enabled = true;
      try {
        enabled = ParamSchema::enabled(row.def, completed);
      } catch (const Error&) {
        enabled = true;
      }
      const Value* own = section.values.find(row.def.info.key);
      row.isSet = own != nullptr && !own->isNull();
      row.enabled = enabled && !section.readOnly;
      const Value& value = row.isSet ? *own : completed.at(row.def.info.key);
      const bool changed = !(row.value == value);
      row.value = value;
      const auto problem =
          std::find_if(problems.begin(), problems.end(),
                       [&](const ParamProblem& p) { return p.path == row.def.info.key; });
      row.problem = problem != problems.end() ? engineText(problem->message) : QString();
      if (row.field != nullptr) {
        showValue(row, changed);
      }
    }
  }
}

void ParamForm::showValue(Row& row, bool changed) {
  const QSignalBlocker block(row.field);
  if (auto* box = qobject_cast<QCheckBox*>(row.field)) {
    box->setChecked(row.value.isBool() && row.value.asBool());
  } else if (auto* combo = qobject_cast<QComboBox*>(row.field)) {
    const QString key = row.value.isString() ? qt(row.value.asString()) : QString();
    int index = combo->findData(key);
    if (index < 0 && !key.isEmpty()) {
      combo->addItem(key, key);
      index = combo->count() - 1;
    }
    combo->setCurrentIndex(index);
  } else if (auto* list = qobject_cast<QListWidget*>(row.field)) {
    const QStringList ids = idsOf(row.value);
    for (int i = 0; i < list->count(); ++i) {
      const bool on = ids.contains(list->item(i)->data(Qt::UserRole).toString());
      list->item(i)->setCheckState(on ? Qt::Checked : Qt::Unchecked);
    }
  } else if (auto* line = qobject_cast<QLineEdit*>(row.field)) {
    if (changed || !line->hasFocus()) {
      line->setText(textOf(row));
      line->setCursorPosition(0);
    }
  }
  QFont font = row.label->font();
  font.setBold(row.isSet);
  row.label->setFont(font);
  row.reset->setVisible(row.isSet && row.enabled);
  row.field->setEnabled(row.enabled);
  row.label->setEnabled(row.enabled);
  if (!row.problem.isEmpty()) {
    row.error->setText(row.problem);
    row.error->show();
  } else if (!row.field->hasFocus()) {
    row.error->hide();
  }
}

void ParamForm::filter() {
  const QString wanted = search_->text().trimmed();
  for (const auto& [group, indices] : groups_) {
    bool any = false;
    for (const std::size_t i : indices) {
      Row& row = rows_[i];
      // A search looks into all levels; what is set is always shown.
      const bool fits =
          wanted.isEmpty()
              ? static_cast<int>(row.def.info.level) <= level_->currentIndex() ||
                    (row.isSet && row.enabled)
              : QString(engineText(row.def.info.label) + " " + engineText(row.def.info.help) + " " +
                        qt(row.def.info.key) + " " + engineText(row.def.info.group))
                    .contains(wanted, Qt::CaseInsensitive);
      row.shown = fits && (row.group->isChecked() || !wanted.isEmpty());
      if (complete_) {
        if (row.shown) {
          fill(row);
        }
        row.box->setVisible(row.shown);
      }
      any = any || fits;
    }
    group->setVisible(any);
  }
}

std::size_t ParamForm::filledRows() const {
  return static_cast<std::size_t>(std::count_if(
      rows_.begin(), rows_.end(), [](const Row& row) { return row.field != nullptr; }));
}

ParamForm::Row* ParamForm::find(const std::string& section, const std::string& key) {
  buildRest();
  for (Row& row : rows_) {
    if (row.section == section && row.def.info.key == key) {
      fill(row);
      return &row;
    }
  }
  return nullptr;
}

QWidget* ParamForm::field(const std::string& section, const std::string& key) {
  const Row* row = find(section, key);
  return row != nullptr ? row->field : nullptr;
}

void ParamForm::commit() {
  for (const Row& row : rows_) {
    const auto* line = qobject_cast<QLineEdit*>(row.field);
    if (line != nullptr && line->hasFocus()) {
      // The document may answer at once and rebuild the rows.
      commitText(std::string(row.section), std::string(row.def.info.key), line->text());
      return;
    }
  }
}

void ParamForm::focusSearch() {
  search_->setFocus();
  search_->selectAll();
}

void ParamForm::focusField(const std::string& section, const std::string& key) {
  if (const Row* row = find(section, key)) {
    if (row->box->isHidden()) {
      search_->setText(qt(key));
    }
    scroll_->ensureWidgetVisible(row->box);
    row->field->setFocus();
  }
}

}  // namespace wcam::gui
