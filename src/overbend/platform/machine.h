/// The machine and its clock.
#pragma once

#include <cstddef>
#include <ctime>
#include <string>

namespace overbend {

/// Returns the number of threads that run at the same time, at least 1. All pools of threads use it. It is 1 on a
/// system without threads, where pools work in the calling thread.
std::size_t hardware_threads();

/// Returns operating system, its release and the processor's architecture.
std::string machine_name();

/// Converts to local time. May be called from any thread.
std::tm local_time(std::time_t time);

}  // namespace overbend
