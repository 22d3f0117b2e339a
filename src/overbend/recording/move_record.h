/// What is recorded of a vessel that moves ahead: histories, and what a user has to know of it.
#pragma once

#include <vector>

#include "mechanics/move_profile.h"
#include "model/model.h"
#include "recording/history_columns.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Way of the vessel and, with a pipe, what of it is paid out, and joints.
void add_move_columns(std::vector<RecordedColumn>& columns, bool pipe);

/// What the results hold of the move by assumption.
void assume_of_move(const Model& model, const MoveProfile& move, DynamicResults& results);

/// Where the run ends before the move does, or the tensioner cannot pay out what the vessel leaves behind.
void warn_of_move(const Model& model, const MoveProfile& move, DynamicResults& results);

}  // namespace overbend
