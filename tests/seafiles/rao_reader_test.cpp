#include "seafiles/rao_reader.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.h"
#include "model/waves/wave_theory.h"
#include "modelfile/model_texts.h"
#include "modelfile/reading/yaml_reader.h"
#include "support/rao_files.h"

namespace overbend {
namespace {

using testing::bgl1_file;
using testing::bgl1_raos;
using testing::good_raos;
using testing::WrittenFile;

/// Largest difference of two tables over headings and frequencies that fall between their points.
double difference(const RaoTable& a, const RaoTable& b, double per_rotation = 1.0 / kDegree) {
  double worst = 0.0;
  for (double heading = 0.0; heading < 360.0; heading += 7.0) {
    for (double omega = 0.1; omega < 2.2; omega += 0.0437) {
      const RaoTable::Response x = a.at(heading * kDegree, omega), y = b.at(heading * kDegree, omega);
      for (std::size_t k = 0; k < 6; ++k) worst = std::max(worst, std::abs(x[k] - y[k]) * (k < 3 ? 1.0 : per_rotation));
    }
  }
  return worst;
}

TEST(rao_reader, the_csv_of_the_barge_has_all_its_rows_and_its_point) {
  const RaoTable& table = bgl1_raos();
  EXPECT_EQ(table.headings.size(), 24U);
  EXPECT_EQ(table.omegas.size(), 49U);
  EXPECT_EQ(table.reference_V, Vec3(0.0, 0.0, 0.818));
  EXPECT_EQ(table.wave_origin_V, table.reference_V);
  EXPECT_TRUE(table.assumptions.empty());
  const RaoTable::Response first = table.at(0.0, 0.1);  // first rows of the file
  EXPECT_NEAR(std::abs(first[0] - std::polar(3.334455, -0.5 * kPi)), 0.0, 1e-9);
  EXPECT_NEAR(std::abs(first[4] - std::polar(0.1958943 * kDegree, 0.5 * kPi)), 0.0, 1e-9);
}

TEST(rao_reader, the_wamit_file_of_the_barge_gives_the_same_motions) {
  RaoSettings given;
  given.reference = Vec3(0.0, 0.0, 0.818);
  const RaoTable wamit = good_raos(bgl1_file("bgl1.4"), given);
  EXPECT_EQ(wamit.reference_V, bgl1_raos().reference_V);
  // Phases have three decimals in the one and seven digits in the other: 5e-4 deg of amplitudes up to 8.75.
  EXPECT_LT(difference(wamit, bgl1_raos()), 1e-4);
}

TEST(rao_reader, a_file_that_does_not_name_its_point_becomes_an_assumption) {
  const RaoTable wamit = good_raos(bgl1_file("bgl1.4"));
  EXPECT_EQ(wamit.reference_V, Vec3(0.0, 0.0, 0.0));
  ASSERT_EQ(wamit.assumptions.size(), 2U);
  EXPECT_NE(wamit.assumptions[0].text.find("midship on the water line"), std::string::npos);
}

/// The barge's table as a CSV file in the convention of `words`, written from their definition.
std::string csv_with_other_labels(const ConventionValues& convention, double depth) {
  const RaoTable& table = bgl1_raos();
  std::string text = "# reference: 0 0 0.818\nheading_deg,period_s,dof,amplitude,phase_rad\n";
  const auto is = [&](const char* key, const char* word) {
    const auto found = convention.find(key);
    return found != convention.end() && found->second == word;
  };
  for (std::size_t i = 0; i < table.headings.size(); ++i) {
    double heading = table.headings[i] / kDegree;
    if (is("heading_zero", "bow")) heading -= 180.0;
    if (is("heading_sense", "clockwise")) heading = -heading;
    for (std::size_t j = 0; j < table.omegas.size(); ++j) {
      const double slope = linear_wave_number(table.omegas[j], depth);  // of unit amplitude
      for (std::size_t k = 0; k < 6; ++k) {
        std::complex<double> z = table.value(i, j, k);
        for (const char* second : {"aft", "starboard", "down", "port_down", "bow_up", "bow_to_starboard"}) {
          if (is((std::string("positive.") + kFreedomNames[k]).c_str(), second)) z = -z;
        }
        double amplitude = std::abs(z);
        if (k >= 3) {
          if (is("rotation", "per_slope")) amplitude /= slope;
          if (is("rotation", "rad_per_steepness")) amplitude /= slope / kPi;  // H/L = 2a/L = k a/pi
          if (convention.count("rotation") == 0) amplitude /= kDegree;
        }
        // The event comes when omega t = 0, pi, pi/2, 3 pi/2; the motion peaks at omega t = lag.
        const double event = is("phase_zero", "trough")          ? kPi
                             : is("phase_zero", "down_crossing") ? 0.5 * kPi
                             : is("phase_zero", "up_crossing")   ? 1.5 * kPi
                                                                 : 0.0;
        double phase = -std::arg(z) - event;
        if (is("phase", "lead")) phase = -phase;
        text += fmt::format("{:.9g},{:.15g},{},{:.12g},{:.12g}\n", heading, 2.0 * kPi / table.omegas[j],
                            kFreedomNames[k], amplitude, phase);
      }
    }
  }
  return text;
}

TEST(rao_reader, every_convention_brings_the_same_motions_back) {
  const std::vector<ConventionValues> all = {
      {},
      {{"phase", "lead"}},
      {{"phase_zero", "trough"}},
      {{"phase_zero", "up_crossing"}, {"phase", "lead"}},
      {{"phase_zero", "down_crossing"}},
      {{"heading_zero", "bow"}},
      {{"heading_sense", "clockwise"}},
      {{"heading_zero", "bow"}, {"heading_sense", "clockwise"}, {"phase", "lead"}},
      {{"rotation", "rad_per_m"}},
      {{"rotation", "per_slope"}},
      {{"rotation", "rad_per_steepness"}},
      {{"positive.surge", "aft"}, {"positive.sway", "starboard"}, {"positive.heave", "down"}},
      {{"positive.roll", "port_down"}, {"positive.pitch", "bow_up"}, {"positive.yaw", "bow_to_starboard"}},
  };
  for (const ConventionValues& convention : all) {
    const WrittenFile file("other.csv", csv_with_other_labels(convention, 89.0));
    RaoSettings given;
    given.values = convention;
    const RaoTable table = good_raos(file.path(), given);
    EXPECT_LT(difference(table, bgl1_raos()), 1e-8) << ::testing::PrintToString(convention);
    if (!convention.empty()) {
      EXPECT_GT(difference(good_raos(file.path()), bgl1_raos()), 1e-2) << "unstated, it would have gone wrong";
    }
  }
}

TEST(rao_reader, a_named_set_is_the_sum_of_its_names) {
  const WrittenFile file("moses.csv", csv_with_other_labels({{"phase", "lead"},
                                                             {"positive.surge", "aft"},
                                                             {"positive.sway", "starboard"},
                                                             {"positive.roll", "port_down"},
                                                             {"positive.pitch", "bow_up"}},
                                                            89.0));
  RaoSettings given;
  given.set = "moses";
  EXPECT_LT(difference(good_raos(file.path(), given), bgl1_raos()), 1e-8);
}

TEST(rao_reader, remarks_at_the_head_of_a_csv_settle_its_convention_and_the_user_overrules_them) {
  const WrittenFile file("remarks.csv",
                         "# phase: lead\n# wave_origin: 3 0\n" + csv_with_other_labels({{"phase", "lead"}}, 89.0));
  const RaoTable table = good_raos(file.path());
  EXPECT_LT(difference(table, bgl1_raos()), 1e-8);
  EXPECT_EQ(table.wave_origin_V, Vec3(3.0, 0.0, 0.0));
  RaoSettings given;
  given.values["phase"] = "lag";
  EXPECT_GT(difference(good_raos(file.path(), given), bgl1_raos()), 0.1);
}

/// The rows of a table as a file of the engine's own, of those headings alone that `wanted` takes.
template <class Wanted>
std::string as_text(const RaoTable& table, const char* reference, Wanted wanted) {
  std::string text = fmt::format("# reference: {}\nheading_deg,omega_rad_s,dof,amplitude,phase_deg\n", reference);
  for (std::size_t i = 0; i < table.headings.size(); ++i) {
    if (!wanted(table.headings[i])) continue;
    for (std::size_t j = 0; j < table.omegas.size(); ++j) {
      for (std::size_t k = 0; k < 6; ++k) {
        const std::complex<double> z = table.value(i, j, k);
        text += fmt::format("{:.10g},{:.10g},{},{:.10g},{:.10g}\n", table.headings[i] / kDegree, table.omegas[j], k + 1,
                            std::abs(z) / (k < 3 ? 1.0 : kDegree), -std::arg(z) / kDegree);
      }
    }
  }
  return text;
}

bool not_to_port(double heading) {
  return heading <= 1e-9 || heading >= kPi - 1e-9;
}
bool not_to_starboard(double heading) {
  return heading <= kPi + 1e-9;
}

TEST(rao_reader, the_starboard_side_alone_is_mirrored) {
  const RaoTable& whole = bgl1_raos();
  const WrittenFile file("starboard.csv", as_text(whole, "0 0 0.818", not_to_port));
  const RaoTable table = good_raos(file.path());
  EXPECT_TRUE(table.one_sided());
  EXPECT_LT(difference(table, whole), 1e-6);
  ASSERT_EQ(table.assumptions.size(), 1U);
  EXPECT_NE(table.assumptions[0].text.find("mirror image"), std::string::npos);
}

/// The barge's motions at another point, with phases that count from the crest there.
RaoTable barge_at(const Vec3& point) {
  RaoTable table = bgl1_raos();
  const Vec3 arm = point - table.reference_V;
  for (std::size_t i = 0; i < table.headings.size(); ++i) {
    const Vec3 travel(std::cos(table.headings[i]), std::sin(table.headings[i]), 0.0);
    for (std::size_t j = 0; j < table.omegas.size(); ++j) {
      std::complex<double>* z = table.values.data() + (i * table.omegas.size() + j) * 6;
      z[0] += z[4] * arm.z() - z[5] * arm.y();
      z[1] += z[5] * arm.x() - z[3] * arm.z();
      z[2] += z[3] * arm.y() - z[4] * arm.x();
      const double later = linear_wave_number(table.omegas[j], 89.0) * travel.dot(point);
      for (std::size_t k = 0; k < 6; ++k) z[k] *= std::polar(1.0, later);
    }
  }
  table.reference_V = table.wave_origin_V = point;
  return table;
}

TEST(rao_reader, one_side_of_a_point_off_the_centreline_is_mirrored_on_the_centreline) {
  const RaoTable off = barge_at(Vec3(-30.0, 7.0, 4.0)), expected = barge_at(Vec3(-30.0, 0.0, 4.0));
  for (const bool port : {true, false}) {
    const WrittenFile file("one_side.csv", as_text(off, "-30 7 4", port ? not_to_starboard : not_to_port));
    const RaoTable table = good_raos(file.path());
    EXPECT_EQ(table.reference_V, expected.reference_V);
    EXPECT_EQ(table.wave_origin_V, expected.wave_origin_V);
    EXPECT_LT(difference(table, expected), 1e-6) << (port ? "port" : "starboard");
    ASSERT_EQ(table.assumptions.size(), 2U);
    EXPECT_NE(table.assumptions[1].text.find("off the centreline"), std::string::npos);
  }
}

TEST(rao_reader, errors_are_reported_with_file_line_what_was_found_and_what_was_expected) {
  const std::string head = "heading_deg,omega_rad_s,dof,amplitude,phase_deg\n";
  const std::string good = "0,0.5,heave,1,0\n0,0.6,heave,1,0\n90,0.5,heave,1,0\n90,0.6,heave,1,0\n";
  struct BadInput {
    const char* name;
    std::string text;
    int line;
    const char* expected_text;
  };
  const std::vector<BadInput> errors = {
      {"a.csv", "", 0, "no rows"},
      {"a.csv", "heading,omega\n1,2\n", 1, "without a column heading_deg"},
      {"a.csv", head + "0,0.5,heave,one,0\n", 2, "'one', expected a number for amplitude"},
      {"a.csv", head + "0,0.5,heav,1,0\n", 2, "'heav'"},
      {"a.csv", head + "0,0.5,heave,1\n", 2, "4 cells"},
      {"a.csv", head + "0,-0.5,heave,1,0\n", 2, "more than 0"},
      {"a.csv", head + "0,0.5,heave,-1,0\n", 2, "below zero"},
      {"a.csv", head + "0,0.5,heave,nan,0\n", 2, "'nan'"},
      {"a.csv", head + good + "0,0.5,heave,1.5,0\n", 6, "twice"},
      {"a.csv", head + good + "45,0.5,heave,1,0\n", 0, "no value of heave for waves travelling towards 45 deg at 0.6"},
      {"a.csv", "# phase: behind\n" + head + good, 1, "'behind' for phase"},
      {"a.csv", "# reference: 0 0 high\n" + head + good, 1, "coordinates in metres"},
      {"a.4", "  10. 0. 3 1. 0. 1. 0.\n  10. 0. 3 1. 0.\n", 2, "seven: PER BETA I MOD PHA RE IM"},
      {"a.4", "  10. 0. 7 1. 0. 1. 0.\n", 1, "a mode from 1 to 6"},
      {"a.rao", "1 2 3", 0, "'.rao', expected .csv, .4 or .out (WAMIT), .LIS (AQWA)"},
      {"a.yml", "VesselTypes: []\n", 1, "a list of named groups"},
      {"a.yml", "VesselTypes: [\n", 2, "invalid YAML"},
  };
  for (const BadInput& damage : errors) {
    const WrittenFile file(damage.name, damage.text);
    Diagnostics diagnostics;
    EXPECT_FALSE(read_raos(file.path(), {}, 89.0, diagnostics).has_value()) << damage.expected_text;
    ASSERT_GE(diagnostics.error_count(), 1) << damage.expected_text;
    const Diagnostic first = diagnostics.sorted().front();
    EXPECT_EQ(first.line, damage.line) << render(first);
    EXPECT_NE(render(first).find(damage.expected_text), std::string::npos) << render(first);
    EXPECT_NE(render(first).find(file.path()), std::string::npos);
  }
}

TEST(rao_reader, a_table_spoilt_in_every_row_is_not_reported_row_by_row) {
  std::string text = "heading_deg,omega_rad_s,dof,amplitude,phase_deg\n";
  for (int i = 0; i < 1000; ++i) text += "0;0.5;heave;1;0\n";
  const WrittenFile file("spoilt.csv", text);
  Diagnostics diagnostics;
  EXPECT_FALSE(read_raos(file.path(), {}, 89.0, diagnostics).has_value());
  EXPECT_EQ(diagnostics.error_count(), 10);
}

TEST(rao_reader, freedoms_a_file_does_not_give_are_zero_and_assumed) {
  const WrittenFile file("heave.csv",
                         "heading_deg,frequency_hz,dof,amplitude,phase_deg\n0,0.1,heave,1,0\n0,0.2,heave,0.5,9\n");
  const RaoTable table = good_raos(file.path());
  EXPECT_EQ(table.at(0.0, 1.0)[4], 0.0);
  EXPECT_NEAR(table.omegas[0], 0.2 * kPi, 1e-12);
  int assumed = 0;
  for (const std::string& line : texts(table.assumptions))
    assumed += line.find("taken as zero") != std::string::npos ? 1 : 0;
  EXPECT_EQ(assumed, 5);
}

TEST(rao_reader, the_model_file_states_conventions_and_reads_the_table) {
  std::string text = testing::file_text(std::string(OVERBEND_SOURCE_DIR) + "/examples/bgl1.yaml");
  const std::string motion = "{raos: ../data/bgl1/rao.csv}";
  text.replace(text.find(motion), motion.size(),
               "{raos: ../data/bgl1/bgl1.4, convention: {reference: {x: 0 m, z: 0.818 m}, wave_origin: {x: 0 m}}}");
  const ModelReading reading = read_model_text(text, std::string(OVERBEND_SOURCE_DIR) + "/examples/other.yaml");
  for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
  ASSERT_TRUE(reading.description.has_value());
  ASSERT_TRUE(reading.description->vessel.raos.has_value());
  EXPECT_LT(difference(*reading.description->vessel.raos, bgl1_raos()), 1e-4);
  EXPECT_TRUE(reading.description->vessel.raos->assumptions.empty());
}

TEST(rao_reader, a_model_with_a_spoilt_motion_file_is_rejected) {
  const WrittenFile file("spoilt.csv", "heading_deg,omega_rad_s,dof,amplitude,phase_deg\n0,0,heave,1,0\n");
  std::string text = testing::file_text(std::string(OVERBEND_SOURCE_DIR) + "/examples/bgl1.yaml");
  text.replace(text.find("../data/bgl1/rao.csv"), 20, file.path());
  const ModelReading reading = read_model_text(text, "model.yaml");
  EXPECT_FALSE(reading.description.has_value());
  ASSERT_EQ(reading.diagnostics.error_count(), 1);
  EXPECT_NE(reading.diagnostics.lines(Severity::error)[0].find("spoilt.csv:2:"), std::string::npos);
}

}  // namespace
}  // namespace overbend
