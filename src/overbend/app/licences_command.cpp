#include <iostream>

#include "app/commands.h"
#include "app/exit_code.h"
#include "serve/http/page_files.h"

namespace overbend {

int run_licences() {
  std::cout << licence_texts();
  return kDone;
}

}  // namespace overbend
