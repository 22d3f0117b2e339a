#include "study/operability/trial_record.h"

#include <array>
#include <utility>

#include "runstore/append_file.h"
#include "runstore/replace_file.h"

namespace overbend {
namespace {

constexpr std::array<std::pair<TrialEnd, const char*>, 4> kWords = {{{TrialEnd::passed, "passed"},
                                                                     {TrialEnd::exceeded, "exceeded"},
                                                                     {TrialEnd::no_solution, "no solution"},
                                                                     {TrialEnd::open, "open"}}};

std::string word(TrialEnd end) {
  for (const auto& [one, text] : kWords) {
    if (one == end) return text;
  }
  return "";
}

Json question_json(const CaseQuestion& question) {
  Json keys = Json::object();
  for (const KeySetting& setting : question.keys) keys[setting.key] = setting.value;
  Json json = {{"keys", keys}};
  if (question.seed) json["seed"] = *question.seed;
  return json;
}

TrialRecord record_of(const Json& json) {
  TrialRecord record;
  const std::string wanted = json.at("end").get<std::string>();
  for (const auto& [end, text] : kWords) {
    if (wanted == text) record.result.end = end;
  }
  if (json.contains("utilisation")) record.result.utilisation = json.at("utilisation").get<double>();
  record.result.governing = json.at("governing").get<std::string>();
  record.wall_time = json.at("wall_time").get<double>();
  return record;
}

}  // namespace

std::optional<TrialRecord> read_trial(const std::filesystem::path& folder, const CaseQuestion& question) {
  try {
    const Json json = read_json_file(folder / "trial.json");
    if (!json.contains("findings_judged")) return std::nullopt;  // of a program that judged checks alone
    if (json.at("question") != question_json(question)) return std::nullopt;
    TrialRecord record = record_of(json);
    return record.result.end == TrialEnd::open ? std::nullopt : std::optional(std::move(record));
  } catch (const Json::exception&) {  // no record of ours
    return std::nullopt;
  }
}

void write_trial(const TrialRecord& record, const CaseQuestion& question, const std::filesystem::path& folder) {
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  if (fault) throw FileFault("the folder '" + folder.string() + "' cannot be made: " + fault.message());
  Json json = {{"question", question_json(question)}, {"end", word(record.result.end)}};
  if (record.result.utilisation) json["utilisation"] = *record.result.utilisation;
  json["governing"] = record.result.governing;
  json["findings_judged"] = true;
  json["wall_time"] = record.wall_time;
  replace_file(folder / "trial.json", json_text(json, 1) + "\n");
}

}  // namespace overbend
