#include <fmt/format.h>

#include "app/described_commands.h"

namespace overbend {
namespace {

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t position = text.find(what); position != std::string::npos;
       position = text.find(what, position + by.size())) {
    text.replace(position, what.size(), by);
  }
  return text;
}

std::string joined(const std::vector<std::string>& items, const char* between) {
  std::string out;
  for (const std::string& word : items) out += (out.empty() ? "" : between) + word;
  return out;
}

std::vector<std::string> names_of_commands(const std::vector<DescribedCommand>& commands) {
  std::vector<std::string> names;
  for (const DescribedCommand& command : commands) {
    if (!command.name.empty()) names.push_back(command.name);
  }
  return names;
}

// bash --------------------------------------------------------------------------------------------------------------

/// Returns the completion of the value of an option.
std::string bash_value(const DescribedCommand& command, const DescribedOption& option) {
  std::vector<std::string> patterns;
  for (const std::string& name : option.names) patterns.push_back(command.name + ":" + name);
  std::string action = "return";  // no completion for free values
  if (!option.choices.empty()) action = fmt::format("_overbend_words '{}'; return", joined(option.choices, " "));
  if (option.completes != Completes::nothing) action = "_overbend_files -f; return";
  return fmt::format("    {}) {} ;;\n", joined(patterns, "|"), action);
}

std::string bash_options(const DescribedCommand& command, const std::vector<std::string>& names) {
  std::vector<std::string> candidates = command.name.empty() ? names : std::vector<std::string>{};
  for (const DescribedOption& option : command.options) {
    candidates.insert(candidates.end(), option.names.begin(), option.names.end());
  }
  return fmt::format("    '{}') options='{}' ;;\n", command.name, joined(candidates, " "));
}

/// Returns the completion of a positional argument.
std::string bash_places(const DescribedCommand& command) {
  for (const DescribedOption& option : command.options) {
    if (!option.names.empty()) continue;
    if (!option.choices.empty()) {
      return fmt::format("    {}) _overbend_words '{}' ;;\n", command.name, joined(option.choices, " "));
    }
    const bool model = option.completes == Completes::model;
    return fmt::format("    {}) _overbend_files {} ;;\n", command.name, model ? "-f -X '!*.y*ml'" : "-f");
  }
  return "";
}

// zsh ---------------------------------------------------------------------------------------------------------------

/// Escapes descriptions inside '...[...]' and '...:...' of _arguments and _describe.
std::string zsh_text(const std::string& text) {
  std::string out = replaced(text, "'", "'\\''");
  for (const char* special : {":", "[", "]"}) out = replaced(out, special, std::string("\\") + special);
  return out;
}

std::string zsh_action(const DescribedOption& option) {
  if (!option.choices.empty()) return "(" + joined(option.choices, " ") + ")";
  switch (option.completes) {
    case Completes::model:
      return "_files -g \"*.y(a|)ml\"";
    case Completes::folder:
    case Completes::file:
      return "_files";
    case Completes::nothing:
      break;
  }
  return " ";
}

std::string zsh_argument(const DescribedOption& option) {
  if (option.names.empty()) {
    return fmt::format(" \\\n        '{}1:{}:{}'", option.required ? "" : ":", zsh_text(option.text),
                       zsh_action(option));
  }
  std::string out;
  for (const std::string& name : option.names) {
    out += fmt::format(" \\\n        '{}[{}]{}'", name, zsh_text(option.text),
                       option.value.empty() ? "" : fmt::format(":{}:{}", option.value, zsh_action(option)));
  }
  return out;
}

}  // namespace

std::string bash_completion(const std::vector<DescribedCommand>& commands) {
  const std::vector<std::string> names = names_of_commands(commands);
  std::string values, options, places;
  for (const DescribedCommand& command : commands) {
    options += bash_options(command, names);
    if (command.name.empty()) continue;
    places += bash_places(command);
    for (const DescribedOption& option : command.options) {
      if (!option.names.empty() && !option.value.empty()) values += bash_value(command, option);
    }
  }
  return "# Completion of overbend in bash, made by `overbend completion bash`.\n"
         "_overbend_words() { mapfile -t COMPREPLY < <(compgen -W \"$1\" -- \"$current\"); }\n"
         "_overbend_files() {\n"
         "  compopt -o filenames 2>/dev/null\n"
         "  mapfile -t COMPREPLY < <(compgen \"$@\" -- \"$current\"; compgen -d -- \"$current\")\n"
         "}\n"
         "_overbend() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command= options= word\n"
         "  COMPREPLY=()\n"
         "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
         "    case $word in " +
         joined(names, "|") +
         ") command=$word; break ;; esac\n"
         "  done\n"
         "  case $command:$before in\n" +
         values +
         "  esac\n"
         "  case $command in\n" +
         options +
         "  esac\n"
         "  if [[ $current == -* || -z $command ]]; then _overbend_words \"$options\"; return; fi\n"
         "  case $command in\n" +
         places +
         "  esac\n"
         "}\n"
         "complete -F _overbend overbend\n";
}

std::string zsh_completion(const std::vector<DescribedCommand>& commands) {
  std::string list, cases;
  for (const DescribedCommand& command : commands) {
    if (command.name.empty()) continue;
    list += fmt::format("    '{}:{}'\n", command.name, zsh_text(command.text));
    cases += fmt::format("    {})\n      _arguments", command.name);
    for (const DescribedOption& option : command.options) cases += zsh_argument(option);
    cases += "\n      ;;\n";
  }
  return "#compdef overbend\n"
         "# Completion of overbend in zsh, made by `overbend completion zsh`.\n"
         "_overbend() {\n"
         "  local -a commands\n"
         "  commands=(\n" +
         list +
         "  )\n"
         "  if (( CURRENT == 2 )); then\n"
         "    _describe command commands\n"
         "    return\n"
         "  fi\n"
         "  shift words\n"
         "  (( CURRENT-- ))\n"
         "  case $words[1] in\n" +
         cases +
         "  esac\n"
         "}\n"
         "_overbend \"$@\"\n";
}

}  // namespace overbend
