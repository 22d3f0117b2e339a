#include "statics/solver/steady_laying.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "base/constants.h"
#include "mechanics/point_load.h"
#include "statics/recovery/recovery.h"
#include "statics/solver/sensitivity.h"
#include "support/fixtures.h"

namespace overbend {
namespace {

/// J-lay of a pipe that hardly bends, in a current to port of the barge, which heads east.
Description soft_pipe_across_a_current(double speed) {
  Description d = testing::plain_description();
  d.environment.water_depth = 300.0;
  d.environment.seabed.friction_lateral = d.environment.seabed.friction_axial = 0.5;
  d.environment.current = {{0.0, speed, 0.0}, {200.0, 0.7 * speed, 0.0}, {300.0, 0.0, 0.0}};
  d.pipe.section.steel.youngs_modulus = 4e9;
  d.tensioner.x = 0.0;
  d.tensioner.z = 0.5;
  d.tensioner.incline = 70.0 * kDegree;
  d.tensioner.guide = Guide::pinned;
  d.tensioner.tension = 250e3;
  return d;
}

struct Laid {
  Model model;
  StaticOutcome outcome;
  StaticResults results;
};

Laid laid(const Description& description) {
  Laid lay{build_model(description), {}, {}};
  lay.outcome = solve_statics(lay.model);
  EXPECT_TRUE(lay.outcome.solution) << (lay.outcome.failure ? lay.outcome.failure->why : "");
  if (lay.outcome.solution) lay.results = recover_statics(lay.model, *lay.outcome.solution);
  return lay;
}

/// A string from touchdown, where it lies along the route, up to the height of the tensioner: its end, pull and length.
struct SuspendedString {
  Vec3 end;
  double tension = 0.0;
};

/// Integrated by the classical Runge-Kutta rule from the horizontal pull at touchdown: dF/ds = -(loads), dr/ds = F/|F|
/// with the stretch of the elastic pipe.
SuspendedString make_string(const Model& model, double pull, double top) {
  const Section& pipe = model.sections.front();
  const LineElements elements = line_elements(model, {1.0}, {0});
  const LineEnvironment env = line_environment(model, lay_route(model));
  const auto load = [&](const Vec3& r, const Vec3& t) {
    const PointLoad point_weight = point_load(elements, env, 0, r, t);
    return Vec3(point_weight.weight + point_weight.buoyancy + point_weight.current);
  };
  const auto slope = [&](const Vec3& r, const Vec3& f) {
    const Vec3 t = f.normalized();
    return std::pair<Vec3, Vec3>{t * (1.0 + f.norm() / pipe.EA), -load(r, t)};
  };
  Vec3 r = Vec3::Zero(), f = pull * -astern_direction(model.mean_pose);
  r.z() = -model.description.environment.water_depth + pipe.outer_radius();
  const double h = 0.25;
  while (r.z() < top) {
    const auto [k1, l1] = slope(r, f);
    const auto [k2, l2] = slope(r + 0.5 * h * k1, f + 0.5 * h * l1);
    const auto [k3, l3] = slope(r + 0.5 * h * k2, f + 0.5 * h * l2);
    const auto [k4, l4] = slope(r + h * k3, f + h * l3);
    const Vec3 dr = h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4), df = h / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
    const double share = std::min(1.0, (top - r.z()) / dr.z());
    r += share * dr;
    f += share * df;
    if (share < 1.0) break;
  }
  return {r, f.norm()};
}

SuspendedString make_string_with_tension(const Model& model, double tension, double top) {
  double low = 1e3, high = tension;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (make_string(model, middle, top).tension < tension ? low : high) = middle;
  }
  return make_string(model, low, top);
}

TEST(steady_laying, is_that_of_a_string_in_the_current_and_puts_the_side_load_on_the_top) {
  const Laid lay = laid(soft_pipe_across_a_current(0.8));
  ASSERT_TRUE(lay.outcome.solution);
  ASSERT_TRUE(lay.results.route);
  const Vec3 top = lay.results.tensioner_W;
  const SuspendedString string = make_string_with_tension(lay.model, 250e3, top.z());
  const Vec3 port = lay_route(lay.model).port(0.0);
  const double aside = -string.end.dot(port);  // from the tensioner to touchdown
  EXPECT_GT(aside, 10.0);
  EXPECT_NEAR(lay.results.route->laid_offset, aside, 0.01 * aside);
  EXPECT_NEAR(lay.results.lay_back,
              (lay.results.stern_shoe_W - top).dot(-astern_direction(lay.model.mean_pose)) +
                  string.end.dot(-astern_direction(lay.model.mean_pose)),
              0.01 * lay.results.lay_back);
  const double side = lay.results.sum_current.dot(port);
  EXPECT_NEAR(lay.results.route->side_load_supports, side, 0.02 * side);
  EXPECT_NEAR(lay.results.route->side_load_bed + lay.results.route->side_load_supports, side, 1e-6 * side);
}

TEST(steady_laying, leaves_the_pipe_where_it_first_touched) {
  const Laid lay = laid(soft_pipe_across_a_current(0.8));
  ASSERT_TRUE(lay.outcome.solution);
  const LayRoute line = laid_route(lay.model, *lay.outcome.solution);
  EXPECT_GT(std::abs(line.shift()), 1.0);
  EXPECT_NEAR(line.offset(lay.results.touchdown.p_W), 0.0, 1e-6);
}

TEST(steady_laying, differs_from_a_pipe_pulled_across_and_static_keeps_its_line_on_the_route) {
  Description d = soft_pipe_across_a_current(0.8);
  const Laid steady = laid(d);
  d.statics.laying = SeabedLayHistory::pulled_sideways;
  const Laid pulled = laid(d);
  ASSERT_TRUE(steady.outcome.solution && pulled.outcome.solution);
  EXPECT_EQ(laid_route(pulled.model, *pulled.outcome.solution).shift(), 0.0);
  EXPECT_NEAR(lay_route(pulled.model).offset(pulled.results.anchor_W), 0.0, 1e-9);
  EXPECT_GT(pulled.results.route->side_load_bed, 5.0 * std::abs(steady.results.route->side_load_bed));
}

TEST(steady_laying, without_side_load_is_what_static_gives_bit_for_bit) {
  Description d = soft_pipe_across_a_current(0.8);
  d.environment.current.clear();
  const Laid steady = laid(d);
  d.statics.laying = SeabedLayHistory::pulled_sideways;
  const Laid pulled = laid(d);
  ASSERT_TRUE(steady.outcome.solution && pulled.outcome.solution);
  EXPECT_EQ(steady.outcome.solution->state.q, pulled.outcome.solution->state.q);
}

TEST(steady_laying, to_starboard_is_the_mirror_image) {
  const Laid port = laid(soft_pipe_across_a_current(0.8));
  Description d = soft_pipe_across_a_current(0.8);
  for (CurrentPoint& point : d.environment.current) point.towards = 180.0 * kDegree;
  const Laid starboard = laid(d);
  ASSERT_TRUE(port.results.route && starboard.results.route);
  EXPECT_NEAR(port.results.route->laid_offset, -starboard.results.route->laid_offset, 1e-6);
}

TEST(steady_laying, is_the_same_from_nothing_and_from_another_current) {
  const Laid weak = laid(soft_pipe_across_a_current(0.3)), strong = laid(soft_pipe_across_a_current(0.8));
  ASSERT_TRUE(weak.outcome.solution && strong.outcome.solution);
  const StaticOutcome warm = solve_statics(strong.model, &*weak.outcome.solution);
  ASSERT_TRUE(warm.solution);
  EXPECT_NEAR(recover_statics(strong.model, *warm.solution).route->laid_offset, strong.results.route->laid_offset,
              2e-3);
}

/// The line goes along with the model: against solves on either side.
TEST(steady_laying, is_followed_to_first_order_by_the_tangent_of_the_equilibrium) {
  Description d = soft_pipe_across_a_current(0.6);
  d.statics.tolerance = 1e-11;
  const Laid lay = laid(d);
  ASSERT_TRUE(lay.outcome.solution);
  const double h = 1e-3;
  const auto changed = [&](double by) {
    Description second_description = d;
    for (CurrentPoint& point : second_description.environment.current) point.speed *= 1.0 + by;
    return build_model(second_description);
  };
  const Model before = changed(-h), after = changed(h);
  EquilibriumTangent tangent(lay.model, *lay.outcome.solution);
  const std::optional<StaticPair> followed = tangent.neighbouring_equilibria(before, after);
  ASSERT_TRUE(followed);
  const auto far = [](const StaticSolution& s) { return Vec3(Eigen::Map<const Vec3>(s.state.q.data())); };
  const StaticOutcome low = solve_statics(before, &*lay.outcome.solution),
                      high = solve_statics(after, &*lay.outcome.solution);
  ASSERT_TRUE(low.solution && high.solution);
  const double solved = (far(*high.solution) - far(*low.solution)).y();
  EXPECT_GT(std::abs(solved), 1e-3);
  EXPECT_NEAR((far(followed->after) - far(followed->before)).y(), solved, 1e-4 * std::abs(solved));
}

}  // namespace
}  // namespace overbend
