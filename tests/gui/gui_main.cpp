// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/application.hpp"
#include "program_role.hpp"
#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>

#include <clocale>

int main(int argc, char** argv) {
  int code = 0;
  if (wcam::gui::test::playRole(argc, argv, code)) {
    return code;
  }
  ::testing::InitGoogleTest(&argc, argv);
  wcam::gui::prepareApplication();
  QCoreApplication::setApplicationName("wcam-test");
  QApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  wcam::gui::loadTranslations(application, "en");
  // Tests begin with the settings of a new user.
  QSettings().clear();
  return RUN_ALL_TESTS();
}
