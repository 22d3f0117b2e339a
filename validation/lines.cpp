/// Lines by themselves: elastic catenaries, other programs' chains and jumpers, a vibrating cable.
#include <fmt/core.h>

#include <algorithm>

#include "groups.h"
#include "support/line_cases.h"

namespace overbend::validation {
namespace {

Table at_rest() {
  Table table{
      "Lines at rest",
      "Chains of MoorDyn's tests (410, 760 and 1,700 m, 390 kg/m) on a bed without friction at rest, against the "
      "elastic catenary; the flexible jumper of Lowe and Langley (2006). Elements by the rule of the mesh.",
      {}};
  const double chains[][3] = {{50.0, 1002.0, 835.9}, {200.0, 2070.8, 1406.6}, {600.0, 5237.9, 3248.3}};
  for (const auto& [depth, fairlead, anchor] : chains) {
    const testing::RestingLines lines(testing::chain_case(depth, 0.0));
    const std::string name = fmt::format("chain in {:g} m", depth);
    const auto add = [&](const char* what, double ours, double reference) {
      table.rows.push_back(
          {name, what, "kN", 1e-3 * ours, reference, share_of(reference, 2e-3), "elastic catenary; 0.2 %"});
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

double extreme(const std::vector<double>& values, bool largest) {
  return largest ? *std::max_element(values.begin(), values.end()) : *std::min_element(values.begin(), values.end());
}

Table in_time() {
  Table table{
      "Lines in motion",
      "The chains with their fairlead heaving every 10 s, against OrcaFlex (validation/moordyn); the jumper with "
      "its top moving by 10 m every 27 s along and across its plane, against the published record "
      "(validation/lowe_langley). Extremes of the tension.",
      {}};
  DynamicOptions options;
  options.output_step = 0.1;
  options.max_step = 0.1;
  struct Chain {
    const char* file;
    double depth, amplitude;
  };
  options.duration = 20.0;
  options.build_up = 10.0;
  for (const Chain& one :
       {Chain{"WD0050_Chain_ZZP1_A1.txt", 50.0, 2.0}, Chain{"WD0050_Chain_ZZP1_A2.txt", 50.0, 5.0},
        Chain{"WD0200_Chain_ZZP1_A1.txt", 200.0, 2.0}, Chain{"WD0200_Chain_ZZP1_A2.txt", 200.0, 5.0}}) {
    const testing::LineHistory line =
        testing::run_lines(testing::chain_case(one.depth, one.amplitude), options).front();
    const auto reference = testing::number_columns(std::string("moordyn/") + one.file);
    const std::string name = fmt::format("chain in {:g} m, heave {:g} m", one.depth, one.amplitude);
    const auto add = [&](const char* what, double ours, const std::vector<double>& record, bool largest) {
      table.rows.push_back({name, what, "kN", 1e-3 * ours, extreme(record, largest),
                            share_of(extreme(record, true), 0.03), "OrcaFlex; 3 % of the largest"});
    };
    add("fairlead, least", line.least_last, reference.at(3), false);
    add("fairlead, largest", line.most_last, reference.at(3), true);
    add("anchor, least", line.least_first, reference.at(4), false);
    add("anchor, largest", line.most_first, reference.at(4), true);
  }
  options.duration = options.build_up = 27.0;
  for (const auto& [file, amplitude] :
       {std::pair{"case1.csv", Vec3(10.0, 0.0, 0.0)}, {"case2.csv", Vec3(0.0, 10.0, 0.0)}}) {
    const testing::LineHistory line = testing::run_lines(testing::jumper_case(amplitude), options).front();
    const auto reference = testing::number_columns(std::string("lowe_langley/") + file);
    const std::string name = fmt::format("jumper, {} its plane", amplitude.x() > 0.0 ? "along" : "across");
    for (const bool largest : {false, true}) {
      const double published = extreme(reference.at(1), largest);
      table.rows.push_back({name, largest ? "top, largest" : "top, least", "kN",
                            1e-3 * (largest ? line.most_last : line.least_last), published, share_of(published, 0.02),
                            "published, digitised to 0.2 kN; 2 %"});
    }
  }
  return table;
}

}  // namespace

Group lines() {
  return {
      "Lines by themselves",
      "Cables, chains and flexibles between two ends ([theory](theory/lines.md)): rest and motion of the same element "
      "with their own numbers.",
      {at_rest(), in_time()}};
}

}  // namespace overbend::validation
