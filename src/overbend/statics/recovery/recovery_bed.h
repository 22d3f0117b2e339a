/// Contacts, free spans and extremes of pipe on an uneven bed.
#pragma once

#include "results/static_results.h"
#include "statics/equations/static_system.h"

namespace overbend {

/// Fills `results.bed` from the stations and the state, if the bed has a shape and the line touches it. Arc lengths of
/// spans are unstressed.
void recover_bed(StaticResults& results, const StaticSystem& system, const LineState& state);

/// Warns of free spans, of a crest that bends the pipe more than the sagbend, and of pipe outside the area of known
/// depths.
void warn_of_uneven_bed(const Model& model, StaticResults& results);

}  // namespace overbend
