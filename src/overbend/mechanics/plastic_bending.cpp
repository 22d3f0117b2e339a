#include "mechanics/plastic_bending.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

namespace overbend {
namespace {

constexpr std::size_t kWide = kDirections;

/// Stiffness of the sliders for a mix of levels.
std::array<double, kSliders> stiffness_of(const BendingLaw& law, const LevelMix& mix) {
  const BendingLevel& lower = law.levels[static_cast<std::size_t>(mix.lower)];
  const BendingLevel& upper = law.levels[std::min(static_cast<std::size_t>(mix.lower) + 1, law.levels.size() - 1)];
  std::array<double, kSliders> stiffness{};
  for (std::size_t i = 0; i < kSliders; ++i) {
    stiffness[i] = lower.stiffness[i] + mix.share * (upper.stiffness[i] - lower.stiffness[i]);
  }
  return stiffness;
}

/// Sum over the directions of a value times the direction.
Vec2 along_directions(const std::array<double, kWide>& values) {
  const Directions& d = directions();
  double x = 0.0, y = 0.0;
  for (std::size_t j = 0; j < kWide; ++j) {
    x += values[j] * d.x[j];
    y += values[j] * d.y[j];
  }
  return {x, y};
}

/// A number that distinguishes histories: the last one stirred with what came on top (splitmix64, Steele 2014).
std::uint64_t stirred(std::uint64_t stamp, const Vec2& curvature) {
  for (const double part : {curvature.x(), curvature.y()}) {
    std::uint64_t z = stamp + std::bit_cast<std::uint64_t>(part) + 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    stamp = z ^ (z >> 31U);
  }
  return stamp | 1U;
}

/// Response of the fibres of all directions when the section is bent.
struct Fibres {
  alignas(64) std::array<double, kWide> bend{};    ///< Curvature towards each.
  alignas(64) std::array<double, kWide> moment{};  ///< Taken off by slips.
  alignas(64) std::array<double, kWide> slope{};   ///< Of that, by sliders that slide.
  alignas(64) std::array<double, kWide> energy{};  ///< Half of stiffness times slip squared.
  double loss = 0.0, slack = std::numeric_limits<double>::infinity();
  bool sliding = false;

  void bend_slider(double limit, double stiffness, double* slip) {
    double over_sum = 0.0, most = 0.0;
    for (std::size_t j = 0; j < kWide; ++j) {
      const double e = bend[j] - slip[j];
      const double over = e - std::min(std::max(e, -limit), limit);
      slip[j] += over;
      over_sum += std::abs(over);
      most = std::max(most, std::abs(e));
      moment[j] += stiffness * slip[j];
      energy[j] += 0.5 * stiffness * slip[j] * slip[j];
      slope[j] += over != 0.0 ? stiffness : 0.0;
    }
    loss += stiffness * limit * over_sum;
    sliding = sliding || over_sum > 0.0;
    slack = std::min(slack, std::max(0.0, limit - most));
  }
};

}  // namespace

void bring_to_level(const BendingLaw& law, const LevelMix& mix, BendingMemory& memory) {
  if (memory.held_mix == mix) return;
  const std::array<double, kSliders> stiffness = stiffness_of(law, mix);
  std::array<double, kWide> sum{}, energy{};
  for (std::size_t i = 0; i < kSliders; ++i) {
    for (std::size_t j = 0; j < kWide; ++j) {
      const double slip = memory.slip[kWide * i + j];
      sum[j] += stiffness[i] * slip;
      energy[j] += 0.5 * stiffness[i] * slip * slip;
    }
  }
  memory.held = memory.stamp == 0 ? Vec2(Vec2::Zero()) : along_directions(sum);
  memory.stored = std::accumulate(energy.begin(), energy.end(), 0.0);
  memory.held_mix = mix;
}

BendingAnswer bend(const BendingLaw& law, const LevelMix& mix, const Vec2& curvature, BendingMemory& memory) {
  BendingAnswer answer;
  if ((curvature - memory.center).squaredNorm() <= memory.slack * std::abs(memory.slack)) {
    bring_to_level(law, mix, memory);
    answer.plastic_moment = memory.held;
    return answer;
  }
  const Directions& d = directions();
  const std::array<double, kSliders> stiffness = stiffness_of(law, mix);
  Fibres fibres;
  for (std::size_t j = 0; j < kWide; ++j) fibres.bend[j] = curvature.x() * d.x[j] + curvature.y() * d.y[j];
  for (std::size_t i = 0; i < kSliders; ++i) {
    fibres.bend_slider(law.limit[i], stiffness[i], memory.slip.data() + kWide * i);
  }
  answer.plastic_moment = along_directions(fibres.moment);
  answer.loss = fibres.loss;
  answer.sliding = fibres.sliding;
  memory.center = curvature;
  memory.slack = fibres.slack;
  memory.held = answer.plastic_moment;
  memory.stored = std::accumulate(fibres.energy.begin(), fibres.energy.end(), 0.0);
  memory.held_mix = mix;
  if (answer.sliding) {
    for (std::size_t j = 0; j < kWide; ++j) {
      const Vec2 to(d.x[j], d.y[j]);
      answer.plastic_tangent += fibres.slope[j] * to * to.transpose();
    }
    memory.largest = std::max(memory.largest, curvature.norm());
    memory.stamp = stirred(memory.stamp, curvature);
  }
  return answer;
}

Vec2 curvature_for(const BendingLaw& law, const LevelMix& mix, double EI, const Vec2& moment, BendingMemory& memory) {
  constexpr int kMost = 60;
  bring_to_level(law, mix, memory);
  Vec2 k = (moment + memory.held) / EI;
  for (int i = 0; i < kMost; ++i) {
    BendingMemory trial = memory;
    const BendingAnswer answer = bend(law, mix, k, trial);
    const Vec2 lack = moment - (EI * k - answer.plastic_moment);
    if (lack.norm() <= 1e-10 * EI * law.limit[0]) break;
    k += (EI * Mat2::Identity() - answer.plastic_tangent).inverse() * lack;
  }
  bend(law, mix, k, memory);
  return k;
}

Vec2 residual_curvature(const BendingLaw& law, const LevelMix& mix, double EI, const BendingMemory& memory) {
  BendingMemory freed = memory;
  return curvature_for(law, mix, EI, Vec2::Zero(), freed);
}

void bring_along(BendingMemory& memory, const Vec3& tangent) {
  const double cosine = memory.tangent.dot(tangent);
  memory.axis -= (memory.axis.dot(tangent) / (1.0 + cosine)) * (memory.tangent + tangent);
  memory.tangent = tangent;
}

BendingMemory fresh_memory(const Vec3& tangent) {
  BendingMemory memory;
  const Vec3 other = std::abs(tangent.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX();
  memory.tangent = tangent;
  memory.axis = (other - other.dot(tangent) * tangent).normalized();
  return memory;
}

Vec3 curvature_vector(const CentrelinePoint& at) {
  const double g = at.a.squaredNorm();
  return (at.b - (at.a.dot(at.b) / g) * at.a) / std::sqrt(g);
}

namespace {

/// Takes off an element's tangent what the second derivatives by a and b at one point are for its unknowns. A column
/// of it is a sum of two products over all rows, which are vectors to the compiler.
void add_point_hessian(const HermiteValues& shape, double weight, const Mat3& h_aa, const Mat3& h_ba, const Mat3& h_bb,
                       ElementMatrix& stiffness) {
  constexpr int kRows = 12;
  alignas(16) std::array<double, kRows> first, second, by_a, by_b;
  for (int k = 0; k < kRows; ++k) {
    first[static_cast<std::size_t>(k)] = -weight * shape.first(k / 3);
    second[static_cast<std::size_t>(k)] = -weight * shape.second(k / 3);
  }
  for (int i = 0; i < 4; ++i) {
    const Mat3 a = shape.first(i) * h_aa + shape.second(i) * h_ba.transpose();
    const Mat3 b = shape.second(i) * h_bb + shape.first(i) * h_ba;
    for (int c = 0; c < 3; ++c) {
      for (int k = 0; k < kRows; ++k) {
        by_a[static_cast<std::size_t>(k)] = a(k % 3, c);
        by_b[static_cast<std::size_t>(k)] = b(k % 3, c);
      }
      double* column = stiffness.data() + kRows * (3 * i + c);
      for (std::size_t k = 0; k < kRows; ++k) column[k] += first[k] * by_a[k] + second[k] * by_b[k];
    }
  }
}

}  // namespace

void add_plastic_point(const HermiteValues& shape, const CentrelinePoint& at, double weight, const Vec3& plastic_moment,
                       const Mat3* tangent, ElementVector& force, ElementMatrix* stiffness) {
  const Vec3 &a = at.a, &b = at.b, &M = plastic_moment;
  const double g = a.squaredNorm(), m = a.dot(b), beta = M.dot(b);
  const double g1 = 1.0 / std::sqrt(g), g3 = g1 / g, g5 = g3 / g;
  const Vec3 f_a = -(beta * g3) * a - (m * g3) * M;
  const Vec3 f_b = g1 * M;
  for (int j = 0; j < 4; ++j) {
    force.segment<3>(3 * j) -= weight * (shape.first(j) * f_a + shape.second(j) * f_b);
  }
  if (stiffness == nullptr) {
    return;
  }
  const Mat3 one = Mat3::Identity();
  const Vec3 k = g1 * (b - (m / g) * a);
  const Mat3 Ma = M * a.transpose(), Mb = M * b.transpose(), Mk = M * k.transpose();
  Mat3 h_aa = (0.5 / g) * (Mk + Mk.transpose()) - beta * g3 * one + 3.0 * beta * g5 * a * a.transpose() -
              g3 * (Mb + Mb.transpose()) + 3.0 * m * g5 * (Ma + Ma.transpose());
  Mat3 h_ba = -g3 * (Ma + Ma.transpose()), h_bb = Mat3::Zero();
  if (tangent != nullptr) {
    const Mat3 k_a =
        -g3 * (b * a.transpose() + m * one);  // parts along a vanish: the moment is perpendicular to the pipe
    const Mat3 along = *tangent * k_a;
    h_aa += k_a.transpose() * along;
    h_ba += g1 * along;
    h_bb = (g1 * g1) * *tangent;
  }
  add_point_hessian(shape, weight, h_aa, h_ba, h_bb, *stiffness);
}

}  // namespace overbend
