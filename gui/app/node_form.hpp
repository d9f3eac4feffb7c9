// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/plugin/host.hpp"
#include "wcam/project/commands.hpp"

#include "widgets/param_form.hpp"
#include "widgets/project_tree.hpp"

namespace wcam::gui {

/// The form of a node of the project.
struct NodeForm {
  QString title;
  std::vector<FormSection> sections;
};

/// Plain fields of the node (section "node"), then the sections with a schema. Empty for a node
/// that does not exist.
NodeForm formOf(const project::Document& document,
                const NodeRef& node,
                const plugin::PluginHost& plugins);

/// The command that an edit of the form stands for. A null value removes the key.
project::Command commandOf(const project::Document& document,
                           const NodeRef& node,
                           const std::string& section,
                           const std::string& key,
                           const Value& value);

/// "part" for "parts", ...
std::string nounOf(const std::string& list);

/// A cell that comes with the program.
struct ShippedCell {
  std::string path;  ///< for a project: "wcam:cells/..."
  std::string name;
  std::string description;
};

/// All of them, by name. One whose file cannot be read has the name of its file.
std::vector<ShippedCell> shippedCells();

}  // namespace wcam::gui
