/// Lines without a pipe: elastic catenaries, other programs' chains and jumpers, a vibrating cable.
#include <fmt/core.h>

#include <algorithm>

#include "groups.h"
#include "support/line_cases.h"

namespace overbend::validation {
namespace {

Table at_rest() {
  Table table{
      "Static lines",
      "Chains of MoorDyn's tests (410, 760 and 1,700 m, 390 kg/m) on a seabed without friction, compared with the "
      "elastic catenary; the flexible jumper of Lowe and Langley (2006). Default mesh.",
      {},
      "elastic catenary, published jumper"};
  const double chains[][3] = {{50.0, 1002.0, 835.9}, {200.0, 2070.8, 1406.6}, {600.0, 5237.9, 3248.3}};
  for (const auto& [depth, fairlead, anchor] : chains) {
    const testing::RestingLines lines(testing::chain_case(depth, 0.0));
    const std::string name = fmt::format("chain in {:g} m", depth);
    const auto add = [&](const char* what, double ours, double reference) {
      table.rows.push_back(
          {name, what, "kN", 1e-3 * ours, reference, relative_tolerance(reference, 2e-3), "elastic catenary; 0.2 %"});
    };
    add("tension at the fairlead", lines.last[0].norm(), fairlead);
    add("horizontal force at the anchor", std::abs(lines.first[0].x()), anchor);
  }
  const testing::RestingLines jumper(testing::jumper_case(Vec3::Zero()));
  const auto add = [&](const char* what, double ours, double reference) {
    table.rows.push_back({"jumper", what, "kN", 1e-3 * ours, reference, 0.02, "published; 0.02 kN"});
  };
  add("horizontal force at the top", jumper.last[0].x(), 11.40);
  add("vertical force at the top", jumper.last[0].z(), 45.71);
  add("vertical force at the bottom", jumper.first[0].z(), 24.04);
  return table;
}

double extreme(const std::vector<double>& values, bool is_maximum) {
  return is_maximum ? *std::max_element(values.begin(), values.end()) : *std::min_element(values.begin(), values.end());
}

Table in_time() {
  Table table{
      "Lines in motion",
      "The chains with their fairlead heaving every 10 s, against OrcaFlex (validation/moordyn); the jumper with "
      "its top moving by 10 m every 27 s along and across its plane, against the published record "
      "(validation/lowe_langley). Extremes of the tension.",
      {},
      "OrcaFlex, published jumper"};
  DynamicOptions options;
  options.output_step = 0.1;
  options.max_step = 0.1;
  struct Chain {
    const char* file;
    double depth, amplitude;
  };
  options.duration = 20.0;
  options.build_up = 10.0;
  for (const Chain& chain :
       {Chain{"WD0050_Chain_ZZP1_A1.txt", 50.0, 2.0}, Chain{"WD0050_Chain_ZZP1_A2.txt", 50.0, 5.0},
        Chain{"WD0200_Chain_ZZP1_A1.txt", 200.0, 2.0}, Chain{"WD0200_Chain_ZZP1_A2.txt", 200.0, 5.0}}) {
    const testing::LineHistory line =
        testing::run_lines(testing::chain_case(chain.depth, chain.amplitude), options).front();
    const auto reference = testing::number_columns(std::string("moordyn/") + chain.file);
    const std::string name = fmt::format("chain in {:g} m, heave {:g} m", chain.depth, chain.amplitude);
    const auto add = [&](const char* what, double ours, const std::vector<double>& record, bool is_maximum) {
      table.rows.push_back({name, what, "kN", 1e-3 * ours, extreme(record, is_maximum),
                            relative_tolerance(extreme(record, true), 0.03), "OrcaFlex; 3 % of the maximum"});
    };
    add("fairlead, minimum", line.min_last_tension, reference.at(3), false);
    add("fairlead, maximum", line.max_last_tension, reference.at(3), true);
    add("anchor, minimum", line.min_first_tension, reference.at(4), false);
    add("anchor, maximum", line.max_first_tension, reference.at(4), true);
  }
  options.duration = options.build_up = 27.0;
  for (const auto& [file, amplitude] :
       {std::pair{"case1.csv", Vec3(10.0, 0.0, 0.0)}, {"case2.csv", Vec3(0.0, 10.0, 0.0)}}) {
    const testing::LineHistory line = testing::run_lines(testing::jumper_case(amplitude), options).front();
    const auto reference = testing::number_columns(std::string("lowe_langley/") + file);
    const std::string name = fmt::format("jumper, {} its plane", amplitude.x() > 0.0 ? "along" : "across");
    for (const bool is_maximum : {false, true}) {
      const double published = extreme(reference.at(1), is_maximum);
      table.rows.push_back({name, is_maximum ? "top, maximum" : "top, minimum", "kN",
                            1e-3 * (is_maximum ? line.max_last_tension : line.min_last_tension), published,
                            relative_tolerance(published, 0.02), "published, digitised to 0.2 kN; 2 %"});
    }
  }
  return table;
}

}  // namespace

Group lines() {
  return {"Lines without a pipe",
          "elastic catenary",
          "Cables, chains and flexibles between two ends ([theory](theory/lines.md)): statics and dynamics of the same "
          "element "
          "with the properties of the line.",
          {at_rest(), in_time()}};
}

}  // namespace overbend::validation
