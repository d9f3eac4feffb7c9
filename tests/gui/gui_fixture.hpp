// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/main_window.hpp"
#include "quick_motion.hpp"
#include "test_folder.hpp"
#include <gtest/gtest.h>

#include <QApplication>
#include <QDialog>
#include <QElapsedTimer>
#include <QTest>
#include <QTimer>

#include <filesystem>
#include <functional>
#include <memory>

namespace wcam::gui::test {

inline constexpr int kPatienceMs = 60000;

/// Plugins are looked for once per process.
inline std::shared_ptr<const plugin::PluginHost> plugins() {
  static const auto host =
      std::make_shared<const plugin::PluginHost>(plugin::defaultPluginSearch({}, false));
  return host;
}

/// Runs the event loop until something holds.
inline bool waitFor(const std::function<bool()>& holds, int patience = kPatienceMs) {
  return QTest::qWaitFor(holds, patience);
}

inline std::filesystem::path example(const std::string& name) {
  return std::filesystem::path(WCAM_RESOURCES) / "projects" / name / (name + ".wcam");
}

/// A copy of an example that may be written to, with a motion that takes no time to plan.
inline std::filesystem::path copyOf(const std::string& name, const std::filesystem::path& folder) {
  std::filesystem::copy(
      example(name).parent_path(), folder,
      std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing);
  const std::filesystem::path file = folder / (name + ".wcam");
  project::saveProject(wcam::test::withQuickMotion(project::loadProject(file).document), file);
  return file;
}

/// True when everything that the document asks for is computed and shown.
inline bool settled(MainWindow& window) {
  return !window.session().stale() && !window.session().generation().busy();
}

inline bool waitSettled(MainWindow& window) {
  return waitFor([&] { return settled(window); });
}

/// Dialogs that are waited for; one that never came must not be met by a later test.
inline int& dialogsAwaited() {
  static int count = 0;
  return count;
}

inline bool dialogsDone() {
  return dialogsAwaited() == 0;
}

/// When the next modal dialog is open, calls a function with it.
inline void whenDialog(const std::function<void(QDialog&)>& then) {
  auto* timer = new QTimer(qApp);
  ++dialogsAwaited();
  timer->setInterval(20);
  QObject::connect(timer, &QTimer::timeout, qApp, [timer, then] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (dialog != nullptr && dialog->isVisible()) {
      timer->stop();
      --dialogsAwaited();
      timer->deleteLater();
      then(*dialog);
    }
  });
  timer->start();
}

}  // namespace wcam::gui::test
