/// What is built into the pipe, as sections of the line.
#pragma once

#include "model/model.h"

namespace overbend {

/// Puts the structures of the description into the model's sections and spans: they take the place of whatever section
/// lies there. They go with the pipe at a stage of an operation. What would lie inboard of the tensioner, or where head
/// and cable are, is left out, and a structure that lies there with all its length.
void add_structures(Model& model);

}  // namespace overbend
