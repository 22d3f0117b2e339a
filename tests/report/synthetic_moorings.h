/// Results of moorings, of a hull and of lines made up for tests and pictures of the report: plausible to look at, the
/// same every time.
#pragma once

#include "report/page/page.h"
#include "results/dynamic_results.h"
#include "results/static_results.h"

namespace overbend::testing {

/// BGL-1 on eight lines, tensions of the planner against 205.6 kN of pipe; `stages`: of the operation.
MooringResults synthetic_moorings();

/// Statics of the barge without a pipe with these.
StaticResults synthetic_hull_alone(MooringResults moorings);

/// The same with a current and a parted line as stages.
MooringResults synthetic_stages();

/// The same in a pull-ahead of 12 m in 24 steps.
MooringResults synthetic_pull_ahead();

/// Radiation, damping and steady loads.
HullResults synthetic_hull();

/// Adds the results of a run of an hour for vessel and moorings, with histories.
void add_moored_dynamics(DynamicResults& results);

/// The report of such a run of the barge without a pipe.
Document moored_document_in_time();

/// A jumper between two ends at rest, and a run from there.
StaticResults synthetic_lines();
DynamicResults synthetic_lines_in_time();

/// The text of examples/NAME.yaml.
std::string example_text(const char* name);

}  // namespace overbend::testing
