// Stress cycles of welds, counted as they come.
#include "recording/fatigue_recorder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "checks/check_rows.h"
#include "recording/fatigue_findings.h"
#include "support/allocation_count.h"
#include "support/bgl1_in_time.h"
#include "support/formula_value.h"
#include "support/memory_sink.h"

namespace overbend {
namespace {

using testing::EmptySink;
using testing::MemorySink;
using testing::TimedLay;

/// Two stations of a level pipe along x, 20 m below the water, under loads that a test gives.
class TwoStations {
 public:
  explicit TwoStations(const FatigueDescription& fatigue) : TwoStations(described(fatigue)) {}
  explicit TwoStations(const Description& description)
      : model_(build_model(description)), recorder_(model_, {0, 0}, 0) {
    nodes_.resize(2);
    for (const std::size_t station : {0, 1}) tangents_.set(station, Vec3::UnitX());
    std::fill(nodes_.z.begin(), nodes_.z.end(), -20.0);
    std::fill(nodes_.external_pressure.begin(), nodes_.external_pressure.end(), 2e5);
  }

  static Description described(const FatigueDescription& fatigue) {
    Description d = read_model(OVERBEND_SOURCE_DIR "/examples/bgl1.yaml").description.value();
    d.fatigue = fatigue;
    return d;
  }

  const Model& model() const { return model_; }
  const Section& section() const { return model_.sections[0]; }
  FatigueRecorder& recorder() { return recorder_; }

  /// `tension(t)`, and `moment(t)` as a vector towards the centre of the curve, at station 0.
  template <class Tension, class Moment>
  void wave(double from, double to, Tension tension, Moment moment) {
    for (double time = from; time < to - 1e-9; time += 0.01) {
      nodes_.effective_tension[0] = tension(time);
      moments_.set(0, moment(time));
      nodes_.curvature[0] = moments_[0].norm() / section().EI;
      if (time == 0.0) recorder_.start(at(time));
      recorder_.step(at(time + 0.01));
    }
  }
  DynamicResults results() const {
    DynamicResults r;
    r.duration = 100.0;
    r.station_s = {0.0, 100.0};
    r.static_place = {Vec3(0.0, 0.0, -20.0), Vec3(100.0, 0.0, -20.0)};
    r.von_mises.max = {0.0, 0.0};
    recorder_.fill(r);
    return r;
  }

 private:
  DesignInstant at(double time) const { return {nodes_, moments_, tangents_, node_indices_, contacts_, time}; }

  Model model_;
  FatigueRecorder recorder_;
  NodeValues nodes_;
  VectorColumns moments_{2}, tangents_{2};
  std::vector<int> node_indices_ = {0, 1};
  std::vector<RollerContact> contacts_;
};

FatigueDescription standard() {
  FatigueDescription fatigue;
  fatigue.weld_time = 300.0;
  fatigue.move_time = 60.0;
  return fatigue;
}

double swing(double time) {
  return std::sin(2.0 * std::numbers::pi * time / 5.0);
}

/// Twenty waves of 5 s: a quarter and nineteen cycles and a half, three quarters at the ends.
constexpr double kCycles = 19.5;

TEST(fatigue_recorder, stress_ranges_are_those_of_axial_force_and_bending_at_the_fibre) {
  TwoStations line(standard());
  constexpr double kTension = 200e3, kMoment = 60e3;  // amplitudes
  line.wave(
      0.0, 100.0, [](double t) { return kTension * (2.0 + swing(t)); },
      [](double t) { return Vec3(0.0, 0.0, -kMoment * swing(t)); });
  const DynamicResults r = line.results();
  const Section& s = line.section();
  const double radius[] = {0.5 * s.steel_diameter, 0.5 * s.steel_diameter - s.wall_thickness};
  const SnCurve curves[] = {sn_curve(FatigueCurve::d, FatigueMedium::seawater_protected),
                            sn_curve(FatigueCurve::f1, FatigueMedium::air)};
  for (std::size_t i = 0; i < 2; ++i) {
    const FatigueSpot& spot = r.fatigue->spots[i];
    const double range = 2.0 * (kTension / s.steel_area + kMoment * radius[i] / s.second_moment);
    EXPECT_NEAR(spot.rate[0] / (curves[i].damage(range) * kCycles / 100.0), 1.0, 0.02) << i;  // the ends
    EXPECT_NEAR(spot.range[0] / range, 1.0, 0.02) << i;  // the half cycles at the ends have half of it
    EXPECT_NEAR(spot.cycles[0], 0.2, 0.006) << i;
    EXPECT_EQ(spot.rate[1], 0.0) << i;
    EXPECT_EQ(spot.worst_s, 0.0) << i;
  }
}

/// Under a load that leaves one range, in the edition that has another slope for curve C.
TEST(fatigue_recorder, the_sheet_of_the_check_gives_damage_rate_and_utilisation_by_the_edition_asked_for) {
  FatigueDescription fatigue = standard();
  fatigue.spots = {{"cap", false, FatigueCurve::c, {}, 1.2}};
  double rates[2] = {};
  for (const FatigueEdition edition : {FatigueEdition::year_2016, FatigueEdition::year_2024}) {
    fatigue.edition = edition;
    TwoStations line(fatigue);
    line.wave(
        0.0, 100.0, [](double t) { return 1500e3 * (2.0 + swing(t)); }, [](double) { return Vec3(0.0, 0.0, 0.0); });
    const DynamicResults r = line.results();
    const CheckRow row = fatigue_rows(line.model(), r).at(0);
    std::map<std::string, double> values;
    for (const SheetLine& entry : row.sheet) {
      const double value = entry.formula.empty() ? entry.value : testing::formula_value(entry.formula, values);
      EXPECT_NEAR(value, entry.value, 1e-9 * entry.value) << entry.symbol;
      values[entry.symbol] = value;
    }
    EXPECT_NEAR(values.at("D_d"), r.fatigue->spots[0].worst_rate, 1e-9 * values.at("D_d"));
    EXPECT_NEAR(values.at("U"), row.utilisation, 1e-9 * row.utilisation);
    const bool renewed = edition == FatigueEdition::year_2024;
    EXPECT_EQ(values.at("m"), renewed ? 3.5 : 3.0);
    EXPECT_EQ(row.code, renewed ? "DNV-RP-C203 (2024)" : "DNV-RP-C203 (2016)");
    rates[renewed ? 1 : 0] = values.at("D_d");
  }
  // 2 x 1500 kN over 138 cm2 times 1.2 is a range of 261 MPa: the lines cross at 301 MPa in protected seawater
  EXPECT_GT(rates[0], rates[1]);
  EXPECT_LT(rates[0], 1.2 * rates[1]);
}

/// One of eight points is never farther from the plane of bending than 22.5 degrees: 7.6 % of the range at most.
TEST(fatigue_recorder, bending_in_any_plane_meets_a_point_of_the_section) {
  double min_value = 1e300, max_value = 0.0;
  for (int degrees = 0; degrees < 180; degrees += 15) {
    const double angle = degrees * std::numbers::pi / 180.0;
    TwoStations line(standard());
    line.wave(
        0.0, 100.0, [](double) { return 300e3; },
        [&](double t) { return Vec3(0.0, 50e3 * swing(t) * std::cos(angle), 50e3 * swing(t) * std::sin(angle)); });
    const double range = line.results().fatigue->spots[0].range[0];
    min_value = std::min(min_value, range);
    max_value = std::max(max_value, range);
    if (degrees % 45 == 0) {
      EXPECT_NEAR(range, 100e3 * 0.5 * line.section().steel_diameter / line.section().second_moment, 0.01 * range);
    }
  }
  EXPECT_GT(min_value / max_value, std::cos(22.5 * std::numbers::pi / 180.0));
}

/// A moment that turns without growing bends every fibre back and forth.
TEST(fatigue_recorder, a_moment_that_turns_round_the_pipe_is_a_cycle_at_every_point) {
  TwoStations line(standard());
  line.wave(
      0.0, 100.0, [](double) { return 300e3; },
      [](double t) {
        const double angle = 2.0 * std::numbers::pi * t / 5.0;
        return Vec3(0.0, 50e3 * std::cos(angle), 50e3 * std::sin(angle));
      });
  const Section& s = line.section();
  const FatigueSpot spot = line.results().fatigue->spots[0];
  EXPECT_NEAR(spot.range[0] / (2.0 * 50e3 * 0.5 * s.steel_diameter / s.second_moment), 1.0, 0.02);
  EXPECT_NEAR(spot.cycles[0], 0.2, 0.006);
}

TEST(fatigue_recorder, misaligned_walls_count_by_their_stress_factor) {
  FatigueDescription fatigue = standard();
  fatigue.spots = {{"cap", false, FatigueCurve::e, FatigueMedium::seawater_free, {}},
                   {"factored", false, FatigueCurve::e, FatigueMedium::seawater_free, 2.0}};
  fatigue.hi_lo = 1.5e-3;
  TwoStations line(fatigue);
  line.wave(
      0.0, 100.0, [](double t) { return 300e3 * (2.0 + swing(t)); }, [](double) { return Vec3(Vec3::Zero()); });
  const std::vector<FatigueSpot> spots = line.results().fatigue->spots;
  const double factor = hi_lo_factor(1.5e-3, line.section().steel_diameter, line.section().wall_thickness);
  EXPECT_DOUBLE_EQ(spots[0].stress_factor, factor);
  EXPECT_NEAR(spots[1].rate[0] / spots[0].rate[0], std::pow(2.0 / factor, 3), 1e-9);  // one slope of 3
  EXPECT_NEAR(spots[1].range[0], spots[0].range[0], 1e-6 * spots[0].range[0]);
}

TEST(fatigue_recorder, counting_allocates_nothing_and_goes_on_from_what_was_saved) {
  const auto tension = [](double t) { return 300e3 * (2.0 + swing(t) + 0.3 * swing(2.7 * t)); };
  const auto moment = [](double t) { return Vec3(0.0, 30e3 * swing(1.3 * t), 20e3 * swing(0.7 * t)); };
  TwoStations whole(standard()), first(standard()), second(standard());
  whole.wave(0.0, 40.0, tension, moment);
  first.wave(0.0, 17.0, tension, moment);
  second.wave(0.0, 0.01, tension, moment);  // its start
  second.recorder().restore(first.recorder().save());
  const long before = testing::allocation_count();
  second.wave(17.0, 40.0, tension, moment);
  EXPECT_EQ(testing::allocation_count(), before);
  const DynamicResults a = whole.results(), b = second.results();
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(a.fatigue->spots[i].rate[0], b.fatigue->spots[i].rate[0], 1e-12 * a.fatigue->spots[i].rate[0]);
    EXPECT_GT(a.fatigue->spots[i].rate[0], 0.0);
  }
  EXPECT_THROW(second.recorder().restore(std::vector<double>(3)), std::runtime_error);
}

TEST(fatigue_recorder, standby_is_what_the_weld_at_the_worst_station_has_left) {
  FatigueDescription fatigue = standard();
  fatigue.joint = 10.0;
  fatigue.budget = 0.2;
  fatigue.design_factor = 4.0;
  TwoStations line(fatigue);
  line.wave(
      0.0, 100.0, [](double t) { return 900e3 * (2.0 + swing(t)); }, [](double) { return Vec3(Vec3::Zero()); });
  const DynamicResults r = line.results();
  EXPECT_DOUBLE_EQ(r.fatigue->lay_rate, 10.0 / 360.0);
  for (const FatigueSpot& spot : r.fatigue->spots) {
    const double rate = spot.rate[0];  // falls evenly over the 100 m to the tensioner, where it is 0
    const double stops = 300.0 * rate * (1.0 + 0.9 + 0.8 + 0.7 + 0.6 + 0.5 + 0.4 + 0.3 + 0.2 + 0.1);
    EXPECT_NEAR(spot.path_damage, stops + 60.0 / 10.0 * 50.0 * rate, 1e-9 * stops);
    EXPECT_NEAR(spot.standby, (0.2 / 4.0 - spot.path_damage) / rate, 1e-6 * spot.standby);
  }
}

TEST(fatigue_recorder, a_line_that_nothing_moves_may_wait_a_hundred_years) {
  TwoStations line(standard());
  line.wave(
      0.0, 10.0, [](double) { return 300e3; }, [](double) { return Vec3(0.0, 0.0, 50e3); });
  const DynamicResults results = line.results();
  for (const FatigueSpot& spot : results.fatigue->spots) {
    EXPECT_EQ(spot.worst_rate, 0.0);
    EXPECT_EQ(spot.path_damage, 0.0);
    EXPECT_EQ(spot.standby, kMaxStandby);
  }
}

TEST(fatigue_recorder, warns_of_few_cycles_and_of_a_standby_shorter_than_a_joint) {
  FatigueDescription fatigue = standard();
  fatigue.budget = 1e-9;
  TwoStations line(fatigue);
  line.wave(
      0.0, 100.0, [](double t) { return 900e3 * (2.0 + swing(t)); }, [](double) { return Vec3(Vec3::Zero()); });
  const std::vector<std::string> warnings = messages(line.results().findings);
  const auto says = [&](const char* arguments) {
    return std::any_of(warnings.begin(), warnings.end(),
                       [&](const std::string& warning) { return warning.find(arguments) != std::string::npos; });
  };
  EXPECT_TRUE(says("on 20 stress cycles"));
  EXPECT_TRUE(says("of standby, less than the 360 s of one joint"));
}

Description in_a_sea() {
  Description d = testing::workable();
  d.dynamics->duration = 6.0;
  d.fatigue = standard();
  return d;
}

/// The pipe on the bed far behind touchdown and the run itself feel nothing of the counting.
TEST(fatigue_recorder, a_run_that_counts_is_the_run_that_does_not) {
  Description plain = in_a_sea();
  plain.fatigue.reset();
  EmptySink a, b;
  const DynamicResults with = TimedLay(in_a_sea()).results(a), without = TimedLay(plain).results(b);
  EXPECT_EQ(with.von_mises.max, without.von_mises.max);
  EXPECT_EQ(with.run.steps, without.run.steps);
  EXPECT_FALSE(without.fatigue);
  ASSERT_TRUE(with.fatigue);
  for (const FatigueSpot& spot : with.fatigue->spots) {
    ASSERT_EQ(spot.rate.size(), with.station_s.size());
    EXPECT_GT(spot.worst_rate, 0.0);
    EXPECT_LT(spot.rate.front(), 0.01 * spot.worst_rate);
  }
}

/// No cycle is larger than what the envelopes of tension and moment allow, and the largest is not far from it.
TEST(fatigue_recorder, equivalent_ranges_lie_within_the_envelopes) {
  const TimedLay c(in_a_sea());
  EmptySink sink;
  const DynamicResults r = c.results(sink);
  const Section& s = c.model.sections[0];
  double closest = 0.0;
  for (std::size_t i = 0; i < r.station_s.size(); ++i) {
    const double bending = 2.0 * r.bending_moment.max[i] * 0.5 * s.steel_diameter / s.second_moment;
    const double axial = (r.effective_tension.max[i] - r.effective_tension.min[i] + 30e3) / s.steel_area;  // pressure
    const double range = r.fatigue->spots[0].range[i];
    EXPECT_LE(range, bending + axial) << i;
    if (bending > 50e6) closest = std::max(closest, range / (bending + axial));
  }
  EXPECT_GT(closest, 0.02);
}

TEST(fatigue_recorder, a_run_taken_up_again_has_the_same_bits) {
  const TimedLay c(in_a_sea());
  MemorySink whole, first, second;
  const DynamicResults expected = c.results(whole);
  c.run(first, dynamic_options(c.model), nullptr, [](const DynamicProgress& dynamic_progress) {
    return dynamic_progress.time < 3.0 ? DynamicControl::checkpoint : DynamicControl::stop;
  });
  ASSERT_FALSE(first.checkpoints.empty());
  const DynamicResults resumed = c.run(second, dynamic_options(c.model), &first.checkpoints.back()).results.value();
  for (std::size_t i = 0; i < expected.fatigue->spots.size(); ++i) {
    EXPECT_EQ(resumed.fatigue->spots[i].rate, expected.fatigue->spots[i].rate);
    EXPECT_EQ(resumed.fatigue->spots[i].cycles, expected.fatigue->spots[i].cycles);
    EXPECT_EQ(resumed.fatigue->spots[i].standby, expected.fatigue->spots[i].standby);
  }
}

TEST(fatigue_recorder, the_table_of_checks_holds_the_damage_of_the_worst_spot_against_the_budget) {
  Description d = in_a_sea();
  d.fatigue->design_factor = 3.0;
  EmptySink sink;
  const DynamicResults r = TimedLay(d).results(sink);
  const auto row = std::find_if(r.checks.rows.begin(), r.checks.rows.end(),
                                [](const CheckRow& check) { return check.id == "fatigue"; });
  ASSERT_NE(row, r.checks.rows.end());
  const double worst = std::max(r.fatigue->spots[0].path_damage, r.fatigue->spots[1].path_damage);
  EXPECT_DOUBLE_EQ(row->utilisation, 3.0 * worst / 0.1);
  EXPECT_TRUE(row->judged());
}

}  // namespace
}  // namespace overbend
