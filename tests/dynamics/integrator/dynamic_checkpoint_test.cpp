#include "dynamics/integrator/dynamic_checkpoint.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

namespace overbend {
namespace {

/// A state of two lines and three attachments with a number of its own everywhere.
SystemState numbered() {
  std::mt19937_64 generator(5);
  const auto number = [&] { return static_cast<double>(generator() >> 11) * 0x1.0p-53; };
  SystemState state;
  state.time = number();
  state.last_step = number();
  for (const std::size_t size : {std::size_t{12}, std::size_t{30}}) {
    LineState line;
    for (std::vector<double>* values : {&line.q, &line.v, &line.acc, &line.algorithmic_acceleration}) {
      for (std::size_t i = 0; i < size; ++i) values->push_back(number());
    }
    for (std::size_t i = 0; i < size; ++i) line.bed_slip.push_back(number());
    line.contacts.push_back({number(), number(), true, Slip::forward, Slip::backward, 3, number()});
    BendingMemory memory;
    memory.max_curvature = number();
    memory.stamp = 0x123456789abcdefULL;
    line.bending = BendingMemories(std::vector<BendingMemory>(size == 30 ? kGaussPoints : 0, memory));
    line.bending_heat = size == 30 ? number() : 0.0;
    state.lines.push_back(line);
  }
  for (int i = 0; i < 3; ++i) {
    AttachmentState held;
    held.guide = {number(), number(), number(), number()};
    held.travel = {number(), number(), number(), number()};
    held.machine.timer = number();
    held.machine.tension = number();
    held.machine.state = TensionerState::pay_out;
    state.attachments.push_back(held);
  }
  HullState body;
  for (Vec6* part : {&body.h, &body.v, &body.acc, &body.algorithmic_acceleration}) *part = Vec6::NullaryExpr(number);
  body.slow.value = Vec3::NullaryExpr(number);
  body.slow.rate = Vec3::NullaryExpr(number);
  body.radiation.values = {number(), number(), number()};
  state.bodies.assign(2, body);
  state.bodies[1].h(5) = number();
  return state;
}

/// A state of the same sizes, everything else as it is made.
SystemState blank(const SystemState& like) {
  SystemState state;
  for (const LineState& line : like.lines) {
    LineState empty;
    empty.contacts.resize(line.contacts.size());
    empty.bending = BendingMemories(std::vector<BendingMemory>(line.bending.size()));
    state.lines.push_back(empty);
  }
  state.attachments.resize(like.attachments.size());
  for (const HullState& body : like.bodies) {
    state.bodies.emplace_back().radiation.values.resize(body.radiation.values.size());
  }
  return state;
}

TEST(dynamic_checkpoint, gives_a_state_of_several_lines_and_bodies_back_bit_for_bit) {
  const SystemState state = numbered();
  DynamicCheckpoint first, second;
  save_state(first, state);
  SystemState restored = blank(state);
  restore_state(first, restored);
  save_state(second, restored);
  ASSERT_EQ(first.arrays.size(), second.arrays.size());
  for (std::size_t i = 0; i < first.arrays.size(); ++i) {
    EXPECT_EQ(first.arrays[i].name, second.arrays[i].name);
    EXPECT_EQ(first.arrays[i].values, second.arrays[i].values) << first.arrays[i].name;
  }
  EXPECT_EQ(restored.lines[1].q, state.lines[1].q);
  EXPECT_EQ(restored.lines[1].bending.at(1).stamp, state.lines[1].bending.at(1).stamp);
  EXPECT_EQ(restored.attachments[2].travel.algorithmic_acceleration,
            state.attachments[2].travel.algorithmic_acceleration);
  EXPECT_EQ(restored.bodies[1].h, state.bodies[1].h);
  EXPECT_EQ(restored.bodies[1].slow.rate, state.bodies[1].slow.rate);
  EXPECT_EQ(restored.bodies[0].radiation.values, state.bodies[0].radiation.values);
}

TEST(dynamic_checkpoint, says_which_array_is_missing) {
  SystemState state = blank(numbered());
  EXPECT_THROW(restore_state({}, state), std::runtime_error);
}

}  // namespace
}  // namespace overbend
