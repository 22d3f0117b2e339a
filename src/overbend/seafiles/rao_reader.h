/// Reads displacement RAOs from files of several programs into the internal convention (model/waves/rao_table.h).
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "model/waves/rao_table.h"
#include "seafiles/rao_convention.h"

namespace overbend {

/// Reads an RAO file. Its contents decide how (seafiles/hull_file_kind.h), or else its ending:
///
/// - `.csv`: columns heading_deg, one of omega_rad_s, frequency_hz, period_s, then dof (surge to yaw, or 1 to 6),
///   amplitude, one of phase_deg, phase_rad; comments "# key: value" in its header may define any key of the convention
///   and "# reference: x y z", "# wave_origin: x y" in metres of frame V; "# assumption: SENTENCE" is reported with the
///   results;
/// - `.4`: WAMIT motion file (PER BETA I MOD PHA RE IM) with periods; rows with PER <= 0 are skipped;
/// - formatted output of WAMIT (`.out`), listing of AQWA (`.LIS`), motions of HydroStar (`.rao`);
/// - `.yml`, `.yaml`: OrcaFlex text data file with displacement RAOs of a vessel type.
///
/// `user_settings` override the statements of the file, which override the named set. The water `depth` [m] determines
/// the wave number if rotations are per slope. Errors go to `diagnostics` with file and line, and nothing is returned.
std::optional<RaoTable> read_raos(const std::string& file, const RaoSettings& user_settings, double depth,
                                  Diagnostics& diagnostics);

/// The same for the text of a file; `file` gives the ending.
std::optional<RaoTable> read_rao_text(const std::string& text, const std::string& file,
                                      const RaoSettings& user_settings, double depth, Diagnostics& diagnostics);

}  // namespace overbend
