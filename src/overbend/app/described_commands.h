/// Description of the commands, from which shell completion and the manual page are made.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace overbend {

enum class Completes { nothing, model, folder, file };

/// An option, or a positional argument (then without names).
struct DescribedOption {
  std::vector<std::string> names;    ///< "-o", "--output"; empty: positional argument.
  std::string text;                  ///< Description.
  std::string value;                 ///< Placeholder of its value, such as "TEXT"; empty: no value.
  std::vector<std::string> choices;  ///< Accepted values; empty: any.
  Completes completes = Completes::nothing;
  bool required = false;
};

struct DescribedCommand {
  std::string name;  ///< Empty: the program itself.
  std::string text;
  std::vector<DescribedOption> options;
};

/// Returns the program, then its commands in order.
std::vector<DescribedCommand> described(const CLI::App& program);

/// Returns a completion script.
std::string bash_completion(const std::vector<DescribedCommand>& commands);
std::string zsh_completion(const std::vector<DescribedCommand>& commands);
/// Returns the manual page (section 1) for groff and mandoc.
std::string manual_page(const std::vector<DescribedCommand>& commands, const std::string& version);

}  // namespace overbend
