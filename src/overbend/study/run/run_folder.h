/// The record run.json of a folder of results.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace overbend {

enum class RunState { queued, running, done, failed, cancelled };
/// Name of a state in run.json.
const char* word(RunState state);

/// State, input and progress of a run. A member that does not apply is empty.
struct RunRecord {
  std::string kind;                  ///< "static", "dynamic", "seeds" or "comparison".
  std::string of;                    ///< Kind of a comparison: a name of ComparisonType.
  std::vector<std::uint64_t> seeds;  ///< Seeds, if there are several.
  std::string title;
  std::string stage;       ///< Name of the stage of a lay operation; empty: the normal lay.
  double duration = 0.0;   ///< Duration that replaces the model's [s]; 0: the model's.
  std::string model_path;  ///< Path of the model file, or its intended path; files that it names are next to it.
  RunState state = RunState::queued;
  double progress = 0.0;   ///< 0 to 1.
  double started = 0.0;    ///< Seconds since 1970.
  std::string message;     ///< Reason of a failure, and similar.
  std::string name, note;  ///< Name and note of the user.
  std::string changed;     ///< Keys in which the model differs from that of an earlier run of the same title.
  std::string input;       ///< Hash of the input of the results in the folder; empty while there are none.
  std::string program;     ///< Identity of the program that computed them.
};

/// Returns the record of a folder; empty if there is none.
std::optional<RunRecord> read_record(const std::filesystem::path& folder);

/// Replaces the record atomically. Throws std::runtime_error if the disk fails.
void write_record(const RunRecord& record, const std::filesystem::path& folder);

/// Reads, changes and writes the record, a new one if there is none. Serialised between threads of this program.
void change_record(const std::filesystem::path& folder, const std::function<void(RunRecord&)>& change);

/// Marks the folder's results as complete: of this kind and this input (input_text() of study/run/prepared_case.h).
void mark_finished(const std::filesystem::path& folder, const std::string& kind, const std::string& title,
                   const std::string& input);

/// Marks the results as incomplete before the folder is rewritten. Does not throw: if it fails, the run cannot be
/// stored either.
void mark_unfinished(const std::filesystem::path& folder);

/// True if the run of this input is finished in the folder. Throws std::runtime_error if the folder holds a finished
/// run of another model, duration or version.
bool is_finished(const std::filesystem::path& folder, const std::string& input);

}  // namespace overbend
