/// Writes the results of variants of one model: comparison.csv and comparison.json.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/comparison_results.h"
#include "results/static_results.h"

namespace overbend {

/// A number of a box with the description of a quantity.
struct BoxQuantity {
  SeedQuantity quantity;
  double ComparedBox::*value;
};
const std::vector<BoxQuantity>& box_quantities();

/// Returns the text of comparison.csv: a row per quantity and a column per variant, engineering units; quantities of
/// boxes are named "support/stinger 8/contact_share".
std::string comparison_table(const Comparison& comparison);

/// Returns the text of comparison.json: the static summary, and the key `comparison`; SI.
std::string comparison_summary(const StaticResults& statics, const Comparison& comparison);

/// Writes both files into an existing folder. Throws std::runtime_error if a value is not finite (and names it) or a
/// file cannot be written.
void write_comparison_files(const StaticResults& statics, const Comparison& comparison,
                            const std::filesystem::path& folder);

}  // namespace overbend
