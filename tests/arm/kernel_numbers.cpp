/// Prints what every kernel makes of made-up input, a name and a number a line: tools/arm_check.sh compares what two
/// machines print.
#include "numbers.h"

#include <cmath>
#include <cstdio>

#include "dynamics/integrator/motion_kernel.h"
#include "hull/hull_waves_kernel.h"
#include "mechanics/line_kernel.h"
#include "mechanics/roller_kernel.h"
#include "mechanics/wave_kernel.h"
#include "numerics/block_tridiagonal_kernel.h"
#include "numerics/line_border_kernel.h"

namespace overbend {
namespace {

using namespace isa_baseline;

constexpr int kNodes = 21;  // elements fill two batches and a half
constexpr int kElements = kNodes - 1, kPadded = 24, kWaves = 32;

struct Blocks {
  Batch diag{kNodes * kBlockSize}, upper{kNodes * kBlockSize}, lower{kNodes * kBlockSize};
  BlockView view() const { return {kNodes, kNodes / 2, diag.data(), upper.data(), lower.data()}; }
  void print(const char* name) const {
    diag.print(name);
    upper.print(name);
    lower.print(name);
  }
};

/// With heavy entries on the diagonal, or across it so that rows are exchanged.
Blocks random_blocks(Numbers& numbers, bool across) {
  Blocks blocks;
  for (int index = 0; index < kNodes * kBlockSize; ++index) {
    const int row = index % kBlockSize / kRowWidth, column = index % kRowWidth;
    const bool coupled = column < kNodeDofs;
    blocks.diag.data()[index] = numbers.between(-1.0, 1.0) + (column == (across ? 5 - row : row) ? 9.0 : 0.0);
    blocks.upper.data()[index] = coupled ? numbers.between(-1.0, 1.0) : 0.0;
    blocks.lower.data()[index] = coupled ? numbers.between(-1.0, 1.0) : 0.0;
  }
  return blocks;
}

void blocks_and_borders(Numbers& numbers, bool across) {
  Blocks solved = random_blocks(numbers, across);
  const BlockSolveReport report = solve_blocks(solved.view());
  std::printf("report %d\nreport %d\n", report.singular_node, report.negative_blocks);
  solved.print("solve_blocks");
  Blocks factored = random_blocks(numbers, across);
  factor_blocks(factored.view(), 0);
  Batch x(kNodes * kNodeDofs);
  x.fill(numbers, -1.0, 1.0);
  resolve_blocks(factored.view(), x.data());
  x.print("resolve_blocks");

  const int stride = 8, panel = kNodeDofs * stride;
  std::vector<int> slot(kNodes, -1);
  slot[3] = 0;
  slot[4] = 1;
  slot[9] = 2;
  Batch values(3 * panel), w(kNodes * panel), product(stride * stride), along(stride);
  values.fill(numbers, -1.0, 1.0);
  const SparsePanelView border{slot.data(), values.data(), 3, 9, stride};
  solve_panel(factored.view(), border, w.data());
  w.print("solve_panel");
  panel_product(border, w.data(), product.data());
  product.print("panel_product");
  panel_times_vector(border, x.data(), along.data());
  along.print("panel_times_vector");
  subtract_columns(kNodes, stride, w.data(), along.data(), x.data());
  x.print("subtract_columns");
}

LineView pipe(Arrays& a) {
  LineView line;
  line.count = kElements;
  line.length = a.of(1.0, 2.0, 1.0);
  line.EA = a.of(2e6, 3e6);
  line.EI = a.of(2e4, 3e4);
  line.compression = a.of(0.0, 1.0, 1.0);
  line.damping = a.of(0.0, 1e-3, 1e-3);
  line.weight = a.of(900.0, 1000.0);
  line.buoyancy = a.of(700.0, 800.0);
  line.radius = a.of(0.16, 0.2, 0.1);
  line.drag_normal = a.of(150.0, 250.0);
  line.drag_axial = a.of(5.0, 10.0);
  line.pressure_constant = a.of(1e3, 2e3);
  line.pressure_slope = a.of(10.0, 20.0);
  line.pressure_external = a.of(5.0, 10.0);
  line.mass = a.of(90.0, 100.0);
  line.displaced_mass = a.of(70.0, 80.0);
  line.added_normal = a.of(70.0, 80.0);
  line.added_axial = a.of(1.0, 2.0);
  line.drag_on_bed = a.of(-0.5, -0.4);
  return line;
}

/// A line from above the water down onto the bed: position and tangent of every node.
Batch suspended_batch(Numbers& numbers, double top) {
  Batch q(kNodes * kNodeDofs);
  for (int n = 0; n < kNodes; ++n) {
    double* node_dofs = q.data() + n * kNodeDofs;
    node_dofs[0] = 1.2 * n + numbers.between(-0.01, 0.01);
    node_dofs[1] = numbers.between(-0.05, 0.05);
    node_dofs[2] = top - 0.8 * n;  // no node at a kink of the current, where rounding would decide
    node_dofs[3] = 0.8 + numbers.between(-0.02, 0.02);
    node_dofs[4] = numbers.between(-0.02, 0.02);
    node_dofs[5] = -0.6 + numbers.between(-0.02, 0.02);
  }
  return q;
}

void lines(Numbers& numbers, int soil) {
  Arrays a(numbers, kElements, kPadded);
  const LineView line = pipe(a);
  const double current_z[] = {-20.0, -5.0, 0.0}, vx[] = {0.1, 0.4, 0.9}, vy[] = {0.3, 0.2, -0.2};
  LineEnvironment env;
  env.bed_offset = -10.0;
  env.bed_stiffness = 1e4;
  env.bed_friction_lateral = 0.5;
  env.bed_friction_axial = 0.3;
  env.bed_stick = 3e3;
  env.bed_soil = soil;
  env.bed_bearing = 4e3;
  env.bed_damping = 500.0;
  env.current_rows = 3;
  env.current_z = current_z;
  env.current_vx = vx;
  env.current_vy = vy;
  const Batch q = suspended_batch(numbers, 4.07);
  Blocks tangent, moving_tangent;
  Batch residual(kNodes * kNodeDofs), cuts(kNodes * kNodeDofs), moving(kNodes * kNodeDofs);
  const LineShape shape{q.data(), nullptr};
  add_line_forces(line, env, shape,
                  {residual.data(), tangent.diag.data(), tangent.upper.data(), tangent.lower.data(), cuts.data()});
  residual.print("line_forces");
  cuts.print("line_cuts");
  tangent.print("line_tangent");

  Batch v(kNodes * kNodeDofs), acc(kNodes * kNodeDofs), water(kNodes * kWaterValues);
  Batch slip(8 * kBedDirections * kPadded), slip_next(8 * kBedDirections * kPadded);
  const LineMotion motion{v.fill(numbers, -1.0, 1.0).data(),
                          acc.fill(numbers, -1.0, 1.0).data(),
                          40.0,
                          1600.0,
                          0.05,
                          water.fill(numbers, -0.3, 0.3).data(),
                          slip.fill(numbers, -0.1, 0.1).data(),
                          slip_next.data()};
  add_moving_line_forces(
      line, env, shape, motion,
      {moving.data(), moving_tangent.diag.data(), moving_tangent.upper.data(), moving_tangent.lower.data(), nullptr});
  moving.print("moving_forces");
  moving_tangent.print("moving_tangent");
  slip_next.print("bed_slip");
  LineEnergy e;
  LineTarget energies;
  energies.energy = &e;
  add_moving_line_forces(line, env, shape, motion, energies);
  for (const double value : {e.kinetic, e.strain, e.gravity, e.seabed, e.fluid_power, e.seabed_loss}) {
    std::printf("line_energy %.17g\n", value);
  }
}

/// Steel that has yielded, some sections of it within their elastic range.
void held_sections(Numbers& numbers) {
  Arrays a(numbers, kElements, kPadded);
  const LineView line = pipe(a);
  const Batch q = suspended_batch(numbers, 4.07);
  const double low[kHeldValues] = {0.79, -0.01, -0.61, -0.01, 0.99, -0.01, -0.1, -0.1, -0.1, -5e4, -5e4, 0.0};
  const double high[kHeldValues] = {0.81, 0.01, -0.59, 0.01, 1.01, 0.01, 0.1, 0.1, 0.4, 5e4, 5e4, 1e3};
  constexpr int kPoints = 4;
  Batch values(kPoints * kHeldValues * kPadded), after(kPoints * kHeldValues * kPadded), left(kPoints * kPadded),
      stored(kLanes), velocities_at_rest(kNodes * kNodeDofs), residual(kNodes * kNodeDofs);
  for (int i = 0; i < kPoints * kHeldValues; ++i) {
    for (int e = 0; e < kPadded; ++e) {
      values.data()[i * kPadded + e] = numbers.between(low[i % kHeldValues], high[i % kHeldValues]);
    }
  }
  const HeldSections held{values.data(), after.data(), left.data(), stored.data()};
  Batch slip(8 * kBedDirections * kPadded), slip_next(8 * kBedDirections * kPadded);
  LineMotion motion{velocities_at_rest.data(), velocities_at_rest.data(), 0.0, 0.0, 0.0, nullptr, slip.data(),
                    slip_next.data()};
  motion.held = &held;
  Blocks tangent;
  add_moving_line_forces(line, {}, {q.data(), nullptr}, motion,
                         {residual.data(), tangent.diag.data(), tangent.upper.data(), tangent.lower.data(), nullptr});
  residual.print("held_forces");
  tangent.print("held_tangent");
  after.print("held_after");
  left.print("held_left");
  double sum = 0.0;  // lanes are as many as the instruction set has
  for (int l = 0; l < kLanes; ++l) sum += stored.data()[l];
  std::printf("held_stored %.17g\n", sum);
}

void waves(Numbers& numbers) {
  Arrays a(numbers, kWaves - 3, kWaves);
  Batch k(kWaves), echo(kWaves);
  constexpr double kDeeper = 0.16863815;  // exp(-2 k d) of the first of them, at 89 m
  for (int i = 0; i < kWaves; ++i) {
    k.data()[i] = 0.01 + 0.01 * i;  // rising, as the kernel wants them
    echo.data()[i] = (i > 0 ? echo.data()[i - 1] : 1.0) * kDeeper;
  }
  const WaveView sea{kWaves,          89.0,
                     a.of(0.0, 0.3),  a.of(0.4, 1.6),
                     k.data(),        a.of(-0.2, 0.2),
                     a.of(-0.2, 0.2), a.of(-3.0, 3.0),
                     a.of(0.0, 0.3),  echo.data(),
                     a.of(-1.0, 1.0), a.of(-1.0, 1.0),
                     a.of(0.5, 2.0)};
  constexpr int kPoints = 11;
  Batch points(3 * kPoints), out(8 * kPoints);
  for (int i = 0; i < kPoints; ++i) {
    points.data()[3 * i] = numbers.between(-200.0, 200.0);
    points.data()[3 * i + 1] = numbers.between(-50.0, 50.0);
    points.data()[3 * i + 2] = 1.0 - 9.0 * i;
  }
  sum_waves(sea, {812.3, 0.9, 0.05}, points.data(), kPoints, out.data());
  out.print("sum_waves");
  std::printf("wave_elevation %.17g\n", wave_elevation(sea, 812.3, 15.0, -4.0));
}

void responses(Numbers& numbers) {
  constexpr int kAhead = 27;
  Arrays a(numbers, kWaves - 3, kWaves);
  ResponseView vessel{kWaves, a.of(0.4, 1.6), {}};
  for (const double*& part : vessel.parts) {
    part = a.of(-0.3, 0.3);
  }
  Batch out(18);
  sum_responses(vessel, {812.3, 40.0, 0.4, 0.01, a.of(-0.2, 0.2), kAhead}, out.data());
  out.print("sum_responses");
}

/// Rollers under a line, some of them passed beyond their ends.
void rollers(Numbers& numbers) {
  constexpr int kRollers = 19;
  const Batch q = suspended_batch(numbers, 4.07);
  Batch v(kNodes * kNodeDofs), length(kElements), places(9 * kRollers);
  v.fill(numbers, -1.0, 1.0);
  length.fill(numbers, 1.4, 1.5);
  RollerSearch looks[kRollers];
  for (int i = 0; i < kRollers; ++i) {
    double* node_dofs = places.data() + 9 * i;
    const double along = i + 0.2, lean = numbers.between(-0.1, 0.1);
    const double placed[] = {1.2 * along,
                             numbers.between(-0.5, 0.5),
                             3.8 - 0.8 * along,
                             0.0,
                             __builtin_sqrt(1.0 - lean * lean),
                             lean,
                             0.0,
                             -lean,
                             __builtin_sqrt(1.0 - lean * lean)};
    for (int k = 0; k < 9; ++k) {
      node_dofs[k] = placed[k];
    }
    looks[i] = {node_dofs, node_dofs + 3, node_dofs + 6, 0.3, 0.5, i, i};
  }
  RollerClosestPoint meetings[kRollers];
  find_closest_points({q.data(), v.data(), length.data()}, looks, kRollers, meetings);
  for (const RollerClosestPoint& met : meetings) {
    std::printf("roller_found %d\nroller_beyond %d\n", met.found, met.beyond_face);
    for (const double value : {met.xi, met.off_end, met.distance}) {
      std::printf("roller %.17g\n", met.found ? value : 0.0);
    }
    for (int k = 0; k < 3; ++k) {
      std::printf("roller_place %.17g\nroller_velocity %.17g\nroller_direction %.17g\n", met.found ? met.place[k] : 0.0,
                  met.found ? met.velocity[k] : 0.0, met.found ? met.direction[k] : 0.0);
    }
  }
}

void hull(Numbers& numbers) {
  constexpr int kHeadings = 5;
  Arrays a(numbers, kWaves, kWaves);
  const double heading[kHeadings] = {-3.0, -1.5, 0.0, 1.5, 3.0};
  Batch table(kWaves * kHeadings * kHullWaveRow);
  const HullWaveView sea{kWaves,          a.of(0.4, 1.6),
                         a.of(-0.2, 0.2), a.of(-0.2, 0.2),
                         a.of(-3.0, 3.0), a.of(-1.5, 1.5),
                         a.of(0.0, 0.3),  kHeadings,
                         false,           true,
                         heading,         table.fill(numbers, -1.0, 1.0).data()};
  Batch out(3 * kLanes), along(kLanes), across(kLanes);
  sum_hull_waves(sea, {812.3, 5.0, -2.0, 0.1}, out.data());
  out.print("sum_hull_waves");
  sum_strip_water(sea, {812.3, 5.0, -2.0, 0.1}, -50.0, 15.0, 8, along.data(), across.data());
  along.print("strip_along");
  across.print("strip_across");
}

void freedoms(Numbers& numbers) {
  constexpr int kFreedoms = kNodes * kNodeDofs;
  Arrays a(numbers, kFreedoms, kFreedoms);
  const FreedomsAtStart freedoms_before{a.of(-1.0, 1.0), a.of(-1.0, 1.0), a.of(-1.0, 1.0), a.of(-1.0, 1.0)};
  Batch q(kFreedoms), v(kFreedoms), acc(kFreedoms), algorithmic_acceleration(kFreedoms);
  const FreedomsView next{kFreedoms, q.data(), v.data(), acc.data()};
  predict_freedoms({0.1, 0.004, 0.001, 0.07, 0.03, 1.5, -0.5}, freedoms_before, next);
  correct_freedoms({30.0, 400.0}, a.of(-1e-3, 1e-3), next);
  const ChangeSums sums =
      end_freedoms({0.8, 0.4, -0.2}, freedoms_before, kFreedoms, acc.data(), algorithmic_acceleration.data());
  q.print("freedoms_q");
  v.print("freedoms_v");
  acc.print("freedoms_acc");
  algorithmic_acceleration.print("freedoms_alg");
  std::printf("freedoms_change %.17g\nfreedoms_change %.17g\n", sums.product, sums.square);
}

}  // namespace
}  // namespace overbend

int main() {
  overbend::Numbers numbers;
  for (const bool across : {false, true}) {
    overbend::blocks_and_borders(numbers, across);
  }
  for (const int soil : {0, 1, 2}) {
    overbend::lines(numbers, soil);
  }
  overbend::held_sections(numbers);
  overbend::waves(numbers);
  overbend::responses(numbers);
  overbend::rollers(numbers);
  overbend::hull(numbers);
  overbend::freedoms(numbers);
  overbend::print_recording(numbers);
}
