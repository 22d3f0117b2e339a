#include <iostream>

#include "app/commands.h"
#include "serve/page_files.h"
#include "study/exit_code.h"

namespace overbend {

int run_licences() {
  std::cout << licence_texts();
  return kDone;
}

}  // namespace overbend
