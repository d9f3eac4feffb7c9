// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
// wcam-plugin-trial MANIFEST: loads a plugin to see whether it comes back (trial.hpp); not for
// users.
#include "library.hpp"
#include "trial.hpp"
#include <unistd.h>

#include <exception>

int main(int argc, char** argv) {
  if (argc != 2) {
    return 2;
  }
  int code = wcam::plugin::kTrialRefused;
  try {
    const std::filesystem::path file = argv[1];
    const wcam::plugin::Manifest manifest =
        wcam::plugin::readManifest(std::filesystem::path(file).replace_extension(".json"));
    (void)wcam::plugin::loadLibrary(manifest, file.parent_path() / manifest.library);
    code = wcam::plugin::kTrialLoaded;
  } catch (const std::exception&) {
    // The host finds the reason for itself.
  }
  // Destructors of the library are not part of the trial: libraries are never unloaded.
  ::_exit(code);
}
