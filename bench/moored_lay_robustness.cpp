/// Rests of a lay whose barge floats free on its moorings, compared with the same lay on a fixed barge: counts lays
/// that a held barge has and a floating one has not.
///
///     overbend_moored_lay_robustness [COUNT] [SEED]
///
/// The moored example with pretensions of 120 to 700 kN, currents of 0 to 1 m/s from anywhere, tensions of the pipe of
/// 0.8 to 1.6 of its own, ballast trimmed or as given, pose or lengths to be found, in the mean drift of seas to 4 m.
#include <fmt/core.h>

#include <cmath>
#include <numbers>
#include <string>

#include "base/random.h"
#include "modelfile/reading/yaml_reader.h"
#include "statics/moored/moored_lay.h"

namespace overbend {
namespace {

double between(Random& random, double low, double high) {
  return low + (high - low) * random.uniform();
}

bool toss(Random& random) {
  return random.uniform() < 0.5;
}

Description random_lay(const Description& example, Random& random) {
  Description d = example;
  const double turn = 2.0 * std::numbers::pi;
  const double speed = between(random, 0.0, 1.0), towards = between(random, 0.0, turn);
  for (CurrentPoint& row : d.environment.current) {
    row.speed *= speed / 1.02;
    row.towards = towards;
  }
  d.environment.waves.front().hs = between(random, 0.5, 4.0);
  d.environment.waves.front().from = between(random, 0.0, turn);
  d.statics.mean_drift = toss(random);
  const double pretension = between(random, 120e3, 700e3);
  for (MooringLineDescription& line : d.moorings->lines) line.tension = pretension;
  d.moorings->find = toss(random) ? FindMooring::pose : FindMooring::lengths;
  d.vessel.coupled->ballast = toss(random) ? Ballast::trim : Ballast::as_given;
  d.tensioner.tension = *d.tensioner.tension * between(random, 0.8, 1.6);
  d.tensioner.range_low.reset();
  d.tensioner.range_high.reset();
  return d;
}

/// Reason why there is no rest, empty where there is one.
std::string why_not(Description d, bool floats) {
  if (!floats) {
    d.moorings.reset();
    d.vessel.coupled.reset();
    d.vessel.motion = VesselMotion::fixed;
  }
  Model model = build_model(d);
  const ModelEquilibrium lay = solve_lay(model);
  return lay.failure ? lay.failure->what + ": " + lay.failure->why : std::string();
}

}  // namespace
}  // namespace overbend

int main(int argc, char** argv) {
  using namespace overbend;
  const int count = argc > 1 ? std::stoi(argv[1]) : 100;
  Random random(argc > 2 ? std::stoull(argv[2]) : 1);
  const Description example = read_model(OVERBEND_SOURCE_DIR "/examples/bgl1-moored.yaml").description.value();
  int held = 0, floating = 0, only_held = 0;
  for (int i = 0; i < count; ++i) {
    const Description d = random_lay(example, random);
    const std::string of_held = why_not(d, false), select_floating = why_not(d, true);
    held += of_held.empty() ? 1 : 0;
    floating += select_floating.empty() ? 1 : 0;
    if (of_held.empty() && !select_floating.empty()) {
      ++only_held;
      fmt::print("trial {}: {}, {} kN, {}\n", i, d.moorings->find == FindMooring::pose ? "pose" : "lengths",
                 std::lround(1e-3 * *d.moorings->lines[0].tension), select_floating);
    }
  }
  fmt::print("{} of {} lays rest on a held barge, {} on a floating one; {} on a held one alone\n", held, count,
             floating, only_held);
  return 0;
}
