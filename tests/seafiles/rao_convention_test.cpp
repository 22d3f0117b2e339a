#include "seafiles/rao_convention.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/constants.h"
#include "model/waves/wave_theory.h"

namespace overbend {
namespace {

constexpr double kDepth = 89.0;

/// The convention of the house with one word changed.
RaoTranslation with(const std::string& key, const std::string& word, double length_scale = 1.0) {
  ConventionValues convention = convention_set("house");
  convention[key] = word;
  return {convention, length_scale, kDepth};
}

RaoRecord record(int freedom, double amplitude, double phase) {
  return {.heading = 0.0, .omega = 0.6, .freedom = freedom, .amplitude = amplitude, .phase = phase, .line = 1};
}

void expect_near(std::complex<double> a, std::complex<double> b) {
  EXPECT_NEAR(std::abs(a - b), 0.0, 1e-14 * std::max(1.0, std::abs(b)));
}

TEST(rao_convention, every_set_settles_every_key_with_one_of_its_names) {
  for (const std::string& set : convention_sets()) {
    const ConventionValues convention = convention_set(set);
    EXPECT_EQ(convention.size(), convention_keys().size()) << set;
    for (const ConventionKey& key : convention_keys()) {
      EXPECT_NE(std::find(key.values.begin(), key.values.end(), convention.at(key.key)), key.values.end())
          << set << key.key;
    }
  }
}

TEST(rao_convention, a_key_that_is_not_settled_is_a_broken_promise) {
  for (const ConventionKey& key : convention_keys()) {
    ConventionValues convention = convention_set("house");
    convention.erase(key.key);
    EXPECT_THROW(RaoTranslation(convention, 1.0, kDepth), std::logic_error) << key.key;
  }
}

TEST(rao_convention, headings_of_the_house_are_directions_of_travel) {
  const RaoTranslation house(convention_set("house"), 1.0, kDepth);
  EXPECT_NEAR(house.heading(30.0 * kDegree), 30.0 * kDegree, 1e-15);
  EXPECT_NEAR(house.heading(-30.0 * kDegree), 330.0 * kDegree, 1e-14);
  EXPECT_EQ(house.heading(2.0 * kPi), 0.0);
}

// Heading 0 meets the bow: the wave travels astern. Counted clockwise, 30 deg turns it to starboard of that.
TEST(rao_convention, headings_may_count_from_the_bow_and_clockwise) {
  EXPECT_NEAR(with("heading_zero", "bow").heading(0.0), kPi, 1e-15);
  EXPECT_NEAR(with("heading_sense", "clockwise").heading(30.0 * kDegree), 330.0 * kDegree, 1e-14);
}

TEST(rao_convention, a_lead_is_a_lag_backwards) {
  const RaoRecord heave = record(2, 0.8, 0.7);
  expect_near(with("phase", "lag").response(heave), std::polar(0.8, -0.7));
  expect_near(with("phase", "lead").response(heave), std::polar(0.8, 0.7));
}

// A motion in step with the trough is half a period behind the crest, one in step with the crossing before the crest a
// quarter ahead of it.
TEST(rao_convention, phases_may_count_from_any_event_of_the_wave) {
  const RaoRecord heave = record(2, 1.0, 0.0);
  expect_near(with("phase_zero", "crest").response(heave), {1.0, 0.0});
  expect_near(with("phase_zero", "trough").response(heave), {-1.0, 0.0});
  expect_near(with("phase_zero", "up_crossing").response(heave), {0.0, 1.0});
  expect_near(with("phase_zero", "down_crossing").response(heave), {0.0, -1.0});
}

TEST(rao_convention, rotations_come_in_rad_per_metre) {
  const double k = linear_wave_number(0.6, kDepth);
  const RaoRecord pitch = record(4, 2.0, 0.0);
  EXPECT_NEAR(with("rotation", "deg_per_m").response(pitch).real(), 2.0 * kDegree, 1e-15);
  EXPECT_NEAR(with("rotation", "rad_per_m").response(pitch).real(), 2.0, 1e-15);
  EXPECT_NEAR(with("rotation", "per_slope").response(pitch).real(), 2.0 * k, 1e-14);
  EXPECT_NEAR(with("rotation", "rad_per_steepness").response(pitch).real(), 2.0 * k / kPi, 1e-14);
  EXPECT_NEAR(with("rotation", "deg_per_steepness").response(pitch).real(), 2.0 * kDegree * k / kPi, 1e-15);
  EXPECT_NEAR(with("rotation", "rad_per_m", 4.0).response(pitch).real(), 0.5, 1e-15);
  // Translations are per metre for any unit of the rotations.
  EXPECT_NEAR(with("rotation", "per_slope", 4.0).response(record(0, 2.0, 0.0)).real(), 2.0, 1e-15);
}

TEST(rao_convention, the_other_word_for_positive_turns_the_sign_of_its_freedom_alone) {
  int freedom = 0;
  for (const ConventionKey& key : convention_keys()) {
    if (key.key.rfind("positive.", 0) != 0) continue;
    for (int second = 0; second < 6; ++second) {
      const double sign = second == freedom ? -1.0 : 1.0;
      const RaoRecord motion = record(second, 1.0, 0.4);
      expect_near(with(key.key, key.values[1]).response(motion), sign * with(key.key, key.values[0]).response(motion));
    }
    ++freedom;
  }
  EXPECT_EQ(freedom, 6);
}

}  // namespace
}  // namespace overbend
