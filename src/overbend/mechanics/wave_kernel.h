/// Sums of linear waves over their components. Compiled once per instruction set; raw pointers only, so that no inline
/// function of another header is compiled for an instruction set that the machine may lack.
#pragma once

namespace overbend {

/// Components by rising wave number, one array per quantity, padded to whole batches of eight with components of no
/// amplitude.
struct WaveView {
  int count = 0;  ///< With the padding.
  double depth = 0.0;
  const double *amplitude, *omega, *wave_number, *kx, *ky, *phase;
  const double* speed;    ///< a omega / (1 - exp(-2 k d)) [m/s]
  const double* echo;     ///< exp(-2 k d)
  const double *ex, *ey;  ///< Direction of travel.
  const double* head;     ///< Phase speed over gravity: head of the dynamic pressure per horizontal velocity [s].
};

/// Responses to the components of a sea in six freedoms, one array per quantity, filled up to whole batches of eight
/// with responses of nothing.
struct ResponseView {
  int count = 0;  ///< With what it is filled up with.
  const double* omega = nullptr;
  const double* parts[12];  ///< Real and imaginary part of the amplitude, freedom by freedom.
};

/// Time, and how far, how fast and with what acceleration the vessel has moved ahead.
struct ResponseInstant {
  double t = 0.0, way = 0.0, speed = 0.0, acceleration = 0.0;
  const double* wave_number = nullptr;  ///< Ahead, of the first `waves` responses [1/m]; the others are of no wave.
  int waves = 0;
};

/// `out` gets value, rate and acceleration of each of the six freedoms.
using ResponseSums = void (*)(const ResponseView& responses, const ResponseInstant& at, double* out);

/// Time and build-up.
struct WaveInstant {
  double t = 0.0, factor = 1.0, factor_rate = 0.0;
};

/// Components for which k |z| is larger are neglected at depth: at 9 the motion has decayed to e^-9 = 1.2e-4.
inline constexpr double kWaveReach = 9.0;

/// `out` gets eight doubles a point: velocity, acceleration, elevation, head of the dynamic pressure; `points` has x,
/// y, z of each.
using WaveSums = void (*)(const WaveView& waves, const WaveInstant& at, const double* points, int count, double* out);
/// Elevation at one place without build-up.
using WaveElevation = double (*)(const WaveView& waves, double t, double x, double y);

namespace isa_baseline {
void sum_waves(const WaveView& waves, const WaveInstant& at, const double* points, int count, double* out);
double wave_elevation(const WaveView& waves, double t, double x, double y);
void sum_responses(const ResponseView& responses, const ResponseInstant& at, double* out);
}  // namespace isa_baseline
namespace isa_avx2 {
void sum_waves(const WaveView& waves, const WaveInstant& at, const double* points, int count, double* out);
double wave_elevation(const WaveView& waves, double t, double x, double y);
void sum_responses(const ResponseView& responses, const ResponseInstant& at, double* out);
}  // namespace isa_avx2
namespace isa_avx512 {
void sum_waves(const WaveView& waves, const WaveInstant& at, const double* points, int count, double* out);
double wave_elevation(const WaveView& waves, double t, double x, double y);
void sum_responses(const ResponseView& responses, const ResponseInstant& at, double* out);
}  // namespace isa_avx512

}  // namespace overbend
