// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "wcam/project/commands.hpp"
#include "wcam/project/pipeline.hpp"
#include "wcam/project/project_file.hpp"

#include "quick_motion.hpp"

#include <memory>
#include <string>

namespace wcam::test {

inline std::filesystem::path exampleFile(const std::string& name) {
  return std::filesystem::path(WCAM_RESOURCES) / "projects" / name / (name + ".wcam");
}

inline std::shared_ptr<const plugin::PluginHost> hostOfPlugins() {
  static const auto host =
      std::make_shared<const plugin::PluginHost>(plugin::defaultPluginSearch({}, false));
  return host;
}

/// With a constant rotation about the torch.
inline project::Document exampleDocument(const std::string& name) {
  return withQuickMotion(project::loadProject(exampleFile(name)).document);
}

}  // namespace wcam::test
