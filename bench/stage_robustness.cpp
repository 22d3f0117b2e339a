/// Random stages of abandonments and start-ups of a lay, each without a previous stage: how many are solved, how many
/// rejected for a valid reason, how many abandoned.
///
///     overbend_stage_robustness MODEL.yaml COUNT SEED abandonment|start_up
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <random>
#include <string>

#include "model/lay_stage.h"
#include "modelfile/reading/yaml_reader.h"
#include "statics/initial_shape/stage_shape.h"
#include "statics/moored/moored_lay.h"

namespace overbend {
namespace {

/// The same numbers on every machine.
class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  double between(double low, double high) { return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0; }

 private:
  std::mt19937 engine_;
};

/// A wire of 30 to 120 mm, a head of 1 to 8 m; a tension of 0.95 to 4 times the vertically suspended weight.
LayStageDescription random_stage(Dice& dice, bool start_up, Description& d) {
  LayOperationDescription& lay = d.operation.lay;
  CableDescription cable;
  cable.diameter = dice.between(0.03, 0.12);
  cable.weight_submerged = 3.6e4 * cable.diameter * cable.diameter;
  cable.weight_in_air = 1.17 * cable.weight_submerged;
  cable.axial_stiffness = 4.5e10 * cable.diameter * cable.diameter;
  HeadDescription head;
  head.length = dice.between(1.0, 8.0);
  head.weight_submerged = dice.between(2e3, 60e3);
  head.weight_in_air = head.weight_submerged * dice.between(1.1, 2.0);
  lay.head = head;
  LayStageDescription stage;
  stage.tension = 1.0;
  d.operation.type = start_up ? OperationType::start_up : OperationType::abandonment;
  if (start_up) {
    cable.length = dice.between(200.0, 700.0);
    stage.pipe_out = dice.between(5.0, 400.0);
    lay.anchor = StartUpAnchor{d.environment.water_depth - 0.5 * cable.diameter, {}};
  } else {
    stage.cable_out = dice.between(1.0, 500.0);
  }
  lay.cable = cable;
  const Model model = build_model(make_stage_description(d, stage));
  stage.tension = min_stage_top_tension(model, lay_plane(model, model.mean_pose)) * dice.between(0.95, 4.0);
  return stage;
}

int run(const std::string& file, int count, unsigned seed, bool start_up) {
  Description d = read_model(file).description.value();
  Dice dice(seed);
  int solved = 0, rejected = 0, given_up = 0;
  double slowest = 0.0;
  for (int i = 0; i < count; ++i) {
    const LayStageDescription stage = random_stage(dice, start_up, d);
    Model model = build_model(make_stage_description(d, stage));
    const auto begin = std::chrono::steady_clock::now();
    const ModelEquilibrium outcome = solve_lay(model);
    slowest = std::max(slowest, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    if (outcome.solution) {
      ++solved;
    } else if (outcome.failure->what == "no equilibrium found") {
      ++given_up;
      fmt::print("{}: {:.1f} m out, {:.1f} kN: {}\n", i, stage.cable_out.value_or(stage.pipe_out.value_or(0.0)),
                 1e-3 * *stage.tension, outcome.failure->what);
    } else {
      ++rejected;
    }
  }
  fmt::print("{} solved, {} rejected, {} given up, slowest {:.2f} s\n", solved, rejected, given_up, slowest);
  return 0;
}

}  // namespace
}  // namespace overbend

int main(int argc, char** argv) {
  if (argc != 5) {
    fmt::print(stderr, "overbend_stage_robustness MODEL.yaml COUNT SEED abandonment|start_up\n");
    return 2;
  }
  return overbend::run(argv[1], std::atoi(argv[2]), static_cast<unsigned>(std::atoi(argv[3])),
                       std::string(argv[4]) == "start_up");
}
