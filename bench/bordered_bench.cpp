/// A line of 450 nodes with borders of several widths: a held ship (0), a far force (1), a free hull with winches
/// (8), bodies and machines (32). Border rows stand at 40 nodes, as where rollers touch.
#include <benchmark/benchmark.h>

#include <random>

#include "numerics/bordered_system.h"

namespace overbend {
namespace {

constexpr int kNodes = 450;

/// A line and its border, kept to be put in afresh before each elimination.
struct Line {
  BlockTridiagonal blocks{kNodes};
  BorderedSystem system;
  std::vector<double> x = std::vector<double>(6 * kNodes, 1.0);
  std::vector<double> y;

  explicit Line(int width) : y(static_cast<std::size_t>(width), 1.0) {
    BorderedLine shape{kNodes, {}};
    for (int i = 0; i < width; ++i) {
      shape.unknowns.push_back(i);
    }
    system = BorderedSystem({shape}, width);
    std::mt19937_64 generator(1);
    std::normal_distribution<double> normal;
    for (int n = 0; n < kNodes; ++n) {
      for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
          blocks.diag(n)[i * kRowWidth + j] = normal(generator) + (i == j ? 20.0 : 0.0);
          // strong enough that nothing dies away along the line to numbers so small that they are slow
          blocks.upper(n)[i * kRowWidth + j] = 3.0 * normal(generator);
          blocks.lower(n)[i * kRowWidth + j] = 3.0 * normal(generator);
        }
        for (int j = 0; j < width && n >= kNodes - 40; ++j) {
          system.columns(0, n)[i * system.stride(0) + j] = normal(generator);
          system.rows(0, n)[i * system.stride(0) + j] = normal(generator);
        }
      }
    }
    for (int i = 0; i < width; ++i) {
      system.corner(i, i) = 1e3;
    }
  }

  void put_in_afresh() { system.line(0).copy_from(blocks, 0); }
  void solve() {
    double* const lines[] = {x.data()};
    system.solve(lines, y.data());
  }
};

void factor_border(benchmark::State& state) {
  Line line(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    line.put_in_afresh();
    benchmark::DoNotOptimize(line.system.factor().solved());
  }
}
BENCHMARK(factor_border)->Arg(0)->Arg(1)->Arg(8)->Arg(32)->Unit(benchmark::kMicrosecond);

void solve_border(benchmark::State& state) {
  Line line(static_cast<int>(state.range(0)));
  line.put_in_afresh();
  line.system.factor();
  for (auto _ : state) {
    line.solve();
    benchmark::DoNotOptimize(line.x.data());
  }
}
BENCHMARK(solve_border)->Arg(0)->Arg(1)->Arg(8)->Arg(32)->Unit(benchmark::kMicrosecond);

/// One Newton step of statics.
void factor_and_solve_border(benchmark::State& state) {
  Line line(static_cast<int>(state.range(0)));
  double* const lines[] = {line.x.data()};
  for (auto _ : state) {
    line.put_in_afresh();
    benchmark::DoNotOptimize(line.system.factor_and_solve(lines, line.y.data()).solved());
  }
}
BENCHMARK(factor_and_solve_border)->Arg(0)->Arg(1)->Arg(8)->Arg(32)->Unit(benchmark::kMicrosecond);

/// The same by the line alone, its second right-hand side the column of one shared unknown.
void solve_line_alone(benchmark::State& state) {
  Line line(0);
  BlockTridiagonal system = line.blocks;
  for (auto _ : state) {
    system.copy_from(line.blocks, 0);
    benchmark::DoNotOptimize(solve(system).solved());
  }
}
BENCHMARK(solve_line_alone)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace overbend
