#include "dynamics/run/conveyor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "dynamics/setup/dynamic_setup.h"
#include "support/bgl1_in_time.h"

namespace overbend {
namespace {

using testing::TimedLay;

struct Laid {
  explicit Laid(const TimedLay& c, std::optional<double> element = {})
      : system(pipe_system(c.model, c.start, c.statics.top_tension)),
        state(state_at_rest(system, {c.start.state.q}, 0.0)),
        conveyor(c.model, system, element) {
    set_initial_memories(system.lines.front(), c.start, state.lines.front());
  }

  void pay_out(double length) {  // unstressed; the end is left where it is: bookkeeping asks for no balance
    const double* t = state.lines[0].q.data() + state.lines[0].q.size() - 3;
    state.attachments[1].travel.q += length * std::hypot(t[0], t[1], t[2]);
    if (conveyor.due(system, state)) conveyor.act(system, state, EndMotion{});
  }
  const Line& line() const { return system.lines.front(); }
  double length() const { return std::accumulate(line().mesh.length.begin(), line().mesh.length.end(), 0.0); }
  double mass() const {
    double sum = 0.0;
    for (std::size_t e = 0; e < line().mesh.length.size(); ++e)
      sum += line().elements.mass[e] * line().elements.length[e];
    return sum;
  }

  System system;
  SystemState state;
  Conveyor conveyor;
};

const TimedLay& plain() {
  static const TimedLay c(testing::workable());
  return c;
}

Description jointed() {
  Description d = testing::workable();
  d.pipe.section.joint = JointDescription{12.2, 0.7, 0.0, 1.5, {}, {}};
  return d;
}

TEST(conveyor, forty_joints_leave_length_and_mass_as_they_have_to_be) {
  Laid laid(plain());
  const double length = laid.length(), mass = laid.mass(), per_metre = laid.line().elements.mass[0];
  for (int i = 0; i < 40; ++i) laid.pay_out(12.2);
  EXPECT_NEAR(laid.conveyor.fed() + laid.state.attachments[1].travel.q, 40.0 * 12.2, 0.01);
  EXPECT_GT(laid.conveyor.fed(), 40.0 * 12.2 - 1.1);
  EXPECT_GT(laid.conveyor.dropped(), 0.0);
  const double change = laid.conveyor.fed() - laid.conveyor.dropped();
  EXPECT_NEAR(laid.length(), length + change, 1e-9 * length);
  EXPECT_NEAR(laid.mass(), mass + per_metre * change, 1e-9 * mass);
  EXPECT_NEAR(laid.line().mesh.total_length() - laid.line().mesh.s.front(), laid.length(), 1e-9 * length);
  EXPECT_EQ(laid.state.lines[0].q.size(), 6 * laid.line().mesh.s.size());
}

TEST(conveyor, joints_come_in_by_the_build_of_the_pipe) {
  const TimedLay c(jointed());
  Laid laid(c);
  const double start = laid.line().mesh.total_length();
  laid.pay_out(40.0 * 12.2 + 1.0);
  double bare = 0.0, coated = 0.0;
  int field_joints = 0, before = 0;
  for (std::size_t e = 0; e < laid.line().mesh.length.size(); ++e) {
    if (laid.line().mesh.s[e] < start - 1e-6) continue;
    const int section = laid.line().mesh.section[e];
    (section == 0 ? bare : coated) += laid.line().mesh.length[e];
    field_joints += section == 0 && before != 0 ? 1 : 0;
    before = section;
    EXPECT_EQ(laid.line().elements.EI[e], c.model.sections[static_cast<std::size_t>(section)].EI);
  }
  EXPECT_EQ(field_joints, 40);
  EXPECT_NEAR(bare, 40.0 * 0.7, 1e-9);
  EXPECT_NEAR(bare + coated, laid.conveyor.fed(), 1e-9);
}

TEST(conveyor, pipe_that_comes_in_is_none_of_a_structure_further_down_the_line) {
  Description d = jointed();
  StructureDescription tee;
  tee.name = "tee";
  tee.at = 300.0;
  tee.length = 5.5;
  tee.weight_in_air = 95e3;
  tee.weight_submerged = 70e3;
  tee.bending_stiffness = 4e8;
  d.pipe.structures = {tee};
  const TimedLay c(d);
  ASSERT_EQ(c.model.sections.size(), 3u);  // the pipe, coated between its joints, the tee
  Laid laid(c);
  const double start = laid.line().mesh.total_length();
  laid.pay_out(40.0 * 12.2 + 1.0);
  int coated = 0;
  for (std::size_t e = 0; e < laid.line().mesh.length.size(); ++e) {
    if (laid.line().mesh.s[e] < start - 1e-6) continue;
    EXPECT_LT(laid.line().mesh.section[e], 2) << e;
    EXPECT_LE(laid.line().elements.EI[e], 1.5 * c.model.sections[0].EI) << e;
    coated += laid.line().mesh.section[e] == 1 ? 1 : 0;
  }
  EXPECT_GT(coated, 0);
}

TEST(conveyor, hauls_in_what_it_paid_out) {
  Laid laid(plain());
  const std::vector<double> q = laid.state.lines[0].q;
  const std::vector<double> s = laid.line().mesh.s;
  laid.pay_out(5.0);
  EXPECT_GT(laid.line().mesh.s.back(), s.back() + 3.9);
  laid.pay_out(-5.0 - laid.line().mesh.length.back());
  EXPECT_NEAR(laid.conveyor.fed(), 0.0, 1e-9);
  EXPECT_NEAR(laid.line().mesh.s.back(), s.back(), 1e-9);
  EXPECT_NEAR(laid.conveyor.travelled(), 0.0, 1e-9);
  EXPECT_EQ(laid.state.lines[0].q.back(), q.back());
}

TEST(conveyor, refines_what_comes_to_the_touchdown) {
  Laid laid(plain());
  laid.pay_out(30.0);
  const LineMesh& mesh = laid.line().mesh;
  for (std::size_t e = 0; e < mesh.length.size(); ++e) {
    const double from_top = mesh.s.back() - mesh.s[e] - 0.5 * mesh.length[e];
    EXPECT_LE(mesh.length[e], 1.5 * laid.conveyor.planned(from_top) + 1e-9);
  }
}

TEST(conveyor, gives_the_mesh_back_from_what_it_saved) {
  const TimedLay c(jointed());
  Laid first(c), second(c);
  first.pay_out(55.0);
  second.conveyor.restore(first.conveyor.save(first.system), second.system);
  EXPECT_EQ(second.line().mesh.s, first.line().mesh.s);
  EXPECT_EQ(second.line().mesh.section, first.line().mesh.section);
  EXPECT_EQ(second.line().elements.length, first.line().elements.length);
  EXPECT_EQ(second.line().elements.EI, first.line().elements.EI);
  EXPECT_EQ(second.line().elements.pressure_external, first.line().elements.pressure_external);
  EXPECT_EQ(second.conveyor.fed(), first.conveyor.fed());
  EXPECT_EQ(second.system.attachments[0].place, first.system.attachments[0].place);
}

}  // namespace
}  // namespace overbend
