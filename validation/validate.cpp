/// Holds the engine against known answers.
///
///     overbend_validate                 prints docs/validation.md
///     overbend_validate --check         prints what is outside its tolerance; fails if anything is
///     overbend_validate --compare FILE  fails if the page in FILE no longer says what is computed
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <string>

#include "groups.h"

namespace overbend::validation {
namespace {

int complain(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    std::fprintf(stderr, "%s\n", line.c_str());
  }
  return lines.empty() ? 0 : 1;
}

int run(const std::string& mode, const std::string& file) {
  const std::vector<Group> groups{static_cases(),   field_lays(), cantilevers(), beams(),       roller_deck(),
                                  bgl1_example(),   jlays(),      code_checks(), dynamic(),     lines(),
                                  lay_operations(), lifts(),      pulls(),       uneven_beds(), stingers(),
                                  fatigue(),        convergence()};
  if (mode == "--check") {
    return complain(failures(groups));
  }
  if (mode == "--compare") {
    std::ifstream stream(file, std::ios::binary);
    return complain(
        stale_lines({std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()}, page(groups)));
  }
  std::fputs(page(groups).c_str(), stdout);
  return 0;
}

}  // namespace
}  // namespace overbend::validation

int main(int argc, char** argv) {
  try {
    return overbend::validation::run(argc > 1 ? argv[1] : "", argc > 2 ? argv[2] : "");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
