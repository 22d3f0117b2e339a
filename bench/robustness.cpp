/// Solves many random but sensible lays from nothing and reports the share solved, the reasons of the rest, and the
/// times.
///
///     overbend_robustness [COUNT] [SEED] [FILE.csv] [yields | routes]
///
/// The file reports each lay with places and reactions, which lets two programs be compared lay by lay.
///
/// With `routes` every lay has lateral friction, three of four a current and every other a route that bends, with 0.6
/// to 3 times the radius that friction holds; it says, too, how often no line of steady laying was found.
///
/// With `yields` the steel is X65, Ramberg-Osgood of an exponent between 8 and 40, which these stingers bend past
/// yield.
#include <fmt/core.h>
#include <fmt/os.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "random_lays.h"
#include "statics/recovery/recovery.h"
#include "statics/solver/statics.h"

namespace overbend {
namespace {

struct Tally {
  int without_steady_lay = 0;  ///< For which no line of steady laying was found.
  int solved = 0, wrong = 0;
  int missed = 0;         ///< Lays whose recovered tension misses the wanted one by more than 0.1 %.
  double max_miss = 0.0;  ///< Over the wanted tension [-].
  std::map<std::string, int> reasons;
  std::vector<double> times;
};

void run_one(std::uint64_t seed, const std::string& kind, Tally& tally, fmt::ostream& csv) {
  Description d = random_lay(seed);
  if (kind == "routes") put_on_route(seed, d);
  if (kind == "yields") d.pipe.section.steel.material = random_material(seed);
  const Model model = build_model(d);
  const StaticOutcome outcome = solve_statics(model);
  const double diameter = d.pipe.section.steel.outside_diameter / kInch;
  csv.print("{},{:.4g},{:.1f},{:.1f},{},{},", seed, diameter, d.environment.water_depth, 1e-3 * *d.tensioner.tension,
            d.supports.boxes.size(), model.supports.rows.size());
  if (!outcome.solution) {
    ++tally.reasons[outcome.failure->what];
    csv.print("{},,,,,,,,\n", outcome.failure->what);
    fmt::print("lay {}: {:.4g} inch, {:.0f} m, {} boxes: {} ({})\n", seed, diameter, d.environment.water_depth,
               d.supports.boxes.size(), outcome.failure->what, outcome.failure->why);
    return;
  }
  const StaticResults results = recover_statics(model, *outcome.solution);
  const bool sound =
      results.force_residual < 1e-9 && results.global_residual < 1e-8 && std::isfinite(results.sagbend.von_mises.value);
  tally.solved += sound ? 1 : 0;
  tally.wrong += sound ? 0 : 1;
  if (has_code(results.findings, FindingCode::steady_laying_not_found)) {
    ++tally.without_steady_lay;
    fmt::print("lay {}: no line of steady laying\n", seed);
  }
  const double miss = std::abs(results.top_tension / *d.tensioner.tension - 1.0);
  tally.missed += miss > 1e-3 ? 1 : 0;
  tally.max_miss = std::max(tally.max_miss, miss);
  tally.times.push_back(results.solve.wall_time);
  double lateral = 0.0;
  for (const SupportResult& support : results.supports) lateral = std::max(lateral, std::abs(support.lateral));
  csv.print("solved,{},{:.2f},{:.1e},{:.1e},{:.7g},{:.7g},{:.5f},{:.6g}\n", results.solve.method,
            1e3 * results.solve.wall_time, results.force_residual, results.global_residual, results.bottom_tension,
            results.lay_back, (results.touchdown.p_W - results.stations.back().p_W).y(), lateral);
  if (!sound) {
    fmt::print("lay {}: unsound, residual {:.1e}, global {:.1e}\n", seed, results.force_residual,
               results.global_residual);
  }
}

}  // namespace
}  // namespace overbend

int main(int count, char** arguments) {
  const int lays = count > 1 ? std::stoi(arguments[1]) : 1000;
  const std::uint64_t seed = count > 2 ? std::stoull(arguments[2]) : 1;
  auto csv = fmt::output_file(count > 3 ? arguments[3] : "robustness.csv");
  csv.print(
      "seed,diameter [in],depth [m],tension [kN],boxes,rows,outcome,method,time [ms],residual,global residual,"
      "bottom tension [N],lay-back [m],across [m],largest lateral reaction [N]\n");
  const std::string kind = count > 4 ? arguments[4] : "";
  overbend::Tally tally;
  for (int i = 0; i < lays; ++i) {
    overbend::run_one(seed + static_cast<std::uint64_t>(i), kind, tally, csv);
  }
  std::sort(tally.times.begin(), tally.times.end());
  fmt::print("{} of {} lays solved ({:.2f} %), {} unsound\n", tally.solved, lays, 100.0 * tally.solved / lays,
             tally.wrong);
  fmt::print("{} without a line of steady laying\n", tally.without_steady_lay);
  fmt::print("{} miss the wanted tension by more than 0.1 %, the largest miss is {:.2g} %\n", tally.missed,
             100.0 * tally.max_miss);
  for (const auto& [reason, times] : tally.reasons) {
    fmt::print("  {} x {}\n", times, reason);
  }
  if (!tally.times.empty()) {
    const auto quantile = [&](double q) {
      return 1e3 * tally.times[static_cast<std::size_t>(q * static_cast<double>(tally.times.size() - 1))];
    };
    fmt::print("solver time: median {:.1f} ms, 90 % {:.1f} ms, longest {:.1f} ms\n", quantile(0.5), quantile(0.9),
               quantile(1.0));
  }
  return 0;
}
