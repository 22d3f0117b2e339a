// The sphere of IEA OES Task 10 with a damper on its heave, in regular waves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "support/hull_case.h"

namespace overbend {
namespace {

const HydrodynamicData& data() {
  static const HydrodynamicData kData = testing::good_hydrodynamics(
      {.path = std::string(OVERBEND_SOURCE_DIR) + "/validation/sphere/sphere", .water_density = 1000.0});
  return kData;
}

/// Radius 5 m, half submerged; inertias are of no account for its heave. Its memory is by direct convolution.
Hull sphere() {
  Hull hull;
  hull.body.mass = 261800.0;
  hull.body.inertia = 3e6 * Mat3::Identity();
  hull.hydrostatics.block<3, 3>(2, 2) = data().hydrostatic_stiffness.block<3, 3>(2, 2);
  hull.radiation = make_radiation(data(), Radiation::convolution).model;
  return hull;
}

struct Case {
  double period, damper, expected;
};

TEST(sphere_in_waves, heaves_as_by_the_frequency_domain_and_another_program) {
  const Hull plain = sphere();
  // Heave per wave amplitude of the frequency domain with these files; HydroChrono's time-domain results, within 0.9 %
  // of them: 0.0788 0.5886 0.8307 0.6982.
  const Case cases[] = {
      {3.0, 398736.034, 0.0782}, {4.0, 118149.758, 0.5844}, {5.0, 161048.558, 0.8336}, {11.0, 1077123.445, 0.7020}};
  for (const Case& c : cases) {
    Hull hull = plain;
    WaveComponent wave;
    wave.amplitude = 0.01;
    wave.omega = kTurn / c.period;
    wave.kx = 1.0;
    hull.waves = make_hull_waves(data(), make_sea({wave}, 50.0), WaveDrift::none, 2.5, 0.0);
    hull.build_up = 3.0 * c.period;
    HullSprings springs;
    springs.stiffness.diagonal() << 1e4, 1e4, 0.0, 0.0, 0.0, 1e4;
    springs.damping.diagonal() << 5e4, 5e4, c.damper, 1e5, 1e5, 1e5;
    HullState state = make_static_hull(hull, Vec6::Zero());
    const double step = c.period / 40.0, start = -hull.build_up;
    find_hull_acceleration(hull, springs, start, state);
    double cosine = 0.0, sine = 0.0;
    // The last two of ten periods; heave has settled by then.
    ASSERT_TRUE(run_hull(hull, springs, 0.9, start, step, 40 * 13, state, [&](double t, const HullState& s) {
      if (t <= 8.0 * c.period + 0.5 * step) return;
      cosine += s.h(2) * std::cos(wave.omega * t) / 40.0;
      sine += s.h(2) * std::sin(wave.omega * t) / 40.0;
    }));
    EXPECT_NEAR(std::hypot(cosine, sine) / 0.01, c.expected, 0.01 * c.expected) << c.period;
  }
}

}  // namespace
}  // namespace overbend
