// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QSocketNotifier;

namespace wcam::gui {

class Session;

/// SIGTERM, SIGINT and SIGHUP end the program without a question. What is not saved is written to
/// the autosave first, so that the next start offers it. One at a time.
class EndSignals : public QObject {
  Q_OBJECT

public:
  explicit EndSignals(Session& session);
  ~EndSignals() override;

private:
  void end();

  Session& session_;
  QSocketNotifier* notifier_ = nullptr;
};

}  // namespace wcam::gui
