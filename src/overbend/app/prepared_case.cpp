#include "app/prepared_case.h"

#include <iostream>

#include "base/units.h"
#include "modelfile/field.h"
#include "study/static_run.h"

namespace overbend {

ExitCode tell_failure(const StaticFailure& failure) {
  std::cerr << "overbend: " << (failure.input ? "" : "no solution: ") << failure_line(failure) << "\n";
  return failure.input ? kWrongInput : kNoSolution;
}

std::unique_ptr<PreparedCase> prepare_case(const Description& description, ExitCode& code) {
  Model model = build_model(description);
  if (const std::optional<StaticFailure> obstacle = dynamic_obstacle(model)) {
    std::cerr << "overbend: " << failure_line(*obstacle) << "\n";
    code = kWrongInput;
    return nullptr;
  }
  StaticOutcome outcome = solve_statics(model);
  if (outcome.failure) {
    code = tell_failure(*outcome.failure);
    return nullptr;
  }
  code = kDone;
  StaticResults statics = checked_statics(model, *outcome.solution);
  return std::make_unique<PreparedCase>(PreparedCase{description, std::move(model), std::move(*outcome.solution),
                                                     std::move(statics), input_text(description)});
}

bool set_duration(Description& description, const std::string& text) {
  if (text.empty()) return true;
  const QuantityReading duration = parse_quantity(text, "s");
  if (!duration.value || !(*duration.value > 0.0 && *duration.value <= largest_sensible("s"))) {
    std::cerr << "overbend: --duration: found " << duration.found << ", expected a time such as '600 s'\n";
    return false;
  }
  if (!description.dynamics) description.dynamics.emplace();
  description.dynamics->duration = *duration.value;
  return true;
}

}  // namespace overbend
