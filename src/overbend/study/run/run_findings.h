/// What the histories of a run warn of, in words: results.findings.
#pragma once

#include <span>

#include "model/description/description.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Statistics of three hours from a shorter run in an irregular sea; a vessel that does not move in a sea; a tension
/// that does not stay where it is wanted; an energy balance that does not close. Reads the summaries of `results`;
/// `tension` is that of the tensioner from t = 0 on [N], rows one output step apart; none without a pipe.
void warn_of_run(const Description& description, DynamicResults& results, std::span<const double> tension);

/// A controlled tensioner in an irregular sea, whose travel (from t = 0 on, rows one output step apart [m]) another run
/// of the same length would know by no more than a tenth: what it decides hangs on little (docs/theory/dynamics.md).
/// Not of a vessel that is pulled ahead, where travel is its way.
void warn_of_tensioners_chance(const Description& description, std::span<const double> travel, DynamicResults& results);

/// Heel or trim beyond 10 deg, or heave beyond half the freeboard, of a hull that floats free: the water's restoring is
/// linear there. Reads the summaries of `results`.
void warn_of_large_motion(const VesselDescription& vessel, DynamicResults& results);

/// RAOs that do not reach the frequencies of the run's sea, and a sea of so few waves that it comes back to itself.
void warn_of_sea(const Description& description, DynamicResults& results);

/// An energy balance that does not close: the error `drift` relative to the energy exchanged. `fixed_step`: whether the
/// model gives the step.
void warn_of_energy(double drift, bool fixed_step, DynamicResults& results);

/// Change of a record over its length by a straight line through the means of eight blocks, where it is beyond chance
/// (five standard errors); else 0. [unit of the values]
double trend(std::span<const double> values);

}  // namespace overbend
