#include "app/option_faults.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <vector>

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

/// "MODEL", the words that are taken by their place; "no words" where there are none.
std::string expected_words(const CLI::App& command) {
  std::vector<std::string> words;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional()) words.push_back(option->get_single_name());
  }
  return words.empty() ? "no words" : "only " + join_words(words, "and");
}

std::string unknown_option(const std::string& word, const CLI::App& command) {
  const std::string name = word.substr(0, word.find('='));
  const std::vector<std::string> names = option_names(command);
  const std::string near = name.size() > 2 ? nearest_word(name, names) : "";  // one letter is near to every other
  return fmt::format("there is no option '{}'; {}", for_display(name),
                     near.empty() ? "the options are " + join_words(names, "and") : "did you mean '" + near + "'?");
}

/// Words that no option has taken: a misspelt option before all others, for it may have cost another word its place.
std::optional<std::string> left_over(const CLI::App& command) {
  const std::vector<std::string> words = command.remaining(true);
  const auto option = std::ranges::find_if(words, is_option);
  if (option != words.end()) return unknown_option(*option, command);
  if (words.empty()) return std::nullopt;
  return fmt::format("found '{}', expected {}", for_display(words.front()), expected_words(command));
}

/// "--strict=maybe"
std::optional<std::string> value_of_a_switch(const CLI::App& command, std::span<const char* const> words) {
  for (const std::string word : words) {
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
    for (const CLI::Option* other : option->get_excludes()) {
      if (option->count() == 0 || other->count() == 0) continue;
      return fmt::format("found {} and {}, expected one of the two", option->get_name(), other->get_name());
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

/// The option that a message of the library begins with: "--stage: ...".
const CLI::Option* named(const CLI::App& command, const std::string& text) {
  return command.get_option_no_throw(text.substr(0, text.find(':')));
}

std::string number_of_values(const CLI::App& command, const std::string& text) {
  const CLI::Option* option = named(command, text);
  if (!option) return "an option lacks its value";
  if (option->count() > 1) {
    return fmt::format("{}: found it {} times, expected it once", option->get_name(), option->count());
  }
  return fmt::format("{}: the value is missing, expected: {}", option->get_name(), option->get_description());
}

std::string fault_within(const CLI::App& command, std::span<const char* const> words, const CLI::ParseError& fault) {
  if (const auto left = left_over(command)) return *left;
  if (const auto value = value_of_a_switch(command, words)) return *value;
  if (dynamic_cast<const CLI::ValidationError*>(&fault)) return fault.what();  // a sentence of option_checks.h
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&fault)) return number_of_values(command, fault.what());
  if (const auto both = exclude_each_other(command)) return *both;
  if (const auto lacks = missing(command)) return *lacks;
  return "the options cannot be read; 'overbend " + command.get_name() + " --help' lists them";
}

}  // namespace

std::string option_fault(const CLI::App& program, std::span<const char* const> words, const CLI::ParseError& fault) {
  const std::string commands = "the commands are " + join_words(command_names(program), "and");
  const std::vector<CLI::App*> given = program.get_subcommands();
  const std::vector<std::string> before = program.remaining(false);
  const auto stray = std::ranges::find_if(before, is_option);
  if (stray != before.end() && !given.empty()) {
    return fmt::format("overbend: found '{}' before the command '{}', expected options behind it", for_display(*stray),
                       given.front()->get_name());
  }
  if (stray != before.end()) return fmt::format("overbend: {}; {}", unknown_option(*stray, program), commands);
  if (given.empty()) return "overbend: the command is missing; " + commands;
  return fmt::format("overbend {}: {}", given.front()->get_name(), fault_within(*given.front(), words, fault));
}

}  // namespace overbend
