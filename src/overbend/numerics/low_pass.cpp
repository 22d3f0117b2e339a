#include "numerics/low_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace overbend {
namespace {

constexpr int kSections = 3;        ///< Number of second-order sections.
constexpr double kContinued = 3.0;  ///< Extension in cut-off periods beyond either end.
constexpr double kMinSteps = 4.0;   ///< Minimum number of steps in a cut-off period.

/// y = b (x + 2 x1 + x2) - a1 y1 - a2 y2: unit gain at zero frequency.
struct SecondOrder {
  double b = 0.0, a1 = 0.0, a2 = 0.0;
};

/// Section `k` of the Butterworth filter; `tangent`: tan(pi step / cut_off).
SecondOrder butterworth(int k, double tangent) {
  const double twice_damping = 2.0 * std::sin(std::numbers::pi * (2.0 * k + 1.0) / (4.0 * kSections));
  const double square = tangent * tangent;
  const double a0 = 1.0 + twice_damping * tangent + square;
  return {square / a0, 2.0 * (square - 1.0) / a0, (1.0 - twice_damping * tangent + square) / a0};
}

/// Filters the values by a section, with the initial state of a constant first value.
template <class Iterator>
void run(const SecondOrder& s, Iterator first, Iterator last) {
  double x1 = *first, x2 = *first, y1 = *first, y2 = *first;
  for (; first != last; ++first) {
    const double x = *first;
    const double y = s.b * (x + 2.0 * x1 + x2) - s.a1 * y1 - s.a2 * y2;
    x2 = x1;
    x1 = x;
    y2 = y1;
    y1 = y;
    *first = y;
  }
}

/// Returns the values extended by `more` on either side: point reflection of the record about its ends.
std::vector<double> continued(std::span<const double> values, std::size_t more) {
  std::vector<double> all;
  all.reserve(values.size() + 2 * more);
  for (std::size_t i = more; i > 0; --i) all.push_back(2.0 * values.front() - values[i]);
  all.insert(all.end(), values.begin(), values.end());
  for (std::size_t i = 1; i <= more; ++i) all.push_back(2.0 * values.back() - values[values.size() - 1 - i]);
  return all;
}

}  // namespace

std::vector<double> low_pass(std::span<const double> values, double step, double cut_off) {
  if (!(step > 0.0) || !(cut_off > 0.0)) {
    throw std::invalid_argument("a low-pass filter needs a positive step and cut-off");
  }
  if (values.size() < 2 || cut_off < kMinSteps * step) return {values.begin(), values.end()};
  const auto more = std::min(values.size() - 1, static_cast<std::size_t>(std::ceil(kContinued * cut_off / step)));
  std::vector<double> all = continued(values, more);
  const double tangent = std::tan(std::numbers::pi * step / cut_off);
  for (int k = 0; k < kSections; ++k) {
    const SecondOrder section = butterworth(k, tangent);
    run(section, all.begin(), all.end());
    run(section, all.rbegin(), all.rend());
  }
  const auto first = all.begin() + static_cast<std::ptrdiff_t>(more);
  return {first, first + static_cast<std::ptrdiff_t>(values.size())};
}

}  // namespace overbend
