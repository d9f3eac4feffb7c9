// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/parallel.hpp"

#include "verbs.hpp"
#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <memory>

namespace {

using namespace wcam;

constexpr int kUsage = 1;
constexpr int kInternal = 2;

struct CommandLine {
  cli::Options options;
  CLI::App app{
      "Prepares parts for robotic wire-arc additive manufacturing: camcli --project part.wcam "
      "exports what the project stores."};
  int (*verb)(const cli::Session&) = nullptr;
  bool completion = false;

  CommandLine() {
    app.name("camcli");
    app.set_version_flag("--version", std::string("camcli ") + WCAM_VERSION);
    app.add_option("--project", options.project, "Project file to compute and export")
        ->type_name("FILE");
    app.add_option("--post", options.posts, "Only this output or post-processor (repeatable)")
        ->type_name("ID")
        ->allow_extra_args(false);
    app.add_option("--operation", options.operations, "Only this operation (repeatable)")
        ->type_name("ID")
        ->allow_extra_args(false);
    app.add_option(
           "--set", options.settings,
           "Change a parameter for this run, e.g. step=2.5mm or elbow.params.step=2mm (repeatable)")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    app.add_flag("--table", options.table, "Also write <operation>.csv, one row per point");
    app.add_option("--report", options.report, "Write the report to this file as well")
        ->type_name("FILE");
    app.add_flag("--check", options.check,
                 "Compute and check, write nothing; exit code 5 on violations");
    addCommon(app);
    addVerbs();
    app.footer(
        "Exit codes: 0 ok, 1 usage, 2 internal, 3 input or project, 4 output conflict, 5 check "
        "violations, 6 job failed,\n"
        "7 plugin missing or refused, 130 cancelled.");
  }

  void addCommon(CLI::App& target) {
    target
        .add_option("--output", options.output,
                    "Output folder (default: <project>-out beside the project)")
        ->type_name("DIR");
    target.add_flag("--json", options.json, "Print the report as JSON on stdout");
    target
        .add_option("--threads", options.threads, "Number of threads (default: one per processor)")
        ->check(CLI::Range(0, 1024))
        ->type_name("N");
    target.add_flag("--quiet", options.quiet, "Print errors only");
    target.add_option("--plugin", options.plugins, "Plugin library to load first (repeatable)")
        ->type_name("FILE")
        ->allow_extra_args(false);
    target.add_flag("--no-user-plugins", options.noUserPlugins,
                    "Ignore WCAM_PLUGIN_PATH and the user's plugin folder");
  }

  CLI::App* addVerb(CLI::App& parent,
                    const char* name,
                    const char* help,
                    int (*function)(const cli::Session&)) {
    CLI::App* verb = parent.add_subcommand(name, help);
    verb->callback([this, function] { verb_(function); });
    return verb;
  }

  void addVerbs() {
    CLI::App* create = addVerb(
        app, "new", "Make a project with a plate, a process and a planar operation", cli::newVerb);
    create->add_option("file", options.file, "Project file to make")->required()->type_name("FILE");
    create->add_option("--part", options.part, "Part file, copied beside the project")
        ->type_name("FILE");
    create
        ->add_option("--cell", options.cell,
                     "Cell file, or the name of one that comes with the program")
        ->type_name("CELL");
    create->add_option("--name", options.name, "Name of the project")->type_name("TEXT");
    CLI::App* info = addVerb(app, "info", "Tell what is in a part, cell or project file, as JSON",
                             cli::infoVerb);
    info->add_option("file", options.file, "File to look at")->required()->type_name("FILE");
    CLI::App* apply =
        addVerb(app, "apply", "Apply a log of commands (JSON lines) to a project and save it",
                cli::applyVerb);
    apply->add_option("project", options.file, "Project file")->required()->type_name("PROJECT");
    apply->add_option("commands", options.commands, "Commands, one JSON object per line")
        ->required()
        ->type_name("COMMANDS.jsonl");
    CLI::App* check =
        addVerb(app, "check", "Check a project: format, files, parameters, reach; writes nothing",
                cli::checkVerb);
    check->add_option("project", options.file, "Project file")->required()->type_name("PROJECT");
    CLI::App* plugins = app.add_subcommand("plugins", "Plugins")->require_subcommand(1);
    CLI::App* list =
        addVerb(*plugins, "list", "List all plugins with verdict and reason", cli::pluginsListVerb);
    CLI::App* schema =
        addVerb(app, "schema", "Print the JSON schema of a component, or the list of components",
                cli::schemaVerb);
    schema->add_option("component", options.component, "Component id")->type_name("COMPONENT");
    CLI::App* completion =
        app.add_subcommand("completion", "Print the completion script of a shell");
    completion->add_option("shell", options.shell, "bash or zsh")
        ->required()
        ->check(CLI::IsMember({"bash", "zsh"}));
    completion->callback([this] { completion_(); });
    for (CLI::App* verb : {create, info, apply, check, list, schema}) {
      addCommon(*verb);
    }
    app.require_subcommand(0, 1);
  }

private:
  void verb_(int (*function)(const cli::Session&)) { verb = function; }

  void completion_() { completion = true; }
};

int runVerb(const CommandLine& line, const cli::Console& console, const std::stop_token& stop) {
  std::vector<std::filesystem::path> files;
  for (const std::string& file : line.options.plugins) {
    files.push_back(pathFromText(file));
  }
  const ThreadLimit threads(line.options.threads);
  const cli::Session session{line.options, console, JobContext(stop, console.progressBar()),
                             std::make_shared<const plugin::PluginHost>(
                                 plugin::defaultPluginSearch(files, !line.options.noUserPlugins))};
  return line.verb(session);
}

int guarded(const CommandLine& line, const cli::Console& console, const std::stop_token& stop) {
  const auto fail = [&](const Error& error) {
    console.endProgress();
    console.error(error);
    if (line.options.json) {
      Value report = Value::object({{"code", toString(error.code())}, {"message", error.what()}});
      if (!error.hint().empty()) {
        report.set("hint", error.hint());
      }
      std::fputs(toCanonicalJson(Value::object({{"error", report}})).c_str(), stdout);
    }
    return exitCodeOf(error.code());
  };
  try {
    return runVerb(line, console, stop);
  } catch (const Error& error) {
    return fail(error);
  } catch (const std::bad_alloc&) {
    return fail(Error(ErrorCode::JobFailed, "there is not enough memory", {},
                      "use a coarser part or step"));
  } catch (const std::exception& error) {
    return fail(Error(ErrorCode::Internal, error.what(), "unexpected",
                      "please report this with the project file"));
  }
}

}  // namespace

int main(int argc, char** argv) {
  const cli::InterruptGuard interrupt;
  CommandLine line;
  try {
    line.app.parse(argc, argv);
    if (line.verb == nullptr && !line.completion) {
      if (line.options.project.empty()) {
        throw CLI::RequiredError("--project or a verb");
      }
      line.verb = cli::runProjectVerb;
    }
  } catch (const CLI::ParseError& error) {
    return line.app.exit(error) == 0 ? 0 : kUsage;
  }
  if (line.completion) {
    std::fputs(cli::completionScript(line.app, line.options.shell).c_str(), stdout);
    return 0;
  }
  const cli::Console console(line.options.quiet);
  try {
    const int code = guarded(line, console, interrupt.token());
    if (std::fflush(stdout) != 0) {
      console.complain("camcli: error: standard output cannot be written");
      return exitCodeOf(ErrorCode::OutputConflict);
    }
    return code;
  } catch (...) {
    return kInternal;
  }
}
