// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line.hpp"

#include "wcam/base/file_io.hpp"
#include "wcam/base/text.hpp"
#include "wcam/base/version.h"

namespace wcam::cli {

namespace {

constexpr const char* kPurpose =
    "Prepares parts for robotic wire-arc additive manufacturing. camcli --project part.wcam "
    "computes the project and exports what it stores.";

constexpr const char* kExitCodes =
    "Exit codes: 0 ok, 1 usage, 2 internal, 3 input or project, 4 output conflict, 5 check "
    "violations, 6 job failed,\n7 plugin missing or refused, 130 cancelled.";

/// The verb that was given last: `plugins list` rather than `plugins`.
const CLI::App& innermost(const CLI::App& app) {
  const auto verbs = app.get_subcommands();
  return verbs.empty() ? app : innermost(*verbs.front());
}

std::string commandName(const CLI::App& app) {
  return app.get_parent() == nullptr ? app.get_name()
                                     : commandName(*app.get_parent()) + " " + app.get_name();
}

std::vector<std::string> optionNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      names.push_back("--" + name);
    }
  }
  return names;
}

std::vector<std::string> verbNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* verb : app.get_subcommands({})) {
    names.push_back(verb->get_name());
  }
  return names;
}

std::string unexpected(const std::string& word, const CLI::App& app) {
  const bool option = word.starts_with("-");
  // A verb can only be the first word.
  const bool verb = !option && !app.get_subcommands({}).empty();
  const auto near = nearestName(word, option ? optionNames(app) : verbNames(app));
  return std::string(option ? "there is no option '"
                     : verb ? "there is no verb '"
                            : "nothing was expected where it says '") +
         word + "'" + (near ? "; did you mean '" + *near + "'?" : "");
}

/// A file whose name begins with a dash looks like an option.
std::string dashHint(const std::vector<std::string>& words) {
  std::error_code ignored;
  return !words.empty() && words.front().starts_with("-") &&
                 std::filesystem::exists(pathFromText(words.front()), ignored)
             ? "write ./" + words.front() + " for the file of this name; "
             : "";
}

}  // namespace

CommandLine::CommandLine() : app_(kPurpose) {
  app_.name("camcli");
  app_.set_version_flag("--version", std::string("camcli ") + WCAM_VERSION);
  app_.add_option("--project", options_.project, "Project file to compute and export")
      ->type_name("FILE");
  app_.add_option("--output", options_.output,
                  "Output folder (default: <project>-out beside the project)")
      ->type_name("DIR");
  addSelection(app_);
  app_.add_flag("--table", options_.table, "Also write <operation>.csv, one row per point");
  app_.add_flag("--allow-outside", options_.allowOutside,
                "Outputs may have a folder outside of the output folder");
  app_.add_flag("--check", options_.check,
                "Compute and check, write nothing; exit code 5 on violations");
  addCommon(app_);
  addFileVerbs();
  addPlaceVerb();
  addEditVerbs();
  addOtherVerbs();
  app_.require_subcommand(0, 1);
  app_.footer(kExitCodes);
}

void CommandLine::addSelection(CLI::App& target) {
  target.add_option("--post", options_.posts, "Only this output or post-processor (repeatable)")
      ->type_name("ID")
      ->allow_extra_args(false);
  target.add_option("--operation", options_.operations, "Only this operation (repeatable)")
      ->type_name("ID")
      ->allow_extra_args(false);
  target
      .add_option(
          "--set", options_.settings,
          "Change a parameter for this run, e.g. step=2.5mm or elbow.params.step=2mm (repeatable)")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  target
      .add_option("--report", options_.report,
                  "Write the report to this file as well: .html for people, else JSON; - prints it")
      ->type_name("FILE");
}

void CommandLine::addCommon(CLI::App& target) {
  target.add_flag("--json", options_.json, "Print the result as one JSON document on stdout");
  target
      .add_option("--threads", options_.threads, "Number of threads (default: one per processor)")
      ->check(CLI::Range(0, 1024))
      ->type_name("N");
  target
      .add_option("--budget", options_.budget,
                  "Change how much a run may take, e.g. memory_mb=4096 (repeatable)")
      ->type_name("KEY=N")
      ->allow_extra_args(false);
  target.add_flag("--quiet", options_.quiet, "Print errors and violations only");
  target.add_option("--plugin", options_.plugins, "Plugin library to load first (repeatable)")
      ->type_name("FILE")
      ->allow_extra_args(false);
  target.add_flag("--no-user-plugins", options_.noUserPlugins,
                  "Ignore WCAM_PLUGIN_PATH and the user's plugin folder");
}

CLI::App* CommandLine::addVerb(CLI::App& parent,
                               const char* name,
                               const char* help,
                               int (*function)(const Session&)) {
  CLI::App* verb = parent.add_subcommand(name, help);
  verb->callback([this, function] { verb_ = function; });
  addCommon(*verb);
  return verb;
}

void CommandLine::addFileVerbs() {
  CLI::App* create = addVerb(
      app_, "new", "Make a project with a plate, a process and a planar operation", newVerb);
  create->add_option("file", options_.file, "Project file to make")->required()->type_name("FILE");
  create->add_option("--part", options_.part, "Part file, copied beside the project")
      ->type_name("FILE");
  create
      ->add_option("--cell", options_.cell,
                   "Cell file, copied beside the project, or the name of one that comes with the "
                   "program (default: fanuc_arcmate120ic)")
      ->type_name("CELL");
  create->add_option("--name", options_.name, "Name of the project")->type_name("TEXT");
  CLI::App* info =
      addVerb(app_, "info", "Tell what is in a part, cell or project file, as JSON", infoVerb);
  info->add_option("file", options_.file, "File to look at")->required()->type_name("FILE");
  CLI::App* apply = addVerb(
      app_, "apply", "Apply a log of commands (JSON lines) to a project and save it", applyVerb);
  apply->add_option("project", options_.file, "Project file")->required()->type_name("PROJECT");
  apply
      ->add_option("commands", options_.commands,
                   "Commands, one JSON object per line; - reads standard input")
      ->required()
      ->type_name("COMMANDS.jsonl");
  apply->add_option("--output", options_.output, "Save as this project file instead")
      ->type_name("FILE");
  CLI::App* check =
      addVerb(app_, "check", "Check a project: format, files, parameters, reach; writes nothing",
              checkVerb);
  check->add_option("project", options_.file, "Project file")->type_name("PROJECT");
  check
      ->add_option("--output", options_.output,
                   "Look at this output folder instead: is it whole, and made from the project?")
      ->type_name("DIR");
  addSelection(*check);
}

void CommandLine::addPlaceVerb() {
  CLI::App* place =
      addVerb(app_, "place", "Search a place of the part on its table that the robot reaches best",
              placeVerb);
  place->add_option("--project", options_.file, "Project file")->required()->type_name("FILE");
  place->add_option("--operation", options_.placedOperation, "Operation whose part is placed")
      ->required()
      ->type_name("ID");
  place->add_option("--range", options_.placeRange, "Greatest move in x and y, mm (default: 200)")
      ->check(CLI::Range(0.0, 5000.0))
      ->type_name("MM");
  place->add_option("--height", options_.placeHeight, "Greatest move in z, mm (default: 0)")
      ->check(CLI::Range(0.0, 5000.0))
      ->type_name("MM");
  place->add_option("--step", options_.placeStep, "Step of the grid, mm (default: 50)")
      ->check(CLI::Range(1.0, 5000.0))
      ->type_name("MM");
  place->add_option("--turn", options_.placeTurn, "Step of the rotation, degrees (default: 30)")
      ->check(CLI::Range(1.0, 360.0))
      ->type_name("DEG");
  place
      ->add_option("--map", options_.map,
                   "Write all places with their margins as CSV; - prints them")
      ->type_name("FILE");
  place->add_flag("--apply", options_.applyPlace, "Move parts and substrate there and save");
}

void CommandLine::addEditVerbs() {
  CLI::App* edit = app_.add_subcommand("edit", "Edits of a generated toolpath, stored in a project")
                       ->require_subcommand(1);
  const auto add = [&](const char* name, const char* help, int (*function)(const Session&)) {
    CLI::App* verb = addVerb(*edit, name, help, function);
    verb->add_option("project", options_.file, "Project file")->required()->type_name("PROJECT");
    return verb;
  };
  const auto addOperation = [&](CLI::App& verb) {
    return verb.add_option("operation", options_.editedOperation, "Operation that is edited")
        ->type_name("OPERATION");
  };
  const auto addId = [&](CLI::App& verb) {
    addOperation(verb)->required();
    verb.add_option("edit", options_.edit, "Id of the edit")->required()->type_name("EDIT");
  };
  const auto addSettings = [&](CLI::App& verb) {
    verb.add_option("--set", options_.settings,
                    "A parameter of the edit, e.g. first_layer=3 (repeatable); KEY= takes the "
                    "default again")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    verb.add_flag("--disable", options_.disable, "Leave the edit out");
  };
  addVerb(*edit, "types", "List the types of edits", editTypesVerb);
  addOperation(*add("list", "List the edits of all operations or of one", editListVerb));
  CLI::App* create = add("add", "Add an edit to an operation and save the project", editAddVerb);
  addOperation(*create)->required();
  create->add_option("type", options_.editType, "What it does; `camcli edit types` lists them")
      ->required()
      ->type_name("TYPE");
  create->add_option("--id", options_.edit, "Id of the edit (default: its type)")->type_name("ID");
  create->add_option("--index", options_.index, "Place in the order, from 0 (default: the end)")
      ->check(CLI::Range(0, 1000000))
      ->type_name("N");
  addSettings(*create);
  CLI::App* set = add("set", "Change an edit and save the project", editSetVerb);
  addId(*set);
  addSettings(*set);
  set->add_flag("--enable", options_.enable, "Apply the edit again")->excludes("--disable");
  addId(*add("remove", "Remove an edit and save the project", editRemoveVerb));
  CLI::App* move = add("move", "Give an edit another place in the order", editMoveVerb);
  addId(*move);
  move->add_option("index", options_.index, "The new place, from 0")
      ->required()
      ->check(CLI::Range(0, 1000000))
      ->type_name("N");
}

void CommandLine::addOtherVerbs() {
  CLI::App* plugins = app_.add_subcommand("plugins", "Plugins")->require_subcommand(1);
  addVerb(*plugins, "list", "List all plugins with verdict and reason", pluginsListVerb);
  CLI::App* schema =
      addVerb(app_, "schema", "Print the JSON schema of a component, or the list of components",
              schemaVerb);
  schema->add_option("component", options_.component, "Component id")->type_name("COMPONENT");
  addSpeedVerb();
  CLI::App* completion =
      app_.add_subcommand("completion", "Print the completion script of a shell");
  completion->add_option("shell", options_.shell, "bash or zsh")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh"}));
  completion->callback([this] { completion_ = true; });
}

void CommandLine::addSpeedVerb() {
  CLI::App* speed = addVerb(
      app_, "speed", "Reconstruct the speed of the torch in the part from recorded motor speeds",
      speedVerb);
  speed->add_option("recording", options_.file, "CSV with time_s and <joint>_rpm of every joint")
      ->required()
      ->type_name("RECORDING.csv");
  speed
      ->add_option(
          "--cell", options_.cell,
          "Cell file with reduction ratios, or the name of one that comes with the program")
      ->required()
      ->type_name("CELL");
  speed
      ->add_option("--joints", options_.joints,
                   "Joint values at the first row, degrees or mm, separated by commas")
      ->required()
      ->type_name("Q1,Q2,...");
  speed
      ->add_option("--zero", options_.zero, "Zero convention of the cell that --joints counts from")
      ->type_name("NAME");
  speed
      ->add_option("--speed", options_.speed,
                   "Wanted speed that peaks and dips are compared with (default: the median)")
      ->type_name("SPEED");
  speed
      ->add_option("--tolerance", options_.tolerance,
                   "Part of the wanted speed beyond which it is a peak or a dip (default: 0.05)")
      ->check(CLI::Range(0.0, 1.0))
      ->type_name("RATIO");
  speed->add_option("--output", options_.output, "Write the table to this file (default: stdout)")
      ->type_name("FILE");
}

Error CommandLine::usageError(const CLI::ParseError& error) const {
  const CLI::App& app = innermost(app_);
  std::string message = error.what();
  std::string hint;
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError)) {
    const std::vector<std::string> words = app_.remaining(true);
    message = unexpected(words.empty() ? std::string() : words.front(), app);
    hint = dashHint(words);
  } else if (const std::vector<std::string> words = app_.remaining(true);
             dynamic_cast<const CLI::RequiredError*>(&error) != nullptr && !words.empty() &&
             words.front().starts_with("-") && words.front() != "--") {
    // What is missing is that word, most likely.
    message = unexpected(words.front(), app);
    hint = dashHint(words);
  } else if (!app.get_subcommands({}).empty() && app.get_parent() != nullptr) {
    message = "'" + app.get_name() + "' needs one of: " + joinText(verbNames(app), ", ");
  }
  return Error(ErrorCode::InvalidArgument, message, {},
               hint + "see `" + commandName(app) + " --help`");
}

std::optional<std::string> CommandLine::parse(int argc, char** argv) {
  try {
    app_.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return app_.help();
  } catch (const CLI::CallForVersion& version) {
    return std::string(version.what()) + "\n";
  } catch (const CLI::ParseError& error) {
    throw usageError(error);
  }
  if (verb_ == nullptr && !completion_) {
    if (options_.project.empty()) {
      throw Error(ErrorCode::InvalidArgument, "give a project with --project, or a verb", {},
                  "verbs: " + joinText(verbNames(app_), ", ") + "; see `camcli --help`");
    }
    verb_ = runProjectVerb;
  } else if (!options_.project.empty()) {
    throw Error(ErrorCode::InvalidArgument, "--project and a verb cannot stand together", {},
                "name the project after the verb");
  }
  return std::nullopt;
}

}  // namespace wcam::cli
