/// Warnings from the histories of a run: results.findings.
#pragma once

#include <span>

#include "model/description/description.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Warns of three-hour statistics from a shorter run in an irregular sea, a vessel that does not move in a sea, a
/// tension that does not stay at its target, and an energy balance that does not close. Reads the summaries of
/// `results`; `tension` is that of the tensioner from t = 0 on [N], rows one output step apart; empty without a pipe.
void warn_of_run(const Description& description, DynamicResults& results, std::span<const double> tension);

/// Warns of a controlled tensioner in an irregular sea whose travel (from t = 0 on, rows one output step apart [m]) has
/// a standard deviation that another run of the same length would reproduce only to more than a tenth: its actions are
/// sensitive to small changes (docs/theory/dynamics.md). Not for a pull-ahead, in which travel is the vessel's advance.
void warn_of_tensioner_uncertainty(const Description& description, std::span<const double> travel,
                                   DynamicResults& results);

/// Warns of heel or trim beyond 10 deg, or heave beyond half the freeboard, of a floating hull: hydrostatic restoring
/// is linearised. Reads the summaries of `results`.
void warn_of_large_motion(const VesselDescription& vessel, DynamicResults& results);

/// Warns of RAOs that do not cover the frequencies of the sea, and of a sea with so few waves that it repeats itself.
void warn_of_sea(const Description& description, DynamicResults& results);

/// Warns of an energy balance that does not close: the error `drift` relative to the energy exchanged. `fixed_step` is
/// true if the model gives the time step.
void warn_of_energy(double drift, bool fixed_step, DynamicResults& results);

/// Change of a record over its length by a straight line through the means of eight blocks, if it is significant (five
/// standard errors); else 0. [unit of the values]
double trend(std::span<const double> values);

}  // namespace overbend
