/// Contacts, free spans and extremes of the pipe that lies on an uneven bed.
#pragma once

#include "results/static_results.h"
#include "statics/equations/static_system.h"

namespace overbend {

/// Fills `results.bed` from the stations and the state, where the bed has a shape and the line touches it. Arc lengths
/// of spans are unstressed.
void recover_bed(StaticResults& results, const StaticSystem& system, const LineState& state);

/// What the user should know of it: spans, a crest that bends the pipe more than the sagbend, a pipe that leaves the
/// area whose depths are known.
void warn_of_uneven_bed(const Model& model, StaticResults& results);

}  // namespace overbend
