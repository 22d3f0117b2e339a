/// In-line structures as sections of the line.
#pragma once

#include "model/model.h"

namespace overbend {

/// Adds the structures of the description to the model's sections and spans, in which they replace the section at their
/// position. They move with the pipe at an operation stage. Parts inboard of the tensioner, or at the position of head
/// and cable, are omitted.
void add_structures(Model& model);

}  // namespace overbend
