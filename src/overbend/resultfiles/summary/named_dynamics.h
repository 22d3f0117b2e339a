/// Names of the results of a dynamic analysis: those of its static analysis, and those below the key `dynamic`.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace overbend {

/// As result_unit() and result_paths() of resultfiles/summary/named_results.h.
std::optional<std::string> dynamic_result_unit(const std::string& name);
std::vector<std::string> dynamic_result_paths();

}  // namespace overbend
