#include "study/run/non_stationary.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

DynamicResults two_lines() {
  DynamicResults results;
  results.duration = 600.0;
  results.moorings.resize(2);
  results.moorings[0].name = "bow";
  results.moorings[1].name = "stern";
  return results;
}

TEST(non_stationary, is_no_run_in_which_nothing_happens) {
  EXPECT_EQ(non_stationary({}, two_lines()), "");
}

TEST(non_stationary, is_a_run_whose_lines_part_drag_or_render) {
  DynamicResults parted = two_lines(), dragged = two_lines(), rendered = two_lines();
  parted.moorings[1].parted_at = 60.0;
  dragged.moorings[0].anchor_slip = 2.0;
  rendered.moorings[0].brake_rendered = 0.5;
  EXPECT_EQ(non_stationary({}, parted), "mooring line \"stern\" parted at t = 60.0 s");
  EXPECT_EQ(non_stationary({}, dragged), "the anchor of mooring line \"bow\" dragged by 2.00 m");
  EXPECT_EQ(non_stationary({}, rendered), "the brake of mooring line \"bow\" paid out 0.50 m");
}

TEST(non_stationary, is_a_run_in_which_winches_or_the_vessel_move) {
  Description d;
  d.moorings.emplace();
  WinchDescription winch;
  winch.name = "main";
  winch.program = {{-10.0, 0.0}};  // before statistics count
  d.moorings->winches = {winch};
  EXPECT_EQ(non_stationary(d, two_lines()), "");
  d.moorings->winches[0].program.push_back({30.0, 5.0});
  EXPECT_EQ(non_stationary(d, two_lines()), "winch \"main\" follows its program");
  d.moorings.reset();
  d.operation.type = OperationType::pull_ahead;
  EXPECT_EQ(non_stationary(d, two_lines()), "the vessel is pulled ahead");
  d.operation.type = OperationType::none;
  d.vessel.coupled.emplace().release_offset.x() = 5.0;
  EXPECT_EQ(non_stationary(d, two_lines()), "the hull is released from an offset");
}

}  // namespace
}  // namespace overbend
