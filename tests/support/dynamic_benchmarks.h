/// Single-effect problems in time with known answers, solved by the engine. Tests and the validation page share them.
#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/fixtures.h"
#include "support/moving_rod.h"

namespace overbend::testing {

/// Stiffness and mass of a rod in the shape of `state`, as the element kernel gives them; ends free.
struct StiffnessAndMass {
  Eigen::MatrixXd stiffness, mass;
};
inline StiffnessAndMass stiffness_and_mass(Assembly& assembly, const SystemState& state) {
  SystemState system_state = state, after = state;
  assembly.set_time(system_state.time, system_state);
  assembly.evaluate(after, system_state, {0.0, 0.0, 0.0}, true);
  StiffnessAndMass both;
  both.stiffness = dense(assembly.line(0).tangent());
  constexpr double kShare = 1e8;  // so large that taking the stiffness away again costs no digits of the mass [1/s2]
  assembly.evaluate(after, system_state, {0.0, kShare, 0.0}, true);
  both.mass = (dense(assembly.line(0).tangent()) - both.stiffness) / kShare;
  return both;
}

/// The 16-inch pipe in air under a pull of 250 kN over 60 m.
struct TensionedBeam {
  static constexpr double kEI = 55894.9e3, kMass = 800.0, kTension = 250e3, kLength = 60.0;
  static constexpr double kEA = 2859.694e6;
  static constexpr double kStretch = kTension / kEA;

  System system;
  std::vector<double> q;

  TensionedBeam(bool clamped, int elements, double added_mass = 0.0) {
    RodMaterial pipe{kEA, kEI, kMass};
    pipe.added_normal = added_mass;
    // Stretched it is 60 m long and has 800 kg/m.
    pipe.mass *= 1.0 + kStretch;
    pipe.added_normal *= 1.0 + kStretch;
    system = rod_system(pipe, kLength / (1.0 + kStretch), elements);
    const double depth = added_mass > 0.0 ? -10.0 : 0.0;
    q = straight(system, Vec3(0.0, 0.0, depth), Vec3::UnitX(), kStretch);
    hold_ends(system, true, clamped);
    first_rod(system).force_scale = kTension;
    system.surroundings = [depth](double, Surroundings& surroundings) {
      surroundings.ends[0].place = Vec3(0.0, 0.0, depth);
      surroundings.ends[1].place = Vec3(kLength, 0.0, depth);
    };
  }
};

/// Frequencies of vibration in the vertical plane, rising [Hz].
inline std::vector<double> beam_frequencies(bool clamped, int elements) {
  const TensionedBeam beam(clamped, elements);
  Assembly assembly(beam.system);
  const StiffnessAndMass full = stiffness_and_mass(assembly, state_at_rest(beam.system, {beam.q}, 0.0));
  std::vector<int> free;
  for (int node = 0; node <= elements; ++node) {
    const bool end = node == 0 || node == elements;
    if (!end) free.push_back(6 * node + 2);
    if (!end || !clamped) free.push_back(6 * node + 5);
  }
  const Eigen::MatrixXd k = full.stiffness(free, free), m = full.mass(free, free);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(k, m, Eigen::EigenvaluesOnly);
  std::vector<double> frequencies;
  for (const double square : modes.eigenvalues()) {
    frequencies.push_back(std::sqrt(square) / (2.0 * std::numbers::pi));
  }
  return frequencies;
}

/// Times at which a signal passes zero upwards or downwards, by the cubic through values and slopes.
class ZeroCrossings {
 public:
  void add(double time, double value, double slope) {
    if (filled_ && value * value_ < 0.0) {
      times_.push_back(crossing(time, value, slope));
    }
    filled_ = true;
    time_ = time;
    value_ = value;
    slope_ = slope;
  }
  const std::vector<double>& times() const { return times_; }

 private:
  double crossing(double time, double value, double slope) const {
    const double h = time - time_;
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 50; ++i) {
      const double x = 0.5 * (low + high);
      const double y = 1.0 - x;
      const double f = (1.0 + 2.0 * x) * y * y * value_ + x * y * y * h * slope_ + x * x * (3.0 - 2.0 * x) * value -
                       x * x * y * h * slope;
      (f * value_ > 0.0 ? low : high) = x;
    }
    return time_ + 0.5 * (low + high) * h;
  }

  bool filled_ = false;
  double time_ = 0.0, value_ = 0.0, slope_ = 0.0;
  std::vector<double> times_;
};

/// Frequency of the first mode of the pinned beam released from its shape, from the record of its middle [Hz].
inline double first_frequency_in_time(int elements, double h) {
  TensionedBeam beam(false, elements);
  MovingRod rod(beam.system, beam.q, {1.0, 1e-9, 12});
  for (int node = 0; node <= elements; ++node) {
    const double x = std::numbers::pi * node / elements;
    rod.line_now().v[static_cast<std::size_t>(6 * node + 2)] = 1e-3 * std::sin(x);
    rod.line_now().v[static_cast<std::size_t>(6 * node + 5)] =
        1e-3 * (1.0 + TensionedBeam::kStretch) * std::numbers::pi / TensionedBeam::kLength * std::cos(x);
  }
  rod.begin();
  ZeroCrossings crossings;
  const auto record = [&] { crossings.add(rod.state.time, rod.r(elements / 2).z(), rod.v(elements / 2).z()); };
  const int steps = static_cast<int>(12.0 / h);
  rod.run(h, steps, record);
  const std::vector<double>& times = crossings.times();
  return 0.5 * static_cast<double>(times.size() - 1) / (times.back() - times.front());
}

/// Extension of the end of a beam that is spun up in its plane within 15 s to 6 rad/s [m]; Simo and Vu-Quoc (1986).
inline double spin_up_extension(int elements, double h) {
  static constexpr double kLength = 10.0, kRise = 15.0, kSpeed = 6.0;
  System system = rod_system({2.8e7, 1.4e4, 1.2}, kLength, elements);
  hold(first_end(system), true, true);
  first_rod(system).force_scale = 1e3;  // the pull at the hub is 2160 N
  system.surroundings = [](double t, Surroundings& surroundings) {
    const double w = 2.0 * std::numbers::pi / kRise;
    const double s = std::min(t, kRise);
    const double angle = kSpeed / kRise * (0.5 * s * s + (std::cos(w * s) - 1.0) / (w * w)) + kSpeed * (t - s);
    const double rate = kSpeed / kRise * (s - std::sin(w * s) / w);
    const double acceleration = kSpeed / kRise * (1.0 - std::cos(w * s));
    const Vec3 along(std::cos(angle), std::sin(angle), 0.0), across(-along.y(), along.x(), 0.0);
    surroundings.ends[0].direction = along;
    surroundings.ends[0].direction_rate = rate * across;
    surroundings.ends[0].direction_acceleration = acceleration * across - rate * rate * along;
  };
  MovingRod rod(system, straight(system, Vec3::Zero(), Vec3::UnitX()));
  rod.begin();
  rod.run(h, static_cast<int>(std::lround(kRise / h)));
  // The mean of a turn: what the end still swings is left out.
  double sum = 0.0;
  const int turn = static_cast<int>(std::lround(1.0 / h));
  rod.run(h, turn, [&] { sum += rod.r(elements).norm() - kLength; });
  return sum / turn;
}

/// Period of a stiff bar suspended from its end, released at `angle` from the vertical, in steps of a 400th of
/// `expected` [s].
inline double bar_pendulum_period(double angle, double expected) {
  System system = rod_system({1e8, 1e9, 1.0, kGravity}, 10.0, 1);
  last_end(system).hold_place = false;
  first_end(system).hold_place = true;
  first_rod(system).force_scale = 10.0 * kGravity;
  MovingRod rod(system, straight(system, Vec3::Zero(), Vec3(std::sin(angle), 0.0, -std::cos(angle))));
  rod.begin();
  ZeroCrossings crossings;
  rod.run(expected / 400.0, 320, [&] { crossings.add(rod.state.time, rod.r(1).x(), rod.v(1).x()); });
  return 2.0 * (crossings.times().at(1) - crossings.times().at(0));
}

/// Places of the free end of the flexible pendulum of benchmark B07d every 0.25 s, up to 1.5 s.
inline std::vector<Vec3> flexible_pendulum_tip(int elements, double h) {
  System system = rod_system({1e6, 50.0, 1.2, 1.2 * kGravity}, 2.0, elements);
  first_end(system).hold_place = true;
  first_rod(system).force_scale = 2.4 * kGravity;
  MovingRod rod(system, straight(system, Vec3::Zero(), Vec3::UnitX()));
  rod.begin();
  std::vector<Vec3> places;
  for (int i = 0; i < 6; ++i) {
    rod.run(h, static_cast<int>(std::lround(0.25 / h)));
    places.push_back(rod.r(elements));
  }
  return places;
}

/// A pipe that sinks level from rest.
struct SinkingPipe {
  double speed_1s = 0.0, speed_5s = 0.0, drop_5s = 0.0;
};
inline SinkingPipe sinking_pipe(double h) {
  constexpr double kRho = 1025.0, kD = 0.489, kCd = 1.2, kSubmerged = 368.493, kMass = 230.041349492;
  RodMaterial pipe{2.86e9, 55.9e6, kMass, kMass * kGravity, kMass * kGravity - kSubmerged, 0.5 * kD};
  pipe.drag_normal = 0.5 * kRho * kCd * kD;
  pipe.displaced_mass = pipe.added_normal = kRho * 0.25 * std::numbers::pi * kD * kD;
  System system = rod_system(pipe, 12.0, 3);
  first_rod(system).force_scale = 12.0 * pipe.weight;
  MovingRod rod(system, straight(system, Vec3(0.0, 0.0, -20.0), Vec3::UnitX()));
  rod.begin();
  SinkingPipe result;
  const int second = static_cast<int>(std::lround(1.0 / h));
  rod.run(h, second);
  result.speed_1s = -rod.v(1).z();
  rod.run(h, 4 * second);
  result.speed_5s = -rod.v(1).z();
  result.drop_5s = -20.0 - rod.r(1).z();
  return result;
}

/// A pipe of 0.5 t that meets a roller of 5e4 kN/m at 1 m/s, without gravity.
struct RollerImpact {
  double rebound = 0.0;                   ///< Speed away from the roller [m/s].
  double duration = 0.0;                  ///< Duration of the force [s].
  double penetration = 0.0, force = 0.0;  ///< Largest [m], [N].
};
inline RollerImpact roller_impact(double damping, double h) {
  constexpr double kStiffness = 5e7, kMass = 500.0;
  // As short and stiff as a point: its first own frequency is 500 times that of the contact.
  System system = rod_system({1e12, 2.5e10, kMass}, 1.0, 1);
  ContactLaw law;
  law.stiffness = kStiffness;
  law.damping = damping;
  system.bodies[0].rollers = {roller_under(0.5, 0.01, law)};
  system.bodies[0].cells = endless_cells();
  first_rod(system).force_scale = 1e5;
  MovingRod rod(system, straight(system, Vec3::Zero(), Vec3::UnitX()));
  push(rod.state, Vec3(0.0, 0.0, -1.0));
  rod.begin();
  RollerImpact impact;
  rod.run(h, static_cast<int>(0.02 / h), [&] {
    const RollerContact& contact = rod.contacts()[0];
    if (contact.normal > 0.0) impact.duration = rod.state.time;
    impact.penetration = std::max(impact.penetration, contact.penetration);
    impact.force = std::max(impact.force, contact.normal);
  });
  impact.rebound = 0.5 * (rod.v(0).z() + rod.v(1).z());
  return impact;
}

}  // namespace overbend::testing
