#include "app/described_commands.h"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace overbend {
namespace {

/// Returns the accepted values. CLI11 keeps them only in the name of the type: "TEXT:{s,j}".
std::vector<std::string> find_choices(const std::string& type) {
  const std::size_t open = type.find('{');
  const std::size_t close = type.find('}', open == std::string::npos ? 0 : open);
  if (open == std::string::npos || close == std::string::npos) return {};
  return CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
}

Completes find_completion(const CLI::Option& option, const std::string& command) {
  const std::string& name = option.get_single_name();
  if (name == "MODEL") return Completes::model;
  if (name == "RESULTS" || name == "folder") return Completes::folder;
  if (name == "output") return command == "new" ? Completes::file : Completes::folder;
  return Completes::nothing;
}

DescribedOption described(const CLI::Option& option, const std::string& command) {
  DescribedOption out;
  out.text = option.get_description();
  out.required = option.get_required();
  out.completes = find_completion(option, command);
  for (const std::string& name : option.get_snames()) out.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) out.names.push_back("--" + name);
  const std::string type = option.get_type_name();
  if (option.get_items_expected_max() > 0) {
    out.value = option.nonpositional() ? type.substr(0, type.find_first_of(": ")) : option.get_single_name();
    if (out.value.empty()) out.value = "VALUE";
    out.choices = find_choices(type);
  }
  return out;
}

DescribedCommand described(const CLI::App& app, const std::string& name) {
  DescribedCommand out{name, app.get_description(), {}};
  for (const CLI::Option* option : app.get_options()) out.options.push_back(described(*option, name));
  return out;
}

}  // namespace

std::vector<DescribedCommand> described(const CLI::App& program) {
  std::vector<DescribedCommand> all = {described(program, "")};
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    all.push_back(described(*command, command->get_name()));
  }
  return all;
}

}  // namespace overbend
