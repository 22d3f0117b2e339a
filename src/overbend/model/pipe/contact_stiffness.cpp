#include "model/pipe/contact_stiffness.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace overbend {
namespace {

/// Positive half of the eight Gauss-Legendre points on [-1, 1].
constexpr double kPoint[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
constexpr double kWeight[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};

/// Integral of the response over all wave numbers along the pipe. With lambda = scale (u/(1 - u))^2 the integrand is
/// smooth on [0, 1]; eight parts leave 1e-8.
double over_wave_numbers(const Shell& shell, double n) {
  constexpr int kParts = 8;
  const double scale = 0.05 * n * n * std::sqrt(shell.thickness / shell.radius) + 0.02 * n;
  const auto integrand = [&](double u) {
    const double ratio = u / (1.0 - u);
    return shell.response(n, scale * ratio * ratio) * scale * 2.0 * ratio / ((1.0 - u) * (1.0 - u));
  };
  double sum = 0.0;
  for (int part = 0; part < kParts; ++part) {
    const double middle = (part + 0.5) / kParts, half = 0.5 / kParts;
    for (int i = 0; i < 4; ++i) {
      sum += half * kWeight[i] * (integrand(middle - half * kPoint[i]) + integrand(middle + half * kPoint[i]));
    }
  }
  return sum;
}

double in_series(double a, double b) {
  return a > 0.0 && b > 0.0 ? a * b / (a + b) : std::max(a, b);
}

double coating_stiffness(const SectionDescription& layers, double bearing) {
  double thickness = 0.0;
  for (const CoatingDescription& layer : layers.coatings) thickness += layer.thickness;
  double stiffness = 0.0;
  for (const CoatingDescription& layer : layers.coatings) {
    if (layer.youngs_modulus) {
      stiffness = in_series(stiffness, *layer.youngs_modulus * bearing * thickness / layer.thickness);
    }
  }
  return stiffness;
}

}  // namespace

double ContactStiffness::total() const {
  return in_series(in_series(shell, coating), structure);
}

double contact_length(double roller_face, double outer_diameter, double steel_diameter) {
  const double squared = (outer_diameter - steel_diameter) * (outer_diameter + steel_diameter);
  return std::min(roller_face, std::sqrt(std::max(squared, 0.0)));
}

double Shell::response(double n, double lambda) const {
  const double a = lambda * lambda + n * n;
  const double bending =
      youngs_modulus * thickness * thickness * thickness / (12.0 * (1.0 - poissons_ratio * poissons_ratio));
  const double r2 = radius * radius, lambda2 = lambda * lambda;
  return a * a /
         (bending / (r2 * r2) * a * a * (a - 1.0) * (a - 1.0) + youngs_modulus * thickness / r2 * lambda2 * lambda2);
}

double shell_stiffness(const Shell& shell, double bearing) {
  constexpr int kMaxWaveNumber = 400;
  constexpr double kSumTolerance = 1e-5;
  const double half_angle = std::min(0.5 * bearing / shell.radius, 0.5 * std::numbers::pi);
  double sum = 0.0;
  for (int n = 2; n < kMaxWaveNumber; ++n) {
    const double angle = n * half_angle;
    const double spread = angle > 0.0 ? std::sin(angle) / angle : 1.0;
    const double wave = over_wave_numbers(shell, n);
    sum += spread * spread * wave;
    if (n * wave < kSumTolerance * sum) break;  // the remaining terms decrease as n^-3
  }
  return std::numbers::pi * std::numbers::pi * shell.radius * shell.radius / sum;
}

ContactStiffness contact_stiffness(const Section& pipe, const SectionDescription& layers, double face,
                                   double structure) {
  const double bearing = contact_length(face, pipe.outer_diameter, pipe.steel_diameter);
  const Shell shell{0.5 * (pipe.steel_diameter - pipe.wall_thickness), pipe.wall_thickness, pipe.youngs_modulus,
                    pipe.poissons_ratio};
  return {shell_stiffness(shell, bearing), coating_stiffness(layers, bearing), structure};
}

}  // namespace overbend
