#include "hull/radiation_convolution.h"

#include <algorithm>
#include <cmath>

namespace overbend::convolution {
namespace {

constexpr std::size_t kHeader = 2;
constexpr double kOnGrid = 1e-9;  // of an interval: rounding of sums of steps

using VelocityMap = Eigen::Map<const Vec6>;

/// Parts of the memory. `newest` is the velocity at the last grid point, `offset` seconds ago.
struct Ring {
  double offset;
  std::size_t newest, size;
  const double* values;

  VelocityMap back(std::size_t i) const { return VelocityMap(values + 6 * ((newest + size - i) % size)); }
};

Ring make_ring(const RadiationMemory& memory) {
  return {memory.values[0], static_cast<std::size_t>(memory.values[1]), (memory.values.size() - kHeader) / 6,
          memory.values.data() + kHeader};
}

/// Second integral of K at `time`, by cubics through its values and slopes.
Mat6 twice_at(const RadiationSamples& samples, double time) {
  const double place = time / samples.interval;
  const auto i = static_cast<std::size_t>(place);
  if (i + 1 >= samples.twice.size()) {
    return samples.twice.back();
  }
  const double b = place - static_cast<double>(i), a = 1.0 - b, length = samples.interval;
  return a * a * (1.0 + 2.0 * b) * samples.twice[i] + b * b * (1.0 + 2.0 * a) * samples.twice[i + 1] +
         a * b * length * (a * samples.once[i] - b * samples.once[i + 1]);
}

/// Number of grid points passed by a step.
std::size_t points_passed(double offset, double h, double interval) {
  return static_cast<std::size_t>((offset + h) / interval + kOnGrid);
}

/// History as seen from the end of a step of length h: velocities at knots `time` back from there, the first at 0.
/// Within the step they are v0 share + v1 (1 - share).
struct Knots {
  Ring ring;
  const Vec6& v0;
  double h, interval;
  std::size_t passed;
  double offset;  ///< Since the last grid point, at the end of the step.

  std::size_t count() const { return ring.size + 1; }
  double time(std::size_t i) const { return i == 0 ? 0.0 : offset + static_cast<double>(i - 1) * interval; }
  double share_of_start(std::size_t i) const { return std::min(time(i) / h, 1.0); }
  bool in_step(std::size_t i) const { return i <= passed; }
  Vec6 at_rest_end(std::size_t i) const {
    return in_step(i) ? Vec6(share_of_start(i) * v0) : Vec6(ring.back(i - 1 - passed));
  }
  double share_of_end(std::size_t i) const { return in_step(i) ? 1.0 - share_of_start(i) : 0.0; }
};

Knots make_knots(const RadiationModel& model, const RadiationMemory& memory, const Vec6& v0, double h) {
  const Ring ring = make_ring(memory);
  const double interval = model.samples.interval;
  const std::size_t passed = points_passed(ring.offset, h, interval);
  return {ring, v0, h, interval, passed, std::max(ring.offset + h - static_cast<double>(passed) * interval, 0.0)};
}

}  // namespace

RadiationMemory make_bending_memory(const RadiationModel& model) {
  return {std::vector<double>(kHeader + 6 * model.samples.once.size(), 0.0)};
}

// Integrated by parts twice: with velocities linear between knots, mu = -sum of slope * (K2 at the end - at the
// beginning).
RadiationStep step(const RadiationModel& model, const RadiationMemory& memory, const Vec6& v0, double h) {
  const Knots knots = make_knots(model, memory, v0, h);
  RadiationStep result;
  Mat6 twice = Mat6::Zero();
  Vec6 velocity = knots.at_rest_end(0);
  for (std::size_t i = 0; i + 1 < knots.count(); ++i) {
    const double length = knots.time(i + 1) - knots.time(i);
    const Vec6 next = knots.at_rest_end(i + 1);
    if (length > kOnGrid * knots.interval) {
      const Mat6 next_twice = twice_at(model.samples, knots.time(i + 1));
      const Mat6 weight = (twice - next_twice) / length;
      result.force_at_rest_end += weight * (next - velocity);
      if (i <= knots.passed) {
        result.slope += (knots.share_of_end(i + 1) - knots.share_of_end(i)) * weight;
      }
      twice = next_twice;
    }
    velocity = next;
  }
  return result;
}

void advance(const RadiationModel& model, RadiationMemory& memory, const Vec6& v0, const Vec6& v1, double h) {
  const Knots knots = make_knots(model, memory, v0, h);
  for (std::size_t i = std::min(knots.passed, knots.ring.size); i >= 1; --i) {
    const std::size_t place = (knots.ring.newest + 1 + knots.passed - i) % knots.ring.size;
    const double share = knots.share_of_start(i);
    Eigen::Map<Vec6>(memory.values.data() + kHeader + 6 * place) = share * v0 + (1.0 - share) * v1;
  }
  memory.values[0] = knots.offset;
  memory.values[1] = static_cast<double>((knots.ring.newest + knots.passed) % knots.ring.size);
}

Vec6 force(const RadiationModel& model, const RadiationMemory& memory, const Vec6& v) {
  // A step of zero length: the newest knot is v, and `offset` before it the last grid point.
  const Ring ring = make_ring(memory);
  Vec6 sum = Vec6::Zero();
  Mat6 twice = Mat6::Zero();
  Vec6 velocity = v;
  double time = 0.0;
  for (std::size_t i = 0; i < ring.size; ++i) {
    const double next_time = ring.offset + static_cast<double>(i) * model.samples.interval;
    const Vec6 next = ring.back(i);
    if (next_time - time > kOnGrid * model.samples.interval) {
      const Mat6 next_twice = twice_at(model.samples, next_time);
      sum += (twice - next_twice) * (next - velocity) / (next_time - time);
      twice = next_twice;
    }
    velocity = next;
    time = next_time;
  }
  return sum;
}

}  // namespace overbend::convolution
