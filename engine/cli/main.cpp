// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/budget.hpp"
#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/parallel.hpp"
#include "wcam/base/text.hpp"
#include "wcam/plugin/crash_notice.hpp"
#include "wcam/project/report.hpp"

#include "command_line.hpp"

#include <cstdio>
#include <cstring>
#include <exception>
#include <memory>

namespace {

using namespace wcam;

constexpr int kInternal = 2;

/// A plugin that the user names must be usable, even when the run does not need it; one that takes
/// the place of another is reported. @throws Error(PluginRefused)
void loadNamedPlugins(const plugin::PluginHost& plugins, const cli::Console& console) {
  plugins.loadRequested();
  for (const plugin::PluginReport& report : plugins.reports()) {
    if (report.origin == plugin::PluginOrigin::Requested &&
        report.verdict == plugin::PluginVerdict::Refused) {
      throw Error(ErrorCode::PluginRefused, text("the plugin is refused: %1", {report.reason}),
                  pathText(report.path), "correct it, or leave out --plugin");
    }
    const bool replaced = report.verdict == plugin::PluginVerdict::Shadowed ||
                          report.verdict == plugin::PluginVerdict::Refused;
    if (report.origin == plugin::PluginOrigin::Installed && replaced) {
      console.complain("camcli: warning: the installed plugin " + report.id +
                       " is not used: " + report.reason.str());
    }
  }
}

int runVerb(const cli::CommandLine& line,
            const cli::Console& console,
            const std::stop_token& stop) {
  const cli::Options& options = line.options();
  if (line.verb() == nullptr) {
    std::fputs(cli::completionScript(line.app(), options.shell).c_str(), stdout);
    return 0;
  }
  std::vector<std::filesystem::path> files;
  for (const std::string& file : options.plugins) {
    files.push_back(pathFromText(file));
  }
  const ThreadLimit threads(options.threads);
  const auto plugins = std::make_shared<const plugin::PluginHost>(
      plugin::defaultPluginSearch(files, !options.noUserPlugins));
  // The list of plugins says itself what is refused.
  if (!files.empty() && line.verb() != cli::pluginsListVerb) {
    loadNamedPlugins(*plugins, console);
  }
  return line.verb()({options, console, JobContext(stop, console.progressBar()), plugins});
}

int fail(const Error& error, const cli::Console& console, bool json) {
  console.endProgress();
  console.error(error);
  if (json) {
    std::fputs(toCanonicalJson(project::failedReport({{}, error})).c_str(), stdout);
  }
  return exitCodeOf(error.code());
}

int guarded(int argc, char** argv, const std::stop_token& stop, cli::Console& console) {
  // Known before the options are read, which may fail.
  bool json = false;
  for (int i = 1; i < argc; ++i) {
    json = json || std::strcmp(argv[i], "--json") == 0;
  }
  try {
    cli::CommandLine line;
    if (const auto text = line.parse(argc, argv)) {
      std::fputs(text->c_str(), stdout);
      return 0;
    }
    console = cli::Console(line.options().quiet);
    if (!line.options().budget.empty()) {
      setBudget(joinText(line.options().budget, ","));
    }
    limitMemory();
    return runVerb(line, console, stop);
  } catch (const Error& error) {
    return fail(error, console, json);
  } catch (const std::bad_alloc&) {
    return fail(outOfMemory(), console, json);
  } catch (const std::exception& error) {
    return fail(Error(ErrorCode::Internal, error.what(), "unexpected",
                      "please report this with the project file"),
                console, json);
  }
}

}  // namespace

int main(int argc, char** argv) {
  cli::prepareProcess();
  plugin::nameCrashes("camcli");
  const cli::InterruptGuard interrupt;
  cli::Console console(false);
  try {
    const int code = guarded(argc, argv, interrupt.token(), console);
    const bool lost = std::ferror(stdout) != 0;
    if (std::fflush(stdout) != 0 || lost) {
      console.complain(
          "camcli: error: standard output cannot be written\n"
          "  hint: direct it to a file with free space");
      return code != 0 ? code : exitCodeOf(ErrorCode::OutputConflict);
    }
    return code;
  } catch (...) {
    return kInternal;
  }
}
