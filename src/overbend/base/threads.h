/// Parallel work.
#pragma once

#include <cstddef>
#include <functional>

namespace overbend {

/// Calls `work` in `count` threads, including this one, and waits for all; cancelling this thread cancels all. Uses
/// fewer threads if the system has no more. Rethrows the first exception after all have ended.
void work_in_threads(std::size_t count, const std::function<void()>& work);

/// Returns the number of threads for so many pieces of work: `asked`, or that of the machine if `asked` is 0.
std::size_t useful_threads(int asked, std::size_t pieces);

}  // namespace overbend
