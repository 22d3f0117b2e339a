#include "study/lay_table/lay_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "base/json.h"
#include "report/page_text.h"
#include "resultfiles/hdf5/result_tree.h"
#include "resultfiles/studies/lay_table_writer.h"
#include "results/check_results.h"
#include "study/lay_on_its_last_box.h"
#include "study/lay_table/lay_table_range.h"
#include "support/csv_text.h"
#include "support/solved_case.h"
#include "support/zip_text.h"

namespace overbend {
namespace {

Description described(const std::string& name) {
  return read_model(testing::case_file(name)).description.value();
}

Json expected(const std::string& name) {
  return read_json(
      testing::file_text(OVERBEND_SOURCE_DIR "/validation/static_cases/" + name + ".expected.json"))["static"];
}

LayTableDescription range(LayTableVary vary, double from, double to, int steps) {
  LayTableDescription table;
  table.vary = vary;
  table.from = from;
  table.to = to;
  table.steps = steps;
  return table;
}

const LayTableRow* find_check_row(const LayTable& table, LayRowKind kind) {
  const auto sample =
      std::find_if(table.rows.begin(), table.rows.end(), [&](const LayTableRow& row) { return row.kind == kind; });
  return sample == table.rows.end() ? nullptr : &*sample;
}

const LayTableRow& step(const LayTable& table, double varied) {
  return *std::min_element(table.rows.begin(), table.rows.end(), [&](const LayTableRow& a, const LayTableRow& b) {
    return std::abs(a.varied - varied) + (a.kind == LayRowKind::step ? 0.0 : 1e9) <
           std::abs(b.varied - varied) + (b.kind == LayRowKind::step ? 0.0 : 1e9);
  });
}

/// Three reference cases are one model at three tensions.
const LayTable& tensions_of_s16() {
  static const LayTable kTable = make_lay_table(described("S16-T300"), range(LayTableVary::tension, 250e3, 400e3, 3));
  return kTable;
}

}  // namespace

TEST(lay_table, rows_over_tension_have_the_independent_answers) {
  for (const auto& [name, tension] : {std::pair{"S16-T250", 250e3}, {"S16-T300", 300e3}, {"S16-T400", 400e3}}) {
    const Json answer = expected(name);
    const LayTableValues& lay = step(tensions_of_s16(), tension).lay.value();
    EXPECT_NEAR(lay.top_tension, tension, 1.0) << name;
    EXPECT_NEAR(lay.bottom_tension, answer["bottom_tension"].get<double>(), 2e-3 * lay.bottom_tension) << name;
    EXPECT_NEAR(lay.lay_back, answer["lay_back"].get<double>(), 0.1) << name;
    EXPECT_NEAR(lay.overbend_bending_stress, answer["overbend"]["max_bending_stress"].get<double>(),
                5e-3 * lay.overbend_bending_stress)
        << name;
    EXPECT_NEAR(lay.sagbend_bending_stress, answer["sagbend"]["max_bending_stress"].get<double>(),
                5e-3 * lay.sagbend_bending_stress)
        << name;
  }
}

TEST(lay_table, a_row_whose_pipe_has_left_its_stinger_says_so_though_its_checks_pass) {
  // The current of the example pushes the pipe over the port side of the last boxes at 300 kN.
  const Description description = read_model(OVERBEND_SOURCE_DIR "/examples/bgl1.yaml").description.value();
  const LayTable table = make_lay_table(description, range(LayTableVary::tension, 250e3, 300e3, 1));
  const LayTableRow& held = step(table, 250e3);
  EXPECT_TRUE(held.lay->passed());
  EXPECT_EQ(make_remark(held), "");
  const LayTableRow& left = step(table, 300e3);
  EXPECT_EQ(left.lay->verdict, VerdictKind::reserved);
  EXPECT_EQ(lay_verdict(left), "reserved");
  EXPECT_NE(make_remark(left).find("the pipe has left 'stinger 7'"), std::string::npos) << make_remark(left);
  EXPECT_TRUE(has_code(table.findings, FindingCode::pipe_off_rollers));
}

TEST(lay_table, lay_back_of_a_reference_case_finds_its_tension) {
  const double wanted = expected("S16-T400")["lay_back"];
  const LayTable table = make_lay_table(described("S16-T300"), range(LayTableVary::lay_back, wanted, wanted + 1.0, 1));
  const LayTableValues& lay = step(table, wanted).lay.value();
  EXPECT_NEAR(lay.lay_back, wanted, 1e-3);
  EXPECT_NEAR(lay.top_tension, 400e3, 0.3e3);  // 0.1 m of touchdown, as the reference cases allow, is 0.17 kN
}

TEST(lay_table, depth_of_the_model_is_the_model) {
  const LayTable table = make_lay_table(described("S16-T300"), range(LayTableVary::depth, 80.0, 89.0, 1));
  EXPECT_NEAR(step(table, 89.0).lay.value().lay_back, expected("S16-T300")["lay_back"].get<double>(), 0.1);
  EXPECT_LT(step(table, 80.0).lay.value().lay_back, step(table, 89.0).lay.value().lay_back);
  EXPECT_GT(step(table, 80.0).lay.value().bottom_tension, step(table, 89.0).lay.value().bottom_tension);
}

TEST(lay_table, depths_sink_an_uneven_bed_as_a_whole) {
  Description level = described("S16-T300");
  level.environment.seabed.profile = {{-1000.0, 89.0}, {3000.0, 89.0}};
  const LayTable table = make_lay_table(level, range(LayTableVary::depth, 80.0, 89.0, 1));
  const LayTable plane = make_lay_table(described("S16-T300"), range(LayTableVary::depth, 80.0, 89.0, 1));
  EXPECT_NEAR(step(table, 80.0).lay.value().lay_back, step(plane, 80.0).lay.value().lay_back, 0.01);
}

TEST(lay_table, a_tension_that_carries_no_pipe_stands_in_the_table_with_its_reason) {
  const LayTable table = make_lay_table(described("S16-T300"), range(LayTableVary::tension, 10e3, 300e3, 1));
  const LayTableRow& row = step(table, 10e3);
  EXPECT_FALSE(row.lay);
  EXPECT_EQ(row.reason, "the tension is too low to carry the pipe");
  EXPECT_TRUE(step(table, 300e3).lay);
}

TEST(lay_table, limits_separate_lays_that_pass_from_lays_that_do_not) {
  const LayTable table = make_lay_table(described("J12-D400-T560"), range(LayTableVary::tension, 400e3, 800e3, 2));
  const LayTableRow* min_value = find_check_row(table, LayRowKind::minimum);
  ASSERT_NE(min_value, nullptr);
  EXPECT_TRUE(min_value->lay.value().passed());
  EXPECT_FALSE(min_value->reason.empty());
  Description below = described("J12-D400-T560");
  below.tensioner.tension = 0.998 * min_value->varied;  // the limit is found to 0.1 %
  const LayTable beyond = make_lay_table(below, range(LayTableVary::tension, *below.tensioner.tension, 560e3, 1));
  const LayTableRow& failing = step(beyond, *below.tensioner.tension);
  EXPECT_FALSE(failing.lay && failing.lay->passed());
}

TEST(lay_table, a_row_says_which_check_could_not_be_judged) {
  const auto warned = [](double yield_stress) {
    Description d = described("S16-T300");
    d.pipe.section.steel.yield_stress = yield_stress;
    const LayTable table = make_lay_table(d, range(LayTableVary::tension, 250e3, 300e3, 1));
    return std::ranges::any_of(table.rows, [](const LayTableRow& row) {
      return make_remark(row).find("not judged: ") != std::string::npos &&
             make_remark(row).find("the criteria start at X52") != std::string::npos;
    });
  };
  EXPECT_FALSE(warned(414e6));
  EXPECT_TRUE(warned(290e6));
}

/// Across its current BGL-1 has several equilibria, which differ in the side rollers that bear.
TEST(lay_table, rows_are_the_lays_that_statics_finds_whatever_rows_stand_before_them) {
  Description d = read_model(OVERBEND_SOURCE_DIR "/examples/bgl1.yaml").description.value();
  const LayTable table = make_lay_table(d, range(LayTableVary::tension, 286e3, 346e3, 12));
  for (const double tension : {306e3, 346e3}) {
    d.tensioner.tension = tension;
    Model model = build_model(d);
    const StaticResults alone = checked_statics(model, solve_lay(model));
    const LayTableValues& row = step(table, tension).lay.value();
    EXPECT_NEAR(row.lay_back, alone.lay_back, 1e-4);
    EXPECT_NEAR(row.max_reaction, alone.max_reaction, 1.0);
    EXPECT_NEAR(row.overbend_von_mises, alone.overbend.value().von_mises.value, 1e3);
  }
}

TEST(lay_table, along_a_route_the_tension_is_held_or_the_least_that_passes) {
  LayTableDescription route;
  route.profile = {{0.0, 400.0}, {5000.0, 300.0}};
  const LayTable held = make_lay_table(described("J12-D400-T560"), route);
  ASSERT_EQ(held.rows.size(), 2U);
  EXPECT_NEAR(held.rows[1].lay.value().top_tension, 560e3, 1.0);
  EXPECT_EQ(held.rows[1].distance, 5000.0);
  route.tension = RouteTension::minimum;
  const LayTable sought = make_lay_table(described("J12-D400-T560"), route);
  for (const LayTableRow& row : sought.rows) {
    EXPECT_TRUE(row.lay.value().passed());
    EXPECT_GT(row.lay->utilisation.value(), 0.9) << row.depth;  // on its limit, or close to where no lay stands
  }
  EXPECT_LT(sought.rows[1].lay->top_tension, sought.rows[0].lay->top_tension);
}

/// At 90 m a check of the lays that clear the tip is outside its validity, and linear steel yields: the project accepts
/// both.
constexpr const char* kClearTip =
    "checks: {manufacture: seamless, limits: {tip_clearance: 0.05 m}, accepted_findings: [check-not-judged, "
    "yield-with-linear-steel]}\n";

/// Lays pass only at several times the model's own tension, and not over one stretch.
TEST(lay_table, the_least_tension_does_not_depend_on_that_of_the_model) {
  LayTableDescription route;
  route.tension = RouteTension::minimum;
  route.profile = {{0.0, 66.0}, {500.0, 90.0}};
  Description model = testing::lay_on_its_last_box(kClearTip);
  const LayTable from_below = make_lay_table(model, route);
  model.tensioner.tension = 2600e3;
  const LayTable from_above = make_lay_table(model, route);
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_TRUE(from_below.rows[i].lay && from_below.rows[i].lay->passed()) << from_below.rows[i].reason;
    EXPECT_EQ(from_below.rows[i].varied, from_above.rows[i].varied);
    const double less = 0.998 * from_below.rows[i].varied;  // the limit is found to 0.1 %
    model.environment.water_depth = route.profile[i].depth;
    const LayTable below = make_lay_table(model, range(LayTableVary::tension, less, from_below.rows[i].varied, 1));
    EXPECT_FALSE(below.rows.front().lay->passed());
  }
  EXPECT_LT(from_below.rows[0].varied, 1655e3);  // which passes at 66 m, as 2500 kN does at 90 m
  EXPECT_LT(from_below.rows[1].varied, 2500e3);
}

TEST(lay_table, where_no_tension_passes_the_row_says_what_was_searched_and_what_stops_it) {
  LayTableDescription route;
  route.tension = RouteTension::minimum;
  route.profile = {{0.0, 58.0}};
  const LayTable none = make_lay_table(
      testing::lay_on_its_last_box("checks: {manufacture: seamless, limits: {tip_clearance: 9 m}}\n"), route);
  ASSERT_EQ(none.rows.size(), 1U);
  const LayTableRow& row = none.rows.front();
  EXPECT_EQ(lay_verdict(row), "exceeded");
  for (const char* arguments :
       {"no tension from", "passes every check", "Clearance at the stinger tip is exceeded", "nearest to passing"}) {
    EXPECT_NE(row.reason.find(arguments), std::string::npos) << arguments << " in: " << row.reason;
  }
}

TEST(lay_table, files_say_the_same_in_csv_workbook_and_summary) {
  const testing::TemporaryFolder folder;
  write_lay_table_run(tensions_of_s16(), described("S16-T300"), folder / "table");
  const auto lines = testing::csv_lines(testing::file_text(folder / "table/lay-table.csv"));
  ASSERT_EQ(lines.size(), tensions_of_s16().rows.size() + 1);
  const double top = testing::value_in(lines, 1, "top tension [kN]");
  const Json summary = read_json(testing::file_text(folder / "table/summary.json"));
  EXPECT_NEAR(summary["lay_table"]["rows"][0]["top_tension"].get<double>(), 1e3 * top, 1e-3);
  EXPECT_EQ(summary["lay_table"]["vary"], "tension");
  const auto book = testing::zip_texts(testing::file_text(folder / "table/lay-table.xlsx"));
  EXPECT_NE(book.at("xl/sharedStrings.xml").find("lay-back [m]"), std::string::npos);
  const Json body = testing::document_in(testing::file_text(folder / "table/report.html"))["body"];
  EXPECT_TRUE(testing::panels(body).front().starts_with("lay_table/"));
}

TEST(lay_table, datasets_have_a_row_for_each_lay_and_nothing_where_there_is_none) {
  const LayTable table = make_lay_table(described("S16-T300"), range(LayTableVary::tension, 10e3, 300e3, 1));
  ResultTree tree;
  write_lay_table_groups(tree, table);
  const auto column = [&](const char* name) {
    return std::get<std::vector<double>>(tree.datasets.at(std::string("/lay_table/") + name).values);
  };
  ASSERT_EQ(column("tension").size(), table.rows.size());
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    EXPECT_EQ(column("tension")[i], table.rows[i].varied);
    EXPECT_EQ(std::isnan(column("lay_back")[i]), !table.rows[i].lay);
    if (table.rows[i].lay) {
      EXPECT_EQ(column("lay_back")[i], table.rows[i].lay->lay_back);
    }
  }
  EXPECT_EQ(tree.datasets.at("/lay_table/lay_back").units, "m");
  const auto& verdicts = std::get<std::vector<std::string>>(tree.datasets.at("/lay_table/verdict").values);
  EXPECT_EQ(verdicts.front(), "no lay");
}

TEST(lay_table_range, takes_the_unit_of_its_end) {
  LayTableDescription table;
  take_range(LayTableVary::tension, "200..400 kN/10", table);
  EXPECT_EQ(table.from, 200e3);
  EXPECT_EQ(table.to, 400e3);
  EXPECT_EQ(table.steps, 10);
  take_range(LayTableVary::depth, "0.06 km .. 120 m", table);
  EXPECT_NEAR(table.from.value(), 60.0, 1e-12);
  EXPECT_EQ(table.vary, LayTableVary::depth);
}

TEST(lay_table_range, rejects_what_is_no_range) {
  LayTableDescription table;
  for (const char* wrong :
       {"200 kN", "200 m..400 m", "0 kN..200 kN", "200 kN..200 kN", "200..400 kN/0", "..400 kN", "a..b"}) {
    EXPECT_THROW(take_range(LayTableVary::tension, wrong, table), std::invalid_argument) << wrong;
  }
}

}  // namespace overbend
