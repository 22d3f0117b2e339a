#include <iostream>

#include "app/commands.h"
#include "io/json_schema.h"
#include "io/reference_page.h"
#include "runs/exit_code.h"

namespace overbend {

int run_schema(bool reference) {
  std::cout << (reference ? reference_page() : json_schema());
  return kDone;
}

}  // namespace overbend
