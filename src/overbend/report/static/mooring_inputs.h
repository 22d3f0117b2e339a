/// Inputs of a floating hull, of moorings and of lines by themselves, as the program reads them.
#pragma once

#include "model/description/description.h"
#include "report/page/blocks.h"

namespace overbend {

/// Tables for the section on inputs; empty where the model has none of them.
Table hull_inputs(const Description& model);
Blocks mooring_inputs(const Description& model);
Table line_inputs(const Description& model);

}  // namespace overbend
