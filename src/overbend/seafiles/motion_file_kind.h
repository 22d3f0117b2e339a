/// Sources of vessel motion that a file may be, by its contents.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/enum_names.h"

namespace overbend {

/// Keys of `vessel.motion` that take a file.
enum class MotionFileKind { raos, history, coupled };

template <>
inline constexpr std::array kEnumNames<MotionFileKind> = {
    Word{MotionFileKind::raos, "raos"},
    Word{MotionFileKind::history, "history"},
    Word{MotionFileKind::coupled, "coupled"},
};

/// Returns the keys that may name the file: RAOs, a motion history, hull data; none for other files and files that
/// cannot be read. Only the beginning of a file is looked at, and its ending where the contents are plain numbers, as
/// those of WAMIT are. Files of one hull count once: the .hst of WAMIT's set, its .1 if there is none.
std::vector<MotionFileKind> find_motion_file_kinds(const std::string& path);

}  // namespace overbend
