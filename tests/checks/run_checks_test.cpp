// The table of checks of solved models.
#include "checks/run_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "checks/dnv_combined.h"
#include "checks/dnv_strength.h"
#include "checks/steel_grades.h"
#include "modelfile/reading/yaml_reader.h"
#include "statics/solver/statics.h"
#include "study/run/static_analysis.h"

namespace overbend {
namespace {

/// The example solved once; the settings of its checks may differ.
struct Solved {
  Description description;
  StaticResults statics;
};

const Solved& bgl1() {
  static const Solved kSolved = [] {
    const Description d = read_model(OVERBEND_SOURCE_DIR "/examples/bgl1.yaml").description.value();
    Model model = build_model(d);
    return Solved{d, checked_statics(model, solve_lay(model))};
  }();
  return kSolved;
}

CheckTable checks_with(const std::function<void(Description&)>& change) {
  Description d = bgl1().description;
  change(d);
  return check_statics(build_model(d), bgl1().statics);
}

const CheckRow* find(const CheckTable& table, const std::string& id, CheckRegion region) {
  for (const CheckRow& row : table.rows) {
    if (row.id == id && row.region == region) return &row;
  }
  return nullptr;
}

const CheckRow& find_check_row(const CheckTable& table, const std::string& id, CheckRegion region) {
  const CheckRow* row = find(table, id, region);
  if (row == nullptr) throw std::runtime_error("no row " + id);
  return *row;
}

double input(const CheckRow& row, const std::string& symbol) {
  for (const CheckInput& i : row.inputs) {
    if (i.symbol == symbol) return i.value;
  }
  throw std::runtime_error("no input " + symbol);
}

bool any_contains(const std::vector<std::string>& all, const std::string& text) {
  return std::any_of(all.begin(), all.end(), [&](const std::string& s) { return s.find(text) != std::string::npos; });
}

TEST(run_checks, the_example_has_a_complete_table_without_settings) {
  const CheckTable& table = bgl1().statics.checks;
  for (const char* id :
       {"dnv_collapse", "dnv_propagation", "api_collapse", "api_propagation", "api_tension", "api_combined_load"}) {
    ASSERT_NE(find(table, id, CheckRegion::line), nullptr) << id;
    EXPECT_TRUE(find_check_row(table, id, CheckRegion::line).judged()) << id;
  }
  for (const char* id : {"dnv_displacement_controlled", "dnv_criterion_1"}) {
    EXPECT_TRUE(find_check_row(table, id, CheckRegion::overbend).judged()) << id;
  }
  for (const CheckRegion region : {CheckRegion::tip, CheckRegion::sagbend, CheckRegion::seabed}) {
    for (const char* id : {"dnv_load_controlled", "dnv_equivalent_stress", "api_bending_pressure"}) {
      EXPECT_TRUE(find_check_row(table, id, region).judged()) << id;
    }
  }
  EXPECT_EQ(find_check_row(table, "dnv_criterion_2", CheckRegion::overbend).status, CheckStatus::not_done);
  for (const CheckRow& row : table.rows) {
    EXPECT_TRUE(std::isfinite(row.utilisation) && std::isfinite(row.reserve)) << row.id;
    EXPECT_FALSE(row.code.empty()) << row.id;
  }
}

TEST(run_checks, load_over_the_supports_is_reported_but_does_not_decide) {
  const CheckTable& table = bgl1().statics.checks;
  EXPECT_FALSE(find_check_row(table, "dnv_load_controlled", CheckRegion::overbend).governing);
  EXPECT_TRUE(find_check_row(table, "dnv_load_controlled", CheckRegion::sagbend).governing);
  EXPECT_TRUE(find_check_row(table, "dnv_displacement_controlled", CheckRegion::overbend).governing);
  EXPECT_FALSE(find_check_row(table, "dnv_propagation", CheckRegion::line).governing);
}

/// Only combination b, and the current as a part of the functional load effects.
CheckTable plain_combination() {
  return checks_with([](Description& d) {
    d.checks.system_effects = false;
    d.checks.current_load = CurrentLoad::functional;
  });
}

TEST(run_checks, static_load_effects_carry_the_functional_factor) {
  const CheckTable table = plain_combination();
  const CheckRow& row = find_check_row(table, "dnv_load_controlled", CheckRegion::sagbend);
  EXPECT_NEAR(input(row, "M_Sd"), 1.1 * input(row, "M_F"), 1e-9 * input(row, "M_F"));
  EXPECT_NEAR(input(row, "S_Sd"), 1.1 * input(row, "S_F"), 1e-9 * input(row, "S_F"));
  EXPECT_NEAR(input(row, "gamma_m gamma_SC"), 1.15 * 1.04, 1e-12);
}

TEST(run_checks, what_the_current_adds_counts_as_environmental_and_is_never_less_than_as_functional) {
  const CheckTable functional = plain_combination();
  const CheckTable apart = checks_with([](Description& d) { d.checks.system_effects = false; });
  double max_value = 0.0;
  for (std::size_t i = 0; i < apart.along.load.size(); ++i) {
    EXPECT_GE(apart.along.load[i], functional.along.load[i] * (1.0 - 1e-12));
    max_value = std::max(max_value, apart.along.load[i] / functional.along.load[i]);
  }
  EXPECT_GT(max_value, 1.02);  // the example's current blows across
  EXPECT_TRUE(
      any_contains(texts(apart.assumptions), "the contribution of the steady current as environmental (factor 1.3)"));
  EXPECT_TRUE(any_contains(texts(functional.assumptions), "with its current"));
}

TEST(run_checks, a_still_lay_without_its_current_is_the_functional_part) {
  Description d = bgl1().description;
  d.environment.current.clear();
  Model model = build_model(d);
  const StaticResults at_rest = checked_statics(model, solve_lay(model));
  for (const Station& station : at_rest.stations) EXPECT_EQ(station.current_vertical_moment, 0.0);
  const Station& with = bgl1().statics.stations.front();  // laid on the bed, far from everything
  EXPECT_NEAR(with.effective_tension - with.current_tension, at_rest.stations.front().effective_tension, 5.0);
}

TEST(run_checks, a_short_run_says_from_how_many_minutes_its_values_are) {
  DynamicResults run;
  run.duration = 300.0;
  const Station& station = bgl1().statics.stations.back();
  run.station_s = {station.s};
  run.static_place = {station.p_W};
  for (std::vector<double>* list : {&run.static_moment,         &run.static_tension,
                                    &run.static_strain,         &run.static_von_mises,
                                    &run.von_mises.max,         &run.strain.max,
                                    &run.effective_tension.max, &run.design.load,
                                    &run.design.load_time,      &run.design.moment,
                                    &run.design.force,          &run.design.load_pressure,
                                    &run.design.share,          &run.design.max_force,
                                    &run.design.strain,         &run.design.strain_time,
                                    &run.design.design_strain,  &run.design.strain_pressure,
                                    &run.design.von_mises_time, &run.design.fibre_strain_time,
                                    &run.design.tension_time}) {
    list->assign(1, 0.1);
  }
  const Model model = build_model(bgl1().description);
  const CheckTable five = check_dynamics(model, bgl1().statics, run);
  const CheckRow& row = find_check_row(five, "dnv_displacement_controlled", CheckRegion::overbend);
  EXPECT_NE(row.remark.find("from 5 min of a run"), std::string::npos) << row.remark;
  EXPECT_EQ(find_check_row(five, "dnv_collapse", CheckRegion::line).remark.find("min of a run"), std::string::npos);
  run.duration = 10800.0;
  const CheckTable long_run = check_dynamics(model, bgl1().statics, run);
  EXPECT_EQ(find_check_row(long_run, "dnv_displacement_controlled", CheckRegion::overbend).remark, "");
}

TEST(run_checks, the_table_agrees_with_a_calculation_by_hand_at_the_worst_station_of_the_sagbend) {
  const CheckTable table = plain_combination();
  const CheckRow& row = find_check_row(table, "dnv_load_controlled", CheckRegion::sagbend);
  const Station* worst = nullptr;
  for (const Station& station : bgl1().statics.stations) {
    if (station.s == row.s) worst = &station;
  }
  ASSERT_NE(worst, nullptr);
  const Wall wall{0.4064, 0.011125, 207e9, 0.3};
  const double fy = 0.96 * 414e6, fu = 0.96 * 517e6, factor = 1.15 * 1.04;
  const double plastic = fy * std::pow(0.4064 - 0.011125, 2) * 0.011125;
  const double axial = fy * M_PI * (0.4064 - 0.011125) * 0.011125;
  const double beta = (60.0 - wall.slenderness()) / 90.0, alpha_c = 1.0 - beta + beta * fu / fy;
  const double m = factor * 1.1 * worst->bending_moment / (alpha_c * plastic);
  const double s = factor * 1.1 * worst->effective_tension / (alpha_c * axial);
  const double p = factor * 10050.0 * -worst->p_W.z() / collapse_pressure(wall, fy, 0.85, 0.005);
  EXPECT_NEAR(row.utilisation, std::pow(m + s * s, 2) + p * p, 1e-9);
  const double reserve = row.reserve;
  EXPECT_NEAR(std::pow(reserve * m + std::pow(reserve * s, 2), 2) + p * p, 1.0, 1e-9);
}

TEST(run_checks, every_region_reports_the_station_that_is_used_most) {
  const CheckTable& table = bgl1().statics.checks;
  ASSERT_EQ(table.along.s.size(), bgl1().statics.stations.size());
  double max_magnitude = 0.0;
  for (const double value : table.along.strain) max_magnitude = std::max(max_magnitude, value);
  EXPECT_DOUBLE_EQ(find_check_row(table, "dnv_displacement_controlled", CheckRegion::overbend).utilisation,
                   max_magnitude);
  double load = 0.0;
  for (std::size_t i = 0; i < table.along.s.size(); ++i) {
    if (bgl1().statics.stations[i].region == Region::seabed) load = std::max(load, table.along.load[i]);
  }
  EXPECT_DOUBLE_EQ(find_check_row(table, "dnv_load_controlled", CheckRegion::seabed).utilisation, load);
}

TEST(run_checks, a_missing_tensile_strength_is_taken_from_the_grade_and_said) {
  EXPECT_TRUE(any_contains(texts(bgl1().statics.assumptions), "517 MPa of API 5L X60"));
  const CheckTable unknown = checks_with([](Description& d) { d.pipe.section.steel.yield_stress = 430e6; });
  const CheckRow& row = find_check_row(unknown, "dnv_load_controlled", CheckRegion::sagbend);
  EXPECT_EQ(row.status, CheckStatus::not_done);
  EXPECT_EQ(row.remark, "tensile strength not given");
  EXPECT_EQ(find_check_row(unknown, "api_combined_load", CheckRegion::line).status, CheckStatus::not_done);
  EXPECT_TRUE(find_check_row(unknown, "dnv_collapse", CheckRegion::line).judged());  // needs none
  EXPECT_TRUE(any_contains(texts(unknown.assumptions), "no grade of API 5L"));
}

TEST(run_checks, between_grades_the_lower_row_of_the_laying_criteria_is_taken_with_a_message) {
  const CheckTable table = checks_with([](Description& d) { d.pipe.section.steel.yield_stress = 430e6; });
  const CheckRow& row = find_check_row(table, "dnv_criterion_1", CheckRegion::overbend);
  EXPECT_DOUBLE_EQ(row.capacity, 0.0023);
  EXPECT_NE(row.remark.find("nearest lower grade"), std::string::npos);
  EXPECT_DOUBLE_EQ(find_check_row(bgl1().statics.checks, "dnv_criterion_1", CheckRegion::overbend).capacity, 0.0023);
  const CheckTable named = checks_with([](Description& d) { d.checks.grade = "X52"; });
  EXPECT_DOUBLE_EQ(find_check_row(named, "dnv_criterion_1", CheckRegion::overbend).capacity, 0.00205);
}

TEST(run_checks, what_lies_outside_a_formula_is_neither_passed_nor_failed) {
  const CheckTable thick = checks_with([](Description& d) { d.pipe.section.steel.wall_thickness = 0.03; });  // D/t 13.5
  for (const CheckRegion region : {CheckRegion::overbend, CheckRegion::sagbend}) {
    const CheckRow& row = find_check_row(thick, "dnv_load_controlled", region);
    EXPECT_EQ(row.status, CheckStatus::outside_validity);
    EXPECT_NE(row.remark.find("15"), std::string::npos);
  }
  const CheckTable thin = checks_with([](Description& d) { d.pipe.section.steel.wall_thickness = 0.0075; });  // 54
  EXPECT_EQ(find_check_row(thin, "dnv_displacement_controlled", CheckRegion::overbend).status,
            CheckStatus::outside_validity);
  EXPECT_EQ(find_check_row(thin, "dnv_propagation", CheckRegion::line).status, CheckStatus::outside_validity);
  EXPECT_EQ(find_check_row(thin, "api_bending_pressure", CheckRegion::sagbend).status, CheckStatus::outside_validity);
  const CheckTable weak = checks_with([](Description& d) { d.pipe.section.steel.yield_stress = 290e6; });
  EXPECT_EQ(find_check_row(weak, "dnv_criterion_1", CheckRegion::overbend).status, CheckStatus::outside_validity);
  const CheckRow* worst = find_governing_check(thick);
  ASSERT_NE(worst, nullptr);
  EXPECT_NE(worst->status, CheckStatus::outside_validity);
}

TEST(run_checks, what_no_formula_judged_is_reported_once_for_all_regions) {
  EXPECT_TRUE(find_invalid_checks(bgl1().statics.checks).empty());
  const CheckTable thick = checks_with([](Description& d) { d.pipe.section.steel.wall_thickness = 0.03; });  // D/t 13.5
  const Findings findings = find_invalid_checks(thick);
  ASSERT_EQ(findings.size(), 1U);  // propagation is for information
  EXPECT_EQ(findings.front().code, FindingCode::check_not_judged);
  EXPECT_NE(findings.front().message.find("Local buckling, load controlled"), std::string::npos);
  EXPECT_NE(findings.front().message.find("valid for 15 <= D/t2 <= 45"), std::string::npos);
}

TEST(run_checks, no_utilisation_is_drawn_along_the_pipe_of_a_formula_that_does_not_hold) {
  const CheckAlong thick =
      checks_with([](Description& d) { d.pipe.section.steel.wall_thickness = 0.03; }).along;  // D/t 13.5
  EXPECT_EQ(*std::ranges::max_element(thick.load), 0.0);
  EXPECT_GT(*std::ranges::max_element(thick.api), 0.0);
  const CheckAlong thin = checks_with([](Description& d) { d.pipe.section.steel.wall_thickness = 0.0079; }).along;
  EXPECT_EQ(*std::ranges::max_element(thin.api), 0.0);  // D/t 51
  EXPECT_GT(*std::ranges::max_element(bgl1().statics.checks.along.load), 0.0);
}

TEST(run_checks, limits_of_the_project_that_find_nothing_to_be_held_against_are_reported) {
  Description d = read_model(OVERBEND_SOURCE_DIR "/examples/bgl1.yaml").description.value();
  d.checks.limits.roller_load = 300e3;
  d.checks.limits.coating_line_load = 2e6;
  d.checks.limits.tip_clearance = 0.1;
  const Model model = build_model(d);
  StaticResults lay = bgl1().statics;
  lay.supports.clear();
  lay.stinger_tip_clearance.reset();
  const CheckTable table = check_statics(model, lay);
  for (const char* id : {"roller_load", "coating_line_load", "tip_clearance"}) {
    const CheckRow& row = find_check_row(table, id, CheckRegion::line);
    EXPECT_EQ(row.status, CheckStatus::not_done) << id;
    EXPECT_NE(row.remark.find("no rollers"), std::string::npos) << id;
  }
}

/// The first 30 m from the tensioner, all over the ramp, of other steel.
CheckTable with_segment(const std::function<void(SteelDescription&)>& change) {
  return checks_with([&](Description& d) {
    d.pipe.segments = {{"segment", 30.0, d.pipe.section}};
    change(d.pipe.segments.front().section.steel);
  });
}

TEST(run_checks, a_segment_that_a_formula_does_not_hold_for_takes_its_region_out_of_validity) {
  const CheckTable table = with_segment([](SteelDescription& steel) { steel.wall_thickness = 0.0075; });  // D/t 54
  for (const char* id : {"dnv_displacement_controlled", "dnv_load_controlled", "api_bending_pressure"}) {
    EXPECT_EQ(find_check_row(table, id, CheckRegion::overbend).status, CheckStatus::outside_validity) << id;
  }
  EXPECT_EQ(find_check_row(table, "dnv_propagation", CheckRegion::line).status, CheckStatus::outside_validity);
  for (const char* id : {"dnv_load_controlled", "api_bending_pressure"}) {
    EXPECT_TRUE(find_check_row(table, id, CheckRegion::sagbend).judged()) << id;
  }
}

TEST(run_checks, a_segment_without_tensile_strength_leaves_its_region_unchecked_and_the_row_says_why) {
  const CheckTable table = with_segment([](SteelDescription& steel) { steel.yield_stress = 430e6; });
  const CheckRow& row = find_check_row(table, "dnv_load_controlled", CheckRegion::overbend);
  EXPECT_EQ(row.status, CheckStatus::not_done);
  EXPECT_EQ(row.remark, "tensile strength not given");
  EXPECT_TRUE(find_check_row(table, "dnv_load_controlled", CheckRegion::sagbend).judged());
}

/// A station lies in one of the two elements that meet at its node: its stress and the limit are of the same steel.
TEST(run_checks, where_two_steels_meet_a_station_is_held_against_the_limit_of_its_own) {
  Description d = bgl1().description;
  for (int i = 0; i < 6; ++i) {
    SegmentDescription& segment = d.pipe.segments.emplace_back();
    segment.length = 9.0 + i;
    segment.section = d.pipe.section;
    segment.section.steel.yield_stress = i % 2 == 0 ? 483e6 : 358e6;
  }
  Model model = build_model(d);
  const StaticResults statics = checked_statics(model, solve_lay(model));
  const CheckAlong& along = statics.checks.along;
  ASSERT_EQ(along.s.size(), statics.stations.size());
  std::size_t judged = 0;
  for (std::size_t i = 0; i < along.s.size(); ++i) {
    if (along.laying[i] <= 0.0) continue;
    ++judged;
    const double limit = laying_limits(statics.stations[i].yield_stress).value().static_strain;
    EXPECT_NEAR(statics.stations[i].strain / along.laying[i], limit, 1e-9) << statics.total_length - along.s[i];
  }
  EXPECT_GT(judged, 50U);
}

TEST(run_checks, a_large_effective_force_is_outside_validity) {
  StaticResults pulled = bgl1().statics;
  for (Station& station : pulled.stations) station.effective_tension = 2.5e6;  // 0.4 S_p is 2.2 MN
  const CheckTable table = check_statics(build_model(bgl1().description), pulled);
  const CheckRow& row = find_check_row(table, "dnv_load_controlled", CheckRegion::sagbend);
  EXPECT_EQ(row.status, CheckStatus::outside_validity);
  EXPECT_NE(row.remark.find("0.4 S_p"), std::string::npos);
}

TEST(run_checks, settings_reach_the_checks) {
  const double plain = find_check_row(bgl1().statics.checks, "dnv_load_controlled", CheckRegion::sagbend).utilisation;
  const auto load = [](const std::function<void(CheckSettings&)>& change) {
    const CheckTable table = checks_with([&](Description& d) { change(d.checks); });
    return find_check_row(table, "dnv_load_controlled", CheckRegion::sagbend).utilisation;
  };
  EXPECT_GT(load([](CheckSettings& s) { s.safety_class = SafetyClass::high; }), plain);
  EXPECT_LT(load([](CheckSettings& s) { s.alpha_u = 1.0; }), plain);
  EXPECT_LT(load([](CheckSettings& s) { s.manufacture = Manufacture::seamless; }), plain);
  EXPECT_LT(load([](CheckSettings& s) { s.system_effects = false; }), plain);
  EXPECT_LT(load([](CheckSettings& s) { s.condition_factor = 0.82; }), plain);
  const auto collapse = [](const std::function<void(CheckSettings&)>& change) {
    const CheckTable table = checks_with([&](Description& d) { change(d.checks); });
    return find_check_row(table, "dnv_collapse", CheckRegion::line).utilisation;
  };
  const double round = find_check_row(bgl1().statics.checks, "dnv_collapse", CheckRegion::line).utilisation;
  EXPECT_GT(collapse([](CheckSettings& s) { s.wall_tolerance = 0.001; }), round);
  EXPECT_GT(collapse([](CheckSettings& s) { s.ovality = 0.02; }), round);
}

TEST(run_checks, the_basis_of_yield_moves_the_stress_limit) {
  const double fy = find_check_row(bgl1().statics.checks, "dnv_equivalent_stress", CheckRegion::sagbend).capacity;
  EXPECT_DOUBLE_EQ(fy, 0.87 * 0.96 * 414e6);
  const CheckTable smys = checks_with([](Description& d) { d.checks.yield_basis = YieldBasis::smys; });
  EXPECT_DOUBLE_EQ(find_check_row(smys, "dnv_equivalent_stress", CheckRegion::sagbend).capacity, 0.87 * 414e6);
}

TEST(run_checks, the_strain_factor_of_field_joints_counts_for_the_design_strain_and_api) {
  const CheckTable table = checks_with([](Description& d) { d.pipe.section.joint->strain_factor = 1.2; });
  const CheckTable& plain = bgl1().statics.checks;
  const auto demand = [](const CheckTable& t, const char* id) {
    return find_check_row(t, id, CheckRegion::overbend).demand;
  };
  for (const char* id : {"dnv_displacement_controlled", "api_bending_pressure"}) {
    EXPECT_NEAR(demand(table, id), 1.2 * demand(plain, id), 1e-12) << id;
  }
  EXPECT_DOUBLE_EQ(demand(table, "dnv_criterion_1"), demand(plain, "dnv_criterion_1"));  // without concentration
}

TEST(run_checks, a_roller_takes_from_the_plastic_moment_only_when_asked) {
  const CheckTable table = checks_with([](Description& d) { d.checks.point_load = true; });
  EXPECT_GT(find_check_row(table, "dnv_load_controlled", CheckRegion::overbend).utilisation,
            find_check_row(bgl1().statics.checks, "dnv_load_controlled", CheckRegion::overbend).utilisation);
  EXPECT_DOUBLE_EQ(find_check_row(table, "dnv_load_controlled", CheckRegion::sagbend).utilisation,
                   find_check_row(bgl1().statics.checks, "dnv_load_controlled", CheckRegion::sagbend).utilisation);
}

TEST(run_checks, one_code_alone_leaves_the_other_out) {
  for (const auto& [codes, second] : {std::pair{CheckCodes::dnv, "api_"}, std::pair{CheckCodes::api, "dnv_"}}) {
    const CheckTable table = checks_with([c = codes](Description& d) { d.checks.codes = c; });
    EXPECT_FALSE(table.rows.empty());
    for (const CheckRow& row : table.rows) EXPECT_FALSE(row.id.starts_with(second)) << row.id;
  }
}

TEST(run_checks, limits_of_the_equipment_are_judged_where_given) {
  EXPECT_EQ(find(bgl1().statics.checks, "roller_load", CheckRegion::line), nullptr);
  const CheckTable table = checks_with([](Description& d) {
    d.checks.limits = {100e3, 200e3, 240e3, 0.5};
    d.checks.allowable_stress.overbend_static = 0.85;
    d.checks.allowable_stress.sagbend_dynamic = 0.9;
  });
  EXPECT_NEAR(find_check_row(table, "roller_load", CheckRegion::line).demand, bgl1().statics.max_reaction, 1e-6);
  EXPECT_GT(find_check_row(table, "coating_line_load", CheckRegion::line).utilisation, 0.0);
  EXPECT_EQ(find_check_row(table, "tensioner_load", CheckRegion::line).status, CheckStatus::exceeded);
  EXPECT_NEAR(find_check_row(table, "tensioner_load", CheckRegion::line).utilisation, 250.0 / 240.0, 1e-6);
  EXPECT_NEAR(find_check_row(table, "tip_clearance", CheckRegion::line).capacity, *bgl1().statics.stinger_tip_clearance,
              1e-12);
  EXPECT_DOUBLE_EQ(find_check_row(table, "yield_share", CheckRegion::overbend).capacity, 0.85 * 414e6);
  EXPECT_DOUBLE_EQ(find_check_row(table, "yield_share", CheckRegion::tip).capacity, 0.85 * 414e6);
  EXPECT_NEAR(std::max(find_check_row(table, "yield_share", CheckRegion::overbend).demand,
                       find_check_row(table, "yield_share", CheckRegion::tip).demand),
              bgl1().statics.overbend.value().von_mises.value, 1.0);
  EXPECT_EQ(find(table, "yield_share", CheckRegion::sagbend), nullptr);  // needs a dynamic analysis
}

TEST(run_checks, internal_pressure_raises_the_strain_capacity_that_is_reported) {
  const auto row_with = [](double pressure) {
    const CheckTable table = checks_with([&](Description& d) { d.pipe.section.internal_pressure = pressure; });
    return find_check_row(table, "dnv_displacement_controlled", CheckRegion::overbend);
  };
  const CheckRow empty = row_with(0.0), full = row_with(8e6);
  ASSERT_LT(input(full, "p_e - p_i"), -7e6);
  EXPECT_GT(full.capacity, 1.5 * empty.capacity);
  EXPECT_NEAR(full.utilisation, full.demand / full.capacity, 1e-12);  // no pressure part, and the exponent is 1
  EXPECT_NEAR(input(full, "eps_c") / full.capacity, strain_safety_factor(SafetyClass::low), 1e-12);
}

TEST(run_checks, a_vacuum_inside_adds_to_the_pressure_of_the_water) {
  const auto overpressure = [](double pressure, double contents) {
    const CheckTable table = checks_with([&](Description& d) {
      d.pipe.section.internal_pressure = pressure;
      d.pipe.section.contents_weight_density = contents;
    });
    return find_check_row(table, "dnv_collapse", CheckRegion::line).demand;
  };
  const double empty = overpressure(0.0, 0.0);
  EXPECT_NEAR(overpressure(-1e5, 0.0), empty + 1e5, 1e-6 * empty);
  EXPECT_NEAR(overpressure(0.0, 10.05e3), 0.0, 1e-6 * empty);  // water inside and out, and no suction above it
}

TEST(run_checks, an_arrestor_is_judged_by_its_cross_over) {
  const CheckTable table = checks_with([](Description& d) { d.checks.arrestor = ArrestorSettings{8e6, 0.5}; });
  const CheckRow& row = find_check_row(table, "dnv_crossover", CheckRegion::line);
  EXPECT_TRUE(row.governing);
  EXPECT_GT(input(row, "p_X"), input(find_check_row(table, "dnv_propagation", CheckRegion::line), "p_pr(t2)"));
  EXPECT_LT(input(row, "p_X"), 8e6);
}

TEST(run_checks, the_api_edition_changes_the_factor_on_collapse) {
  const CheckTable third = checks_with([](Description& d) { d.checks.api.edition = ApiEdition::third; });
  const CheckRow& row = find_check_row(third, "api_bending_pressure", CheckRegion::sagbend);
  EXPECT_EQ(input(row, "f_c"), 1.0);
  EXPECT_NE(row.code.find("1999"), std::string::npos);
  const CheckTable of_fourth = checks_with([](Description& d) { d.checks.api.edition = ApiEdition::fourth; });
  const CheckRow& fourth = find_check_row(of_fourth, "api_bending_pressure", CheckRegion::sagbend);
  EXPECT_NE(fourth.code.find("2009"), std::string::npos);
  const CheckRow& fifth = find_check_row(bgl1().statics.checks, "api_bending_pressure", CheckRegion::sagbend);
  EXPECT_NE(fifth.code.find("2015"), std::string::npos);
  EXPECT_DOUBLE_EQ(fifth.utilisation, fourth.utilisation);
  EXPECT_NEAR(input(fourth, "delta"), 0.0025, 1e-15);  // half of O_0
  EXPECT_NEAR(input(fourth, "f_c"), 0.6 * (1.0 + 20.0 * 0.0025), 1e-12);
}

TEST(run_checks, lines_have_the_sheet_and_the_remark_on_a_short_run_that_every_row_has) {
  const Model model = build_model(read_model(OVERBEND_SOURCE_DIR "/examples/jumper.yaml").description.value());
  StaticResults statics;
  LineResult& line = statics.lines.emplace_back();
  line.utilisation = 0.2;
  line.max_tension = 50e3;
  DynamicResults run;
  run.duration = 1800.0;
  LineDynamics& moved = run.lines.emplace_back();
  moved.utilisation = 0.3;
  moved.max_tension = 75e3;
  const CheckTable rest = check_statics(model, statics), table = check_dynamics(model, statics, run);
  ASSERT_EQ(rest.rows.size(), 1U);
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_DOUBLE_EQ(rest.rows.front().sheet.back().value, 0.2 * 2.0);
  EXPECT_DOUBLE_EQ(table.rows.front().sheet.back().value, 0.3 * 1.67);
  EXPECT_EQ(rest.rows.front().remark.find("three hours"), std::string::npos);
  EXPECT_NE(table.rows.front().remark.find("from 30 min of a run"), std::string::npos);
  EXPECT_TRUE(table.assumptions.empty());
  EXPECT_TRUE(table.along.s.empty());
}

}  // namespace
}  // namespace overbend
