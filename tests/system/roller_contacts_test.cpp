/// Rollers and bed under a moving pipe: sticking, sliding, and finding the rollers it meets.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "modelfile/reading/yaml_reader.h"
#include "support/dynamic_benchmarks.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

using namespace testing;

constexpr double kMass = 100.0, kLength = 4.0, kNormalStiffness = 1e7, kTangential = 1e5;
// So hard that the pipe stays level when it shifts: a slope of 6e-5 pushes along it with half a thousandth of friction.
constexpr double kAxial = 0.1, kLateral = 0.3;
constexpr double kRollerLoad = 0.5 * kMass * kLength * kGravity;

/// A stiff pipe at rest on two rollers, one at each quarter of it.
System pipe_on_rollers() {
  System system = rod_system({1e9, 1e8, kMass, kMass * kGravity}, kLength, 2);
  ContactLaw law;
  law.stiffness = kNormalStiffness;
  law.damping = 9e4;  // critical: what the pipe bounces at first dies out
  law.tangential_stiffness = kTangential;
  law.friction_axial = kAxial;
  law.friction_lateral = kLateral;
  system.bodies[0].rollers = {roller_under(1.0, 0.01, law), roller_under(3.0, 0.01, law)};
  system.bodies[0].cells = endless_cells();
  first_rod(system).force_scale = kMass * kLength * kGravity;
  return system;
}

Vec3 start() {
  return {0.0, 0.0, -kRollerLoad / kNormalStiffness};
}

/// Both ends led along `direction` at a steady 20 mm/s from rest, started gently.
System led_pipe(const Vec3& direction) {
  System system = pipe_on_rollers();
  first_end(system).hold_place = last_end(system).hold_place = true;
  system.surroundings = [direction](double t, Surroundings& surroundings) {
    constexpr double kSpeed = 0.02, kRise = 0.05;
    const double rate = t < kRise ? t / kRise : 1.0, way = t < kRise ? 0.5 * t * t / kRise : t - 0.5 * kRise;
    surroundings.ends[0].place = start() + kSpeed * way * direction;
    surroundings.ends[0].velocity = kSpeed * rate * direction;
    surroundings.ends[0].acceleration = t < kRise ? Vec3(kSpeed / kRise * direction) : Vec3(Vec3::Zero());
    surroundings.ends[1] = surroundings.ends[0];
    surroundings.ends[1].place += Vec3(kLength, 0.0, 0.0);
  };
  return system;
}

TEST(pipe_on_rollers, led_across_sticks_to_the_stretch_of_the_limit_and_then_slides) {
  const System system = led_pipe(Vec3::UnitY());
  MovingRod rod(system, straight(system, start(), Vec3::UnitX()));
  rod.begin();
  const double limit = kLateral * kRollerLoad, stretch = limit / kTangential;  // 5.9 mm
  double distance = 0.0, stuck_until = 0.0;
  rod.run(1e-3, 800, [&] {
    distance = rod.r(1).y();
    for (const RollerContact& contact : rod.contacts()) {
      // The pipe bends between its ends: by 3e-6 m under these forces; slip is summed over steps.
      if (distance < 0.98 * stretch) {
        EXPECT_NEAR(contact.lateral, -kTangential * distance, 0.01 * limit);
        stuck_until = distance;
      } else if (distance > 1.05 * stretch) {
        EXPECT_NEAR(contact.lateral, -kLateral * contact.normal, 1e-9 * limit);
      }
    }
  });
  EXPECT_GT(stuck_until, 0.9 * stretch);
  EXPECT_GT(distance, 2.0 * stretch);
}

TEST(pipe_on_rollers, pulled_along_is_held_by_the_rolling_resistance_of_the_rollers) {
  const System system = led_pipe(Vec3::UnitX());
  MovingRod rod(system, straight(system, start(), Vec3::UnitX()));
  rod.begin();
  rod.run(1e-3, 50);  // 0.5 mm: a quarter of the stretch of the limit, 2 mm
  for (const RollerContact& contact : rod.contacts()) {
    EXPECT_NEAR(contact.axial, -kTangential * 5e-4, 0.02 * kAxial * kRollerLoad);  // the pipe's own stretching swings
  }
  rod.run(1e-3, 450);
  double sum = 0.0;
  for (const RollerContact& contact : rod.contacts()) {
    EXPECT_NEAR(contact.axial, -kAxial * contact.normal, 1e-9 * kRollerLoad);
    EXPECT_NEAR(contact.lateral, 0.0, 1e-9 * kRollerLoad);
    sum += contact.normal;
  }
  EXPECT_NEAR(sum, 2.0 * kRollerLoad, 0.04 * kRollerLoad);  // the held ends bear a hundredth of the weight
}

/// Distance of the pipe's middle from its start when it turns back.
double slide(MovingRod& rod, const Vec3& velocity, double h) {
  push(rod.state, velocity);
  rod.begin();
  const Vec3 from = rod.r(1), direction = velocity.normalized();
  double furthest = 0.0;
  rod.run(h, static_cast<int>(1.2 / h), [&] { furthest = std::max(furthest, (rod.r(1) - from).dot(direction)); });
  return furthest;
}

TEST(pipe_on_rollers, sent_along_them_it_slides_until_friction_has_spent_its_speed) {
  const System system = pipe_on_rollers();
  MovingRod rod(system, straight(system, start(), Vec3::UnitX()));
  const double speed = 0.8;
  // m v2/2 = mu W (d - s/2): the first stretch s of the springs takes half the force on the average.
  const double stretch = kAxial * kRollerLoad / kTangential;
  const double exact = speed * speed / (2.0 * kAxial * kGravity) + 0.5 * stretch;
  EXPECT_NEAR(slide(rod, Vec3(speed, 0.0, 0.0), 1e-3), exact, 1e-3 * exact);  // a step's way at the start is 0.25 %
}

/// A pipe at rest on the bed in water, free to slide.
struct PipeOnBed {
  static constexpr double kSubmerged = 600.0, kAdded = 80.0, kBed = 1e5, kFriction = 0.4;
  System system;
  std::vector<double> q;

  PipeOnBed() {
    RodMaterial pipe{1e9, 1e7, kMass, kMass * kGravity, kMass * kGravity - kSubmerged, 0.1};
    pipe.displaced_mass = pipe.added_normal = kAdded;
    system = rod_system(pipe, kLength, 2);
    first_rod(system).force_scale = kMass * kLength * kGravity;
    first_rod(system).environment.bed_offset = -20.1 + kSubmerged / kBed;
    first_rod(system).environment.bed_stiffness = first_rod(system).environment.bed_stick = kBed;
    first_rod(system).environment.bed_friction_lateral = first_rod(system).environment.bed_friction_axial = kFriction;
    q = straight(system, Vec3(0.0, 0.0, -20.0), Vec3::UnitX());
  }
  /// With `mass` moving per length.
  double slip(double mass, double speed) const {
    return mass * speed * speed / (2.0 * kFriction * kSubmerged) + 0.5 * kFriction * kSubmerged / kBed;
  }
};

TEST(pipe_on_bed, sent_across_it_slides_until_friction_has_spent_its_speed) {
  const PipeOnBed pipe;
  MovingRod rod(pipe.system, pipe.q);
  const double exact = pipe.slip(kMass + PipeOnBed::kAdded, 0.8);
  EXPECT_NEAR(slide(rod, Vec3(0.0, 0.8, 0.0), 1e-3), exact, 1e-3 * exact);  // a step's way at the start is 0.33 %
}

TEST(pipe_on_bed, sent_along_it_moves_no_water) {
  const PipeOnBed pipe;
  MovingRod rod(pipe.system, pipe.q);
  const double exact = pipe.slip(kMass, 0.8);
  EXPECT_NEAR(slide(rod, Vec3(0.8, 0.0, 0.0), 1e-3), exact, 2e-3 * exact);  // a step's way at the start is 0.6 %
}

TEST(pipe_on_bed, at_rest_it_stays) {
  const PipeOnBed pipe;
  MovingRod rod(pipe.system, pipe.q);
  rod.begin();
  rod.run(0.05, 100);
  for (int node = 0; node <= 2; ++node) {
    EXPECT_LT((rod.r(node) - place(pipe.q, node)).norm(), 1e-9);  // tolerance of the balance over the bed's stiffness
  }
}

/// The barge of the BGL-1 case with a pipe over its rollers.
struct Deck {
  Model model = build_model(read_model(case_file("BGL1-T250")).description.value());
  double pipe_radius = 0.5 * model.sections.front().outer_diameter;
  Vec3 shoe_V{-40.0, 0.0, 3.0};
  std::vector<BodyRoller> rollers;
  std::vector<double> length;
  AlignedDoubles radius;
  std::vector<double> q_V;  ///< In the frame of the vessel.

  Deck() {
    for (const Roller& roller : model.supports.rollers) {
      BodyRoller moving;
      moving.center_V = shoe_V + to_V(roller.center_S);
      moving.axis_V = to_V(roller.axis_S);
      moving.normal_V = to_V(roller.normal_S);
      moving.half_face = 0.5 * roller.face;
      moving.radius = roller.radius;
      moving.box = roller.box;
      moving.law.stiffness = 1e6;
      rollers.push_back(moving);
    }
    lay_pipe();
  }
  /// S runs astern and to starboard, V ahead and to port.
  static Vec3 to_V(const Vec3& v_S) { return {-v_S.x(), -v_S.y(), v_S.z()}; }

 private:
  /// A parabola a hand above the rows, from far astern to ahead of them all.
  void lay_pipe() {
    double low = 1e30, high = -1e30;
    Eigen::MatrixXd a(static_cast<Eigen::Index>(model.supports.rows.size()), 3);
    Eigen::VectorXd z(a.rows());
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
      const Vec3 p = shoe_V + to_V(model.supports.rows[static_cast<std::size_t>(i)].point_S);
      a.row(i) << 1.0, p.x(), p.x() * p.x();
      z(i) = p.z() + pipe_radius;
      low = std::min(low, p.x());
      high = std::max(high, p.x());
    }
    const Eigen::Vector3d c = a.colPivHouseholderQr().solve(z);
    const int count = 100;
    const double step = (high - low + 40.0) / count;
    for (int i = 0; i <= count; ++i) {
      const double x = low - 20.0 + i * step;
      q_V.insert(q_V.end(), {x, 0.0, c(0) + x * (c(1) + x * c(2)), 1.0, 0.0, c(1) + 2.0 * x * c(2)});
    }
    length.assign(count, step);
    radius.assign(count, pipe_radius);
  }
};

/// Places along the line in `turn` about the origin, then moved by `shift`.
std::vector<double> moved(const std::vector<double>& q, const Mat3& turn, const Vec3& shift) {
  std::vector<double> result(q.size());
  for (std::size_t i = 0; i < q.size(); i += 6) {
    Eigen::Map<Vec3>(result.data() + i) = turn * Eigen::Map<const Vec3>(q.data() + i) + shift;
    Eigen::Map<Vec3>(result.data() + i + 3) = turn * Eigen::Map<const Vec3>(q.data() + i + 3);
  }
  return result;
}

TEST(roller_contacts, every_roller_that_a_search_of_the_whole_line_finds_is_found_in_any_pose) {
  const Deck deck;
  const std::vector<Body> bodies = {
      {deck.rollers, contact_cells(deck.model.supports, deck.pipe_radius), deck.shoe_V, {}}};
  Line line;
  line.mesh.length = deck.length;
  line.elements.radius = deck.radius;
  RollerContacts contacts(line, bodies);
  std::mt19937_64 generator(11);
  const auto random = [&](double size) {
    return size * (2.0 * static_cast<double>(generator() >> 11) * 0x1.0p-53 - 1.0);
  };
  const std::vector<double> v(deck.q_V.size(), 0.0);
  const std::vector<ContactMemory> fresh(deck.rollers.size());
  std::vector<double> residual(deck.q_V.size()), cuts(deck.q_V.size());
  int touching = 0, apart = 0;
  for (int pose = 0; pose < 200; ++pose) {
    RigidMotion vessel;
    vessel.pose.R_WV = (Eigen::AngleAxisd(random(3.0), Vec3::UnitZ()) * Eigen::AngleAxisd(random(0.1), Vec3::UnitY()) *
                        Eigen::AngleAxisd(random(0.2), Vec3::UnitX()))
                           .toRotationMatrix();
    vessel.pose.p_WV = Vec3(random(500.0), random(500.0), random(5.0));
    // The pipe has not followed the vessel all the way.
    const Mat3 lag = (Eigen::AngleAxisd(random(0.02), Vec3::UnitY()) * Eigen::AngleAxisd(random(0.02), Vec3::UnitZ()))
                         .toRotationMatrix();
    const Vec3 offset(random(1.0), random(0.5), random(0.5));
    const std::vector<double> q = moved(moved(deck.q_V, lag, offset), vessel.pose.R_WV, vessel.pose.p_WV);
    contacts.place({vessel}, q.data(), 0.0);
    std::vector<ContactMemory> after = fresh;
    contacts.evaluate(q.data(), v.data(), {}, fresh, after, ContactMode::free, {residual, cuts});
    for (std::size_t i = 0; i < deck.rollers.size(); ++i) {
      const BodyRoller& roller = deck.rollers[i];
      const PlacedRoller placed{vessel.pose.p_WV + vessel.pose.R_WV * roller.center_V,
                                vessel.pose.R_WV * roller.axis_V,
                                vessel.pose.R_WV * roller.normal_V,
                                roller.half_face,
                                roller.radius,
                                1e6};
      const ClosestPoint closest =
          closest_point(placed, q.data(), deck.length.data(), 0, static_cast<int>(deck.length.size()));
      ASSERT_TRUE(closest.found);
      // A moving pipe is where it is: behind a roller's face its distance is that to the far side.
      const double distance = std::abs(roller_distance(placed, closest).value);
      const double penetration = deck.pipe_radius + roller.radius - distance;
      if (penetration > 0.0) {
        ++touching;
        ASSERT_NEAR(contacts.contacts()[i].penetration, penetration, 1e-9) << "pose " << pose << " roller " << i;
      } else {
        ++apart;
        ASSERT_LE(contacts.contacts()[i].normal, 0.0);
      }
    }
  }
  EXPECT_GT(touching, 200);
  EXPECT_GT(apart, 200);
}

TEST(roller_contacts, no_roller_that_the_line_has_come_near_since_is_passed_over) {
  const Deck deck;
  const std::vector<Body> bodies = {
      {deck.rollers, contact_cells(deck.model.supports, deck.pipe_radius), deck.shoe_V, {}}};
  Line line;
  line.mesh.length = deck.length;
  line.mesh.s.resize(deck.length.size() + 1);
  line.elements.radius = deck.radius;
  RollerContacts watched(line, bodies), all(line, bodies);
  std::mt19937_64 generator(5);
  const auto random = [&](double size) {
    return size * (2.0 * static_cast<double>(generator() >> 11) * 0x1.0p-53 - 1.0);
  };
  const std::vector<double> v(deck.q_V.size(), 0.0);
  std::vector<double> forces(deck.q_V.size()), forces_of_all(deck.q_V.size()), cuts(deck.q_V.size());
  std::vector<ContactMemory> memory(deck.rollers.size());
  Vec3 offset = Vec3::Zero(), turn = Vec3::Zero(), heave = Vec3::Zero();
  int touched = 0, passed_over = 0;
  for (int step = 0; step < 400; ++step) {
    std::vector<ContactMemory> after = memory, after_all = memory;
    std::vector<double> q;
    // Iterates of a step wander; now and then the pipe jumps.
    const double size = step % 10 == 9 ? 0.2 : 0.01;
    for (int iteration = 0; iteration < 3; ++iteration) {
      offset += Vec3(random(size), random(size), random(size)) - 0.05 * offset;
      turn += 0.02 * Vec3(0.0, random(size), random(size)) - 0.05 * turn;
      heave += Vec3(0.0, 0.0, random(size)) - 0.05 * heave;
      RigidMotion vessel;
      vessel.pose.R_WV = Eigen::AngleAxisd(0.1 * heave.z(), Vec3::UnitX()).toRotationMatrix();
      vessel.pose.p_WV = heave;
      const Mat3 lag =
          (Eigen::AngleAxisd(turn.y(), Vec3::UnitY()) * Eigen::AngleAxisd(turn.z(), Vec3::UnitZ())).toRotationMatrix();
      const Vec3 slid(3.0 * std::sin(0.02 * step), 0.0, 0.0);  // over elements that no roller met at first
      q = moved(deck.q_V, lag, offset + slid);
      std::fill(forces.begin(), forces.end(), 0.0);
      std::fill(forces_of_all.begin(), forces_of_all.end(), 0.0);
      watched.place({vessel}, q.data(), 0.5);  // keeps what it found until all has moved by 0.25 m
      watched.evaluate(q.data(), v.data(), {}, memory, after, ContactMode::free, {forces, cuts});
      all.forget();
      all.place({vessel}, q.data(), 0.5);
      all.evaluate(q.data(), v.data(), {}, memory, after_all, ContactMode::free, {forces_of_all, cuts});
      for (std::size_t i = 0; i < forces.size(); ++i) {
        ASSERT_NEAR(forces[i], forces_of_all[i], 1e-3) << "step " << step << " number " << i;  // of about 1e5 N
      }
      for (int i = 0; i < watched.count(); ++i) {
        ASSERT_EQ(watched.carries(i), all.carries(i)) << "step " << step << " roller " << i;
        const std::size_t index = static_cast<std::size_t>(i);
        touched += all.carries(i) ? 1 : 0;
        passed_over += watched.contacts()[index].penetration != all.contacts()[index].penetration ? 1 : 0;
      }
    }
    watched.complete(q.data(), v.data(), after);
    for (std::size_t i = 0; i < deck.rollers.size(); ++i) {
      const double far = -0.5;  // beyond the reach it may be found or not
      ASSERT_NEAR(std::max(watched.contacts()[i].penetration, far), std::max(all.contacts()[i].penetration, far), 1e-9);
      ASSERT_EQ(after[i].carries, after_all[i].carries);
    }
    memory = after;
  }
  EXPECT_GT(touched, 1000);
  EXPECT_GT(passed_over, 1000);
}

}  // namespace
}  // namespace overbend
