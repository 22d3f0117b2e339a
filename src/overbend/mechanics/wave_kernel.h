/// Sums of linear waves over their components. Compiled once per instruction set; raw pointers only, so that no inline
/// function of another header is compiled for an instruction set that the machine may lack.
#pragma once

namespace overbend {

/// Components by rising wave number, one array per quantity, padded to whole batches of eight with components of zero
/// amplitude.
struct WaveView {
  int count = 0;  ///< Including padding.
  double depth = 0.0;
  const double *amplitude, *omega, *wave_number, *kx, *ky, *phase;
  const double* speed;    ///< a omega / (1 - exp(-2 k d)) [m/s]
  const double* echo;     ///< exp(-2 k d)
  const double *ex, *ey;  ///< Direction of travel.
  const double* head;     ///< Phase speed over gravity: head of the dynamic pressure per horizontal velocity [s].
};

/// Responses to the components of a sea in six freedoms, one array per quantity, padded to whole batches of eight with
/// zero responses.
struct ResponseView {
  int count = 0;  ///< Including padding.
  const double* omega = nullptr;
  const double* parts[12];  ///< Real and imaginary part of the amplitude, freedom by freedom.
};

/// Time, and distance, speed and acceleration of the vessel's move ahead.
struct ResponseInstant {
  double t = 0.0, distance = 0.0, speed = 0.0, acceleration = 0.0;
  /// Wave numbers ahead of the first `waves` responses [1/m]; the others do not belong to waves.
  const double* wave_number = nullptr;
  int waves = 0;
};

/// `out` receives value, rate and acceleration of each of the six freedoms.
using ResponseSums = void (*)(const ResponseView& responses, const ResponseInstant& instant, double* out);

/// Time and build-up.
struct WaveInstant {
  double t = 0.0, factor = 1.0, factor_rate = 0.0;
};

/// Components with larger k |z| are neglected at depth: at 9 the motion has decayed to e^-9 = 1.2e-4.
inline constexpr double kWaveReach = 9.0;

/// `out` receives eight doubles per point: velocity, acceleration, elevation, head of the dynamic pressure; `points`
/// has x, y, z of each.
using WaveSums = void (*)(const WaveView& waves, const WaveInstant& instant, const double* points, int count,
                          double* out);
/// Elevation at one point without build-up.
using WaveElevation = double (*)(const WaveView& waves, double t, double x, double y);

namespace isa_baseline {
void sum_waves(const WaveView& waves, const WaveInstant& instant, const double* points, int count, double* out);
double wave_elevation(const WaveView& waves, double t, double x, double y);
void sum_responses(const ResponseView& responses, const ResponseInstant& instant, double* out);
}  // namespace isa_baseline
namespace isa_avx2 {
void sum_waves(const WaveView& waves, const WaveInstant& instant, const double* points, int count, double* out);
double wave_elevation(const WaveView& waves, double t, double x, double y);
void sum_responses(const ResponseView& responses, const ResponseInstant& instant, double* out);
}  // namespace isa_avx2
namespace isa_avx512 {
void sum_waves(const WaveView& waves, const WaveInstant& instant, const double* points, int count, double* out);
double wave_elevation(const WaveView& waves, double t, double x, double y);
void sum_responses(const ResponseView& responses, const ResponseInstant& instant, double* out);
}  // namespace isa_avx512

}  // namespace overbend
