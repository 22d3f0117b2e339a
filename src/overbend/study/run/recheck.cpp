#include "study/run/recheck.h"

#include "base/yaml_document.h"
#include "checks/recheck_key.h"
#include "checks/run_checks.h"
#include "model/lay_stage.h"
#include "modelfile/reading/yaml_reader.h"
#include "modelfile/yaml/yaml_edit.h"
#include "report/report.h"
#include "resultfiles/dynamic/dynamic_reader.h"
#include "resultfiles/dynamic/dynamic_writer.h"
#include "resultfiles/stages/operation_reader.h"
#include "runstore/staged_folder.h"
#include "runstore/written_files.h"
#include "study/run/static_analysis.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

YamlChange parse_change(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::string path = text.substr(0, equals);
  if (equals == std::string::npos) {
    throw RecheckError("--set " + text + ": expected a key and its value, such as checks.safety_class=high");
  }
  if (!path.starts_with("checks.")) {
    throw RecheckError("--set " + path +
                       ": only keys below 'checks' can be set for stored results; the others need a new analysis");
  }
  const std::string value = text.substr(equals + 1);
  const bool flow = value.starts_with('{') || value.starts_with('[');
  const YamlChange::Kind kind = value.empty() ? YamlChange::Kind::remove
                                : flow        ? YamlChange::Kind::flow
                                              : YamlChange::Kind::scalar;
  return {path, kind, value};
}

/// Reads the model without the files that it names; checks need none of them.
Description read_stored(const std::string& text, const std::string& file) {
  Diagnostics diagnostics;
  const std::optional<YamlNode> root = parse_yaml(text, file, diagnostics);
  ModelReading reading;
  if (root && !diagnostics.has_errors()) {
    reading = read_statics_inputs(*root, file);
    diagnostics = reading.diagnostics;
  }
  if (!reading.description) {
    const std::vector<std::string> errors = diagnostics.lines(Severity::error);
    throw RecheckError(errors.empty() ? file + " cannot be read" : errors.front());
  }
  reading.description->source_text = text;
  return std::move(*reading.description);
}

std::string edited(const std::string& text, const std::vector<std::string>& changes) {
  std::vector<YamlChange> all;
  for (const std::string& change : changes) all.push_back(parse_change(change));
  try {
    return edit_yaml(text, all);
  } catch (const YamlEditError& error) {
    throw RecheckError(error.what());
  }
}

/// Returns the model of the stored results: the lay, or the stage of its operation.
Description at_stored_stage(Description description, const StoredStatics& stored) {
  return stored.stage ? make_stage_description(description, *stored.stage) : std::move(description);
}

Rechecked read_results(const fs::path& h5, StoredStatics& stored) {
  Rechecked again;
  if (has_dynamic(h5)) {
    StoredDynamics all = read_dynamic_results(h5);
    stored = std::move(all.statics);
    again.dynamics = std::move(all.results);
  } else {
    stored = read_static_results(h5);
  }
  again.statics = std::move(stored.results);
  return again;
}

/// Throws if a change needs data that the results do not hold.
void require_same_analysis(const Model& before, const Model& after, bool in_time) {
  const std::string key = key_for_new_analysis(before, after, in_time);
  if (key.empty()) return;
  throw RecheckError(key + " cannot be changed for these results, which lack the data that the checks need of " +
                     (in_time ? "every step" : "the lay without its current") + "; run the model again");
}

}  // namespace

Rechecked recheck(const fs::path& h5, const std::vector<std::string>& changes) {
  StoredStatics stored;
  Rechecked again = read_results(h5, stored);
  again.description = at_stored_stage(read_stored(edited(stored.model_text, changes), stored.model_file), stored);
  const Model before = build_model(at_stored_stage(read_stored(stored.model_text, stored.model_file), stored));
  const Model after = build_model(again.description);
  require_same_analysis(before, after, again.dynamics.has_value());
  fill_checks(after, again.statics);
  accept(again.statics.findings, after.description.checks.accepted_findings);
  if (again.dynamics) {
    select_safety_class(again.dynamics->design, after.description.checks.safety_class);
    fill_checks(after, again.statics, *again.dynamics);
    accept(again.dynamics->findings, after.description.checks.accepted_findings);
  }
  return again;
}

RecheckedOperation recheck_operation(const fs::path& h5, const std::vector<std::string>& changes) {
  StoredOperation stored = read_operation_results(h5);
  const Description before = read_stored(stored.model_text, stored.model_file);
  RecheckedOperation again{read_stored(edited(stored.model_text, changes), stored.model_file),
                           std::move(stored.results)};
  for (StageResult& stage : again.results.stages) {
    if (!stage.lay) continue;
    const Model after = build_model(make_stage_description(again.description, stage.stage));
    require_same_analysis(build_model(make_stage_description(before, stage.stage)), after, false);
    fill_checks(after, *stage.lay);
    accept(stage.lay->findings, after.description.checks.accepted_findings);
  }
  return again;
}

void write_rechecked(const Rechecked& again, const fs::path& from, const fs::path& folder) {
  if (!again.dynamics) {
    write_static_run(again.statics, again.description, folder);
    return;
  }
  StagedFolder staged(folder);
  write_rechecked_files(again.statics, *again.dynamics, from, again.description, staged.path());
  write_report(again.statics, *again.dynamics, again.description.source_text, staged.path() / "report.html");
  staged.commit("summary.json");
}

std::vector<fs::path> result_files(const fs::path& folder) {
  if (fs::is_regular_file(folder)) return {folder};
  if (fs::exists(folder / "results.h5")) return {folder / "results.h5"};
  std::vector<fs::path> files;
  for (const std::string& name : read_written(folder).folders) {
    if (fs::exists(folder / name / "results.h5")) files.push_back(folder / name / "results.h5");
  }
  return files;
}

}  // namespace overbend
