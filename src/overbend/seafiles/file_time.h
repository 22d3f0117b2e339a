/// Times in the files of buoys and wave models.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"

namespace overbend {

/// Year, month, day, hour, minute, second, as the file gives them: usually UTC.
using FileTime = std::array<int, 6>;

/// Parses year, month, day and, if given, hour, minute and second, separated by anything but digits, or as
/// 20260601.094000. Years of two digits are 1970 to 2069. Nothing if it is no date.
std::optional<FileTime> parse_file_time(std::string_view text);

/// Returns "2026-06-01 09:40", with seconds if there are any.
std::string file_time_label(const FileTime& time);

/// Selection of a time in a file.
struct TimeChoice {
  std::string path;    ///< Path of the file, for messages.
  std::string key;     ///< Key of the model file, "environment.waves.time".
  std::string wanted;  ///< Its value; empty if it is not given.
};

/// Returns the index of the chosen time; the only one if none is given. Errors: no times, several without a choice, and
/// a time that is not among them.
std::optional<std::size_t> choose_time(const std::vector<FileTime>& times, const TimeChoice& choice,
                                       Diagnostics& diagnostics);

}  // namespace overbend
