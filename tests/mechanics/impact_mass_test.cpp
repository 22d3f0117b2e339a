#include "mechanics/impact_mass.h"

#include <gtest/gtest.h>

#include <cmath>

namespace overbend {
namespace {

// m = 2 m' c_b/w with w = sqrt(k/m): the closed form solves it.
TEST(impact_mass, is_what_the_beam_is_as_a_mass_at_the_frequency_of_its_own_contact) {
  const double line = 230.0, EI = 55.9e6, k = 20e6;
  const double m = impact_mass(line, EI, k), w = std::sqrt(k / m);
  EXPECT_NEAR(m, 2.0 * line * std::pow(EI * w * w / line, 0.25) / w, 1e-9 * m);
}

}  // namespace
}  // namespace overbend
