// Sections of a stinger on hinges in time, without a pipe: against closed forms and against equations of one and two
// freedoms that are integrated here.
#include "system/hinged_sections.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "base/constants.h"
#include "dynamics/integrator/dynamic_checkpoint.h"
#include "dynamics/integrator/energy_account.h"
#include "dynamics/integrator/time_step.h"
#include "model/pipe/section.h"
#include "support/allocation_count.h"

namespace overbend {
namespace {

constexpr double kMass = 2e5, kArm = 20.0, kOwnInertia = 2e7;  // [kg], [m], [kg m2]

std::shared_ptr<SectionSea> calm_sea(double weight_density = 10.05e3) {
  auto sea = std::make_shared<SectionSea>();
  sea->weight_density = weight_density;
  return sea;
}

/// A section as drawn: level astern of a hinge at `hinge_V`, with the mass of a stinger `kArm` from it.
FreeBody level_section(int carrier, const Vec3& hinge_V, double angle) {
  FreeBody free;
  HingedBody& hinged = free.hinge.emplace();
  hinged.carrier = carrier;
  hinged.hinge.place_V = hinge_V;
  hinged.section.mass = kMass;
  hinged.section.center_V = hinge_V - kArm * Vec3::UnitX();
  hinged.section.inertia_V = kOwnInertia * (Mat3::Identity() - Vec3::UnitX() * Vec3::UnitX().transpose());
  hinged.sea = calm_sea();
  free.force_scale = kMass * kGravity;
  free.arm = kArm;
  free.inertia(kHingeFreedom) = kMass * kArm * kArm + kOwnInertia;
  free.rest.h(kHingeFreedom) = angle;
  return free;
}

const double kInertia = kMass * kArm * kArm + kOwnInertia;

RigidMotion barge_at_rest(double /*time*/) {
  return {};
}

/// Bodies without lines, their integrator and their present.
class HingedRun {
 public:
  HingedRun(std::vector<FreeBody> sections, std::function<RigidMotion(double)> barge = barge_at_rest,
            double spectral_radius = 1.0)
      : system_(made(std::move(sections), std::move(barge))),
        assembly_(system_),
        stepper_(assembly_, {spectral_radius, 1e-11, 30}),
        state(state_at_rest(system_, {}, 0.0)) {}
  HingedRun(const HingedRun&) = delete;
  HingedRun& operator=(const HingedRun&) = delete;

  void begin() {
    assembly_.set_time(state.time, state);
    assembly_.impose_ends(state);
    ASSERT_TRUE(assembly_.find_accelerations(state));
    for (HullState& body : state.bodies) body.algorithmic_acceleration = body.acc;
    assembly_.evaluate(state, state, {}, false);
    next_ = state;
    energy_.start(assembly_.energy(state), 1.0);
  }
  void step(double h) {
    const StepReport report = stepper_.step(state, h, next_);
    EXPECT_TRUE(report.converged()) << state.time << " " << report.residual;
    energy_.add(assembly_.energy(next_), h);
    std::swap(state, next_);
  }
  void steps(double h, int count) {
    for (int i = 0; i < count; ++i) step(h);
  }
  double angle(std::size_t i = 0) const { return state.bodies[i].h(kHingeFreedom); }
  double& rate(std::size_t i = 0) { return state.bodies[i].v(kHingeFreedom); }
  HingeReading reading(std::size_t i = 0) const { return assembly_.hinged().reading(i); }
  const EnergyBalance& energy() const { return energy_.balance(); }
  TimeStepper& stepper() { return stepper_; }
  /// Mean time between passages of the first angle through `middle` upwards, over `count` of them [s].
  double period(double h, double middle, int count) {
    std::vector<double> passed;
    while (static_cast<int>(passed.size()) <= count && state.time < 1e4) {
      const double before = angle() - middle;
      step(h);
      const double after = angle() - middle;
      if (before < 0.0 && after >= 0.0) passed.push_back(state.time - h * after / (after - before));
    }
    return (passed.back() - passed.front()) / count;
  }

 private:
  static System made(std::vector<FreeBody> sections, std::function<RigidMotion(double)> barge) {
    System system;
    system.bodies.emplace_back();
    for (FreeBody& section : sections) system.bodies.emplace_back().free = std::move(section);
    system.surroundings = [barge = std::move(barge)](double time, Surroundings& surroundings) {
      surroundings.bodies.front() = barge(time);
    };
    return system;
  }

  System system_;
  Assembly assembly_;
  TimeStepper stepper_;
  SystemState next_;
  EnergyAccount energy_;

 public:
  SystemState state;
};

using Values = std::vector<double>;

/// Classical Runge-Kutta.
void runge_kutta(Values& y, double& t, double h, const std::function<Values(double, const Values&)>& rates) {
  const auto ahead = [&](const Values& k, double by) {
    Values sample = y;
    for (std::size_t i = 0; i < y.size(); ++i) sample[i] += by * k[i];
    return sample;
  };
  const Values a = rates(t, y), b = rates(t + 0.5 * h, ahead(a, 0.5 * h)), c = rates(t + 0.5 * h, ahead(b, 0.5 * h)),
               d = rates(t + h, ahead(c, h));
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
  t += h;
}

// The integrator's period is longer by (omega h)^2 / 12: 1e-4 here; the swing of 0.02 rad lengthens it by 2.5e-5.
TEST(hinged_section, in_air_swings_with_the_period_of_a_compound_pendulum) {
  HingedRun run({level_section(0, Vec3::Zero(), 0.5 * kPi - 0.02)});
  run.begin();
  const double expected = 2.0 * kPi * std::sqrt(kInertia / (kMass * kGravity * kArm));
  EXPECT_NEAR(run.period(expected / 200.0, 0.5 * kPi, 3), expected, 5e-4 * expected);
}

TEST(hinged_section, in_air_keeps_its_energy_over_a_large_swing) {
  HingedRun run({level_section(0, Vec3::Zero(), 0.2)});
  run.begin();
  run.steps(0.02, 1000);
  EXPECT_LT(std::abs(run.energy().error), 1e-4 * kMass * kGravity * kArm);
}

// The hinge of a pendulum at rest, released level: W (1 - m r^2 / I) upwards.
TEST(hinged_section, let_go_level_is_held_by_its_hinge_with_the_weight_that_does_not_fall) {
  HingedRun run({level_section(0, Vec3(-3.0, 0.5, 2.0), 0.0)});
  run.begin();
  const Vec3 force = run.reading().force;
  EXPECT_NEAR(force.z(), kMass * kGravity * (1.0 - kMass * kArm * kArm / kInertia), 1e-3 * kMass);
  EXPECT_NEAR(force.x(), 0.0, 1.0);
  EXPECT_NEAR(run.state.bodies[0].acc(kHingeFreedom), kMass * kGravity * kArm / kInertia, 1e-9);
}

/// A tank on the line from the hinge, which stands `height` above the water, out to `reach`.
struct FloatingTank {
  double height = 2.0, reach = 36.0, diameter = 1.6, weight_density = 10.05e3;
  double area() const { return 0.25 * kPi * diameter * diameter; }
  /// Moment of the buoyancy about the hinge, raising the tip, at an angle below the level.
  double moment(double angle) const {
    const double from = height / std::sin(angle);
    return weight_density * area() * std::cos(angle) * 0.5 * (reach * reach - from * from);
  }
  FreeBody section(double angle, double drag, double added_mass) const {
    FreeBody free = level_section(0, Vec3(0.0, 0.0, height), angle);
    HingedBody& hinged = *free.hinge;
    hinged.hinge.rest = 0.0;
    constexpr int kStrips = 36;
    for (int i = 0; i < kStrips; ++i) {
      const auto sample = [&](int k) { return Vec3(-reach * k / kStrips, 0.0, height); };
      hinged.section.strips.push_back({sample(i), sample(i + 1), diameter, drag, added_mass, 0});
    }
    hinged.section.mass = 0.5 * weight_density * area() * reach / kGravity;
    hinged.section.center_V = Vec3(-0.5 * reach, 0.0, height);
    hinged.section.inertia_V.setZero();
    return free;
  }
  double weight_moment(double angle) const {
    return 0.5 * weight_density * area() * reach * 0.5 * reach * std::cos(angle);
  }
  double rest() const {
    double low = 0.01, high = 1.2;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (moment(middle) < weight_moment(middle) ? low : high) = middle;
    }
    return low;
  }
};

// Added mass grows with the wet length: the small swing takes its mean. Strips of a metre leave 1e-3.
TEST(hinged_section, on_a_tank_rests_at_the_hydrostatic_angle_and_swings_with_its_period) {
  const FloatingTank tank;
  const double rest = tank.rest(), added = 1.0;
  HingedRun run({tank.section(rest + 0.002, 0.0, added)});
  run.begin();
  constexpr double kChange = 1e-5;
  const auto unbalance = [&](double angle) { return tank.moment(angle) - tank.weight_moment(angle); };
  const double stiffness = (unbalance(rest + kChange) - unbalance(rest - kChange)) / (2.0 * kChange);
  const double from = tank.height / std::sin(rest), density = tank.weight_density / kGravity;
  const double mass = 0.5 * density * tank.area() * tank.reach;
  const double inertia = mass * 0.25 * tank.reach * tank.reach +
                         added * density * tank.area() * (std::pow(tank.reach, 3) - std::pow(from, 3)) / 3.0;
  const double expected = 2.0 * kPi * std::sqrt(inertia / stiffness);
  EXPECT_NEAR(run.period(expected / 100.0, rest, 3), expected, 0.01 * expected);
  EXPECT_NEAR(run.reading().draught, tank.reach * std::sin(run.angle()) - tank.height, 1e-9);
}

TEST(hinged_section, that_drags_through_the_water_loses_what_its_energy_falls_by) {
  const FloatingTank tank;
  FreeBody section = tank.section(tank.rest() + 0.15, 1.2, 1.0);
  section.hinge->law.friction = 2e4;
  HingedRun run({std::move(section)});
  run.begin();
  run.steps(0.02, 1500);
  EXPECT_LT(std::abs(run.angle() - tank.rest()), 0.1);
  EXPECT_LT(std::abs(run.energy().error), 1e-3 * run.energy().throughput + 1e-4 * 1e7);
}

/// The motion of a pendulum that runs into a stop, by small steps.
TEST(hinged_section, rebounds_from_a_stop_as_the_equation_of_one_freedom_does) {
  FreeBody section = level_section(0, Vec3::Zero(), 0.0);
  HingeLaw& law = section.hinge->law;
  law.down = 0.15;
  law.stop_stiffness = 3e9;
  law.stop_damping = 2.0 * kStopDamping * std::sqrt(law.stop_stiffness * kInertia);
  const HingeLaw stop = law;
  HingedRun run({std::move(section)});
  run.begin();
  Values y{0.0, 0.0};
  double t = 0.0;
  const auto rates = [&](double, const Values& sample) {
    const double moment =
        kMass * kGravity * kArm * std::cos(sample[0]) + hinge_moment(stop, sample[0], sample[1], 0.0, 0.0).stop;
    return Values{sample[1], moment / kInertia};
  };
  double max_value = 0.0;
  for (int i = 0; i < 2000; ++i) {
    run.step(1e-3);
    for (int k = 0; k < 4; ++k) runge_kutta(y, t, 2.5e-4, rates);
    max_value = std::max(max_value, std::abs(run.angle() - y[0]));
  }
  EXPECT_LT(max_value, 5e-5);
  EXPECT_LT(std::abs(run.energy().error), 2e-3 * kMass * kGravity * kArm * 0.15);
}

/// A barge that heaves, surges and pitches.
RigidMotion rolling_barge(double t) {
  constexpr double kOmega = 0.7;
  RigidMotion m;
  const double s = std::sin(kOmega * t), c = std::cos(kOmega * t);
  const double pitch = 0.06 * s;
  m.pose.p_WV = Vec3(0.8 * s, 0.0, 1.2 * c);
  m.velocity = kOmega * Vec3(0.8 * c, 0.0, -1.2 * s);
  m.acceleration = -kOmega * kOmega * m.pose.p_WV;
  m.pose.R_WV << std::cos(pitch), 0.0, std::sin(pitch), 0.0, 1.0, 0.0, -std::sin(pitch), 0.0, std::cos(pitch);
  m.omega = Vec3(0.0, 0.06 * kOmega * c, 0.0);
  m.alpha = Vec3(0.0, -0.06 * kOmega * kOmega * s, 0.0);
  return m;
}

// In the plane: the section stands at phi = theta - pitch below the level, its hinge moves with the barge.
TEST(hinged_section, on_a_barge_of_prescribed_motion_moves_as_a_pendulum_on_a_moving_support) {
  const Vec3 hinge_V(-60.0, 0.0, 3.0);
  HingedRun run({level_section(0, hinge_V, 1.2)}, rolling_barge);
  run.begin();
  const auto pitch = [](double t) { return std::array{0.06 * std::sin(0.7 * t), 0.042 * std::cos(0.7 * t)}; };
  const auto rates = [&](double t, const Values& y) {
    const PointMotion hinge = point_motion(rolling_barge(t), hinge_V);
    const double phi = y[0];
    // Position of the centre: astern by r cos phi, down by r sin phi from the hinge.
    const Vec3 across(std::sin(phi), 0.0, -std::cos(phi));
    const Vec3 pull = -kMass * (hinge.acceleration + kGravity * Vec3::UnitZ());
    return Values{y[1], kArm * pull.dot(across) / kInertia};
  };
  Values y{1.2 - pitch(0.0)[0], -pitch(0.0)[1]};
  double t = 0.0, max_value = 0.0;
  for (int i = 0; i < 2000; ++i) {
    run.step(0.01);
    runge_kutta(y, t, 0.01, rates);
    max_value = std::max(max_value, std::abs(run.angle() - (y[0] + pitch(t)[0])));
  }
  EXPECT_LT(max_value, 2e-3);
  EXPECT_GT(std::abs(run.angle() - 1.2), 0.0);
  EXPECT_LT(std::abs(run.energy().error), 1e-3 * run.energy().throughput + 1e-3 * kMass * kGravity);
}

// Absolute angles a and b below the level; the second hinge is `l` from the first along the first section.
TEST(hinged_section, that_carries_another_moves_as_a_double_pendulum) {
  constexpr double l = 32.0;
  HingedRun run({level_section(0, Vec3::Zero(), 1.0), level_section(1, Vec3(-l, 0.0, 0.0), 0.4)});
  // Both frames coincide with the barge's at angles of zero.
  run.begin();
  const auto rates = [](double, const Values& y) {
    const double a = y[0], b = y[1], va = y[2], vb = y[3];
    const double m11 = kInertia + kMass * l * l, m22 = kInertia, m12 = kMass * l * kArm * std::cos(a - b);
    const double fa = kMass * kGravity * (kArm + l) * std::cos(a) - kMass * l * kArm * std::sin(a - b) * vb * vb;
    const double fb = kMass * kGravity * kArm * std::cos(b) + kMass * l * kArm * std::sin(a - b) * va * va;
    const double det = m11 * m22 - m12 * m12;
    return Values{va, vb, (m22 * fa - m12 * fb) / det, (m11 * fb - m12 * fa) / det};
  };
  Values y{1.0, 1.4, 0.0, 0.0};
  double t = 0.0, max_value = 0.0;
  for (int i = 0; i < 1000; ++i) {
    run.step(0.01);
    runge_kutta(y, t, 0.01, rates);
    max_value = std::max({max_value, std::abs(run.angle(0) - y[0]), std::abs(run.angle(1) - (y[1] - y[0]))});
  }
  EXPECT_LT(max_value, 2e-3);
  EXPECT_LT(std::abs(run.energy().error), 1e-3 * kMass * kGravity * l);
}

// The elastic part is a sum of rates at the ends of steps, which the angle is not: 2 % of it differ.
TEST(hinged_section, held_by_the_friction_of_its_hinge_yields_by_the_breakaway_and_stays) {
  FreeBody section = level_section(0, Vec3::Zero(), 0.0);
  section.hinge->law.friction = 2.0 * kMass * kGravity * kArm;
  section.hinge->law.friction_damping = 0.4 * std::sqrt(section.hinge->law.friction / kBreakawayRotation * kInertia);
  HingedRun run({std::move(section)}, barge_at_rest, 0.6);
  run.begin();
  run.steps(0.02, 1000);
  EXPECT_NEAR(run.angle(), 0.5 * kBreakawayRotation, 0.05 * kBreakawayRotation);
  EXPECT_NEAR(run.reading().friction_moment, -kMass * kGravity * kArm, 1e-3 * kMass * kGravity * kArm);
}

TEST(hinged_section, in_waves_is_lifted_by_the_water_that_rises_along_its_tank) {
  const FloatingTank tank;
  FreeBody section = tank.section(tank.rest(), 1.0, 1.0);
  auto sea = calm_sea();
  WaveComponent wave;
  wave.amplitude = 0.5;
  wave.omega = 0.25;  // long: the tank follows the surface
  wave.kx = 1.0;
  sea->sea = make_sea({wave}, 300.0);
  section.hinge->sea = sea;
  HingedRun run({std::move(section)});
  run.begin();
  double low = 9.0, high = -9.0;
  for (int i = 0; i < 1500; ++i) {
    run.step(0.1);
    if (run.state.time < 50.0) continue;
    low = std::min(low, run.angle());
    high = std::max(high, run.angle());
  }
  // The surface rises by the amplitude under all of it: the angle at which the tank rests with the hinge so much lower.
  FloatingTank up = tank, down = tank;
  up.height -= 0.5;
  down.height += 0.5;
  EXPECT_NEAR(low, up.rest(), 0.1 * (down.rest() - up.rest()));
  EXPECT_NEAR(high, down.rest(), 0.1 * (down.rest() - up.rest()));
}

TEST(hinged_section, resumes_from_a_checkpoint_bit_for_bit) {
  const FloatingTank tank;
  const auto started = [&] {
    FreeBody section = tank.section(tank.rest() + 0.1, 1.0, 1.0);
    section.hinge->law.friction = 2e5;
    auto run = std::make_unique<HingedRun>(std::vector<FreeBody>{std::move(section)});
    run->begin();
    return run;
  };
  const auto whole = started(), resumed = started();
  whole->steps(0.02, 20);
  DynamicCheckpoint checkpoint;
  save_state(checkpoint, whole->state);
  whole->stepper().forget();
  whole->steps(0.02, 20);
  restore_state(checkpoint, resumed->state);
  resumed->steps(0.02, 20);
  EXPECT_EQ(whole->state.bodies[0].h, resumed->state.bodies[0].h);
  EXPECT_EQ(whole->state.bodies[0].hinge_slip, resumed->state.bodies[0].hinge_slip);
  EXPECT_EQ(whole->state.bodies[0].algorithmic_acceleration, resumed->state.bodies[0].algorithmic_acceleration);
}

TEST(hinged_section, steps_without_asking_for_memory) {
  const FloatingTank tank;
  HingedRun run({tank.section(tank.rest() + 0.1, 1.0, 1.0)});
  run.begin();
  run.steps(0.02, 3);
  const long before = testing::allocation_count();
  run.steps(0.02, 10);
  EXPECT_EQ(testing::allocation_count(), before);
}

}  // namespace
}  // namespace overbend
