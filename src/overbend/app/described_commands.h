/// The program's own description of its commands, for what is made of it: completion in a shell and the manual page.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace overbend {

enum class Completes { nothing, model, folder, file };

/// An option, or a word that a command takes (then without names).
struct DescribedOption {
  std::vector<std::string> names;    ///< "-o", "--output"; empty: taken by its place.
  std::string text;                  ///< What it is.
  std::string value;                 ///< How its value is called: "TEXT"; empty: it takes none.
  std::vector<std::string> choices;  ///< The values there are; empty: any.
  Completes completes = Completes::nothing;
  bool required = false;
};

struct DescribedCommand {
  std::string name;  ///< Empty: the program itself.
  std::string text;
  std::vector<DescribedOption> options;
};

/// The program first, then its commands in their order.
std::vector<DescribedCommand> described(const CLI::App& program);

std::string bash_completion(const std::vector<DescribedCommand>& commands);
std::string zsh_completion(const std::vector<DescribedCommand>& commands);
/// Section 1, for groff and mandoc.
std::string manual_page(const std::vector<DescribedCommand>& commands, const std::string& version);

}  // namespace overbend
