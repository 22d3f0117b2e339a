#include <fmt/format.h>

#include "app/described_commands.h"

namespace overbend {
namespace {

/// Escapes text for roff.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else if (c == '\'') {
      out += "\\(aq";
    } else {
      out += c;
    }
  }
  return !out.empty() && out[0] == '.' ? "\\&" + out : out;
}

std::string option_head(const DescribedOption& option) {
  std::string names;
  for (const std::string& name : option.names) names += (names.empty() ? "" : ", ") + ("\\fB" + roff(name) + "\\fR");
  if (option.value.empty()) return names;
  return names + (names.empty() ? "" : " ") + "\\fI" + roff(option.value) + "\\fR";
}

std::string option_text(const DescribedOption& option) {
  std::string text = roff(option.text);
  if (!option.choices.empty()) {
    text += " (one of";
    for (const std::string& choice : option.choices) {
      text += (choice == option.choices.front() ? " " : ", ") + roff(choice);
    }
    text += ")";
  }
  return text;
}

std::string synopsis(const DescribedCommand& command) {
  std::string line = "overbend " + roff(command.name);
  for (const DescribedOption& option : command.options) {
    if (option.names.empty()) {
      line += option.required ? " \\fI" + option.value + "\\fR" : " [\\fI" + option.value + "\\fR]";
    }
  }
  return line + " [options]";
}

std::string option_entries(const DescribedCommand& command) {
  std::string out;
  for (const DescribedOption& option : command.options) {
    out += ".TP\n" + option_head(option) + "\n" + option_text(option) + "\n";
  }
  return out;
}

constexpr const char* kExit =
    ".SH EXIT STATUS\n"
    ".TP\n0\nDone.\n"
    ".TP\n1\nAn error of the program or of the machine.\n"
    ".TP\n2\nThe model file or the command line is wrong; what, and what is expected, is on standard error.\n"
    ".TP\n3\nNo solution was found; what, where and why is on standard error.\n"
    ".TP\n4\nWith \\fB\\-\\-strict\\fR: a code check is exceeded. The results are still written.\n"
    ".TP\n130\nInterrupted; \\fB\\-\\-resume\\fR continues from the last checkpoint.\n";

constexpr const char* kExamples =
    ".SH EXAMPLES\n"
    ".nf\n"
    "overbend new \\-\\-pipe 16 \\-\\-depth \\(aq89 m\\(aq \\-o lay.yaml\n"
    "overbend static lay.yaml \\-o results\n"
    "overbend dynamic lay.yaml \\-\\-duration \\(aq3 h\\(aq \\-o storm\n"
    ".fi\n";

}  // namespace

std::string manual_page(const std::vector<DescribedCommand>& commands, const std::string& version) {
  std::string lines, details;
  for (const DescribedCommand& command : commands) {
    if (command.name.empty()) continue;
    lines += (lines.empty() ? "" : ".br\n") + synopsis(command) + "\n";
    details += ".SS " + roff(command.name) + "\n" + roff(command.text) + "\n" + option_entries(command);
  }
  return fmt::format(
      ".\\\" Made by `overbend completion man`.\n"
      ".TH OVERBEND 1 \"\" \"overbend {}\" \"User commands\"\n"
      ".SH NAME\noverbend \\- analysis of offshore pipeline installation\n"
      ".SH SYNOPSIS\n{}"
      ".SH DESCRIPTION\n"
      "Static and dynamic analysis of a pipe between lay vessel and seabed, from a model file in YAML. The keys of "
      "that file: \\fBoverbend schema \\-\\-reference\\fR.\n"
      ".SH OPTIONS\n{}.SH COMMANDS\n{}{}{}",
      roff(version), lines, option_entries(commands.front()), details, kExit, kExamples);
}

}  // namespace overbend
