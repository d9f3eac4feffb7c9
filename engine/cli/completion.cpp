// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/text.hpp"

#include "verbs.hpp"
#include <CLI/CLI.hpp>

#include <algorithm>

namespace wcam::cli {

namespace {

void addOptionNames(const CLI::App& app, std::vector<std::string>& names) {
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      if (std::find(names.begin(), names.end(), "--" + name) == names.end()) {
        names.push_back("--" + name);
      }
    }
  }
}

/// Of a verb and the verbs inside of it, each once.
std::string optionNames(const CLI::App& app, bool inner) {
  std::vector<std::string> names;
  addOptionNames(app, names);
  for (const CLI::App* verb : app.get_subcommands({})) {
    if (inner) {
      addOptionNames(*verb, names);
    }
  }
  return joinText(names, " ");
}

std::string verbNames(const CLI::App& app) {
  std::string names;
  for (const CLI::App* verb : app.get_subcommands({})) {
    names += (names.empty() ? "" : " ") + verb->get_name();
  }
  return names;
}

}  // namespace

std::string completionScript(const CLI::App& app, const std::string& shell) {
  // One function serves both shells: zsh runs it through bashcompinit. There the file itself is the
  // function _camcli, which is called once while it is loaded and has to complete then as well.
  const bool zsh = shell == "zsh";
  const std::string function = zsh ? "_camcli_words" : "_camcli";
  std::string script = zsh ? "#compdef camcli\nautoload -U +X bashcompinit && bashcompinit\n"
                           : "# bash completion of camcli\n";
  script += function +
            "() {\n  local word=\"${COMP_WORDS[COMP_CWORD]}\" "
            "before=\"${COMP_WORDS[COMP_CWORD-1]}\" verb=\"${COMP_WORDS[1]}\"\n";
  script += "  local options=\"" + optionNames(app, false) + "\" verbs=\"\"\n  case \"$verb\" in\n";
  for (const CLI::App* verb : app.get_subcommands({})) {
    script += "    " + verb->get_name() + ") options=\"" + optionNames(*verb, true) +
              "\" verbs=\"" + verbNames(*verb) + "\" ;;\n";
  }
  script += "  esac\n  case \"$before\" in\n";
  script +=
      "    "
      "--post|--operation|--set|--threads|--name|--cell|--joints|--zero|--speed|--tolerance|--id|--"
      "index) "
      "return ;;\n";
  script +=
      "    --project|--output|--report|--plugin|--part) COMPREPLY=($(compgen -f -- "
      "\"$word\")); return ;;\n";
  script += "    completion) COMPREPLY=($(compgen -W \"bash zsh\" -- \"$word\")); return ;;\n";
  script +=
      "    schema) COMPREPLY=($(compgen -W \"$(camcli schema 2>/dev/null)\" -- \"$word\")); return "
      ";;\n  esac\n";
  script +=
      "  if [[ \"$word\" == -* ]]; then\n    COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n";
  script += "  elif [[ $COMP_CWORD -eq 1 ]]; then\n    COMPREPLY=($(compgen -W \"" +
            verbNames(app) + "\" -- \"$word\"))\n";
  script +=
      "  elif [[ $COMP_CWORD -eq 2 && -n \"$verbs\" ]]; then\n    COMPREPLY=($(compgen -W "
      "\"$verbs\" -- \"$word\"))\n";
  script +=
      "  else\n    COMPREPLY=($(compgen -f -- \"$word\"))\n  fi\n}\ncomplete -o filenames -F " +
      function + " camcli\n";
  if (zsh) {
    script += "(( ${+compstate} )) && _bash_complete -o filenames -F " + function + "\n";
  }
  return script;
}

}  // namespace wcam::cli
