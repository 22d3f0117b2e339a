#include "base/threads.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "base/interruption.h"
#include "platform/machine.h"

namespace overbend {

void work_in_threads(std::size_t count, const std::function<void()>& work) {
  std::mutex mutex;
  std::exception_ptr first;
  const auto guarded = [&] {
    try {
      work();
    } catch (...) {
      const std::lock_guard<std::mutex> hold(mutex);
      if (!first) first = std::current_exception();
    }
  };
  std::vector<std::thread> others;
  try {
    for (std::size_t i = 1; i < count; ++i) {
      others.emplace_back([&, asked = caller_interruption()] {
        const InterruptionScope scope(asked);
        guarded();
      });
    }
  } catch (const std::system_error&) {  // the existing threads do all the work
  }
  guarded();
  for (std::thread& thread : others) thread.join();
  if (first) std::rethrow_exception(first);
}

std::size_t useful_threads(int asked, std::size_t pieces) {
  const std::size_t wanted = asked > 0 ? static_cast<std::size_t>(asked) : hardware_threads();
  return std::min(wanted, std::max<std::size_t>(pieces, 1));
}

}  // namespace overbend
