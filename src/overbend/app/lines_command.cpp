#include "app/lines_command.h"

#include <fmt/format.h>

#include <iostream>
#include <stdexcept>

#include "app/exit_code.h"
#include "app/warning_lines.h"
#include "runstore/staged_folder.h"
#include "study/lines_run.h"
#include "study/prepared_case.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

void print_line(const LineResult& line, bool moved) {
  std::cout << fmt::format("  {}: {:.2f} m, {} elements, {:.1f} m on the bed\n", line.name, line.length, line.elements,
                           line.on_bed);
  for (const auto& [name, end] : {std::pair{"first end", &line.first}, {"second end", &line.second}}) {
    std::cout << fmt::format("    {:<26}{:>12.2f} kN", name, end->tension / 1e3);
    if (moved) std::cout << fmt::format(", {:.2f} to {:.2f} kN", end->in_time.min / 1e3, end->in_time.max / 1e3);
    std::cout << "\n";
  }
  if (line.utilisation) std::cout << fmt::format("    {:<26}{:>12.3f}\n", "of the breaking load", *line.utilisation);
}

int finish(const LinesOutcome& outcome, const Description& description, const fs::path& folder) {
  if (outcome.failure) return tell(failed_end(*outcome.failure));
  const LinesResults& results = *outcome.results;
  try {
    write_lines_run(results, description, folder);
  } catch (const UnusableFolder& fault) {  // a folder that cannot be is the user's to mend
    return tell({RunEnding::wrong_input, fault.what()});
  }
  std::cout << results.title << "\n";
  for (const LineResult& line : results.lines) print_line(line, results.moved);
  std::cout << warning_lines(results.warnings) << "Results are in " << folder.string() << "\n";
  return kDone;
}

}  // namespace

int run_static_lines(const Description& description, const fs::path& folder) {
  return finish(solve_lines(build_model(description)), description, folder);
}

int run_dynamic_lines(const Description& description, std::optional<double> duration, const fs::path& folder) {
  if (!description.dynamics) {
    return tell({RunEnding::wrong_input, "the model has no analysis.dynamic, which says for how long it is to run"});
  }
  const Model model = build_model(description);
  DynamicOptions options = dynamic_options(model);
  options.duration = duration.value_or(options.duration);
  try {
    return finish(run_lines(model, options), description, folder);
  } catch (const std::invalid_argument& fault) {  // a sea or a motion that cannot be made
    return tell({RunEnding::wrong_input, fault.what()});
  }
}

}  // namespace overbend
