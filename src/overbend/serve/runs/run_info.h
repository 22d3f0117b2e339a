/// A run as the page lists it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "serve/http/http.h"
#include "study/run/run_folder.h"

namespace overbend {

/// Progress of a dynamic run.
struct RunNow {
  double time = 0.0, end = 0.0;  ///< [s]
  double top_tension = 0.0;      ///< [N]
  double worst_stress = 0.0;     ///< Largest von Mises stress of the line off the seabed [Pa].
};

/// With its record, which is what stays of it on disk.
struct RunInfo : RunRecord {
  std::string id;                     ///< Name of its folder; of a case of a study "STUDY~CASE".
  std::string parent;                 ///< Of a case: id of the study.
  bool has_results = false;           ///< Of the whole run, or of what was computed before it was cancelled.
  bool resumable = false;             ///< It can go on from a checkpoint.
  std::string verdict;                ///< Kind of its verdict, such as "passed"; empty without results and of a study.
  std::string verdict_text;           ///< The verdict as a sentence.
  std::optional<double> utilisation;  ///< Largest of its governing code checks.
  std::optional<RunNow> now;

  bool ended() const { return state != RunState::queued && state != RunState::running; }
  bool is_study() const { return kind == "seeds" || kind == "comparison"; }
  bool is_matrix() const { return kind == "study"; }  ///< A study file's: its cases are no runs of the list.
};

/// The cases of a study, with nothing said of how they stand; none of another run.
std::vector<RunInfo> cases_of(const RunInfo& study);

/// Where a run lies below the folder of all.
std::filesystem::path folder_of(const RunInfo& run, const std::filesystem::path& runs);

Json run_json(const RunInfo& run);

/// In a run's folder: the model text with which the run was started.
inline constexpr const char* kModelCopy = "model.yaml";
/// Of a study file's: its text, and the folder within with its cases and tables.
inline constexpr const char* kStudyCopy = "study.yaml";
inline constexpr const char* kStudyFolder = "study";

/// Whether the folder below `runs` has what it takes to resume: a sound checkpoint, of a study one of a case or a
/// finished case, and the model's text.
bool can_be_resumed(const RunInfo& run, const std::filesystem::path& runs);

/// Verdict and largest utilisation, of the time-domain simulation where the summary has one.
void add_verdict(RunInfo& run, const Json& summary);
/// The same from the summary file in the run's folder; nothing where it has none.
void read_verdict(RunInfo& run, const std::filesystem::path& folder);

double seconds_since_1970();

/// Leaves the record in a run's folder, so that a later start can list it. What it says of the input of the results is
/// kept: that is written by who computes them.
void keep_record(const RunInfo& run, const std::filesystem::path& folder);

/// The runs below a folder and the cases of studies, by their records and results. One that has neither is none.
std::vector<RunInfo> find_runs(const std::filesystem::path& folder);

}  // namespace overbend
