/// From the results of variants to what they say beside each other.
#pragma once

#include <filesystem>

#include "model/description/description.h"
#include "results/comparison_results.h"
#include "results/static_results.h"

namespace overbend {

/// One variant as its run left it.
struct FinishedVariant {
  std::string name, words;
  std::filesystem::path folder;  ///< Of its results.
};

/// Reads the results of all variants. The quantities are those of the thing compared, then the key values that several
/// seeds are gathered by. Throws std::runtime_error where results cannot be read.
Comparison gather_comparison(ComparisonOf of, const Description& description, const StaticResults& statics,
                             const std::vector<FinishedVariant>& variants);

/// Neighbouring rows of one state joined. `time` and `state` are of one length.
std::vector<TensionerSpan> tensioner_spans(const std::vector<double>& time, const std::vector<double>& state);

}  // namespace overbend
