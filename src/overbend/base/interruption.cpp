#include "base/interruption.h"

#include <atomic>
#include <utility>

namespace overbend {
namespace {

std::atomic<bool> process_interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may not wait");

thread_local const InterruptionScope* innermost = nullptr;

}  // namespace

InterruptionScope::InterruptionScope(std::function<bool()> stop)
    : stop_(std::move(stop)), around_(std::exchange(innermost, this)) {}

InterruptionScope::~InterruptionScope() {
  innermost = around_;
}

bool InterruptionScope::wanted() const {
  return (stop_ && stop_()) || (around_ != nullptr && around_->wanted());
}

bool interruption_wanted() {
  return process_interrupted.load(std::memory_order_relaxed) || (innermost != nullptr && innermost->wanted());
}

void check_interruption() {
  if (interruption_wanted()) throw Interrupted();
}

void interrupt_process(bool wanted) noexcept {
  process_interrupted = wanted;
}

}  // namespace overbend
