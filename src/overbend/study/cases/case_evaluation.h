/// One case of a study: the base model with some keys set anew, solved, and what it says.
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
#include "study/run/lay_beside.h"
#include "study/run/peaks_of_history.h"
#include "study/run/prepared_case.h"

namespace overbend {

/// A key and its value, both as they stand in a study file: "environment.waves.hs" and "1.5 m". The key may choose
/// items of lists by index, name or pattern.
struct KeySetting {
  std::string key, value;

  bool operator==(const KeySetting&) const = default;
};

/// What distinguishes a case from the others of its study.
struct CaseQuestion {
  std::vector<KeySetting> keys;
  std::optional<std::uint64_t> seed;  ///< Of the waves; none: the model's first.
};

/// What all cases of a study are made from. Constant: several threads may use it.
class CaseBase {
 public:
  /// `base` has been read from the study's base model.
  CaseBase(Description base, StudyDescription study);

  const Description& model() const { return base_; }
  const StudyDescription& study() const { return study_; }

  /// The changes of the model's text that these settings are: one for every item that a key chooses.
  std::vector<YamlChange> changes(const std::vector<KeySetting>& keys) const;

  /// The model of a case, read and checked. `still`: without files that statics do not look at, and without its text.
  /// Throws std::runtime_error, with the reason in one line, where it is no model.
  Description described(const std::vector<KeySetting>& keys, bool still) const;

 private:
  Description base_;
  StudyDescription study_;
  YamlNode tree_;
};

/// What helps to solve a case, of another case or of the base. Empty at first; of one thread.
struct CaseNeighbour {
  std::shared_ptr<const LayStart> start;  ///< Of statics: an equilibrium close by,
  std::shared_ptr<const LayStart> other;  ///< and another, for where neither this one nor nothing leads to a solution.
  std::shared_ptr<const LayStart> found;  ///< What the last case of statics leaves for others to start from.
  std::vector<KeySetting> keys;           ///< Of what is prepared.
  std::shared_ptr<const PreparedCase> prepared;  ///< For dynamic analyses: shared by the seeds of one model.
};

/// The equilibrium of the base model as it stands, for statics to start from. Null where it has none.
std::shared_ptr<const LayStart> base_start(const CaseBase& base);

/// Prepares the model of a dynamic analysis where the neighbour has another one; says why where that cannot be.
RunEnd prepare_neighbour(const CaseBase& base, const CaseQuestion& question, CaseNeighbour& neighbour);

/// How a case is run.
struct CaseConduct {
  std::filesystem::path folder;     ///< Of the case: checkpoints of a dynamic analysis, and the files that are kept.
  bool keep = false;                ///< All result files are written.
  double checkpoint_every = 60.0;   ///< Of a dynamic analysis [s].
  std::function<bool()> stop = {};  ///< Whether to end, a dynamic analysis at a checkpoint.
  /// Told how far a dynamic analysis is that began at the time `from` [s].
  std::function<void(const DynamicProgress& at, double from)> progress = {};
  FileLock* files = nullptr;    ///< Held while HDF5 is used, which serves one thread alone.
  bool until_exceeded = false;  ///< A dynamic analysis ends once a governing check is exceeded, and has its answer.
};

/// What came of it.
struct CaseAnswer : RunEnd {  // NOLINT(bugprone-exception-escape): what moving JSON could throw it never does
  Json summary{};             ///< As summary.json; null where there is no answer.
  VerdictKind verdict = VerdictKind::not_judged;
  std::string governing{};              ///< The check that is used most; empty where none is judged.
  std::optional<double> utilisation{};  ///< Its utilisation.
  Findings findings{};
  std::vector<HistoryPeaks> peaks{};  ///< Of a dynamic analysis that leaves no files.
};

/// Solves a case: the statics, the dynamic analysis, the operation or the goal seek that the study asks for. A dynamic
/// analysis that was interrupted in the folder before goes on from its checkpoint. Does not throw: a fault of the
/// model, of the method or of the disk is the answer's ending.
///
/// Statics start from the neighbour's where there is one and are solved from nothing where that fails, so that the
/// answer agrees with one found from nothing to the accuracy of statics.
CaseAnswer evaluate_case(const CaseBase& base, const CaseQuestion& question, CaseNeighbour& neighbour,
                         const CaseConduct& conduct);

}  // namespace overbend
