/// Statics of the BGL-1 example: from the parsed model, and with a start from the neighbour.
#include <benchmark/benchmark.h>

#include <string>

#include "modelfile/reading/yaml_reader.h"
#include "statics/recovery/current_effect.h"
#include "statics/recovery/recovery.h"
#include "statics/solver/statics.h"

namespace overbend {
namespace {

Description bgl1() {
  return read_model(OVERBEND_SOURCE_DIR "/examples/bgl1.yaml").description.value();
}

void bgl1_from_nothing(benchmark::State& state) {
  const Model model = build_model(bgl1());
  for (auto _ : state) {
    benchmark::DoNotOptimize(solve_statics(model));
  }
}
BENCHMARK(bgl1_from_nothing)->Unit(benchmark::kMillisecond);

void bgl1_hundred_tensions(benchmark::State& state) {
  Description d = bgl1();
  const StaticSolution first = solve_statics(build_model(d)).solution.value();
  int failures = 0;
  for (auto _ : state) {
    StaticSolution static_solution = first;
    for (int i = 0; i < 100; ++i) {
      d.tensioner.tension = 250e3 + 1e3 * i;
      const StaticOutcome outcome = solve_statics(build_model(d), &static_solution);
      failures += outcome.solution ? 0 : 1;
      static_solution = outcome.solution.value_or(static_solution);
    }
  }
  state.counters["failures"] = failures;
}
BENCHMARK(bgl1_hundred_tensions)->Unit(benchmark::kMillisecond);

/// One of them by itself, 1 kN on: without making the model.
void bgl1_one_tension_on(benchmark::State& state) {
  Description d = bgl1();
  const StaticSolution first = solve_statics(build_model(d)).solution.value();
  *d.tensioner.tension += 1e3;
  const Model next = build_model(d);
  for (auto _ : state) {
    benchmark::DoNotOptimize(solve_statics(next, &first));
  }
}
BENCHMARK(bgl1_one_tension_on)->Unit(benchmark::kMillisecond);

/// The same lay without its current, which the code checks ask for.
void bgl1_static_lay(benchmark::State& state) {
  const Model model = build_model(bgl1());
  const StaticSolution solution = solve_statics(model).solution.value();
  const Model at_rest = without_current(model);
  for (auto _ : state) {
    benchmark::DoNotOptimize(solve_still_water_lay(at_rest, solution));
  }
}
BENCHMARK(bgl1_static_lay)->Unit(benchmark::kMillisecond);

void bgl1_recovery(benchmark::State& state) {
  const Model model = build_model(bgl1());
  const StaticSolution solution = solve_statics(model).solution.value();
  for (auto _ : state) {
    benchmark::DoNotOptimize(recover_statics(model, solution));
  }
}
BENCHMARK(bgl1_recovery)->Unit(benchmark::kMillisecond);

/// From the parsed model, its derived properties included: with linear steel, and with steel that yields.
void with_steel(benchmark::State& state, const char* example, bool yields) {
  Description d = read_model(std::string(OVERBEND_SOURCE_DIR "/examples/") + example).description.value();
  if (yields) {
    d.pipe.section.steel.material.law = MaterialLaw::ramberg_osgood;
    d.pipe.section.steel.material.hardening_exponent = 25.0;
  }
  for (auto _ : state) {
    benchmark::DoNotOptimize(solve_statics(build_model(d)));
  }
}
BENCHMARK_CAPTURE(with_steel, bgl1_linear, "bgl1.yaml", false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(with_steel, bgl1_yields, "bgl1.yaml", true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(with_steel, as_printed_linear, "bgl1-as-printed.yaml", false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(with_steel, as_printed_yields, "bgl1-as-printed.yaml", true)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace overbend
