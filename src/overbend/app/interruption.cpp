#include "app/interruption.h"

#include <atomic>

#include "platform/process.h"

namespace overbend {
namespace {

std::atomic<bool> flag{false};  // read by several threads
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not block");

void set_flag() {
  flag = true;
}

}  // namespace

Interruption::Interruption() : scope_(wanted) {
  flag = false;
  set_interrupt_handler(set_flag);
}

Interruption::~Interruption() {
  set_interrupt_handler(nullptr);
}

bool Interruption::wanted() {
  return flag;
}

}  // namespace overbend
