/// Reads a user's wave spectrum.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "model/description/description.h"

namespace overbend {

/// Reads CSV text: a header that names the columns and with them the units, `omega_rad_s,density_m2s` or
/// `frequency_hz,density_m2_hz`, then two rows or more by rising frequency. Lines that begin with # are passed over.
/// Densities are one-sided. `path` names the text in messages; every error is reported with its line. Empty after a
/// fault.
std::vector<SpectrumPoint> read_spectrum_text(const std::string& text, const std::string& path,
                                              Diagnostics& diagnostics);

/// Fills `waves.spectrum`, and `waves.hs` with its significant height, from `waves.spectrum_file` where the waves are a
/// user's. A file that is not there leaves it empty without a complaint, which the checks make.
void read_wave_spectrum(WavesDescription& waves, Diagnostics& diagnostics);

}  // namespace overbend
