// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "log_view.hpp"

#include "wcam/base/log.hpp"

#include "icons.hpp"
#include "text.hpp"

#include <QMetaObject>
#include <QPointer>
#include <QTime>

namespace wcam::gui {

namespace {

constexpr int kMaxLines = 5000;

}  // namespace

LogView::LogView(QWidget* parent) : QPlainTextEdit(parent) {
  setObjectName("log");
  setAccessibleName(tr("Log"));
  setReadOnly(true);
  setMaximumBlockCount(kMaxLines);
  setFrameShape(QFrame::NoFrame);
  setTabChangesFocus(true);
  // The engine writes from every thread.
  log::setSink([this](const log::Record& record) {
    if (record.level == log::Level::Debug) {
      return;
    }
    const Kind kind = record.level == log::Level::Error     ? Kind::Error
                      : record.level == log::Level::Warning ? Kind::Warning
                                                            : Kind::Note;
    QMetaObject::invokeMethod(
        this, [this, kind, text = qt(record.domain + ": " + record.message)] { say(kind, text); },
        Qt::QueuedConnection);
  });
}

LogView::~LogView() {
  log::setSink({});
}

void LogView::say(Kind kind, const QString& text) {
  QString line = QTime::currentTime().toString("HH:mm:ss ") + text.toHtmlEscaped();
  line.replace("\n", "<br/>&nbsp;&nbsp;&nbsp;&nbsp;");
  if (kind != Kind::Note) {
    line =
        QString("<span style='color:%1'>%2</span>")
            .arg(statusColour(kind == Kind::Error ? Status::Error : Status::Warning).name(), line);
  }
  appendHtml(line);
}

}  // namespace wcam::gui
