#include "mechanics/plastic_bending.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace overbend {
namespace {

/// Stiffness of the springs for a mix of levels.
struct Springs {
  const BendingLevel *lower, *upper;
  double share;

  Springs(const BendingLaw& law, const LevelMix& mix)
      : lower(&law.levels[static_cast<std::size_t>(mix.lower)]),
        upper(&law.levels[std::min(static_cast<std::size_t>(mix.lower) + 1, law.levels.size() - 1)]),
        share(mix.share) {}
  double operator[](std::size_t i) const {
    return lower->stiffness[i] + share * (upper->stiffness[i] - lower->stiffness[i]);
  }
};

Vec2 moment_of_slips(const Springs& springs, const BendingMemory& memory) {
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = 0; i < kSprings; ++i) sum += springs[i] * memory.slip[i];
  return sum;
}

}  // namespace

BendingAnswer bend(const BendingLaw& law, const LevelMix& mix, const Vec2& curvature, BendingMemory& memory) {
  const Springs springs(law, mix);
  BendingAnswer answer;
  if ((curvature - memory.center).squaredNorm() <= memory.slack * std::abs(memory.slack)) {
    answer.plastic_moment = moment_of_slips(springs, memory);
    return answer;
  }
  double slack = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < kSprings; ++i) {
    const Vec2 trial = curvature - memory.slip[i];
    const double size = trial.norm(), limit = law.limit[i];
    if (size > limit) {
      const Vec2 n = trial / size, slide = (size - limit) * n;
      memory.slip[i] += slide;
      answer.sliding = true;
      const double held = limit / size, stiffness = springs[i];
      answer.plastic_tangent += stiffness * (Mat2::Identity() - held * (Mat2::Identity() - n * n.transpose()));
      answer.loss += stiffness * limit * (size - limit);
      slack = 0.0;
    } else {
      slack = std::min(slack, limit - size);
    }
    answer.plastic_moment += springs[i] * memory.slip[i];
  }
  memory.center = curvature;
  memory.slack = slack;
  if (answer.sliding) memory.largest = std::max(memory.largest, curvature.norm());
  return answer;
}

double stored_beyond_elastic(const BendingLaw& law, const LevelMix& mix, const Vec2& curvature,
                             const BendingMemory& memory) {
  const Springs springs(law, mix);
  double sum = 0.0;
  for (std::size_t i = 0; i < kSprings; ++i) {
    sum += 0.5 * springs[i] * ((curvature - memory.slip[i]).squaredNorm() - curvature.squaredNorm());
  }
  return sum;
}

Vec2 curvature_for(const BendingLaw& law, const LevelMix& mix, double EI, const Vec2& moment, BendingMemory& memory) {
  constexpr int kMost = 60;
  Vec2 k = (moment + moment_of_slips(Springs(law, mix), memory)) / EI;
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

void add_plastic_point(const HermiteValues& shape, const CentrelinePoint& at, double weight, const Vec3& plastic_moment,
                       const Mat3& tangent, ElementVector& force, ElementMatrix* stiffness) {
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
  const Mat3 k_b = g1 * one;
  const Mat3 k_a = -g3 * (b * a.transpose() + m * one);  // parts along a drop out: the moment stands across the pipe
  const Mat3 Ma = M * a.transpose(), Mb = M * b.transpose(), Mk = M * k.transpose();
  Mat3 h_aa = k_a.transpose() * tangent * k_a + (0.5 / g) * (Mk + Mk.transpose());
  h_aa += -beta * g3 * one + 3.0 * beta * g5 * a * a.transpose() - g3 * (Mb + Mb.transpose()) +
          3.0 * m * g5 * (Ma + Ma.transpose());
  const Mat3 h_ba = k_b.transpose() * tangent * k_a - g3 * (Ma + Ma.transpose());
  const Mat3 h_bb = k_b.transpose() * tangent * k_b;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      stiffness->block<3, 3>(3 * j, 3 * i) -=
          weight * (shape.first(j) * shape.first(i) * h_aa + shape.second(j) * shape.second(i) * h_bb +
                    shape.second(j) * shape.first(i) * h_ba + shape.first(j) * shape.second(i) * h_ba.transpose());
    }
  }
}

}  // namespace overbend
