/// Gathers the results of variants into a comparison.
#pragma once

#include <filesystem>

#include "model/description/description.h"
#include "results/comparison_results.h"
#include "results/static_results.h"

namespace overbend {

/// A variant with its finished run.
struct FinishedVariant {
  std::string name, label;
  std::filesystem::path folder;  ///< Folder of its results.
};

/// Reads the results of all variants. The quantities are those of the compared item, then the key values gathered over
/// seeds. Throws std::runtime_error if results cannot be read.
Comparison gather_comparison(ComparisonType of, const Description& description, const StaticResults& statics,
                             const std::vector<FinishedVariant>& variants);

/// Joins neighbouring rows of equal state. `time` [s] and `state` have the same length.
std::vector<TensionerSpan> tensioner_spans(const std::vector<double>& time, const std::vector<double>& state);

}  // namespace overbend
