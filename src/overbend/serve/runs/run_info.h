/// A run in the list of the page.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "serve/http/http.h"
#include "study/run/run_folder.h"

namespace overbend {

/// Progress of a dynamic run.
struct RunProgress {
  double time = 0.0, end = 0.0;  ///< [s]
  double top_tension = 0.0;      ///< [N]
  double worst_stress = 0.0;     ///< Largest von Mises stress of the line off the seabed [Pa].
};

/// A run with its record on disk.
struct RunInfo : RunRecord {
  std::string id;                     ///< Name of its folder; for a case of a study "STUDY~CASE".
  std::string parent;                 ///< Id of the study, for a case.
  bool has_results = false;           ///< True if there are results, complete or up to cancellation.
  bool resumable = false;             ///< True if it can continue from a checkpoint.
  std::string verdict;                ///< Kind of its verdict, such as "passed"; empty for a study or without results.
  std::string verdict_text;           ///< The verdict as a sentence.
  std::optional<double> utilisation;  ///< Maximum utilisation of its governing code checks.
  std::optional<RunProgress> live_progress;

  bool ended() const { return state != RunState::queued && state != RunState::running; }
  bool is_study() const { return kind == "seeds" || kind == "comparison"; }
  bool is_campaign() const { return kind == "study"; }  ///< True for a study file; its cases are not listed as runs.
};

/// Returns the cases of a study with their default state; empty for other runs.
std::vector<RunInfo> make_study_cases(const RunInfo& study);

/// Returns the folder of a run below the folder of all runs.
std::filesystem::path find_run_folder(const RunInfo& run, const std::filesystem::path& runs);

Json run_json(const RunInfo& run);

/// File in a run's folder with the model text of the run.
inline constexpr const char* kModelCopy = "model.yaml";
/// For a study file: its text, and the subfolder with its cases and tables.
inline constexpr const char* kStudyCopy = "study.yaml";
inline constexpr const char* kStudyFolder = "study";

/// True if the run's folder allows resuming: it has the model text and a valid checkpoint (for a study, a checkpoint of
/// a case or a finished case).
bool can_be_resumed(const RunInfo& run, const std::filesystem::path& runs);

/// Reads verdict and maximum utilisation from a summary; those of the time-domain simulation if there is one.
void add_verdict(RunInfo& run, const Json& summary);
/// The same from the summary file in the run's folder, if it exists.
void read_verdict(RunInfo& run, const std::filesystem::path& folder);

/// Returns the current time in seconds since 1970.
double seconds_since_1970();

/// Writes the record into a run's folder, so that a later start can list it. Its description of the input of the
/// results is kept, because the solver writes it.
void keep_record(const RunInfo& run, const std::filesystem::path& folder);

/// Returns the runs below a folder and the cases of studies that have a record or results.
std::vector<RunInfo> find_runs(const std::filesystem::path& folder);

}  // namespace overbend
