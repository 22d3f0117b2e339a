/// A made-up abandonment in six stages on the solved example: the head goes down its line, the last stage cannot be.
#pragma once

#include <string>

#include "results/operation_results.h"

namespace overbend::testing {

OperationResults synthetic_abandonment();

/// The same stages of a start-up: the cable lies between head and anchor.
OperationResults synthetic_start_up();

/// The example's model with that operation in it.
std::string abandonment_text();

}  // namespace overbend::testing
