#include <fmt/format.h>

#include <iostream>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/operation_command.h"
#include "app/print_checks.h"
#include "app/print_findings.h"
#include "app/print_friction.h"
#include "app/print_lines_and_bodies.h"
#include "app/print_moorings.h"
#include "app/print_sensitivities.h"
#include "app/print_stinger.h"
#include "base/finding.h"
#include "base/shown_unit.h"
#include "results/fields/location_names.h"
#include "runstore/staged_folder.h"
#include "statics/solver/unsupported_statics.h"
#include "study/run/input_findings.h"
#include "study/run/prepared_case.h"
#include "study/run/static_analysis.h"
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
  number("tension at the anchor", bed.tail_tension, "N");
  line("laid pipe, hogging moment", moment(bed.hogging_moment, bed.hogging_x));
  line("laid pipe, sagging moment", moment(bed.sagging_moment, bed.sagging_x));
  for (const FreeSpanResult& span : bed.spans) {
    line("free span", fmt::format("{:>12} {}, {} to {} astern of the stern shoe, gap {}",
                                  shown_number(span.length, "m", 2), shown_name("m"), shown_number(span.x_from, "m", 1),
                                  shown(span.x_to, "m", 1), shown(span.max_gap, "m", 3)));
  }
}

void print_pipe(const StaticResults& r) {
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
    line("max. roller reaction",
         fmt::format("{:>12} {} at {}", shown_number(r.max_reaction, "N", 2), shown_name("N"), r.max_reaction_support));
  }
  std::cout << attachment_lines(r) << stinger_lines(r);
  std::cout << friction_lines(r);
}

void print_solver(const StaticResults& r) {
  line("balance of forces",
       fmt::format("{:>12.1e} of the weight at a node, {:.1e} globally", r.force_residual, r.global_residual));
  line("solver", fmt::format("{:>12.3f} s, {} iterations, {}", r.solve.wall_time, r.solve.iterations, r.solve.method));
}

void print_results(const StaticResults& r) {
  std::cout << r.title << "\n";
  if (r.has_pipe()) print_pipe(r);
  if (r.moorings) std::cout << moored_state_lines(*r.moorings);
  if (r.hull) std::cout << hull_lines(*r.hull);
  std::cout << (r.has_pipe() ? "" : lines_at_rest_text(r.lines)) << bodies_at_rest(r.bodies) << check_lines(r.checks);
  if (r.has_pipe()) print_solver(r);
  std::cout << verdict_line(make_verdict(r.checks, r.findings)) << finding_lines(r.findings);
}

fs::path default_folder(const std::string& model_file) {
  return fs::path(model_file).stem().string() + ".results";
}

/// Reports a failure together with warnings about the input, which often explain it.
int report_failure(const StaticFailure& failure, const Model& model) {
  const int code = report_status(failure_result(failure, model.description));
  Findings findings = input_findings(model);
  std::erase_if(findings, [](const Finding& finding) {
    return finding.severity() != FindingSeverity::serious && finding.code != FindingCode::unusual_input;
  });
  std::cerr << finding_lines(findings);
  return code;
}

/// Returns an error if sensitivities are requested but unsupported for this model.
std::optional<RunResult> find_sensitivities_error(const StaticArguments& arguments, const Description& description) {
  if (!arguments.sensitivities) return std::nullopt;
  if (description.operation.type == OperationType::lift) {
    return RunResult{RunStatus::wrong_input,
                     "--sensitivities: the stages of a lift are not supported; use a study over the lengths to get "
                     "differences"};
  }
  if (is_lay_operation(description.operation.type) && arguments.stage.empty()) {
    return RunResult{RunStatus::wrong_input,
                     "--sensitivities: sensitivities are computed for a single stage; select it with --stage"};
  }
  if (const auto unsupported = missing_pipe_message(description, "sensitivities")) {
    return RunResult{RunStatus::wrong_input, "--sensitivities: " + *unsupported};
  }
  return std::nullopt;
}

}  // namespace

int run_static(const StaticArguments& arguments) {
  std::optional<Description> description = load_model(arguments.model_file);
  if (!description) return kWrongInput;
  const fs::path folder = arguments.output.empty() ? default_folder(arguments.model_file) : fs::path(arguments.output);
  if (const std::optional<RunResult> lost = find_output_conflict(arguments.model_file, folder)) {
    return report_status(*lost);
  }
  if (const std::optional<RunResult> no = find_sensitivities_error(arguments, *description)) return report_status(*no);
  if (!arguments.stage.empty()) {
    std::variant<Description, RunResult> chosen = choose_stage(*description, arguments.stage);
    if (const RunResult* error = std::get_if<RunResult>(&chosen)) return report_status(*error);
    description = std::get<Description>(std::move(chosen));
  } else if (is_lay_operation(description->operation.type)) {
    return run_static_operation(*description, folder, arguments.strict);
  }
  Model model = build_model(*description);
  const StaticRun run = run_statics(model);
  if (run.failure) return report_failure(*run.failure, model);
  StaticResults results = *run.results;
  add_roller_friction_limits(model, *run.solution, results);
  add_hull_results(model, results);
  std::optional<SensitivityResults> sensitivities;
  if (arguments.sensitivities) {
    sensitivities = find_sensitivities(model, *run.solution);
    if (!sensitivities) results.findings.push_back({FindingCode::sensitivities_missing, kNoSensitivities});
  }
  try {
    write_static_run(results, *description, folder, sensitivities ? &*sensitivities : nullptr);
  } catch (const UnusableFolder& error) {  // error of the user: the folder cannot be used
    return report_status({RunStatus::wrong_input, error.what()});
  }
  print_results(results);
  if (sensitivities) std::cout << sensitivity_lines(*sensitivities);
  std::cout << "Results are in " << folder.string() << "\n";
  return strict_code(results.checks, results.findings, arguments.strict);
}

}  // namespace overbend
