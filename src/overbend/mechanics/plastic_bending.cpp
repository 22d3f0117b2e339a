#include "mechanics/plastic_bending.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/bit_cast.h"

namespace overbend {
namespace {

constexpr std::size_t kWide = kDirections;

/// Returns the stiffness of the sliders for a mix of levels.
std::array<double, kSliders> slider_stiffness(const BendingLaw& law, const LevelMix& mix) {
  const BendingLevel& lower = law.levels[static_cast<std::size_t>(mix.lower)];
  const BendingLevel& upper = law.levels[std::min(static_cast<std::size_t>(mix.lower) + 1, law.levels.size() - 1)];
  std::array<double, kSliders> stiffness{};
  for (std::size_t i = 0; i < kSliders; ++i) {
    stiffness[i] = lower.stiffness[i] + mix.share * (upper.stiffness[i] - lower.stiffness[i]);
  }
  return stiffness;
}

/// Returns the sum over the directions of value times direction.
Vec2 along_directions(const std::array<double, kWide>& values) {
  const Directions& d = directions();
  double x = 0.0, y = 0.0;
  for (std::size_t j = 0; j < kWide; ++j) {
    x += values[j] * d.x[j];
    y += values[j] * d.y[j];
  }
  return {x, y};
}

/// Hash of a slip history: the previous hash mixed with the new curvature (splitmix64, Steele 2014).
std::uint64_t mix_hash(std::uint64_t stamp, const Vec2& curvature) {
  for (const double part : {curvature.x(), curvature.y()}) {
    std::uint64_t z = stamp + overbend::bit_cast<std::uint64_t>(part) + 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    stamp = z ^ (z >> 31U);
  }
  return stamp | 1U;
}

/// Response of the fibres of all directions to bending of the section.
struct Fibres {
  alignas(64) std::array<double, kWide> bend{};    ///< Curvature in each direction.
  alignas(64) std::array<double, kWide> moment{};  ///< Moment subtracted by slips.
  alignas(64) std::array<double, kWide> slope{};   ///< Its derivative, from slipping sliders.
  alignas(64) std::array<double, kWide> energy{};  ///< Half of stiffness times slip squared.
  double loss = 0.0, slack = std::numeric_limits<double>::infinity();
  bool sliding = false;

  void bend_slider(double limit, double stiffness, double* slip) {
    double over_sum = 0.0, max_offset = 0.0;
    for (std::size_t j = 0; j < kWide; ++j) {
      const double e = bend[j] - slip[j];
      const double over = e - std::min(std::max(e, -limit), limit);
      slip[j] += over;
      over_sum += std::abs(over);
      max_offset = std::max(max_offset, std::abs(e));
      moment[j] += stiffness * slip[j];
      energy[j] += 0.5 * stiffness * slip[j] * slip[j];
      slope[j] += over != 0.0 ? stiffness : 0.0;
    }
    loss += stiffness * limit * over_sum;
    sliding = sliding || over_sum > 0.0;
    slack = std::min(slack, std::max(0.0, limit - max_offset));
  }
};

}  // namespace

void update_held_moment(const BendingLaw& law, const LevelMix& mix, BendingMemory& memory) {
  if (memory.held_mix == mix) return;
  const std::array<double, kSliders> stiffness = slider_stiffness(law, mix);
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

BendingResponse bend(const BendingLaw& law, const LevelMix& mix, const Vec2& curvature, BendingMemory& memory) {
  BendingResponse answer;
  if ((curvature - memory.center).squaredNorm() <= memory.slack * std::abs(memory.slack)) {
    update_held_moment(law, mix, memory);
    answer.plastic_moment = memory.held;
    return answer;
  }
  const Directions& d = directions();
  const std::array<double, kSliders> stiffness = slider_stiffness(law, mix);
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
    memory.max_curvature = std::max(memory.max_curvature, curvature.norm());
    memory.stamp = mix_hash(memory.stamp, curvature);
  }
  return answer;
}

Vec2 find_curvature(const BendingLaw& law, const LevelMix& mix, double EI, const Vec2& moment, BendingMemory& memory) {
  constexpr int kMaxIterations = 60;
  update_held_moment(law, mix, memory);
  Vec2 k = (moment + memory.held) / EI;
  for (int i = 0; i < kMaxIterations; ++i) {
    BendingMemory trial = memory;
    const BendingResponse answer = bend(law, mix, k, trial);
    const Vec2 lack = moment - (EI * k - answer.plastic_moment);
    if (lack.norm() <= 1e-10 * EI * law.limit[0]) break;
    k += (EI * Mat2::Identity() - answer.plastic_tangent).inverse() * lack;
  }
  bend(law, mix, k, memory);
  return k;
}

Vec2 residual_curvature(const BendingLaw& law, const LevelMix& mix, double EI, const BendingMemory& memory) {
  BendingMemory freed = memory;
  return find_curvature(law, mix, EI, Vec2::Zero(), freed);
}

void transport_axes(BendingMemory& memory, const Vec3& tangent) {
  const double cosine = memory.tangent.dot(tangent);
  memory.axis -= (memory.axis.dot(tangent) / (1.0 + cosine)) * (memory.tangent + tangent);
  memory.tangent = tangent;
}

BendingMemory make_bending_memory(const Vec3& tangent) {
  BendingMemory memory;
  const Vec3 helper_axis = std::abs(tangent.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX();
  memory.tangent = tangent;
  memory.axis = (helper_axis - helper_axis.dot(tangent) * tangent).normalized();
  return memory;
}

Vec3 curvature_vector(const CentrelinePoint& centreline) {
  const double g = centreline.a.squaredNorm();
  return (centreline.b - (centreline.a.dot(centreline.b) / g) * centreline.a) / std::sqrt(g);
}

namespace {

/// Subtracts from an element's tangent the contribution of second derivatives by a and b at one point. Each column is a
/// sum of two products over all rows, which the compiler vectorises.
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

void add_plastic_point(const HermiteValues& shape, const CentrelinePoint& centreline, double weight,
                       const Vec3& plastic_moment, const Mat3* tangent, ElementVector& force,
                       ElementMatrix* stiffness) {
  const Vec3 &a = centreline.a, &b = centreline.b, &M = plastic_moment;
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
  const Mat3 identity = Mat3::Identity();
  const Vec3 k = g1 * (b - (m / g) * a);
  const Mat3 Ma = M * a.transpose(), Mb = M * b.transpose(), Mk = M * k.transpose();
  Mat3 h_aa = (0.5 / g) * (Mk + Mk.transpose()) - beta * g3 * identity + 3.0 * beta * g5 * a * a.transpose() -
              g3 * (Mb + Mb.transpose()) + 3.0 * m * g5 * (Ma + Ma.transpose());
  Mat3 h_ba = -g3 * (Ma + Ma.transpose()), h_bb = Mat3::Zero();
  if (tangent != nullptr) {
    const Mat3 k_a =
        -g3 * (b * a.transpose() + m * identity);  // parts along a vanish: the moment is perpendicular to the pipe
    const Mat3 along = *tangent * k_a;
    h_aa += k_a.transpose() * along;
    h_ba += g1 * along;
    h_bb = (g1 * g1) * *tangent;
  }
  add_point_hessian(shape, weight, h_aa, h_ba, h_bb, *stiffness);
}

}  // namespace overbend
