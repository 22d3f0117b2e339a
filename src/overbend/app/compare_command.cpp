#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "app/commands.h"
#include "app/compare_gather.h"
#include "app/compare_variants.h"
#include "app/prepared_case.h"
#include "app/side_by_side.h"
#include "report/comparison_page.h"
#include "report/warning_weight.h"
#include "resultfiles/comparison_writer.h"
#include "resultfiles/seeds_writer.h"
#include "runstore/staged_folder.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

int refuse(const std::string& why) {
  std::cerr << "overbend: " << why << "\n";
  return kWrongInput;
}

using Cases = std::vector<std::unique_ptr<PreparedCase>>;

/// Every variant with its equilibrium, in the order of the list. Shorter where one has none: `code` says why.
Cases prepare(const Description& description, const std::vector<Variant>& variants, const std::string& duration,
              ExitCode& code) {
  Cases cases;
  for (const Variant& variant : variants) {
    Description varied = vary(description, variant);
    set_duration(varied, duration);
    cases.push_back(prepare_case(varied, code));
    if (cases.back() == nullptr) {
      cases.pop_back();
      break;
    }
  }
  return cases;
}

void print(const Comparison& comparison) {
  std::cout << fmt::format("  {:<42}", "");
  for (const ComparedRun& run : comparison.runs) std::cout << fmt::format("{:>13}", run.name);
  std::cout << "\n";
  for (std::size_t i = 0; i < comparison.quantities.size(); ++i) {
    const ShownUnit unit = table_unit(comparison.quantities[i]);
    std::cout << fmt::format("  {:<42}", comparison.quantities[i].name);
    for (const ComparedRun& run : comparison.runs) std::cout << fmt::format("{:>13.5g}", run.values[i] * unit.factor);
    std::cout << " " << unit.name << "\n";
  }
  for (const ComparedRun& run : comparison.runs) {
    for (const std::string& warning : run.results.warnings) {
      std::cout << "  warning: " << run.name << ": " << without_mark(warning) << "\n";
    }
  }
}

/// Puts beside each other what came to its end.
int gather(ComparisonOf of, const Description& original, const Cases& cases, const std::vector<SideRun>& runs,
           const fs::path& folder) {
  const std::vector<Variant>& variants = variants_of(of);
  std::vector<FinishedVariant> finished;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].end.code == kDone) {
      finished.push_back({variants[i].name, variants[i].words, runs[i].folder});
    } else {
      std::cerr << "overbend: " << variants[i].name << ": " << runs[i].end.why << "\n";
    }
  }
  if (finished.size() < runs.size()) {
    std::cerr << "overbend: no comparison is written\n";
    return kNoSolution;
  }
  const PreparedCase& first = *cases.front();
  const Comparison comparison = gather_comparison(of, first.description, first.statics, finished);
  StagedFolder staged(folder);
  write_comparison_files(first.statics, comparison, staged.path());
  write_comparison_page(first.statics, comparison, original.source_text, staged.path() / "comparison.html");
  std::vector<std::string> folders;
  for (const SideRun& run : runs) folders.push_back(run.folder.filename().string());
  staged.commit("comparison.json", folders);
  std::cout << first.statics.title << "\n";
  print(comparison);
  std::cout << "The comparison is " << (folder / "comparison.html").string() << "\n";
  return kDone;
}

std::vector<fs::path> variant_folders(ComparisonOf of, const fs::path& folder) {
  std::vector<fs::path> folders;
  for (const Variant& variant : variants_of(of)) folders.push_back(folder / variant.name);
  return folders;
}

/// Runs the cases into folders of their own in `folder`, then puts them beside each other.
int run_all(ComparisonOf of, const Description& original, const Cases& cases, const fs::path& folder,
            const SideOptions& options) {
  const std::vector<fs::path> folders = variant_folders(of, folder);
  std::vector<DynamicCase> shared;
  for (const std::unique_ptr<PreparedCase>& one : cases) shared.push_back(one->shared());
  std::vector<SideRun> runs;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    runs.push_back({&shared[i], dynamic_options(cases[i]->model).seed, folders[i]});
  }
  if (const ExitCode code = run_side_by_side(runs, options, "variants"); code != kDone) return code;
  if (all_wrong(runs, folder)) return kWrongInput;
  return gather(of, original, cases, runs, folder);
}

}  // namespace

int run_compare(const CompareArguments& arguments) {
  const ComparisonOf of = arguments.of == "contact" ? ComparisonOf::contact : ComparisonOf::tensioner;
  std::optional<Description> description = load_model(arguments.model_file);
  if (!description || !set_duration(*description, arguments.duration)) return kWrongInput;
  if (const std::optional<std::string> obstacle = comparison_obstacle(of, *description)) return refuse(*obstacle);
  const fs::path folder = arguments.output.empty()
                              ? fs::path(fs::path(arguments.model_file).stem().string() + ".comparison")
                              : fs::path(arguments.output);
  const std::optional<bool> resume = goes_on(variant_folders(of, folder), arguments.take_up);
  if (!resume) return kWrongInput;
  ExitCode code = kDone;
  Cases cases;
  try {
    cases = prepare(*description, variants_of(of), arguments.duration, code);
  } catch (const std::runtime_error& fault) {  // a text that cannot be varied
    return refuse(fault.what());
  }
  if (code != kDone) return code;
  return run_all(of, *description, cases, folder, {*resume, arguments.checkpoint_every, arguments.threads});
}

}  // namespace overbend
