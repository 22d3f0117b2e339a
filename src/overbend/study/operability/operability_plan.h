/// What the search for limits of a study has to try.
#pragma once

#include <string>
#include <vector>

#include "study/cases/case_evaluation.h"
#include "study/cases/study_cases.h"
#include "study/operability/operability_search.h"

namespace overbend {

/// Cells and values of a chart. The axis that is searched gives the bounds; the values tried lie between them in steps
/// of the resolution, with the largest bound as the last.
class OperabilityPlan {
 public:
  /// `study` asks for operability, over an axis with numbers that nothing changes together with.
  explicit OperabilityPlan(const StudyDescription& study);

  const OperabilityGrid& grid() const { return grid_; }
  const StudyInput& over() const { return over_; }
  /// The crossed axes of the chart, without those that change together with one.
  const std::vector<StudyInput>& axes() const { return axes_; }
  const std::vector<double>& values() const { return values_; }  ///< [SI], ascending.
  const std::vector<std::uint64_t>& seeds() const { return seeds_; }

  std::size_t cells() const;
  /// Index of the value of every axis.
  std::vector<std::size_t> at(std::size_t cell) const;
  /// What is set in the model, and the seed.
  CaseQuestion question(std::size_t cell, std::size_t value, std::size_t seed) const;
  /// Its folder within the study's: "trials/0012/007-seed-3".
  std::string folder(std::size_t cell, std::size_t value, std::size_t seed) const;

 private:
  std::string value_words(std::size_t value) const;

  StudyInput over_;
  std::vector<StudyInput> axes_;
  std::vector<std::vector<StudyInput>> together_;  ///< With each of axes_, itself first.
  std::vector<double> values_;
  std::vector<std::uint64_t> seeds_;
  OperabilityGrid grid_;
};

/// Values from the least to the largest in equal steps, the largest always among them.
std::vector<double> searched_values(double least, double largest, double step);

}  // namespace overbend
