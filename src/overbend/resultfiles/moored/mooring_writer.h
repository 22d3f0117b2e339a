/// Writes what a static analysis of a hull and its mooring lines found: summary.json, moorings.csv, results.h5.
#pragma once

#include <filesystem>
#include <string>

#include "model/description/description.h"
#include "results/moored_dynamics.h"
#include "results/mooring_results.h"

namespace overbend {

/// The text of summary.json: static.vessel, static.moorings and operation.stages in SI.
std::string mooring_summary(const MooringResults& results);

/// The text of moorings.csv: a row per state and line, engineering units. `in_time`: of a dynamic analysis that began
/// at the rest, in further columns of the rest's rows.
std::string moorings_table(const MooringResults& results, const std::vector<MooringLineDynamics>& in_time = {});

/// Throw std::runtime_error that names the quantity which is no number.
void require_finite(const MooringResults& results);
void require_finite(const HullResults& hull);

/// Writes all files into an existing folder. Throws std::runtime_error when a quantity is not finite (and names it) or
/// a file cannot be written.
void write_mooring_files(const MooringResults& results, const Description& description,
                         const std::filesystem::path& folder);

}  // namespace overbend
