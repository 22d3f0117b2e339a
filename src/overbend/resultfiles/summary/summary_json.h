/// Parts of summary.json.
#pragma once

#include <string>

#include "base/json.h"
#include "results/dynamic_results.h"

namespace overbend {

/// What a static analysis writes.
Json static_summary_json(const StaticResults& results);

/// The same as text: key results in SI.
std::string static_summary(const StaticResults& results);

/// Where a moored vessel lies and its lines, into the part of the statics; stages of its operation next to it. What
/// is told of a laid pipe stays, balance and iterations.
void add_moorings(const MooringResults& results, Json& summary);
/// static.lines, where lines stand by themselves, and dynamic.lines.
void add_lines(const StaticResults& results, Json& summary);
void add_lines_in_time(const DynamicResults& results, Json& summary);
/// static.bodies and dynamic.bodies, where lines are on bodies.
void add_bodies(const StaticResults& results, Json& summary);
void add_bodies_in_time(const DynamicResults& results, Json& summary);
/// static.hull.
void add_hull(const HullResults& hull, Json& summary);
/// dynamic.vessel and dynamic.moorings, where the vessel floats.
void add_moored_dynamics(const DynamicResults& results, Json& summary);

/// dynamic.stinger, where it turns on its hinges.
void add_stinger_dynamics(const DynamicResults& results, Json& summary);

/// dynamic.fatigue, where the model asks for it.
void add_fatigue(const DynamicResults& results, Json& summary);

/// The text of a summary with its results by object (resultfiles/summary/result_objects.h).
std::string summary_text(const Json& summary);

}  // namespace overbend
