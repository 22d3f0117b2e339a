#include "hull/hull_waves_kernel.h"

#include "mechanics/wave_functions.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

constexpr double kTurn = 0x1.921fb54442d18p+2;  // 2 pi
constexpr int kRegisters = 8 / kWidth;          // of eight doubles

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

/// Eight adjacent values.
struct Eight {
  Lanes part[kRegisters];
};

inline Eight none() {
  Eight e;
  for (Lanes& part : e.part) part = Lanes{};
  return e;
}

inline void put(const Eight& e, double* out) {
  for (int r = 0; r < kRegisters; ++r) lanes(out, r * kWidth) = e.part[r];
}

/// Phases at the low-frequency position, w t - k.x - eps: zero with the crest at the hull.
inline void find_phase(const HullWaveView& w, const HullWavePlace& place, int i, Lanes& sine, Lanes& cosine) {
  const Lanes phase =
      (lanes(w.omega, i) * place.t - lanes(w.phase, i)) - lanes(w.kx, i) * place.x - lanes(w.ky, i) * place.y;
  sine_cosine(phase, sine, cosine);
}

/// Two neighbouring headings of the table and the weight of the second.
struct Between {
  int low = 0, high = 0;
  double share = 0.0;
};

Between find_heading(const HullWaveView& w, double relative) {
  const int n = w.headings;
  if (n == 1) return {0, 0, 0.0};
  double a = relative - kTurn * __builtin_floor(relative / kTurn);
  if (!w.all_around && a > w.heading[n - 1] && a - kTurn >= w.heading[0]) a -= kTurn;
  int low = -1, high = n;  // heading[low] <= a < heading[high]
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    if (w.heading[middle] <= a) {
      low = middle;
    } else {
      high = middle;
    }
  }
  if (low >= 0 && high < n) return {low, high, (a - w.heading[low]) / (w.heading[high] - w.heading[low])};
  if (!w.all_around) return low < 0 ? Between{0, 0, 0.0} : Between{n - 1, n - 1, 0.0};
  const double gap = w.heading[0] + kTurn - w.heading[n - 1];
  const double past = low < 0 ? a + kTurn - w.heading[n - 1] : a - w.heading[n - 1];
  return {n - 1, 0, past / gap};
}

/// Sums of a sqrt(T) times cosine and sine for positive and for negative T (Standing et al., 1987).
struct DriftSums {
  Eight mean = none(), cosine_up = none(), sine_up = none(), cosine_down = none(), sine_down = none();
};

inline Lanes root_of_size(const Lanes& a) {
  Lanes r;
  for (int l = 0; l < kWidth; ++l) r[l] = __builtin_sqrt(__builtin_fabs(a[l]));
  return r;
}

inline void add_drift(const Lanes& value, int r, double sine, double cosine, DriftSums& sums) {
  const Lanes root = root_of_size(value);
  const Lanes up = value > 0.0 ? root : Lanes{}, down = value < 0.0 ? root : Lanes{};
  sums.cosine_up.part[r] += up * cosine;
  sums.sine_up.part[r] += up * sine;
  sums.cosine_down.part[r] += down * cosine;
  sums.sine_down.part[r] += down * sine;
}

inline void add_component(const HullWaveView& w, int i, const Between& b, double sine, double cosine, Eight& force,
                          DriftSums& sums) {
  const double* low = w.table + (static_cast<long>(i) * w.headings + b.low) * kHullWaveRow;
  const double* high = w.table + (static_cast<long>(i) * w.headings + b.high) * kHullWaveRow;
  const double q = b.share, p = 1.0 - b.share;
  for (int r = 0; r < kRegisters; ++r) {
    const int k = r * kWidth;
    const Lanes re = lanes(low, k) * p + lanes(high, k) * q;
    const Lanes im = lanes(low, 8 + k) * p + lanes(high, 8 + k) * q;
    force.part[r] += re * cosine - im * sine;
  }
  for (int r = 0; r * kWidth < 4; ++r) {  // surge, sway, yaw
    const int k = 16 + r * kWidth;
    const Lanes value = lanes(low, k) * p + lanes(high, k) * q;
    sums.mean.part[r] += value;
    if (w.drift) add_drift(value, r, sine, cosine, sums);
  }
}

/// Steps along the centreline change the phase by k cos(beta - psi) spacing.
inline void add_strips(const Lanes& speed, const Lanes& cosine_of_travel, const Lanes& sine_of_travel, Lanes sine,
                       Lanes cosine, const Lanes& step_sine, const Lanes& step_cosine, int strips, Lanes* along,
                       Lanes* across) {
  for (int s = 0; s < strips; ++s) {
    const Lanes u = speed * cosine;
    along[s] += u * cosine_of_travel;
    across[s] += u * sine_of_travel;
    const Lanes next = cosine * step_cosine - sine * step_sine;
    sine = sine * step_cosine + cosine * step_sine;
    cosine = next;
  }
}

}  // namespace

void sum_hull_waves(const HullWaveView& w, const HullWavePlace& place, double* out) {
  Eight force = none();
  DriftSums sums;
  Between between;
  double last = 0.0;
  for (int i = 0; i < w.count; i += kWidth) {
    Lanes sine, cosine;
    find_phase(w, place, i, sine, cosine);
    for (int l = 0; l < kWidth; ++l) {
      const double direction = w.direction[i + l];
      if (i + l == 0 || direction != last) between = find_heading(w, direction - place.psi);
      last = direction;
      add_component(w, i + l, between, sine[l], cosine[l], force, sums);
    }
  }
  Eight drift = sums.mean;
  if (w.drift) {
    for (int r = 0; r < kRegisters; ++r) {
      const Lanes &cu = sums.cosine_up.part[r], &su = sums.sine_up.part[r];
      const Lanes &cd = sums.cosine_down.part[r], &sd = sums.sine_down.part[r];
      drift.part[r] = (cu * cu + su * su) - (cd * cd + sd * sd);
    }
  }
  put(force, out);
  put(drift, out + 8);
  put(sums.mean, out + 16);
}

void sum_strip_water(const HullWaveView& w, const HullWavePlace& place, double first, double spacing, int strips,
                     double* along, double* across) {
  Lanes u[8] = {}, v[8] = {};
  const double c = __builtin_cos(place.psi), s = __builtin_sin(place.psi);
  const HullWavePlace aft{place.t, place.x + first * c, place.y + first * s, place.psi};
  for (int i = 0; i < w.count; i += kWidth) {
    Lanes sine, cosine, step_sine, step_cosine, sine_of_travel, cosine_of_travel;
    find_phase(w, aft, i, sine, cosine);
    sine_cosine((lanes(w.kx, i) * c + lanes(w.ky, i) * s) * -spacing, step_sine, step_cosine);
    sine_cosine(lanes(w.direction, i) - place.psi, sine_of_travel, cosine_of_travel);
    add_strips(lanes(w.orbital, i), cosine_of_travel, sine_of_travel, sine, cosine, step_sine, step_cosine, strips, u,
               v);
  }
  for (int k = 0; k < strips; ++k) {
    along[k] = total(u[k]);
    across[k] = total(v[k]);
  }
}

}  // namespace overbend::OVERBEND_ISA_NAMESPACE
