#include "app/interruption.h"

#include <atomic>
#include <csignal>

namespace overbend {
namespace {

std::atomic<bool> flag{false};  // read by several threads
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not block");

void set_flag(int signal) {
  flag = true;
  std::signal(signal, SIG_DFL);  // a second signal ends the program
}

}  // namespace

Interruption::Interruption() : scope_(wanted) {
  flag = false;
  std::signal(SIGINT, set_flag);
  std::signal(SIGTERM, set_flag);
}

Interruption::~Interruption() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool Interruption::wanted() {
  return flag;
}

}  // namespace overbend
