/// The kernels that a step in time is made of, on the line of the BGL-1 example: elements, with and without tangent,
/// energies, factors and solutions.
#include <benchmark/benchmark.h>

#include "dynamics/setup/dynamic_setup.h"
#include "mechanics/quadrature.h"
#include "modelfile/reading/yaml_reader.h"
#include "numerics/block_tridiagonal.h"

namespace overbend {
namespace {

/// The line at its equilibrium, moving slowly.
struct MovingLine {
  Model model = build_model(read_model(OVERBEND_SOURCE_DIR "/examples/bgl1.yaml").description.value());
  StaticSolution solution = solve_statics(model).solution.value();
  System system = pipe_system(model, solution, model.description.tensioner.tension.value_or(3e5));
  const Line& line = system.lines.front();
  SystemState state = state_at_rest(system, {solution.state.q}, 0.0);
  std::vector<double> residual, cuts, water;
  AlignedDoubles slips;
  BlockTridiagonal tangent;

  MovingLine() {
    const std::size_t nodes = static_cast<std::size_t>(line.mesh.nodes());
    residual.assign(6 * nodes, 0.0);
    cuts = residual;
    water.assign(kWaterValues * nodes, 0.01);
    slips.assign(kGaussPoints * kBedDirections * line.elements.padded(), 0.0);
    tangent.resize(line.mesh.nodes());
    LineState& pipe = state.lines.front();
    set_initial_memories(line, solution, pipe);
    for (std::size_t i = 0; i < pipe.v.size(); ++i) pipe.v[i] = 0.01 * static_cast<double>(i % 7);
  }

  LineMotion motion() {
    const LineState& pipe = state.lines.front();
    LineMotion m;
    m.v = pipe.v.data();
    m.acc = pipe.acc.data();
    m.velocity_share = 40.0;
    m.acceleration_share = 1600.0;
    m.step = 0.05;
    m.water = water.data();
    m.bed_slip = pipe.bed_slip.data();
    m.bed_slip_next = slips.data();
    return m;
  }

  LineShape shape() const { return {state.lines.front().q.data(), nullptr}; }

  void evaluate(bool with_tangent) {
    LineTarget target{residual.data(), nullptr, nullptr, nullptr, cuts.data()};
    if (with_tangent) {
      tangent.set_zero();
      target.diag = tangent.diag(0);
      target.upper = tangent.upper(0);
      target.lower = tangent.lower(0);
    }
    add_line_forces(line.elements, line.environment, shape(), motion(), target, best_isa());
  }
};

void moving_forces(benchmark::State& state) {
  MovingLine moving_line;
  for (auto _ : state) {
    moving_line.evaluate(false);
    benchmark::DoNotOptimize(moving_line.residual.data());
  }
}
BENCHMARK(moving_forces)->Unit(benchmark::kMicrosecond);

void moving_forces_with_tangent(benchmark::State& state) {
  MovingLine moving_line;
  for (auto _ : state) {
    moving_line.evaluate(true);
    benchmark::DoNotOptimize(moving_line.residual.data());
  }
}
BENCHMARK(moving_forces_with_tangent)->Unit(benchmark::kMicrosecond);

void resting_forces(benchmark::State& state, bool with_tangent) {
  MovingLine moving_line;
  for (auto _ : state) {
    LineTarget target{moving_line.residual.data(), nullptr, nullptr, nullptr, moving_line.cuts.data()};
    if (with_tangent) {
      moving_line.tangent.set_zero();
      target.diag = moving_line.tangent.diag(0);
      target.upper = moving_line.tangent.upper(0);
      target.lower = moving_line.tangent.lower(0);
    }
    add_line_forces(moving_line.line.elements, moving_line.line.environment, moving_line.shape(), target, best_isa());
    benchmark::DoNotOptimize(moving_line.residual.data());
  }
}
BENCHMARK_CAPTURE(resting_forces, alone, false)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(resting_forces, with_tangent, true)->Unit(benchmark::kMicrosecond);

void energies(benchmark::State& state) {
  MovingLine moving_line;
  for (auto _ : state) {
    benchmark::DoNotOptimize(line_energy(moving_line.line.elements, moving_line.line.environment, moving_line.shape(),
                                         moving_line.motion(), best_isa()));
  }
}
BENCHMARK(energies)->Unit(benchmark::kMicrosecond);

/// The tangent must be made anew for every factorisation: its cost is that of moving_forces_with_tangent less.
void tangent_and_factors(benchmark::State& state) {
  MovingLine moving_line;
  for (auto _ : state) {
    moving_line.evaluate(true);
    benchmark::DoNotOptimize(solve(moving_line.tangent));
  }
}
BENCHMARK(tangent_and_factors)->Unit(benchmark::kMicrosecond);

void solution_with_factors(benchmark::State& state) {
  MovingLine moving_line;
  std::vector<double> dq(moving_line.residual.size(), 1.0);
  moving_line.evaluate(true);
  solve(moving_line.tangent);
  for (auto _ : state) {
    std::fill(dq.begin(), dq.end(), 1.0);
    resolve(moving_line.tangent, dq.data());
    benchmark::DoNotOptimize(dq.data());
  }
}
BENCHMARK(solution_with_factors)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace overbend
