#include "serve/run_info.h"

#include <array>
#include <chrono>
#include <fstream>

#include "report/json_number.h"
#include "resultfiles/results_writer.h"
#include "runstore/append_file.h"
#include "runstore/run_store.h"
#include "runstore/staged_folder.h"

namespace overbend {
namespace fs = std::filesystem;
namespace {

constexpr std::array kStates = {"queued", "running", "done", "failed", "cancelled"};

Json read_json(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return stream ? Json::parse(stream, nullptr, false) : Json();
}

RunState state_of(const std::string& name) {
  for (std::size_t i = 0; i < kStates.size(); ++i) {
    if (kStates[i] == name) return static_cast<RunState>(i);
  }
  return RunState::failed;
}

double modified(const fs::path& file) {
  std::error_code fault;
  const auto time = std::chrono::file_clock::to_sys(fs::last_write_time(file, fault));
  return static_cast<double>(std::chrono::duration_cast<std::chrono::seconds>(time.time_since_epoch()).count());
}

/// Results beside a checkpoint are those of a cancelled run.
bool cancelled_on_the_way(const RunInfo& run, const fs::path& folder) {
  std::error_code fault;
  return run.state == RunState::cancelled && fs::exists(folder / ".run", fault);
}

std::optional<RunInfo> find_run(const fs::path& folder) {
  const fs::path summary_file = folder / "summary.json";
  const Json note = read_json(folder / "run.json"), summary = read_json(summary_file);
  if (!note.is_object() && !summary.is_object()) return std::nullopt;
  RunInfo run;
  run.id = folder.filename().string();
  if (note.is_object()) {
    run.title = note.value("title", "");
    run.kind = note.value("kind", "static");
    run.state = state_of(note.value("state", ""));
    run.started = note.value("started", 0.0);
    run.message = note.value("message", "");
    run.name = note.value("name", "");
    run.note = note.value("note", "");
    run.model_path = note.value("model_path", "");
    run.progress = note.value("progress", 0.0);
    run.duration = note.value("duration", 0.0);
  }
  if (summary.is_object()) {
    run.title = summary.value("title", "");
    run.kind = summary.contains("dynamic") ? "dynamic" : "static";
    run.has_results = true;
    if (!cancelled_on_the_way(run, folder)) {
      run.state = RunState::done;
      run.progress = 1.0;
    }
    if (run.started == 0.0) run.started = modified(summary_file);
  } else if (!run.ended()) {
    run.state = RunState::cancelled;
    run.message = "the program ended before the run started";
  }
  run.resumable = run.state != RunState::done && can_be_resumed(folder);
  return run;
}

}  // namespace

Json run_json(const RunInfo& run) {
  Json json = {{"id", run.id},
               {"title", run.title},
               {"kind", run.kind},
               {"state", kStates[static_cast<std::size_t>(run.state)]},
               {"progress", seven_digits(run.progress)},
               {"started", run.started},
               {"message", run.message},
               {"name", run.name},
               {"note", run.note},
               {"has_results", run.has_results},
               {"resumable", run.resumable}};
  if (run.now) {
    json["time"] = seven_digits(run.now->time);
    json["end"] = seven_digits(run.now->end);
    json["top_tension"] = seven_digits(run.now->top_tension);
    json["worst_stress"] = seven_digits(run.now->worst_stress);
  }
  return json;
}

bool can_be_resumed(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder / kModelCopy, ignored)) return false;
  const std::optional<StoredRun> stored = RunStore::find(folder);
  return stored && stored->fault.empty();
}

double seconds_since_1970() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<double>(std::chrono::duration_cast<std::chrono::seconds>(now).count());
}

void write_note(const RunInfo& run, const fs::path& folder) {
  RunInfo lasting = run;
  lasting.now.reset();
  const fs::path beside = folder / "run.json.part";
  Json note = run_json(lasting);
  note["model_path"] = run.model_path;
  note["duration"] = run.duration;
  write_text(beside, note.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  fs::rename(beside, folder / "run.json");
}

std::vector<RunInfo> find_runs(const fs::path& folder) {
  std::vector<RunInfo> runs;
  std::error_code fault;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, fault)) {
    if (!entry.is_directory(fault)) continue;
    clear_leftovers(entry.path());  // of a program that was killed: nobody writes into an old run again
    try {
      if (std::optional<RunInfo> run = find_run(entry.path())) runs.push_back(std::move(*run));
    } catch (const std::exception&) {
      continue;  // a file that only looks like ours
    }
  }
  return runs;
}

}  // namespace overbend
