#include "mechanics/wave_kernel.h"

#include "base/lane_transpose.h"
#include "mechanics/lane_vectors.h"
#include "mechanics/wave_functions.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

/// Number of components whose sine and cosine are kept from the surface to the kinematics; with more they are
/// recomputed.
constexpr int kKept = 1024;

constexpr int kPointValues = 8;  ///< Values per point, see WaveSums.

struct Phases {
  alignas(64) double sine[kKept], cosine[kKept];
};

struct Place {
  double t, x, y, z;
};

inline const Lanes& lanes(const double* from, int i) {
  return *reinterpret_cast<const Lanes*>(from + i);
}
inline Lanes& lanes(double* to, int i) {
  return *reinterpret_cast<Lanes*>(to + i);
}

inline double total(const Lanes& values) {
  double sum = 0.0;
  for (int i = 0; i < kWidth; ++i) sum += values[i];
  return sum;
}

inline void find_phase(const WaveView& waves, const Place& place, int i, Lanes& sine, Lanes& cosine) {
  const Lanes phase = (lanes(waves.phase, i) - lanes(waves.omega, i) * place.t) + lanes(waves.kx, i) * place.x +
                      lanes(waves.ky, i) * place.y;
  sine_cosine(phase, sine, cosine);
}

/// Returns the elevation and stores the phases.
double surface(const WaveView& waves, const Place& place, Phases& phases) {
  Lanes sum{};
  for (int i = 0; i < waves.count; i += kWidth) {
    Lanes sine, cosine;
    find_phase(waves, place, i, sine, cosine);
    if (i < kKept) {
      lanes(phases.sine, i) = sine;
      lanes(phases.cosine, i) = cosine;
    }
    sum += lanes(waves.amplitude, i) * cosine;
  }
  return total(sum);
}

/// Returns the number of components, rounded up to whole registers, that reach down to z.
int reaching(const WaveView& waves, double z) {
  int low = 0, high = waves.count;
  while (low < high) {
    const int middle = (low + high) / 2;
    if (-waves.wave_number[middle] * z < kWaveReach) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  const int full = (low + kWidth - 1) / kWidth * kWidth;
  return full < waves.count ? full : waves.count;
}

/// Computes velocity, acceleration, a slot for the elevation and pressure head at the height z of linear theory: -depth
/// to 0.
void sum_kinematics(const WaveView& waves, const Place& place, const Phases& phases, double* out) {
  Lanes sums[kPointValues] = {};
  Lanes &u = sums[0], &v = sums[1], &w = sums[2], &u_t = sums[3], &v_t = sums[4], &w_t = sums[5], &head = sums[7];
  const int count = reaching(waves, place.z);
  for (int i = 0; i < count; i += kWidth) {
    Lanes sine, cosine;
    if (i < kKept) {
      sine = lanes(phases.sine, i);
      cosine = lanes(phases.cosine, i);
    } else {
      find_phase(waves, place, i, sine, cosine);
    }
    Lanes depth = lanes(waves.wave_number, i) * place.z;
    depth = depth < -30.0 ? Lanes{} - 30.0 : depth;  // the last register may hold components that do not reach
    const Exponentials grown = exponentials(depth);
    const Lanes down = grown.down, echo = lanes(waves.echo, i) * grown.up;
    const Lanes speed = lanes(waves.speed, i), omega = lanes(waves.omega, i);
    const Lanes across = speed * (down + echo), up = speed * (down - echo);
    const Lanes forward = across * cosine, forward_rate = across * sine * omega;
    u += lanes(waves.ex, i) * forward;
    v += lanes(waves.ey, i) * forward;
    w += up * sine;
    u_t += lanes(waves.ex, i) * forward_rate;
    v_t += lanes(waves.ey, i) * forward_rate;
    w_t -= up * cosine * omega;
    head += lanes(waves.head, i) * forward;
  }
  for (int first = 0; first < kPointValues; first += kWidth) {
    Lanes rows[kWidth];
    for (int i = 0; i < kWidth; ++i) rows[i] = sums[first + i];
    unaligned(out + first) = row_sums(rows);
  }
}

/// Wheeler stretching: maps the column from seabed to surface onto the column from seabed to still water of linear
/// theory.
double stretched(double z, double elevation, double depth) {
  // An elevation below the seabed is unphysical; the limit keeps the values finite.
  const double column = depth + elevation > 0.01 * depth ? depth + elevation : 0.01 * depth;
  const double height = (z - elevation) * depth / column;
  return height > 0.0 ? 0.0 : height < -depth ? -depth : height;
}

/// Wave numbers of responses from index i on.
Lanes wave_numbers(const ResponseInstant& instant, int i) {
  Lanes numbers{};
  for (int l = 0; l < kWidth && i + l < instant.waves; ++l) numbers[l] = instant.wave_number[i + l];
  return numbers;
}

}  // namespace

void sum_waves(const WaveView& waves, const WaveInstant& instant, const double* points, int count, double* out) {
  Phases phases;
  for (int point = 0; point < count; ++point, points += 3, out += kPointValues) {
    Place place{instant.t, points[0], points[1], 0.0};
    const double elevation = instant.factor * surface(waves, place, phases);
    place.z = stretched(points[2], elevation, waves.depth);
    sum_kinematics(waves, place, phases, out);
    for (int i = 0; i < 3; ++i) {
      out[3 + i] = instant.factor * out[3 + i] + instant.factor_rate * out[i];
      out[i] *= instant.factor;
    }
    out[6] = elevation;
    out[7] *= instant.factor;
  }
}

void sum_responses(const ResponseView& responses, const ResponseInstant& instant, double* out) {
  Lanes sums[18] = {};
  for (int i = 0; i < responses.count; i += kWidth) {
    const Lanes ahead = wave_numbers(instant, i), omega = lanes(responses.omega, i);
    const Lanes rate = omega - ahead * instant.speed, bend = ahead * instant.acceleration;
    Lanes sine, cosine;
    sine_cosine(omega * instant.t - ahead * instant.distance, sine, cosine);
    for (int k = 0; k < 6; ++k) {
      const Lanes re = lanes(responses.parts[2 * k], i), im = lanes(responses.parts[2 * k + 1], i);
      const Lanes value = re * cosine - im * sine, turned = re * sine + im * cosine;
      sums[3 * k] += value;
      sums[3 * k + 1] -= rate * turned;
      sums[3 * k + 2] -= rate * rate * value - bend * turned;
    }
  }
  for (int k = 0; k < 18; ++k) out[k] = total(sums[k]);
}

double wave_elevation(const WaveView& waves, double t, double x, double y) {
  Lanes sum{};
  for (int i = 0; i < waves.count; i += kWidth) {
    Lanes sine, cosine;
    find_phase(waves, {t, x, y, 0.0}, i, sine, cosine);
    sum += lanes(waves.amplitude, i) * cosine;
  }
  return total(sum);
}

}  // namespace overbend::OVERBEND_ISA_NAMESPACE
