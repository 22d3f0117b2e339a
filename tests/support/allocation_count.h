/// Number of times the test program has asked the heap for memory.
#pragma once

namespace overbend::testing {

/// Calls of operator new since the program began, from every thread.
long allocation_count();

}  // namespace overbend::testing
