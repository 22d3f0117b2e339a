/// Messages for errors on the command line: what was found and what was expected.
#pragma once

#include <span>
#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace overbend {

/// Returns a message such as "overbend static: there is no option '--outpt'; did you mean '--output'?". `arguments` are
/// those after the name of the program.
std::string option_error_message(const CLI::App& program, std::span<const char* const> arguments,
                                 const CLI::ParseError& error);

}  // namespace overbend
