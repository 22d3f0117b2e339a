#include "seafiles/wamit_out.h"

#include <gtest/gtest.h>

#include "seafiles/hull_reference.h"

namespace overbend {
namespace {

using testing::barge_source;
using testing::hull_file;
using testing::HullReading;
using testing::read_hull;
using testing::read_text;
using testing::ScratchFolder;
using testing::with_change;

const std::string kFile = "wamit-out/barge.out";

HullReading read_changed(const std::string& text, HydrodynamicsSource source = barge_source("")) {
  const ScratchFolder scratch;
  source.path = scratch.write("barge.out", text);
  return read_hull(source);
}

TEST(wamit_out, a_file_about_the_water_line_is_moved_to_the_centre_of_gravity) {
  const HullReading reading = read_hull(barge_source(hull_file(kFile)));
  ASSERT_TRUE(reading.data) << reading.errors.at(0);
  EXPECT_TRUE(reading.warnings.empty()) << reading.warnings.at(0);
  testing::expect_barge(*reading.data, 2e-4, true);
  EXPECT_TRUE(reading.data->has_zero);
  EXPECT_EQ(reading.data->file_origin_V.value(), Vec3::Zero());
  EXPECT_NE(reading.notes().find("does not state the density of the water"), std::string::npos);
}

TEST(wamit_out, phases_of_a_body_elsewhere_are_turned_to_its_place) {
  const std::string good = read_text(hull_file(kFile));
  const std::string moved =
      with_change(good, "XBODY =    0.0000 YBODY =    0.0000", "XBODY =   10.0000 YBODY =   -5.0000");
  const HullReading good_reading = read_changed(good), moved_reading = read_changed(moved);
  ASSERT_TRUE(good_reading.data && moved_reading.data);
  const HeadingTable& table = good_reading.data->excitation;
  const std::size_t i = table.omega.size() - 1, j = testing::nearest_index(table.heading, 45.0 * kDegree);
  const double k = table.omega[i] * table.omega[i] / kGravity;
  const double later = k * (10.0 - 5.0) * std::cos(45.0 * kDegree);
  const std::complex<double> ratio =
      moved_reading.data->force[table.index(i, j)](0) / good_reading.data->force[table.index(i, j)](0);
  EXPECT_NEAR(std::abs(ratio - std::polar(1.0, later)), 0.0, 2e-4);
  EXPECT_EQ(moved_reading.data->hydrostatic_stiffness, good_reading.data->hydrostatic_stiffness);
}

TEST(wamit_out, headings_of_a_turned_body_count_from_its_bow) {
  std::string text = with_change(read_text(hull_file(kFile)), "PHIBODY =   0.0", "PHIBODY =  45.0");
  const HullReading reading = read_changed(text);
  ASSERT_TRUE(reading.data) << reading.errors.at(0);
  EXPECT_NEAR(reading.data->excitation.heading.back(), 315.0 * kDegree, 1e-9);
}

TEST(wamit_out, drift_is_that_of_the_momentum_and_of_equal_headings) {
  const std::string good = read_text(hull_file(kFile));
  std::string text;
  std::size_t from = 0;
  const std::string end = "    DIFFRACTION EXCITING";
  for (std::size_t place = good.find(end); place != std::string::npos; place = good.find(end, from)) {
    text += good.substr(from, place - from) +
            " SURGE, SWAY & YAW DRIFT FORCES (Momentum Conservation)\n\n  Wave Heading (deg) :      0         0\n\n"
            "     I      Mod[F(I)]    Pha[F(I)]\n\n     1    7.0E+00          180\n     2    0.0E+00           90\n"
            "     6    0.0E+00           90\n\n  Wave Heading (deg) :      0        45\n\n"
            "     1    9.0E+00          180\n\n" +
            end;
    from = place + end.size();
  }
  text += good.substr(from);
  const HullReading reading = read_changed(text);
  ASSERT_TRUE(reading.data) << reading.errors.at(0);
  ASSERT_EQ(reading.data->mean_drift.size(), 12U);
  EXPECT_NEAR(reading.data->mean_drift[0](0), -7.0 * 1025.0 * kGravity, 1e-6);
}

TEST(wamit_out, one_body_of_several_is_selected_by_number) {
  std::string text = read_text(hull_file(kFile));
  const std::size_t body = text.find(" Total panels:"), end = text.find(" ----", body);
  text.insert(end, text.substr(body, end - body));
  EXPECT_NE(read_changed(text).errors.at(0).find("2 bodies"), std::string::npos);
  HydrodynamicsSource source = barge_source("");
  source.body = 1;
  const HullReading reading = read_changed(text, source);
  ASSERT_TRUE(reading.data) << reading.errors.at(0);
  testing::expect_barge(*reading.data, 2e-4, true);
  EXPECT_NE(reading.notes().find("Body 1 of 2"), std::string::npos);
}

TEST(wamit_out, asterisks_are_an_error_with_line_and_coefficient) {
  const HullReading reading = read_hull(barge_source(hull_file("bad/wamit-stars.out")));
  EXPECT_FALSE(reading.data);
  ASSERT_EQ(reading.errors.size(), 1U);
  for (const char* part : {"wamit-stars.out:531:", "'*************'", "A(3,3) at 7 s"}) {
    EXPECT_NE(reading.errors[0].find(part), std::string::npos) << reading.errors[0];
  }
}

TEST(wamit_out, what_differs_from_the_model_is_reported) {
  HydrodynamicsSource source = barge_source(hull_file(kFile));
  source.origin_V.z() = 2.0;
  EXPECT_NE(read_hull(source).errors.at(0).find("(0, 0, 1.5) m in the axes of the file"), std::string::npos);
  source = barge_source(hull_file(kFile));
  source.mass = 10000e3;
  EXPECT_NE(read_hull(source).warnings.at(0).find("displaces 12915 t"), std::string::npos);
  source = barge_source(hull_file(kFile));
  source.water_depth = 20.0;
  EXPECT_NE(read_hull(source).warnings.at(0).find("deep water"), std::string::npos);
  source = barge_source(hull_file(kFile));
  source.length_scale = 10.0;
  EXPECT_NE(read_hull(source).errors.at(0).find("length_scale"), std::string::npos);
}

TEST(wamit_out, damaged_files_get_an_answer) {
  testing::expect_answers_to_damage(hull_file("wamit-out"), "barge.out", "barge.out", testing::damage_trials());
}

}  // namespace
}  // namespace overbend
