// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QApplication;
class QString;

namespace wcam::gui {

/// What must be set before a QApplication exists: graphics format, platform, name of the program.
void prepareApplication();
/// Loads the translations of a language ("fr"); an empty name takes that of the desktop. @return
/// whether there are any
bool loadTranslations(QApplication& application, const QString& language);
/// The program `wcam`.
int runApplication(int argc, char** argv);

}  // namespace wcam::gui
