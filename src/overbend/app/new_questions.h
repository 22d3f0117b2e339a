/// Questions of `overbend new`.
#pragma once

#include <iosfwd>

#include "model/new_model.h"

namespace overbend {

/// Asks for the main inputs of a first model that were not given, each with its default. At the end of input, all
/// remaining questions get their defaults.
void ask_new_options(NewOptions& options, std::istream& in, std::ostream& out);

}  // namespace overbend
