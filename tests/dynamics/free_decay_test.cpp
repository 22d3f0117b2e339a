/// BGL-1 released from a distance to its rest in calm water, on eight lines of elements and under its pipe.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "base/constants.h"
#include "dynamics/run/simulation.h"
#include "modelfile/reading/yaml_reader.h"
#include "statics/moored/moored_lay.h"

namespace overbend {
namespace {

const char* const kModes[] = {"surge", "sway", "heave", "roll", "pitch", "yaw"};

Description calm_lay(TensionerMode tensioner) {
  Description d = read_model(OVERBEND_SOURCE_DIR "/examples/bgl1-moored.yaml").description.value();
  d.environment.waves.front().type = WaveType::none;
  d.environment.current.clear();
  d.mesh.overbend_element = 2.0;
  d.mesh.touchdown_element = 5.0;
  d.mesh.max_element_length = 10.0;
  for (MooringLineDescription& line : d.moorings->lines) {
    for (LineSegmentDescription& segment : line.segments) {
      segment.type.friction = 0.0;
      segment.type.drag_normal = segment.type.drag_axial = 0.0;
    }
  }
  d.pipe.section.hydrodynamics.drag_normal = d.pipe.section.hydrodynamics.drag_axial = 0.0;
  d.tensioner.mode = tensioner;
  d.dynamics = DynamicSettings{};
  d.dynamics->build_up = 1.0;
  return d;
}

struct Decay {
  double period = 0.0;      ///< Between the first and the third crossing of the middle of two turning points [s].
  double of_statics = 0.0;  ///< Period of the linear system: catenaries, the water's mass at the period, no pipe [s].
  double tension = 0.0;     ///< Mean at the tensioner over that time [N].
};

Decay decay(const Description& d, int freedom, double kick) {
  Model model = build_model(d);
  const ModelEquilibrium lay = solve_lay(model);
  EXPECT_FALSE(lay.failure);
  Decay result;
  for (const PeriodResult& mode : lay.moorings->rest.vessel.natural_periods) {
    if (mode.mode == kModes[freedom]) result.of_statics = mode.period;
  }
  DynamicOptions options = dynamic_options(model);
  options.duration = 1.45 * result.of_statics;
  options.release(freedom) = kick;
  Simulation simulation(model, *lay.solution, *d.tensioner.tension, options);
  EXPECT_FALSE(simulation.failure());
  std::vector<std::pair<double, double>> motion;
  std::vector<double> tension;
  while (simulation.step()) {
    tension.push_back(simulation.tension());
    motion.emplace_back(simulation.time(), simulation.present().state->bodies[0].h(freedom));
  }
  EXPECT_FALSE(simulation.failure());
  EXPECT_LT(std::abs(simulation.energy().drift()), 1e-3);
  const auto by_offset = [](const auto& a, const auto& b) { return a.second < b.second; };
  const auto later = motion.begin() + static_cast<std::ptrdiff_t>(motion.size() / 3);
  const double low = std::min_element(motion.begin(), motion.end(), by_offset)->second;
  const double high = std::max_element(later, motion.end(), by_offset)->second, middle = 0.5 * (low + high);
  std::vector<double> crossings;
  double sum = 0.0;
  for (std::size_t i = 1; i < motion.size(); ++i) {
    const auto [t0, x0] = motion[i - 1];
    const auto [t1, x1] = motion[i];
    if ((x0 - middle) * (x1 - middle) < 0.0) crossings.push_back(t0 + (t1 - t0) * (middle - x0) / (x1 - x0));
    if (crossings.size() == 1 || crossings.size() == 2) sum += 0.5 * (t1 - t0) * (tension[i - 1] + tension[i]);
  }
  EXPECT_GE(crossings.size(), 3U);
  result.period = crossings.at(2) - crossings.at(0);
  result.tension = sum / result.period;
  return result;
}

/// Contribution of a pipe whose upper end is held to the surge of its barge: by the shapes at rest of two tensions.
struct HeldPipe {
  double stiffness = 0.0;  ///< [N/m]
  double mass = 0.0;       ///< Mass of the pipe and the water around it, moved as the shapes differ (Rayleigh) [kg].
};

HeldPipe held_pipe(Description d, double wanted) {
  d.moorings.reset();
  d.vessel.motion = VesselMotion::fixed;
  d.mesh.overbend_element = d.mesh.touchdown_element = d.mesh.max_element_length = 2.0;
  const auto at_tension = [&](double tension) {
    d.tensioner.tension = tension;
    return solve_statics(build_model(d)).solution.value();
  };
  const StaticSolution low = at_tension(0.98 * wanted), high = at_tension(1.02 * wanted);
  // Places of the pipe by the length from its upper end, relative to that end; the tangent along the pipe.
  const auto node = [](const StaticSolution& s, std::size_t i, std::size_t part) {
    return Vec3(Eigen::Map<const Vec3>(s.state.q.data() + 6 * i + part));
  };
  const auto place = [&](const StaticSolution& s, double from_top) {
    const double position = s.mesh.s.back() - from_top;
    const auto right =
        static_cast<std::size_t>(std::upper_bound(s.mesh.s.begin(), s.mesh.s.end() - 1, position) - s.mesh.s.begin());
    const double share = (position - s.mesh.s[right - 1]) / (s.mesh.s[right] - s.mesh.s[right - 1]);
    const std::size_t top = s.mesh.s.size() - 1;
    return Vec3((1.0 - share) * node(s, right - 1, 0) + share * node(s, right, 0) - node(s, top, 0));
  };
  const double length = 0.99 * std::min(low.mesh.s.back(), high.mesh.s.back()) - 1.0, step = 1.0;
  const Vec3 far = place(high, length) - place(low, length);  // on the bed: it stays, so the upper end moves by -far
  const Section section = build_model(d).sections.front();
  const double added = 0.25 * std::numbers::pi * section.outer_diameter * section.outer_diameter *
                       d.environment.water_weight_density / kGravity * section.added_mass_normal;
  HeldPipe pipe;
  pipe.stiffness = (high.state.far_force - low.state.far_force) / far.norm();
  for (double l = 0.5 * step; l < length; l += step) {
    const Vec3 moved = (place(high, l) - place(low, l) - far) / far.norm();
    const Vec3 along = (place(high, l + 0.5) - place(high, l - 0.5)).normalized();
    const Vec3 across = moved - moved.dot(along) * along;
    pipe.mass += step * (section.mass() * moved.squaredNorm() + added * across.squaredNorm());
  }
  return pipe;
}

TEST(free_decay, of_the_moored_barge_has_its_natural_periods) {
  // By eigenvalues of hull, fitted memory and restoring of eight wires at 300 kN each: 66.96, 77.15, 44.64 s. Lengths
  // that balance the pipe's pull leave 347 kN at the bow and 253 kN at the stern, whose restoring statics have:
  // surge 67.4 s.
  const Description d = calm_lay(TensionerMode::constant);
  const Decay surge = decay(d, 0, 1.0), yaw = decay(d, 5, 0.2 * kDegree);
  EXPECT_NEAR(yaw.period, 44.64, 0.005 * 44.64);
  EXPECT_NEAR(surge.period, surge.of_statics, 0.005 * surge.of_statics);
  EXPECT_NEAR(surge.of_statics, 66.96, 0.01 * 66.96);
  EXPECT_NEAR(yaw.period, yaw.of_statics, 0.01 * yaw.of_statics);
}

TEST(free_decay, of_a_barge_whose_tensioner_is_locked_has_the_stiffness_and_mass_of_the_pipe) {
  const double free = decay(calm_lay(TensionerMode::constant), 0, 0.5).period;
  const Decay locked = decay(calm_lay(TensionerMode::locked), 0, 0.5);
  const HeldPipe pipe = held_pipe(calm_lay(TensionerMode::constant), locked.tension);
  const double restoring = 1.848e5, mass = restoring * std::pow(free / (2.0 * std::numbers::pi), 2);
  const double expected = 2.0 * std::numbers::pi * std::sqrt((mass + pipe.mass) / (restoring + pipe.stiffness));
  EXPECT_NEAR(locked.period, expected, 0.005 * expected);
  // A catenary of 74 m without mass says 34.3 kN/m and 61.5 s at the full tension.
  const HeldPipe at_set_tension = held_pipe(calm_lay(TensionerMode::constant), 250e3);
  EXPECT_NEAR(at_set_tension.stiffness, 34.3e3, 0.1 * 34.3e3);
}

}  // namespace
}  // namespace overbend
