/// Reads a user-defined wave spectrum.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "model/description/description.h"

namespace overbend {

/// Reads CSV text: a header that names columns and units, `omega_rad_s,density_m2s` or `frequency_hz,density_m2_hz`,
/// then two or more rows with increasing frequency. Lines that begin with # are skipped. Densities are one-sided.
/// `path` names the text in messages; every error is reported with its line. Returns an empty list after an error.
std::vector<SpectrumPoint> read_spectrum_text(const std::string& text, const std::string& path,
                                              Diagnostics& diagnostics);

}  // namespace overbend
