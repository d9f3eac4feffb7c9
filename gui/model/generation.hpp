// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/project/commands.hpp"

#include "path_model.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace wcam::gui {

/// A part as it is shown.
struct GeneratedPart {
  std::string id;
  std::shared_ptr<const io::ImportedPart> part;
  std::shared_ptr<const viewport::PreparedMesh> mesh;
  std::optional<Error> error;
};

/// A plate or body that is built on.
struct GeneratedPlate {
  std::string id;
  std::shared_ptr<const toolpath::Substrate> substrate;
  std::shared_ptr<const viewport::PreparedMesh> mesh;
};

/// An operation as it is shown: a path, and why there is none.
struct GeneratedOperation {
  std::string id;
  std::shared_ptr<const PathModel> path;
  std::shared_ptr<const viewport::PreparedMesh> substrate;
  std::vector<Diagnostic> outputFindings;  ///< of the post-processors that would print it
  std::optional<Error> error;
  std::vector<project::Command> remedy;  ///< of the error; none: its hint is only one
  bool outdated = false;  ///< the path is the last one that there was: the present one fails
};

/// What a document gives.
struct Generated {
  std::uint64_t state = 0;  ///< History::stateId of the document
  std::vector<GeneratedPart> parts;
  std::vector<GeneratedPlate> plates;
  std::vector<GeneratedOperation> operations;
  std::shared_ptr<const cell::Cell> cell;
  std::optional<Error> cellError;
  std::vector<Diagnostic> findings;  ///< of the project
  std::optional<Error> error;        ///< of the project

  [[nodiscard]] const GeneratedPart* part(const std::string& id) const;
  [[nodiscard]] const GeneratedPlate* plate(const std::string& id) const;
  [[nodiscard]] const GeneratedOperation* operation(const std::string& id) const;
};

/// Reads cell, plates and parts and computes the enabled operations, `first` before the others.
/// Every failure is kept with its part or operation, which keeps what it showed before; the others
/// go on. For the background.
/// @param before what was shown until now: what is the same is taken from it, so that views keep it
/// @param step called with what there is so far after every part and operation
/// @throws CancelledError
Generated generate(const project::Pipeline& pipeline,
                   const std::string& first,
                   const Generated& before,
                   const JobContext& context,
                   const std::function<void(const Generated&)>& step);

/// The schema of a section of a node, or nothing when its plugin is missing.
std::optional<ParamSchema> schemaOf(const plugin::PluginHost& plugins,
                                    const project::ParamSection& section);

}  // namespace wcam::gui
