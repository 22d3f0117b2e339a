/// Reads spectra of the wave model SWAN: files of one frequency axis (.spc) and of frequency and direction (.sp2).
///
/// Nautical directions (NDIR) are those from which the waves come, clockwise from north; Cartesian ones (CDIR) those
/// towards which they travel, anticlockwise from x, which is taken as east.
#pragma once

#include <optional>
#include <string_view>

#include "base/diagnostics.h"
#include "seafiles/wave_file_content.h"

namespace overbend {

/// Returns true if the text begins with SWAN.
bool is_swan(std::string_view text);

/// Reads the spectrum of the chosen time and location. Densities over direction are summed over sectors of equal width,
/// no tail is added; the exponent of a directional spreading sigma is s = 2/sigma^2 - 1, by the circular standard
/// deviation. Errors name line, value and what is expected there; then nothing is returned.
std::optional<WaveFileContent> read_swan_spectrum(const WaveFileRequest& request, Diagnostics& diagnostics);

}  // namespace overbend
