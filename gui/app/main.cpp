// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "application.hpp"

int main(int argc, char** argv) {
  return wcam::gui::runApplication(argc, argv);
}
