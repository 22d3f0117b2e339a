/// Order, energy and objectivity of motions without contact.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "support/dynamic_benchmarks.h"

namespace overbend {
namespace {

using namespace testing;

/// A soft chain hung from one end: its fastest vibrations are slow enough for the steps used.
System soft_pendulum(double EI, int elements) {
  System system = rod_system({400.0, EI, 1.2, 1.2 * kGravity}, 2.0, elements);
  first_end(system).hold_place = true;
  first_rod(system).force_scale = 2.4 * kGravity;
  return system;
}

std::vector<double> swung(const System& system, const std::function<double(int)>& step_at, int steps) {
  MovingRod rod(system, straight(system, Vec3::Zero(), Vec3::UnitX()), {0.8, 1e-11, 20});
  rod.begin();
  for (int i = 0; i < steps; ++i) rod.step(step_at(i));
  return rod.line_now().q;
}

double max_deviation(const std::vector<double>& a, const std::vector<double>& b) {
  double max_value = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) max_value = std::max(max_value, std::abs(a[i] - b[i]));
  return max_value;
}

/// Orders seen at two halvings of the step, where `make_step(n)` gives n steps over half a second.
void expect_second_order(const std::function<std::function<double(int)>(int)>& make_step) {
  const System system = soft_pendulum(1.0, 2);
  const std::vector<double> exact = swung(
      system, [](int) { return 0.5 / 6400; }, 6400);
  double before = 0.0;
  for (const int n : {200, 400, 800}) {
    const double error = max_deviation(swung(system, make_step(n), n), exact);
    if (before > 0.0) {
      EXPECT_NEAR(std::log2(before / error), 2.0, 0.15) << n;  // the next order, and the error of the finest: 1/64
    }
    before = error;
  }
  EXPECT_LT(before, 1e-3);
}

TEST(dynamic_accuracy, error_falls_with_the_square_of_the_step) {
  expect_second_order([](int n) { return [n](int) { return 0.5 / n; }; });
}

TEST(dynamic_accuracy, error_falls_with_the_square_of_steps_that_change_every_time) {
  expect_second_order([](int n) {
    const double low = 0.5 / n * 2.0 / 2.3;
    return [low](int i) { return i % 2 == 0 ? low : 1.3 * low; };
  });
}

struct EnergyRecord {
  double max_relative_change = 0.0, last_change = 0.0, exchanged = 0.0;
};

/// Energy of a free flexible pendulum: no force but its own weight, so that the energy stays.
EnergyRecord pendulum_energy(double spectral_radius, double h) {
  const System system = soft_pendulum(5.0, 3);
  MovingRod rod(system, straight(system, Vec3::Zero(), Vec3::UnitX()), {spectral_radius, 1e-11, 20});
  rod.begin();
  const double start = stored(rod.energy());
  EnergyRecord record;
  rod.run(h, static_cast<int>(std::lround(3.0 / h)), [&] {
    const InstantEnergy instant_energy = rod.energy();
    record.last_change = stored(instant_energy) - start;
    record.max_relative_change = std::max(record.max_relative_change, std::abs(record.last_change));
    record.exchanged = std::max(record.exchanged, instant_energy.line.kinetic);
  });
  return record;
}

TEST(dynamic_accuracy, energy_of_a_free_pendulum_is_kept_to_second_order_without_damping) {
  const EnergyRecord coarse = pendulum_energy(1.0, 0.002), fine = pendulum_energy(1.0, 0.001);
  EXPECT_LT(coarse.max_relative_change, 1e-4 * coarse.exchanged);                // 1000 steps to a swing
  EXPECT_NEAR(coarse.max_relative_change / fine.max_relative_change, 4.0, 0.8);  // largest values fall between steps
}

TEST(dynamic_accuracy, energy_of_a_free_pendulum_only_drains_with_damping) {
  const EnergyRecord damped = pendulum_energy(0.8, 0.002), undamped = pendulum_energy(1.0, 0.002);
  EXPECT_LT(damped.last_change, 0.0);
  EXPECT_GT(-damped.last_change, std::abs(undamped.last_change));
  EXPECT_LT(-damped.last_change, 1e-4 * damped.exchanged);  // slow swings are hardly touched
}

/// A slack pipe between two held ends, partly on the bed, its right end moved up and down in water: stored energy
/// plus losses minus work, by the trapezoidal rule, largest over the run.
double sagbend_imbalance(double h) {
  RodMaterial pipe{2e7, 2e5, 200.0, 200.0 * kGravity, 1400.0, 0.2};
  pipe.drag_normal = 0.5 * 1025.0 * 1.2 * 0.4;
  pipe.displaced_mass = pipe.added_normal = 140.0;
  System system = rod_system(pipe, 40.0, 20);
  first_rod(system).environment.bed_offset = -30.2;
  first_rod(system).environment.bed_stiffness = 2e4;
  first_rod(system).environment.bed_friction_lateral = 0.5;
  first_rod(system).environment.bed_stick = 2e4;
  first_end(system).hold_place = last_end(system).hold_place = true;
  first_rod(system).force_scale = 40.0 * pipe.weight;
  system.surroundings = [](double t, Surroundings& surroundings) {
    const double w = 3.0;
    surroundings.ends[0].place = Vec3(0.0, 0.0, -30.0);
    surroundings.ends[1].place = Vec3(40.0, 0.0, -30.0 + 0.5 * (1.0 - std::cos(w * t)));
    surroundings.ends[1].velocity = Vec3(0.0, 0.0, 0.5 * w * std::sin(w * t));
    surroundings.ends[1].acceleration = Vec3(0.0, 0.0, 0.5 * w * w * std::cos(w * t));
  };
  MovingRod rod(system, straight(system, Vec3(0.0, 0.0, -30.0), Vec3::UnitX()), {0.8, 1e-10, 20});
  rod.begin();
  rod.step(1e-6);  // so that the first energy is that of a state in balance, contacts and all
  InstantEnergy before = rod.energy();
  const double start = stored(before);
  double work = 0.0, max_value = 0.0;
  const auto power = [](const InstantEnergy& e) {
    return e.line.fluid_power + e.top_power + e.anchor_power - e.line.seabed_loss;
  };
  rod.run(h, static_cast<int>(std::lround(2.0 / h)), [&] {
    const InstantEnergy instant_energy = rod.energy();
    work += 0.5 * h * (power(before) + power(instant_energy));
    max_value = std::max(max_value, std::abs(stored(instant_energy) - start - work));
    before = instant_energy;
  });
  return max_value;
}

TEST(dynamic_accuracy, energy_balance_with_drag_and_bed_closes_to_second_order) {
  const double coarse = sagbend_imbalance(0.008), middle = sagbend_imbalance(0.004), fine = sagbend_imbalance(0.002);
  EXPECT_NEAR(std::log2(coarse / middle), 2.0, 0.3);  // the pipe leaves the bed point by point: small kinks
  EXPECT_NEAR(std::log2(middle / fine), 2.0, 0.3);
}

TEST(dynamic_accuracy, a_bent_pipe_turned_as_a_whole_keeps_its_strain_energy_and_turns_its_forces) {
  const System system = rod_system({2e7, 2e5, 200.0}, 11.0, 10);
  Assembly assembly(system);
  const std::vector<double> q = wavy_line(11, 1.1, Vec3(0.0, 0.0, 0.0), 3);
  const auto evaluated = [&](const Mat3& turn) {
    std::vector<double> turned(q.size());
    for (std::size_t i = 0; i < q.size(); i += 3) {
      Eigen::Map<Vec3>(turned.data() + i) = turn * Eigen::Map<const Vec3>(q.data() + i);
    }
    SystemState state = state_at_rest(system, {turned}, 0.0);
    assembly.set_time(0.0, state);
    const SystemState before = state;
    assembly.evaluate(state, before, {}, false);
    return assembly.energy(state).line.strain;
  };
  const double energy = evaluated(Mat3::Identity());
  const std::vector<double> force = assembly.line(0).residual();
  for (const double angle : {0.4, 1.9, 3.0}) {
    const Mat3 turn = Eigen::AngleAxisd(angle, Vec3(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
    EXPECT_NEAR(evaluated(turn), energy, 1e-12 * energy);  // rounding
    double size = 0.0, difference = 0.0;
    for (std::size_t i = 0; i < force.size(); i += 3) {
      const Vec3 expected = turn * Eigen::Map<const Vec3>(force.data() + i);
      size = std::max(size, expected.norm());
      difference =
          std::max(difference, (Eigen::Map<const Vec3>(assembly.line(0).residual().data() + i) - expected).norm());
    }
    EXPECT_LT(difference, 1e-11 * size);
  }
}

}  // namespace
}  // namespace overbend
