#include "study/campaign/study_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "base/ranges.h"
#include "base/text.h"
#include "base/version.h"
#include "model/description/study_enum_names.h"
#include "modelfile/reading/seek_reader.h"
#include "modelfile/schema/scalar_row.h"
#include "resultfiles/summary/study_outputs.h"
#include "runstore/append_file.h"
#include "runstore/replace_file.h"
#include "runstore/run_record.h"
#include "runstore/staged_folder.h"
#include "study/campaign/study_findings.h"
#include "study/operability/operability_folder.h"

#include "results/result_enum_names.h"
namespace overbend {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStudy = "study.json";
constexpr const char* kRecord = "case.json";

constexpr std::array kStates = {"open", "done", "failed"};

const char* word(StudyCaseState state) {
  return kStates.at(static_cast<std::size_t>(state));
}

StudyCaseState parse_state(const std::string& name) {
  const auto found = ranges::find(kStates, name);
  return found == kStates.end() ? StudyCaseState::open : static_cast<StudyCaseState>(found - kStates.begin());
}

/// Inputs in the files that text axes name, such as a list of seas.
std::string axis_text(const CaseBase& base) {
  std::string text;
  for (const StudyAxis& axis : base.study().axes) {
    const Field* row = scalar_row(axis.key);
    if (row == nullptr || row->kind != FieldKind::text) continue;
    for (const std::string& value : axis.values) {
      try {
        text += input_text(base.described({{axis.key, value}}, false));
      } catch (const std::runtime_error&) {
        text += "\n# no model\n";  // the case reports the error
      }
    }
  }
  return text;
}

/// Hashes of the origins of a study, by their names in messages.
Json origins(const CaseBase& base) {
  return {{"study file", text_hash(base.study().text)},
          {"base model or a file that it names", text_hash(input_text(base.model()) + axis_text(base))},
          {"program", program_identity()}};
}

Json input_json(const StudyInput& input) {
  return {{"key", input.key},         {"unit", input.unit},         {"show", input.show},    {"with", input.with},
          {"sampled", input.sampled}, {"words", input.value_texts}, {"values", input.values}};
}

StudyInput parse_input(const Json& json) {
  return {json.at("key"),     json.at("unit"),  json.at("show"),  json.at("with"),
          json.at("sampled"), json.at("words"), json.at("values")};
}

double study_duration(const CaseBase& base) {
  if (base.study().analysis != StudyAnalysis::dynamic) return 0.0;
  const std::optional<DynamicSettings>& settings = base.model().dynamics;
  return base.study().duration.value_or(settings ? settings->duration : 0.0);
}

/// Peaks as one text per history: six digits each, to save space.
Json peaks_json(const std::vector<HistoryPeaks>& peaks) {
  Json list = Json::array();
  for (const HistoryPeaks& history : peaks) {
    std::string text;
    for (const double peak : history.record.peaks) text += fmt::format("{}{:.6g}", text.empty() ? "" : " ", peak);
    list.push_back({{"name", history.name},
                    {"smallest", history.is_minimum},
                    {"duration", history.record.duration},
                    {"peaks", text}});
  }
  return list;
}

HistoryPeaks parse_peaks(const Json& json) {
  HistoryPeaks peaks{json.at("name"), json.at("smallest"), {}};
  peaks.record.duration = json.at("duration");
  std::istringstream text(json.at("peaks").get<std::string>());
  for (double peak = 0.0; text >> peak;) peaks.record.peaks.push_back(peak);
  return peaks;
}

Json study_json(const CaseBase& base, const StudyCases& cases) {
  Json inputs = Json::array(), outputs = Json::array();
  for (const StudyInput& input : cases.inputs()) inputs.push_back(input_json(input));
  for (const StudyOutput& output : study_outputs(base)) {
    outputs.push_back({{"name", output.name}, {"unit", output.unit}, {"text", output.text}});
  }
  return {{"title", base.study().title},
          {"version", kVersion},
          {"analysis", enum_name(base.study().analysis)},
          {"study", fs::absolute(base.study().file).lexically_normal().string()},
          {"base", fs::absolute(base.model().source_file).lexically_normal().string()},
          {"made_from", origins(base)},
          {"duration", study_duration(base)},
          {"cases", base.study().operability ? 0 : cases.count()},  // a limit search has trials instead
          {"seeds", cases.seeds()},
          {"inputs", inputs},
          {"outputs", outputs}};
}

std::string file_content(const Json& json) {
  return json_text(json, 2) + "\n";
}

void reject_other_study(const Json& present, const Json& wanted, const fs::path& folder) {
  for (const auto& [part, hash] : wanted.at("made_from").items()) {
    const Json& before = present.value("made_from", Json::object());
    if (before.contains(part) && before.at(part) == hash) continue;
    throw UnusableFolder(
        fmt::format("'{}' holds a study made from another {}; give another folder", folder.string(), part));
  }
}

Json number_json(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

std::optional<double> parse_number_or_null(const Json& json, const char* key) {
  return json.contains(key) && json.at(key).is_number() ? std::optional(json.at(key).get<double>()) : std::nullopt;
}

fs::path record_path(const fs::path& folder, std::size_t number) {
  return folder / case_folder(number) / kRecord;
}

/// Fills the results from the record; a damaged record leaves the case open.
void load_record(const Json& record, const std::vector<StudyOutput>& outputs, StudyCase& study_case) {
  const Json& values = record.at("outputs");
  study_case.values.resize(outputs.size());
  study_case.texts.resize(outputs.size());
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (!values.contains(outputs[i].name)) continue;
    const Json& value = values.at(outputs[i].name);
    if (value.is_number()) study_case.values[i] = value.get<double>();
    if (value.is_string()) study_case.texts[i] = value.get<std::string>();
  }
  from_enum_name(record.at("verdict").get<std::string>(), study_case.verdict);
  study_case.governing = record.at("governing");
  study_case.utilisation = parse_number_or_null(record, "utilisation");
  study_case.reason = record.at("reason");
  study_case.findings = read_findings(record.at("findings"));
  study_case.wall_time = record.at("wall_time");
  study_case.state = parse_state(record.at("state"));
}

/// The record also holds the texts and numbers of the inputs, so that the table does not need the study file.
void read_inputs(const Json& record, const std::vector<StudyInput>& inputs, StudyCase& study_case) {
  for (const StudyInput& input : inputs) {
    const Json& value = record.at("inputs").at(input.key);
    study_case.value_texts.push_back(value.at("text"));
    study_case.inputs.push_back(parse_number_or_null(value, "si").value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  study_case.value_indices = record.at("at").get<std::vector<std::size_t>>();
  if (record.contains("seed")) study_case.seed = record.at("seed").get<std::uint64_t>();
}

/// Adds the limits found by a search, with their assumptions.
void load_operability(const fs::path& folder, StudyResults& results) {
  results.operability = read_operability(folder);
  if (!results.operability) return;
  results.wall_time += results.operability->wall_time;
  for (const std::string& remark : results.operability->remarks) {
    results.findings.push_back({FindingCode::study_inputs, remark});
  }
}

}  // namespace

std::vector<StudyOutput> study_outputs(const CaseBase& base) {
  const StudyDescription& study = base.study();
  const std::optional<SeekDescription> seek =
      study.analysis == StudyAnalysis::seek ? read_seek(base.model()) : std::nullopt;
  std::vector<StudyOutput> outputs;
  const std::vector<std::string> usual = default_outputs(study.analysis, base.model());
  for (const std::string& name : study.gather.empty() ? usual : study.gather) {
    if (auto output = study_output(study.analysis, name, seek)) outputs.push_back(std::move(*output));
  }
  return outputs;
}

void open_study(const CaseBase& base, const StudyCases& cases, const fs::path& folder) {
  Json wanted = study_json(base, cases);
  if (const std::optional<Json> present = read_json_object(folder / kStudy)) {
    return reject_other_study(*present, wanted, folder);
  }
  std::error_code io_error;
  for (const char* name :
       {"summary.json", "run.json", "results.h5", "report.html", "study.csv", "study.xlsx", "operability.csv"}) {
    if (!fs::exists(folder / name, io_error)) continue;
    throw UnusableFolder("'" + folder.string() + "' holds other results; give another folder");
  }
  fs::create_directories(folder, io_error);
  if (io_error) throw UnusableFolder("'" + folder.string() + "' cannot be created: " + io_error.message());
  wanted["findings"] = findings_json(study_findings(base, cases));
  try {
    replace_file(folder / kStudy, file_content(wanted));
  } catch (const std::runtime_error& error) {
    throw UnusableFolder(error.what());
  }
}

StudyCaseState recorded_state(const fs::path& folder, std::size_t number) {
  const std::optional<Json> record = read_json_object(record_path(folder, number));
  return record && record->contains("state") ? parse_state(record->at("state")) : StudyCaseState::open;
}

StudyCase recorded_case(const StudyCases& cases, const std::vector<StudyOutput>& outputs, const fs::path& folder,
                        std::size_t number) {
  StudyCase study_case = cases.at(number);
  if (const std::optional<Json> record = read_json_object(record_path(folder, number))) {
    try {
      load_record(*record, outputs, study_case);
    } catch (const Json::exception&) {
      study_case = cases.at(number);
    }
  }
  return study_case;
}

void store_result(const CaseResult& answer, StudyAnalysis analysis, const std::vector<StudyOutput>& outputs,
                  StudyCase& study_case) {
  const bool done = answer.ending == RunStatus::done;
  study_case.state = done ? StudyCaseState::done : StudyCaseState::failed;
  study_case.values.assign(outputs.size(), std::nullopt);
  study_case.texts.assign(outputs.size(), "");
  study_case.findings = answer.findings;
  if (!done) {
    study_case.reason = answer.why;
    return;
  }
  study_case.verdict = answer.verdict;
  study_case.governing = answer.governing;
  study_case.utilisation = answer.utilisation;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (outputs[i].text) {
      study_case.texts[i] = answer.governing;
      continue;
    }
    const std::optional<double> value = output_value(answer.summary, analysis, outputs[i].name);
    if (value && std::isfinite(*value)) study_case.values[i] = value;
  }
}

void write_case_record(const StudyCase& study_case, const std::vector<StudyInput>& inputs,
                       const std::vector<StudyOutput>& outputs, const fs::path& folder,
                       const std::vector<HistoryPeaks>& peaks) {
  Json inputs_json = Json::object(), gathered = Json::object();
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    inputs_json[inputs[i].key] = {{"text", study_case.value_texts[i]}, {"si", number_json(study_case.inputs[i])}};
  }
  for (std::size_t i = 0; i < outputs.size() && i < study_case.values.size(); ++i) {
    gathered[outputs[i].name] = outputs[i].text ? Json(study_case.texts[i]) : number_json(study_case.values[i]);
  }
  Json record = {{"case", study_case.number},
                 {"state", word(study_case.state)},
                 {"inputs", inputs_json},
                 {"at", study_case.value_indices},
                 {"outputs", gathered},
                 {"verdict", word(study_case.verdict)},
                 {"passed", study_case.passed()},
                 {"governing", study_case.governing},
                 {"utilisation", number_json(study_case.utilisation)},
                 {"reason", study_case.reason},
                 {"warnings", messages(study_case.findings)},
                 {"findings", findings_json(study_case.findings)},
                 {"wall_time", study_case.wall_time}};
  if (study_case.seed) record["seed"] = *study_case.seed;
  if (!peaks.empty()) record["peaks"] = peaks_json(peaks);
  const fs::path file = record_path(folder, study_case.number), partial = file.string() + ".part";
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  write_text(partial, file_content(record));
  name_complete_file(partial, file);
}

StudyResults read_study(const fs::path& folder) {
  const std::optional<Json> json = read_json_object(folder / kStudy);
  if (!json) throw std::runtime_error("'" + folder.string() + "' is not the folder of a study: study.json is missing");
  StudyResults results;
  try {
    results.title = json->at("title");
    results.version = json->at("version");
    results.analysis = json->at("analysis");
    results.command = make_study_command(json->at("study"), folder.string());
    results.findings = read_findings(json->value("findings", Json::array()));
    for (const Json& input : json->at("inputs")) results.inputs.push_back(parse_input(input));
    for (const Json& output : json->at("outputs")) {
      results.outputs.push_back({output.at("name"), output.at("unit"), output.at("text")});
    }
    const std::size_t count = json->at("cases"), seeds = json->at("seeds");
    for (std::size_t number = 0; number < count; ++number) {
      StudyCase& study_case = results.cases.emplace_back();
      study_case.number = number;
      study_case.group = number / seeds;
      study_case.folder = case_folder(number);
      const std::optional<Json> record = read_json_object(record_path(folder, number));
      if (!record) continue;
      read_inputs(*record, results.inputs, study_case);
      load_record(*record, results.outputs, study_case);
      results.wall_time += study_case.wall_time;
    }
  } catch (const Json::exception& error) {
    throw std::runtime_error("'" + folder.string() + "' holds a damaged record: " + error.what());
  }
  load_operability(folder, results);
  return results;
}

std::vector<HistoryPeaks> recorded_peaks(const fs::path& folder, const StudyCase& study_case) {
  std::vector<HistoryPeaks> peaks;
  const fs::path h5 = folder / study_case.folder / "results.h5";
  std::error_code error;
  if (fs::exists(h5, error)) return find_run_peaks(h5);
  const std::optional<Json> record = read_json_object(record_path(folder, study_case.number));
  if (!record || !record->contains("peaks")) return peaks;
  try {
    for (const Json& history : record->at("peaks")) peaks.push_back(parse_peaks(history));
  } catch (const Json::exception&) {
    return {};
  }
  return peaks;
}

double recorded_duration(const fs::path& folder) {
  const std::optional<Json> json = read_json_object(folder / kStudy);
  return json ? parse_number_or_null(*json, "duration").value_or(0.0) : 0.0;
}

std::string make_study_command(const std::string& file, const std::string& folder) {
  return "overbend study " + shell_word(file) + " -o " + shell_word(folder);
}

}  // namespace overbend
