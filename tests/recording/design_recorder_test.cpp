// Input of the code checks from a time-domain run.
#include "recording/design_recorder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/bgl1_in_time.h"
#include "support/memory_sink.h"

namespace overbend {
namespace {

using testing::EmptySink;
using testing::MemorySink;
using testing::TimedLay;

/// The example, for a shorter time.
Description workable() {
  Description d = testing::workable();
  d.dynamics->duration = 8.0;
  return d;
}

const CheckRow& find_check_row(const CheckTable& table, const std::string& id, CheckRegion region) {
  for (const CheckRow& row : table.rows) {
    if (row.id == id && row.region == region) return row;
  }
  throw std::runtime_error("no row " + id);
}

TEST(design_recorder, a_line_at_rest_has_the_functional_load_effects_and_those_of_the_current) {
  Description d = workable();
  d.environment.waves.front().type = WaveType::none;
  d.vessel.motion = VesselMotion::fixed;
  d.checks.system_effects = false;
  d.dynamics->duration = 4.0;
  const TimedLay apart(d);
  d.checks.current_load = CurrentLoad::functional;
  const TimedLay c(d);
  EmptySink sink;
  const DynamicResults r = c.results(sink), of_current = apart.results(sink);
  double max_value = 0.0;
  for (std::size_t i = 0; i < r.station_s.size(); ++i) {  // what the current adds has 1.3 then, and 1.1 lies between
    EXPECT_GE(of_current.design.load[i], r.design.load[i] * (1.0 - 1e-4)) << i;  // the step's own error, as below
    max_value = std::max(max_value, of_current.design.load[i] / r.design.load[i]);
  }
  EXPECT_GT(max_value, 1.02);
  for (std::size_t i = 0; i < r.station_s.size(); ++i) {
    // A step is solved to 1e-6 of the line's weight of 1.2 MN: what is left shows as environmental part.
    EXPECT_NEAR(r.design.moment[i], 1.1 * r.static_moment[i], 20.0 + 1e-4 * r.static_moment[i]) << i;
    EXPECT_NEAR(r.design.force[i], 1.1 * r.static_tension[i], 50.0) << i;
  }
}

TEST(design_recorder, factored_load_effects_are_never_below_those_that_stood) {
  const TimedLay c(workable());
  EmptySink sink;
  const DynamicResults r = c.results(sink);
  const CheckSection section = make_check_section(c.model.description.pipe.section, c.model.description.checks);
  double above = 0.0;
  for (std::size_t i = 0; i < r.station_s.size(); ++i) {
    // The corners of the factors hold 1 and 1 between them, and the size of a sum is convex: the worst corner is worse.
    const double moment = section.load.moment_factor * r.bending_moment.max[i];
    EXPECT_GE(r.design.load[i], moment * moment * (1.0 - 1e-9)) << i;
    EXPECT_GE(r.design.max_force[i], r.effective_tension.max[i] * (1.0 - 1e-9)) << i;
    EXPECT_GT(r.design.load_time[i], 0.0);
    EXPECT_LE(r.design.load_time[i], r.duration + 1e-9);
    above = std::max(above, r.design.load[i]);
  }
  EXPECT_GT(above, 0.1);
}

TEST(design_recorder, utilisations_follow_from_what_is_kept_next_to_them) {
  const TimedLay c(workable());
  EmptySink sink;
  const DynamicResults r = c.results(sink);
  const CheckSection section = make_check_section(c.model.description.pipe.section, c.model.description.checks);
  int strained = 0;
  for (std::size_t i = 0; i < r.station_s.size(); ++i) {
    const StationDesign& d = r.design;
    const LoadTerms load = load_terms(section.load, d.moment[i], d.force[i], d.load_pressure[i], 0.0, d.share[i]);
    EXPECT_DOUBLE_EQ(load.utilisation(), d.load[i]);
    if (d.strain[i] <= 0.0) continue;
    ++strained;
    EXPECT_DOUBLE_EQ(strain_terms(section.strain, d.design_strain[i], d.strain_pressure[i], 0.0).utilisation(),
                     d.strain[i]);
  }
  EXPECT_GT(strained, 20);
}

TEST(design_recorder, the_table_of_a_run_is_complete_and_in_time) {
  const TimedLay c(workable());
  EmptySink sink;
  const DynamicResults r = c.results(sink);
  const CheckRow& second = find_check_row(r.checks, "dnv_criterion_2", CheckRegion::overbend);
  EXPECT_TRUE(second.judged());
  EXPECT_TRUE(second.in_time);
  EXPECT_DOUBLE_EQ(second.demand, r.overbend.strain.over_time.max);
  EXPECT_DOUBLE_EQ(second.time, r.overbend.strain.time);
  const CheckRow& stress = find_check_row(r.checks, "dnv_equivalent_stress", CheckRegion::sagbend);
  EXPECT_TRUE(stress.in_time);
  EXPECT_GE(stress.utilisation,
            find_check_row(c.statics.checks, "dnv_equivalent_stress", CheckRegion::sagbend).utilisation);
  EXPECT_GT(find_check_row(r.checks, "dnv_load_controlled", CheckRegion::sagbend).utilisation,
            find_check_row(c.statics.checks, "dnv_load_controlled", CheckRegion::sagbend).utilisation);
}

TEST(design_recorder, a_run_taken_up_again_has_the_same_bits) {
  const TimedLay c(workable());
  MemorySink whole, first, second;
  const DynamicResults expected = c.results(whole);
  c.run(first, dynamic_options(c.model), nullptr, [](const DynamicProgress& dynamic_progress) {
    return dynamic_progress.time < 3.0 ? DynamicControl::checkpoint : DynamicControl::stop;
  });
  ASSERT_FALSE(first.checkpoints.empty());
  const DynamicResults resumed = c.run(second, dynamic_options(c.model), &first.checkpoints.back()).results.value();
  EXPECT_EQ(resumed.design.load, expected.design.load);
  EXPECT_EQ(resumed.design.load_time, expected.design.load_time);
  EXPECT_EQ(resumed.design.moment, expected.design.moment);
  EXPECT_EQ(resumed.design.strain, expected.design.strain);
  EXPECT_EQ(resumed.design.von_mises_time, expected.design.von_mises_time);
  EXPECT_EQ(resumed.design.tension_time, expected.design.tension_time);
}

TEST(design_recorder, a_roller_force_counts_where_it_is_asked_for) {
  Description d = workable();
  d.checks.point_load = true;
  EmptySink a, b;
  const DynamicResults with = TimedLay(d).results(a), without = TimedLay(workable()).results(b);
  const auto min_value = [](const DynamicResults& r) {
    return *std::min_element(r.design.share.begin(), r.design.share.end());
  };
  EXPECT_LT(min_value(with), 1.0);
  EXPECT_EQ(min_value(without), 1.0);
}

}  // namespace
}  // namespace overbend
