/// Histories of machines that controllers from outside drive.
#pragma once

#include <vector>

#include "dynamics/run/controllers.h"
#include "recording/history_columns.h"

namespace overbend {

/// For every machine with a controller: its speed, the speed asked for, the tension that it is set to or, of a winch,
/// what it has paid out.
void add_control_columns(const Controllers& controllers, std::vector<RecordedColumn>& columns);

}  // namespace overbend
