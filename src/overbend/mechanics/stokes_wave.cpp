#include "mechanics/stokes_wave.h"

#include <cmath>
#include <numbers>

#include "model/pipe/section.h"
#include "model/waves/wave_theory.h"

namespace overbend {
namespace {

double phase_at(const StokesWave& wave, double t, double x, double y) {
  return wave.kx * x + wave.ky * y - wave.omega * t + wave.phase;
}

}  // namespace

StokesWave stokes_wave(double height, double period, double depth, double ex, double ey, double phase) {
  StokesWave wave{.depth = depth, .omega = 2.0 * std::numbers::pi / period, .phase = phase};
  const double k = stokes_wave_number(height, period, depth);
  wave.wave_number = k;
  wave.kx = k * ex;
  wave.ky = k * ey;
  const StokesCoefficients c = stokes_coefficients(k * depth);
  const double e = 0.5 * k * height, e2 = e * e;
  wave.elevation = {(e + e * e2 * (c.b31 - e2 * (c.b53 + c.b55))) / k, e2 * (c.b22 + e2 * c.b42) / k,
                    e * e2 * (-c.b31 + e2 * c.b53) / k, e2 * e2 * c.b44 / k, e * e2 * e2 * c.b55 / k};
  const double scale = c.c0 * std::sqrt(kGravity / k);
  wave.speed = {scale * e * (c.a11 + e2 * (c.a31 + e2 * c.a51)), scale * 2.0 * e2 * (c.a22 + e2 * c.a42),
                scale * 3.0 * e * e2 * (c.a33 + e2 * c.a53), scale * 4.0 * e2 * e2 * c.a44,
                scale * 5.0 * e * e2 * e2 * c.a55};
  return wave;
}

double elevation(const StokesWave& wave, double t, double x, double y) {
  const double phase = phase_at(wave, t, x, y);
  double sum = 0.0;
  for (int j = 1; j <= 5; ++j) sum += wave.elevation[j - 1] * std::cos(j * phase);
  return sum;
}

WaveKinematics kinematics(const StokesWave& wave, double t, double x, double y, double z) {
  const double phase = phase_at(wave, t, x, y);
  double u = 0.0, w = 0.0, u_t = 0.0, w_t = 0.0;
  for (int j = 1; j <= 5; ++j) {
    const double k = j * wave.wave_number;
    // cosh and sinh of k(z + d) over cosh kd, in a form that deep water does not overflow
    const double down = std::exp(k * z), echo = std::exp(-k * (z + 2.0 * wave.depth));
    const double amplitude = wave.speed[j - 1] / (1.0 + std::exp(-2.0 * k * wave.depth));
    const double across = amplitude * (down + echo), up = amplitude * (down - echo);
    const double cosine = std::cos(j * phase), sine = std::sin(j * phase);
    u += across * cosine;
    w += up * sine;
    u_t += j * wave.omega * across * sine;
    w_t -= j * wave.omega * up * cosine;
  }
  const double ex = wave.kx / wave.wave_number, ey = wave.ky / wave.wave_number;
  return {Vec3(u * ex, u * ey, w), Vec3(u_t * ex, u_t * ey, w_t), wave.omega / wave.wave_number * u / kGravity};
}

}  // namespace overbend
