/// A solved lay that can be looked at anywhere along the line.
#pragma once

#include <memory>
#include <string>

#include "model/model.h"
#include "statics/recovery/recovery.h"
#include "statics/solver/statics.h"

namespace overbend::validation {

/// Solves a model and keeps all that is needed to evaluate it. Throws std::runtime_error with the engine's reason where
/// there is no equilibrium.
class Lay {
 public:
  explicit Lay(Model model);

  const StaticResults& results() const { return results_; }
  const StaticSystem& system() const { return *system_; }
  const StaticSolution& solution() const { return solution_; }

  /// Station at an unstressed length from the top, with the forces of the neighbouring cuts [m].
  Station station_at(double from_top) const;
  /// Station exactly at the contact with a roller.
  Station at_roller(std::size_t roller) const;
  double from_top(const Station& station) const { return system_->mesh().total_length() - station.s; }

 private:
  Station station(int element, double xi) const;
  std::unique_ptr<Model> model_;  ///< Its address is kept by the system.
  StaticSolution solution_;
  StaticResults results_;
  std::unique_ptr<StaticSystem> system_;
  std::vector<CutForces> cuts_;
};

/// Reads validation/static_cases/NAME.yaml.
Description case_description(const std::string& name);

}  // namespace overbend::validation
