#include "app/interruption.h"

#include <csignal>

namespace overbend {
namespace {

volatile std::sig_atomic_t flag = 0;

void set_flag(int signal) {
  flag = 1;
  std::signal(signal, SIG_DFL);  // who asks twice means it
}

}  // namespace

Interruption::Interruption() {
  flag = 0;
  std::signal(SIGINT, set_flag);
  std::signal(SIGTERM, set_flag);
}

Interruption::~Interruption() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool Interruption::wanted() {
  return flag != 0;
}

}  // namespace overbend
