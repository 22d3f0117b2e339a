/// Data for the report's figures.
#pragma once

#include <optional>

#include "base/json.h"
#include "model/description/description.h"
#include "results/comparison_results.h"
#include "results/seek_results.h"

namespace overbend {

/// Returns JSON: stations as columns, boxes with rows and rollers, vessel, positions and extremes; SI, points as
/// (astern of the stern shoe, to port, above the water). Long lines are thinned where they are straight, never at an
/// extreme. Dynamic results are under "dynamic", moorings under "moorings", the path of a goal seek under "seek";
/// `description` gives the surroundings.
Json report_data(const StaticResults& results, const DynamicResults* dynamic = nullptr,
                 const std::optional<Description>& description = std::nullopt, const SeekResults* seek = nullptr);

/// Returns the static data with those of a comparison under "comparison".
Json report_data(const StaticResults& results, const Comparison& comparison);

}  // namespace overbend
