#include "seafiles/motion_record_checks.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "base/constants.h"
#include "base/random.h"
#include "seafiles/motion_history_reader.h"
#include "support/rao_files.h"

namespace overbend {
namespace {

using Row = std::array<double, 6>;  // in the units of the columns
using Motion = std::function<Row(double)>;

struct Sampling {
  double step = 0.5;
  int rows = 240;
  int decimals = 4;
};

/// A swell of 8 s: heave of 1 m, roll and pitch of some degrees.
Row swell(double t) {
  const double phase = 2.0 * std::numbers::pi / 8.0 * t;
  return {0.4 * std::cos(phase),       0.2 * std::sin(phase), std::sin(phase),
          3.0 * std::sin(phase + 0.4), 1.5 * std::cos(phase), 0.5 * std::sin(phase)};
}

std::string written(const Motion& motion, const Sampling& s) {
  std::string text = "time_s,surge_m,sway_m,heave_m,roll_deg,pitch_deg,yaw_deg\n";
  for (int i = 0; i < s.rows; ++i) {
    const double t = s.step * i;
    text += fmt::format("{:.3f}", t);
    for (const double value : motion(t)) text += fmt::format(",{:.{}f}", value, s.decimals);
    text += "\n";
  }
  return text;
}

struct Reading {
  std::optional<MotionHistory> history;
  std::vector<std::string> warnings, errors;
};

Reading read(const std::string& text, double heading = 0.0) {
  const testing::WrittenFile file("motion.csv", text);
  Diagnostics diagnostics;
  Reading reading;
  reading.history = read_motion_history(file.path(), heading, diagnostics);
  reading.warnings = diagnostics.lines(Severity::warning);
  reading.errors = diagnostics.lines(Severity::error);
  return reading;
}

Reading read(const Motion& motion, const Sampling& sampling = {}, double heading = 0.0) {
  return read(written(motion, sampling), heading);
}

bool says(const std::vector<std::string>& lines, const std::string& message) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return line.find(message) != std::string::npos; });
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// A random sea of three hours with the spectrum of a narrow band about 9 s, and slow drift of surge.
Motion random_motion() {
  auto phases = std::make_shared<std::vector<Vec3>>();
  Random random(7);
  for (int k = 0; k < 80; ++k) {
    phases->push_back(Vec3(random.uniform(), random.uniform(), random.uniform()) * 2.0 * std::numbers::pi);
  }
  return [phases](double t) {
    Row row{};
    for (std::size_t k = 0; k < phases->size(); ++k) {
      const double omega = 0.35 + 0.01 * static_cast<double>(k) * 1.037;
      const double size = std::exp(-std::pow((omega - 0.7) / 0.12, 2));
      const Vec3& phase = (*phases)[k];
      row[0] += 0.15 * size * std::cos(omega * t + phase(0));
      row[2] += 0.3 * size * std::cos(omega * t + phase(1));
      row[3] += 0.8 * size * std::cos(omega * t + phase(2));
      row[4] += 0.5 * size * std::sin(omega * t + phase(1));
    }
    row[0] += 4.0 * std::sin(2.0 * std::numbers::pi / 90.0 * t);
    row[5] = 1.2 * std::sin(2.0 * std::numbers::pi / 140.0 * t);
    return row;
  };
}

TEST(motion_record_checks, a_sound_record_is_taken_without_a_word) {
  EXPECT_EQ(joined(read(swell).warnings), "");
  for (const int decimals : {1, 2, 4}) {
    EXPECT_EQ(joined(read(random_motion(), {0.5, 21600, decimals}).warnings), "") << decimals;
  }
  EXPECT_EQ(joined(read(random_motion(), {0.1, 20000, 3}).warnings), "");
}

TEST(motion_record_checks, a_motion_that_grows_has_no_leaps) {
  const auto growing = [](double t) {
    Row row = swell(t);
    for (double& value : row) value *= std::exp(0.02 * (t - 120.0));
    return row;
  };
  EXPECT_EQ(joined(read(growing).warnings), "");
}

TEST(motion_record_checks, a_heading_that_passes_north_is_continuous) {
  const auto compass = [](double t) {
    Row row = swell(t);
    row[5] = std::fmod(row[5] + 359.9, 360.0);
    return row;
  };
  const Reading reading = read(compass);
  ASSERT_TRUE(reading.history) << joined(reading.errors);
  EXPECT_GT(reading.history->passages, 10);
  for (std::size_t i = 0; i < reading.history->time.size(); ++i) {
    const double turned = swell(reading.history->time[i])[5] - 0.1;
    EXPECT_NEAR(reading.history->freedoms[i][5] * kToDegrees, turned, 1e-4);  // four decimals
  }
  EXPECT_FALSE(says(reading.warnings, "leaps")) << joined(reading.warnings);
  EXPECT_TRUE(says(reading.warnings, "as a compass heading is")) << joined(reading.warnings);
}

TEST(motion_record_checks, the_compass_heading_in_place_of_the_deviation_is_warned_of) {
  const auto compass = [](double t) {
    Row row = swell(t);
    row[5] += 91.0;
    return row;
  };
  EXPECT_TRUE(says(read(compass, {}, 90.0 * kDegree).warnings, "it seems to be the compass heading itself"));
  EXPECT_TRUE(says(read(compass, {}, 200.0 * kDegree).warnings, "is it a compass heading?"));
}

TEST(motion_record_checks, a_spike_is_warned_of_with_row_and_value) {
  for (const double spike : {9.99, -4.0, 12.0}) {
    const auto spiked = [&](double t) {
      Row row = swell(t);
      if (t == 50.0) row[2] = spike;
      return row;
    };
    const Reading reading = read(spiked);
    ASSERT_TRUE(reading.history);
    ASSERT_EQ(reading.warnings.size(), 1U) << joined(reading.warnings);
    EXPECT_TRUE(says(reading.warnings, "motion.csv:102: heave_m jumps by")) << reading.warnings[0];
    EXPECT_TRUE(says(reading.warnings, "at t = 50 s")) << reading.warnings[0];
  }
}

TEST(motion_record_checks, steps_between_rows_beyond_a_vessel_are_warned_of_in_every_freedom) {
  const Row steps = {8.0, 8.0, 8.0, 25.0, 20.0, 12.0};
  for (std::size_t k = 0; k < 6; ++k) {
    const auto shifted = [&](double t) {
      Row row = swell(t);
      if (t > 60.0) row[k] += steps[k];
      return row;
    };
    EXPECT_TRUE(says(read(shifted).warnings, std::string(kMotionColumns[k]) + " jumps by")) << k;
  }
}

TEST(motion_record_checks, values_that_stand_for_none_are_rejected_with_the_row) {
  for (const char* value : {"999", "-999", "9999", "1e20", "-999.25", "32767"}) {
    const Reading reading =
        read(std::string("time_s,heave_m,roll_deg\n0,0.1,1\n0.5,0.2,2\n1,") + value + ",2\n1.5,0.1,1\n");
    EXPECT_FALSE(reading.history.has_value()) << value;
    ASSERT_EQ(reading.errors.size(), 1U);
    EXPECT_TRUE(says(reading.errors, "motion.csv:4: found heave_m of ")) << reading.errors[0];
    EXPECT_TRUE(says(reading.errors, "write for missing values")) << reading.errors[0];
  }
}

TEST(motion_record_checks, a_recorder_that_stops_is_warned_of) {
  for (const double held : {0.0, 0.7, 9.99}) {
    const auto frozen = [&](double t) {
      Row row = swell(t);
      if (t >= 41.0 && t < 53.0) row[2] = held;
      return row;
    };
    const Reading reading = read(frozen);
    EXPECT_TRUE(says(reading.warnings, "for 24 rows, from t = 41 s to 52.5 s")) << joined(reading.warnings);
  }
}

TEST(motion_record_checks, a_few_constant_rows_are_distinguished_by_the_digits_of_the_record) {
  const auto held_for = [](double time, int decimals) {
    const Motion motion = random_motion();
    const auto held = [=](double t) {
      Row row = motion(t);
      if (t >= 100.0 && t < 100.0 + time) row[2] = 0.0;
      return row;
    };
    return says(read(held, {0.5, 1200, decimals}).warnings, "heave_m stays at 0 m for ");
  };
  EXPECT_TRUE(held_for(4.0, 4));
  EXPECT_TRUE(held_for(4.0, 3));
  EXPECT_FALSE(held_for(4.0, 1));  // so does a crest, written in tenths
  EXPECT_TRUE(held_for(30.0, 2));
}

TEST(motion_record_checks, a_row_of_zeros_in_every_column_is_warned_of) {
  const Motion motion = random_motion();
  const auto blank = [&](double t) { return t == 60.0 ? Row{} : motion(t); };
  EXPECT_TRUE(says(read(blank).warnings, "motion.csv:122: all columns are 0 at t = 60 s; did"))
      << joined(read(blank).warnings);
  const auto from_rest = [&](double t) { return t < 60.0 ? Row{} : motion(t); };
  EXPECT_FALSE(says(read(from_rest).warnings, "all columns are 0"));
}

TEST(motion_record_checks, values_that_are_held_over_several_rows_are_warned_of) {
  const Motion motion = random_motion();
  const auto stairs = [&](double t) { return motion(std::floor(t)); };
  EXPECT_TRUE(says(read(stairs, {0.25, 2400, 4}).warnings, "heave_m repeats the previous value in 75 % of its rows"))
      << joined(read(stairs, {0.25, 2400, 4}).warnings);
}

TEST(motion_record_checks, a_mean_away_from_the_nominal_place_is_warned_of) {
  const Row means = {47.0, -20.0, 2.0, 8.0, 6.0, 30.0};
  for (std::size_t k = 0; k < 6; ++k) {
    const auto away = [&](double t) {
      Row row = swell(t);
      row[k] += means[k];
      return row;
    };
    EXPECT_TRUE(says(read(away).warnings, std::string(kMotionColumns[k]) + " is ")) << k;
  }
}

TEST(motion_record_checks, angles_in_another_unit_are_suspicious) {
  const auto in_radians = [](double t) {
    Row row = swell(t);
    for (std::size_t k = 3; k < 6; ++k) row[k] *= kDegree;
    return row;
  };
  EXPECT_TRUE(says(read(in_radians).warnings, "in radians?"));
  const auto times_sixty = [](double t) {
    Row row = swell(t);
    row[3] *= 20.0;
    return row;
  };
  EXPECT_TRUE(says(read(times_sixty).warnings, "roll_deg is"));
  const auto centimetres = [](double t) {
    Row row = swell(t);
    row[2] *= 100.0;
    return row;
  };
  EXPECT_TRUE(says(read(centimetres).errors, "heave_m of"));
}

TEST(motion_record_checks, a_time_step_that_changes_or_is_too_long_is_warned_of) {
  std::string text = "time_s,heave_m\n";
  for (int i = 0; i < 400; ++i) {
    const double t = i < 200 ? 0.5 * i : 100.0 + 0.1 * (i - 200);
    text += fmt::format("{:.2f},{:.4f}\n", t, swell(t)[2]);
  }
  EXPECT_TRUE(says(read(text).warnings, "the time step varies between 0.1 s and 0.5 s")) << joined(read(text).warnings);
  EXPECT_TRUE(says(read(swell, {3.0, 200, 4}).warnings, "rows per mean period"));
  EXPECT_TRUE(says(read(swell, {500.0, 50, 4}).warnings, "is the time in s?"));
}

}  // namespace
}  // namespace overbend
