/// The questions of `overbend new`.
#pragma once

#include <iosfwd>

#include "model/new_model.h"

namespace overbend {

/// Asks for what decides a first model and was not said, each with what an empty answer stands for; input that ends
/// answers all that is left with nothing.
void ask_new_options(NewOptions& options, std::istream& in, std::ostream& out);

}  // namespace overbend
