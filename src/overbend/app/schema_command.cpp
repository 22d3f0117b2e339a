#include <iostream>

#include "app/commands.h"
#include "app/exit_code.h"
#include "modelfile/json_schema.h"
#include "modelfile/reference_page.h"

namespace overbend {

int run_schema(bool reference) {
  std::cout << (reference ? reference_page() : json_schema());
  return kDone;
}

}  // namespace overbend
