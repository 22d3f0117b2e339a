#include "hull/hull_waves.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/constants.h"
#include "base/simd.h"
#include "hull/hull_waves_kernel.h"
#include "mechanics/sea_outside_range.h"
#include "model/pipe/section.h"

namespace overbend {
namespace {

constexpr std::size_t kColumns = 6;

/// Position between two rows of ascending frequencies; `weight` 0 beyond the last.
struct InFrequency {
  std::size_t low = 0, high = 0;
  double share = 0.0, weight = 1.0;
};

/// Constant below the first frequency; zero above the last.
InFrequency find_frequency(const std::vector<double>& omega, double w) {
  if (omega.empty() || w > omega.back()) return {0, 0, 0.0, 0.0};
  if (w <= omega.front()) return {0, 0, 0.0, 1.0};
  const auto high = static_cast<std::size_t>(std::upper_bound(omega.begin(), omega.end() - 1, w) - omega.begin());
  return {high - 1, high, (w - omega[high - 1]) / (omega[high] - omega[high - 1]), 1.0};
}

template <class Value>
Value in_frequency(const HeadingTable& table, const std::vector<Value>& values, const InFrequency& f,
                   std::size_t heading) {
  const Value &low = values[table.index(f.low, heading)], &high = values[table.index(f.high, heading)];
  return f.weight * ((1.0 - f.share) * low + f.share * high);
}

/// True if the gap from the last to the first heading is no wider than the others, so that values can be interpolated
/// in it.
bool closes_circle(const std::vector<double>& heading) {
  if (heading.size() < 3) return false;
  double widest = 0.0;
  for (std::size_t i = 1; i < heading.size(); ++i) widest = std::max(widest, heading[i] - heading[i - 1]);
  return heading.front() + kTurn - heading.back() < 1.5 * widest;
}

double to_circle(double angle) {
  return angle - kTurn * std::floor(angle / kTurn);
}

double component_direction(const WaveComponent& c) {
  return std::atan2(c.ky, c.kx);
}

/// Drift at a heading: headings of the drift may differ from those of the excitation.
Vec6 drift_at(const HydrodynamicData& data, const InFrequency& f, double heading) {
  const std::vector<double>& angles = data.drift.heading;
  const double a = to_circle(heading);
  std::size_t high = static_cast<std::size_t>(std::upper_bound(angles.begin(), angles.end(), a) - angles.begin());
  std::size_t low = high == 0 ? angles.size() - 1 : high - 1;
  if (high == angles.size()) high = closes_circle(angles) ? 0 : low;
  if (a < angles.front() && !closes_circle(angles)) low = high;
  const double gap = to_circle(angles[high] - angles[low]);
  const double share = gap > 0.0 ? to_circle(a - angles[low]) / gap : 0.0;
  return (1.0 - share) * in_frequency(data.drift, data.mean_drift, f, low) +
         share * in_frequency(data.drift, data.mean_drift, f, high);
}

/// a w integral over the draught T of cosh k(z + d) / sinh kd, divided by T.
double orbital_speed(const WaveComponent& c, double depth, double draught) {
  const double k = c.wave_number, whole = -std::expm1(-2.0 * k * depth);
  if (draught <= 0.0) return c.amplitude * c.omega * (2.0 - whole) / whole;
  // sinh k(d - T) / sinh kd without large numbers.
  const double below = -std::expm1(-2.0 * k * (depth - draught)) / whole * std::exp(-k * draught);
  return c.amplitude * c.omega * (1.0 - below) / (k * draught);
}

void require_heading(const HydrodynamicData& data, double relative) {
  const std::vector<double>& heading = data.excitation.heading;
  if (heading.size() == 1 || closes_circle(heading)) return;
  const double a = to_circle(relative), slack = 1e-6;
  const bool inside = (a > heading.front() - slack && a < heading.back() + slack) ||
                      (a - kTurn > heading.front() - slack) || (a + kTurn < heading.back() + slack);
  if (inside) return;
  const auto degrees = [](double angle) { return std::to_string(angle * 360.0 / kTurn); };
  throw std::invalid_argument("the wave forces in " + data.source + " are for headings from " +
                              degrees(heading.front()) + " to " + degrees(heading.back()) + " deg, waves run towards " +
                              degrees(a) + " deg from the bow anticlockwise");
}

std::size_t padded(std::size_t count) {
  return (count + kLanes - 1) / kLanes * kLanes;
}

void fill_component(HullWaves& waves, std::size_t i, const WaveComponent& c, double orbital) {
  const auto rows = static_cast<std::size_t>(waves.count);
  const double columns[kColumns] = {c.omega, c.kx, c.ky, c.phase, component_direction(c), orbital};
  for (std::size_t k = 0; k < kColumns; ++k) waves.components[k * rows + i] = columns[k];
}

void fill_rows(HullWaves& waves, std::size_t i, const WaveComponent& c, const HydrodynamicData& data) {
  const InFrequency f = find_frequency(data.excitation.omega, c.omega);
  const InFrequency of_drift = find_frequency(data.drift.omega, c.omega);
  for (std::size_t b = 0; b < waves.heading.size(); ++b) {
    double* row = waves.table.data() + (i * waves.heading.size() + b) * kHullWaveRow;
    const CVec6 force = c.amplitude * in_frequency(data.excitation, data.force, f, b);
    Eigen::Map<Vec6> real(row), imaginary(row + 8);
    real = force.real();
    imaginary = force.imag();
    if (waves.drift == WaveDrift::none) continue;
    const Vec6 drift = c.amplitude * c.amplitude * drift_at(data, of_drift, waves.heading[b]);
    row[16] = drift(0);
    row[17] = drift(1);
    row[18] = drift(5);
  }
}

HullWaveView make_view(const HullWaves& waves) {
  const auto column = [&](int k) { return waves.components.data() + static_cast<std::size_t>(k * waves.count); };
  return {.count = waves.count,
          .omega = column(0),
          .kx = column(1),
          .ky = column(2),
          .phase = column(3),
          .direction = column(4),
          .orbital = column(5),
          .headings = static_cast<int>(waves.heading.size()),
          .all_around = waves.all_around,
          .drift = waves.drift == WaveDrift::newman,
          .heading = waves.heading.data(),
          .table = waves.table.data()};
}

struct Kernels {
  HullWaveSums forces;
  HullStripSums strips;
};

Kernels select_kernels(Isa isa) {
#if defined(OVERBEND_X86_KERNELS)
  if (isa == Isa::avx512) return {isa_avx512::sum_hull_waves, isa_avx512::sum_strip_water};
  if (isa == Isa::avx2) return {isa_avx2::sum_hull_waves, isa_avx2::sum_strip_water};
#endif
  (void)isa;
  return {isa_baseline::sum_hull_waves, isa_baseline::sum_strip_water};
}

const Kernels& kernels() {
  static const Kernels kKernels = select_kernels(best_isa());
  return kKernels;
}

Vec6 horizontal(const double* surge_sway_yaw) {
  return (Vec6() << surge_sway_yaw[0], surge_sway_yaw[1], 0.0, 0.0, 0.0, surge_sway_yaw[2]).finished();
}

}  // namespace

HullWaves make_hull_waves(const HydrodynamicData& data, const Sea& sea, WaveDrift drift, double draught, double psi) {
  HullWaves waves;
  waves.drift = data.mean_drift.empty() ? WaveDrift::none : drift;
  if (sea.calm()) return waves;
  if (data.force.empty()) throw std::invalid_argument("there are no wave forces in " + data.source);
  waves.count = static_cast<int>(padded(sea.components.size()));
  waves.heading = data.excitation.heading;
  waves.all_around = closes_circle(waves.heading);
  const auto rows = static_cast<std::size_t>(waves.count);
  waves.components.assign(kColumns * rows, 0.0);
  waves.table.assign(rows * waves.heading.size() * kHullWaveRow, 0.0);
  for (std::size_t i = 0; i < rows; ++i) {
    const bool real = i < sea.components.size();
    const WaveComponent& c = real ? sea.components[i] : sea.components.back();
    fill_component(waves, i, c, real ? orbital_speed(c, sea.depth, draught) : 0.0);
    if (!real) continue;
    require_heading(data, component_direction(c) - psi);
    fill_rows(waves, i, c, data);
  }
  const SeaOutsideRange outside = sea_outside_range(sea, data.excitation.omega.front(), data.excitation.omega.back());
  waves.below_table = outside.below;
  waves.above_table = outside.above;
  if (waves.drift != WaveDrift::none) waves.above_drift = sea_outside_range(sea, 0.0, data.drift.omega.back()).above;
  return waves;
}

WaveForce wave_force(const HullWaves& waves, double t, const Vec3& slow) {
  WaveForce out;
  if (waves.empty()) return out;
  alignas(64) double sums[24];
  kernels().forces(make_view(waves), {t, slow.x(), slow.y(), slow.z()}, sums);
  out.first_order = Eigen::Map<const Vec6>(sums);
  out.drift = horizontal(sums + 8);
  out.mean_drift = horizontal(sums + 16);
  return out;
}

Vec6 mean_drift(const HullWaves& waves, double psi) {
  return wave_force(waves, 0.0, Vec3(0.0, 0.0, psi)).mean_drift;
}

StripWater strip_water(const HullWaves& waves, double t, const Vec3& slow, double first, double spacing) {
  StripWater water;
  if (waves.empty()) return water;
  kernels().strips(make_view(waves), {t, slow.x(), slow.y(), slow.z()}, first, spacing, kHullStrips, water.along.data(),
                   water.across.data());
  return water;
}

Mat6 wave_drift_damping(const HydrodynamicData& data, const Sea& sea, double psi) {
  Mat6 damping = Mat6::Zero();
  if (data.mean_drift.empty()) return damping;
  const double d = 0.01, last = data.drift.omega.back();  // difference of the frequencies for dD/dw [rad/s]
  for (const WaveComponent& c : sea.components) {
    if (c.omega > last) continue;
    const double direction = component_direction(c) - psi;
    const auto drift = [&](double w) { return drift_at(data, find_frequency(data.drift.omega, w), direction); };
    const double high = std::min(c.omega + d, last), low = c.omega - d;
    const Vec6 slope = (drift(high) - drift(low)) / (high - low);
    const Vec6 along =
        c.amplitude * c.amplitude * (4.0 * c.omega / kGravity * drift(c.omega) + c.omega * c.omega / kGravity * slope);
    damping.col(0) += std::cos(direction) * along;
    damping.col(1) += std::sin(direction) * along;
  }
  return damping;
}

}  // namespace overbend
