/// Handling of Ctrl-C and SIGTERM with a flag that long computations poll.
#pragma once

#include "base/interruption.h"

namespace overbend {

/// During its lifetime, the first Ctrl-C or SIGTERM sets the flag; the second ends the program.
class Interruption {
 public:
  /// Computations of this thread end by the exception Interrupted; other threads must poll wanted().
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  static bool wanted();

 private:
  InterruptionScope scope_;
};

}  // namespace overbend
