#include "mechanics/sea.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "base/constants.h"
#include "base/interruption.h"
#include "base/random.h"
#include "base/require.h"
#include "mechanics/record_components.h"
#include "mechanics/spectrum_directions.h"
#include "mechanics/wave_spreading.h"
#include "model/pipe/section.h"
#include "model/waves/wave_theory.h"

namespace overbend {
namespace {

constexpr std::size_t kColumns = 11;  // columns of the kernel's table

static_assert(sizeof(WaterState) == 8 * sizeof(double) && sizeof(Vec3) == 3 * sizeof(double),
              "the kernel writes states and reads points as plain doubles");

std::size_t padded(std::size_t count) {
  return (count + kLanes - 1) / kLanes * kLanes;
}

WaveView make_wave_view(const Sea& sea) {
  const std::size_t rows = padded(sea.components.size());
  const auto column = [&](std::size_t i) { return sea.table.data() + i * rows; };
  return {.count = static_cast<int>(rows),
          .depth = sea.depth,
          .amplitude = column(0),
          .omega = column(1),
          .wave_number = column(2),
          .kx = column(3),
          .ky = column(4),
          .phase = column(5),
          .speed = column(6),
          .echo = column(7),
          .ex = column(8),
          .ey = column(9),
          .head = column(10)};
}

void fill_table(Sea& sea) {
  const std::size_t rows = padded(sea.components.size());
  sea.table.assign(kColumns * rows, 0.0);
  for (std::size_t i = 0; i < sea.components.size(); ++i) {
    const WaveComponent& c = sea.components[i];
    const double echo = std::exp(-2.0 * c.wave_number * sea.depth);
    const double speed = c.amplitude * c.omega / -std::expm1(-2.0 * c.wave_number * sea.depth);
    const double columns[kColumns] = {c.amplitude,
                                      c.omega,
                                      c.wave_number,
                                      c.kx,
                                      c.ky,
                                      c.phase,
                                      speed,
                                      echo,
                                      c.kx / c.wave_number,
                                      c.ky / c.wave_number,
                                      c.omega / (c.wave_number * kGravity)};
    for (std::size_t column = 0; column < kColumns; ++column) sea.table[column * rows + i] = columns[column];
  }
  // The padding keeps the order by wave number.
  for (std::size_t i = sea.components.size(); i < rows; ++i) {
    sea.table[2 * rows + i] = sea.components.back().wave_number;
  }
}

/// Component of frequency omega travelling towards an azimuth.
WaveComponent travelling(double amplitude, double omega, double towards, double phase, double depth) {
  const double k = linear_wave_number(omega, depth);
  return {amplitude, omega, k, k * std::sin(towards), k * std::cos(towards), phase};
}

/// Returns the azimuth of travel; waves are specified by the direction they come from.
double travel_azimuth(const WavesDescription& waves) {
  return waves.from + std::numbers::pi;
}

void add_regular(Sea& sea, const WavesDescription& waves) {
  if (!(waves.height > 0.0) || !(waves.period > 0.0)) {
    throw std::invalid_argument("a regular wave needs a height and a period");
  }
  const double towards = travel_azimuth(waves);
  if (waves.type == WaveType::airy) {
    sea.components.push_back(travelling(0.5 * waves.height, kTurn / waves.period, towards, waves.phase, sea.depth));
    return;
  }
  sea.nonlinear = true;
  sea.stokes = stokes_wave(waves.height, waves.period, sea.depth, std::sin(towards), std::cos(towards), waves.phase);
  const StokesWave& s = sea.stokes;
  sea.components = {{s.elevation[0], s.omega, s.wave_number, s.kx, s.ky, s.phase}};
}

/// Components of equal energy, one from each slice of the spectrum's energy at a random frequency within it.
void add_random(Sea& sea, const WavesDescription& waves, std::uint64_t seed) {
  if (waves.components < 1) throw std::invalid_argument("a random sea needs at least one component");
  const WaveSpectrum spectrum(waves);
  Random random(seed);
  const int count = waves.components;
  const double amplitude = std::sqrt(2.0 * spectrum.variance() / count);
  const std::size_t first = sea.components.size();
  for (int i = 0; i < count; ++i) {
    const double omega = spectrum.quantile((i + random.uniform()) / count);
    const double phase = kTurn * random.uniform();
    sea.components.push_back(travelling(amplitude, omega, travel_azimuth(waves), phase, sea.depth));
  }
  if (!waves.spreading && waves.directions.empty()) return;
  const std::span<WaveComponent> components = std::span(sea.components).subspan(first);
  std::vector<double> azimuths;
  // Drawn last, so that the short-crested sea has the frequencies and phases of the long-crested one.
  if (waves.directions.empty()) {
    azimuths = spread_directions(*waves.spreading, count, random);
    for (double& azimuth : azimuths) azimuth = travel_azimuth(waves) + azimuth;
  } else {
    azimuths = component_azimuths(waves, components, random);
    for (double& azimuth : azimuths) azimuth += kPi;  // from that azimuth
  }
  for (std::size_t i = 0; i < components.size(); ++i) {
    const WaveComponent& c = components[i];
    components[i] = travelling(amplitude, c.omega, azimuths[i], c.phase, sea.depth);
  }
}

/// Fourier components of a measured elevation, which pass its point with the phases of the record.
void add_measured(Sea& sea, const WavesDescription& waves) {
  const double towards = travel_azimuth(waves);
  for (const RecordComponent& c : record_components(waves.record)) {
    WaveComponent wave = travelling(c.amplitude, c.omega, towards, 0.0, sea.depth);
    wave.phase = c.phase - wave.kx * waves.measured_at.x() - wave.ky * waves.measured_at.y();
    sea.components.push_back(wave);
  }
}

void add_group(Sea& sea, const WavesDescription& waves, std::uint64_t seed) {
  if (waves.type == WaveType::none) return;
  if (!(sea.depth > 0.0)) throw std::invalid_argument("waves need a water depth");
  if (sea.nonlinear || (waves.type == WaveType::stokes5 && !sea.calm())) {
    throw std::invalid_argument("a Stokes wave is not a sum of linear waves: it is the only wave of its sea");
  }
  if (is_regular(waves.type)) {
    add_regular(sea, waves);
  } else if (waves.type == WaveType::elevation) {
    add_measured(sea, waves);
  } else {
    add_random(sea, waves, seed);
  }
}

void sort_by_wave_number(Sea& sea) {
  std::stable_sort(sea.components.begin(), sea.components.end(),
                   [](const WaveComponent& a, const WaveComponent& b) { return a.wave_number < b.wave_number; });
}

/// Sums of squared amplitudes times phasors over a row of lags.
struct LagSums {
  static constexpr int kLags = 512;
  std::array<double, kLags> real{}, imaginary{};

  /// Adds lags from `lag` on in steps of `step` [s]. Each phasor is rotated from one lag to the next: rounding stays
  /// below 1e-12.
  void add(const WaveComponent& c, double lag, double step) {
    const double a2 = c.amplitude * c.amplitude;
    double re = a2 * std::cos(c.omega * lag), im = a2 * std::sin(c.omega * lag);
    const double turn_re = std::cos(c.omega * step), turn_im = std::sin(c.omega * step);
    for (std::size_t i = 0; i < kLags; ++i) {
      real[i] += re;
      imaginary[i] += im;
      const double before = re;
      re = re * turn_re - im * turn_im;
      im = before * turn_im + im * turn_re;
    }
  }
};

void stokes_state(const StokesWave& wave, double t, const BuildUp& build_up, const Vec3& point, WaterState& out) {
  out.elevation = build_up.value * elevation(wave, t, point.x(), point.y());
  const double z = std::clamp(point.z(), -wave.depth, std::max(out.elevation, -wave.depth));
  const WaveKinematics k = kinematics(wave, t, point.x(), point.y(), z);
  out.velocity = build_up.value * k.velocity;
  out.acceleration = build_up.value * k.acceleration + build_up.rate * k.velocity;
  out.pressure_head = build_up.value * k.pressure_head;
}

WaveSums wave_sums_for(Isa isa) {
#if defined(OVERBEND_X86_KERNELS)
  if (isa == Isa::avx512) return isa_avx512::sum_waves;
  if (isa == Isa::avx2) return isa_avx2::sum_waves;
#endif
  (void)isa;
  return isa_baseline::sum_waves;
}

WaveElevation wave_elevation_for(Isa isa) {
#if defined(OVERBEND_X86_KERNELS)
  if (isa == Isa::avx512) return isa_avx512::wave_elevation;
  if (isa == Isa::avx2) return isa_avx2::wave_elevation;
#endif
  (void)isa;
  return isa_baseline::wave_elevation;
}

}  // namespace

Sea make_sea(const WaveGroups& groups, double depth, std::uint64_t seed) {
  Sea sea;
  sea.depth = depth;
  for (std::size_t i = 0; i < groups.size(); ++i) add_group(sea, groups[i], group_seed(groups, i, seed));
  if (sea.calm()) return sea;
  if (groups.size() > 1) sort_by_wave_number(sea);  // those of one group are in order
  fill_table(sea);
  return sea;
}

Sea make_sea(const WavesDescription& waves, double depth, std::uint64_t seed) {
  return make_sea(WaveGroups{waves}, depth, seed);
}

Sea make_sea(std::vector<WaveComponent> components, double depth) {
  Sea sea;
  sea.depth = depth;
  sea.components = std::move(components);
  if (sea.calm()) return sea;
  for (WaveComponent& c : sea.components) {
    const double towards = std::atan2(c.kx, c.ky);
    c = travelling(c.amplitude, c.omega, towards, c.phase, depth);
  }
  sort_by_wave_number(sea);
  fill_table(sea);
  return sea;
}

double recurrence(const Sea& sea, double simulated_time) {
  double energy = 0.0, moment = 0.0;
  for (const WaveComponent& c : sea.components) {
    energy += c.amplitude * c.amplitude;
    moment += c.amplitude * c.amplitude * c.omega;
  }
  // A quarter of a period is a fine step for the envelope, which varies with the wave groups.
  const double step = 0.25 * kTurn * energy / moment;
  double max_correlation = 0.0;
  const auto last = static_cast<std::int64_t>(simulated_time / step);
  for (std::int64_t first = 120; first <= last; first += LagSums::kLags) {
    check_interruption();
    LagSums sums;
    for (const WaveComponent& c : sea.components) sums.add(c, step * static_cast<double>(first), step);
    const auto count = static_cast<std::size_t>(std::min<std::int64_t>(LagSums::kLags, last - first + 1));
    for (std::size_t i = 0; i < count; ++i) {
      max_correlation = std::max(max_correlation, std::hypot(sums.real[i], sums.imaginary[i]) / energy);
    }
  }
  return max_correlation;
}

void water_state(const Sea& sea, double t, const BuildUp& build_up, std::span<const Vec3> points,
                 std::span<WaterState> out) {
  require(points.size() == out.size(), "there are as many water states as points");
  if (points.empty()) return;
  if (sea.calm()) {
    std::fill(out.begin(), out.end(), WaterState{});
  } else if (sea.nonlinear) {
    for (std::size_t i = 0; i < points.size(); ++i) stokes_state(sea.stokes, t, build_up, points[i], out[i]);
  } else {
    static const WaveSums kSums = wave_sums_for(best_isa());
    kSums(make_wave_view(sea), {t, build_up.value, build_up.rate}, points[0].data(), static_cast<int>(points.size()),
          out[0].velocity.data());
  }
}

double elevation(const Sea& sea, double t, const BuildUp& build_up, double x, double y) {
  if (sea.calm()) return 0.0;
  if (sea.nonlinear) return build_up.value * elevation(sea.stokes, t, x, y);
  static const WaveElevation kElevation = wave_elevation_for(best_isa());
  return build_up.value * kElevation(make_wave_view(sea), t, x, y);
}

double spectral_density(const WavesDescription& waves, double omega) {
  if (!is_random(waves.type)) return 0.0;
  return WaveSpectrum(waves).density(omega);
}

double highest_frequency(const Sea& sea) {
  if (sea.calm()) return 0.0;
  // Frequency rises with the wave number.
  const double harmonics = sea.nonlinear ? 5.0 : 1.0;
  return harmonics * sea.components.back().omega;
}

}  // namespace overbend
