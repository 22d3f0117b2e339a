/// Forced motion against linear theory, and the two integrators against each other.
#include <gtest/gtest.h>

#include <cmath>

#include "support/dynamic_benchmarks.h"
#include "support/explicit_step.h"

namespace overbend {
namespace {

using namespace testing;

constexpr double kOmega = 2.0 * std::numbers::pi * 0.4;  // between the first and the second mode [rad/s]
constexpr double kAmplitude = 1e-3;                      // of the right end, so small that all is linear [m]

/// Shape of the pinned tensioned beam whose right end moves up and down by 1, and its slope: EI u'''' - T u'' = m w2 u,
/// no deflection at the left, no moment at either end.
struct DrivenBeam {
  double p, q;
  explicit DrivenBeam(double mass) {
    const double half = 0.5 * TensionedBeam::kTension / TensionedBeam::kEI;
    const double root = std::sqrt(half * half + mass * kOmega * kOmega / TensionedBeam::kEI);
    p = std::sqrt(root + half);
    q = std::sqrt(root - half);
  }
  double value(double x) const {
    const double L = TensionedBeam::kLength;
    return (p * p * std::sin(q * x) / std::sin(q * L) + q * q * std::sinh(p * x) / std::sinh(p * L)) / (p * p + q * q);
  }
  double slope(double x) const {
    const double L = TensionedBeam::kLength;
    return p * q * (p * std::cos(q * x) / std::sin(q * L) + q * std::cosh(p * x) / std::sinh(p * L)) / (p * p + q * q);
  }
};

/// Largest difference from the steady response over two periods, the start being on it.
double difference_from_linear_response(double added_mass, double h) {
  constexpr int kElements = 20;
  TensionedBeam beam(false, kElements, added_mass);
  const DrivenBeam exact(TensionedBeam::kMass + added_mass);
  const auto at_rest = beam.system.surroundings;
  beam.system.surroundings = [at_rest](double t, Surroundings& surroundings) {
    at_rest(t, surroundings);
    surroundings.ends[1].place.z() += kAmplitude * std::sin(kOmega * t);
    surroundings.ends[1].velocity = Vec3(0.0, 0.0, kAmplitude * kOmega * std::cos(kOmega * t));
    surroundings.ends[1].acceleration = Vec3(0.0, 0.0, -kAmplitude * kOmega * kOmega * std::sin(kOmega * t));
  };
  MovingRod rod(beam.system, beam.q, {0.8, 1e-9, 12});
  for (int node = 0; node <= kElements; ++node) {
    const double x = TensionedBeam::kLength * node / kElements;
    const std::size_t dof = 6 * static_cast<std::size_t>(node);
    rod.line_now().v[dof + 2] = kAmplitude * kOmega * exact.value(x);
    rod.line_now().v[dof + 5] = kAmplitude * kOmega * exact.slope(x) * (1.0 + TensionedBeam::kStretch);
  }
  rod.begin();
  double max_value = 0.0;
  rod.run(h, static_cast<int>(5.0 / h), [&] {
    for (int node = 0; node <= kElements; ++node) {
      const double x = TensionedBeam::kLength * node / kElements;
      const double expected = kAmplitude * exact.value(x) * std::sin(kOmega * rod.state.time);
      const double level = place(beam.q, node).z();
      max_value = std::max(max_value, std::abs(rod.r(node).z() - level - expected));
    }
  });
  return max_value;
}

TEST(dynamic_response, lateral_motion_of_an_end_in_air_is_answered_as_linear_theory_says) {
  // Periods are longer by (w h)^2/12 = 5e-5 and more for what is free; two periods add up to 1e-3 of the amplitude.
  EXPECT_LT(difference_from_linear_response(0.0, 0.01), 1e-3 * kAmplitude);
}

TEST(dynamic_response, lateral_motion_of_an_end_in_water_moves_the_added_mass_too) {
  EXPECT_LT(difference_from_linear_response(400.0, 0.01), 1e-3 * kAmplitude);
  // Without the added mass the middle would move by fifty times that tolerance less.
  EXPECT_GT(std::abs(DrivenBeam(1200.0).value(30.0) - DrivenBeam(800.0).value(30.0)), 0.05);
}

/// A pipe in water between a held end on the bed and a top that is led down: drag, bed with friction and damping, and
/// a roller that it hits.
System coarse_sagbend() {
  RodMaterial pipe{2e6, 5e5, 150.0, 150.0 * kGravity, 1000.0, 0.2};
  pipe.drag_normal = 0.5 * 1025.0 * 1.2 * 0.4;
  pipe.displaced_mass = pipe.added_normal = 130.0;
  System system = rod_system(pipe, 30.0, 10);
  first_rod(system).environment.bed_offset = -30.2;
  first_rod(system).environment.bed_stiffness = 2e4;
  first_rod(system).environment.bed_stick = 2e4;
  first_rod(system).environment.bed_friction_lateral = 0.5;
  first_rod(system).environment.bed_damping = 1e3;
  first_end(system).hold_place = first_end(system).hold_direction = last_end(system).hold_place = true;
  first_rod(system).force_scale = 30.0 * pipe.weight;
  ContactLaw law;
  law.stiffness = 5e4;
  law.damping = 2e3;
  law.tangential_stiffness = 1e4;
  law.friction_axial = 0.1;
  law.friction_lateral = 0.3;
  system.bodies[0].rollers = {roller_under(20.0, 0.2, law)};
  system.bodies[0].rollers[0].center_V.z() += -28.1;
  system.bodies[0].cells = endless_cells();
  system.surroundings = [](double t, Surroundings& surroundings) {
    constexpr double kRate = 3.0;
    surroundings.ends[0].place = Vec3(0.0, 0.0, -30.0);
    surroundings.ends[0].direction = Vec3::UnitX();
    surroundings.ends[1].place = Vec3(29.0, 0.5 * std::sin(kRate * t), -26.0 - 0.6 * (1.0 - std::cos(kRate * t)));
    surroundings.ends[1].velocity = Vec3(0.0, 0.5 * kRate * std::cos(kRate * t), -0.6 * kRate * std::sin(kRate * t));
    surroundings.ends[1].acceleration =
        kRate * kRate * Vec3(0.0, -0.5 * std::sin(kRate * t), -0.6 * std::cos(kRate * t));
  };
  return system;
}

/// A cubic from the bed to the top.
std::vector<double> sagging(const System& system) {
  std::vector<double> q;
  for (const double s : first_rod(system).mesh.s) {
    const double u = s / 30.0;
    q.insert(q.end(), {29.0 * u, 0.0, -30.0 + 4.0 * u * u * (1.5 - 0.5 * u), 29.0 / 30.0, 0.0,
                       4.0 / 30.0 * u * (3.0 - 1.5 * u)});
  }
  return q;
}

/// The shape after 1 s, and when the roller was hit on the way.
struct Ride {
  std::vector<double> q;
  double first_hit = 0.0;  ///< Time; 0 if none [s].
};

void record(MovingRod& rod, Ride& ride) {
  if (ride.first_hit == 0.0 && rod.contacts()[0].normal > 0.0) ride.first_hit = rod.state.time;
}

Ride implicit_ride(double h) {
  const System system = coarse_sagbend();
  MovingRod rod(system, sagging(system), {0.9, 1e-8, 20});
  rod.line_now().v[rod.line_now().v.size() - 5] = 1.5;
  rod.begin();
  Ride ride;
  rod.run(h, static_cast<int>(std::lround(1.0 / h)), [&] { record(rod, ride); });
  ride.q = rod.line_now().q;
  return ride;
}

Ride explicit_ride(double h) {
  const System system = coarse_sagbend();
  MovingRod rod(system, sagging(system));
  rod.line_now().v[rod.line_now().v.size() - 5] = 1.5;
  rod.begin();
  SystemState next = rod.state;
  Ride ride;
  for (int i = 0; i < static_cast<int>(std::lround(1.0 / h)); ++i) {
    if (!explicit_step(rod.assembly(), rod.state, h, next)) throw std::runtime_error("unstable");
    std::swap(rod.state, next);
    record(rod, ride);
  }
  ride.q = rod.line_now().q;
  return ride;
}

double max_state_distance(const std::vector<double>& a, const std::vector<double>& b) {
  double max_value = 0.0;
  for (int node = 0; node < static_cast<int>(a.size()) / 6; ++node) {
    max_value = std::max(max_value, (place(a, node) - place(b, node)).norm());
  }
  return max_value;
}

TEST(explicit_step, agrees_with_the_implicit_scheme_on_a_sagbend_that_hits_a_roller) {
  const double h = 5e-4;
  const Ride a = explicit_ride(h), b = implicit_ride(h);
  // Points of the pipe have moved by a metre. Friction and the jump of a damped contact leave errors of first order in
  // both: each is 1.2e-4 m from what both tend to.
  EXPECT_LT(max_state_distance(a.q, b.q), 2e-4);
  EXPECT_GT(max_state_distance(a.q, sagging(coarse_sagbend())), 1.0);
  EXPECT_GT(a.first_hit, 0.1);
  EXPECT_NEAR(a.first_hit, b.first_hit, 2.0 * h);
}

TEST(explicit_step, tends_to_what_the_implicit_scheme_tends_to) {
  const Ride fine = explicit_ride(1e-4);
  const double coarse = max_state_distance(implicit_ride(4e-3).q, fine.q);
  EXPECT_LT(max_state_distance(implicit_ride(1e-3).q, fine.q), 0.5 * coarse);  // first order would give a quarter
}

/// A soft chain released level, after half a second, in `steps` steps of central differences.
std::vector<double> explicit_pendulum(int steps) {
  System system = rod_system({400.0, 1.0, 1.2, 1.2 * kGravity}, 2.0, 2);
  first_end(system).hold_place = true;
  first_rod(system).force_scale = 2.4 * kGravity;
  MovingRod rod(system, straight(system, Vec3::Zero(), Vec3::UnitX()));
  rod.begin();
  SystemState next = rod.state;
  for (int i = 0; i < steps; ++i) {
    if (!explicit_step(rod.assembly(), rod.state, 0.5 / steps, next)) throw std::runtime_error("unstable");
    std::swap(rod.state, next);
  }
  return rod.line_now().q;
}

TEST(explicit_step, error_falls_with_the_square_of_the_step) {
  const std::vector<double> exact = explicit_pendulum(6400);
  const double coarse = max_state_distance(explicit_pendulum(400), exact);
  const double fine = max_state_distance(explicit_pendulum(800), exact);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.1);  // the finest errs by 1/64 of `fine`
  EXPECT_LT(fine, 1e-4);
}

TEST(explicit_step, says_so_when_steps_are_too_long_to_be_stable) {
  const System system = coarse_sagbend();
  MovingRod rod(system, sagging(system));
  rod.begin();
  SystemState next = rod.state;
  bool finite = true;
  for (int i = 0; i < 1000 && finite; ++i) {
    finite = explicit_step(rod.assembly(), rod.state, 0.05, next);
    std::swap(rod.state, next);
  }
  EXPECT_FALSE(finite);
}

}  // namespace
}  // namespace overbend
