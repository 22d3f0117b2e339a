/// Writes what variants of one model gave: comparison.csv and comparison.json.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/comparison_results.h"
#include "results/static_results.h"

namespace overbend {

/// A number of a box, told as the quantities are.
struct BoxQuantity {
  SeedQuantity quantity;
  double ComparedBox::*value;
};
const std::vector<BoxQuantity>& box_quantities();

/// The text of comparison.csv: a row per quantity and a column per variant, engineering units; those of the boxes are
/// called "support/stinger 8/contact_share".
std::string comparison_table(const Comparison& comparison);

/// The text of comparison.json: what statics writes, and the key `comparison`; SI.
std::string comparison_summary(const StaticResults& statics, const Comparison& comparison);

/// Both files into an existing folder. Throws std::runtime_error when a value is not finite (and names it) or a file
/// cannot be written.
void write_comparison_files(const StaticResults& statics, const Comparison& comparison,
                            const std::filesystem::path& folder);

}  // namespace overbend
