/// The results of a summary by object: the key `objects` of summary.json.
#pragma once

#include "base/json.h"

namespace overbend {

/// Returns lines, bodies, supports, seabed, stages and run, each with its part of the summary under the names of
/// results/fields/object_names.h; empty without results. Objects are members by their names. Code checks are not
/// repeated. In a table of units, whose lists have no names, lines are members by their kind and others by "*".
Json result_objects(const Json& summary);

/// Returns the summary with that key.
Json with_objects(Json summary);

}  // namespace overbend
