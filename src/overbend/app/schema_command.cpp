#include <iostream>

#include "app/commands.h"
#include "app/exit_code.h"
#include "base/findings_page.h"
#include "modelfile/reading/json_schema.h"
#include "modelfile/reading/reference_page.h"
#include "serve/answers/type_style.h"

namespace overbend {

int run_schema(SchemaForm form) {
  switch (form) {
    case SchemaForm::json:
      std::cout << json_schema();
      break;
    case SchemaForm::reference:
      std::cout << reference_page();
      break;
    case SchemaForm::findings:
      std::cout << findings_page();
      break;
    case SchemaForm::types:
      std::cout << page_types();
      break;
  }
  return kDone;
}

}  // namespace overbend
