#include <fmt/format.h>

#include <iostream>

#include "app/check_lines.h"
#include "app/commands.h"
#include "app/exit_code.h"
#include "app/finding_lines.h"
#include "app/friction_lines.h"
#include "app/lines_command.h"
#include "app/mooring_lines.h"
#include "app/operation_command.h"
#include "app/sensitivity_lines.h"
#include "app/stinger_lines.h"
#include "base/finding.h"
#include "base/shown_unit.h"
#include "report/page/places.h"
#include "runstore/staged_folder.h"
#include "statics/moored/moored_lay.h"
#include "statics/moored/moored_statics.h"
#include "statics/solver/statics.h"
#include "study/run/input_findings.h"
#include "study/run/lines_run.h"
#include "study/run/mooring_run.h"
#include "study/run/prepared_case.h"
#include "study/run/static_run.h"
#include "study/sensitivity/sensitivities.h"
#include "study/stages/stage_choice.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

void line(const std::string& name, const std::string& value) {
  std::cout << fmt::format("  {:<28}{}\n", name, value);
}

void number(const std::string& name, double value, const char* si, int digits = 2) {
  line(name, fmt::format("{:>12} {}", shown_number(value, si, digits), shown_name(si)));
}

void print_region(const char* name, const StaticResults& r, const RegionResult& region) {
  const auto stress = [&](const Extreme& extreme) {
    return fmt::format("{:>12} {}, {} from the tensioner", shown_number(extreme.value, "Pa", 2), shown_name("Pa"),
                       shown(from_tensioner(r, extreme.s), "m", 1));
  };
  line(fmt::format("{} bending stress", name), stress(region.bending_stress));
  line(fmt::format("{} von Mises stress", name), stress(region.von_mises));
}

void print_laid_pipe(const BedResults& bed) {
  const auto moment = [&](double value, double x) {
    return fmt::format("{:>12} {}, {} astern of the stern shoe", shown_number(value, "N m", 1), shown_name("N m"),
                       shown(x, "m", 1));
  };
  number("tension at the far end", bed.tail_tension, "N");
  line("laid pipe, hogging moment", moment(bed.hogging_moment, bed.hogging_x));
  line("laid pipe, sagging moment", moment(bed.sagging_moment, bed.sagging_x));
  for (const FreeSpanResult& span : bed.spans) {
    line("free span", fmt::format("{:>12} {}, {} to {} astern of the stern shoe, gap {}",
                                  shown_number(span.length, "m", 2), shown_name("m"), shown_number(span.x_from, "m", 1),
                                  shown(span.x_to, "m", 1), shown(span.largest_gap, "m", 3)));
  }
}

void print_results(const StaticResults& r) {
  std::cout << r.title << "\n";
  number("top tension", r.top_tension, "N");
  number("horizontal tension", r.bottom_tension, "N");
  number("lay-back", r.lay_back, "m");
  number("suspended length", r.suspended_length, "m");
  number("departure angle", r.departure_angle, "rad");
  if (r.overbend) print_region("overbend", r, *r.overbend);
  if (r.tower) print_region("tower", r, *r.tower);
  print_region("sagbend", r, r.sagbend);
  if (r.bed) print_laid_pipe(*r.bed);
  if (r.residual_curvature > 0.0) {
    line("residual curvature",
         fmt::format("{:>12} {}, at touchdown", shown_number(r.residual_curvature, "1/m", 5), shown_name("1/m")));
  }
  if (r.stinger_tip_clearance) number("stinger tip clearance", *r.stinger_tip_clearance, "m", 3);
  if (r.stinger_fitted_radius) number("stinger radius, fitted", *r.stinger_fitted_radius, "m");
  if (!r.supports.empty()) {
    line("largest roller reaction", fmt::format("{:>12} {} at {}", shown_number(r.largest_reaction, "N", 2),
                                                shown_name("N"), r.largest_reaction_support));
  }
  std::cout << stinger_lines(r);
  std::cout << friction_lines(r);
  if (r.moorings) std::cout << moored_state_lines(*r.moorings);
  if (r.hull) std::cout << hull_lines(*r.hull);
  std::cout << check_lines(r.checks);
  line("balance of forces",
       fmt::format("{:>12.1e} of the weight at a node, {:.1e} as a whole", r.force_residual, r.global_residual));
  line("solver", fmt::format("{:>12.3f} s, {} iterations, {}", r.solve.wall_time, r.solve.iterations, r.solve.method));
  std::cout << verdict_line(r.checks, r.findings) << finding_lines(r.findings);
}

fs::path default_folder(const std::string& model_file) {
  return fs::path(model_file).stem().string() + ".results";
}

/// A failure with what the numbers of the model are warned of: the culprit is often among it.
int tell_failure(const StaticFailure& failure, const Model& model) {
  const int code = tell(failed_end(failure, model.description));
  Findings findings = input_findings(model);
  std::erase_if(findings, [](const Finding& finding) {
    return finding.severity() != FindingSeverity::serious && finding.code != FindingCode::unusual_input;
  });
  std::cerr << finding_lines(findings);
  return code;
}

/// A hull and its mooring lines, without a pipe.
int run_static_moorings(const Description& description, Model& model, const fs::path& folder) {
  LayOutcome outcome = solve_moored_hull(model);
  if (outcome.failure) return tell_failure(*outcome.failure, model);
  MooringResults& results = *outcome.moorings;
  tell_hull(model, results);
  try {
    write_mooring_run(results, description, folder);
  } catch (const UnusableFolder& fault) {
    return tell({RunEnding::wrong_input, fault.what()});
  }
  std::cout << mooring_lines(results) << "Results are in " << folder.string() << "\n";
  return kDone;
}

}  // namespace

int run_static(const StaticArguments& arguments) {
  std::optional<Description> description = load_model(arguments.model_file);
  if (!description) return kWrongInput;
  const fs::path folder = arguments.output.empty() ? default_folder(arguments.model_file) : fs::path(arguments.output);
  if (const std::optional<RunEnd> lost = files_in_the_way(arguments.model_file, folder)) return tell(*lost);
  if (!arguments.stage.empty()) {
    std::variant<Description, RunEnd> chosen = choose_stage(*description, arguments.stage);
    if (const RunEnd* fault = std::get_if<RunEnd>(&chosen)) return tell(*fault);
    description = std::get<Description>(std::move(chosen));
  } else if (is_lay_operation(description->operation.type)) {
    return run_static_operation(*description, folder, arguments.strict);
  }
  if (is_lines_alone(*description)) return run_static_lines(*description, folder);
  Model model = build_model(*description);
  if (is_moored_hull(*description)) return run_static_moorings(*description, model, folder);
  const LayOutcome outcome = solve_lay(model);
  if (outcome.failure) return tell_failure(*outcome.failure, model);
  StaticResults results = checked_statics(model, outcome);
  tell_friction(model, outcome, results);
  tell_hull(model, results);
  std::optional<SensitivityResults> sensitivities;
  if (arguments.sensitivities) {
    sensitivities = find_sensitivities(model, *outcome.solution);
    if (!sensitivities) results.findings.push_back({FindingCode::sensitivities_missing, kNoSensitivities});
  }
  try {
    write_static_run(results, *description, folder, sensitivities ? &*sensitivities : nullptr);
  } catch (const UnusableFolder& fault) {  // a folder that cannot be is the user's to mend
    return tell({RunEnding::wrong_input, fault.what()});
  }
  print_results(results);
  if (sensitivities) std::cout << sensitivity_lines(*sensitivities);
  std::cout << "Results are in " << folder.string() << "\n";
  return strict_code(results.checks, results.findings, arguments.strict);
}

}  // namespace overbend
