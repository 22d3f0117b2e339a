#include "hull/hull_run.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

#include "hull/damping_ratios.h"
#include "support/hull_case.h"
#include "support/rao_files.h"

namespace overbend {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDeg = kPi / 180.0;
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

Mat6 inertia_of(const Hull& hull) {
  Mat6 M = Mat6::Zero();
  M.topLeftCorner<3, 3>().diagonal().setConstant(hull.body.mass);
  M.bottomRightCorner<3, 3>() = hull.body.inertia;
  return M;
}

/// Complex motion per wave amplitude by the file's added mass and damping at one of its frequencies; i in the file.
CVec6 linear_answer(const Hull& hull, const HullSprings& springs, std::size_t i, std::size_t heading) {
  const RadiationPoint& point = data().radiation[i];
  const double w = point.omega;
  const CMat6 Z = (hull.hydrostatics + springs.stiffness - w * w * (inertia_of(hull) + point.added_mass))
                      .cast<std::complex<double>>() +
                  std::complex<double>(0.0, w) *
                      (point.damping + hull.damping.linear + springs.damping).cast<std::complex<double>>();
  return Z.partialPivLu().solve(data().force[data().excitation.index(i, heading)]);
}

/// Amplitude of exp(i w t) in a record of equal steps over whole periods, least squares with a mean and a trend.
CVec6 harmonic_of(const std::vector<std::pair<double, Vec6>>& record, double w) {
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
  HullState state = hull_at_rest(hull, hull.drawn);
  HullSprings springs = soft_springs(hull.drawn);
  find_hull_acceleration(hull, springs, -hull.build_up, state);
  const double start = -hull.build_up, settled = 100.0, end = settled + 4.0 * 2.0 * kPi / w;
  std::vector<std::pair<double, Vec6>> record;
  const int steps = static_cast<int>((end - start) / step);
  EXPECT_TRUE(run_hull(hull, springs, kRadius, start, step, steps, state, [&](double t, const HullState& s) {
    if (t > settled) record.emplace_back(t, freedoms_from(s.h, hull.drawn) / amplitude);
  }));
  return harmonic_of(record, w);
}

TEST(hull_run, regular_waves_give_the_linear_answer_of_the_files_coefficients) {
  Vec6 largest = Vec6::Zero();  // of each freedom over the cases
  std::vector<std::pair<CVec6, CVec6>> pairs;
  for (const double omega : {0.5, 0.725, 0.825, 1.0}) {
    const std::size_t i = frequency(omega);
    const double w = data().radiation[i].omega;
    for (const int heading : {6, 9, 12}) {  // 90, 135, 180 deg
      const Hull& hull = testing::made_bgl1_hull().hull;
      const CVec6 exact = linear_answer(hull, soft_springs(hull.drawn), i, static_cast<std::size_t>(heading));
      pairs.emplace_back(answer_in_waves(w, heading * 15.0 * kDeg, 0.1, 0.0), exact);
      largest = largest.cwiseMax(exact.cwiseAbs());
    }
  }
  for (const auto& [found, exact] : pairs) {
    for (int k = 0; k < 6; ++k) {
      EXPECT_LT(std::abs(found(k) - exact(k)), 0.01 * largest(k)) << k << ' ' << exact.transpose();
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
  HullState state = hull_at_rest(hull, hull.drawn);
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

struct Extremum {
  double t, value;
};

/// Turning points of a freedom after a release, by parabolas.
std::vector<Extremum> decay(Vec6 offset, int mode, double step, double end, std::vector<Extremum>* values = nullptr) {
  const Hull& hull = testing::made_bgl1_hull().hull;
  HullState state = hull_at_rest(hull, hull.drawn + offset);
  find_hull_acceleration(hull, {}, 0.0, state);
  std::vector<Extremum> found;
  Extremum last[2] = {{0.0, offset(mode)}, {0.0, offset(mode)}};
  EXPECT_TRUE(
      run_hull(hull, {}, kRadius, 0.0, step, static_cast<int>(end / step), state, [&](double t, const HullState& s) {
        const double x = s.h(mode) - hull.drawn(mode), b = last[1].value, a = last[0].value;
        if (values) values->push_back({t, x});
        if (last[0].t > 0.0 && (b - a) * (x - b) < 0.0) {
          const double slope = 0.5 * (x - a), curve = x - 2.0 * b + a;
          found.push_back({t - step - step * slope / curve, b - 0.5 * slope * slope / curve});
        }
        last[0] = last[1];
        last[1] = {t, x};
      }));
  return found;
}

TEST(hull_run, heave_decays_as_by_direct_convolution) {
  // An independent program's convolution of the same file, with the added mass that belongs to its kernel.
  std::vector<Extremum> z;
  const std::vector<Extremum> found = decay(Vec6::Unit(2), 2, 0.02, 13.0, &z);
  const std::pair<int, double> expected[] = {{1, 0.7484},  {2, 0.1523},  {3, -0.4299}, {4, -0.6894},
                                             {5, -0.5528}, {6, -0.1842}, {8, 0.3012},  {10, 0.0346}};
  for (const auto& [t, value] : expected) {
    EXPECT_NEAR(z[static_cast<std::size_t>(50 * t - 1)].value, value, 0.002) << t;
  }
  const Extremum extrema[] = {{4.12, -0.6925}, {8.08, 0.3021}, {11.76, -0.1537}};
  ASSERT_GE(found.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(found[i].value, extrema[i].value, 0.002);
    EXPECT_NEAR(found[i].t, extrema[i].t, 0.03);
  }
}

TEST(hull_run, roll_decays_as_by_direct_convolution_with_sway_and_yaw_free) {
  const std::vector<Extremum> found = decay(5.0 * kDeg * Vec6::Unit(3), 3, 0.02, 17.5);
  const Extremum expected[] = {{4.08, -4.170}, {8.18, 3.350}, {12.30, -2.649}, {16.40, 2.087}};
  ASSERT_GE(found.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(found[i].value / kDeg, expected[i].value, 0.02);
    EXPECT_NEAR(found[i].t, expected[i].t, 0.02);
  }
}

TEST(hull_run, pitch_decays_as_by_direct_convolution_with_surge_free) {
  const std::vector<Extremum> found = decay(2.0 * kDeg * Vec6::Unit(4), 4, 0.02, 15.0);
  const Extremum expected[] = {{3.70, -1.6645}, {7.40, 1.0074}, {10.96, -0.5012}, {14.30, 0.2602}};
  ASSERT_GE(found.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(found[i].value / kDeg, expected[i].value, 0.01);
    EXPECT_NEAR(found[i].t, expected[i].t, 0.03);
  }
}

/// Stiffness of eight lines at 300 kN about the centre of gravity.
HullSprings moored(const Vec6& rest) {
  HullSprings springs;
  Mat6& K = springs.stiffness;
  K.diagonal() << 1.8479e5, 1.8479e5, 1.1845e4, 2.7285e6, 1.3382e8, 5.1281e8;
  K(0, 4) = K(4, 0) = 2.455e6;
  K(1, 3) = K(3, 1) = -9.4315e5;
  springs.rest = rest;
  return springs;
}

TEST(hull_run, moored_hull_swings_with_its_natural_periods) {
  // Eigenvalues of hull, fitted memory and stiffness by an independent program: 66.96, 77.15, 44.64 s.
  const Hull& hull = testing::made_bgl1_hull().hull;
  const HullSprings springs = moored(hull.drawn);
  const std::pair<int, double> expected[] = {{0, 66.96}, {1, 77.15}, {5, 44.64}};
  for (const auto& [mode, period] : expected) {
    const double kick = mode == 5 ? 1.0 * kDeg : 1.0;
    HullState state = hull_at_rest(hull, hull.drawn + kick * Vec6::Unit(mode));
    find_hull_acceleration(hull, springs, 0.0, state);
    std::vector<double> crossings;
    double before = kick, peak = 0.0;
    ASSERT_TRUE(run_hull(hull, springs, kRadius, 0.0, 0.25, 1600, state, [&](double t, const HullState& s) {
      const double x = s.h(mode) - hull.drawn(mode);
      if (before > 0.0 && x <= 0.0) crossings.push_back(t - 0.25 * x / (x - before));
      before = x;
      if (t > 300.0) peak = std::max(peak, std::abs(x));
    }));
    const auto n = static_cast<double>(crossings.size() - 1);
    EXPECT_NEAR((crossings.back() - crossings.front()) / n, period, 0.005 * period) << mode;
    EXPECT_LT(peak, kick) << mode;
    EXPECT_GT(peak, 0.9 * kick) << mode;  // radiation alone damps by 0.02 % of critical
  }
}

TEST(hull_run, energy_of_the_moored_hull_in_calm_water_never_grows) {
  const Hull& hull = testing::made_bgl1_hull().hull;
  const HullSprings springs = moored(hull.drawn);
  HullState state = hull_at_rest(hull, hull.drawn + Vec6((Vec6() << 1, 1, 1, kDeg, kDeg, kDeg).finished()));
  find_hull_acceleration(hull, springs, 0.0, state);
  const auto held = [&](const HullState& s) {
    const HullEnergy e = hull_energy(hull, s, 0.0);
    const Vec6 off = s.h - springs.rest;
    return e.kinetic + e.hydrostatic + 0.5 * off.dot(springs.stiffness * off);
  };
  // What the water around the hull holds comes and goes, but never more than was put in; and the slow swings, after
  // heave, roll and pitch have died out, shrink from each 400 s to the next.
  const double most = held(state);
  std::vector<Vec6> largest;
  ASSERT_TRUE(run_hull(hull, springs, kRadius, 0.0, 0.5, 21600, state, [&](double t, const HullState& s) {
    EXPECT_LE(held(s), most) << t;
    if (t > 400.0 * static_cast<double>(largest.size())) largest.push_back(Vec6::Zero());
    largest.back() = largest.back().cwiseMax((s.h - springs.rest).cwiseAbs());
  }));
  ASSERT_EQ(largest.size(), 27U);
  for (std::size_t i = 2; i < largest.size(); ++i) {
    // The largest of ten swings or so, seen every half second.
    for (const int k : {0, 1, 5}) EXPECT_LT(largest[i](k), largest[i - 1](k) * 1.0005) << i << ' ' << k;
  }
  for (const int k : {0, 1, 5}) EXPECT_LT(largest.back()(k), 0.95 * largest[1](k));
}

TEST(hull_run, energy_balance_closes_with_the_square_of_the_step) {
  Hull hull = testing::bgl1_in(testing::long_crested(2.5, 9.0, 1.2, 3, 60), WaveDrift::newman);
  hull.damping.quadratic(3) = 1e9;
  const HullSprings springs = moored(hull.drawn);
  const auto drift = [&](double step) {
    HullState state = hull_at_rest(hull, hull.drawn);
    find_hull_acceleration(hull, springs, 0.0, state);
    double work = 0.0, last = hull_energy(hull, state, 0.0).power(), size = 0.0, error = 0.0;
    EXPECT_TRUE(run_hull(hull, springs, 1.0, 0.0, step, static_cast<int>(100.0 / step), state,
                         [&](double t, const HullState& s) {
                           const HullEnergy e = hull_energy(hull, s, t);
                           work += 0.5 * step * (last + e.power());
                           last = e.power();
                           const Vec6 off = s.h - springs.rest;
                           const double held = e.kinetic + e.hydrostatic + 0.5 * off.dot(springs.stiffness * off);
                           size = std::max(size, held);
                           error = std::max(error, std::abs(held - work));
                         }));
    return error / size;
  };
  const double coarse = drift(0.2), fine = drift(0.1);
  EXPECT_LT(fine, 3e-3);
  EXPECT_GT(coarse / fine, 3.0);
}

TEST(hull_run, hull_turns_all_the_way_round_and_its_forces_with_it) {
  // A slow turn by a spring that is drawn ahead: 400 deg in 1,000 s in waves from one side.
  const Sea sea = testing::regular_sea(1.0, data().radiation[frequency(0.825)].omega, 0.5 * kPi);
  Hull hull = testing::bgl1_in(sea, WaveDrift::newman);
  HullSprings springs = moored(hull.drawn);
  springs.damping.diagonal() << 8e5, 1e6, 0.0, 0.0, 0.0, 2e9;
  HullState state = hull_at_rest(hull, hull.drawn), scratch = state;
  find_hull_acceleration(hull, springs, 0.0, state);
  const GeneralizedAlpha scheme(kRadius);
  double before = 0.0;
  for (int i = 1; i <= 4000; ++i) {
    const double t = 0.25 * i;
    springs.rest(5) = hull.drawn(5) + 400.0 * kDeg * t / 1000.0;
    ASSERT_TRUE(hull_step(hull, springs, scheme, t, 0.25, state, scratch).converged) << t;
    ASSERT_LT(std::abs(state.h(5) - before), 0.05) << t;  // no jump at a whole turn
    before = state.h(5);
  }
  EXPECT_NEAR(state.h(5) / kDeg, 400.0, 8.0);
  const Vec6 here = wave_force(hull.waves, 1000.0, state.slow.value).drift;
  const Vec6 wrapped = wave_force(hull.waves, 1000.0, state.slow.value - Vec3(0.0, 0.0, 2.0 * kPi)).drift;
  EXPECT_LT((here - wrapped).norm(), 1e-9 * here.norm());
}

TEST(hull_run, parts_of_the_damping_are_those_of_an_independent_program) {
  const Sea sea = testing::long_crested(4.0, 12.9, 0.5 * kPi, 1, 2000);
  Hull hull = testing::made_bgl1_hull().hull;
  hull.drift_damping = wave_drift_damping(data(), sea, 0.0);
  HullCurrent& current = hull.current;
  current.form = HullCurrentForm::strips;
  current.velocity = {0.0, 1.02};
  current.length = 120.0;
  current.beam = 30.0;
  current.draught = 5.182;
  current.reference_V = hull.reference_V;
  current.transverse = 1.2;
  current.longitudinal = 0.5;
  current.wetted_surface = 5155.0;
  const auto modes = horizontal_damping(hull, data(), moored(hull.drawn).stiffness);
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
