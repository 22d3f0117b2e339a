/// The units of summary.json in the place of its numbers.
#pragma once

#include "base/json.h"

namespace overbend {

/// An object built as the summary of a static analysis, with every part that may be there. A number has its SI unit as
/// base/units.h writes it; a list has one item; what is no number, or has a unit that hangs on the row, is null.
const Json& summary_units();

/// The same of a dynamic analysis: with the key `dynamic`.
const Json& dynamic_summary_units();

/// Of what a stage of an operation on the line has besides the keys of a lay: `tension`, `barge_ahead`,
/// `failure.least_tension`.
const Json& stage_units();

/// The same with units as results.h5 has them: "Pa", "N m".
const Json& stored_summary_units();

/// The descriptions of the numbers in their place, of a dynamic analysis as well.
const Json& summary_descriptions();

}  // namespace overbend
