/// What is wrong with the words of a command line: one message that says what was found and what was expected.
#pragma once

#include <span>
#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace overbend {

/// "overbend static: there is no option '--outpt'; did you mean '--output'?" `words`: those behind the program's name.
std::string option_fault(const CLI::App& program, std::span<const char* const> words, const CLI::ParseError& fault);

}  // namespace overbend
