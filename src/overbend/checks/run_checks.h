/// Table of code checks of a static state or of a dynamic run.
#pragma once

#include "model/model.h"
#include "results/dynamic_results.h"
#include "results/line_results.h"
#include "results/static_results.h"

namespace overbend {

/// Returns the checks of a static state, whose stations must be set.
CheckTable check_statics(const Model& model, const StaticResults& statics);

/// Returns the checks of a run, whose stations, envelopes and design values must be set.
CheckTable check_dynamics(const Model& model, const StaticResults& statics, const DynamicResults& dynamics);

/// Stores the table and its assumptions in the results, replacing an earlier table.
void fill_checks(const Model& model, StaticResults& statics);
void fill_checks(const Model& model, const StaticResults& statics, DynamicResults& dynamics);
/// Checks of a hull and its mooring lines without a pipe, and of standalone lines.

}  // namespace overbend
