/// Steel that yields in motion: the element kernel and the sections that slide against one section after the other.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "mechanics/line_elements.h"
#include "mechanics/quadrature.h"
#include "support/fixtures.h"
#include "system/yielding.h"

namespace overbend {
namespace {

constexpr int kNodes = 14;

/// A pipe that has been bent far beyond yield and released a little, and a shape to which it moves from there: some of
/// its sections slide again, others hold.
struct BentPipe {
  Model model;
  LineMesh mesh;
  LineElements line;
  YieldingElements elements;
  std::vector<BendingMemory> before;
  std::vector<double> q;
};

ElementVector unknowns(const std::vector<double>& q, std::size_t element) {
  return Eigen::Map<const ElementVector>(q.data() + 6 * element);
}

Model yielding_pipe() {
  Description d = testing::plain_description();
  d.pipe.section.steel.material.law = MaterialLaw::ramberg_osgood;
  d.pipe.section.steel.material.hardening_exponent = 25.0;
  return build_model(d);
}

BentPipe bent_pipe() {
  BentPipe pipe{yielding_pipe(), {}, {}, {}, {}, testing::wavy_line(kNodes, 1.1, Vec3(0.0, 0.0, 30.0), 5)};
  for (int e = 0; e + 1 < kNodes; ++e) pipe.mesh.length.push_back(1.0 + 0.02 * e);
  pipe.mesh.s.resize(kNodes, 0.0);
  std::partial_sum(pipe.mesh.length.begin(), pipe.mesh.length.end(), pipe.mesh.s.begin() + 1);
  pipe.mesh.section.assign(kNodes - 1, 0);
  pipe.line = line_elements(pipe.model, pipe.mesh.length, pipe.mesh.section);
  pipe.elements = yielding_elements(pipe.model, pipe.mesh);
  choose_levels(pipe.elements, pipe.q.data());
  pipe.before = fresh_memories(pipe.mesh, pipe.q.data());
  constexpr double kLetGo = 0.004;  // 1/m, of 0.02 at which the steel yields there and back
  for (std::size_t i = 0; i < pipe.before.size(); ++i) {
    const std::size_t e = i / kGaussPoints;
    const CentrelinePoint point = centreline(unknowns(pipe.q, e), kGaussXi[i % kGaussPoints], pipe.mesh.length[e]);
    const Vec2 k = in_axes(pipe.before[i], curvature_vector(point));
    bend(*pipe.elements.law[e], {}, k + kLetGo * k.normalized(), pipe.before[i]);
    bend(*pipe.elements.law[e], {}, k, pipe.before[i]);  // at another level than that of the element
  }
  pipe.elements.law[5] = nullptr;  // linear steel in between, where pipe that had yielded lay before
  std::mt19937_64 generator(11);
  std::normal_distribution<double> normal(0.0, 1e-4);
  for (double& value : pipe.q) value += normal(generator);
  return pipe;
}

struct Added {
  std::vector<double> residual = std::vector<double>(6 * kNodes, 0.0);
  Eigen::MatrixXd tangent = Eigen::MatrixXd::Zero(6 * kNodes, 6 * kNodes);
  std::vector<BendingMemory> after;
  double stored = 0.0, heat = 0.0;
  int held = 0, slid = 0;
};

/// Section by section, with what is written for one.
Added one_by_one(const BentPipe& pipe) {
  Added sum;
  sum.after = pipe.before;
  for (std::size_t e = 0; e < pipe.elements.law.size(); ++e) {
    if (pipe.elements.law[e] == nullptr) continue;
    ElementVector force = ElementVector::Zero();
    ElementMatrix stiffness = ElementMatrix::Zero();
    for (std::size_t i = 0; i < kGaussPoints; ++i) {
      const CentrelinePoint point = centreline(unknowns(pipe.q, e), kGaussXi[i], pipe.mesh.length[e]);
      BendingMemory& memory = sum.after[kGaussPoints * e + i];
      transport_axes(memory, point.a.normalized());
      const Vec2 k = in_axes(memory, curvature_vector(point));
      const std::uint64_t stamp = memory.stamp;
      const BendingResponse answer = bend(*pipe.elements.law[e], pipe.elements.mix[e], k, memory);
      ++(memory.stamp == stamp ? sum.held : sum.slid);
      const double weight = pipe.mesh.length[e] * kGaussWeight[i];
      sum.heat += weight * answer.loss;
      sum.stored += weight * stored_beyond_elastic(k, memory);
      Eigen::Matrix<double, 3, 2> axes;
      axes << memory.axis, memory.tangent.cross(memory.axis);
      const Mat3 by_curvature = axes * answer.plastic_tangent * axes.transpose();
      add_plastic_point(hermite(kGaussXi[i], pipe.mesh.length[e]), point, weight,
                        from_axes(memory, answer.plastic_moment), &by_curvature, force, &stiffness);
    }
    for (int r = 0; r < 12; ++r) sum.residual[6 * e + static_cast<std::size_t>(r)] += force(r);
    sum.tangent.block<12, 12>(6 * static_cast<int>(e), 6 * static_cast<int>(e)) += stiffness;
  }
  return sum;
}

/// Forces and tangent of the line, with its yielding or, without `yielding`, as if it were linear.
Added all_at_once(const BentPipe& pipe, MovingYielding* yielding, Isa isa,
                  const std::vector<std::vector<double>>& on_the_way = {}) {
  Added sum;
  const std::vector<double> rest(pipe.q.size(), 0.0);
  const AlignedDoubles slip(static_cast<std::size_t>(kGaussPoints * kBedDirections) * pipe.line.padded(), 0.0);
  AlignedDoubles next = slip;
  LineMotion motion{rest.data(), rest.data(), 0.0, 0.0, 0.0, nullptr, slip.data(), next.data()};
  const LineEnvironment env = line_environment(pipe.model, LayRoute(Vec3::Zero(), -Vec3::UnitX()));
  const BendingMemories before(pipe.before);
  BendingMemories after = before;
  BlockTridiagonal tangent(kNodes);
  const auto evaluate = [&](const std::vector<double>& q) {
    HeldSections held;
    if (yielding != nullptr) {
      held = yielding->held(before, after);
      motion.held = &held;
    }
    add_line_forces(pipe.line, env, {q.data(), nullptr}, motion,
                    {sum.residual.data(), tangent.diag(0), tangent.upper(0), tangent.lower(0)}, isa);
    if (yielding == nullptr) return;
    sum.heat = yielding->add_sliding(q.data(), before, after, {&sum.residual, &tangent});
    sum.stored = yielding->stored();
  };
  if (yielding != nullptr) yielding->begin(before, after);
  for (const std::vector<double>& q : on_the_way) evaluate(q);
  evaluate(pipe.q);
  if (yielding != nullptr) yielding->finish(before, after);
  sum.after = after.all();
  sum.tangent = testing::dense(tangent);
  return sum;
}

class moving_yielding : public ::testing::TestWithParam<Isa> {};

TEST_P(moving_yielding, takes_off_the_line_what_its_sections_take_off_one_by_one) {
  if (GetParam() > best_isa()) GTEST_SKIP() << "an instruction set that this machine lacks";
  const BentPipe pipe = bent_pipe();
  const Added expected = one_by_one(pipe);
  ASSERT_GT(expected.held, 10);
  ASSERT_GT(expected.slid, 10);
  MovingYielding yielding(pipe.elements, pipe.mesh);
  const Added with = all_at_once(pipe, &yielding, GetParam()), without = all_at_once(pipe, nullptr, GetParam());
  // Both sum up the same in another order: they differ by rounding, of forces by that of the elastic ones.
  EXPECT_NEAR(with.stored, expected.stored, 1e-10 * std::abs(expected.stored));
  EXPECT_NEAR(with.heat, expected.heat, 1e-10 * expected.heat);
  double max_value = 0.0;
  for (const double force : without.residual) max_value = std::max(max_value, std::abs(force));
  for (std::size_t i = 0; i < expected.residual.size(); ++i) {
    EXPECT_NEAR(with.residual[i] - without.residual[i], expected.residual[i], 1e-12 * max_value) << i;
  }
  const Eigen::MatrixXd lack = with.tangent - without.tangent - expected.tangent;
  EXPECT_LT(lack.cwiseAbs().maxCoeff(), 1e-12 * without.tangent.cwiseAbs().maxCoeff());
  EXPECT_GT(expected.tangent.cwiseAbs().maxCoeff(), 1e-4 * without.tangent.cwiseAbs().maxCoeff());
}

void expect_same_memories(const BentPipe& pipe, const std::vector<BendingMemory>& found,
                          const std::vector<BendingMemory>& expected) {
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (pipe.elements.law[i / kGaussPoints] == nullptr) continue;
    const BendingMemory &a = found[i], &b = expected[i];
    // Rounding again: of unit vectors and curvatures, and of moments of up to 1e6 N m that nearly cancel.
    EXPECT_LT((a.tangent - b.tangent).norm() + (a.axis - b.axis).norm(), 1e-13) << i;
    EXPECT_LT((a.held - b.held).norm(), 1e-9 * b.held.norm() + 1e-9) << i;
    EXPECT_NEAR(a.stored, b.stored, 1e-9 * b.stored + 1e-9) << i;
    EXPECT_NEAR(a.slack, b.slack, 1e-13) << i;
    EXPECT_NEAR(a.max_curvature, b.max_curvature, 1e-13) << i;
    EXPECT_EQ(a.held_mix, b.held_mix) << i;
    for (std::size_t j = 0; j < b.slip.size(); ++j) ASSERT_NEAR(a.slip[j], b.slip[j], 1e-13) << i << " " << j;
  }
}

TEST_P(moving_yielding, remembers_what_its_sections_remember_one_by_one) {
  if (GetParam() > best_isa()) GTEST_SKIP() << "an instruction set that this machine lacks";
  const BentPipe pipe = bent_pipe();
  MovingYielding yielding(pipe.elements, pipe.mesh);
  expect_same_memories(pipe, all_at_once(pipe, &yielding, GetParam()).after, one_by_one(pipe).after);
}

TEST_P(moving_yielding, remembers_nothing_of_shapes_on_the_way_to_the_end_of_a_step) {
  if (GetParam() > best_isa()) GTEST_SKIP() << "an instruction set that this machine lacks";
  const BentPipe pipe = bent_pipe();
  std::vector<double> further = pipe.q;
  for (std::size_t i = 0; i < further.size(); ++i) further[i] += i % 2 == 0 ? 3e-3 : -3e-3;
  MovingYielding yielding(pipe.elements, pipe.mesh);
  const Added straight = all_at_once(pipe, &yielding, GetParam());
  const Added back = all_at_once(pipe, &yielding, GetParam(), {further, pipe.q, further});
  expect_same_memories(pipe, back.after, one_by_one(pipe).after);
  EXPECT_EQ(back.residual, straight.residual);
  EXPECT_EQ(back.heat, straight.heat);
  EXPECT_EQ(back.stored, straight.stored);
}

INSTANTIATE_TEST_SUITE_P(on_every_instruction_set, moving_yielding,
                         ::testing::Values(Isa::baseline, Isa::avx2, Isa::avx512));

}  // namespace
}  // namespace overbend
