/// Ctrl-C and its like as a flag that long work looks at.
#pragma once

namespace overbend {

/// While it lives, the first SIGINT or SIGTERM sets the flag; the second ends the program as it would without.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  static bool wanted();
};

}  // namespace overbend
