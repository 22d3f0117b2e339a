/// A study as Python holds it: what is asked for, and the folder that it runs into.
#pragma once

#include <atomic>
#include <mutex>

#include "python/model_handle.h"
#include "study/campaign/study_runner.h"

namespace overbend {

/// Cases of a model, ready to be run. Constant.
class StudyHandle {
 public:
  /// A study file. Throws UnreadableModel.
  static std::shared_ptr<StudyHandle> read(const std::string& file);
  /// The text of a study file on a model. Both will lie in the folder as study.yaml, whose key `base` names model.yaml,
  /// so that the command line can go on with what was begun here. Throws UnreadableModel.
  static std::shared_ptr<StudyHandle> of(const ModelHandle& model, const std::string& text,
                                         const std::filesystem::path& folder);

  const CaseBase& base() const { return base_; }
  const StudyCases& cases() const { return cases_; }

  /// Begins the study in the folder, or finds it there. Throws UnusableFolder where something else is in it.
  void open(const std::filesystem::path& folder) const;

 private:
  StudyHandle(Description base, StudyDescription study)
      : base_(std::move(base), std::move(study)), cases_(base_.study()) {}

  CaseBase base_;
  StudyCases cases_;
  bool keeps_files_ = false;  ///< Study and model are written beside the results.
};

/// Counts what the threads of a study tell, for the thread that waits.
class CaseCount : public StudyWatch {
 public:
  bool stop() override { return stopped; }
  void begin(std::size_t open, std::size_t finished) override;
  void ended(const StudyCase& one) override;
  void tried(const TrialTold& trial) override;

  struct Told {
    std::size_t done = 0, cases = 0, failed = 0;  ///< `cases` is 0 where it is not known how many there will be.
  };
  Told told() const;

  std::atomic<bool> stopped = false;

 private:
  mutable std::mutex mutex_;
  Told told_;
};

}  // namespace overbend
