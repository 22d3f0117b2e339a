/// Free bodies with lines in time: against closed forms, prescribed motions, invariances.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dynamics/integrator/dynamic_checkpoint.h"
#include "dynamics/integrator/energy_account.h"
#include "support/allocation_count.h"
#include "support/free_body.h"

namespace overbend {
namespace {

using namespace testing;

/// A system with bodies, its integrator and its present.
class BodyRun {
 public:
  BodyRun(const System& system, const std::vector<std::vector<double>>& q,
          const StepSettings& settings = {1.0, 1e-11, 30})
      : system_(system),
        assembly_(kept(system_)),
        stepper_(assembly_, settings),
        state(state_at_rest(system_, q, 0.0)) {}
  BodyRun(const BodyRun&) = delete;
  BodyRun& operator=(const BodyRun&) = delete;

  void begin() {
    assembly_.set_time(state.time, state);
    assembly_.impose_ends(state);
    ASSERT_TRUE(assembly_.find_accelerations(state));
    for (LineState& line : state.lines) line.algorithmic_acceleration = line.acc;
    for (AttachmentState& end : state.attachments) end.guide.algorithmic_acceleration = end.guide.acc;
    for (HullState& body : state.bodies) body.algorithmic_acceleration = body.acc;
    next_ = state;
  }
  void step(double h) {
    const StepReport report = stepper_.step(state, h, next_);
    EXPECT_TRUE(report.converged()) << state.time << " " << report.residual;
    std::swap(state, next_);
  }
  void steps(double h, int count) {
    for (int i = 0; i < count; ++i) step(h);
  }
  double energy() const {
    const InstantEnergy e = assembly_.energy(state);
    return stored(e) + e.bodies.kinetic + e.bodies.stored;
  }
  Assembly& assembly() { return assembly_; }
  TimeStepper& stepper() { return stepper_; }
  const HullState& body(std::size_t i = 0) const { return state.bodies[i]; }

 private:
  static const System& kept(System& system) {
    system.surroundings = surroundings_at_rest(system);
    return system;
  }

  System system_;
  Assembly assembly_;
  TimeStepper stepper_;
  SystemState next_;

 public:
  SystemState state;
};

std::vector<std::vector<double>> level(const System& system) {
  return {straight(system, Vec3::Zero(), Vec3::UnitX())};
}

/// A body of 40 kg that a light cable of 4 m ties to the ground at the origin, along x.
System tied_body(double EA, const SpringBody& springs) {
  System system = rod_system({EA, 1e-3, 1e-3}, 4.0, 4);
  system.bodies[0].free = free_body(springs);
  hold_on_body(last_end(system), Vec3(4.0, 0.0, 0.0));
  hold(first_end(system), true, false);
  return system;
}

TEST(free_body, on_a_spring_and_a_cable_swings_with_the_period_of_both) {
  SpringBody springs;
  springs.stiffness = Vec6::Constant(600.0);
  const double EA = 8e3;
  const System system = tied_body(EA, springs);
  BodyRun run(system, {straight(system, Vec3::Zero(), Vec3::UnitX(), 0.05)});
  run.state.bodies[0].h(0) = 0.2;  // 5 % of 4 m
  run.begin();
  const double omega = std::sqrt((600.0 + EA / 4.0) / springs.body.mass);
  const double h = 2.0 * std::numbers::pi / omega / 400.0;
  double error = 0.0;
  for (int i = 0; i < 100; ++i) {  // a quarter of a period, in which the cable stays taut
    run.step(h);
    error = std::max(error, std::abs(run.body().h(0) - 0.2 * std::cos(omega * run.state.time)));
  }
  EXPECT_LT(error, 2e-4 * 0.2 + 1e-5);
  EXPECT_LT(run.body().h.tail<5>().norm(), 1e-12);
}

TEST(free_body, with_an_ideal_winch_feels_the_constant_tension_of_its_line) {
  SpringBody springs;
  springs.stiffness = Vec6::Constant(600.0);
  constexpr double kTension = 80.0, kStretch = 0.01;
  System system = tied_body(kTension / kStretch, springs);
  TensionerLaw& law = system.attachments[1].tensioner.emplace();
  law.mode = TensionerMode::constant;
  law.wanted = kTension;
  system.attachments[1].place = Vec3(4.0 * (1.0 + kStretch), 0.0, 0.0);
  BodyRun run(system, {straight(system, Vec3::Zero(), Vec3::UnitX(), kStretch)});
  run.assembly().set_drive(0, TensionerDrive::governor);
  run.begin();
  const double omega = std::sqrt(600.0 / springs.body.mass);
  const double h = 2.0 * std::numbers::pi / omega / 400.0;
  for (int i = 0; i < 300; ++i) {
    run.step(h);
    const double expected = -kTension / 600.0 * (1.0 - std::cos(omega * run.state.time));
    ASSERT_NEAR(run.body().h(0), expected, 1e-4 * kTension / 600.0) << i;
    ASSERT_NEAR(run.state.attachments[1].travel.q, expected, 1e-4 * kTension / 600.0) << i;
  }
}

/// A body on springs between two cables with weight, one to a point next to it and one to its top, pinned and clamped.
System between_cables() {
  System system = rod_system({2e3, 2.0, 0.8, 0.8 * kGravity}, 4.0, 8);
  system.lines.push_back(system.lines[0]);
  system.attachments.push_back(system.attachments[0]);
  system.attachments.push_back(system.attachments[1]);
  system.attachments[2].line = system.attachments[3].line = 1;
  system.attachments[2].place = Vec3(0.0, 3.0, 0.0);
  SpringBody springs;
  springs.stiffness << 300.0, 300.0, 500.0, 400.0, 400.0, 350.0;
  springs.body.inertia << 30.0, 2.0, -1.0, 2.0, 55.0, 3.0, -1.0, 3.0, 70.0;
  system.bodies[0].free = free_body(springs, Vec3(0.2, 0.1, -0.1));
  hold_on_body(system.attachments[1], Vec3(4.2, 0.1, -0.1));
  hold_on_body(system.attachments[3], Vec3(4.2, 3.1, -0.1));
  hold(system.attachments[3], true, true);
  hold(system.attachments[0], true, false);
  hold(system.attachments[2], true, false);
  return system;
}

std::vector<std::vector<double>> two_level(const System& system) {
  return {straight(system, Vec3::Zero(), Vec3::UnitX()), straight(system, Vec3(0.0, 3.0, 0.0), Vec3::UnitX())};
}

/// Largest change of energy of the released body over a second.
double energy_change(double h) {
  const System system = between_cables();
  BodyRun run(system, two_level(system));
  run.state.bodies[0].v << 0.3, -0.2, 0.4, 0.2, -0.3, 0.25;
  run.begin();
  const double first = run.energy();
  double change = 0.0;
  for (int i = 0; i < static_cast<int>(std::lround(0.5 / h)); ++i) {
    run.step(h);
    change = std::max(change, std::abs(run.energy() - first));
  }
  return change;
}

TEST(free_body, with_two_lines_keeps_its_energy_to_second_order) {
  const double coarse = energy_change(1e-3), fine = energy_change(5e-4);
  EXPECT_LT(fine, 0.01);
  EXPECT_GT(coarse / fine, 3.3);
  EXPECT_LT(coarse / fine, 4.7);
}

/// Half a second of it in a world that is turned.
std::pair<SystemState, Vec3> turned(double angle) {
  System system = between_cables();
  const Mat3 turn = turned_about_z(angle);
  SpringBody springs;
  springs.stiffness << 300.0, 300.0, 500.0, 400.0, 400.0, 350.0;
  springs.drawn << turn * Vec3(0.4, -0.2, 0.1), 0.0, 0.0, angle;
  system.bodies[0].free = free_body(springs, Vec3(0.2, 0.1, -0.1));
  for (const int ground : {0, 2}) {
    Attachment& end = system.attachments[static_cast<std::size_t>(ground)];
    end.place = turn * end.place;
  }
  std::vector<std::vector<double>> q = two_level(system);
  for (std::vector<double>& line : q) {
    for (std::size_t i = 0; i < line.size(); i += 3) {
      Eigen::Map<Vec3> part(line.data() + i);
      part = (turn * part).eval();
    }
  }
  BodyRun run(system, q, {0.8, 1e-12, 30});
  run.state.bodies[0].h << turn * Vec3(0.0, 0.0, 0.0), 0.0, 0.0, angle;
  run.begin();
  run.steps(2e-3, 100);
  return {run.state, turn.transpose() * run.state.bodies[0].h.head<3>()};
}

TEST(free_body, in_a_turned_world_does_the_same) {
  const auto [plain, place] = turned(0.0);
  EXPECT_GT(place.norm(), 0.01);
  for (const double degrees : {90.0, 217.0, 1000.0}) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const auto [state, back] = turned(angle);
    EXPECT_LT((back - place).norm(), 1e-9) << degrees;
    EXPECT_LT((state.bodies[0].h.tail<3>() - plain.bodies[0].h.tail<3>() - angle * Vec3::UnitZ()).norm(), 1e-9);
    for (std::size_t i = 0; i < plain.lines[1].q.size(); i += 3) {
      const Vec3 original(Eigen::Map<const Vec3>(plain.lines[1].q.data() + i));
      const Vec3 rotated(Eigen::Map<const Vec3>(state.lines[1].q.data() + i));
      EXPECT_LT((turned_about_z(-angle) * rotated - original).norm(), 1e-9) << degrees << " " << i;
    }
  }
}

/// A body so heavy that nothing changes its steady speed and turning, on which a rod is held and rubs.
System heavy_with_rod(bool free) {
  System system = rod_system({4000.0, 60.0, 1.2, 1.2 * kGravity}, 4.0, 4);
  hold_on_body(last_end(system), Vec3(4.0, 0.0, 0.0));
  hold(last_end(system), true, true);
  ContactLaw law;
  law.stiffness = 2e4;
  law.damping = 40.0;
  law.tangential_stiffness = 3e3;
  law.friction_axial = law.friction_lateral = 0.3;
  system.bodies[0].rollers = {roller_under(1.3, 0.01, law)};
  system.bodies[0].cells = endless_cells();
  if (free) {
    SpringBody heavy;
    heavy.body = {1e12, Mat3(Vec3(1e12, 1e12, 1e12).asDiagonal())};
    system.bodies[0].free = free_body(heavy, Vec3(0.5, 0.0, 0.2));
  }
  return system;
}

const Vec3 kSpeed(0.3, -0.2, 0.1);
constexpr double kTurning = 0.4;

TEST(free_body, that_nothing_can_move_carries_lines_like_a_body_whose_motion_is_prescribed) {
  const Vec3 reference(0.5, 0.0, 0.2);
  const auto prescribed_motion = [&](double t) {
    HullState hull_state;
    hull_state.h << reference + kSpeed * t, 0.0, 0.0, kTurning * t;
    hull_state.v << kSpeed, 0.0, 0.0, kTurning;
    return hull_state;
  };
  System prescribed = heavy_with_rod(false);
  FreeBody kinematics;
  kinematics.reference_V = reference;
  prescribed.surroundings = [&](double t, Surroundings& surroundings) {
    surroundings.bodies[0] = rigid_motion(kinematics, prescribed_motion(t));
    set_attachment_motions(prescribed, surroundings);
  };
  MovingRod rod(prescribed, level(prescribed)[0], {0.8, 1e-9, 30});
  const System system = heavy_with_rod(true);
  BodyRun run(system, level(system), {0.8, 1e-9, 30});
  run.state.bodies[0] = prescribed_motion(0.0);
  for (LineState* line : {&run.state.lines[0], &rod.state.lines[0]}) {
    for (std::size_t i = 0; i < line->v.size(); i += 6) {
      const Vec3 r(Eigen::Map<const Vec3>(line->q.data() + i));
      Eigen::Map<Vec3>(line->v.data() + i) = kSpeed + kTurning * Vec3::UnitZ().cross(r - reference);
      Eigen::Map<Vec3>(line->v.data() + i + 3) = kTurning * Vec3::UnitZ().cross(Vec3::UnitX());
    }
  }
  run.begin();
  rod.begin();
  run.steps(2e-3, 250);
  rod.run(2e-3, 250);
  EXPECT_GT(run.state.lines[0].contacts[0].carries, 0);
  double difference = 0.0;
  for (std::size_t i = 0; i < run.state.lines[0].q.size(); ++i) {
    difference = std::max(difference, std::abs(run.state.lines[0].q[i] - rod.state.lines[0].q[i]));
  }
  EXPECT_LT(difference, 1e-7);
}

/// Error of the balance of energy over what has passed, of a rolling body with a rod on a rubbing, damped roller.
double energy_error(double h) {
  System system = heavy_with_rod(true);
  SpringBody springs;
  springs.stiffness << 300.0, 300.0, 500.0, 400.0, 400.0, 350.0;
  springs.damping = Vec6::Constant(20.0);
  system.bodies[0].free = free_body(springs, Vec3(0.5, 0.0, 0.2));
  BodyRun run(system, level(system));
  run.state.bodies[0].h.head<3>() = Vec3(0.5, 0.0, 0.2);
  run.state.bodies[0].v << 0.1, 0.2, 0.0, 0.3, 0.0, 0.2;
  run.begin();
  EnergyAccount account;
  account.start(run.assembly().energy(run.state), 1e-6);
  for (int i = 0; i < static_cast<int>(std::lround(0.2 / h)); ++i) {
    run.step(h);
    account.add(run.assembly().energy(run.state), h);
  }
  EXPECT_GT(run.assembly().line(0).contacts().contacts()[0].normal, 0.0);
  EXPECT_GT(account.balance().friction_loss, 1e-3);
  return std::abs(account.balance().drift());
}

TEST(free_body, with_a_rod_that_rubs_on_its_roller_accounts_for_all_energy) {
  const double coarse = energy_error(4e-4), fine = energy_error(2e-4);
  EXPECT_LT(fine, 1e-3);
  EXPECT_LT(fine, 0.5 * coarse);
}

TEST(free_body, that_is_held_leaves_its_line_what_it_is_and_shows_the_wrench_of_its_ends) {
  System system = heavy_with_rod(true);
  SpringBody springs;  // nothing acts on it but the line
  system.bodies[0].free = free_body(springs);
  BodyRun held(system, level(system), {0.8, 1e-9, 30});
  for (int k = 0; k < 6; ++k) held.assembly().hold_body(0, k, true);
  held.begin();
  held.steps(2e-3, 100);
  System fixed = heavy_with_rod(false);
  fixed.surroundings = [&](double, Surroundings& surroundings) { set_attachment_motions(fixed, surroundings); };
  MovingRod rod(fixed, level(fixed)[0], {0.8, 1e-9, 30});
  rod.begin();
  rod.run(2e-3, 100);
  for (std::size_t i = 0; i < held.state.lines[0].q.size(); ++i) {
    EXPECT_NEAR(held.state.lines[0].q[i], rod.state.lines[0].q[i], 1e-10) << i;
  }
  const RollerContact& contact = rod.contacts()[0];
  ASSERT_GT(contact.normal, 1.0);
  const std::array<double, 6>& end = rod.assembly().line(0).end_force(LineEnd::last);
  const Vec3 force = contact.force() + Vec3(end[0], end[1], end[2]);
  const Vec3 moment =
      contact.closest.place.cross(contact.force()) + rod.r(rod.last()).cross(Vec3(end[0], end[1], end[2])) +
      Vec3(rod.line_now().q[27], rod.line_now().q[28], rod.line_now().q[29]).cross(Vec3(end[3], end[4], end[5]));
  const std::vector<double>& wrench = held.assembly().body_residual();
  EXPECT_LT((Vec3(wrench[0], wrench[1], wrench[2]) - force).norm(), 1e-8 * force.norm());
  EXPECT_LT((Vec3(wrench[3], wrench[4], wrench[5]) - moment).norm(), 1e-8 * moment.norm());
}

/// A spring without length from a point of the world.
BodySpring to_point(const Vec3& place_V, const Vec3& point, double stiffness) {
  return {
      place_V, [point, stiffness](const Vec3& place, double, const LineEndForces&) {
        const Vec3 away = place - point;
        return PlaceForce{-stiffness * away, stiffness * Mat3::Identity(), 0.5 * stiffness * away.squaredNorm(), {}};
      }};
}

TEST(free_body, on_quasi_static_lines_keeps_its_energy_to_second_order) {
  System system = between_cables();
  system.lines.clear();
  system.attachments.clear();
  SpringBody floating;
  floating.body.inertia << 30.0, 2.0, -1.0, 2.0, 55.0, 3.0, -1.0, 3.0, 70.0;
  FreeBody& body = system.bodies[0].free.emplace(free_body(floating, Vec3(0.2, 0.1, -0.1)));
  body.springs = {to_point(Vec3(2.0, 1.0, 0.5), Vec3(3.0, 1.5, 0.0), 900.0),
                  to_point(Vec3(-2.0, 1.0, 0.5), Vec3(-3.0, 1.5, 0.0), 700.0),
                  to_point(Vec3(0.0, -1.5, 0.2), Vec3(0.0, -2.0, 0.4), 800.0)};
  const auto change = [&](double h) {
    BodyRun run(system, {});
    run.state.bodies[0].v << 0.3, -0.2, 0.4, 0.2, -0.3, 0.25;
    run.begin();
    const double first = run.energy();
    double max_value = 0.0;
    for (int i = 0; i < static_cast<int>(std::lround(1.0 / h)); ++i) {
      run.step(h);
      max_value = std::max(max_value, std::abs(run.energy() - first));
    }
    return max_value;
  };
  const double coarse = change(0.02), fine = change(0.01);
  EXPECT_LT(fine, 0.5);
  EXPECT_GT(coarse / fine, 3.5);
  EXPECT_LT(coarse / fine, 4.5);
}

TEST(free_body, resumes_from_a_checkpoint_bit_for_bit) {
  const System system = between_cables();
  const auto started = [&] {
    auto run = std::make_unique<BodyRun>(system, two_level(system));
    run->state.bodies[0].v << 0.3, -0.2, 0.4, 0.2, -0.3, 0.25;
    run->begin();
    return run;
  };
  const auto whole = started(), resumed = started();
  whole->steps(2e-3, 20);
  DynamicCheckpoint checkpoint;
  save_state(checkpoint, whole->state);
  whole->stepper().forget();
  whole->steps(2e-3, 20);
  restore_state(checkpoint, resumed->state);
  resumed->steps(2e-3, 20);
  EXPECT_EQ(whole->state.bodies[0].h, resumed->state.bodies[0].h);
  EXPECT_EQ(whole->state.bodies[0].algorithmic_acceleration, resumed->state.bodies[0].algorithmic_acceleration);
  EXPECT_EQ(whole->state.lines[1].q, resumed->state.lines[1].q);
}

TEST(free_body, steps_without_asking_for_memory) {
  const System system = between_cables();
  BodyRun run(system, two_level(system));
  run.begin();
  run.steps(2e-3, 3);
  const long before = allocation_count();
  run.steps(2e-3, 10);
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace overbend
