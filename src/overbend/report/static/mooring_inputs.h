/// Inputs of a floating hull, of moorings and of stand-alone lines, as read by the program.
#pragma once

#include "model/description/description.h"
#include "report/page/blocks.h"

namespace overbend {

/// Returns tables for the section on inputs; empty if the model has none of these inputs.
Table hull_inputs(const Description& model);
Blocks mooring_inputs(const Description& model);
Table line_inputs(const Description& model);

}  // namespace overbend
