#include "study/goal_seek/seek_run.h"

#include "base/interruption.h"
#include "model/description/seek_operations.h"
#include "modelfile/reading/yaml_reader.h"
#include "modelfile/yaml/moved_text.h"
#include "report/report.h"
#include "report/stages/operation_report.h"
#include "report/studies/seek_section.h"
#include "resultfiles/stages/operation_writer.h"
#include "resultfiles/static/results_writer.h"
#include "resultfiles/studies/seek_writer.h"
#include "results/findings.h"
#include "runstore/append_file.h"
#include "runstore/staged_folder.h"
#include "study/run/prepared_case.h"
#include "study/stages/lay_operation.h"
#include "study/stages/stage_choice.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

Description with_answer(const Description& description, const SeekDescription& wanted, const SeekResults& results) {
  const std::string text = edit_yaml(description.source_text, answer_changes(description, wanted, results));
  ModelReading reading = read_model_text(text, description.source_file);
  if (!reading.description) {
    throw SeekError("the model with the answer: " + reading.diagnostics.lines(Severity::error).front());
  }
  return std::move(*reading.description);
}

/// Solves all stages of the written lift or pull. The search took the same steps.
void solve_stages(SeekRun& run) {
  run.operation = solve_operation(run.answer);
  run.results.stages = stage_lines(run.answer, run.results.unknowns);
}

/// Solves the statics of the written model; these are reported.
void solve_answer(SeekRun& run, const std::optional<StaticSolution>& start) {
  Model model = build_model(run.answer);
  run.statics = run_statics(model, start ? &*start : nullptr);
  if (run.statics.failure) {
    run.results.found = false;
    run.results.why = "the model with the answer has no equilibrium: " + failure_line(*run.statics.failure);
    return;
  }
  add_hull_results(model, *run.statics.results);
}

void write_answer(const SeekRun& run, const fs::path& folder) {
  if (run.operation) {
    write_operation_files(*run.operation, run.answer, folder);
    const FirstSection sought{seek_section(run.results), {{"seek", seek_figure_data(run.results)}}};
    write_operation_report(*run.operation, run.answer.source_text, folder / "report.html", &sought);
    return;
  }
  write_static_files(*run.statics.results, run.answer, folder);
  write_report(*run.statics.results, run.answer.source_text, folder / "report.html", {.seek = &run.results});
}

}  // namespace

SeekRun run_seek(const Description& description, const SeekDescription& wanted, const std::function<bool()>& stop) {
  const InterruptionScope scope(stop);
  SeekOutcome outcome = seek(description, wanted, stop);
  SeekRun run{std::move(outcome.results), {}, {}, {}};
  if (!run.results.found) return run;
  run.answer = with_answer(description, wanted, run.results);
  if (is_seek_over_stages(run.answer.operation.type)) {
    solve_stages(run);
    return run;
  }
  if (is_lay_operation(run.answer.operation.type)) run.answer.findings.push_back(no_stage_finding(run.answer, false));
  solve_answer(run, outcome.start);
  return run;
}

Findings SeekRun::findings() const {
  if (operation) return operation_findings(*operation);
  return statics.results ? statics.results->findings : Findings{};
}

std::string answered_text(const SeekRun& run, const fs::path& folder) {
  return moved_text(run.answer.source_text, run.answer.source_file, folder);
}

void write_seek_run(const SeekRun& run, const Description& description, const fs::path& folder) {
  StagedFolder staged(folder);
  if (run.results.found) {
    write_answer(run, staged.path());
    write_text(staged.path() / "model.yaml", answered_text(run, folder));
  }
  write_seek_files(run.results, description.title, staged.path());
  staged.commit("summary.json");
}

}  // namespace overbend
