#include "system/state.h"

namespace overbend {

LineState::LineState() = default;
LineState::LineState(const LineState&) = default;
LineState::LineState(LineState&&) noexcept = default;
LineState& LineState::operator=(const LineState&) = default;
LineState& LineState::operator=(LineState&&) noexcept = default;
LineState::~LineState() = default;

SystemState::SystemState() = default;
SystemState::SystemState(const SystemState&) = default;
SystemState::SystemState(SystemState&&) noexcept = default;
SystemState& SystemState::operator=(const SystemState&) = default;
SystemState& SystemState::operator=(SystemState&&) noexcept = default;
SystemState::~SystemState() = default;

}  // namespace overbend
