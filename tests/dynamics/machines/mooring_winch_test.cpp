#include "dynamics/machines/mooring_winch.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

std::optional<WinchLaw> make_law(const WinchDescription& winch) {
  MooringsDescription moorings;
  moorings.winches = {winch};
  MooringLineDescription line;
  line.winch = winch.name;
  return find_winch_law(moorings, line);
}

WinchDescription winch(WinchMode mode) {
  WinchDescription winch;
  winch.name = "main";
  winch.mode = mode;
  winch.speed = 0.1;
  winch.acceleration_time = 5.0;
  return winch;
}

TEST(mooring_winch, that_holds_whatever_the_tension_is_none) {
  EXPECT_FALSE(make_law(winch(WinchMode::hold)));
  WinchDescription renders = winch(WinchMode::hold);
  renders.brake = 1600e3;
  const std::optional<WinchLaw> law = make_law(renders);
  ASSERT_TRUE(law);
  EXPECT_EQ(law->brake, 1600e3);
  EXPECT_EQ(law->program.at(100.0).rate, 0.0);
}

/// An operation gives it a program.
TEST(mooring_winch, that_holds_without_a_brake_stalls_where_it_says) {
  WinchDescription stalls = winch(WinchMode::hold);
  stalls.stall = 330e3;
  ASSERT_TRUE(make_law(stalls));
  EXPECT_EQ(make_law(stalls)->stall, 330e3);
  WinchDescription hauls = winch(WinchMode::hold);
  hauls.haul = 300e3;
  ASSERT_TRUE(make_law(hauls));
  EXPECT_EQ(make_law(hauls)->stall, 300e3);
}

TEST(mooring_winch, in_mode_speed_makes_its_moves_one_after_the_other) {
  WinchDescription mover = winch(WinchMode::speed);
  mover.program = {{10.0, 2.0}, {20.0, -1.0}};  // the second begins when the first is done, at 35 s
  const LengthTable table = make_law(mover).value().program;
  EXPECT_NEAR(table.at(22.0).rate, 0.1, 1e-12);
  EXPECT_NEAR(table.at(35.0).length, 2.0, 1e-12);
  EXPECT_NEAR(table.at(50.0).rate, -0.1, 1e-12);
  EXPECT_NEAR(table.at(70.0).length, -1.0, 1e-12);
}

TEST(mooring_winch, in_mode_length_is_there_by_the_times_given) {
  WinchDescription follower = winch(WinchMode::length);
  follower.program = {{30.0, 4.0}, {60.0, 1.0}};
  const LengthTable table = make_law(follower).value().program;
  EXPECT_EQ(table.at(0.0).length, 0.0);
  EXPECT_NEAR(table.at(30.0).length, 4.0, 1e-12);
  EXPECT_NEAR(table.at(60.0).length, 1.0, 1e-12);
  EXPECT_EQ(table.at(60.0).rate, 0.0);
}

TEST(mooring_winch, in_mode_tension_stays_within_its_band) {
  WinchDescription keeper = winch(WinchMode::tension);
  keeper.tension = 300e3;
  EXPECT_NEAR(make_law(keeper).value().tension.high, 330e3, 1e-6);
  keeper.band = 20e3;
  const WinchLaw law = make_law(keeper).value();
  EXPECT_NEAR(law.tension.low, 280e3, 1e-6);
  EXPECT_NEAR(law.tension.acceleration, 0.02, 1e-12);
  EXPECT_TRUE(law.program.empty());
}

}  // namespace
}  // namespace overbend
