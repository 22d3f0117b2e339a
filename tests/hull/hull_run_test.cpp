#include "hull/hull_run.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include "base/constants.h"
#include "hull/damping_ratios.h"
#include "support/hull_case.h"
#include "support/rao_files.h"

namespace overbend {
namespace {

constexpr double kRadius = 0.8;  // spectral radius of the scheme

const HydrodynamicData& data() {
  return testing::bgl1_hydrodynamics();
}

/// Springs so soft that wave-frequency motion does not feel them, with a fifth of critical damping, so that what the
/// start excites dies out.
HullSprings soft_springs(const Vec6& rest) {
  HullSprings springs;
  springs.stiffness.diagonal() << 6e4, 6e4, 0.0, 0.0, 0.0, 5e7;
  springs.damping.diagonal() << 6e5, 6e5, 0.0, 0.0, 0.0, 8e8;
  springs.rest = rest;
  return springs;
}

Mat6 hull_inertia(const Hull& hull) {
  Mat6 M = Mat6::Zero();
  M.topLeftCorner<3, 3>().diagonal().setConstant(hull.body.mass);
  M.bottomRightCorner<3, 3>() = hull.body.inertia;
  return M;
}

/// Complex motion per wave amplitude by the file's added mass and damping at one of its frequencies; i in the file.
CVec6 linear_answer(const Hull& hull, const HullSprings& springs, std::size_t i, std::size_t heading) {
  const RadiationPoint& point = data().radiation[i];
  const double w = point.omega;
  const CMat6 Z = (hull.hydrostatics + springs.stiffness - w * w * (hull_inertia(hull) + point.added_mass))
                      .cast<std::complex<double>>() +
                  std::complex<double>(0.0, w) *
                      (point.damping + hull.damping.linear + springs.damping).cast<std::complex<double>>();
  return Z.partialPivLu().solve(data().force[data().excitation.index(i, heading)]);
}

/// Amplitude of exp(i w t) in a record of equal steps over whole periods, least squares with a mean and a trend.
CVec6 fit_harmonic(const std::vector<std::pair<double, Vec6>>& record, double w) {
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Matrix<double, 4, 6> right = Eigen::Matrix<double, 4, 6>::Zero();
  const double middle = 0.5 * (record.front().first + record.back().first);
  for (const auto& [t, h] : record) {
    const Eigen::Vector4d row(std::cos(w * t), -std::sin(w * t), 1.0, (t - middle) / 50.0);
    normal += row * row.transpose();
    right += row * h.transpose();
  }
  const Eigen::Matrix<double, 4, 6> found = normal.ldlt().solve(right);
  CVec6 z;
  for (int k = 0; k < 6; ++k) z(k) = {found(0, k), found(1, k)};
  return z;
}

std::size_t frequency(double w) {
  std::size_t best = 0;
  for (std::size_t i = 0; i < data().radiation.size(); ++i) {
    if (std::abs(data().radiation[i].omega - w) < std::abs(data().radiation[best].omega - w)) best = i;
  }
  return best;
}

/// Answer to small regular waves, per amplitude; freedoms along the drawn hull.
CVec6 answer_in_waves(double w, double heading, double step, double psi) {
  const double amplitude = 0.01;
  Hull hull = testing::made_bgl1_hull().hull;
  hull.drawn(5) = psi;
  hull.waves = make_hull_waves(data(), testing::regular_sea(amplitude, w, heading + psi), WaveDrift::none, 5.182, psi);
  hull.build_up = 100.0;
  HullState state = make_static_hull(hull, hull.drawn);
  HullSprings springs = soft_springs(hull.drawn);
  find_hull_acceleration(hull, springs, -hull.build_up, state);
  const double start = -hull.build_up, settled = 100.0, end = settled + 4.0 * 2.0 * kPi / w;
  std::vector<std::pair<double, Vec6>> record;
  const int steps = static_cast<int>((end - start) / step);
  EXPECT_TRUE(run_hull(hull, springs, kRadius, start, step, steps, state, [&](double t, const HullState& s) {
    if (t > settled) record.emplace_back(t, freedoms_from(s.h, hull.drawn) / amplitude);
  }));
  return fit_harmonic(record, w);
}

TEST(hull_run, regular_waves_give_the_linear_answer_of_the_files_coefficients) {
  Vec6 max_value = Vec6::Zero();  // of each freedom over the cases
  std::vector<std::pair<CVec6, CVec6>> pairs;
  for (const double omega : {0.5, 0.725, 0.825, 1.0}) {
    const std::size_t i = frequency(omega);
    const double w = data().radiation[i].omega;
    for (const int heading : {6, 9, 12}) {  // 90, 135, 180 deg
      const Hull& hull = testing::made_bgl1_hull().hull;
      const CVec6 exact = linear_answer(hull, soft_springs(hull.drawn), i, static_cast<std::size_t>(heading));
      pairs.emplace_back(answer_in_waves(w, heading * 15.0 * kDegree, 0.1, 0.0), exact);
      max_value = max_value.cwiseMax(exact.cwiseAbs());
    }
  }
  for (const auto& [found, exact] : pairs) {
    for (int k = 0; k < 6; ++k) {
      EXPECT_LT(std::abs(found(k) - exact(k)), 0.01 * max_value(k)) << k << ' ' << exact.transpose();
    }
  }
}

TEST(hull_run, answer_in_waves_does_not_depend_on_the_heading_in_the_world) {
  const CVec6 east = answer_in_waves(0.7, 2.0, 0.25, 0.0), turned = answer_in_waves(0.7, 2.0, 0.25, 2.5);
  EXPECT_LT((east - turned).norm(), 1e-4 * east.norm());  // soft springs stand along the world's axes, alike in x and y
}

TEST(hull_run, error_falls_with_the_square_of_the_step) {
  const CVec6 a = answer_in_waves(0.825, 1.9, 0.4, 0.0), b = answer_in_waves(0.825, 1.9, 0.2, 0.0),
              c = answer_in_waves(0.825, 1.9, 0.1, 0.0);
  for (const int k : {2, 3, 4}) {
    EXPECT_NEAR(std::log2(std::abs(a(k) - b(k)) / std::abs(b(k) - c(k))), 2.0, 0.1) << k;
  }
}

TEST(hull_run, irregular_sea_gives_the_motion_of_the_raos) {
  const Sea sea = testing::long_crested(2.0, 10.0, 0.5 * kPi, 4, 120);
  Hull hull = testing::bgl1_in(sea, WaveDrift::none);
  hull.build_up = 100.0;
  Description description = testing::bgl1_hull_description();
  description.vessel.motion = VesselMotion::raos;
  description.vessel.raos = testing::bgl1_raos();
  const VesselMotionModel by_raos = make_vessel_motion(build_model(description), sea);
  HullState state = make_static_hull(hull, hull.drawn);
  const HullSprings springs = soft_springs(hull.drawn);
  find_hull_acceleration(hull, springs, -100.0, state);
  Vec6 aa = Vec6::Zero(), bb = aa, ab = aa;
  ASSERT_TRUE(run_hull(hull, springs, kRadius, -100.0, 0.1, 7000, state, [&](double t, const HullState& s) {
    if (t < 0.0) return;
    const RigidMotion m = vessel_motion(by_raos, t, {});
    const Vec6 a = freedoms_from(s.h, hull.drawn), b = Eigen::Map<const Vec6>(m.freedoms.data());
    aa += a.cwiseAbs2();
    bb += b.cwiseAbs2();
    ab += a.cwiseProduct(b);
  }));
  for (const int k : {2, 3}) {
    EXPECT_NEAR(std::sqrt(aa(k) / bb(k)), 1.0, 0.02) << k;
    EXPECT_GT(ab(k) / std::sqrt(aa(k) * bb(k)), 0.99) << k;
  }
}

TEST(hull_run, hull_turns_all_the_way_round_and_its_forces_with_it) {
  // A slow turn by a spring that is drawn ahead: 400 deg in 1,000 s in waves from one side.
  const Sea sea = testing::regular_sea(1.0, data().radiation[frequency(0.825)].omega, 0.5 * kPi);
  Hull hull = testing::bgl1_in(sea, WaveDrift::newman);
  HullSprings springs = testing::on_eight_lines(hull.drawn);
  springs.damping.diagonal() << 8e5, 1e6, 0.0, 0.0, 0.0, 2e9;
  HullState state = make_static_hull(hull, hull.drawn), scratch = state;
  find_hull_acceleration(hull, springs, 0.0, state);
  const GeneralizedAlpha scheme(kRadius);
  double before = 0.0;
  for (int i = 1; i <= 4000; ++i) {
    const double t = 0.25 * i;
    springs.rest(5) = hull.drawn(5) + 400.0 * kDegree * t / 1000.0;
    ASSERT_TRUE(hull_step(hull, springs, scheme, t, 0.25, state, scratch).converged) << t;
    ASSERT_LT(std::abs(state.h(5) - before), 0.05) << t;  // no jump at a whole turn
    before = state.h(5);
  }
  EXPECT_NEAR(state.h(5) / kDegree, 400.0, 8.0);
  const Vec6 local = wave_force(hull.waves, 1000.0, state.slow.value).drift;
  const Vec6 wrapped = wave_force(hull.waves, 1000.0, state.slow.value - Vec3(0.0, 0.0, 2.0 * kPi)).drift;
  EXPECT_LT((local - wrapped).norm(), 1e-9 * local.norm());
}

TEST(hull_run, parts_of_the_damping_are_those_of_an_independent_program) {
  const Sea sea = testing::long_crested(4.0, 12.9, 0.5 * kPi, 1, 2000);
  Hull hull = testing::made_bgl1_hull().hull;
  hull.drift_damping = wave_drift_damping(data(), sea, 0.0);
  HullCurrent& current = hull.current;
  current.form = HullCurrentModel::strips;
  current.velocity = {0.0, 1.02};
  current.length = 120.0;
  current.beam = 30.0;
  current.draught = 5.182;
  current.reference_V = hull.reference_V;
  current.transverse = 1.2;
  current.longitudinal = 0.5;
  current.wetted_surface = 5155.0;
  const auto modes = horizontal_damping(hull, data(), testing::on_eight_lines(hull.drawn).stiffness);
  EXPECT_NEAR(modes[0].period, 66.96, 0.3);
  EXPECT_NEAR(modes[1].period, 77.15, 0.4);
  EXPECT_NEAR(modes[2].period, 44.64, 0.2);
  EXPECT_NEAR(modes[1].critical, 4.54e6, 0.02e6);
  EXPECT_NEAR(modes[1].drift, 0.032, 0.001);
  EXPECT_NEAR(modes[1].current, 0.17, 0.003);
  EXPECT_NEAR(modes[1].radiation, 0.0002, 0.0002);
}

}  // namespace
}  // namespace overbend
