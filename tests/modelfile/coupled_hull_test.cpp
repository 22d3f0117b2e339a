// Hulls whose motion is computed, and the files that they come from.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <numbers>
#include <sstream>

#include "base/constants.h"
#include "model/model.h"
#include "modelfile/moored_reading.h"

namespace overbend {
namespace {

using testing::expect_reported;
using testing::ModelSlip;
using testing::read_good;
using testing::replaced;

/// The interface of a coupled hull, with files of the repository.
const std::string kCoupled = R"(overbend: 1
environment:
  water_depth: 89 m
  seabed: {stiffness: 100 kN/m^2}
  current: [{depth: 0 m, speed: 1 m/s, towards: 0 deg}]
vessel:
  depth: 9 m
  draught: 5.182 m
  motion:
    coupled:
      hydrodynamics: ../data/bgl1/bgl1
      mass: 19121.58 t
      centre_of_gravity: {x: 0 m, y: 0 m, z: 0.818 m}
      gyration: {roll: 10.5 m, pitch: 30 m, yaw: 30 m}
      wave_drift: mean
      damping: {roll: 5 %, sway: {linear: 100 kN*s/m, quadratic: 10 kN*s^2/m^2}}
      current: {transverse: 0.9}
      wind: {speed: 10 m/s, from: 90 deg, areas: [{name: deckhouse, area: 200 m^2, centre: {x: -30 m, y: 0 m, z: 10 m}, frontal: yes}]}
station_keeping:
  dp:
    surge: {stiffness: 100 kN/m, damping: 10 kN*s/m, thrust_limit: 500 kN}
    yaw: {stiffness: 1e6 kN*m}
)";

TEST(coupled_hull, keys_fill_the_description) {
  const Description d = read_good(kCoupled);
  EXPECT_FALSE(d.has_pipe);
  EXPECT_EQ(d.vessel.motion, VesselMotion::coupled);
  ASSERT_TRUE(d.vessel.coupled);
  const CoupledHullDescription& hull = *d.vessel.coupled;
  EXPECT_NEAR(hull.mass, 19121.58e3, 1e-6);
  EXPECT_EQ(hull.gyration, Vec3(10.5, 30.0, 30.0));
  EXPECT_EQ(hull.wave_drift, WaveDrift::mean);
  ASSERT_EQ(hull.damping.size(), 2U);  // in the order of the degrees of freedom
  EXPECT_EQ(hull.damping[0].mode, "sway");
  EXPECT_NEAR(hull.damping[0].linear.value(), 1e5, 1e-9);
  EXPECT_EQ(hull.damping[1].mode, "roll");
  EXPECT_NEAR(hull.damping[1].ratio.value(), 0.05, 1e-15);
  EXPECT_EQ(hull.current.transverse, 0.9);
  EXPECT_TRUE(hull.current.stated);
  EXPECT_TRUE(hull.wind.areas.at(0).frontal);
  ASSERT_TRUE(d.station_keeping);
  EXPECT_EQ(d.station_keeping->stiffness, Vec3(1e5, 0.0, 1e9));
  EXPECT_EQ(d.station_keeping->limit.x(), 5e5);
}

TEST(coupled_hull, its_files_are_read_with_their_conventions) {
  const std::string found = "hydrodynamics: ../data/bgl1/bgl1\n";
  const Description d = read_good(replaced(kCoupled, found, found + "      convention: {drift_from: 0.5 rad/s}\n"));
  ASSERT_TRUE(d.vessel.coupled && d.vessel.coupled->data);
  const HydrodynamicData& data = *d.vessel.coupled->data;
  EXPECT_EQ(data.origin_V, Vec3(0.0, 0.0, 0.818));
  EXPECT_NEAR(data.hydrostatic_stiffness(2, 2), 1025.0 * 9.81 * 3600.0, 1e3);  // a box of 120 x 30 m
  EXPECT_EQ(data.excitation.heading.size(), 24U);
  EXPECT_EQ(data.mean_drift.at(data.drift.index(0, 6))[1], 0.0);
}

TEST(coupled_hull, files_of_another_hull_or_scale_are_rejected) {
  const std::string stem = std::string(OVERBEND_SOURCE_DIR) + "/data/bgl1/bgl1";
  const std::string good = replaced(kCoupled, "../data/bgl1/bgl1", stem);
  const std::string key = "vessel.motion.coupled.hydrodynamics";
  expect_reported(
      good, {"length scale", stem + "\n", stem + "\n      convention: {length_scale: 10 m}\n", key, "waterplane"});
  expect_reported(good, {"another vessel", "  depth: 9 m", "  length: 500 m\n  depth: 9 m", key, "3600 m^2"});
}

/// Files of BGL-1 under a stem of their own, with the lines of one of them that are wanted.
std::string thinned_files(const std::string& ending, const std::function<bool(std::istringstream&)>& wanted) {
  const std::string from = std::string(OVERBEND_SOURCE_DIR) + "/data/bgl1/bgl1";
  const std::string stem = ::testing::TempDir() + "thinned" + ending.substr(1);
  for (const char* each : {".1", ".3", ".8", ".hst"}) {
    std::ifstream in(from + each);
    std::ofstream out(stem + each);
    for (std::string line; std::getline(in, line);) {
      std::istringstream numbers(line);
      if (each != ending || wanted(numbers)) out << line << '\n';
    }
  }
  return stem;
}

TEST(coupled_hull, drift_of_one_side_of_the_hull_alone_is_rejected_as_forces_are) {
  const std::string stem = thinned_files(".8", [](std::istringstream& line) {
    double period = 0.0, heading = 0.0;
    line >> period >> heading;
    return heading <= 180.0;
  });
  const std::string calm = "  current: [{depth: 0 m, speed: 1 m/s, towards: 0 deg}]\n";
  const std::string waves = calm + "  waves: {type: airy, height: 1 m, period: 8 s, from: 300 deg}\n";
  const std::string good = replaced(kCoupled, calm, waves);
  expect_reported(good,
                  {"half", "../data/bgl1/bgl1", stem, "vessel.motion.coupled.hydrodynamics", "headings of the drift"});
  const std::string mirrored = "hydrodynamics: " + stem + "\n      convention: {headings: mirrored}";
  EXPECT_TRUE(read_model_text(replaced(good, "hydrodynamics: ../data/bgl1/bgl1", mirrored), "m.yaml").description);
}

TEST(coupled_hull, files_without_a_mode_are_warned_of) {
  const std::string stem = thinned_files(".1", [](std::istringstream& line) {
    double period = 0.0;
    int i = 0, j = 0;
    line >> period >> i >> j;
    return i != 3 && j != 3;
  });
  const ModelReading reading = read_model_text(replaced(kCoupled, "../data/bgl1/bgl1", stem), "m.yaml");
  ASSERT_TRUE(reading.description);
  const std::vector<std::string> warnings = reading.diagnostics.lines(Severity::warning);
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const std::string& line) {
    return line.find("no added mass of heave") != std::string::npos;
  }));
}

TEST(coupled_hull, current_may_be_omitted_only_by_its_keyword) {
  const Description d = read_good(replaced(kCoupled, "current: {transverse: 0.9}", "current: none"));
  EXPECT_EQ(d.vessel.coupled->current.form, HullCurrentModel::none);
}

TEST(coupled_hull, current_may_act_by_the_coefficients_of_the_hulls_dimensions) {
  const Description d = read_good(replaced(kCoupled, "{transverse: 0.9}", "{form: ufc, relative_to: earth}"));
  EXPECT_EQ(d.vessel.coupled->current.form, HullCurrentModel::ufc);
  EXPECT_EQ(d.vessel.coupled->current.relative_to, CurrentRelativeTo::earth);
}

TEST(coupled_hull, wind_may_act_by_a_table) {
  const std::string file = ::testing::TempDir() + "wind_table.csv";
  std::ofstream(file) << "angle_deg,cx,cy,cz\n0,0.7,0,0\n60,0.4,0.6,0.05\n120,-0.4,0.6,-0.05\n180,-0.7,0,0\n";
  const std::string areas =
      "areas: [{name: deckhouse, area: 200 m^2, centre: {x: -30 m, y: 0 m, z: 10 m}, frontal: yes}]";
  const std::string table = "table: " + file + ", axes: to_from_bow, frontal_area: 115 m^2, lateral_area: 460 m^2";
  const WindDescription wind = read_good(replaced(kCoupled, areas, table)).vessel.coupled->wind;
  EXPECT_EQ(wind.table.size(), 6U);  // the other side is mirrored
  EXPECT_EQ(wind.frontal_area.value(), 115.0);
  EXPECT_EQ(wind.axes.value(), CoefficientAxes::to_from_bow);
}

TEST(coupled_hull, mean_drift_acts_in_statics_as_asked_for) {
  EXPECT_FALSE(read_good(kCoupled).statics.mean_drift);
  EXPECT_TRUE(read_good(kCoupled + "analysis: {static: {mean_drift: yes}}\n").statics.mean_drift.value());
  EXPECT_FALSE(read_good(kCoupled + "analysis: {static: {mean_drift: no}}\n").statics.mean_drift.value());
}

TEST(coupled_hull, every_slip_is_reported_once_with_key_and_remedy) {
  const std::string c = "vessel.motion.coupled.";
  const std::string stem = std::string(OVERBEND_SOURCE_DIR) + "/data/bgl1/bgl1";
  const std::string good = replaced(kCoupled, "../data/bgl1/bgl1", stem);
  const std::vector<ModelSlip> slips = {
      {"a current on no hull", "      current: {transverse: 0.9}\n", "", c + "current", "strips, a table, or none"},
      {"no files", stem + "\n", stem + "x\n", c + "hydrodynamics", "there is no file"},
      {"mass in kg", "19121.58 t", "1.912158e10 kg", c + "mass", "displaced by a box"},
      {"damping twice", "{linear: 100 kN*s/m,", "{ratio: 1 %, linear: 100 kN*s/m,", c + "damping.sway.linear",
       "one of them"},
      {"damping of another dimension", "linear: 100 kN*s/m", "linear: 100 kN*m*s", c + "damping.sway.linear", "kN*s/m"},
      {"areas without a table", "{transverse: 0.9}", "{lateral_area: 600 m^2}", c + "current.lateral_area",
       "the key table"},
      {"coefficients twice", "{transverse: 0.9}", "{form: ufc, transverse: 0.9}", c + "current.transverse",
       "one of them"},
      {"wind on nothing",
       ", areas: [{name: deckhouse, area: 200 m^2, centre: {x: -30 m, y: 0 m, z: 10 m}, frontal: yes}]", "",
       c + "wind.areas", "the wind has no effect"},
  };
  for (const ModelSlip& slip : slips) expect_reported(good, slip);
}

struct Doubt {
  const char* claim;
  std::string find, replace;
  std::string key, expected_text;
};

/// Messages on the coupled hull with one number changed.
std::vector<std::string> said(const Doubt& doubt, Severity severity) {
  return read_model_text(replaced(kCoupled, doubt.find, doubt.replace),
                         std::string(OVERBEND_SOURCE_DIR) + "/examples/hull.yaml")
      .diagnostics.lines(severity);
}

void expect_said(const Doubt& doubt, Severity severity) {
  SCOPED_TRACE(doubt.claim);
  const std::vector<std::string> lines = said(doubt, severity);
  EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
    return line.find(doubt.key) != std::string::npos && line.find(doubt.expected_text) != std::string::npos;
  })) << (lines.empty() ? "nothing was said" : lines.front());
}

TEST(coupled_hull, a_mass_that_is_not_the_displaced_one_is_rejected) {
  const std::string given = "mass: 19121.58 t", key = "vessel.motion.coupled.mass";
  for (const char* mass : {"19121.58 kg", "5000 t", "12000 t", "18000 t"}) {
    expect_said({mass, given, std::string("mass: ") + mass, key, "displaced by the hull"}, Severity::error);
  }
  expect_said({"kg for t", given, "mass: 19121.58 kg", key, "is the mass in t?"}, Severity::error);
  EXPECT_TRUE(said({"lines carry one per cent", given, "mass: 18930 t", "", ""}, Severity::error).empty());
  EXPECT_TRUE(said({"as it is", given, given, "", ""}, Severity::warning).empty());
}

TEST(coupled_hull, numbers_that_no_hull_of_its_size_has_are_warned_of) {
  const std::string c = "vessel.motion.coupled.";
  const std::string gyration = "gyration: {roll: 10.5 m, pitch: 30 m, yaw: 30 m}", g = "x: 0 m, y: 0 m, z: 0.818 m";
  const std::string files = "hydrodynamics: ../data/bgl1/bgl1\n";
  const std::vector<Doubt> doubts = {
      {"roll as pitch", gyration, "gyration: {roll: 20 m, pitch: 30 m, yaw: 30 m}", c + "gyration.roll",
       "0.67 times the beam"},
      {"pitch in feet", gyration, "gyration: {roll: 10.5 m, pitch: 100 ft, yaw: 9 m}", c + "gyration.yaw",
       "0.075 times the length"},
      {"from the stern", g, "x: 61 m, y: 0 m, z: 0.818 m", c + "centre_of_gravity.x", "outside the hull"},
      {"off the side", g, "x: 0 m, y: 16 m, z: 0.818 m", c + "centre_of_gravity.y", "outside the hull"},
      {"far ahead", g, "x: 40 m, y: 0 m, z: 0.818 m", c + "centre_of_gravity.x", "the waterplane is at 40 m"},
      {"off the centreline", g, "x: 0 m, y: -3 m, z: 0.818 m", c + "centre_of_gravity.y", "the waterplane is at -3 m"},
      {"above the keel", g, "x: 0 m, y: 0 m, z: 6 m", c + "centre_of_gravity.z", "outside the hull"},
      {"a brackish sea", "water_depth: 89 m", "water_depth: 89 m\n  water_weight_density: 9.95 kN/m^3",
       c + "convention.water_density", "differ by 1.0 %"},
      {"the files' own water", files, files + "      convention: {water_density: 1000 kg/m^3}\n",
       c + "convention.water_density", "differ by 2.4 %"},
  };
  for (const Doubt& doubt : doubts) expect_said(doubt, Severity::warning);
}

TEST(coupled_hull, radii_of_gyration_that_no_body_has_are_rejected) {
  expect_said({"yaw alone", "yaw: 30 m", "yaw: 40 m", "gyration.yaw", "as for any rigid body"}, Severity::error);
}

TEST(coupled_hull, a_file_of_a_kind_that_is_not_read_is_named_as_it_is) {
  const std::string file = ::testing::TempDir() + "results.h5";
  std::ofstream(file) << "not read";
  const Doubt doubt{"results", "../data/bgl1/bgl1", file, "vessel.motion.coupled.hydrodynamics",
                    "results.h5', whose type is not supported"};
  expect_said(doubt, Severity::error);
  EXPECT_EQ(said(doubt, Severity::error).front().find(".h5.1"), std::string::npos);
}

/// The box barge of validation/hull_files with the hull data of one of its files.
std::string barge_model(const std::string& file, const std::string& more = "convention: {headings: mirrored}") {
  const std::string path = std::string(OVERBEND_SOURCE_DIR) + "/validation/hull_files/" + file;
  return "overbend: 1\nenvironment:\n  water_depth: 2000 m\n  seabed: {stiffness: 100 kN/m^2}\nvessel:\n  length: 90 "
         "m\n"
         "  beam: 28 m\n  depth: 8 m\n  draught: 5 m\n  motion:\n    coupled:\n      hydrodynamics: " +
         path +
         "\n      mass: 12915 t\n      centre_of_gravity: {x: 0 m, y: 0 m, z: 1.5 m}\n"
         "      gyration: {roll: 9.8 m, pitch: 25.2 m, yaw: 26 m}\n      wave_drift: none\n      " +
         more + "\n";
}

ModelReading read_barge(const std::string& file, const std::string& more = "convention: {headings: mirrored}") {
  return read_model_text(barge_model(file, more), "barge.yaml");
}

std::string first_error(const ModelReading& reading) {
  const std::vector<std::string> lines = reading.diagnostics.lines(Severity::error);
  return lines.empty() ? "" : lines.front();
}

TEST(coupled_hull, files_of_every_program_are_read_by_their_contents) {
  for (const char* file : {"wamit-out/barge.out", "aqwa/barge.LIS", "aqwa/barge.AH1", "nemoh/Nemoh.cal", "nemoh",
                           "bemio/barge.h5", "hydrodyn/HydroDyn.dat", "orcaflex-loads/barge.yml"}) {
    const ModelReading reading = read_barge(file);
    ASSERT_TRUE(reading.description) << file << ": " << first_error(reading);
    const HydrodynamicData& data = *reading.description->vessel.coupled->data;
    EXPECT_NEAR(data.hydrostatic_stiffness(3, 3), 1.1483195e9, 1e-3 * 1.1483195e9) << file;
    EXPECT_EQ(data.excitation.heading.size(), 8U) << file;
    for (const std::string& warning : reading.diagnostics.lines(Severity::warning)) {
      EXPECT_EQ(warning.find("hydrodynamics"), std::string::npos) << warning;
    }
  }
}

TEST(coupled_hull, keys_state_what_files_do_not) {
  const ModelReading stated =
      read_barge("hydrodyn/barge", "convention: {headings: mirrored, origin: waterline, stiffness: hydrostatic_only}");
  ASSERT_TRUE(stated.description) << first_error(stated);
  EXPECT_EQ(stated.description->vessel.coupled->data->notes.size(), 1U);
  const std::string keel = "convention: {headings: mirrored, origin: {x: 0 m, y: 0 m, z: 0 m}, stiffness: ";
  const ModelReading point = read_barge("hydrodyn/barge", keel + "hydrostatic_only}");
  ASSERT_TRUE(point.description) << first_error(point);
  EXPECT_EQ(point.description->vessel.coupled->data->hydrostatic_stiffness,
            stated.description->vessel.coupled->data->hydrostatic_stiffness);
  const ModelReading hydrostatics =
      read_barge("capytaine/barge-classic.nc",
                 "convention: {headings: mirrored, gravity: 9.80665 m/s^2}\n      hydrostatics: {heave: 25.33 MN/m, "
                 "roll: 1148.3 MN*m, pitch: 16591.5 MN*m}");
  ASSERT_TRUE(hydrostatics.description) << first_error(hydrostatics);
  EXPECT_NEAR(hydrostatics.description->vessel.coupled->data->hydrostatic_stiffness(3, 3), 1.1483e9, 1.0);
  const ModelReading both =
      read_barge("hydrodyn/barge", "convention: {origin: waterline, reference: {x: 0 m, y: 0 m, z: 0 m}}");
  EXPECT_NE(first_error(both).find("convention.origin: found an origin and a reference"), std::string::npos)
      << first_error(both);
}

TEST(coupled_hull, phases_of_the_other_sense_are_seen_in_long_waves) {
  const std::string file = ::testing::TempDir() + "conjugated.yml";
  std::ifstream in(std::string(OVERBEND_SOURCE_DIR) + "/validation/hull_files/orcaflex-loads/barge.yml");
  std::stringstream text;
  text << in.rdbuf();
  std::ofstream(file) << replaced(text.str(), "RAOPhaseConvention: lags", "RAOPhaseConvention: leads");
  const std::string error = first_error(read_model_text(
      replaced(barge_model("orcaflex-loads/barge.yml"),
               std::string(OVERBEND_SOURCE_DIR) + "/validation/hull_files/orcaflex-loads/barge.yml", file),
      "barge.yaml"));
  EXPECT_NE(error.find("push the hull up the slope of the wave"), std::string::npos) << error;
}

}  // namespace
}  // namespace overbend
