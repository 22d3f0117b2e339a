/// Displacement RAOs from files of several programs, into the convention of the house (model/waves/rao_table.h).
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "model/waves/rao_table.h"
#include "seafiles/rao_convention.h"

namespace overbend {

/// Reads an RAO file by its ending:
///
/// - `.csv`: columns heading_deg, one of omega_rad_s, frequency_hz, period_s, then dof (surge to yaw, or 1 to 6),
///   amplitude, one of phase_deg, phase_rad; remarks "# key: word" in its header may define any key of the convention
///   and
///   "# reference: x y z", "# wave_origin: x y" in metres of frame V; "# assumption: SENTENCE" is reported with
///   results;
/// - `.4`: WAMIT's motion file (PER BETA I MOD PHA RE IM), periods; rows with PER <= 0 are passed over;
/// - `.yml`, `.yaml`: text data file of OrcaFlex with a vessel type's displacement RAOs.
///
/// What `given` says wins over what the file says, and that over the named set. `depth` [m] gives the wave number where
/// rotations are per slope. Faults go to `diagnostics` with file and line, and nothing is returned.
std::optional<RaoTable> read_raos(const std::string& file, const RaoSettings& given, double depth,
                                  Diagnostics& diagnostics);

/// The same for the text of a file that has been read already; `file` gives the ending.
std::optional<RaoTable> read_rao_text(const std::string& text, const std::string& file, const RaoSettings& given,
                                      double depth, Diagnostics& diagnostics);

}  // namespace overbend
