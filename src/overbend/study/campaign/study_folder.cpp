#include "study/campaign/study_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "base/text.h"
#include "base/version.h"
#include "model/description/study_words.h"
#include "modelfile/reading/seek_reader.h"
#include "modelfile/schema/scalar_row.h"
#include "resultfiles/summary/study_outputs.h"
#include "runstore/append_file.h"
#include "runstore/replace_file.h"
#include "runstore/run_record.h"
#include "runstore/staged_folder.h"
#include "study/campaign/study_findings.h"
#include "study/operability/operability_folder.h"

#include "results/result_words.h"
namespace overbend {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStudy = "study.json";
constexpr const char* kRecord = "case.json";

constexpr std::array kStates = {"open", "done", "failed"};

const char* word(StudyCaseState state) {
  return kStates.at(static_cast<std::size_t>(state));
}

StudyCaseState state_of(const std::string& name) {
  const auto found = std::ranges::find(kStates, name);
  return found == kStates.end() ? StudyCaseState::open : static_cast<StudyCaseState>(found - kStates.begin());
}

/// What the files hold that axes of words name, such as one sea after the other.
std::string axis_text(const CaseBase& base) {
  std::string text;
  for (const StudyAxis& axis : base.study().axes) {
    const Field* row = scalar_row(axis.key);
    if (row == nullptr || row->kind != FieldKind::text) continue;
    for (const std::string& value : axis.values) {
      try {
        text += input_text(base.described({{axis.key, value}}, false));
      } catch (const std::runtime_error&) {
        text += "\n# no model\n";  // the case will say why
      }
    }
  }
  return text;
}

/// What a study is made from, with the words for each part.
Json origins(const CaseBase& base) {
  return {{"study file", text_hash(base.study().text)},
          {"base model or a file that it names", text_hash(input_text(base.model()) + axis_text(base))},
          {"program", program_identity()}};
}

Json input_json(const StudyInput& input) {
  return {{"key", input.key},         {"unit", input.unit},   {"show", input.show},    {"with", input.with},
          {"sampled", input.sampled}, {"words", input.words}, {"values", input.values}};
}

StudyInput input_of(const Json& json) {
  return {json.at("key"),     json.at("unit"),  json.at("show"),  json.at("with"),
          json.at("sampled"), json.at("words"), json.at("values")};
}

double duration_of(const CaseBase& base) {
  if (base.study().analysis != StudyAnalysis::dynamic) return 0.0;
  const std::optional<DynamicSettings>& settings = base.model().dynamics;
  return base.study().duration.value_or(settings ? settings->duration : 0.0);
}

/// Peaks as one text for each history: six digits of many numbers in little space.
Json peaks_json(const std::vector<HistoryPeaks>& peaks) {
  Json list = Json::array();
  for (const HistoryPeaks& one : peaks) {
    std::string text;
    for (const double peak : one.record.peaks) text += fmt::format("{}{:.6g}", text.empty() ? "" : " ", peak);
    list.push_back(
        {{"name", one.name}, {"smallest", one.smallest}, {"duration", one.record.duration}, {"peaks", text}});
  }
  return list;
}

HistoryPeaks peaks_of(const Json& json) {
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
          {"analysis", word_of(base.study().analysis)},
          {"study", fs::absolute(base.study().file).lexically_normal().string()},
          {"base", fs::absolute(base.model().source_file).lexically_normal().string()},
          {"made_from", origins(base)},
          {"duration", duration_of(base)},
          {"cases", base.study().operability ? 0 : cases.count()},  // those of a search are trials
          {"seeds", cases.seeds()},
          {"inputs", inputs},
          {"outputs", outputs}};
}

std::string text_of(const Json& json) {
  return json_text(json, 2) + "\n";
}

void refuse_another(const Json& there, const Json& wanted, const fs::path& folder) {
  for (const auto& [part, hash] : wanted.at("made_from").items()) {
    const Json& before = there.value("made_from", Json::object());
    if (before.contains(part) && before.at(part) == hash) continue;
    throw UnusableFolder(
        fmt::format("'{}' holds a study that was made from another {}; give another folder", folder.string(), part));
  }
}

Json number_json(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

std::optional<double> number_of(const Json& json, const char* key) {
  return json.contains(key) && json.at(key).is_number() ? std::optional(json.at(key).get<double>()) : std::nullopt;
}

fs::path record_path(const fs::path& folder, std::size_t number) {
  return folder / case_folder(number) / kRecord;
}

/// Fills what the record says; a record that is damaged leaves the case open.
void take_record(const Json& record, const std::vector<StudyOutput>& outputs, StudyCase& one) {
  const Json& values = record.at("outputs");
  one.values.resize(outputs.size());
  one.texts.resize(outputs.size());
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (!values.contains(outputs[i].name)) continue;
    const Json& value = values.at(outputs[i].name);
    if (value.is_number()) one.values[i] = value.get<double>();
    if (value.is_string()) one.texts[i] = value.get<std::string>();
  }
  from_word(record.at("verdict").get<std::string>(), one.verdict);
  one.governing = record.at("governing");
  one.utilisation = number_of(record, "utilisation");
  one.reason = record.at("reason");
  one.findings = read_findings(record.at("findings"));
  one.wall_time = record.at("wall_time");
  one.state = state_of(record.at("state"));
}

/// The words and numbers of the inputs stand in the record as well, so that the table needs the study file no more.
void take_inputs(const Json& record, const std::vector<StudyInput>& inputs, StudyCase& one) {
  for (const StudyInput& input : inputs) {
    const Json& value = record.at("inputs").at(input.key);
    one.words.push_back(value.at("text"));
    one.inputs.push_back(number_of(value, "si").value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  one.at = record.at("at").get<std::vector<std::size_t>>();
  if (record.contains("seed")) one.seed = record.at("seed").get<std::uint64_t>();
}

/// Limits that were looked for, with what they assume.
void take_operability(const fs::path& folder, StudyResults& results) {
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
  const std::vector<std::string> usual = usual_outputs(study.analysis, base.model());
  for (const std::string& name : study.gather.empty() ? usual : study.gather) {
    if (auto output = study_output(study.analysis, name, seek)) outputs.push_back(std::move(*output));
  }
  return outputs;
}

void open_study(const CaseBase& base, const StudyCases& cases, const fs::path& folder) {
  Json wanted = study_json(base, cases);
  if (const std::optional<Json> there = read_json_object(folder / kStudy)) {
    return refuse_another(*there, wanted, folder);
  }
  std::error_code fault;
  for (const char* other :
       {"summary.json", "run.json", "results.h5", "report.html", "study.csv", "study.xlsx", "operability.csv"}) {
    if (!fs::exists(folder / other, fault)) continue;
    throw UnusableFolder("'" + folder.string() + "' holds other results; give another folder");
  }
  fs::create_directories(folder, fault);
  if (fault) throw UnusableFolder("'" + folder.string() + "' cannot be made: " + fault.message());
  wanted["findings"] = findings_json(study_findings(base, cases));
  try {
    replace_file(folder / kStudy, text_of(wanted));
  } catch (const std::runtime_error& refused) {
    throw UnusableFolder(refused.what());
  }
}

StudyCaseState recorded_state(const fs::path& folder, std::size_t number) {
  const std::optional<Json> record = read_json_object(record_path(folder, number));
  return record && record->contains("state") ? state_of(record->at("state")) : StudyCaseState::open;
}

StudyCase recorded_case(const StudyCases& cases, const std::vector<StudyOutput>& outputs, const fs::path& folder,
                        std::size_t number) {
  StudyCase one = cases.at(number);
  if (const std::optional<Json> record = read_json_object(record_path(folder, number))) {
    try {
      take_record(*record, outputs, one);
    } catch (const Json::exception&) {
      one = cases.at(number);
    }
  }
  return one;
}

void take_answer(const CaseAnswer& answer, StudyAnalysis analysis, const std::vector<StudyOutput>& outputs,
                 StudyCase& one) {
  const bool done = answer.ending == RunEnding::done;
  one.state = done ? StudyCaseState::done : StudyCaseState::failed;
  one.values.assign(outputs.size(), std::nullopt);
  one.texts.assign(outputs.size(), "");
  one.findings = answer.findings;
  if (!done) {
    one.reason = answer.why;
    return;
  }
  one.verdict = answer.verdict;
  one.governing = answer.governing;
  one.utilisation = answer.utilisation;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (outputs[i].text) {
      one.texts[i] = answer.governing;
      continue;
    }
    const std::optional<double> value = output_value(answer.summary, analysis, outputs[i].name);
    if (value && std::isfinite(*value)) one.values[i] = value;
  }
}

void write_case_record(const StudyCase& one, const std::vector<StudyInput>& inputs,
                       const std::vector<StudyOutput>& outputs, const fs::path& folder,
                       const std::vector<HistoryPeaks>& peaks) {
  Json given = Json::object(), gathered = Json::object();
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    given[inputs[i].key] = {{"text", one.words[i]}, {"si", number_json(one.inputs[i])}};
  }
  for (std::size_t i = 0; i < outputs.size() && i < one.values.size(); ++i) {
    gathered[outputs[i].name] = outputs[i].text ? Json(one.texts[i]) : number_json(one.values[i]);
  }
  Json record = {{"case", one.number},
                 {"state", word(one.state)},
                 {"inputs", given},
                 {"at", one.at},
                 {"outputs", gathered},
                 {"verdict", word(one.verdict)},
                 {"passed", one.passed()},
                 {"governing", one.governing},
                 {"utilisation", number_json(one.utilisation)},
                 {"reason", one.reason},
                 {"warnings", messages(one.findings)},
                 {"findings", findings_json(one.findings)},
                 {"wall_time", one.wall_time}};
  if (one.seed) record["seed"] = *one.seed;
  if (!peaks.empty()) record["peaks"] = peaks_json(peaks);
  const fs::path file = record_path(folder, one.number), beside = file.string() + ".part";
  std::error_code fault;
  fs::create_directories(file.parent_path(), fault);
  write_text(beside, text_of(record));
  fs::rename(beside, file, fault);
  if (fault) throw FileFault("'" + file.string() + "' cannot be written: " + fault.message());
}

StudyResults read_study(const fs::path& folder) {
  const std::optional<Json> json = read_json_object(folder / kStudy);
  if (!json) throw std::runtime_error("'" + folder.string() + "' is no folder of a study: study.json is missing");
  StudyResults results;
  try {
    results.title = json->at("title");
    results.version = json->at("version");
    results.analysis = json->at("analysis");
    results.command = study_words(json->at("study"), folder.string());
    results.findings = read_findings(json->value("findings", Json::array()));
    for (const Json& input : json->at("inputs")) results.inputs.push_back(input_of(input));
    for (const Json& output : json->at("outputs")) {
      results.outputs.push_back({output.at("name"), output.at("unit"), output.at("text")});
    }
    const std::size_t count = json->at("cases"), seeds = json->at("seeds");
    for (std::size_t number = 0; number < count; ++number) {
      StudyCase& one = results.cases.emplace_back();
      one.number = number;
      one.group = number / seeds;
      one.folder = case_folder(number);
      const std::optional<Json> record = read_json_object(record_path(folder, number));
      if (!record) continue;
      take_inputs(*record, results.inputs, one);
      take_record(*record, results.outputs, one);
      results.wall_time += one.wall_time;
    }
  } catch (const Json::exception& fault) {
    throw std::runtime_error("'" + folder.string() + "' holds a damaged record: " + fault.what());
  }
  take_operability(folder, results);
  return results;
}

std::vector<HistoryPeaks> recorded_peaks(const fs::path& folder, const StudyCase& one) {
  std::vector<HistoryPeaks> peaks;
  const fs::path h5 = folder / one.folder / "results.h5";
  std::error_code fault;
  if (fs::exists(h5, fault)) return peaks_of_run(h5);
  const std::optional<Json> record = read_json_object(record_path(folder, one.number));
  if (!record || !record->contains("peaks")) return peaks;
  try {
    for (const Json& history : record->at("peaks")) peaks.push_back(peaks_of(history));
  } catch (const Json::exception&) {
    return {};
  }
  return peaks;
}

double recorded_duration(const fs::path& folder) {
  const std::optional<Json> json = read_json_object(folder / kStudy);
  return json ? number_of(*json, "duration").value_or(0.0) : 0.0;
}

std::string study_words(const std::string& file, const std::string& folder) {
  return "overbend study " + shell_word(file) + " -o " + shell_word(folder);
}

}  // namespace overbend
