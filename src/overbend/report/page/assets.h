/// Files of report/ embedded by the build.
#pragma once

#include <string_view>

namespace overbend {

/// Returns the bytes of a style sheet or script by its name in report/CMakeLists.txt; empty for an unknown name.
std::string_view report_asset(std::string_view name);

}  // namespace overbend
