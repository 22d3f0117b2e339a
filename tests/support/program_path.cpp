#include "support/program_path.h"

// In a file of its own, which is compiled with every executable: the other tests may serve several.
std::string overbend::testing::program_path() {
  return OVERBEND_PROGRAM;
}
