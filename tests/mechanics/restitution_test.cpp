#include "mechanics/restitution.h"

#include <gtest/gtest.h>

#include <cmath>

namespace overbend {
namespace {

struct Rebound {
  double speed, time;
};

/// A unit mass on a unit spring hits at unit speed. Integrated by Runge-Kutta of fourth order until the force passes
/// zero (`clipped`) or the penetration does.
Rebound rebound(double zeta, bool clipped) {
  const auto rate = [zeta](double x, double v) { return -x - 2.0 * zeta * v; };
  const double h = 1e-3 / (1.0 + zeta);  // stiff dashpots have short times
  double x = 0.0;
  double v = 1.0;
  double t = 0.0;
  double ending = -1.0;
  while (true) {
    const double k1x = v, k1v = rate(x, v);
    const double k2x = v + 0.5 * h * k1v, k2v = rate(x + 0.5 * h * k1x, k2x);
    const double k3x = v + 0.5 * h * k2v, k3v = rate(x + 0.5 * h * k2x, k3x);
    const double k4x = v + h * k3v, k4v = rate(x + h * k3x, k4x);
    const double x1 = x + h / 6.0 * (k1x + 2.0 * k2x + 2.0 * k3x + k4x);
    const double v1 = v + h / 6.0 * (k1v + 2.0 * k2v + 2.0 * k3v + k4v);
    const double current = clipped ? rate(x1, v1) : -x1;  // negative while in contact
    if (current >= 0.0) {
      const double part = -ending / (current - ending);
      return {-(v + part * (v1 - v)), t + part * h};
    }
    x = x1, v = v1, t += h, ending = current;
  }
}

TEST(restitution, of_a_contact_that_never_pulls_is_what_integration_gives_below_at_and_above_critical_damping) {
  for (const double zeta : {0.01, 0.1, 0.3, 0.7071, 0.9, 0.99999, 1.0, 1.00001, 1.2, 2.0, 5.0}) {
    const double expected = rebound(zeta, true).speed;
    // Linear search for the end within a step of 1e-3 periods: below 1e-6 of the speed.
    EXPECT_NEAR(compute_restitution(zeta), expected, 1e-6) << "damping ratio " << zeta;
  }
}

TEST(restitution, has_the_known_values) {
  const double pairs[][2] = {{0.8, 0.0744}, {0.6, 0.181}, {0.5, 0.255}, {0.4, 0.355}, {0.3, 0.497}, {0.2, 0.731}};
  for (const auto& [e, zeta] : pairs) {
    EXPECT_NEAR(damping_ratio(e, RestitutionForm::clipped), zeta, 0.0006);  // three digits are published
  }
  EXPECT_NEAR(compute_restitution(1.0), std::exp(-2.0), 1e-15);
}

TEST(restitution, is_given_back_by_its_damping_over_the_whole_range) {
  double last = kMaxDampingRatio;
  for (double e = 0.003; e < 1.0; e += 0.001) {
    const double zeta = damping_ratio(e, RestitutionForm::clipped);
    EXPECT_NEAR(compute_restitution(zeta), e, 1e-14);
    EXPECT_LT(zeta, last);
    last = zeta;
  }
}

TEST(restitution, is_smooth_across_critical_damping) {
  for (const double edge : {1.0 - 1e-4, 1.0 + 1e-4}) {  // where series and closed forms meet
    EXPECT_NEAR(compute_restitution(edge - 1e-12), compute_restitution(edge + 1e-12), 1e-11);
  }
}

TEST(restitution, textbook_form_presumes_a_contact_that_pulls) {
  for (const double e : {0.1, 0.4, 0.8}) {
    const double zeta = damping_ratio(e, RestitutionForm::textbook);
    EXPECT_NEAR(rebound(zeta, false).speed, e, 1e-6);
    EXPECT_GT(rebound(zeta, true).speed, e);
  }
  EXPECT_NEAR(compute_restitution(damping_ratio(0.4, RestitutionForm::textbook)), 0.47, 0.005);
  EXPECT_NEAR(compute_restitution(damping_ratio(0.1, RestitutionForm::textbook)), 0.25, 0.005);
}

TEST(restitution, ends_of_the_range_have_finite_damping) {
  for (const RestitutionForm form : {RestitutionForm::clipped, RestitutionForm::textbook}) {
    EXPECT_EQ(damping_ratio(1.0, form), 0.0);
  }
  EXPECT_EQ(damping_ratio(0.0, RestitutionForm::clipped), kMaxDampingRatio);
  EXPECT_EQ(damping_ratio(0.0, RestitutionForm::textbook), 1.0);
  EXPECT_LT(compute_restitution(kMaxDampingRatio), 0.0025);
}

}  // namespace
}  // namespace overbend
