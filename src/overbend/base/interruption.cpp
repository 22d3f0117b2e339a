#include "base/interruption.h"

#include <utility>

namespace overbend {
namespace {

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
  return innermost != nullptr && innermost->wanted();
}

void check_interruption() {
  if (interruption_wanted()) throw Interrupted();
}

std::function<bool()> caller_interruption() {
  const InterruptionScope* const scope = innermost;
  return [scope] { return scope != nullptr && scope->wanted(); };
}

}  // namespace overbend
