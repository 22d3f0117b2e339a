/// What a folder of results says of the run in it: the record run.json.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace overbend {

enum class RunState { queued, running, done, failed, cancelled };
const char* word(RunState state);

/// What is run, from which input, and how far it is. A member that does not apply is empty.
struct RunRecord {
  std::string kind;                  ///< "static", "dynamic", "seeds" or "comparison".
  std::string of;                    ///< Of a comparison: a word of ComparisonOf.
  std::vector<std::uint64_t> seeds;  ///< Of several seeds.
  std::string title;
  std::string stage;       ///< Of an operation on the line, its name; empty: the lay as such.
  double duration = 0.0;   ///< Asked for instead of the model's [s]; 0: the model's.
  std::string model_path;  ///< Of the model's file, or where it would lie: files it mentions lie beside.
  RunState state = RunState::queued;
  double progress = 0.0;   ///< 0 to 1.
  double started = 0.0;    ///< Seconds since 1970.
  std::string message;     ///< Why it failed, and the like.
  std::string name, note;  ///< The user's.
  std::string changed;     ///< Keys in which its model differs from that of an earlier run of the same title.
  std::string input;       ///< Hash of what the results in the folder were computed from; empty while there are none.
  std::string program;     ///< Identity of the program that did.
};

/// Nothing where there is none.
std::optional<RunRecord> read_record(const std::filesystem::path& folder);

/// Replaces the record at once. Throws std::runtime_error when the disk refuses.
void write_record(const RunRecord& record, const std::filesystem::path& folder);

/// Reads, changes and writes the record, a new one where there is none. Threads of this program take turns.
void change_record(const std::filesystem::path& folder, const std::function<void(RunRecord&)>& change);

/// The folder's results are whole: of this kind and this input (input_text() of study/run/prepared_case.h).
void mark_finished(const std::filesystem::path& folder, const std::string& kind, const std::string& title,
                   const std::string& input);

/// Says that the results are not whole any more, before the folder is written anew. Does not throw: where that fails,
/// the run cannot be stored either.
void unmark(const std::filesystem::path& folder);

/// Whether the run of this input is finished there. Throws std::runtime_error where a finished run of another model,
/// duration or version lies in the folder.
bool is_finished(const std::filesystem::path& folder, const std::string& input);

}  // namespace overbend
