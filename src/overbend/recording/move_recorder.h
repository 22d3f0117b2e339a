/// Records of a pull-ahead: histories, assumptions and warnings.
#pragma once

#include <vector>

#include "mechanics/move_profile.h"
#include "model/model.h"
#include "recording/history_columns.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Adds the columns of the vessel's advance and, with a pipe, of its payout and joints.
void add_move_columns(std::vector<RecordedColumn>& columns, bool pipe);

/// Adds the assumptions of the move to the results.
void assume_of_move(const Model& model, const MoveProfile& move, DynamicResults& results);

/// Warns of a run that ends before the move does, and of a tensioner that cannot pay out what the vessel advances.
void warn_of_move(const Model& model, const MoveProfile& move, DynamicResults& results);

}  // namespace overbend
