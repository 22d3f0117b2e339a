/// The units of summary.json in place of its numbers.
#pragma once

#include "base/json.h"

namespace overbend {

/// Returns an object with the structure of the summary of a static analysis, with every part that may exist. A number
/// has its SI unit as in base/units.h; a list has one item; a member that is not a number, or whose unit depends on the
/// row, is null.
const Json& summary_units();

/// Returns the same for a dynamic analysis: with the key `dynamic`.
const Json& dynamic_summary_units();

/// Returns the units of a stage of an operation on the line in addition to the keys of a lay: `tension`, `barge_ahead`,
/// `failure.least_tension`.
const Json& stage_units();

/// Returns the same with units as in results.h5: "Pa", "N m".
const Json& stored_summary_units();

/// Returns the descriptions of the numbers in their place, of a dynamic analysis as well.
const Json& summary_descriptions();

}  // namespace overbend
