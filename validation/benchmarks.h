/// The single-effect problems of cases_public.json.
#pragma once

#include "base/json.h"

namespace overbend::validation {

/// `expected` of the benchmark; throws where it is not there.
Json benchmark(const char* name);

}  // namespace overbend::validation
