// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/cell/cell.hpp"
#include "wcam/io/import.hpp"
#include "wcam/motion/collisions.hpp"
#include "wcam/motion/placement.hpp"
#include "wcam/motion/plan.hpp"
#include "wcam/plugin/host.hpp"
#include "wcam/process/process.hpp"
#include "wcam/program/program.hpp"
#include "wcam/project/commands.hpp"
#include "wcam/project/document.hpp"
#include "wcam/project/stage_cache.hpp"
#include "wcam/toolpath/build.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace wcam::project {

/// Everything that an operation gives, with the findings of all its stages (their place names the
/// operation).
struct OperationResult {
  std::string id;
  std::string strategy;
  std::vector<std::shared_ptr<const io::ImportedPart>> parts;
  std::shared_ptr<const toolpath::Substrate> substrate;
  std::shared_ptr<const toolpath::Toolpath> path;  ///< with process and exit rotations
  std::shared_ptr<const cell::Cell> cell;
  std::shared_ptr<const motion::PlannedMotion> motion;
  motion::CollisionStatistics collisions;
  std::shared_ptr<const program::Program> program;
  process::ProcessParams process;
  std::vector<Diagnostic> findings;
  /// Of every finding the commands that put it right, tried on the whole operation with the figures
  /// that it tells. None: its remedy is a hint.
  std::vector<std::vector<Command>> remedies;
};

/// An error of an operation with commands that put it right, which were tried.
class OperationError : public Error {
public:
  OperationError(const Error& error, std::vector<Command> remedy);
  ~OperationError() override;

  [[nodiscard]] const std::vector<Command>& remedy() const noexcept { return remedy_; }

private:
  std::vector<Command> remedy_;
};

/// part → layers → beads → process → motion → program → files, each stage a cached pure function
/// (DESIGN 4).
class Pipeline {
public:
  /// @param project path of the .wcam file, against which the document's files are resolved
  Pipeline(Document document,
           std::filesystem::path project,
           std::shared_ptr<const plugin::PluginHost> plugins,
           std::shared_ptr<StageCache> cache = std::make_shared<StageCache>());

  /// All problems of parameters, components and file references, without computing anything. A
  /// component that no plugin provides is none while others are left: its operation or output fails
  /// alone.
  /// @return warnings: unknown parameters, changed files
  /// @throws Error(ProjectInvalid / PluginMissing / InputNotFound) listing them
  [[nodiscard]] std::vector<Diagnostic> validate() const;

  /// Everything that validate() finds wrong with parameters and components, one by one.
  [[nodiscard]] std::vector<ParamProblem> problems() const;

  /// @throws Error of the stage that fails, with the operation in its context
  [[nodiscard]] OperationResult compute(const std::string& operation,
                                        const JobContext& context) const;

  /// The beads alone, without cell, motion and program: what a view shows first, and all that there
  /// is while no cell is chosen.
  /// @throws Error as compute
  [[nodiscard]] OperationResult computePath(const std::string& operation,
                                            const JobContext& context) const;

  /// Searches a place of an operation's part on its table, see motion::searchPlacement. Computes
  /// everything up to the beads, and the cell.
  /// @throws Error as compute
  [[nodiscard]] motion::PlacementMap searchPlacement(const std::string& operation,
                                                     const motion::PlacementSearch& search,
                                                     const JobContext& context) const;

  /// Prints an operation's program with an output's post-processor.
  [[nodiscard]] std::vector<plugin::OutputFile> post(const Output& output,
                                                     const OperationResult& result,
                                                     const JobContext& context) const;

  /// The part alone, as `info` and previews want it.
  [[nodiscard]] std::shared_ptr<const io::ImportedPart> importPart(const std::string& part,
                                                                   const JobContext& context) const;

  /// The plate or body that is built on, which needs no operation. @param substrate its id
  [[nodiscard]] std::shared_ptr<const toolpath::Substrate> loadSubstrate(
      const std::string& substrate, const JobContext& context) const;

  /// The cell. @throws Error(ProjectInvalid) when the project names none
  [[nodiscard]] std::shared_ptr<const cell::Cell> loadCell(const JobContext& context) const;

  [[nodiscard]] const Document& document() const noexcept { return document_; }

  /// The project file.
  [[nodiscard]] const std::filesystem::path& file() const noexcept { return project_; }

  [[nodiscard]] const plugin::PluginHost& plugins() const noexcept { return *plugins_; }

private:
  class MissingComponents;
  /// @throws Error(PluginMissing / PluginRefused), also where the project asks for a later version
  [[nodiscard]] std::shared_ptr<const plugin::SlicingComponent> findStrategy(
      const std::string& id) const;
  [[nodiscard]] std::shared_ptr<const plugin::PostComponent> findPost(const std::string& id) const;
  [[nodiscard]] std::vector<ParamProblem> problems(MissingComponents& strategies,
                                                   MissingComponents& posts) const;
  template <class T>
  Staged<T> stage(const std::string& name,
                  StageKey key,
                  const JobContext& context,
                  const std::function<T(const JobContext&)>& make) const;
  [[nodiscard]] Staged<io::ImportedPart> stagePart(const std::string& id,
                                                   const JobContext& context) const;
  [[nodiscard]] Staged<toolpath::Substrate> stageSubstrate(const std::string& id,
                                                           const JobContext& context) const;
  [[nodiscard]] std::shared_ptr<const geometry::GuideCurve> makeGuide(
      const Guide& guide, std::string& key, const JobContext& context) const;
  /// The path itself where no edit is enabled.
  [[nodiscard]] Staged<toolpath::Toolpath> stageEdits(const Operation& operation,
                                                      const Staged<toolpath::Toolpath>& path,
                                                      const toolpath::PathParams& params,
                                                      const JobContext& context) const;
  [[nodiscard]] process::ProcessParams processOf(const Operation& operation,
                                                 Value& completed) const;
  /// The last stage that is wanted.
  enum class Until { Path, Cell, Program };
  /// @throws Error(InvalidArgument) with a near name
  [[nodiscard]] const Operation& operationOf(const std::string& id) const;
  [[nodiscard]] OperationResult computeUntil(const std::string& id,
                                             Until until,
                                             const JobContext& context) const;
  [[nodiscard]] OperationResult computeStages(const Operation& operation,
                                              Until until,
                                              const JobContext& context) const;
  [[nodiscard]] Staged<cell::Cell> stageCell(const JobContext& context) const;
  /// Tries the remedies of an operation's findings on the whole of it.
  void addRemedies(const Operation& operation,
                   OperationResult& result,
                   const std::string& key,
                   const JobContext& context) const;

  Document document_;
  std::filesystem::path project_;
  std::shared_ptr<const plugin::PluginHost> plugins_;
  std::shared_ptr<StageCache> cache_;
  bool isTrial_ = false;  ///< of a remedy: its own remedies are not tried
};

}  // namespace wcam::project
