/// A run of lines into a checkpoint and out of it.
#include <cmath>

#include "dynamics/integrator/dynamic_checkpoint.h"
#include "dynamics/machines/parting.h"
#include "dynamics/run/system_run.h"

namespace overbend {
namespace {

constexpr std::size_t kWatchNumbers = 4;

}  // namespace

DynamicCheckpoint SystemRun::checkpoint() const {
  DynamicCheckpoint c;
  c.time = state_.time;
  save_state(c, state_);
  save_water(c, water_memory_);
  c.arrays.push_back({"energy", energy_.save()});
  c.arrays.push_back({"steps", chooser_.save()});
  c.arrays.push_back({"control", {static_cast<double>(clock_.tick)}});
  save_report(c, report_);
  std::vector<double> watches;
  for (const TensionWatch& watch : watches_) {
    watches.insert(watches.end(), {watch.last, watch.slope, watch.least, watch.most});
  }
  c.arrays.push_back({"watches", std::move(watches)});
  for (const SystemObserver* observer : observers_) observer->save(c);
  return c;
}

void SystemRun::restore(const DynamicCheckpoint& checkpoint) {
  restore_state(checkpoint, state_);
  restore_water(checkpoint, water_memory_);
  energy_.restore(checkpoint_array(checkpoint, "energy"));
  clock_.tick = std::llround(checkpoint_array(checkpoint, "control").at(0));
  restore_report(checkpoint, report_);
  chooser_.restore(checkpoint_array(checkpoint, "steps"));
  const std::vector<double>& watches = checkpoint_array(checkpoint, "watches");
  for (std::size_t i = 0; i < watches_.size(); ++i) {
    const double* at = &watches.at(kWatchNumbers * i);
    watches_[i] = {at[0], at[1], at[2], at[3]};
  }
  part_as_in(state_, system_);
  stepper_->forget();
  failure_.reset();
  next_ = state_;
  SystemState at = state_;  // the state itself keeps its bits
  assembly_->set_time(at.time, at);
  assembly_->evaluate(at, state_, {}, false);
  for (SystemObserver* observer : observers_) observer->restore(checkpoint);
}

}  // namespace overbend
