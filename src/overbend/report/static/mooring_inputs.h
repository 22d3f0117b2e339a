/// Inputs of a floating hull, of moorings and of lines by themselves, as the program reads them. HTML.
#pragma once

#include <string>

#include "model/description/description.h"

namespace overbend {

/// Tables for the section on inputs; empty where the model has none of them.
std::string hull_inputs(const Description& model);
std::string mooring_inputs(const Description& model);
std::string line_inputs(const Description& model);

}  // namespace overbend
