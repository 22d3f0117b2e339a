#include "study/input_warnings.h"

#include <stdexcept>

#include "model/model_warnings.h"
#include "results/warnings.h"
#include "statics/hull_account.h"
#include "statics/static_warnings.h"

namespace overbend {

std::vector<std::string> input_warnings(const Model& model) {
  std::vector<std::string> warnings = model_warnings(model);
  if (model.description.has_pipe) warnings = together(std::move(warnings), lay_warnings(model));
  try {
    if (const auto account = hull_account(model, nullptr)) warnings = together(std::move(warnings), account->warnings);
  } catch (const std::invalid_argument&) {  // a hull that needs more than it has is refused where it is solved
  }
  return warnings;
}

}  // namespace overbend
