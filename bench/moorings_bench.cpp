// Times of mooring lines and of the rest of a hull on eight of them.
#include <benchmark/benchmark.h>

#include <cmath>

#include "moorings/planner.h"

namespace overbend {
namespace {

/// A barge on eight wires of 998.998 m in 89 m of water.
MooringSpread eight_wires() {
  MooringSpread spread;
  spread.bed = SeabedSurface(Vec3(0.0, 0.0, -89.0), Vec3::UnitZ());
  for (const double azimuth : {25.0, 65.0, 115.0, 155.0, 205.0, 245.0, 295.0, 335.0}) {
    const double angle = azimuth * 0.017453292519943295;
    const Vec3 to(std::cos(angle), std::sin(angle), 0.0);
    MooredLine& line = spread.lines.emplace_back();
    line.fairlead_V = {to.x() > 0.0 ? 58.0 : -58.0, to.y() > 0.0 ? 14.0 : -14.0, 3.8};
    line.anchor_W = line.fairlead_V + 992.0 * to;
    line.anchor_W.z() = -89.0;
    line.line.pieces = {{998.998, 170.0, 148.0, 190e6, 0.0}};
  }
  return spread;
}

StaticHull barge() {
  StaticHull hull;
  hull.length = 120.0;
  hull.restoring = Vec3(36198.9e3, 2075448e3, 42799210e3).asDiagonal();
  hull.steady << -205.5e3, 400e3, 0.0, 0.0, 0.0, 8e6;
  return hull;
}

void catenary(benchmark::State& state) {
  const MooringSpread spread = eight_wires();
  const MooredLine& line = spread.lines[0];
  const CatenarySite site = line_site(spread, line, line.fairlead_V);
  const CatenarySolution near = solve_catenary(line.line, site, 992.0);
  for (auto _ : state) benchmark::DoNotOptimize(solve_catenary(line.line, site, 992.2, &near).pull);
}
BENCHMARK(catenary)->Unit(benchmark::kMicrosecond);

void rest_on_eight_lines(benchmark::State& state) {
  const MooringSpread spread = eight_wires();
  const StaticHull hull = barge();
  for (auto _ : state) benchmark::DoNotOptimize(find_hull_equilibrium(spread, hull, HullOffset::Zero()).residual);
}
BENCHMARK(rest_on_eight_lines)->Unit(benchmark::kMicrosecond);

void lengths_for_a_place(benchmark::State& state) {
  const MooringSpread spread = eight_wires();
  const StaticHull hull = barge();
  const HullEquilibrium rest = find_hull_equilibrium(spread, hull, HullOffset::Zero());
  HullOffset hull_offset = rest.offset;
  hull_offset[0] += 12.0;
  for (auto _ : state) {
    MooringSpread copy = spread;
    benchmark::DoNotOptimize(plan_lengths(copy, hull, hull_offset, horizontal_pulls(spread, rest.lines)).residual);
  }
}
BENCHMARK(lengths_for_a_place)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace overbend
