// Prints the results of the kernels that a run's recording calls.
#include "numbers.h"
#include "numerics/running_statistics_kernel.h"
#include "recording/design_screen_kernel.h"
#include "recording/node_recovery_kernel.h"

namespace overbend {
namespace {

using namespace isa_baseline;

/// An odd number of quantities, of which the last is absent at times.
void statistics(Numbers& numbers) {
  constexpr int kQuantities = 7, kSamples = 50;
  Batch low(kQuantities), high(kQuantities), mean(kQuantities), squares(kQuantities), weights(kQuantities),
      sample(kQuantities);
  const StatisticsView view{low.data(), high.data(), mean.data(), squares.data()};
  const auto present = [&](int i, int k) { return i % 3 != 0 || k + 1 < kQuantities; };
  for (int i = 0; i < kSamples; ++i) {
    sample.fill(numbers, -1.0, 2.0);
    for (int k = 0; k < kQuantities; ++k) {
      if (!present(i, k)) sample.data()[k] = __builtin_nan("");
    }
    if (all_finite(sample.data(), kQuantities) != present(i, kQuantities - 1)) std::printf("statistics_finite 1e300\n");
    add_samples(sample.data(), kQuantities - 1, {0.1, 1.0 / (1.0 + i)}, view);
    const int last = kQuantities - 1;
    add_present_samples(sample.data() + last, 1, 0.1, weights.data() + last,
                        {view.low + last, view.high + last, view.mean + last, view.squares + last});
  }
  low.print("statistics_low");
  high.print("statistics_high");
  mean.print("statistics_mean");
  squares.print("statistics_squares");
}

/// Load effects of a run of nodes, an odd number of them.
void screen(Numbers& numbers) {
  constexpr int kRun = 21;
  Arrays a(numbers, kRun, kRun);
  const auto vectors = [&] { return VectorsView{a.of(-1.0, 1.0), a.of(-1.0, 1.0), a.of(0.5, 1.0)}; };
  const EffectView effect{vectors(), vectors(), vectors(), vectors()};
  const LoadFactors factors[] = {{}, {1.2, 1.0, 0.7, 0.0}};
  const CombinationsView combinations{factors, 2};
  Batch functional(kRun), environmental(kRun), both(kRun), size(kRun), force(kRun), x(kRun), y(kRun), z(kRun),
      load(kRun), strain(kRun);
  const EffectParts parts{functional.data(), environmental.data(), both.data()};
  const ScreenKernels kernels = screen_kernels();
  kernels.split(effect, kRun, parts);
  kernels.sizes(combinations, parts, kRun, size.data());
  const double *at_rest = a.of(-1.0, 1.0), *present_value = a.of(-1.0, 1.0), *strains = a.of(0.1, 0.2);
  kernels.forces(combinations, at_rest, present_value, kRun, force.data());
  kernels.strain_vectors(effect.now, strains, kRun, x.data(), y.data(), z.data());
  const double* pressure = a.of(-0.5, 1.0);
  for (const bool first : {true, false}) {
    kernels.load_excess({0.8, 0.4, 0.3, a.of(0.0, 0.5)}, size.data(), force.data(), pressure, kRun, first, load.data());
    kernels.strain_excess({0.7, 0.9, 0.3, a.of(0.0, 0.5), a.of(0.0, 0.5)}, size.data(), pressure, kRun, first,
                          strain.data());
  }
  functional.print("screen_functional");
  environmental.print("screen_environmental");
  both.print("screen_both");
  size.print("screen_size");
  force.print("screen_force");
  x.print("screen_strain_x");
  z.print("screen_strain_z");
  load.print("screen_load_excess");
  strain.print("screen_strain_excess");
}

/// Nodes of a line, an odd number of them, and the results of the cuts.
void recovery(Numbers& numbers) {
  constexpr int kCount = 21;
  Arrays a(numbers, 6 * kCount, 6 * kCount);
  const NodeRows rows{a.of(0.1, 1.0), a.of(-1.0, 1.0)};
  Batch x(kCount), y(kCount), z(kCount), tx(kCount), ty(kCount), tz(kCount), bx(kCount), by(kCount), bz(kCount),
      tension(kCount), moment(kCount), vertical(kCount);
  recover_nodes(rows, kCount,
                {x.data(),
                 y.data(),
                 z.data(),
                 {tx.data(), ty.data(), tz.data()},
                 {bx.data(), by.data(), bz.data()},
                 tension.data(),
                 moment.data(),
                 vertical.data()});
  x.print("recovery_place_x");
  tz.print("recovery_tangent_z");
  by.print("recovery_bend_y");
  tension.print("recovery_tension");
  moment.print("recovery_moment");
  vertical.print("recovery_vertical");
}

}  // namespace

void print_recording(Numbers& numbers) {
  statistics(numbers);
  screen(numbers);
  recovery(numbers);
}

}  // namespace overbend
