/// The cases of a study in their order.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "results/study_results.h"
#include "study/cases/case_evaluation.h"

namespace overbend {

/// Numbers and what they stand for. The first axis changes slowest, then those behind it, the draws of a sample and
/// last the seeds, so that a number says the same whenever the study is read.
class StudyCases {
 public:
  explicit StudyCases(const StudyDescription& study);

  std::size_t count() const { return count_; }
  /// Cases that differ in the seed alone: number / seeds().
  std::size_t seeds() const { return seeds_.empty() ? 1 : seeds_.size(); }
  const std::vector<StudyInput>& inputs() const { return inputs_; }

  /// The case from which statics of this one start, itself solved from the base model; behind it those of the groups
  /// before and after. It is one of the eight or so around it along the last axis, and always the same: so results hang
  /// neither on the number of threads and processes nor on what was finished before. Draws at random are not near to
  /// each other: none.
  std::vector<std::size_t> anchors(std::size_t number) const;

  /// An open case, its inputs filled.
  StudyCase at(std::size_t number) const;
  CaseQuestion question(std::size_t number) const;

 private:
  /// Index of the value of every axis, then of the draw.
  std::vector<std::size_t> indices(std::size_t group) const;

  std::vector<StudyInput> inputs_;
  std::vector<std::size_t> leads_;  ///< Of every axis: the one that is crossed and takes it along, itself mostly.
  std::vector<std::uint64_t> seeds_;
  std::vector<std::vector<std::string>> drawn_words_;  ///< [draw][key]
  std::vector<std::vector<double>> drawn_;             ///< The same as numbers.
  std::size_t count_ = 1;
};

/// "cases/0012/000012345": at most a thousand entries in a folder.
std::string case_folder(std::size_t number);

}  // namespace overbend
