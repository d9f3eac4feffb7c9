// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program_view.hpp"

#include "text.hpp"

#include <QComboBox>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QSignalBlocker>
#include <QTextBlock>
#include <QVBoxLayout>

#include <algorithm>

namespace wcam::gui {

namespace {

// More text than this makes the editor slow to open; the rest is in the exported file.
constexpr std::size_t kMaxText = std::size_t{8} << 20;

}  // namespace

ProgramView::ProgramView(ViewState& state, QWidget* parent) : QWidget(parent), state_(state) {
  setObjectName("programView");
  output_ = new QComboBox(this);
  output_->setObjectName("programOutput");
  output_->setAccessibleName(tr("Output"));
  file_ = new QComboBox(this);
  file_->setAccessibleName(tr("File of the program"));
  note_ = new QLabel(this);
  text_ = new QPlainTextEdit(this);
  text_->setObjectName("programText");
  text_->setReadOnly(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  text_->setLineWrapMode(QPlainTextEdit::NoWrap);
  text_->setFrameShape(QFrame::NoFrame);
  text_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  text_->setTabChangesFocus(true);
  text_->setAccessibleName(tr("Program text"));
  auto* top = new QHBoxLayout;
  top->setContentsMargins(6, 4, 6, 0);
  top->addWidget(output_);
  top->addWidget(file_);
  top->addWidget(note_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(3);
  layout->addLayout(top);
  layout->addWidget(text_, 1);
  connect(output_, &QComboBox::activated, this, &ProgramView::wanted);
  connect(file_, &QComboBox::activated, this, [this](int index) {
    // The chosen file stays until the move changes.
    browsing_ = true;
    showFile(index);
    browsing_ = false;
  });
  connect(text_, &QPlainTextEdit::cursorPositionChanged, this, &ProgramView::jump);
  listener_ = state_.listen([this](unsigned changes) {
    if ((changes & (ViewState::MoveChanged | ViewState::PathChanged)) != 0 && isVisible()) {
      showMove();
    }
  });
}

ProgramView::~ProgramView() {
  state_.forget(listener_);
}

void ProgramView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  emit wanted();
  showMove();
}

void ProgramView::setOutputs(const QStringList& ids) {
  const QString before = output_->currentText();
  const QSignalBlocker block(output_);
  output_->clear();
  output_->addItems(ids);
  output_->setCurrentIndex(std::max(static_cast<int>(ids.indexOf(before)), ids.isEmpty() ? -1 : 0));
}

QString ProgramView::output() const {
  return output_->currentText();
}

void ProgramView::setMessage(const QString& message) {
  program_.reset();
  file_->clear();
  note_->clear();
  const QSignalBlocker block(text_);
  text_->setPlainText(message);
  marked_ = -1;
  text_->setExtraSelections({});
}

void ProgramView::setProgram(std::shared_ptr<const ProgramText> program) {
  program_ = std::move(program);
  const QString before = file_->currentText();
  file_->clear();
  for (const ProgramText::File& file : program_->files) {
    file_->addItem(qt(file.name));
  }
  file_->setCurrentIndex(std::max(file_->findText(before), 0));
  note_->setText(program_->linked ? QString()
                                  : tr("The lines of this language are not tied to the path."));
  showFile(file_->currentIndex());
}

void ProgramView::showFile(int index) {
  if (!program_ || index < 0 || index >= static_cast<int>(program_->files.size())) {
    return;
  }
  const ProgramText::File& file = program_->files[static_cast<std::size_t>(index)];
  const QSignalBlocker block(text_);
  const bool cut = file.text.size() > kMaxText;
  text_->setPlainText(qt(cut ? file.text.substr(0, kMaxText) : file.text));
  if (cut) {
    text_->appendPlainText(tr("… the rest is in the exported file"));
  }
  marked_ = -1;
  showMove();
}

void ProgramView::showMove() {
  if (!program_ || !program_->linked || !state_.path()) {
    return;
  }
  // The last line before or at the move, in whichever file it stands.
  const auto move = static_cast<std::int32_t>(state_.move());
  int file = -1;
  int line = -1;
  std::int32_t best = -1;
  for (std::size_t f = 0; f < program_->files.size(); ++f) {
    const auto& moves = program_->files[f].moveOfLine;
    for (std::size_t i = 0; i < moves.size() && moves[i] <= move; ++i) {
      if (moves[i] > best) {
        best = moves[i];
        file = static_cast<int>(f);
        line = static_cast<int>(i);
      }
    }
  }
  if (file >= 0 && file != file_->currentIndex()) {
    if (browsing_) {
      return;
    }
    file_->setCurrentIndex(file);
    showFile(file);
    return;
  }
  if (line < 0 || line == marked_) {
    return;
  }
  marked_ = line;
  const QTextBlock block = text_->document()->findBlockByNumber(line);
  if (!block.isValid()) {
    return;
  }
  QTextEdit::ExtraSelection mark;
  QColor colour = palette().color(QPalette::Highlight);
  colour.setAlpha(70);
  mark.format.setBackground(colour);
  mark.format.setProperty(QTextFormat::FullWidthSelection, true);
  mark.cursor = QTextCursor(block);
  text_->setExtraSelections({mark});
  if (!following_) {
    const QSignalBlocker blocker(text_);
    text_->setTextCursor(QTextCursor(block));
    text_->centerCursor();
  }
}

void ProgramView::jump() {
  if (!program_ || !program_->linked || file_->currentIndex() < 0) {
    return;
  }
  const auto& moves = program_->files[static_cast<std::size_t>(file_->currentIndex())].moveOfLine;
  const auto line = static_cast<std::size_t>(text_->textCursor().blockNumber());
  if (line < moves.size() && moves[line] >= 0) {
    following_ = true;
    state_.jumpTo(static_cast<std::size_t>(moves[line]));
    following_ = false;
  }
}

}  // namespace wcam::gui
