/// Histories of machines with external controllers.
#pragma once

#include <vector>

#include "dynamics/run/controllers.h"
#include "recording/history_columns.h"

namespace overbend {

/// Adds for every machine with a controller its speed, the commanded speed, its set tension and, for a winch, its
/// payout.
void add_control_columns(const Controllers& controllers, std::vector<RecordedColumn>& columns);

}  // namespace overbend
