#include "dynamics/machines/controller.h"

#include <stdexcept>

namespace overbend {

MachineCommand CompiledController::command(const MachineReading& seen) {
  double value = 0.0;
  const int answer = function_(&seen, &value, memory_.data());
  switch (answer) {
    case OVERBEND_LEAVE:
      return {MachineCommand::Kind::leave, 0.0};
    case OVERBEND_SPEED:
      return {MachineCommand::Kind::speed, value};
    case OVERBEND_TENSION:
      return {MachineCommand::Kind::tension, value};
    default:
      throw std::runtime_error("it returned " + std::to_string(answer) + " instead of 0, 1 or 2");
  }
}

void CompiledController::restore(const std::vector<double>& saved) {
  if (saved.empty()) return;
  if (saved.size() != memory_.size()) {
    throw std::runtime_error("the compiled controller has a memory of " + std::to_string(memory_.size()) +
                             " numbers, the saved state has " + std::to_string(saved.size()));
  }
  memory_ = saved;
}

}  // namespace overbend
