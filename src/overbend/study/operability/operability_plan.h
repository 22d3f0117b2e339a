/// Cells and trial values of a limit search.
#pragma once

#include <string>
#include <vector>

#include "study/cases/case_evaluation.h"
#include "study/cases/study_cases.h"
#include "study/operability/operability_search.h"

namespace overbend {

/// Cells and values of a chart. The searched axis gives the bounds; the trial values lie between them in steps of the
/// resolution, with the upper bound as the last.
class OperabilityPlan {
 public:
  /// `study` requests operability over a numeric axis with which no other axis varies.
  explicit OperabilityPlan(const StudyDescription& study);

  const OperabilityGrid& grid() const { return grid_; }
  const StudyInput& over() const { return over_; }
  /// The crossed axes of the chart, without axes that vary with one of them.
  const std::vector<StudyInput>& axes() const { return axes_; }
  const std::vector<double>& values() const { return values_; }  ///< [SI], ascending.
  const std::vector<std::uint64_t>& seeds() const { return seeds_; }

  /// Number of cells of the chart.
  std::size_t cells() const;
  /// Returns the index of the value of every axis.
  std::vector<std::size_t> at(std::size_t cell) const;
  /// Returns the keys to set in the model, and the seed.
  CaseInput question(std::size_t cell, std::size_t value, std::size_t seed) const;
  /// Folder of a trial within the study's: "trials/0012/007-seed-3".
  std::string folder(std::size_t cell, std::size_t value, std::size_t seed) const;

 private:
  std::string value_text(std::size_t value) const;

  StudyInput over_;
  std::vector<StudyInput> axes_;
  std::vector<std::vector<StudyInput>> together_;  ///< Inputs that vary with each of axes_, itself first.
  std::vector<double> values_;
  std::vector<std::uint64_t> seeds_;
  OperabilityGrid grid_;
};

/// Returns values from `from` to `to` in equal steps; the last value is always `to`.
std::vector<double> searched_values(double from, double to, double step);

}  // namespace overbend
