#include "study/operability/trial_record.h"

#include <array>
#include <utility>

#include "runstore/append_file.h"
#include "runstore/replace_file.h"

namespace overbend {
namespace {

constexpr std::array<std::pair<TrialStatus, const char*>, 4> kStatusNames = {{{TrialStatus::passed, "passed"},
                                                                              {TrialStatus::exceeded, "exceeded"},
                                                                              {TrialStatus::no_solution, "no solution"},
                                                                              {TrialStatus::open, "open"}}};

std::string word(TrialStatus end) {
  for (const auto& [known, text] : kStatusNames) {
    if (known == end) return text;
  }
  return "";
}

Json question_json(const CaseInput& question) {
  Json keys = Json::object();
  for (const KeySetting& setting : question.keys) keys[setting.key] = setting.value;
  Json json = {{"keys", keys}};
  if (question.seed) json["seed"] = *question.seed;
  return json;
}

TrialRecord parse_record(const Json& json) {
  TrialRecord record;
  const std::string wanted = json.at("end").get<std::string>();
  for (const auto& [end, text] : kStatusNames) {
    if (wanted == text) record.result.end = end;
  }
  if (json.contains("utilisation")) record.result.utilisation = json.at("utilisation").get<double>();
  record.result.governing = json.at("governing").get<std::string>();
  record.wall_time = json.at("wall_time").get<double>();
  return record;
}

}  // namespace

std::optional<TrialRecord> read_trial(const std::filesystem::path& folder, const CaseInput& question) {
  try {
    const Json json = read_json_file(folder / "trial.json");
    if (!json.contains("findings_judged")) return std::nullopt;  // written by a version that judged checks only
    if (json.at("question") != question_json(question)) return std::nullopt;
    TrialRecord record = parse_record(json);
    return record.result.end == TrialStatus::open ? std::nullopt : std::optional(std::move(record));
  } catch (const Json::exception&) {  // not a record of this program
    return std::nullopt;
  }
}

void write_trial(const TrialRecord& record, const CaseInput& question, const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw FileError("the folder '" + folder.string() + "' cannot be created: " + error.message());
  Json json = {{"question", question_json(question)}, {"end", word(record.result.end)}};
  if (record.result.utilisation) json["utilisation"] = *record.result.utilisation;
  json["governing"] = record.result.governing;
  json["findings_judged"] = true;
  json["wall_time"] = record.wall_time;
  replace_file(folder / "trial.json", json_text(json, 1) + "\n");
}

}  // namespace overbend
