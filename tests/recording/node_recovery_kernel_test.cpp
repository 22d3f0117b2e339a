#include "recording/node_recovery_kernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "base/simd.h"
#include "recording/vector_columns.h"

namespace overbend {
namespace {

using Map = Eigen::Map<const Vec3>;

RecoverKernel find_recover_kernel(Isa isa) {
#if defined(__x86_64__)
  if (isa == Isa::avx512) return isa_avx512::recover_nodes;
  if (isa == Isa::avx2) return isa_avx2::recover_nodes;
#endif
  return isa_baseline::recover_nodes;
}

/// Results, with a number beyond the last that must stay.
struct Recovered {
  std::vector<double> x, y, z, tension, moment, vertical;
  VectorColumns tangent, bend;

  explicit Recovered(std::size_t nodes) : tangent(nodes + 1), bend(nodes + 1) {
    for (std::vector<double>* column : columns()) column->assign(nodes + 1, 77.0);
  }
  std::vector<std::vector<double>*> columns() {
    return {&x, &y, &z, &tangent.x, &tangent.y, &tangent.z, &bend.x, &bend.y, &bend.z, &tension, &moment, &vertical};
  }
  RecoveredNodes view() {
    return {x.data(),
            y.data(),
            z.data(),
            {tangent.x.data(), tangent.y.data(), tangent.z.data()},
            {bend.x.data(), bend.y.data(), bend.z.data()},
            tension.data(),
            moment.data(),
            vertical.data()};
  }
};

class node_recovery_kernel : public ::testing::TestWithParam<Isa> {
 protected:
  void SetUp() override {
    if (GetParam() > best_isa()) GTEST_SKIP() << "this machine has no such registers";
  }
};

TEST_P(node_recovery_kernel, finds_tension_and_moment_across_the_pipe_of_lines_of_any_length) {
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (std::size_t nodes = 1; nodes < 30; ++nodes) {
    std::vector<double> q(6 * nodes), cuts(6 * nodes);
    for (double& value : q) value = any(generator);
    for (double& value : cuts) value = 1e5 * any(generator);
    Recovered out(nodes);
    find_recover_kernel(GetParam())({q.data(), cuts.data()}, static_cast<int>(nodes), out.view());
    for (std::size_t i = 0; i < nodes; ++i) {
      const Vec3 place = Map(q.data() + 6 * i), t = Map(q.data() + 6 * i + 3).normalized();
      const Vec3 force = Map(cuts.data() + 6 * i), moment = Map(cuts.data() + 6 * i + 3);
      // The moment of a cut does its work on the tangent, which is as long as the pipe is stretched.
      const Vec3 about = Vec3(Map(q.data() + 6 * i + 3)).cross(moment);
      const Vec3 bend = (about - about.dot(t) * t).cross(t);
      const Vec3 up = (Vec3::UnitZ() - t.z() * t).normalized();
      EXPECT_EQ(Vec3(out.x[i], out.y[i], out.z[i]), place);
      EXPECT_LT((out.tangent[i] - t).norm(), 1e-14);
      EXPECT_LT((out.bend[i] - bend).norm(), 1e-9);
      EXPECT_NEAR(out.tension[i], force.dot(t), 1e-9);
      EXPECT_NEAR(out.moment[i], bend.norm(), 1e-9);
      EXPECT_NEAR(out.vertical[i], bend.dot(up), 1e-8);
    }
    for (const std::vector<double>* column : {&out.x, &out.y, &out.z, &out.tension, &out.moment, &out.vertical}) {
      EXPECT_EQ(column->back(), 77.0);
    }
  }
}

TEST_P(node_recovery_kernel, an_upright_pipe_has_no_vertical_moment) {
  const std::vector<double> q{0.0, 0.0, 5.0, 0.0, 0.0, 1.001}, cuts{0.0, 0.0, 9.0, 3.0, 4.0, 0.0};
  Recovered out(1);
  find_recover_kernel(GetParam())({q.data(), cuts.data()}, 1, out.view());
  EXPECT_EQ(out.vertical[0], 0.0);
  EXPECT_NEAR(out.moment[0], 1.001 * 5.0, 1e-12);
  EXPECT_NEAR(out.tension[0], 9.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(every_instruction_set, node_recovery_kernel,
                         ::testing::Values(Isa::baseline, Isa::avx2, Isa::avx512));

}  // namespace
}  // namespace overbend
