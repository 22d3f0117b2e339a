// The calculation sheets of solved models, evaluated from their texts.
#include "checks/calculation_sheet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "checks/run_checks.h"
#include "modelfile/reading/yaml_reader.h"
#include "statics/solver/statics.h"
#include "study/run/static_analysis.h"
#include "study/stages/lift.h"
#include "support/formula_value.h"

namespace overbend {
namespace {

using testing::formula_value;

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

using Values = std::map<std::string, double>;

/// Value of a line by its formula and the values of the lines before it. An equation gives none: its value must solve
/// it, and is the root below both pressures.
double value_by_text(const SheetLine& line, Values values) {
  const std::size_t equals = line.formula.find(" = ");
  if (equals == std::string::npos) return formula_value(line.formula, values);
  values[line.symbol] = line.value;
  const double left = formula_value(line.formula.substr(0, equals), values);
  const double right = formula_value(line.formula.substr(equals + 3), values);
  EXPECT_NEAR(left, right, 1e-8 * std::abs(right)) << line.formula;  // half of the digits are left near a double root
  EXPECT_LT(line.value, std::min(values.at("p_el"), values.at("p_p")));
  return line.value;
}

/// Evaluates a sheet from its inputs alone and compares every line and the utilisation of its row.
void expect_sheet_gives_utilisation(const CheckRow& row) {
  SCOPED_TRACE(row.id);
  ASSERT_FALSE(row.sheet.empty());
  Values values;
  for (const SheetLine& line : row.sheet) {
    const double value = line.formula.empty() ? line.value : value_by_text(line, values);
    EXPECT_NEAR(value, line.value, 1e-9 * std::abs(line.value)) << line.symbol << ": " << line.formula;
    values[line.symbol] = value;
    EXPECT_FALSE(line.meaning.empty()) << line.symbol;
  }
  EXPECT_EQ(row.sheet.back().symbol, "U");
  EXPECT_NEAR(values.at("U"), row.utilisation, 1e-9 * row.utilisation);
}

void expect_sheets_give_utilisations(const CheckTable& table, const std::string& what) {
  SCOPED_TRACE(what);
  ASSERT_FALSE(table.rows.empty());
  for (const CheckRow& row : table.rows) {
    if (row.judged()) expect_sheet_gives_utilisation(row);
  }
}

TEST(calculation_sheet, the_numbers_on_the_sheet_give_the_utilisation_of_every_check) {
  expect_sheets_give_utilisations(bgl1().statics.checks, "default");
  const std::map<std::string, std::function<void(Description&)>> variants = {
      {"current functional", [](Description& d) { d.checks.current_load = CurrentLoad::functional; }},
      {"one combination", [](Description& d) { d.checks.system_effects = false; }},
      {"condition", [](Description& d) { d.checks.condition_factor = 1.07; }},
      {"high class", [](Description& d) { d.checks.safety_class = SafetyClass::high; }},
      {"arrestor",
       [](Description& d) {
         d.checks.arrestor = ArrestorSettings{20e6, 0.8};
       }},
      {"point load", [](Description& d) { d.checks.point_load = true; }},
      {"third edition", [](Description& d) { d.checks.api.edition = ApiEdition::third; }},
      {"f_c given", [](Description& d) { d.checks.api.combined_collapse_factor = 0.9; }},
      {"seamless", [](Description& d) { d.checks.manufacture = Manufacture::seamless; }},
      {"alpha_fab and f_o given",
       [](Description& d) {
         d.checks.alpha_fab = 0.9;
         d.checks.api.collapse_factor = 0.65;
       }},
      {"basis SMYS", [](Description& d) { d.checks.yield_basis = YieldBasis::smys; }},
      {"project limits",
       [](Description& d) {
         d.checks.allowable_stress.overbend_static = 0.85;
         d.checks.allowable_stress.sagbend_static = 0.72;
         d.checks.limits.roller_load = 100e3;
         d.checks.limits.tension = 300e3;
       }},
      {"wall tolerance", [](Description& d) { d.checks.wall_tolerance = 0.001; }},
      {"internal pressure", [](Description& d) { d.pipe.section.internal_pressure = 12e6; }},
      {"high internal pressure", [](Description& d) { d.pipe.section.internal_pressure = 22e6; }},
      {"thick wall", [](Description& d) { d.pipe.section.steel.wall_thickness = 0.024; }},
  };
  for (const auto& [what, change] : variants) expect_sheets_give_utilisations(checks_with(change), what);
}

TEST(calculation_sheet, the_numbers_of_pipe_of_a_line_give_its_utilisations) {
  Description d = read_model(OVERBEND_SOURCE_DIR "/validation/lift_cases/DL8-one.yaml").description.value();
  d.operation.lay.stages.resize(3);
  const StaticResults lifted = *solve_lift(d, {}).stages.back().lay;
  const auto checked = [&](const std::function<void(Description&)>& change) {
    Description changed = d;
    change(changed);
    return check_statics(build_model(changed), lifted);
  };
  expect_sheets_give_utilisations(checked([](Description&) {}), "default");
  expect_sheets_give_utilisations(checked([](Description& c) {
                                    c.environment.current = {{0.0, 0.5, 0.0}};
                                    c.checks.condition_factor = 1.07;
                                  }),
                                  "current");
  expect_sheets_give_utilisations(checked([](Description& c) {
                                    c.lines[0].segments[0].section->internal_pressure = 12e6;
                                    c.checks.arrestor = ArrestorSettings{20e6, 0.8};
                                  }),
                                  "pressure and arrestor");
  const CheckTable pointed = checked([](Description& c) { c.checks.point_load = true; });
  expect_sheets_give_utilisations(pointed, "force of the wire");
  EXPECT_TRUE(std::ranges::any_of(
      pointed.rows, [](const CheckRow& row) { return row.id == "dnv_load_controlled" && row.line == "pipe"; }));
}

TEST(calculation_sheet, a_changed_number_of_the_sheet_no_longer_gives_the_utilisation) {
  for (CheckRow row : bgl1().statics.checks.rows) {
    if (row.id != "dnv_load_controlled" || row.region != CheckRegion::sagbend) continue;
    Values values;
    for (const SheetLine& line : row.sheet) {
      const double given = line.symbol == "gamma_SC" ? 1.01 * line.value : line.value;
      values[line.symbol] = line.formula.empty() ? given : value_by_text(line, values);
    }
    EXPECT_GT(std::abs(values.at("U") / row.utilisation - 1.0), 1e-3);
  }
}

/// A run of one station with the same value everywhere: what a run hands on is taken as given.
TEST(calculation_sheet, the_numbers_of_a_run_give_the_utilisations_too) {
  DynamicResults run;
  run.duration = 10800.0;
  const Station& top = bgl1().statics.stations.back();
  run.station_s = {top.s};
  run.static_place = {top.p_W};
  StationDesign& d = run.design;
  for (std::vector<double>* list : {&run.static_moment,
                                    &run.static_tension,
                                    &run.static_strain,
                                    &run.static_von_mises,
                                    &run.von_mises.max,
                                    &run.strain.max,
                                    &run.effective_tension.max,
                                    &d.load,
                                    &d.load_time,
                                    &d.moment,
                                    &d.force,
                                    &d.load_pressure,
                                    &d.share,
                                    &d.max_force,
                                    &d.strain,
                                    &d.strain_time,
                                    &d.design_strain,
                                    &d.strain_pressure,
                                    &d.von_mises_time,
                                    &d.fibre_strain_time,
                                    &d.tension_time}) {
    list->assign(1, 0.1);
  }
  expect_sheets_give_utilisations(check_dynamics(build_model(bgl1().description), bgl1().statics, run), "run");
}

const SheetLine* find_line(const CheckRow& row, const std::string& symbol) {
  for (const SheetLine& line : row.sheet) {
    if (line.symbol == symbol) return &line;
  }
  return nullptr;
}

TEST(calculation_sheet, it_marks_what_no_public_text_confirms) {
  const std::map<std::string, std::string> unconfirmed = {{"dnv_displacement_controlled", "alpha_gw"},
                                                          {"dnv_criterion_1", "eps_lim"},
                                                          {"dnv_equivalent_stress", "sigma_lim"},
                                                          {"api_bending_pressure", "g"}};
  std::size_t found = 0;
  for (const CheckRow& row : bgl1().statics.checks.rows) {
    for (const SheetLine& line : row.sheet) {
      EXPECT_EQ(line.confirmation == Confirmation::one_source || line.confirmation == Confirmation::two_sources,
                !line.sources.empty() && line.confirmation != Confirmation::unconfirmed)
          << row.id << " " << line.symbol;
    }
    const auto open = unconfirmed.find(row.id);
    if (open == unconfirmed.end()) continue;
    const SheetLine* line = find_line(row, open->second);
    ASSERT_NE(line, nullptr) << row.id;
    EXPECT_EQ(line->confirmation, Confirmation::unconfirmed) << row.id;
    ++found;
  }
  EXPECT_GE(found, 4U);
}

TEST(calculation_sheet, the_collapse_factor_of_combined_loading_can_be_given) {
  const auto bending = [](const CheckTable& table) {
    const auto row = std::find_if(table.rows.begin(), table.rows.end(), [](const CheckRow& each) {
      return each.id == "api_bending_pressure" && each.region == CheckRegion::sagbend;  // under water
    });
    return row->utilisation;
  };
  const CheckTable given = checks_with([](Description& d) { d.checks.api.combined_collapse_factor = 1.0; });
  const CheckTable third = checks_with([](Description& d) { d.checks.api.edition = ApiEdition::third; });
  EXPECT_DOUBLE_EQ(bending(given), bending(third));
  EXPECT_LT(bending(given), bending(bgl1().statics.checks));
  const CheckTable oval = checks_with([](Description& d) { d.checks.api.ovality = 0.1; });  // f_o/g = 1.8
  for (const CheckRow& row : oval.rows) {
    const SheetLine* f_c = find_line(row, "f_c");
    EXPECT_TRUE(f_c == nullptr || f_c->value == 1.0) << row.id;
  }
}

}  // namespace
}  // namespace overbend
