#include <fmt/format.h>

#include <iostream>
#include <stdexcept>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/print_findings.h"
#include "app/study_progress.h"
#include "base/finding.h"
#include "resultfiles/studies/seeds_writer.h"
#include "study/seeds/compare_variants.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

void print(const StaticResults& statics, const Comparison& comparison) {
  std::cout << fmt::format("  {:<42}", "");
  for (const ComparedRun& run : comparison.runs) std::cout << fmt::format("{:>13}", run.name);
  std::cout << "\n";
  for (std::size_t i = 0; i < comparison.quantities.size(); ++i) {
    const ShownUnit unit = table_unit(comparison.quantities[i]);
    std::cout << fmt::format("  {:<42}", comparison.quantities[i].name);
    for (const ComparedRun& run : comparison.runs) std::cout << fmt::format("{:>13.5g}", run.values[i] * unit.factor);
    std::cout << " " << unit.name << "\n";
  }
  std::vector<Findings> findings;
  for (const ComparedRun& run : comparison.runs) findings.push_back(run.results.findings);
  std::cout << shared_finding_lines(findings, "variants") << finding_lines(statics.findings);
}

}  // namespace

int run_compare(const CompareArguments& arguments) {
  std::error_code ignored;
  const bool folders = !arguments.others.empty() || fs::is_directory(arguments.model_file, ignored) ||
                       fs::path(arguments.model_file).extension() == ".h5";
  if (folders && !arguments.of.empty()) {
    return report_status(
        {RunStatus::wrong_input, "--of applies to a model file; omit it to compare folders of results"});
  }
  if (folders) {
    std::vector<std::string> places = {arguments.model_file};
    places.insert(places.end(), arguments.others.begin(), arguments.others.end());
    return run_compare_folders(places, arguments.output);
  }
  if (arguments.of.empty()) {
    return report_status(
        {RunStatus::wrong_input,
         "compare: found only a model file, expected it with --of tensioner, contact or impacts, or two or "
         "more folders of results"});
  }
  const std::optional<Description> description = load_model(arguments.model_file);
  if (!description) return kWrongInput;
  std::variant<StudyPlan, std::string> planned;
  try {
    planned = plan_comparison(from_enum_name<ComparisonType>(arguments.of).value(), *description,
                              parse_duration_option(arguments.duration));
  } catch (const std::invalid_argument& error) {
    planned = error.what();
  }
  if (const auto* error = std::get_if<std::string>(&planned)) return report_status({RunStatus::wrong_input, *error});
  const StudyPlan& plan = std::get<StudyPlan>(planned);
  const fs::path folder = arguments.output.empty()
                              ? fs::path(fs::path(arguments.model_file).stem().string() + ".comparison")
                              : fs::path(arguments.output);
  const std::vector<std::string> results = {"comparison.html", "comparison.csv", "comparison.json"};
  if (const std::optional<RunResult> lost = find_output_conflict(arguments.model_file, folder, results)) {
    return report_status(*lost);
  }
  const std::optional<bool> resume = resume_requested(case_folders(plan, folder), arguments.resume_option);
  if (!resume) return kWrongInput;
  const StudyOutcome end =
      follow_study(*description, plan, folder, {*resume, arguments.checkpoint_every, arguments.threads}, "variants");
  for (const FailedCase& failed : end.failed) std::cerr << "overbend: " << failed.name << ": " << failed.why << "\n";
  if (!end.comparison) return report_status(end);
  std::cout << end.statics.title << "\n";
  print(end.statics, *end.comparison);
  std::cout << "The comparison is " << (folder / "comparison.html").string() << "\n";
  return kDone;
}

}  // namespace overbend
