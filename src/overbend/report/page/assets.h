/// Files of report/ that the build embeds.
#pragma once

#include <string_view>

namespace overbend {

/// The bytes of a style sheet or script by its name in report/CMakeLists.txt; empty for a name that is not there.
std::string_view report_asset(std::string_view name);

}  // namespace overbend
