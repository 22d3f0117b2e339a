/// Random profiles under a lay: how many are solved, how many rejected for a valid reason, how many abandoned.
///
///     overbend_bed_robustness MODEL.yaml COUNT SEED
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

#include "modelfile/reading/yaml_reader.h"
#include "statics/recovery/recovery.h"
#include "statics/solver/statics.h"

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

/// Level at the stern shoe and at the far end; between them points 3 to 60 m apart that rise and fall by up to 0.25 of
/// their distance, on a trend of up to 0.06.
std::vector<ProfilePoint> random_profile(Dice& dice, double depth, double length) {
  std::vector<ProfilePoint> points = {{0.0, depth}, {20.0, depth}};
  const double trend = dice.between(-0.06, 0.06), rough = dice.between(0.0, 0.25), coarse = dice.between(3.0, 60.0);
  double x = 20.0;
  while (x < length) {
    const double step = coarse * dice.between(0.5, 1.5);
    x += step;
    const double mean = depth + trend * (x - 20.0);
    const double next = mean + rough * coarse * dice.between(-0.5, 0.5);
    points.push_back({x, std::clamp(next, 0.5 * depth, 2.0 * depth)});
  }
  points.push_back({x + 50.0, points.back().depth});
  points.push_back({x + 150.0, points.back().depth});
  return points;
}

int run(const std::string& file, int count, unsigned seed) {
  Description d = read_model(file).description.value();
  const double tension = d.tensioner.tension.value();
  Dice dice(seed);
  int solved = 0, rejected = 0, given_up = 0, spans = 0;
  double slowest = 0.0;
  for (int i = 0; i < count; ++i) {
    d.environment.seabed.profile = random_profile(dice, d.environment.water_depth, 800.0);
    d.environment.seabed.friction_axial = d.environment.seabed.friction_lateral = dice.between(-0.5, 0.7);
    if (d.environment.seabed.friction_axial < 0.0) {
      d.environment.seabed.friction_axial = d.environment.seabed.friction_lateral = 0.0;
    }
    d.tensioner.tension = tension * dice.between(0.7, 2.0);
    const auto begin = std::chrono::steady_clock::now();
    const Model model = build_model(d);
    const StaticOutcome outcome = solve_statics(model);
    slowest = std::max(slowest, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    if (outcome.solution) {
      ++solved;
      spans += static_cast<int>(recover_statics(model, *outcome.solution).bed.value().spans.size());
    } else if (outcome.failure->what == "no equilibrium found") {
      ++given_up;
      fmt::print("{}: {:.1f} kN: {}\n", i, 1e-3 * *d.tensioner.tension, outcome.failure->why);
    } else {
      ++rejected;
      fmt::print("{}: {:.1f} kN: rejected: {} {}\n", i, 1e-3 * *d.tensioner.tension, outcome.failure->what,
                 outcome.failure->why);
    }
  }
  fmt::print("{} solved with {} free spans, {} rejected, {} given up, slowest {:.2f} s\n", solved, spans, rejected,
             given_up, slowest);
  return 0;
}

}  // namespace
}  // namespace overbend

int main(int argc, char** argv) {
  if (argc != 4) {
    fmt::print(stderr, "overbend_bed_robustness MODEL.yaml COUNT SEED\n");
    return 2;
  }
  return overbend::run(argv[1], std::atoi(argv[2]), static_cast<unsigned>(std::atoi(argv[3])));
}
