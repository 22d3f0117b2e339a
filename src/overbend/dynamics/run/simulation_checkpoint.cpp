/// Saving and restoring a simulation.
#include <cmath>

#include "dynamics/integrator/dynamic_checkpoint.h"
#include "dynamics/machines/line_failure.h"
#include "dynamics/run/simulation.h"

namespace overbend {

DynamicCheckpoint Simulation::checkpoint() const {
  DynamicCheckpoint c;
  c.time = state_.time;
  save_state(c, state_);
  save_water(c, water_->memories());
  if (conveyor_) {
    c.arrays.push_back({"conveyor", conveyor_->save(setup_.system)});
    const std::vector<int>& stations = water_->stations(pipe_->line);
    if (!stations.empty()) c.arrays.push_back({"conveyor/stations", {stations.begin(), stations.end()}});
  }
  c.arrays.push_back({"impacts", tracker_->save()});
  c.arrays.push_back({"energy", energy_.save()});
  c.arrays.push_back({"steps", chooser_.save()});
  c.arrays.push_back({"control", {static_cast<double>(clock_.tick)}});
  c.arrays.push_back({"watches", monitors_.save()});
  controllers_.save(setup_.system, c);
  save_report(c, report_);
  for (const SimulationObserver* observer : observers_) observer->save(c);
  return c;
}

void Simulation::restore(const DynamicCheckpoint& checkpoint) {
  restore_state(checkpoint, state_);
  restore_water(checkpoint, water_->memories());
  if (conveyor_) restore_pipe(checkpoint);
  tracker_->restore(checkpoint_array(checkpoint, "impacts"));
  energy_.restore(checkpoint_array(checkpoint, "energy"));
  clock_.tick = std::llround(checkpoint_array(checkpoint, "control").at(0));
  monitors_.restore(checkpoint_array(checkpoint, "watches"));
  chooser_.restore(checkpoint_array(checkpoint, "steps"));
  controllers_.restore(checkpoint, setup_.system);
  restore_report(checkpoint, report_);
  restore_failed_lines(state_, setup_.system);
  failure_.reset();
  if (conveyor_) {
    renew_system();
  } else {
    stepper_->forget();
    evaluate_present();
  }
  next_ = state_;
  for (SimulationObserver* observer : observers_) observer->restore(checkpoint);
}

/// Restores the pipe's mesh and the wave stations along it.
void Simulation::restore_pipe(const DynamicCheckpoint& checkpoint) {
  conveyor_->restore(checkpoint_array(checkpoint, "conveyor"), setup_.system);
  if (water_->calm()) return;
  const std::vector<double>& stations = checkpoint_array(checkpoint, "conveyor/stations");
  water_->place_stations(pipe_->line, setup_.system.lines[pipe_->line].mesh, {stations.begin(), stations.end()});
}

/// Evaluates the system at the restored state, so that the present can be read. The state itself is not changed.
void Simulation::evaluate_present() {
  SystemState state = state_;
  assembly_->set_time(state.time, state);
  set_drives();
  assembly_->evaluate(state, state_, {}, false);
  find_elevation();
}

}  // namespace overbend
