/// The results of a summary by object: the key `objects` of summary.json.
#pragma once

#include "base/json.h"

namespace overbend {

/// lines, bodies, supports, seabed, stages and run, each with what the summary has of it under the names of
/// results/fields/object_names.h; empty where it has nothing of them. Objects are members by their names. Code checks
/// are not repeated. Of a table of units, in whose lists nothing has a name, lines stand by their kind and others by
/// "*".
Json result_objects(const Json& summary);

/// The summary with that key.
Json with_objects(Json summary);

}  // namespace overbend
