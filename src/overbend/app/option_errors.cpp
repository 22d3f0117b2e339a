#include "app/option_errors.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <vector>

#include "base/ranges.h"
#include "base/text.h"

namespace overbend {
namespace {

bool is_option(const std::string& word) {
  return word.size() > 1 && word.front() == '-';
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::vector<std::string> command_names(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  return names;
}

/// Returns the names of the positional arguments, such as "only MODEL".
std::string expected_positionals(const CLI::App& command) {
  std::vector<std::string> positionals;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional()) positionals.push_back(option->get_single_name());
  }
  return positionals.empty() ? "no positional argument" : "only " + join_items(positionals, "and");
}

std::string unknown_option(const std::string& word, const CLI::App& command) {
  const std::string name = word.substr(0, word.find('='));
  const std::vector<std::string> names = option_names(command);
  const std::string near = name.size() > 2 ? nearest_word(name, names) : "";  // a single letter resembles every other
  return fmt::format("there is no option '{}'; {}", for_display(name),
                     near.empty() ? "the options are " + join_items(names, "and") : "did you mean '" + near + "'?");
}

/// Reports arguments that no option has taken: a misspelt option first, since it may have displaced another argument.
std::optional<std::string> find_extra_argument(const CLI::App& command) {
  const std::vector<std::string> extras = command.remaining(true);
  const auto option = ranges::find_if(extras, is_option);
  if (option != extras.end()) return unknown_option(*option, command);
  if (extras.empty()) return std::nullopt;
  return fmt::format("found '{}', expected {}", for_display(extras.front()), expected_positionals(command));
}

/// Reports a value given to a flag, such as "--strict=maybe".
std::optional<std::string> find_value_of_flag(const CLI::App& command, std::span<const char* const> arguments) {
  for (const std::string word : arguments) {
    const std::size_t sign = word.find('=');
    if (!word.starts_with("--") || sign == std::string::npos) continue;
    const CLI::Option* option = command.get_option_no_throw(word.substr(0, sign));
    if (!option || option->get_items_expected_max() > 0) continue;
    return fmt::format("{}: found '{}', expected no value", word.substr(0, sign), for_display(word.substr(sign + 1)));
  }
  return std::nullopt;
}

std::optional<std::string> exclude_each_other(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    for (const CLI::Option* excluded : option->get_excludes()) {
      if (option->count() == 0 || excluded->count() == 0) continue;
      return fmt::format("found {} and {}, expected one of the two", option->get_name(), excluded->get_name());
    }
  }
  return std::nullopt;
}

std::optional<std::string> missing(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_required() || option->count() > 0) continue;
    return fmt::format("{} is missing, expected: {}", option->get_single_name(), option->get_description());
  }
  return std::nullopt;
}

/// Returns the option named at the start of a message of CLI11: "--stage: ...".
const CLI::Option* named(const CLI::App& command, const std::string& text) {
  return command.get_option_no_throw(text.substr(0, text.find(':')));
}

std::string number_of_values(const CLI::App& command, const std::string& text) {
  const CLI::Option* option = named(command, text);
  if (!option) return "the value of an option is missing";
  if (option->count() > 1) {
    return fmt::format("{}: found it {} times, expected it once", option->get_name(), option->count());
  }
  return fmt::format("{}: the value is missing, expected: {}", option->get_name(), option->get_description());
}

std::string command_error_message(const CLI::App& command, std::span<const char* const> arguments,
                                  const CLI::ParseError& error) {
  if (const auto left = find_extra_argument(command)) return *left;
  if (const auto value = find_value_of_flag(command, arguments)) return *value;
  if (dynamic_cast<const CLI::ValidationError*>(&error)) return error.what();  // message of option_checks.h
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) return number_of_values(command, error.what());
  if (const auto both = exclude_each_other(command)) return *both;
  if (const auto lacks = missing(command)) return *lacks;
  return "the options cannot be read; 'overbend " + command.get_name() + " --help' lists them";
}

}  // namespace

std::string option_error_message(const CLI::App& program, std::span<const char* const> arguments,
                                 const CLI::ParseError& error) {
  const std::string commands = "the commands are " + join_items(command_names(program), "and");
  const std::vector<CLI::App*> subcommands = program.get_subcommands();
  const std::vector<std::string> before = program.remaining(false);
  const auto stray = ranges::find_if(before, is_option);
  if (stray != before.end() && !subcommands.empty()) {
    return fmt::format("overbend: found '{}' before the command '{}', expected options after it", for_display(*stray),
                       subcommands.front()->get_name());
  }
  if (stray != before.end()) return fmt::format("overbend: {}; {}", unknown_option(*stray, program), commands);
  if (subcommands.empty()) return "overbend: the command is missing; " + commands;
  return fmt::format("overbend {}: {}", subcommands.front()->get_name(),
                     command_error_message(*subcommands.front(), arguments, error));
}

}  // namespace overbend
