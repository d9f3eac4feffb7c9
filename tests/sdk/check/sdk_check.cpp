// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Uses only what is installed: loads a plugin that was built out of tree and runs the conformance
// kit. Usage: sdk_check PLUGIN LIBRARY_FOLDER DATA_FOLDER
#include "wcam/plugin/host.hpp"
#include "wcam/plugin/locations.hpp"
#include "wcam/testing/plugin_conformance.hpp"

#include <filesystem>
#include <iostream>

namespace {

namespace fs = std::filesystem;

void require(bool condition, const std::string& what) {
  if (!condition) {
    throw wcam::Error(wcam::ErrorCode::CheckFailed, what);
  }
}

void check(const fs::path& plugin, const fs::path& libraryFolder, const fs::path& dataFolder) {
  require(fs::equivalent(wcam::plugin::engineFolder(), libraryFolder),
          "the engine was loaded from " + wcam::plugin::engineFolder().string());
  require(fs::equivalent(wcam::plugin::dataFolder(), dataFolder),
          "the data folder is " + wcam::plugin::dataFolder().string());
  require(fs::exists(dataFolder / "cells"), "there are no cells");

  const wcam::plugin::PluginHost host(wcam::plugin::defaultPluginSearch({plugin}, false));
  for (const char* id : {"example.post.csv", "wcam.post.fanuc", "wcam.post.kuka"}) {
    wcam::testing::checkPost(*host.findPost(id));
  }
  host.loadAll();
  for (const wcam::plugin::PluginReport& report : host.reports()) {
    std::cout << toString(report.verdict) << ' ' << report.id << ' ' << report.path << ' '
              << report.reason << '\n';
    require(report.verdict == wcam::plugin::PluginVerdict::Loaded,
            report.id + ": " + report.reason.str());
    const bool installed = report.origin == wcam::plugin::PluginOrigin::Installed;
    require(installed != (report.id == "org.example.post.csv"),
            report.id + " comes from an unexpected place");
  }
  require(host.reports().front().id == "org.example.post.csv",
          "the requested plugin is not the first");
}

}  // namespace

int main(int argc, char** argv) {
  try {
    require(argc == 4, "three arguments are needed");
    check(argv[1], argv[2], argv[3]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
