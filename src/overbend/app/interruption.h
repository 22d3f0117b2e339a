/// Ctrl-C and its like as a flag that long work looks at.
#pragma once

#include "base/interruption.h"

namespace overbend {

/// While it lives, the first SIGINT or SIGTERM sets the flag; the second ends the program as it would without.
class Interruption {
 public:
  /// What this thread does meanwhile ends by Interrupted, what threads of its own do by themselves.
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  static bool wanted();

 private:
  InterruptionScope scope_;
};

}  // namespace overbend
