/// The free spans of the laid pipe as a text table.
#pragma once

#include <string>

#include "results/ground_results.h"

namespace overbend {

/// Returns the text of spans.csv: a row per free span from touchdown astern, engineering units.
std::string span_table(const BedResults& bed);

}  // namespace overbend
