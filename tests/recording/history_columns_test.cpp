#include "recording/history_columns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "recording/pipe_recorder_layout.h"
#include "support/bgl1_in_time.h"

namespace overbend {
namespace {

using testing::TimedLay;

constexpr double kNothing = std::numeric_limits<double>::infinity();

const TimedLay& example() {
  static const TimedLay c(testing::workable());
  return c;
}

double value(const std::string& name, const RowSource& row) {
  for (const RecordedColumn& recorded : recorded_columns({&example().model.supports})) {
    if (recorded.column.name == name) return recorded.value(row);
  }
  throw std::runtime_error("no column " + name);
}

TEST(history_columns, begin_with_time_and_have_a_name_of_their_own_a_unit_and_a_meaning) {
  std::set<std::string> names;
  const std::vector<RecordedColumn> columns = recorded_columns({&example().model.supports});
  EXPECT_EQ(columns.front().column.name, "time");
  for (const RecordedColumn& recorded : columns) {
    EXPECT_TRUE(names.insert(recorded.column.name).second) << recorded.column.name;
    EXPECT_FALSE(recorded.column.units.empty());
    EXPECT_FALSE(recorded.column.description.empty());
  }
}

TEST(history_columns, a_value_is_that_of_its_name) {
  std::array<double, kKeyQuantities> current{}, max_value{}, min_value{};
  for (std::size_t i = 0; i < kKeyQuantities; ++i) {
    current[i] = static_cast<double>(i);
    max_value[i] = 100.0 + current[i];
    min_value[i] = -100.0 + current[i];
  }
  const std::size_t boxes = example().model.supports.boxes.size();
  std::vector<double> reaction(boxes, 7.0), separation(boxes, kNothing);
  separation.back() = 0.25;
  SystemState state;
  state.time = 12.0;
  AttachmentState tensioner;
  tensioner.machine.tension = 3e5;
  Instant instant;
  instant.state = &state;
  instant.tensioner = &tensioner;
  instant.step = 0.125;
  const RowSource row{instant, current, max_value, min_value, reaction, separation};
  EXPECT_EQ(value("time", row), 12.0);
  EXPECT_EQ(value("step", row), 0.125);
  EXPECT_EQ(value("tensioner/tension", row), 3e5);
  EXPECT_EQ(value("top_tension", row), current[kTopTension]);
  EXPECT_EQ(value("top_tension_peak", row), max_value[kTopTension]);
  EXPECT_EQ(value("top_tension_low", row), min_value[kTopTension]);
  EXPECT_EQ(value("smallest_tension", row), min_value[kMinLineTension]);
  EXPECT_EQ(value("sagbend_bending_stress", row), current[std::size_t{kSagbend} + kBendingStress]);
  EXPECT_EQ(value("overbend_strain_peak", row), max_value[std::size_t{kUpper} + kStrain]);
  const std::vector<SupportBox>& all = example().model.supports.boxes;
  EXPECT_EQ(value("support/" + all.back().name + "/separation", row), 0.25);
  EXPECT_TRUE(std::isnan(value("support/" + all.front().name + "/separation", row)));  // passed by no pipe
  EXPECT_EQ(value("support/" + all.front().name + "/reaction", row), 7.0);
}

TEST(history_columns, without_supports_the_upper_region_is_the_tower) {
  const Supports without;
  const std::vector<RecordedColumn> columns = recorded_columns({&without});
  const auto named = [&](const std::string& name) {
    return std::any_of(columns.begin(), columns.end(), [&](const RecordedColumn& c) { return c.column.name == name; });
  };
  EXPECT_TRUE(named("tower_von_mises"));
  EXPECT_FALSE(named("overbend_von_mises"));
}

}  // namespace
}  // namespace overbend
