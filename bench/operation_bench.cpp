/// Operations on the line: all stages of an abandonment, results and code checks included.
#include <benchmark/benchmark.h>

#include <string>

#include "modelfile/reading/yaml_reader.h"
#include "study/stages/lay_operation.h"

namespace overbend {
namespace {

Description abandonment(StageTension tension) {
  Description d = read_model(OVERBEND_SOURCE_DIR "/examples/bgl1-abandonment.yaml").description.value();
  StageProgram program;
  program.from = 2.0;
  program.to = 400.0;
  program.steps = 50;
  program.tension = tension;
  program.values = {250e3, 200e3, 150e3, 120e3};
  program.limits.sagbend_stress = 150e6;
  d.operation.lay.program = program;
  return d;
}

void run_stages(benchmark::State& state, StageTension tension) {
  const Description d = abandonment(tension);
  int failures = 0;
  for (auto _ : state) {
    for (const StageResult& stage : solve_operation(d).stages) failures += stage.failure ? 1 : 0;
  }
  state.counters["failures"] = failures;
}

void bgl1_abandoned_in_51_stages(benchmark::State& state) {
  run_stages(state, StageTension::hold);
}
BENCHMARK(bgl1_abandoned_in_51_stages)->Unit(benchmark::kMillisecond);

void bgl1_abandoned_with_51_sought_tensions(benchmark::State& state) {
  run_stages(state, StageTension::seek);
}
BENCHMARK(bgl1_abandoned_with_51_sought_tensions)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace overbend
