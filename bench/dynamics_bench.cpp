/// Dynamics as ratios of simulated to wall time, on one core: the sagbend under a heaving top and the BGL-1 example in
/// its random sea with resolved impacts.
#include <benchmark/benchmark.h>

#include "modelfile/reading/yaml_reader.h"
#include "recording/run_dynamics.h"
#include "statics/recovery/recovery.h"

namespace overbend {
namespace {

/// Takes everything and keeps nothing.
class NoSink : public DynamicSink {
 public:
  void begin(const std::vector<HistoryColumn>& columns, const SnapshotSize& size) override {
    benchmark::DoNotOptimize(columns.size());
    benchmark::DoNotOptimize(size.stations);
  }
  void row(std::span<const double> values) override { benchmark::DoNotOptimize(values.data()); }
  void snapshot(double time, std::span<const double> values) override {
    benchmark::DoNotOptimize(time);
    benchmark::DoNotOptimize(values.data());
  }
  void impact(const Impact& impact) override { benchmark::DoNotOptimize(impact.peak_force); }
  void checkpoint(const DynamicCheckpoint& state) override { benchmark::DoNotOptimize(state.time); }
};

void run(benchmark::State& state, const std::string& file, double duration) {
  const Model model = build_model(read_model(std::string(OVERBEND_SOURCE_DIR) + file).description.value());
  const StaticSolution start = solve_statics(model).solution.value();
  const StaticResults statics = recover_statics(model, start);
  DynamicOptions options = dynamic_options(model);
  options.duration = duration;
  DynamicOutcome outcome;
  for (auto _ : state) {
    NoSink sink;
    outcome = run_dynamics(model, start, statics, options, sink, nullptr,
                           [](const DynamicProgress&) { return DynamicControl::go_on; });
    if (!outcome.results) {
      state.SkipWithError("the run did not end");
      return;
    }
  }
  const DynamicResults& r = *outcome.results;
  state.counters["real_time_ratio"] = r.run.real_time_ratio;
  state.counters["steps"] = static_cast<double>(r.run.steps);
  state.counters["iterations_per_step"] =
      static_cast<double>(r.run.newton_iterations) / static_cast<double>(r.run.steps);
  state.counters["factors_per_step"] = static_cast<double>(r.run.factorisations) / static_cast<double>(r.run.steps);
  state.counters["impacts"] = static_cast<double>(r.impact_count);
  state.counters["energy_drift"] = r.energy.drift();
  state.counters["elements"] = start.mesh.elements();
}

/// 600 m of pipe, 400 elements, steps of 0.1 s for 600 s.
void sagbend(benchmark::State& state) {
  run(state, "/bench/sagbend.yaml", 600.0);
}
BENCHMARK(sagbend)->Unit(benchmark::kMillisecond)->Iterations(1);

/// Hs 4 m on the beam, 200 components: the pipe leaves the stinger, as the run's warnings say.
void bgl1_storm(benchmark::State& state) {
  run(state, "/examples/bgl1.yaml", 600.0);
}
BENCHMARK(bgl1_storm)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace overbend
