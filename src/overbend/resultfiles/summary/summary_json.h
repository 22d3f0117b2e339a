/// Parts of summary.json.
#pragma once

#include <string>

#include "base/json.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Returns the summary of a static analysis.
Json static_summary_json(const StaticResults& results);

/// Returns the same as text: key results in SI.
std::string static_summary(const StaticResults& results);

/// Adds the equilibrium of a moored vessel and its lines to the static part; stages of its operation next to it. Values
/// of a laid pipe, balance and iterations are kept.
void add_moorings(const MooringResults& results, Json& summary);
/// Adds static.lines, if there are stand-alone lines, and dynamic.lines.
void add_lines(const StaticResults& results, Json& summary);
void add_lines_in_time(const DynamicResults& results, Json& summary);
/// Adds static.bodies and dynamic.bodies, if lines are connected to bodies.
void add_bodies(const StaticResults& results, Json& summary);
void add_bodies_in_time(const DynamicResults& results, Json& summary);
/// Adds static.hull.
void add_hull(const HullResults& hull, Json& summary);
/// Adds dynamic.vessel and dynamic.moorings, if the vessel floats.
void add_moored_dynamics(const DynamicResults& results, Json& summary);

/// Adds dynamic.stinger, if it has hinges.
void add_stinger_dynamics(const DynamicResults& results, Json& summary);

/// Adds dynamic.fatigue, if the model requests it.
void add_fatigue(const DynamicResults& results, Json& summary);

/// Returns the text of a summary with its results by object (resultfiles/summary/result_objects.h).
std::string summary_text(const Json& summary);

}  // namespace overbend
