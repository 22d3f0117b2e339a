#include "study/run/input_findings.h"

#include <stdexcept>

#include "model/model_findings.h"
#include "results/findings.h"
#include "statics/moored/hull_statics.h"
#include "statics/recovery/static_findings.h"

namespace overbend {

Findings input_findings(const Model& model) {
  Findings findings = model_findings(model);
  if (model.description.has_pipe) append(findings, lay_findings(model));
  try {
    if (const auto account = compute_hull_statics(model, nullptr)) {
      findings = merge(std::move(findings), account->findings);
    }
  } catch (const std::invalid_argument&) {  // incomplete hull data are rejected when the hull is solved
  }
  return findings;
}

}  // namespace overbend
