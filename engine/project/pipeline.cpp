// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/pipeline.hpp"

#include "wcam/base/budget.hpp"
#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/remedy.hpp"
#include "wcam/base/text.hpp"
#include "wcam/geometry/mesh_deviation.hpp"
#include "wcam/motion/pauses.hpp"
#include "wcam/program/from_motion.hpp"
#include "wcam/project/project_file.hpp"
#include "wcam/toolpath/edit_findings.hpp"
#include "wcam/toolpath/part_coverage.hpp"

#include "part_names.hpp"
#include "part_wall.hpp"
#include "remedies.hpp"
#include "stage_size.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace wcam::project {

namespace {

// Raise the version of a stage when the same input gives another result.
constexpr int kPartVersion = 3;
constexpr int kSubstrateVersion = 1;
constexpr int kSliceVersion = 6;
constexpr int kPathVersion = 4;
constexpr int kEditsVersion = 3;
constexpr int kProcessVersion = 4;
constexpr int kCellVersion = 3;
constexpr int kMotionVersion = 7;
constexpr int kProgramVersion = 3;
constexpr int kRemediesVersion = 2;

std::string placementText(const Placement& placement) {
  std::string text;
  for (const double number : placement.positionMm) {
    text += formatFixed(number, 9) + ",";
  }
  for (const double number : placement.rotationDeg) {
    text += formatFixed(number, 9) + ",";
  }
  return text;
}

/// Rethrows with the operation in front of the context.
[[noreturn]] void rethrowIn(const Error& error, const Text& place) {
  if (error.code() == ErrorCode::Cancelled) {
    throw CancelledError();
  }
  throw Error(error.code(), error.messageText(),
              error.context().empty() ? place : text("%1: %2", {place, error.contextText()}),
              error.hintText());
}

int edgeByName(const geometry::Brep& brep, const std::string& name) {
  std::vector<std::string> names;
  for (int i = 0; i < brep.edgeCount(); ++i) {
    if (brep.edge(i).name == name) {
      return i;
    }
    if (!brep.edge(i).name.empty()) {
      names.push_back(brep.edge(i).name);
    }
  }
  const auto near = nearestName(name, names);
  throw Error(ErrorCode::ProjectInvalid, text("the part has no edge named '%1'", {name}), {},
              near ? text("did you mean '%1'?", {*near})
                   : text("name the edge by its index; `camcli info` lists them"));
}

/// The diagnostics of a stage belong to the operation.
void collect(std::vector<Diagnostic>& findings,
             const std::vector<Diagnostic>& stage,
             const std::string& operation) {
  for (Diagnostic diagnostic : stage) {
    diagnostic.place.operation = operation;
    findings.push_back(std::move(diagnostic));
  }
}

std::vector<toolpath::Edit> enabledEdits(const Operation& operation) {
  std::vector<toolpath::Edit> edits;
  for (const OperationEdit& edit : operation.edits) {
    if (edit.enabled) {
      edits.push_back(toolpath::readEdit(edit.id, edit.type, edit.params));
    }
  }
  return edits;
}

}  // namespace

OperationError::OperationError(const Error& error, std::vector<Command> remedy)
    : Error(error), remedy_(std::move(remedy)) {}

OperationError::~OperationError() = default;

namespace {

/// Ids of the post-processors that write for a controller.
std::vector<std::string> postsFor(const plugin::PluginHost& plugins,
                                  const std::string& controller) {
  std::vector<std::string> ids;
  for (const plugin::ComponentEntry& component : plugins.components()) {
    if (component.kind != plugin::ComponentKind::Post) {
      continue;
    }
    try {
      const std::vector<std::string>& own = plugins.findPost(component.id)->info.controllers;
      if (std::find(own.begin(), own.end(), controller) != own.end()) {
        ids.push_back(component.id);
      }
    } catch (const Error&) {
      continue;  // refused: no advice
    }
  }
  return ids;
}

/// Joint values, frames and configurations of one make mean something else on another.
void checkController(const plugin::ComponentInfo& post,
                     const program::Program& program,
                     const plugin::PluginHost& plugins,
                     const JobContext& context) {
  const std::string& controller = program.cell.controller;
  if (post.controllers.empty() || std::find(post.controllers.begin(), post.controllers.end(),
                                            controller) != post.controllers.end()) {
    return;
  }
  const std::string makes = joinText(post.controllers, ", ");
  if (controller.empty()) {
    context.add(
        {Severity::Information,
         "post.controller_unknown",
         text("the cell does not name its controller; the program is written for %1", {makes}),
         "name it in the cell file (robot.controller)",
         {program.name},
         {}});
    return;
  }
  const std::vector<std::string> fitting = postsFor(plugins, controller);
  context.add(
      {Severity::Warning,
       "post.other_controller",
       text("the controller of the cell is %1, the program is written for %2", {controller, makes}),
       fitting.empty()
           ? text("no post-processor that is installed writes for %1: check every joint value and "
                  "frame before the program runs",
                  {controller})
           : text("use %1, which writes for %2", {joinText(fitting, ", "), controller}),
       {program.name},
       {}});
}

}  // namespace

Pipeline::Pipeline(Document document,
                   std::filesystem::path project,
                   std::shared_ptr<const plugin::PluginHost> plugins,
                   std::shared_ptr<StageCache> cache)
    : document_(std::move(document)),
      project_(std::move(project)),
      plugins_(std::move(plugins)),
      cache_(std::move(cache)) {}

template <class T>
Staged<T> Pipeline::stage(const std::string& name,
                          StageKey key,
                          const JobContext& context,
                          const std::function<T(const JobContext&)>& make) const {
  context.check();
  return cache_->get<T>(name, key.hex(), context, make,
                        [](const T& value) { return bytesOf(value); });
}

Staged<io::ImportedPart> Pipeline::stagePart(const std::string& id,
                                             const JobContext& context) const {
  const Part& part = *document_.project().part(id);
  const std::filesystem::path file = resolvePath(project_, part.file);
  const Value options =
      io::importOptionsSchema().params().complete(part.import, "part '" + id + "'");
  StageKey key("part", kPartVersion);
  key.text(sha256OfFile(file)).params(options).text(placementText(part.placement));
  for (const int face : part.faces) {
    key.text(std::to_string(face));
  }
  if (part.wallSide) {
    key.text("side " + std::to_string(static_cast<int>(*part.wallSide)));
  }
  return stage<io::ImportedPart>("part", std::move(key), context, [&](const JobContext& own) {
    io::ImportedPart imported =
        io::importPart(file, io::importOptionsSchema().read(options), toPose(part.placement), own);
    if (!part.faces.empty()) {
      imported.surface = std::make_shared<const geometry::PartSurface>(
          geometry::selectFaces(*imported.surface, part.faces));
    }
    if (part.wallSide) {
      try {
        takeSide(imported, *part.wallSide, id, own);
      } catch (const Error& error) {
        rethrowIn(error, text("part '%1'", {id}));
      }
    }
    return imported;
  });
}

std::shared_ptr<const io::ImportedPart> Pipeline::importPart(const std::string& part,
                                                             const JobContext& context) const {
  return stagePart(part, context).value;
}

Staged<toolpath::Substrate> Pipeline::stageSubstrate(const std::string& id,
                                                     const JobContext& context) const {
  const Substrate& substrate = *document_.project().substrate(id);
  StageKey key("substrate", kSubstrateVersion);
  key.text(placementText(substrate.placement));
  std::shared_ptr<const geometry::PartSurface> body;
  if (substrate.type == Substrate::Type::Part) {
    const Staged<io::ImportedPart> part = stagePart(substrate.part, context);
    body = part.value->surface;
    key.text(part.key);
  } else {
    for (const double size : substrate.sizeMm) {
      key.text(formatFixed(size, 9));
    }
  }
  return stage<toolpath::Substrate>("substrate", std::move(key), context, [&](const JobContext&) {
    const geometry::Pose pose = toPose(substrate.placement);
    return body != nullptr
               ? toolpath::Substrate(pose, body)
               : toolpath::Substrate(pose, geometry::Vec3(substrate.sizeMm[0], substrate.sizeMm[1],
                                                          substrate.sizeMm[2]));
  });
}

std::shared_ptr<const toolpath::Substrate> Pipeline::loadSubstrate(
    const std::string& substrate, const JobContext& context) const {
  return stageSubstrate(substrate, context).value;
}

std::shared_ptr<const cell::Cell> Pipeline::loadCell(const JobContext& context) const {
  return stageCell(context).value;
}

std::shared_ptr<const geometry::GuideCurve> Pipeline::makeGuide(const Guide& guide,
                                                                std::string& key,
                                                                const JobContext& context) const {
  switch (guide.type) {
    case Guide::Type::Edge: {
      const Staged<io::ImportedPart> part = stagePart(guide.part, context);
      const auto& brep = part.value->surface->brep;
      if (brep == nullptr) {
        throw Error(ErrorCode::ProjectInvalid,
                    text("the part '%1' is a mesh and has no CAD edges", {guide.part}),
                    text("guide '%1'", {guide.id}), "use a polyline or a formula as guide");
      }
      const int edge = guide.edgeName.empty() ? guide.edge : edgeByName(*brep, guide.edgeName);
      key = part.key + ":" + std::to_string(edge) + (guide.reversed ? "r" : "");
      return geometry::guideFromEdge(brep, edge, guide.reversed);
    }
    case Guide::Type::Polyline: {
      const std::filesystem::path file = resolvePath(project_, guide.file);
      key = sha256OfFile(file);
      return geometry::guideFromFile(pathText(file));
    }
    case Guide::Type::Formula:
      key = joinText({guide.formulas[0], guide.formulas[1], guide.formulas[2],
                      formatFixed(guide.begin, 12), formatFixed(guide.end, 12)},
                     ";");
      try {
        return geometry::guideFromFormula(guide.formulas, guide.begin, guide.end);
      } catch (const Error& error) {
        if (error.code() != ErrorCode::InvalidArgument) {
          throw;
        }
        throw Error(ErrorCode::ProjectInvalid, error.whatText(), text("guide '%1'", {guide.id}),
                    error.hintText());
      }
  }
  return nullptr;
}

process::ProcessParams Pipeline::processOf(const Operation& operation, Value& completed) const {
  const Process& process = *document_.project().process(operation.process);
  Value params = Value::object();
  if (!process.file.empty()) {
    const std::filesystem::path file = resolvePath(project_, process.file);
    const Value tree = parseJson(readFile(file), pathText(file));
    params = tree.isObject() && tree.contains("params") ? tree.at("params") : tree;
    if (!params.isObject()) {
      throw Error(ErrorCode::ProjectInvalid, "the file holds no process parameters", pathText(file),
                  "write them as {\"params\": {...}}; `camcli schema process` lists them");
    }
    std::vector<ParamProblem> problems =
        process::ProcessParams::schema().params().validate(params, "params");
    std::erase_if(problems, [](const ParamProblem& p) { return p.unknown; });
    throwProblems(problems, ErrorCode::ProjectInvalid, pathText(file));
  }
  if (process.params.isObject()) {
    for (const auto& [key, value] : process.params.asObject()) {
      params.set(key, value);
    }
  }
  completed =
      process::ProcessParams::schema().params().complete(params, "process '" + process.id + "'");
  return process::ProcessParams::schema().read(completed);
}

Staged<cell::Cell> Pipeline::stageCell(const JobContext& context) const {
  const FileRef& ref = document_.project().cell;
  if (ref.empty()) {
    throw Error(ErrorCode::ProjectInvalid, "the project names no cell", pathText(project_),
                "set \"cell\" to a cell file");
  }
  const std::filesystem::path file = resolvePath(project_, ref);
  StageKey key("cell", kCellVersion);
  const std::string text = readFile(file);
  key.text(sha256Hex(text));
  for (const std::filesystem::path& mesh :
       cell::shapeFiles(parseJson(text, pathText(file)), file.parent_path())) {
    // A missing mesh is told by the reader, with its place in the file.
    key.text(std::filesystem::exists(mesh) ? sha256OfFile(mesh) : std::string());
  }
  if (const auto other =
          cell::otherConfigurationFile(parseJson(text, pathText(file)), file.parent_path())) {
    key.text(std::filesystem::exists(*other) ? sha256OfFile(*other) : std::string());
  }
  return stage<cell::Cell>("cell", std::move(key), context,
                           [&](const JobContext& own) { return cell::loadCell(file, own); });
}

const Operation& Pipeline::operationOf(const std::string& id) const {
  const Operation* operation = document_.project().operation(id);
  if (operation == nullptr) {
    std::vector<std::string> ids;
    for (const Operation& known : document_.project().operations) {
      ids.push_back(known.id);
    }
    const auto near = nearestName(id, ids);
    throw Error(
        ErrorCode::InvalidArgument, text("the project has no operation '%1'", {id}), {},
        near ? text("did you mean '%1'?", {*near}) : text("operations: %1", {joinText(ids, ", ")}));
  }
  return *operation;
}

OperationResult Pipeline::compute(const std::string& id, const JobContext& context) const {
  return computeUntil(id, Until::Program, context);
}

OperationResult Pipeline::computePath(const std::string& id, const JobContext& context) const {
  return computeUntil(id, Until::Path, context);
}

OperationResult Pipeline::computeUntil(const std::string& id,
                                       Until until,
                                       const JobContext& context) const {
  const Operation& operation = operationOf(id);
  const Text place = text("operation '%1'", {id});
  try {
    return computeStages(operation, until, context);
  } catch (const RemediedError& error) {
    std::vector<Command> remedy;
    for (const ParamSetting& setting : error.settings()) {
      remedy.push_back(detail::setParam(id, setting));
    }
    throw OperationError(Error(error.code(), error.messageText(),
                               text("%1: %2", {place, error.contextText()}), error.hintText()),
                         std::move(remedy));
  } catch (const Error& error) {
    rethrowIn(error, place);
  }
}

motion::PlacementMap Pipeline::searchPlacement(const std::string& id,
                                               const motion::PlacementSearch& search,
                                               const JobContext& context) const {
  const Operation& operation = operationOf(id);
  try {
    const OperationResult result = computeStages(operation, Until::Cell, context.portion(0.0, 0.3));
    const auto params = motion::MotionParams::schema().read(operation.motion, "motion");
    std::unique_ptr<collision::CellCollision> model;
    if (params.checkCollisions && !result.cell->shapes.empty()) {
      collision::CollisionSettings settings;
      settings.safetyDistance = params.safetyDistance.value();
      model = std::make_unique<collision::CellCollision>(*result.cell, *result.path,
                                                         result.substrate.get(), settings, context);
    }
    return motion::searchPlacement(*result.path, *result.cell, model.get(), params, search,
                                   context.portion(0.3, 1.0, "placement"));
  } catch (const Error& error) {
    rethrowIn(error, text("operation '%1'", {id}));
  }
}

Staged<toolpath::Toolpath> Pipeline::stageEdits(const Operation& operation,
                                                const Staged<toolpath::Toolpath>& path,
                                                const toolpath::PathParams& params,
                                                const JobContext& context) const {
  StageKey key("edits", kEditsVersion);
  key.text(path.key);
  const std::vector<toolpath::Edit> edits = enabledEdits(operation);
  for (const OperationEdit& edit : operation.edits) {
    if (edit.enabled) {
      key.text(edit.id)
          .text(toolpath::infoOf(edit.type).key)
          .params(toolpath::editSchema(edit.type).params().complete(edit.params));
    }
  }
  if (edits.empty()) {
    return path;
  }
  return stage<toolpath::Toolpath>("edits", std::move(key), context, [&](const JobContext& own) {
    return toolpath::applyEdits(*path.value, edits, params.zones(), own);
  });
}

OperationResult Pipeline::computeStages(const Operation& operation,
                                        Until until,
                                        const JobContext& context) const {
  OperationResult result;
  result.id = operation.id;
  result.strategy = operation.strategy;
  const auto collectFrom = [&](const auto& staged) {
    collect(result.findings, detail::withPartNames(staged.findings, operation.parts), operation.id);
  };

  plugin::SliceInput input;
  StageKey sliceKey("slice", kSliceVersion);
  requireBudget(operation.parts.size(), "parts",
                text("the operation has %1 parts", {std::to_string(operation.parts.size())}),
                "parts");
  std::map<std::string, std::size_t> firstWith;
  for (std::size_t i = 0; i < operation.parts.size(); ++i) {
    const Staged<io::ImportedPart> part =
        stagePart(operation.parts[i], context.portion(0.0, 0.25, "import"));
    collectFrom(part);
    result.parts.push_back(part.value);
    input.parts.push_back(part.value->surface);
    sliceKey.text(part.key);
    // The key holds the file's content, its import and its place.
    if (const auto [it, fresh] = firstWith.emplace(part.key, i); !fresh) {
      throw Error(ErrorCode::ProjectInvalid,
                  text("the parts '%1' and '%2' are equal and stand in one place",
                       {operation.parts[it->second], operation.parts[i]}),
                  "parts", "move one of them, or take it out of the operation");
    }
  }
  const Staged<toolpath::Substrate> substrate = stageSubstrate(operation.substrate, context);
  collectFrom(substrate);
  result.substrate = input.substrate = substrate.value;
  if (!operation.guide.empty()) {
    std::string guideKey;
    try {
      input.guide = makeGuide(*document_.project().guide(operation.guide), guideKey, context);
    } catch (const Error& error) {
      // What is wrong stands in the project, not in the command.
      throw Error(
          error.code() == ErrorCode::InvalidArgument ? ErrorCode::ProjectInvalid : error.code(),
          error.messageText(), text("guide '%1', %2", {operation.guide, error.contextText()}),
          error.hintText());
    }
    sliceKey.text(guideKey);
  }
  if (!operation.file.empty()) {
    const std::filesystem::path file = resolvePath(project_, operation.file);
    const std::string text = readFile(file);
    input.imported = std::make_shared<const toolpath::ImportedPath>(
        toolpath::readPathTable(text, pathText(file), context));
    sliceKey.text(sha256Hex(text));
  }
  const auto pathParams = toolpath::PathParams::schema().read(operation.path, "path");
  Value processParams;
  result.process = processOf(operation, processParams);
  input.bead = {result.process.heightMin.value(), result.process.heightMax.value(),
                result.process.beadWidth.value()};
  double deviation = 0.0;
  for (const auto& part : input.parts) {
    deviation = std::max(deviation, geometry::meshDeviation(*part));
  }
  input.sampling = pathParams.sampling(input.bead.width, deviation);
  for (std::size_t i = 0; i < result.parts.size(); ++i) {
    collect(result.findings,
            compareWithBead(*result.parts[i], operation.parts[i], input.bead.width), operation.id);
  }
  const auto strategy = findStrategy(operation.strategy);
  const Value sliceParams = strategy->info.params.complete(operation.params, "params");
  sliceKey.text(substrate.key)
      .text(strategy->info.id)
      .text(std::to_string(strategy->info.version))
      .text(strategy->pluginVersion);
  sliceKey.params(sliceParams)
      .text(formatReal(input.sampling.chordError))
      .text(formatReal(input.sampling.maxSpacing))
      .text(formatReal(input.bead.heightMin))
      .text(formatReal(input.bead.heightMax))
      .text(formatReal(input.bead.width));
  auto sliced = stage<toolpath::SlicedLayers>(
      "slice", std::move(sliceKey), context.portion(0.25, 0.6, "slice"),
      [&](const JobContext& own) {
        toolpath::SlicedLayers layers = strategy->strategy->slice(input, sliceParams, own);
        requireBudget(layers.layers.size(), "layers",
                      text("the operation has %1 layers", {std::to_string(layers.layers.size())}),
                      "slice", ErrorCode::JobFailed);
        toolpath::reportLeftOut(layers, input.parts, *input.substrate, input.bead, own);
        return layers;
      });
  collectFrom(sliced);
  input.imported = nullptr;  // the layers hold its points

  StageKey pathKey("path", kPathVersion);
  pathKey.text(sliced.key).params(toolpath::PathParams::schema().params().complete(operation.path));
  auto path = stage<toolpath::Toolpath>(
      "path", std::move(pathKey), context.portion(0.6, 0.7, "path"), [&](const JobContext& own) {
        const std::size_t points = pointsOf(*sliced.value);
        requireBudget(points, "points", text("the path has %1 points", {std::to_string(points)}),
                      "path", ErrorCode::JobFailed);
        return toolpath::buildToolpath(*sliced.value, *substrate.value, pathParams, own,
                                       input.bead);
      });
  collectFrom(path);

  Staged<toolpath::Toolpath> edited = stageEdits(operation, path, pathParams, context);
  if (edited.key != path.key) {
    // What was found before is about the layers as the strategy made them.
    result.findings = toolpath::findingsAfter(std::move(result.findings), path.value->layers.size(),
                                              enabledEdits(operation));
    collectFrom(edited);
  }

  StageKey processKey("process", kProcessVersion);
  processKey.text(edited.key).params(processParams);
  const auto processed = stage<toolpath::Toolpath>(
      "process", std::move(processKey), context, [&](const JobContext& own) {
        return process::applyProcess(*edited.value, result.process, own);
      });
  collectFrom(processed);
  result.path = processed.value;
  // A long path takes as much memory in each stage: what is not needed any more goes.
  sliced.value = nullptr;
  path.value = nullptr;
  edited.value = nullptr;

  result.remedies = detail::triedSettings(result.findings, operation.id);
  if (until == Until::Path) {
    return result;
  }
  const Staged<cell::Cell> cell = stageCell(context);
  collectFrom(cell);
  result.cell = cell.value;
  if (until == Until::Cell) {
    return result;
  }
  const auto motionParams = motion::MotionParams::schema().read(operation.motion, "motion");
  StageKey motionKey("motion", kMotionVersion);
  motionKey.text(processed.key)
      .text(cell.key)
      .text(substrate.key)
      .params(motion::MotionParams::schema().params().complete(operation.motion));
  const auto motion = stage<motion::CheckedMotion>(
      "motion", std::move(motionKey), context.portion(0.7, 0.95, "motion"),
      [&](const JobContext& own) {
        motion::CheckedMotion checked = motion::planCheckedMotion(
            *processed.value, *cell.value, substrate.value.get(), motionParams, operation.id, own);
        const toolpath::Toolpath& built = checked.pathChanged ? checked.path : *processed.value;
        if (motion::hasPauses(built)) {
          checked.planned = motion::withPauses(std::move(checked.planned), built);
        }
        checked.planned =
            motion::withCraters(std::move(checked.planned), result.process.craterTime.value());
        return checked;
      });
  collectFrom(motion);
  result.motion =
      std::shared_ptr<const motion::PlannedMotion>(motion.value, &motion.value->planned);
  result.collisions = motion.value->collisions;
  if (motion.value->pathChanged) {
    result.path = std::shared_ptr<const toolpath::Toolpath>(motion.value, &motion.value->path);
  }

  StageKey programKey("program", kProgramVersion);
  programKey.text(motion.key)
      .text(operation.id)
      .text(document_.project().name)
      .params(processParams);
  const auto program = stage<program::Program>(
      "program", std::move(programKey), context.portion(0.95, 1.0, "program"),
      [&](const JobContext& own) {
        program::ArcSettings arc;
        arc.job = result.process.job;
        arc.craterTime = result.process.craterTime.value();
        arc.jointSpeedRatio = motionParams.jointSpeedRatio;
        arc.wireDiameter = result.process.wireDiameter.value();
        arc.wireSpeed = process::operationWireSpeed(*result.path, result.process);
        arc.liftHeight =
            std::max(motionParams.approachHeight.value(), motionParams.safeHeight.value());
        arc.liftSpeed = motionParams.travelSpeed.value();
        return program::programFromMotion(motion.value->planned, *cell.value, arc, operation.id,
                                          document_.project().name, own);
      });
  collectFrom(program);
  result.program = program.value;
  if (!isTrial_) {
    addRemedies(operation, result, motion.key, context.portion(1.0, 1.0));
  }
  context.report(1.0);
  return result;
}

void Pipeline::addRemedies(const Operation& operation,
                           OperationResult& result,
                           const std::string& key,
                           const JobContext& context) const {
  // Each try plans the whole operation: as many as take a time like that of the planning itself.
  constexpr std::size_t kMostTries = 3;
  constexpr std::size_t kMostPoints = 60000;
  const std::size_t tries =
      std::min(kMostTries, kMostPoints / std::max<std::size_t>(result.path->pointCount(), 1));
  const auto makeProposal = [&](const Diagnostic& finding) {
    return detail::proposalOf(finding, document_, operation.id, *result.cell, project_);
  };
  const auto tryRemedy =
      [&](const std::vector<Command>& commands) -> std::optional<std::vector<Diagnostic>> {
    try {
      Document changed = document_;
      for (const Command& command : commands) {
        changed = apply(changed, command);
      }
      Pipeline trial(changed, project_, plugins_, cache_);
      trial.isTrial_ = true;
      return trial.computeUntil(operation.id, Until::Program, context).findings;
    } catch (const CancelledError&) {
      throw;
    } catch (const Error&) {
      return std::nullopt;
    }
  };
  StageKey stageKey("remedies", kRemediesVersion);
  stageKey.text(key).text(operation.id);
  const auto tried = stage<detail::RemediedFindings>(
      "remedies", std::move(stageKey), context, [&](const JobContext&) {
        return detail::triedRemedies(result.findings, makeProposal, tryRemedy, tries);
      });
  result.findings = tried.value->findings;
  result.remedies = tried.value->commands;
  // What a stage has tried itself needs no try.
  const auto settings = detail::triedSettings(result.findings, operation.id);
  for (std::size_t i = 0; i < settings.size(); ++i) {
    if (!settings[i].empty()) {
      result.remedies[i] = settings[i];
    }
  }
}

std::vector<plugin::OutputFile> Pipeline::post(const Output& output,
                                               const OperationResult& result,
                                               const JobContext& context) const {
  const auto post = findPost(output.post);
  try {
    const Value params = post->info.params.complete(output.params, "params");
    checkController(post->info, *result.program, *plugins_, context);
    return post->post->post(*result.program, params, context);
  } catch (const Error& error) {
    rethrowIn(error, text("output '%1', operation '%2'", {output.id, result.id}));
  }
}

}  // namespace wcam::project
