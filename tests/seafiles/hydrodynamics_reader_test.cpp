#include "seafiles/hydrodynamics_reader.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/constants.h"
#include "seafiles/hull_reference.h"

namespace overbend {
namespace {

HydrodynamicsSource bgl1_source() {
  HydrodynamicsSource source;
  source.path = std::string(OVERBEND_SOURCE_DIR) + "/data/bgl1/bgl1";
  source.origin_V = Vec3(0.0, 0.0, 0.818);
  return source;
}

/// Small made-up files with a stem of their own, gone at the end.
class Files {
 public:
  Files() {
    folder_ = std::filesystem::temp_directory_path() / ("overbend_hydro_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
    write(".1", good_radiation());
    write(".3", "6.0 0 1 1 0 1 0\n6.0 0 3 2 0 2 0\n6.0 180 1 1 180 -1 0\n6.0 180 3 2 0 2 0\n");
    write(".hst", "3 3 10\n4 4 20\n");
  }
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;
  ~Files() { std::filesystem::remove_all(folder_); }

  static std::string good_radiation() {
    return " heading of free text 12:18:57\n 0 3 3 0.5\n-1 3 3 0.8\n6 3 3 1 0.1\n5 3 3 2 0.2\n4 3 3 3 0.3\n3 3 3 4 "
           "0.4\n";
  }
  void write(const std::string& ending, const std::string& text) const {
    std::ofstream(folder_ / ("hull" + ending)) << text;
  }
  HydrodynamicsSource source() const {
    HydrodynamicsSource source;
    source.path = (folder_ / "hull").string();
    source.water_density = 1000.0;
    source.gravity = 10.0;
    return source;
  }

 private:
  std::filesystem::path folder_;
};

TEST(hydrodynamics_reader, gives_the_numbers_of_bgl1_their_dimension) {
  Diagnostics diagnostics;
  const auto data = read_hydrodynamics(bgl1_source(), diagnostics);
  ASSERT_TRUE(data) << diagnostics.lines(Severity::error)[0];
  ASSERT_EQ(data->radiation.size(), 49U);
  EXPECT_NEAR(data->radiation.front().omega, 0.1, 1e-6);
  EXPECT_NEAR(data->radiation.back().omega, 2.2, 1e-6);
  EXPECT_TRUE(data->has_infinite);
  EXPECT_FALSE(data->has_zero);
  EXPECT_NEAR(data->added_mass_infinite(0, 0), 6.025689e2 * 1025.0, 1.0);
  // hydrostatics_mass.json, heave stiffness rho g L B and C44 = M g GM
  EXPECT_NEAR(data->hydrostatic_stiffness(2, 2), 1025.0 * 9.81 * 3600.0, 1.0);
  EXPECT_NEAR(data->hydrostatic_stiffness(3, 3), 19121.58e3 * 9.81 * 11.064, 1e-4 * 2.075e9);
  EXPECT_EQ(data->excitation.heading.size(), 24U);
  EXPECT_EQ(data->excitation.omega.size(), 49U);
  // very long wave from astern: heave force rho g A (1 - small), surge leads by 90 deg
  EXPECT_NEAR(data->force[0](2).real() / data->hydrostatic_stiffness(2, 2), 0.96, 0.01);
  EXPECT_NEAR(std::arg(data->force[0](0)), 0.5 * kPi, 0.01);
  // mean_drift.csv at 2.2 rad/s in head seas: 0.964 of rho g B/2 against the bow
  const std::size_t head = 12;
  EXPECT_NEAR(data->drift.heading[head], kPi, 1e-12);
  EXPECT_NEAR(data->mean_drift[data->drift.index(48, head)](0), -0.964 * 1025.0 * 9.81 * 15.0, 200.0);
  EXPECT_EQ(data->mean_drift[data->drift.index(48, head)](2), 0.0);
}

TEST(hydrodynamics_reader, knows_infinite_and_zero_frequency_of_the_sphere) {
  HydrodynamicsSource source;
  source.path = std::string(OVERBEND_SOURCE_DIR) + "/validation/sphere/sphere.1";  // any file of the stem
  source.water_density = 1000.0;
  Diagnostics diagnostics;
  const auto data = read_hydrodynamics(source, diagnostics);
  ASSERT_TRUE(data);
  EXPECT_TRUE(data->has_infinite && data->has_zero);
  const double displaced = 1000.0 * 2.0 / 3.0 * kPi * 125.0;
  EXPECT_NEAR(data->added_mass_infinite(2, 2) / displaced, 0.5, 5e-4);  // Hulme (1982)
  EXPECT_NEAR(data->added_mass_zero(2, 2) / 1000.0, 201.54, 0.01);
  EXPECT_NEAR(data->hydrostatic_stiffness(2, 2), 78.48768e3 * 9.81, 10.0);
  EXPECT_EQ(data->radiation.size(), 420U);
  EXPECT_TRUE(data->drift.omega.empty());
}

TEST(hydrodynamics_reader, drift_below_the_cut_off_is_zero) {
  HydrodynamicsSource source = bgl1_source();
  source.drift_from = 0.5;
  Diagnostics diagnostics;
  const auto data = read_hydrodynamics(source, diagnostics);
  ASSERT_TRUE(data);
  for (std::size_t i = 0; i < data->drift.omega.size(); ++i) {
    const Vec6& beam = data->mean_drift[data->drift.index(i, 6)];
    EXPECT_EQ(beam(1) == 0.0, data->drift.omega[i] < 0.499) << data->drift.omega[i];
  }
}

TEST(hydrodynamics_reader, length_scale_and_units_of_every_file) {
  const Files files;
  files.write(".1", " 0 1 5 0.5\n6 1 5 1 0.1\n5 1 5 2 0.2\n4 1 5 3 0.3\n3 1 5 4 0.4\n");
  files.write(".3", "6.0 0 1 1 0 1 0\n6.0 0 5 2 90 0 2\n");
  files.write(".9", "heading\n6 0 0 1 3 0 3 0\n6 0 0 6 4 0 4 0\n6 0 0 3 9 0 9 0\n6 0 90 1 7 0 7 0\n");
  files.write(".hst", "3 3 10\n3 5 10\n5 5 10\n");
  HydrodynamicsSource source = files.source();
  source.length_scale = 2.0;
  Diagnostics diagnostics;
  const auto data = read_hydrodynamics(source, diagnostics);
  ASSERT_TRUE(data) << diagnostics.lines(Severity::error)[0];
  EXPECT_DOUBLE_EQ(data->added_mass_infinite(0, 4), 1000.0 * 16.0 * 0.5);
  EXPECT_DOUBLE_EQ(data->radiation[0].damping(0, 4), 1000.0 * 16.0 * (kPi / 3.0) * 0.1);
  EXPECT_DOUBLE_EQ(data->force[0](0).real(), 10e3 * 4.0);
  EXPECT_DOUBLE_EQ(data->force[0](4).imag(), 10e3 * 8.0 * 2.0);
  EXPECT_DOUBLE_EQ(data->hydrostatic_stiffness(2, 2), 10e3 * 4.0 * 10.0);
  EXPECT_DOUBLE_EQ(data->hydrostatic_stiffness(2, 4), 10e3 * 8.0 * 10.0);
  EXPECT_DOUBLE_EQ(data->hydrostatic_stiffness(4, 4), 10e3 * 16.0 * 10.0);
  ASSERT_EQ(data->mean_drift.size(), 1U);  // the pair of two headings is passed over, and so is heave
  EXPECT_DOUBLE_EQ(data->mean_drift[0](0), 10e3 * 2.0 * 3.0);
  EXPECT_DOUBLE_EQ(data->mean_drift[0](5), 10e3 * 4.0 * 4.0);
  EXPECT_EQ(data->mean_drift[0](2), 0.0);
}

TEST(hydrodynamics_reader, a_pair_of_modes_that_stands_once_couples_both_ways) {
  const Files files;
  files.write(".1", "0 1 5 0.5\n6 1 5 1 0.1\n5 1 5 2 0.2\n4 1 5 3 0.3\n3 1 5 4 0.4\n");
  Diagnostics diagnostics;
  const auto data = read_hydrodynamics(files.source(), diagnostics);
  ASSERT_TRUE(data);
  EXPECT_EQ(data->added_mass_infinite(4, 0), data->added_mass_infinite(0, 4));
  EXPECT_EQ(data->radiation[0].damping(4, 0), data->radiation[0].damping(0, 4));
  EXPECT_GT(data->radiation[0].damping(4, 0), 0.0);
}

TEST(hydrodynamics_reader, headings_are_wrapped_sorted_and_mirrored_where_the_hull_is_symmetric) {
  const Files files;
  files.write(".3",
              "6 -30 1 1 0 1 0\n6 -30 2 1 0 3 0\n6 0 1 1 0 2 0\n6 0 2 0 0 0 0\n6 360 1 1 0 2 0\n6 360 2 0 0 0 0\n");
  Diagnostics diagnostics;
  auto data = read_hydrodynamics(files.source(), diagnostics);
  ASSERT_TRUE(data);
  ASSERT_EQ(data->excitation.heading.size(), 2U);
  EXPECT_NEAR(data->excitation.heading[1], 11.0 / 6.0 * kPi, 1e-12);
  HydrodynamicsSource source = files.source();
  source.mirror_headings = true;
  data = read_hydrodynamics(source, diagnostics);
  ASSERT_TRUE(data);
  ASSERT_EQ(data->excitation.heading.size(), 3U);
  EXPECT_NEAR(data->excitation.heading[1], kPi / 6.0, 1e-12);
  EXPECT_EQ(data->force[1](0), data->force[2](0));   // surge is even
  EXPECT_EQ(data->force[1](1), -data->force[2](1));  // sway is odd
}

TEST(hydrodynamics_reader, every_bad_file_is_one_error_with_line_found_and_expected) {
  struct BadInput {
    const char *ending, *text, *place, *expected_text;
  };
  const BadInput errors[] = {
      {".1", "", "hull.1: ", "no numbers"},
      {".1", "6 3 3 1 x\n", "hull.1:1: ", "found 'x', expected a number"},
      {".1", "6 3 3 1 0.1\n5 3 3 1\n", "hull.1:2: ", "5 columns at a finite frequency"},
      {".1", "6 3 9 1 0.1\n", "hull.1:1: ", "two modes from 1 to 6"},
      {".1", "6 3 3 1 0.1\n6 3 3 1 0.1\n", "hull.1:2: ", "twice"},
      {".1", "6 3 3 1 0.1\n5 3 3 1 0.1\n5 1 1 1 0\n4 3 3 1 1\n3 3 3 1 1\n", "hull.1:2: ", "pairs of modes that differ"},
      {".1", "0 1 1 1\n6 3 3 1 1\n5 3 3 1 1\n4 3 3 1 1\n3 3 3 1 1\n", "hull.1:1: ", "pairs of modes that differ"},
      {".1", "6 3 3 1 1\n6.000001 3 3 1 1\n5 3 3 1 1\n4 3 3 1 1\n3 3 3 1 1\n", "hull.1:2: ", "each frequency once"},
      {".1", "6 3 3 1 0.1\n5 3 3 1 0.1\n", "hull.1: ", "four or more"},
      {".1", "0 3 3 1\n", "hull.1: ", "no finite frequency"},
      {".3", "6 0 1 1 0 1\n", "hull.3:1: ", "found 6 columns, expected 7 numbers"},
      {".3", "-1 0 1 1 0 1 0\n", "hull.3:1: ", "the period -1 s, expected more than 0"},
      {".3", "6 720 1 1 0 1 0\n", "hull.3:1: ", "-360 to 360 deg"},
      {".3", "6 0 7 1 0 1 0\n", "hull.3:1: ", "a mode from 1 to 6"},
      {".3", "6 0 1 1 0 1 0\n6 360 1 1 0 2 0\n", "hull.3: ", "two different values"},
      {".3", "6 0 1 1 0 1 0\n5 0 1 1 0 1 0\n5 90 1 1 0 2 0\n", "hull.3: ", "heading 90 deg"},
      {".8", "6 0 90 1 1 0 1 0\n", "hull.8: ", "equal headings"},
      {".hst", "0 3 1\n", "hull.hst:1: ", "two modes"},
  };
  for (const BadInput& damage : errors) {
    const Files files;
    files.write(damage.ending, damage.text);
    Diagnostics diagnostics;
    EXPECT_FALSE(read_hydrodynamics(files.source(), diagnostics)) << damage.text;
    ASSERT_EQ(diagnostics.error_count(), 1) << damage.text;
    const std::string line = diagnostics.lines(Severity::error)[0];
    EXPECT_NE(line.find(damage.place), std::string::npos) << line;
    EXPECT_NE(line.find(damage.expected_text), std::string::npos) << line;
  }
}

TEST(hydrodynamics_reader, missing_files_are_named_but_drift_may_be_missing) {
  const Files files;
  Diagnostics diagnostics;
  EXPECT_TRUE(read_hydrodynamics(files.source(), diagnostics));
  HydrodynamicsSource source = files.source();
  source.path += "_of_nobody";
  EXPECT_FALSE(read_hydrodynamics(source, diagnostics));
  EXPECT_EQ(diagnostics.error_count(), 3);
}

TEST(hydrodynamics_reader, frequencies_in_the_first_column_need_their_key) {
  HydrodynamicsSource source = testing::barge_source(testing::hull_file("wamit-rad-per-s/barge"));
  const testing::HullReading without = testing::read_hull(source);
  EXPECT_FALSE(without.data);
  for (const char* part :
       {"barge.1", "12 values from 0.2513 to 1.571", "waves of 0.099 to 3.9 m length", "rad_per_s"}) {
    EXPECT_NE(without.errors.at(0).find(part), std::string::npos) << without.errors.at(0);
  }
  source.frequencies = WaveColumn::rad_per_s;
  const testing::HullReading reading = testing::read_hull(source);
  ASSERT_TRUE(reading.data) << reading.errors.at(0);
  EXPECT_TRUE(reading.warnings.empty());
  EXPECT_TRUE(reading.data->has_zero);
  testing::expect_barge(*reading.data, 2e-4, true);
}

TEST(hydrodynamics_reader, a_period_without_excitation_is_warned_of) {
  const testing::HullReading reading =
      testing::read_hull(testing::barge_source(testing::hull_file("bad/wamit-missing-period/barge")));
  ASSERT_TRUE(reading.data) << reading.errors.at(0);
  ASSERT_EQ(reading.warnings.size(), 1U);
  for (const char* part : {"barge.3", "no excitation at 9 s, which barge.1 has", "interpolated"}) {
    EXPECT_NE(reading.warnings[0].find(part), std::string::npos) << reading.warnings[0];
  }
}

TEST(hydrodynamics_reader, one_body_of_several_is_selected_by_number) {
  const Files files;
  files.write(".1", "6 9 9 1 0.1\n6 3 3 9 9\n5 9 9 2 0.2\n4 9 9 3 0.3\n3 9 9 4 0.4\n");
  files.write(".3", "6 0 9 1 0 1 0\n6 0 3 7 0 7 0\n");
  files.write(".hst", "9 9 10\n3 3 99\n");
  HydrodynamicsSource source = files.source();
  Diagnostics diagnostics;
  EXPECT_FALSE(read_hydrodynamics(source, diagnostics));
  EXPECT_NE(diagnostics.lines(Severity::error)[0].find("convention.body"), std::string::npos);
  source.body = 2;
  Diagnostics second;
  const auto data = read_hydrodynamics(source, second);
  ASSERT_TRUE(data) << second.lines(Severity::error)[0];
  EXPECT_DOUBLE_EQ(data->radiation[0].added_mass(2, 2), 1000.0);
  EXPECT_DOUBLE_EQ(data->force[0](2).real(), 10e3);
  EXPECT_DOUBLE_EQ(data->hydrostatic_stiffness(2, 2), 100e3);
}

TEST(hydrodynamics_reader, stiffness_of_the_model_serves_where_the_files_have_none) {
  HydrodynamicsSource source = testing::barge_source(testing::hull_file("capytaine/barge-classic.nc"));
  EXPECT_NE(testing::read_hull(source).errors.at(0).find("vessel.motion.coupled.hydrostatics"), std::string::npos);
  source.stated_stiffness = Vec3(25330576.95, 1148319488.4, 16591527902.25);
  const testing::HullReading reading = testing::read_hull(source);
  ASSERT_TRUE(reading.data) << reading.errors.at(0);
  testing::expect_barge(*reading.data, 2e-4, false);
  EXPECT_NE(reading.notes().find("is that of the model"), std::string::npos);
}

}  // namespace
}  // namespace overbend
