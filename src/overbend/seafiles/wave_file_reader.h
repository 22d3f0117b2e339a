/// Reads the file that a group of waves names.
#pragma once

#include "base/diagnostics.h"
#include "model/description/waves_description.h"

namespace overbend {

/// Fills spectrum, directions, height and period of waves from `waves.spectrum_file`, or their record from
/// `waves.elevation_file`.
///
/// The format follows from the first line: NDBC text (seafiles/ndbc_reader.h), SWAN spectra
/// (seafiles/swan_spectrum_reader.h), otherwise CSV (seafiles/spectrum_reader.h). A file of sea states is one for waves
/// whose type gives the shape of the spectrum, and a file of a spectrum is one for waves of type user: the other way
/// round is an error. If the file does not exist, nothing is filled and there is no error: the input checks report it.
void read_wave_file(WavesDescription& waves, Diagnostics& diagnostics);

}  // namespace overbend
