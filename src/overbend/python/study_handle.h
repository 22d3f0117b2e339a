/// A study in Python.
#pragma once

#include <atomic>
#include <mutex>

#include "python/model_handle.h"
#include "study/campaign/study_runner.h"

namespace overbend {

/// Cases of a model, ready to run; immutable.
class StudyHandle {
 public:
  /// Reads a study file. Throws UnreadableModel.
  static std::shared_ptr<StudyHandle> read(const std::string& file);
  /// Makes a study from the text of a study file and a model. Both are written to the folder as study.yaml (whose key
  /// `base` names model.yaml) and model.yaml, so that the command line can continue the study. Throws UnreadableModel.
  static std::shared_ptr<StudyHandle> of(const ModelHandle& model, const std::string& text,
                                         const std::filesystem::path& folder);

  const CaseBase& base() const { return base_; }
  const StudyCases& cases() const { return cases_; }

  /// Creates the study in the folder or continues it. Throws UnusableFolder if the folder contains something else.
  void open(const std::filesystem::path& folder) const;

 private:
  StudyHandle(Description base, StudyDescription study)
      : base_(std::move(base), std::move(study)), cases_(base_.study()) {}

  CaseBase base_;
  StudyCases cases_;
  bool keeps_files_ = false;  ///< Write study and model next to the results.
};

/// Counts the cases reported by the threads of a study, for the waiting thread.
class CaseCounter : public StudyObserver {
 public:
  bool stop() override { return stopped; }
  void begin(std::size_t open, std::size_t finished) override;
  void ended(const StudyCase& study_case) override;
  void tried(const TrialReport& trial) override;

  struct Tally {
    std::size_t done = 0, cases = 0, failed = 0;  ///< `cases` is 0 if the total is unknown.
  };
  Tally tally() const;

  std::atomic<bool> stopped = false;

 private:
  mutable std::mutex mutex_;
  Tally tally_;
};

}  // namespace overbend
