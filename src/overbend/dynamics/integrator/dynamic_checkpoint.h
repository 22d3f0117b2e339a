/// Saves the state of a run as named arrays and restores it bit for bit.
#pragma once

#include <string>
#include <vector>

#include "dynamics/integrator/water_field.h"
#include "results/dynamic_sink.h"
#include "system/state.h"

namespace overbend {

/// Returns the array of that name. Throws std::runtime_error if the checkpoint has none.
const std::vector<double>& checkpoint_array(const DynamicCheckpoint& checkpoint, const std::string& name);

/// Adds all lines, attachments and free bodies of `state` to the checkpoint.
void save_state(DynamicCheckpoint& checkpoint, const SystemState& state);
/// Restores into a state of the same system.
void restore_state(const DynamicCheckpoint& checkpoint, SystemState& state);

/// Adds the waves tabulated along each line.
void save_water(DynamicCheckpoint& checkpoint, const std::vector<WaterMemory>& lines);
/// Restores into `lines`, which must have the size of the saved run.
void restore_water(const DynamicCheckpoint& checkpoint, std::vector<WaterMemory>& lines);

/// Adds the counters of the run.
void save_report(DynamicCheckpoint& checkpoint, const DynamicRunReport& report);
void restore_report(const DynamicCheckpoint& checkpoint, DynamicRunReport& report);

}  // namespace overbend
