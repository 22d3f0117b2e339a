/// Times of files.
#pragma once

#include <chrono>
#include <filesystem>

namespace overbend {

/// Returns the time of a file since 1970, in whole seconds.
inline double seconds_since_1970(std::filesystem::file_time_type time) {
#if defined(_LIBCPP_VERSION)  // counts from 1970, and converts only from version 19 on
  const auto since = time.time_since_epoch();
#else
  const auto since = std::chrono::file_clock::to_sys(time).time_since_epoch();
#endif
  return static_cast<double>(std::chrono::duration_cast<std::chrono::seconds>(since).count());
}

}  // namespace overbend
