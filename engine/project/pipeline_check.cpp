// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a project, without computing anything.

#include "wcam/base/file_io.hpp"
#include "wcam/base/text.hpp"
#include "wcam/project/pipeline.hpp"
#include "wcam/project/project_file.hpp"

#include <algorithm>
#include <charconv>
#include <set>
#include <utility>

namespace wcam::project {

namespace {

void checkParams(const ParamSchema& schema,
                 const Value& params,
                 const std::string& path,
                 std::vector<ParamProblem>& problems) {
  for (ParamProblem& problem : schema.validate(params, path)) {
    problems.push_back(std::move(problem));
  }
}

/// The numbers of a version, "1.12.3"; what is no number ends it.
std::vector<int> versionNumbers(const std::string& version) {
  std::vector<int> numbers;
  for (const std::string& part : splitText(version, '.')) {
    int number = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
    if (error != std::errc{}) {
      break;
    }
    numbers.push_back(number);
  }
  numbers.resize(3);
  return numbers;
}

/// The plugins that the project names against those that are there.
void checkNamed(const Project& project,
                const std::vector<plugin::PluginReport>& reports,
                std::vector<Diagnostic>& findings) {
  for (const PluginRef& wanted : project.plugins) {
    const auto found = std::find_if(reports.begin(), reports.end(), [&](const auto& report) {
      return report.id == wanted.id && (report.verdict == plugin::PluginVerdict::Available ||
                                        report.verdict == plugin::PluginVerdict::Loaded);
    });
    if (found == reports.end()) {
      findings.push_back(
          {Severity::Warning,
           "project.plugin_missing",
           text("the project names the plugin %1, which is not installed", {wanted.id}),
           "install it, or take it out of \"plugins\"; `camcli plugins list` shows what is there",
           {},
           {}});
      continue;
    }
    const auto mine = versionNumbers(found->version);
    const auto named = versionNumbers(wanted.version);
    if (wanted.version.empty() || mine == named) {
      continue;
    }
    const bool older = mine < named;
    findings.push_back(
        {older ? Severity::Warning : Severity::Information,
         older ? "project.plugin_older" : "project.plugin_newer",
         text(older ? "the project needs version %2 of the plugin %1; version %3 is installed"
                    : "the project was made with version %2 of the plugin %1; version %3 is "
                      "installed",
              {wanted.id, wanted.version, found->version}),
         older ? text("install version %1 or a later one", {wanted.version})
               : text("check the result, then write version %1 into \"plugins\"", {found->version}),
         {},
         {}});
  }
}

/// A plugin that does not come with the program and that the project uses without naming it: who
/// opens the file elsewhere does not learn what it needs.
void checkUnnamed(const Project& project,
                  const plugin::PluginHost& host,
                  std::vector<Diagnostic>& findings) {
  std::set<std::string> used;
  for (const Operation& operation : project.operations) {
    used.insert(operation.strategy);
  }
  for (const Output& output : project.outputs) {
    used.insert(output.post);
  }
  for (const plugin::PluginReport& report : host.reports()) {
    const bool active = report.verdict == plugin::PluginVerdict::Available ||
                        report.verdict == plugin::PluginVerdict::Loaded;
    const bool needed =
        std::any_of(report.components.begin(), report.components.end(),
                    [&](const plugin::ComponentEntry& entry) { return used.contains(entry.id); });
    const bool named = std::any_of(project.plugins.begin(), project.plugins.end(),
                                   [&](const PluginRef& ref) { return ref.id == report.id; });
    if (active && needed && !named && report.origin != plugin::PluginOrigin::Installed) {
      findings.push_back(
          {Severity::Information,
           "project.plugin_not_named",
           text("the project uses the plugin %1 without naming it", {report.id}),
           text("add {\"id\": \"%1\", \"version\": \"%2\"} to \"plugins\", so that others learn "
                "what they need",
                {report.id, report.version}),
           {},
           {}});
    }
  }
}

}  // namespace

/// Components that no plugin provides. They stop what needs them, and a project only when nothing
/// else is left.
class Pipeline::MissingComponents {
public:
  /// @return nothing when the component is missing
  template <class Find>
  auto unless(const Find& find) -> decltype(find()) {
    try {
      return find();
    } catch (const Error& error) {
      if (error.code() != ErrorCode::PluginMissing && error.code() != ErrorCode::PluginRefused) {
        throw;
      }
      errors_.push_back(error);
      return nullptr;
    }
  }

  void throwIfAll(std::size_t all) const {
    if (all > 0 && errors_.size() == all) {
      throw Error(errors_.front());
    }
  }

  void addTo(std::vector<ParamProblem>& problems) const {
    for (const Error& error : errors_) {
      problems.push_back({{}, error.whatText()});
    }
  }

private:
  std::vector<Error> errors_;
};

namespace {

/// A plugin older than the project asks for is as good as missing.
void requireVersion(const Project& project, const std::string& plugin, const std::string& version) {
  for (const PluginRef& wanted : project.plugins) {
    if (wanted.id == plugin && versionNumbers(version) < versionNumbers(wanted.version)) {
      throw Error(ErrorCode::PluginMissing,
                  text("the project needs version %2 of the plugin %1; version %3 is installed",
                       {plugin, wanted.version, version}),
                  {}, text("install version %1 or a later one", {wanted.version}));
    }
  }
}

}  // namespace

std::shared_ptr<const plugin::SlicingComponent> Pipeline::findStrategy(
    const std::string& id) const {
  auto found = plugins_->findSlicing(id);
  requireVersion(document_.project(), found->plugin, found->pluginVersion);
  return found;
}

std::shared_ptr<const plugin::PostComponent> Pipeline::findPost(const std::string& id) const {
  auto found = plugins_->findPost(id);
  requireVersion(document_.project(), found->plugin, found->pluginVersion);
  return found;
}

std::vector<ParamProblem> Pipeline::problems(MissingComponents& strategies,
                                             MissingComponents& posts) const {
  const Project& project = document_.project();
  std::vector<ParamProblem> problems;
  for (std::size_t i = 0; i < project.parts.size(); ++i) {
    checkParams(io::importOptionsSchema().params(), project.parts[i].import,
                "parts[" + std::to_string(i) + "].import", problems);
  }
  for (std::size_t i = 0; i < project.processes.size(); ++i) {
    checkParams(process::ProcessParams::schema().params(), project.processes[i].params,
                "processes[" + std::to_string(i) + "].params", problems);
  }
  for (std::size_t i = 0; i < project.operations.size(); ++i) {
    const Operation& operation = project.operations[i];
    const std::string path = "operations[" + std::to_string(i) + "]";
    const auto strategy = strategies.unless([&] { return findStrategy(operation.strategy); });
    checkParams(toolpath::PathParams::schema().params(), operation.path, path + ".path", problems);
    checkParams(motion::MotionParams::schema().params(), operation.motion, path + ".motion",
                problems);
    for (std::size_t k = 0; k < operation.edits.size(); ++k) {
      const OperationEdit& edit = operation.edits[k];
      const std::string place = path + ".edits[" + std::to_string(k) + "].params";
      for (ParamProblem& problem : toolpath::validateEdit(edit.type, edit.params, place)) {
        problems.push_back(std::move(problem));
      }
    }
    if (strategy == nullptr) {
      continue;
    }
    checkParams(strategy->info.params, operation.params, path + ".params", problems);
    if (strategy->info.needsFile && operation.file.empty()) {
      problems.push_back(
          {path + ".file", text("the strategy %1 needs a file with a path", {operation.strategy})});
    }
    if (!strategy->info.needsFile && operation.parts.empty()) {
      problems.push_back(
          {path + ".parts", text("the strategy %1 needs a part", {operation.strategy})});
    }
    const std::string& automatic = strategy->info.automaticGuide;
    const bool ownGuide =
        !automatic.empty() && operation.params.isObject() && operation.params.contains(automatic) &&
        operation.params.at(automatic).isBool() && operation.params.at(automatic).asBool();
    if (strategy->info.needsGuide && operation.guide.empty() && !ownGuide) {
      problems.push_back(
          {path + ".guide", automatic.empty()
                                ? text("the strategy %1 needs a guide curve", {operation.strategy})
                                : text("the strategy %1 needs a guide curve, or set %2",
                                       {operation.strategy, automatic})});
    }
  }
  for (std::size_t i = 0; i < project.outputs.size(); ++i) {
    const auto post = posts.unless([&] { return findPost(project.outputs[i].post); });
    if (post != nullptr) {
      checkParams(post->info.params, project.outputs[i].params,
                  "outputs[" + std::to_string(i) + "].params", problems);
    }
  }
  return problems;
}

std::vector<ParamProblem> Pipeline::problems() const {
  MissingComponents strategies;
  MissingComponents posts;
  std::vector<ParamProblem> found = problems(strategies, posts);
  strategies.addTo(found);
  posts.addTo(found);
  return found;
}

std::vector<Diagnostic> Pipeline::validate() const {
  MissingComponents strategies;
  MissingComponents posts;
  std::vector<ParamProblem> problems = this->problems(strategies, posts);
  strategies.throwIfAll(document_.project().operations.size());
  posts.throwIfAll(document_.project().outputs.size());
  std::vector<Diagnostic> findings;
  for (const ParamProblem& problem : problems) {
    if (problem.unknown) {
      findings.push_back({Severity::Warning,
                          "project.unknown_parameter",
                          text("%1: %2", {problem.path, problem.message}),
                          "it is kept in the file and has no effect",
                          {},
                          {}});
    }
  }
  std::erase_if(problems, [](const ParamProblem& p) { return p.unknown; });
  throwProblems(problems, ErrorCode::ProjectInvalid, pathText(project_));
  checkNamed(document_.project(), plugins_->reports(), findings);
  checkUnnamed(document_.project(), *plugins_, findings);
  const std::vector<Diagnostic> files = checkFiles(document_, project_);
  findings.insert(findings.end(), files.begin(), files.end());
  return findings;
}

}  // namespace wcam::project
