#include "study/run/run_folder.h"

#include <array>
#include <mutex>
#include <stdexcept>
#include <system_error>

#include "base/json.h"
#include "runstore/append_file.h"
#include "runstore/run_record.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRecord = "run.json";
constexpr std::array kStates = {"queued", "running", "done", "failed", "cancelled"};

/// An unknown state counts as failed.
RunState parse_state(const std::string& name) {
  for (std::size_t i = 0; i < kStates.size(); ++i) {
    if (kStates[i] == name) return static_cast<RunState>(i);
  }
  return RunState::failed;
}

Json record_json(const RunRecord& r) {
  return {{"kind", r.kind},         {"of", r.of},
          {"seeds", r.seeds},       {"title", r.title},
          {"duration", r.duration}, {"model_path", r.model_path},
          {"state", word(r.state)}, {"progress", r.progress},
          {"started", r.started},   {"message", r.message},
          {"name", r.name},         {"note", r.note},
          {"changed", r.changed},   {"stage", r.stage},
          {"input", r.input},       {"program", r.program}};
}

RunRecord parse_record(const Json& json) {
  RunRecord r;
  r.kind = json.value("kind", "static");
  r.of = json.value("of", "");
  r.seeds = json.value("seeds", r.seeds);
  r.title = json.value("title", "");
  r.stage = json.value("stage", "");
  r.duration = json.value("duration", 0.0);
  r.model_path = json.value("model_path", "");
  r.state = parse_state(json.value("state", ""));
  r.progress = json.value("progress", 0.0);
  r.started = json.value("started", 0.0);
  r.message = json.value("message", "");
  r.name = json.value("name", "");
  r.note = json.value("note", "");
  r.changed = json.value("changed", "");
  r.input = json.value("input", "");
  r.program = json.value("program", "");
  return r;
}

/// The queue and the running run change different parts of the same record.
std::mutex& records() {
  static std::mutex mutex;
  return mutex;
}

void replace_record(const RunRecord& record, const fs::path& folder) {
  const fs::path partial = folder / "run.json.part";
  write_text(partial, json_text(record_json(record), 2) + "\n");
  name_complete_file(partial, folder / kRecord);
}

}  // namespace

const char* word(RunState state) {
  return kStates.at(static_cast<std::size_t>(state));
}

std::optional<RunRecord> read_record(const fs::path& folder) {
  try {
    const Json json = read_json_file(folder / kRecord);
    if (json.is_object()) return parse_record(json);
  } catch (const Json::exception&) {  // a file of another program with the same name
  }
  return std::nullopt;
}

void write_record(const RunRecord& record, const fs::path& folder) {
  const std::lock_guard hold(records());
  replace_record(record, folder);
}

void change_record(const fs::path& folder, const std::function<void(RunRecord&)>& change) {
  const std::lock_guard hold(records());
  RunRecord record = read_record(folder).value_or(RunRecord{});
  change(record);
  replace_record(record, folder);
}

void mark_finished(const fs::path& folder, const std::string& kind, const std::string& title,
                   const std::string& input) {
  change_record(folder, [&](RunRecord& record) {
    record.kind = kind;
    record.title = title;
    record.state = RunState::done;
    record.progress = 1.0;
    record.input = text_hash(input);
    record.program = program_identity();
  });
}

void mark_unfinished(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder / kRecord, ignored)) return;
  try {
    change_record(folder, [](RunRecord& record) {
      if (record.state == RunState::done) record.state = RunState::running;
      record.input.clear();
      record.program.clear();
    });
  } catch (const std::exception&) {
    fs::remove(folder / kRecord, ignored);
  }
}

bool is_finished(const fs::path& folder, const std::string& input) {
  const std::optional<RunRecord> record = read_record(folder);
  if (!record || record->input.empty()) return false;
  if (record->input == text_hash(input) && record->program == program_identity()) return true;
  throw std::runtime_error(
      "'" + folder.string() +
      "' holds results of another model file, another --duration or another build of the program; start again with "
      "--restart");
}

}  // namespace overbend
