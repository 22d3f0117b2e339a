/// The table of code checks of a static state or of a dynamic run.
#pragma once

#include "model/model.h"
#include "results/dynamic_results.h"
#include "results/line_results.h"
#include "results/static_results.h"

namespace overbend {

/// Of the static state: stations must be set.
CheckTable check_statics(const Model& model, const StaticResults& statics);

/// Of a run: stations, envelopes and the design values must be set.
CheckTable check_dynamics(const Model& model, const StaticResults& statics, const DynamicResults& dynamics);

/// Puts the table into the results, and what it assumes among their assumptions, in place of an earlier table.
void fill_checks(const Model& model, StaticResults& statics);
void fill_checks(const Model& model, const StaticResults& statics, DynamicResults& dynamics);
/// Of a hull and its mooring lines without a pipe; of lines by themselves.

}  // namespace overbend
