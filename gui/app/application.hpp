// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

class QApplication;
class QString;

namespace wcam::gui {

class MainWindow;

/// What must be set before a QApplication exists: graphics format, platform, name of the program.
void prepareApplication();
/// Loads the translations of a language ("fr"); an empty name takes that of the desktop. @return
/// whether there are any
bool loadTranslations(QApplication& application, const QString& language);
/// The program `wcam`.
/// @param started called with the window before its event loop runs
int runApplication(int argc, char** argv, const std::function<void(MainWindow&)>& started = {});

}  // namespace wcam::gui
