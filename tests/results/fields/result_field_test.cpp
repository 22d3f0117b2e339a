#include "results/fields/result_field.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/json.h"
#include "report/page/report_style.h"
#include "resultfiles/hdf5/hdf5_readers.h"
#include "resultfiles/hdf5/hdf5_visitors.h"
#include "resultfiles/summary/json_fields.h"
#include "resultfiles/tables/csv_fields.h"
#include "resultfiles/tables/finite_visitor.h"
#include "results/fields/check_fields.h"
#include "results/fields/dynamic_scalars.h"
#include "results/fields/static_tables.h"
#include "serve/answers/page_style.h"
#include "serve/answers/type_style.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

/// A table of one row, as the tables next to result_field.h have them.
struct Probe {
  double squeeze = 0.0;
};

template <class Row, class Visit>
void visit_probe(Row& r, Visit& visit) {
  visit(ResultField{"squeeze", "N/m", "Squeeze of a roller"}.csv("squeeze").summary("max_squeeze").page().report(),
        r.squeeze);
}

const Probe kProbe{2500.0};

TEST(result_field, one_line_of_a_table_reaches_the_tables_of_text) {
  CsvHead head;
  visit_probe(kProbe, head);
  CsvTable table(head.names);
  CsvCells cells{table};
  visit_probe(kProbe, cells);
  EXPECT_EQ(table.text(), "squeeze [kN/m]\r\n2.5");
}

TEST(result_field, the_same_line_reaches_summary_page_report_and_types) {
  JsonWriter summary{SummaryStyle{}};
  visit_probe(kProbe, summary);
  EXPECT_EQ(json_text(summary.take()), R"({"max_squeeze":2500.0})");
  JsonWriter page{PageStyle{}};
  visit_probe(kProbe, page);
  EXPECT_EQ(json_text(page.take()), R"({"squeeze":2500.0})");
  const ReportStyle style(testing::solved_case("BGL1-T250").results);
  JsonLists<ReportStyle> report(style);
  visit_probe(kProbe, report);
  EXPECT_EQ(json_text(report.take()), R"({"squeeze":[2500.0]})");
  NamedTypes types;
  JsonWriter type{TypeStyle<Output::page>{&types}};
  visit_probe(kProbe, type);
  EXPECT_EQ(type_text(type.take()), "{ squeeze: number; }");
}

TEST(result_field, the_same_line_is_written_to_hdf5_read_again_and_checked) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "overbend_result_field_test.h5";
  {
    Hdf5Writer writer(file);
    TableWriter table;
    visit_probe(kProbe, table);
    table.end_row();
    table.write(writer, "/probes", "Probes");
    writer.close();
  }
  const Hdf5Reader reader(file);
  TableReader table(reader, "/probes");
  Probe found;
  table.start_row(0);
  visit_probe(found, table);
  EXPECT_EQ(found.squeeze, kProbe.squeeze);
  std::filesystem::remove(file);
  const Probe broken{std::numeric_limits<double>::infinity()};
  FiniteVisitor finite{"probe."};
  EXPECT_THROW(visit_probe(broken, finite), std::runtime_error);
}

/// Names that page or report would have in addition to a field's own.
struct OtherNames {
  std::vector<std::string> found;

  template <class Value>
  void operator()(const ResultField& f, const Value&) {
    for (const Output output : {Output::page, Output::report}) {
      const std::optional<std::string_view> key = f.key(output);
      // a vector may be the place itself, and a key may stand deeper
      const bool place = std::is_same_v<Value, Vec3>;
      if (key && *key != f.name && !place && key->find('/') == std::string_view::npos) found.emplace_back(*key);
    }
  }
  template <class SpreadType>
  void spread(const ResultField& f, const SpreadType&) {
    (*this)(f, 0.0);
  }
};

TEST(result_field, a_quantity_has_one_name_in_results_page_and_report) {
  OtherNames names;
  const StaticResults statics;
  const DynamicResults dynamics;
  const Station station;
  const SupportResult support;
  const RollerResult roller;
  const SupportDynamics box;
  const RollerDynamics roller_dynamics;
  const Impact impact;
  const CheckRow check;
  visit_key_results(statics, names);
  visit_scene(statics, names);
  visit_station(station, names);
  visit_support(support, names);
  visit_roller(roller, names);
  visit_dynamic_keys(dynamics, names, true);
  visit_dynamic_stations(dynamics, names);
  visit_dynamic_support(box, names);
  visit_dynamic_roller(roller_dynamics, names);
  visit_impact(impact, names);
  visit_check(check, names);
  EXPECT_TRUE(names.found.empty()) << names.found.front();
}

TEST(result_field, arc_lengths_are_counted_from_the_tensioner_on_the_page) {
  PageStyle style;
  style.top = 300.0;
  JsonWriter page{style};
  const Touchdown touchdown{{1.0, 2.0, -3.0}, 120.0, 90.0};
  visit_touchdown(touchdown, page);
  EXPECT_EQ(json_text(page.take()), R"({"place":[1.0,2.0,-3.0],"s":180.0})");
}

TEST(result_field, an_alias_with_a_star_names_the_four_values_of_a_quantity_over_time) {
  TensionerDynamics tensioner;
  tensioner.tension = {1.0, 2.0, 3.0, 4.0};
  JsonWriter json{SummaryStyle{}};
  visit_tensioner(tensioner, json);
  const auto summary = json.take();
  EXPECT_EQ(summary["min_tension"], 1.0);
  EXPECT_EQ(summary["std_tension"], 4.0);
  EXPECT_TRUE(summary.contains("travel_max"));
}

}  // namespace
}  // namespace overbend
