#include "hull/damping_interpolation.h"

#include <algorithm>
#include <cmath>

#include "base/dense_algebra.h"

namespace overbend {
namespace {

constexpr double kSteepest = 8.0, kFlattest = 1.0, kWithoutPower = 2.0;
constexpr double kSilent = 1e-6;

/// Second derivatives of the natural cubic spline through the points, for all 36 entries at once.
std::vector<Mat6> spline_curvatures(const std::vector<double>& x, const std::vector<Mat6>& y) {
  const std::size_t n = x.size();
  std::vector<Mat6> curvature(n, Mat6::Zero());
  std::vector<double> upper(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = x[i] - x[i - 1], behind = x[i + 1] - x[i];
    const double pivot = 2.0 * (before + behind) - before * upper[i - 1];
    upper[i] = behind / pivot;
    const Mat6 bend = 6.0 * ((y[i + 1] - y[i]) / behind - (y[i] - y[i - 1]) / before);
    curvature[i] = (bend - before * curvature[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) {
    curvature[i] -= upper[i] * curvature[i + 1];
  }
  return curvature;
}

/// Exponents below the first frequency: value times (omega/first)^exponent.
Mat6 low_exponents(const HydrodynamicData& data, const std::vector<Mat6>& damping) {
  Mat6 exponents = Mat6::Constant(kWithoutPower);
  const auto& points = data.radiation;
  const double omega[3] = {points[0].omega, points[1].omega, points[2].omega};
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      exponents(i, j) = low_exponent(omega, {damping[0](i, j), damping[1](i, j), damping[2](i, j)});
    }
  }
  return exponents;
}

}  // namespace

double low_exponent(const double (&omega)[3], const double (&value)[3]) {
  const bool same_sign = value[0] * value[1] > 0.0 && value[1] * value[2] > 0.0;
  if (!same_sign) {
    return kWithoutPower;
  }
  double x_mean = 0.0, y_mean = 0.0, xy = 0.0, xx = 0.0;
  for (int k = 0; k < 3; ++k) {
    x_mean += std::log(omega[k]) / 3.0;
    y_mean += std::log(std::abs(value[k])) / 3.0;
  }
  for (int k = 0; k < 3; ++k) {
    const double x = std::log(omega[k]) - x_mean;
    xy += x * (std::log(std::abs(value[k])) - y_mean);
    xx += x * x;
  }
  return std::clamp(xy / xx, kFlattest, kSteepest);
}

std::vector<Mat6> passive_damping(const HydrodynamicData& data, double& max_negative_damping) {
  Vec6 peak = Vec6::Constant(1e-300);
  for (const RadiationPoint& point : data.radiation) {
    peak = peak.cwiseMax(point.damping.diagonal().cwiseAbs());
  }
  // Modes that do not radiate contain only noise, which must not be amplified.
  peak.head<3>() = peak.head<3>().cwiseMax(kSilent * peak.head<3>().maxCoeff()).eval();
  peak.tail<3>() = peak.tail<3>().cwiseMax(kSilent * peak.tail<3>().maxCoeff()).eval();
  const Vec6 unit = peak.cwiseSqrt();
  std::vector<Mat6> passive;
  max_negative_damping = 0.0;
  for (const RadiationPoint& point : data.radiation) {
    const Mat6 scaled = unit.cwiseInverse().asDiagonal() * (0.5 * (point.damping + point.damping.transpose())) *
                        unit.cwiseInverse().asDiagonal();
    const SymmetricModes modes = symmetric_modes(scaled);
    max_negative_damping = std::max(max_negative_damping, -modes.values(0));
    const Mat6 positive = modes.vectors * modes.values.cwiseMax(0.0).asDiagonal() * modes.vectors.transpose();
    passive.emplace_back(unit.asDiagonal() * positive * unit.asDiagonal());
  }
  return passive;
}

void interpolate_damping(const HydrodynamicData& data, const std::vector<Mat6>& file_damping,
                         std::span<const double> omega, std::span<Mat6> damping) {
  std::vector<double> x = {0.0};
  std::vector<Mat6> y = {Mat6::Zero()};
  for (std::size_t i = 0; i < file_damping.size(); ++i) {
    x.push_back(data.radiation[i].omega);
    y.push_back(file_damping[i]);
  }
  const std::vector<Mat6> curvature = spline_curvatures(x, y);
  const Mat6 exponents = low_exponents(data, file_damping);
  std::size_t right = 1;
  for (std::size_t k = 0; k < omega.size(); ++k) {
    while (right + 1 < x.size() && omega[k] > x[right]) {
      ++right;
    }
    if (omega[k] <= 0.0) {
      damping[k] = Mat6::Zero();
    } else if (right == 1) {
      damping[k] = y[1].cwiseProduct((std::log(omega[k] / x[1]) * exponents).array().exp().matrix());
    } else {
      const double length = x[right] - x[right - 1], b = (omega[k] - x[right - 1]) / length, a = 1.0 - b;
      damping[k] =
          a * y[right - 1] + b * y[right] +
          length * length / 6.0 * ((a * a * a - a) * curvature[right - 1] + (b * b * b - b) * curvature[right]);
    }
  }
}

}  // namespace overbend
