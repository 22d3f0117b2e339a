/// Version of the program, set by the build.
#pragma once

namespace overbend {

inline constexpr const char* kVersion = OVERBEND_VERSION;

}  // namespace overbend
