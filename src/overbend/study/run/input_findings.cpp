#include "study/run/input_findings.h"

#include <stdexcept>

#include "model/model_findings.h"
#include "results/findings.h"
#include "statics/moored/hull_account.h"
#include "statics/recovery/static_findings.h"

namespace overbend {

Findings input_findings(const Model& model) {
  Findings findings = model_findings(model);
  if (model.description.has_pipe) append(findings, lay_findings(model));
  try {
    if (const auto account = hull_account(model, nullptr)) findings = merge(std::move(findings), account->findings);
  } catch (const std::invalid_argument&) {  // a hull that needs more than it has is refused where it is solved
  }
  return findings;
}

}  // namespace overbend
