/// Reads text files of the National Data Buoy Center (NDBC).
///
/// Sea states: rows of WVHT, DPD, APD and MWD. Spectral density: a table over frequency, or realtime rows of values
/// with their frequencies in brackets. Next to a density file, directions and their spread: NAME.swdir and NAME.swr1 of
/// NAME.data_spec, or the files with d and j in place of w of a yearly file such as 46042w2019.txt. MM, 99 and 999 are
/// missing values. Directions are those from which the waves come, clockwise from north.
#pragma once

#include <optional>
#include <string_view>

#include "base/diagnostics.h"
#include "seafiles/wave_file_content.h"

namespace overbend {

/// Returns true if the first line is the header of such a file.
bool is_ndbc(std::string_view text);

/// Reads the row of the chosen time. Errors name line, value and frequency; then nothing is returned. The spreading is
/// s = r1/(1 - r1) of cos^2s of half the angle, which has the first moment r1 [longuethiggins1963].
std::optional<WaveFileContent> read_ndbc(const WaveFileRequest& request, Diagnostics& diagnostics);

}  // namespace overbend
