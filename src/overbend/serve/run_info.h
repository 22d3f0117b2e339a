/// A run as the page lists it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "serve/http.h"

namespace overbend {

enum class RunState { queued, running, done, failed, cancelled };

/// Progress of a dynamic run.
struct RunNow {
  double time = 0.0, end = 0.0;  ///< [s]
  double top_tension = 0.0;      ///< [N]
  double worst_stress = 0.0;     ///< Largest von Mises stress of the line off the seabed [Pa].
};

struct RunInfo {
  std::string id;  ///< Name of its folder.
  std::string title, kind;
  std::string name, note;  ///< The user's; empty until he gives them.
  std::string model_path;  ///< Of the model's file, or where it would lie: files it mentions lie beside.
  RunState state = RunState::queued;
  double progress = 0.0;     ///< 0 to 1.
  double started = 0.0;      ///< Seconds since 1970.
  std::string message;       ///< Why it failed, and the like.
  bool has_results = false;  ///< Of the whole run, or of what was computed before it was cancelled.
  std::optional<RunNow> now;
  bool resumable = false;  ///< It can go on from a checkpoint.
  double duration = 0.0;   ///< Asked for instead of the model's [s]; 0: the model's.

  bool ended() const { return state != RunState::queued && state != RunState::running; }
};

Json run_json(const RunInfo& run);

/// In a run's folder: the model text with which the run was started.
inline constexpr const char* kModelCopy = "model.yaml";

/// Whether the folder has what it takes to resume: a sound checkpoint and the model's text.
bool can_be_resumed(const std::filesystem::path& folder);

double seconds_since_1970();

/// Leaves a note in a run's folder, so that a later start can list it.
void write_note(const RunInfo& run, const std::filesystem::path& folder);

/// The runs below a folder, by their notes and results. One that has neither is none.
std::vector<RunInfo> find_runs(const std::filesystem::path& folder);

}  // namespace overbend
