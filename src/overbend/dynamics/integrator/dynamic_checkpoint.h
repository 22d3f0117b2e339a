/// The state of a run as named arrays, bit for bit, and back.
#pragma once

#include <string>
#include <vector>

#include "dynamics/integrator/water_field.h"
#include "results/dynamic_sink.h"
#include "system/state.h"

namespace overbend {

/// An array of a checkpoint. Throws std::runtime_error where there is none of the name.
const std::vector<double>& checkpoint_array(const DynamicCheckpoint& checkpoint, const std::string& name);

void save_state(DynamicCheckpoint& checkpoint, const SystemState& state);
/// Into a state of the same line.
void restore_state(const DynamicCheckpoint& checkpoint, SystemState& state);

void save_water(DynamicCheckpoint& checkpoint, const std::vector<WaterMemory>& lines);
/// `lines` has its size.
void restore_water(const DynamicCheckpoint& checkpoint, std::vector<WaterMemory>& lines);

void save_report(DynamicCheckpoint& checkpoint, const DynamicRunReport& report);
void restore_report(const DynamicCheckpoint& checkpoint, DynamicRunReport& report);

}  // namespace overbend
