/// Lines on free bodies: residual and tangent of the border, by differences and by what must hold.
#include "system/body_border.h"

#include <gtest/gtest.h>

#include <random>

#include "support/free_body.h"

namespace overbend {
namespace {

using namespace testing;

/// A system in a random state, its tangent tested along the correction that Newton's method makes there.
class Tangent {
 public:
  /// `size`: by how much it is out of its straight place, the body four times as much in its angles [m, -].
  Tangent(System system, double velocity_share, double acceleration_share, unsigned seed, double size = 0.05)
      : system_(std::move(system)), weights_{velocity_share, acceleration_share, 0.02}, random_(seed) {
    system_.surroundings = surroundings_at_rest(system_);
    assembly_.emplace(system_);
    std::vector<std::vector<double>> q;
    for (std::size_t i = 0; i < system_.lines.size(); ++i) {
      q.push_back(straight(system_, Vec3(0.0, 3.0 * static_cast<double>(i), 0.0), Vec3::UnitX()));
      for (double& x : q.back()) x += shake(size);
    }
    state = state_at_rest(system_, q, 0.0);
    for (HullState& body : state.bodies) {
      for (int k = 0; k < 6; ++k) body.h(k) += shake(k < 3 ? size : 4.0 * size);
    }
  }

  double shake(double size) { return std::uniform_real_distribution<double>(-size, size)(random_); }
  Assembly& assembly() { return *assembly_; }
  System& system() { return system_; }

  /// Residuals of lines and bodies after a share of the correction.
  Eigen::VectorXd residual(double share) {
    SystemState system_state = state;
    const Vec6 zero = Vec6::Zero();
    const auto move = [&](auto& values, std::size_t size, double weight, auto of) {
      for (std::size_t i = 0; i < size; ++i) values[i] += share * weight * of(i);
    };
    for (std::size_t line = 0; line < system_state.lines.size() && !dq.empty(); ++line) {
      LineState& l = system_state.lines[line];
      const auto of = [&](std::size_t i) { return dq[line][i]; };
      move(l.q, l.q.size(), 1.0, of);
      move(l.v, l.q.size(), weights_.velocity, of);
      move(l.acc, l.q.size(), weights_.acceleration, of);
    }
    for (std::size_t i = 0; i < system_state.bodies.size(); ++i) {
      const Vec6 dh = dq.empty() ? zero : Vec6(share * Eigen::Map<const Vec6>(dq.back().data() + 6 * i));
      system_state.bodies[i].h += dh;
      system_state.bodies[i].v += weights_.velocity * dh;
      system_state.bodies[i].acc += weights_.acceleration * dh;
    }
    for (std::size_t i = 0; i < system_state.attachments.size() && !dq.empty(); ++i) {
      const Attachment& held = system_.attachments[i];
      const std::size_t line = static_cast<std::size_t>(held.line);
      const double* part = dq[line].data() + 6 * held_node(held, system_.lines[line]);
      const Vec3 direction = directions_[i];
      const auto add = [&](MotionValues& values, double d) {
        values.q += share * d;
        values.v += share * weights_.velocity * d;
        values.acc += share * weights_.acceleration * d;
      };
      add(system_state.attachments[i].guide, direction.dot(Vec3(Eigen::Map<const Vec3>(part + 3))));
      if (held.tensioner.has_value()) {
        add(system_state.attachments[i].travel, -direction.dot(Vec3(Eigen::Map<const Vec3>(part))));
      }
    }
    return evaluate(system_state, false);
  }

  Eigen::VectorXd evaluate(SystemState& system_state, bool with_tangent) {
    assembly_->impose_ends(system_state);
    assembly_->evaluate(system_state, state, weights_, with_tangent);
    assembly_->hold(with_tangent);
    std::vector<double> all;
    for (std::size_t i = 0; i < system_.lines.size(); ++i) {
      const std::vector<double> single = along_guides(i);
      all.insert(all.end(), single.begin(), single.end());
    }
    all.insert(all.end(), assembly_->body_residual().begin(), assembly_->body_residual().end());
    return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
  }

  /// Residual of a line; what is left along a guide as the one number it is, for the guide turns.
  std::vector<double> along_guides(std::size_t line) {
    std::vector<double> residual = assembly_->line(line).residual();
    for (std::size_t i = 0; i < system_.attachments.size(); ++i) {
      const Attachment& held = system_.attachments[i];
      const auto keep_along = [&](bool guided, int first) {
        Eigen::Map<Vec3> part(residual.data() + 6 * held_node(held, system_.lines[line]) + first);
        if (guided && held.line == static_cast<int>(line)) {
          part = part.dot(assembly_->surroundings().ends[i].direction) * Vec3::UnitX();
        }
      };
      keep_along(held.hold_direction, 3);
      keep_along(held.tensioner.has_value(), 0);
    }
    return residual;
  }

  /// Largest error of the change of the residual along the correction, over the largest residual: of the lines and of
  /// the bodies.
  std::pair<double, double> error() {
    assembly_->set_time(0.0, state);
    for (std::size_t i = 0; i < assembly_->tensioners().size(); ++i) {
      assembly_->set_drive(i, TensionerDrive::governor);
    }
    assembly_->impose_ends(state);
    SystemState system_state = state;
    const Eigen::VectorXd local = evaluate(system_state, true);
    for (const EndMotion& end : assembly_->surroundings().ends) directions_.push_back(end.direction);
    dq = assembly_->increments();
    EXPECT_TRUE(assembly_->solve_factored(dq));
    constexpr double kShare = 1e-4;
    const Eigen::VectorXd slope = (residual(kShare) - residual(-kShare)) / (2.0 * kShare);
    const Eigen::Index n = 6 * static_cast<Eigen::Index>(state.bodies.size());
    const auto max_value = [](const Eigen::VectorXd& x) { return x.cwiseAbs().maxCoeff(); };
    const Eigen::VectorXd off = slope + local;
    return {max_value(off.head(off.size() - n)) / max_value(local.head(off.size() - n)),
            max_value(off.tail(n)) / max_value(local.tail(n))};
  }

  SystemState state;
  Increments dq;

 private:
  System system_;
  Weights weights_;
  std::mt19937 random_;
  std::optional<Assembly> assembly_;
  std::vector<Vec3> directions_;
};

/// A soft rod of four elements whose last end is on a body on springs.
System rod_on_body(bool place, bool direction) {
  System system = rod_system({4000.0, 60.0, 1.2}, 4.0, 4);
  SpringBody springs;
  springs.stiffness << 900.0, 1100.0, 1500.0, 700.0, 800.0, 500.0;
  springs.pull << 30.0, -20.0, 10.0, 25.0, -15.0, 40.0;
  system.bodies[0].free = free_body(springs, Vec3(0.3, -0.2, 0.1));
  hold_on_body(last_end(system), Vec3(4.3, -0.2, 0.1), Vec3(1.0, 0.1, -0.2).normalized());
  hold(last_end(system), place, direction);
  hold(first_end(system), true, false);
  return system;
}

void expect_exact(const System& system, double tolerance = 1e-6, double size = 0.05, double slip = 0.0) {
  for (unsigned seed = 1; seed < 4; ++seed) {
    Tangent border_tangent(system, 60.0, 3600.0, seed, size);
    const auto slide = [slip](Tangent& tangent) {
      for (ContactMemory& contact : tangent.state.lines[0].contacts) contact.slip_axial = contact.slip_lateral = slip;
    };
    slide(border_tangent);
    const auto [lines, bodies] = border_tangent.error();
    EXPECT_LT(lines, tolerance) << seed;
    EXPECT_LT(bodies, tolerance) << seed;
    Tangent resting(system, 0.0, 0.0, seed, size);
    slide(resting);
    const auto [lines_at_rest, bodies_at_rest] = resting.error();
    EXPECT_LT(lines_at_rest, tolerance) << seed;
    EXPECT_LT(bodies_at_rest, tolerance) << seed;
  }
}

// Differences over 1e-4 of the correction leave 1e-8 of its curvature.
TEST(body_border, of_an_end_pinned_to_the_body_is_the_derivative) {
  expect_exact(rod_on_body(true, false));
}

TEST(body_border, of_an_end_clamped_in_the_body_is_the_derivative) {
  expect_exact(rod_on_body(true, true));
}

TEST(body_border, of_an_end_whose_direction_alone_is_held_is_the_derivative) {
  expect_exact(rod_on_body(false, true));
}

TEST(body_border, of_both_ends_on_one_body_is_the_derivative) {
  System system = rod_on_body(true, true);
  hold_on_body(first_end(system), Vec3(0.3, -0.2, 0.1), Vec3(1.0, -0.3, 0.1).normalized());
  hold(first_end(system), true, true);
  expect_exact(system);
  System single = rod_system({4000.0, 60.0, 1.2}, 4.0, 1);  // no node is free
  single.bodies = system.bodies;
  single.attachments = system.attachments;
  expect_exact(single);
}

TEST(body_border, of_a_quasi_static_line_is_the_derivative) {
  System system = rod_on_body(true, true);
  const Vec3 far(3.0, -4.0, -2.0);
  system.bodies[0].free->springs.push_back(
      {Vec3(1.0, 0.5, -0.4), [far](const Vec3& place, double, const LineEndForces&) {
         const Vec3 away = place - far;  // a force that grows with its square
         const double l = away.norm();
         const Mat3 slope = 9.0 * (l * Mat3::Identity() + away * away.transpose() / l);
         return PlaceForce{-9.0 * l * away, slope, 3.0 * l * l * l, {}};
       }});
  expect_exact(system);
}

TEST(body_border, of_a_rod_between_two_bodies_is_the_derivative) {
  System system = rod_on_body(true, true);
  SpringBody second_spring_body;
  second_spring_body.stiffness = Vec6::Constant(600.0);
  second_spring_body.pull << -10.0, 5.0, 20.0, 5.0, 10.0, -30.0;
  system.bodies.emplace_back().free = free_body(second_spring_body);
  hold_on_body(first_end(system), Vec3(0.1, 0.2, -0.1));
  first_end(system).body = 1;
  hold(first_end(system), true, true);
  expect_exact(system);
}

/// Holds an inner node of a line to a body at a point of its frame.
Attachment& hold_inside(System& system, int line, int node, int body, const Vec3& place_V) {
  Attachment& held = system.attachments.emplace_back();
  held.line = line;
  held.end = LineEnd::inner;
  held.node = node;
  hold_on_body(held, place_V);
  held.body = body;
  return held;
}

TEST(body_border, of_nodes_between_the_ends_is_the_derivative) {
  System system = rod_on_body(true, true);
  hold_inside(system, 0, 2, 0, Vec3(2.1, 0.1, -0.1));
  expect_exact(system);
  hold_inside(system, 0, 1, 0, Vec3(1.0, -0.1, 0.1)).hold_direction = true;  // next to the other
  expect_exact(system);
}

/// A point where the middle of a rod and the end of another meet.
System rods_at_a_point() {
  System system = rod_on_body(true, true);
  system.lines.push_back(rod_system({4000.0, 60.0, 1.2}, 4.0, 4).lines[0]);
  Attachment ground = first_end(system);
  ground.line = 1;
  ground.place = Vec3(0.0, 3.0, 0.0);
  Attachment end = ground;
  end.end = LineEnd::last;
  end.body = 1;
  end.place = Vec3::Zero();
  system.attachments.push_back(ground);
  system.attachments.push_back(end);
  system.bodies.emplace_back().free = free_point(Vec3(3.0, 1.5, 0.2), 100.0);
  hold_inside(system, 0, 2, 1, Vec3::Zero());
  return system;
}

void expect_exact_at_a_point(const System& system) {
  for (unsigned seed = 1; seed < 4; ++seed) {
    Tangent resting(system, 0.0, 0.0, seed, 0.05);
    const auto [lines, bodies] = resting.error();
    EXPECT_LT(lines, 1e-6) << seed;
    EXPECT_LT(bodies, 1e-6) << seed;
  }
}

TEST(body_border, of_a_point_where_lines_meet_is_the_derivative) {
  expect_exact_at_a_point(rods_at_a_point());
}

TEST(body_border, of_wires_is_the_derivative) {
  System system = rods_at_a_point();
  system.wires.push_back({"to the ground", 1, kGround, Vec3::Zero(), Vec3(2.0, 5.0, 4.0), 4.0, 3000.0, std::nullopt});
  system.wires.push_back({"to the body", 0, 1, Vec3(1.0, -0.3, 2.0), Vec3::Zero(), 2.0, 2000.0, std::nullopt});
  system.wires.push_back({"slack", 0, 1, Vec3(1.0, -0.3, 2.0), Vec3::Zero(), 40.0, 2000.0, std::nullopt});
  expect_exact_at_a_point(system);
}

System governed(bool clamped) {
  System system = rod_on_body(true, clamped);
  TensionerLaw& law = last_end(system).tensioner.emplace();
  law.mode = TensionerMode::controlled;
  law.wanted = 100.0;
  law.low = 80.0;
  law.high = 120.0;
  law.velocity = 0.2;
  return system;
}

TEST(body_border, of_an_end_that_a_tensioner_on_the_body_lets_move_is_the_derivative) {
  expect_exact(governed(true));
}

constexpr double kPressed = 0.01;  ///< Out of place so little that rollers keep carrying.

/// A rod over two rollers of the body, pressed into them and rubbing.
System rod_on_rollers(const ContactLaw& law) {
  System system = rod_on_body(true, true);
  BodyRoller roller = roller_under(1.3, 0.01, law);
  roller.center_V.z() += 0.12;
  system.bodies[0].rollers = {roller, roller};
  system.bodies[0].rollers[1].center_V.x() = 3.4;  // next to the held node
  system.bodies[0].cells = endless_cells();
  return system;
}

ContactLaw rubbing(double friction) {
  ContactLaw law;
  law.stiffness = 2e4;
  law.damping = 40.0;
  law.tangential_stiffness = 3e3;
  law.tangential_damping = 20.0;
  law.friction_axial = law.friction_lateral = friction;
  return law;
}

TEST(body_border, of_rollers_that_push_is_the_derivative) {
  ContactLaw smooth = rubbing(0.0);
  smooth.tangential_stiffness = smooth.tangential_damping = 0.0;
  expect_exact(rod_on_rollers(smooth), 1e-6, kPressed);
}

// The turn of the directions of sliding friction, which the line's own tangent omits, is missing here as well: a
// hundredth of the normal force over the distance to the roller.
TEST(body_border, of_rollers_that_rub_is_the_derivative_as_far_as_the_lines_own_tangent_is) {
  expect_exact(rod_on_rollers(rubbing(50.0)), 1e-6, kPressed);       // sticks, not loaded before the step
  expect_exact(rod_on_rollers(rubbing(0.01)), 2e-3, kPressed, 1.0);  // slides
}

/// A section with mass, drag, water and a wire, on a hinge of body `carrier` at `place_V`.
FreeBody section_on(int carrier, const Vec3& place_V) {
  FreeBody free;
  HingedBody& hinged = free.hinge.emplace();
  hinged.carrier = carrier;
  hinged.hinge.place_V = place_V;
  hinged.hinge.axis_V = Vec3(0.1, -1.0, 0.05).normalized();
  hinged.section.mass = 12.0;
  hinged.section.center_V = place_V + Vec3(-0.8, 0.05, -0.2);
  hinged.section.inertia_V = Vec3(2.0, 5.0, 6.0).asDiagonal();
  hinged.section.strips.push_back({place_V + Vec3(-0.2, 0.1, -0.1), place_V + Vec3(-1.2, 0.1, -0.5), 0.1, 1.0, 1.0, 0});
  hinged.section.immersed = ImmersedBody{place_V + Vec3(-1.0, 0.0, 0.0), Vec3::UnitZ(), 0.002, 3.0, 0.05};
  hinged.section.springs.push_back({place_V + Vec3(0.5, 0.0, 1.0), place_V + Vec3(-1.0, 0.0, 0.1), 3000.0, 1.2, true});
  hinged.law.down = -0.5;  // it leans on the stop, however it is shaken
  hinged.law.stop_stiffness = 900.0;
  hinged.law.stop_damping = 2.0;
  hinged.law.friction = 4.0;
  auto sea = std::make_shared<SectionSea>();
  sea->weight_density = 10.05e3;
  hinged.sea = std::move(sea);
  free.force_scale = 100.0;
  return free;
}

/// Two sections suspended from the body next to the rod, one on the other, both with a roller under the rod.
System rod_on_sections(const ContactLaw& law, bool free_vessel) {
  System system = rod_on_body(true, true);
  if (!free_vessel) {
    system.bodies[0].free.reset();
  }
  for (int i = 0; i < 2; ++i) {
    Body& section = system.bodies.emplace_back();
    section.free = section_on(i, Vec3(3.6 - 2.0 * i, 0.1, -0.3));
    BodyRoller roller = roller_under(i == 0 ? 3.3 : 1.3, 0.01, law);
    roller.center_V.z() += 0.12;
    section.rollers = {roller};
    section.cells = endless_cells();
  }
  return system;
}

// Forces of the sections themselves are differentiated by differences: at rest the slope of the drag, which is square
// in the speed, comes out as that of 1e-4 rad/s, 1e-5 of the whole.
TEST(body_border, of_rollers_on_hinged_sections_is_the_derivative) {
  ContactLaw smooth = rubbing(0.0);
  smooth.tangential_stiffness = smooth.tangential_damping = 0.0;
  for (const bool free_vessel : {false, true}) {
    SCOPED_TRACE(free_vessel);
    expect_exact(rod_on_sections(smooth, free_vessel), 5e-5, kPressed);
    expect_exact(rod_on_sections(rubbing(50.0), free_vessel), 5e-5, kPressed);
  }
}

// At rest together: the vessel carries the supports of the sections and the forces of the rod on them.
TEST(body_border, hinged_sections_hand_their_rollers_forces_on_to_a_free_vessel) {
  ContactLaw smooth = rubbing(0.0);
  System system = rod_on_sections(smooth, true);
  for (Body& body : system.bodies) {
    if (body.free && body.free->hinge) {
      body.free->hinge->section = SectionBody{};  // weightless
      body.free->hinge->law = HingeLaw{};
    }
  }
  System rigid = rod_on_body(true, true);
  rigid.bodies[0].rollers = {system.bodies[1].rollers[0], system.bodies[2].rollers[0]};
  rigid.bodies[0].cells = endless_cells();
  const auto force_on_vessel = [](const System& of) {
    Tangent tangent(of, 0.0, 0.0, 1, 0.0);
    tangent.assembly().set_time(0.0, tangent.state);
    SystemState state = tangent.state;
    tangent.evaluate(state, false);
    return Vec6(Eigen::Map<const Vec6>(tangent.assembly().body_residual().data()));
  };
  const Vec6 difference = force_on_vessel(system) - force_on_vessel(rigid);
  EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-9 * force_on_vessel(rigid).cwiseAbs().maxCoeff());
}

TEST(body_border, with_renewed_contacts_gives_the_step_of_a_full_tangent) {
  ContactLaw law = rubbing(0.3);
  law.tangential_stiffness = 30.0;
  System system = rod_on_rollers(law);
  system.bodies[0].rollers.erase(system.bodies[0].rollers.begin());
  system.surroundings = surroundings_at_rest(system);
  system.bodies[0].cells.boxes.front() = {-1e9, -2.8, 1e9};  // x runs astern: the last elements
  Assembly assembly(system);
  SystemState state = state_at_rest(system, {straight(system, Vec3::Zero(), Vec3::UnitX())}, 0.0);
  const Weights weights{60.0, 3600.0, 0.02};
  const auto solved = [&](bool with_tangent, const auto& solve) {
    SystemState system_state = state;
    assembly.set_time(0.0, system_state);
    assembly.impose_ends(system_state);
    assembly.evaluate(system_state, state, weights, with_tangent);
    assembly.hold(with_tangent);
    Increments dq = assembly.increments();
    EXPECT_TRUE(solve(system_state, dq));
    return dq;
  };
  const auto fully = [&](const SystemState&, Increments& dq) { return assembly.solve_factored(dq); };
  solved(true, fully);
  state.lines[0].contacts[0].slip_axial = state.lines[0].contacts[0].slip_lateral = 5.0;  // it slides
  const Increments old = solved(false, [&](const SystemState&, Increments& dq) {
    assembly.solve_again(dq);
    return true;
  });
  const Increments renewed = solved(false, [&](const SystemState& system_state, Increments& dq) {
    const bool renewed_at_all = assembly.renew_contacts(system_state, weights);
    assembly.solve_again(dq);
    return renewed_at_all;
  });
  const Increments full = solved(true, fully);
  const auto vector = [](const std::vector<double>& values) {
    return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())));
  };
  for (const std::size_t part : {std::size_t{0}, std::size_t{1}}) {  // the line's, the body's
    const double size = vector(full[part]).norm();
    EXPECT_GT((vector(old[part]) - vector(full[part])).norm(), 1e-4 * size) << part;
    EXPECT_LT((vector(renewed[part]) - vector(full[part])).norm(), 1e-9 * size) << part;
  }
}

TEST(body_border, leaves_no_force_and_no_moment_over_between_lines_and_bodies) {
  System system = rod_on_rollers(rubbing(0.3));
  system.bodies[0].free->balance = [](const HullState&, const HullState&, const Weights&, double, HullBalance& out) {
    out = HullBalance{};
  };
  Tangent tangent(system, 60.0, 3600.0, 5, kPressed);
  for (double& v : tangent.state.lines[0].v) v = tangent.shake(0.1);
  tangent.assembly().set_time(0.0, tangent.state);
  tangent.assembly().impose_ends(tangent.state);
  SystemState before = tangent.state;
  tangent.assembly().evaluate(tangent.state, before, {0.0, 0.0, 0.02}, false);
  int carrying = 0;
  for (const RollerContact& contact : tangent.assembly().line(0).contacts().contacts())
    carrying += contact.normal > 0.0;
  ASSERT_EQ(carrying, 2);
  const LineAssembly& line = tangent.assembly().line(0);
  const BodyPose pose = make_pose(tangent.state.bodies[0].h);
  const auto part = [](const std::vector<double>& values, std::size_t first) {
    return Vec3(Eigen::Map<const Vec3>(values.data() + first));
  };
  Vec3 force = part(tangent.assembly().body_residual(), 0);
  Vec3 moment = pose.E.transpose().inverse() * part(tangent.assembly().body_residual(), 3) + pose.place.cross(force);
  double size = force.norm();
  for (std::size_t i = 0; i + 6 < line.residual().size(); i += 6) {  // the held end's is the body's
    const Vec3 f = part(line.residual(), i), r = part(tangent.state.lines[0].q, i);
    force += f;
    moment += r.cross(f) + part(tangent.state.lines[0].q, i + 3).cross(part(line.residual(), i + 3));
    size = std::max(size, f.norm());
  }
  EXPECT_GT(size, 100.0);
  EXPECT_LT(force.norm(), 1e-12 * size);
  EXPECT_LT(moment.norm(), 1e-11 * size);
}

}  // namespace
}  // namespace overbend
