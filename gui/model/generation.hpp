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

/// An operation as it is shown: a path, or why there is none.
struct GeneratedOperation {
  std::string id;
  std::shared_ptr<const PathModel> path;
  std::shared_ptr<const viewport::PreparedMesh> substrate;
  std::vector<Diagnostic> outputFindings;  ///< of the post-processors that would print it
  std::optional<Error> error;
};

/// What a document gives.
struct Generated {
  std::uint64_t state = 0;  ///< History::stateId of the document
  std::vector<GeneratedPart> parts;
  std::vector<GeneratedOperation> operations;
  std::shared_ptr<const cell::Cell> cell;
  std::vector<Diagnostic> findings;  ///< of the project
  std::optional<Error> error;        ///< of the project

  [[nodiscard]] const GeneratedPart* part(const std::string& id) const;
  [[nodiscard]] const GeneratedOperation* operation(const std::string& id) const;
};

/// Imports the parts and computes the enabled operations, `first` before the others. Every failure
/// is kept with its part or operation; the others go on. For the background.
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
