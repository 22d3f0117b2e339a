/// Rainflow counts and S-N curves compared with published and independently computed values.
#include <cmath>
#include <map>
#include <span>

#include "checks/fatigue_curve.h"
#include "groups.h"
#include "numerics/rainflow.h"

namespace overbend::validation {
namespace {

Table rainflow_example() {
  Table table{
      "Rainflow counting", "The example of ASTM E1049-85: -2, 1, -3, 5, -1, 3, -4, 4, -2.", {}, "ASTM E1049-85"};
  std::map<double, double> counts;
  const auto keep = [&](std::size_t, const RainflowCycle& cycle) { counts[cycle.range] += cycle.count; };
  RainflowCounter counter(1);
  for (const double value : {-2.0, 1.0, -3.0, 5.0, -1.0, 3.0, -4.0, 4.0, -2.0}) {
    counter.add(std::span(&value, 1), keep);
  }
  counter.residue(keep);
  for (const auto& [range, count] : {std::pair{3.0, 0.5}, {4.0, 1.5}, {6.0, 0.5}, {8.0, 1.0}, {9.0, 0.5}}) {
    table.rows.push_back({"range " + std::to_string(static_cast<int>(range)), "cycles", "", counts[range], count, 0.0,
                          "ASTM E1049-85, exact"});
  }
  return table;
}

void add_lives(std::vector<Row>& rows, const char* name, const SnCurve& curve,
               const std::vector<std::pair<double, double>>& lives) {
  for (const auto& [range, life] : lives) {
    rows.push_back({name, "cycles at " + std::to_string(static_cast<int>(range)) + " MPa", "",
                    1.0 / curve.damage(range * 1e6), life, 5e-5 * life, "computed from the tables; digits printed"});
  }
}

Table lives() {
  Table table{
      "S-N curves of DNV-RP-C203",
      "Lives computed from the tables apart from the program: they verify the implementation, not the numbers of "
      "the tables.",
      {}};
  add_lives(table.rows, "D, air", sn_curve(FatigueCurve::d, FatigueMedium::air),
            {{20.0, 1.2614e9}, {50.0, 1.2917e7}, {100.0, 1.4588e6}, {200.0, 1.8235e5}});
  add_lives(table.rows, "F1, air", sn_curve(FatigueCurve::f1, FatigueMedium::air),
            {{50.0, 4.0003e6}, {100.0, 5.0003e5}});
  add_lives(table.rows, "D, protected seawater", sn_curve(FatigueCurve::d, FatigueMedium::seawater_protected),
            {{100.0, 5.8076e5}});
  add_lives(table.rows, "E, air", sn_curve(FatigueCurve::e, FatigueMedium::air), {{50.0, 8.1863e6}, {100.0, 1.0233e6}});
  return table;
}

}  // namespace

Group fatigue() {
  return {
      "Fatigue",
      "computed from the tables",
      "Cycles and lives of the [fatigue of welds](theory/fatigue.md). Mean damage of narrow-banded Gaussian stress is "
      "compared with its closed form by a test, within 2 %.",
      {rainflow_example(), lives()}};
}

}  // namespace overbend::validation
