#include "app/new_questions.h"

#include <istream>
#include <ostream>

namespace overbend {
namespace {

std::string trimmed(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  return first == std::string::npos ? "" : line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
}

/// Asks one question. `offered` describes the default; an empty answer gives `otherwise`.
void ask(const char* question, const std::string& offered, std::string& answer, const std::string& otherwise,
         std::istream& in, std::ostream& out) {
  if (!answer.empty()) return;
  out << question << " [" << offered << "]: " << std::flush;
  std::string line;
  std::getline(in, line);
  const std::string said = trimmed(line);
  answer = said.empty() ? otherwise : said;
}

}  // namespace

void ask_new_options(NewOptions& options, std::istream& in, std::ostream& out) {
  ask("Nominal pipe size in inches, or outside diameter with its unit", kDefaultPipe, options.pipe, kDefaultPipe, in,
      out);
  ask("Water depth with its unit", kUsualDepth, options.depth, kUsualDepth, in, out);
  ask("Wall thickness with its unit", "chosen for pressure and bending", options.wall, "", in, out);
  ask("Thickness of a concrete coating", "none", options.concrete, "", in, out);
  ask("Tension with its unit", "chosen for the sagbend", options.tension, "", in, out);
  ask("File to write", "the terminal", options.output, "", in, out);
}

}  // namespace overbend
