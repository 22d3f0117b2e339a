/// One case of a study: the base model with changed keys, its solution and its results.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/file_lock.h"
#include "base/finding.h"
#include "base/yaml_document.h"
#include "model/description/study_description.h"
#include "modelfile/yaml/yaml_edit.h"
#include "recording/run_dynamics.h"
#include "resultfiles/summary/summary_json.h"
#include "results/verdict.h"
#include "study/run/history_peaks.h"
#include "study/run/prepared_case.h"
#include "study/run/warm_start.h"

namespace overbend {

/// A key and its value as written in a study file: "environment.waves.hs" and "1.5 m". The key may select items of
/// lists by index, name or pattern.
struct KeySetting {
  std::string key, value;

  bool operator==(const KeySetting&) const = default;
};

/// Inputs that distinguish a case from the others of its study.
struct CaseInput {
  std::vector<KeySetting> keys;
  std::optional<std::uint64_t> seed;  ///< Seed of the waves; if empty, the first seed of the model.
};

/// Base of all cases of a study. Constant: several threads may use it.
class CaseBase {
 public:
  /// `base` has been read from the study's base model.
  CaseBase(Description base, StudyDescription study);

  const Description& model() const { return base_; }
  const StudyDescription& study() const { return study_; }

  /// Returns the changes of the model text for these settings: one for every item that a key selects.
  std::vector<YamlChange> changes(const std::vector<KeySetting>& keys) const;

  /// Returns the model of a case, read and checked. `statics_only`: without files that statics do not use, and without
  /// its text. Throws std::runtime_error, with a one-line reason, if the model is invalid.
  Description described(const std::vector<KeySetting>& keys, bool statics_only) const;

 private:
  Description base_;
  StudyDescription study_;
  YamlNode tree_;
};

/// Warm start of a case from another case or from the base. Initially empty; used by one thread.
struct CaseWarmStart {
  std::shared_ptr<const LayWarmStart> start;  ///< Start of statics: a neighbouring equilibrium.
  std::shared_ptr<const LayWarmStart>
      fallback_start;  ///< Another one, if neither the first nor a cold start leads to a solution.
  std::shared_ptr<const LayWarmStart> found;     ///< Equilibrium of the last static case, from which others may start.
  std::vector<KeySetting> keys;                  ///< Keys of the prepared case.
  std::shared_ptr<const PreparedCase> prepared;  ///< Prepared case of dynamic analyses, shared by the seeds of one
                                                 ///< model.
};

/// Returns the equilibrium of the unchanged base model as a start for statics; null if it has none.
std::shared_ptr<const LayWarmStart> base_start(const CaseBase& base);

/// Prepares the model of a dynamic analysis if the prepared one is another; returns an error if that fails.
RunResult prepare_warm_start(const CaseBase& base, const CaseInput& question, CaseWarmStart& neighbour);

/// Options for running a case.
struct CaseEvaluationOptions {
  std::filesystem::path folder;     ///< Folder of the case, for checkpoints of a dynamic analysis and for the files
                                    ///< that are kept.
  bool keep = false;                ///< All result files are written.
  double checkpoint_every = 60.0;   ///< Checkpoint interval of a dynamic analysis [s].
  std::function<bool()> stop = {};  ///< True to stop; a dynamic analysis stops at a checkpoint.
  /// True to abandon also what leaves no checkpoint: statics, files that are written. By default like `stop`.
  std::function<bool()> abandon = {};
  /// Called with the progress of a dynamic analysis that started at the time `from` [s].
  std::function<void(const DynamicProgress& state, double from)> progress = {};
  FileLock* files = nullptr;    ///< Locked while HDF5 is used, which serves one thread only.
  bool until_exceeded = false;  ///< A dynamic analysis ends successfully once a governing check is exceeded.
};

/// Result of a case.
struct CaseResult : RunResult {  // NOLINT(bugprone-exception-escape): what moving JSON could throw it never does
  Json summary{};                ///< Contents of summary.json; null without a result.
  VerdictKind verdict = VerdictKind::not_judged;
  std::string governing{};              ///< Check with the highest utilisation; empty if none is evaluated.
  std::optional<double> utilisation{};  ///< Its utilisation.
  Findings findings{};
  std::vector<HistoryPeaks> peaks{};  ///< Peaks of a dynamic analysis that leaves no files.
};

/// Solves a case: the statics, the dynamic analysis, the operation or the goal seek that the study requests. A dynamic
/// analysis that was interrupted in the folder before resumes from its checkpoint. Does not throw: an error of the
/// model, the method or the disk is the status of the result.
///
/// Statics start from the neighbouring solution if there is one and are solved from scratch if that fails, so that the
/// result agrees with one found from scratch to the accuracy of statics.
CaseResult evaluate_case(const CaseBase& base, const CaseInput& question, CaseWarmStart& neighbour,
                         const CaseEvaluationOptions& conduct);

}  // namespace overbend
