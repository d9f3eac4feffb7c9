// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
// wcam-cad-worker REQUEST: reads a CAD part for the engine (cad_process.hpp); not for users.
#include "cad_process.hpp"

int main(int argc, char** argv) {
  return argc == 2 ? wcam::io::runCadWorker(argv[1]) : 2;
}
