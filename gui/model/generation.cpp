// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generation.hpp"

#include "wcam/project/commands.hpp"
#include "wcam/project/project_file.hpp"
#include "wcam/project/run.hpp"

#include "shapes.hpp"

#include <algorithm>

namespace wcam::gui {

namespace {

/// Runs a step; keeps its error unless it is a cancel.
/// @param remedy gets the commands that put the error right
template <class Step>
std::optional<Error> errorOf(const Step& step, std::vector<project::Command>* remedy = nullptr) {
  try {
    step();
    return std::nullopt;
  } catch (const CancelledError&) {
    throw;
  } catch (const project::OperationError& error) {
    if (remedy != nullptr) {
      *remedy = error.remedy();
    }
    return error;
  } catch (const Error& error) {
    return error;
  } catch (const std::bad_alloc&) {
    return Error(ErrorCode::JobFailed, "there is not enough memory", {},
                 "use a coarser part or step");
  } catch (const std::exception& error) {
    return Error(ErrorCode::Internal, error.what(), "unexpected",
                 "please report this with the project file");
  }
}

/// Stages keep their results, so equal results are the same objects.
bool sameResult(const project::OperationResult& a, const project::OperationResult& b) {
  return a.path == b.path && a.motion == b.motion && a.program == b.program && a.cell == b.cell &&
         a.substrate == b.substrate && a.findings.size() == b.findings.size();
}

}  // namespace

namespace {

/// What the outputs say of an operation; a failing one is a violation.
std::vector<Diagnostic> outputFindings(const project::Pipeline& pipeline,
                                       const project::OperationResult& operation,
                                       const JobContext& context) {
  std::vector<Diagnostic> findings;
  for (const project::Output& output : pipeline.document().project().outputs) {
    if (!project::prints(output, operation.id)) {
      continue;
    }
    project::PrintedOutput printed;
    if (const auto missing = errorOf(
            [&] { printed = project::printOutput(pipeline, output, operation, context); })) {
      printed.error = missing;
    }
    findings.insert(findings.end(), printed.findings.begin(), printed.findings.end());
    if (printed.error) {
      findings.push_back({Severity::Violation,
                          "post.failed",
                          text("output '%1': %2", {output.id, printed.error->messageText()}),
                          printed.error->hintText(),
                          {operation.id},
                          {}});
    }
  }
  return findings;
}

}  // namespace

const GeneratedPart* Generated::part(const std::string& id) const {
  const auto found =
      std::find_if(parts.begin(), parts.end(), [&](const GeneratedPart& p) { return p.id == id; });
  return found != parts.end() ? &*found : nullptr;
}

const GeneratedPlate* Generated::plate(const std::string& id) const {
  const auto found = std::find_if(plates.begin(), plates.end(),
                                  [&](const GeneratedPlate& p) { return p.id == id; });
  return found != plates.end() ? &*found : nullptr;
}

const GeneratedOperation* Generated::operation(const std::string& id) const {
  const auto found = std::find_if(operations.begin(), operations.end(),
                                  [&](const GeneratedOperation& o) { return o.id == id; });
  return found != operations.end() ? &*found : nullptr;
}

Generated generate(const project::Pipeline& pipeline,
                   const std::string& first,
                   const Generated& before,
                   const JobContext& context,
                   const std::function<void(const Generated&)>& step) {
  Generated result;
  const project::Project& project = pipeline.document().project();
  result.findings = pipeline.document().findings();
  result.error = errorOf([&] {
    const std::vector<Diagnostic> found = pipeline.validate();
    result.findings.insert(result.findings.end(), found.begin(), found.end());
  });
  // Cell and plates first: they are seen whatever becomes of the rest.
  if (!project.cell.empty()) {
    result.cellError = errorOf([&] { result.cell = pipeline.loadCell(context); });
  }
  for (const project::Substrate& substrate : project.substrates) {
    GeneratedPlate plate;
    plate.id = substrate.id;
    // What is wrong with it is told by the operations that stand on it.
    static_cast<void>(errorOf([&] {
      plate.substrate =
          pipeline.loadSubstrate(substrate.id, context.portion(0.0, 0.1, substrate.id));
      const GeneratedPlate* old = before.plate(plate.id);
      plate.mesh = old != nullptr && old->substrate == plate.substrate
                       ? old->mesh
                       : viewport::prepare(meshOf(*plate.substrate));
    }));
    result.plates.push_back(std::move(plate));
  }
  step(result);
  for (const project::Part& part : project.parts) {
    GeneratedPart shown;
    shown.id = part.id;
    shown.error = errorOf([&] {
      shown.part = pipeline.importPart(part.id, context.portion(0.0, 0.2, "import"));
      const GeneratedPart* old = before.part(part.id);
      shown.mesh = old != nullptr && old->part == shown.part
                       ? old->mesh
                       : viewport::prepare(meshOf(*shown.part->surface));
    });
    if (const GeneratedPart* old = before.part(part.id); shown.error && old != nullptr) {
      shown.part = old->part;
      shown.mesh = old->mesh;
    }
    result.parts.push_back(std::move(shown));
    step(result);
  }
  std::vector<const project::Operation*> wanted;
  for (const project::Operation& operation : project.operations) {
    if (operation.enabled) {
      wanted.push_back(&operation);
    }
  }
  std::stable_partition(wanted.begin(), wanted.end(),
                        [&](const project::Operation* o) { return o->id == first; });
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    GeneratedOperation shown;
    shown.id = wanted[i]->id;
    const double begin = 0.2 + 0.8 * static_cast<double>(i) / static_cast<double>(wanted.size());
    const double end = 0.2 + 0.8 * static_cast<double>(i + 1) / static_cast<double>(wanted.size());
    const GeneratedOperation* old = before.operation(shown.id);
    const GeneratedPlate* plate = result.plate(wanted[i]->substrate);
    shown.substrate = plate != nullptr ? plate->mesh : nullptr;
    const auto take = [&](project::OperationResult&& computed) {
      // The same beads keep their old motion until the new one is there.
      const bool same = old != nullptr && old->path &&
                        (computed.motion == nullptr ? old->path->result().path == computed.path
                                                    : sameResult(old->path->result(), computed));
      if (same) {
        shown.path = old->path;
        return;
      }
      shown.path = std::make_shared<const PathModel>(
          std::make_shared<const project::OperationResult>(std::move(computed)));
    };
    const auto keepOld = [&] {
      if (shown.error && old != nullptr && old->path) {
        shown.path = old->path;
        shown.outdated = true;
      }
    };
    // The beads first: they are there long before their motion, and when there is none at all.
    shown.error = errorOf(
        [&] {
          take(pipeline.computePath(shown.id,
                                    context.portion(begin, 0.5 * (begin + end), shown.id)));
          context.check();
        },
        &shown.remedy);
    keepOld();
    result.operations.push_back(shown);
    if (!shown.error) {
      step(result);
      // Without a motion there are the new beads all the same.
      shown.error = errorOf(
          [&] {
            project::OperationResult computed =
                pipeline.compute(shown.id, context.portion(0.5 * (begin + end), end, shown.id));
            context.check();
            shown.outputFindings = outputFindings(pipeline, computed, context);
            take(std::move(computed));
          },
          &shown.remedy);
      // New beads stand alone; a motion of the same beads is an old one now.
      shown.outdated = shown.error && shown.path->result().motion != nullptr;
    }
    result.operations.back() = std::move(shown);
    step(result);
  }
  return result;
}

std::optional<ParamSchema> schemaOf(const plugin::PluginHost& plugins,
                                    const project::ParamSection& section) {
  if (section.list == "operations" && section.section == "path") {
    return toolpath::PathParams::schema().params();
  }
  if (section.list == "operations" && section.section == "motion") {
    return motion::MotionParams::schema().params();
  }
  if (section.list == "processes") {
    return process::ProcessParams::schema().params();
  }
  if (section.list == "parts") {
    return io::importOptionsSchema().params();
  }
  try {
    return plugins.info(section.component).params;
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace wcam::gui
