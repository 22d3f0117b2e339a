/// The cases of a study in order.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "results/study_results.h"
#include "study/cases/case_evaluation.h"

namespace overbend {

/// Case numbers and their inputs. The first axis varies slowest, then the following ones, then the draws of a sample
/// and last the seeds, so that a number has the same meaning whenever the study is read.
class StudyCases {
 public:
  explicit StudyCases(const StudyDescription& study);

  std::size_t count() const { return count_; }
  /// Number of seeds; cases that differ only in the seed have the same number / seeds().
  std::size_t seeds() const { return seeds_.empty() ? 1 : seeds_.size(); }
  const std::vector<StudyInput>& inputs() const { return inputs_; }

  /// Returns the case from which the statics of this one start, itself solved from the base model; then those of the
  /// previous and next blocks. An anchor is one of about eight neighbours along the last axis, and always the same:
  /// results depend neither on the number of threads and processes nor on what was finished before. Random draws are
  /// not neighbours: empty.
  std::vector<std::size_t> anchors(std::size_t number) const;

  /// Returns an open case with its inputs.
  StudyCase at(std::size_t number) const;
  /// Returns the keys and the seed of a case.
  CaseInput question(std::size_t number) const;

 private:
  /// Index of the value of every axis, then of the draw.
  std::vector<std::size_t> indices(std::size_t group) const;

  std::vector<StudyInput> inputs_;
  std::vector<std::size_t> leads_;  ///< For every axis, the crossed axis that it varies with; usually itself.
  std::vector<std::uint64_t> seeds_;
  std::vector<std::vector<std::string>> drawn_texts_;  ///< [draw][key]
  std::vector<std::vector<double>> drawn_;             ///< The same as numbers.
  std::size_t count_ = 1;
};

/// "cases/0012/000012345": at most a thousand entries in a folder.
std::string case_folder(std::size_t number);

}  // namespace overbend
