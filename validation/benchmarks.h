/// The single-effect problems of cases_public.json.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace overbend::validation {

/// `expected` of the benchmark; throws where it is not there.
nlohmann::json benchmark(const char* name);

}  // namespace overbend::validation
