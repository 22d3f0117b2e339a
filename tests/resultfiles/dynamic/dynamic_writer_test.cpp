#include "resultfiles/dynamic/dynamic_writer.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "resultfiles/static/finite_check.h"
#include "resultfiles/static/results_writer.h"
#include "support/dynamic_case.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;
using testing::filled_dynamics;
using testing::filled_run;
using testing::solved_case;
using testing::TemporaryFolder;

TEST(dynamic_writer, writes_the_files) {
  const TemporaryFolder folder;
  const auto& [description, statics] = solved_case("BGL1-T250");
  const DynamicResults dynamics = filled_dynamics(statics);
  const RunStore store = filled_run(folder / "run", 100);
  fs::create_directory(folder / "out");
  write_dynamic_files(statics, dynamics, store, description, folder / "out");
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / "out")) {
    names.insert(entry.path().filename());
  }
  EXPECT_EQ(names, (std::set<std::string>{"summary.json", "pipe.csv", "supports.csv", "impacts.csv", "checks.csv",
                                          "calculation_sheet.csv", "results.h5"}));
  EXPECT_EQ(testing::file_text(folder / "out/summary.json"), dynamic_summary(statics, dynamics));
  EXPECT_EQ(testing::file_text(folder / "out/impacts.csv"), impacts_table(dynamics));
}

TEST(dynamic_results_file, is_complete_and_described_for_h5py) {
  for (const char* name : {"BGL1-T250", "J12-D400-T560"}) {
    const TemporaryFolder folder;
    const auto& [description, statics] = solved_case(name);
    DynamicResults dynamics = filled_dynamics(statics);
    const RunStore store = filled_run(folder.path());
    dynamics.histories = summarise_histories(store);
    write_dynamic_hdf5(statics, dynamics, store, description, folder / "results.h5");
    for (const char* script : {"check_results_h5.py", "check_dynamic_h5.py"}) {
      const std::string command = std::string("/usr/bin/python3 " OVERBEND_SOURCE_DIR "/tests/resultfiles/") + script +
                                  " " + (folder / "results.h5").string() + " > " + (folder / "told").string() + " 2>&1";
      EXPECT_EQ(std::system(command.c_str()), 0) << name << ": " << testing::file_text(folder / "told");
    }
  }
}

/// The quantity that require_finite names first.
template <class Spoil>
std::string named(Spoil spoil) {
  DynamicResults results = filled_dynamics(solved_case("BGL1-T250").results);
  results.histories = {{"heave", "m", "", {}, {1.0, 2.0}, {3.0, 4.0}}};
  spoil(results);
  try {
    require_finite(results);
  } catch (const std::runtime_error& error) {
    return std::string(error.what()).substr(0, std::string(error.what()).find(" is not"));
  }
  return "";
}

TEST(dynamic_finite_check, finds_what_is_not_finite_wherever_it_is) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(named([](DynamicResults&) {}), "");
  EXPECT_EQ(named([&](DynamicResults& r) { r.lay_back.std = none; }), "dynamic.lay_back_std");
  EXPECT_EQ(named([&](DynamicResults& r) { r.energy.error = none; }), "dynamic.energy.error");
  EXPECT_EQ(named([&](DynamicResults& r) { r.tensioner.travel.max = none; }), "dynamic.tensioner.travel_max");
  EXPECT_EQ(named([&](DynamicResults& r) { r.run.real_time_ratio = INFINITY; }), "dynamic.run.real_time_ratio");
  EXPECT_EQ(named([&](DynamicResults& r) { r.sagbend.strain.p_W.y() = none; }), "dynamic.sagbend.strain.position_y");
  EXPECT_EQ(named([&](DynamicResults& r) { r.z.mean[7] = none; }), "dynamic.stations[7].z_mean");
  EXPECT_EQ(named([&](DynamicResults& r) { r.static_place[2].x() = none; }), "dynamic.stations[2].static_x");
  EXPECT_EQ(named([&](DynamicResults& r) { r.supports[3].lateral.min = none; }), "dynamic.supports[3].lateral_min");
  EXPECT_EQ(named([&](DynamicResults& r) { r.supports[3].rollers[0].dent_depth = none; }),
            "dynamic.supports[3].rollers[0].dent_depth");
  EXPECT_EQ(named([&](DynamicResults& r) { r.hardest_impacts[1].impulse = none; }),
            "dynamic.hardest_impacts[1].impulse");
  EXPECT_EQ(named([&](DynamicResults& r) { r.extremes[1].gumbel_low = none; }), "dynamic.extremes[1].gumbel_low");
  EXPECT_EQ(named([&](DynamicResults& r) { r.histories[0].high[1] = none; }), "dynamic.histories.heave[1].high");
  EXPECT_EQ(named([&](DynamicResults& r) { r.spectra[0].density[1] = none; }),
            "dynamic.spectra.top_tension[1].density");
}

TEST(dynamic_finite_check, lets_a_separation_be_absent_but_not_infinite) {
  const double absent = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(named([&](DynamicResults& r) {
              r.supports[3].separation = r.supports[3].rollers[0].separation = {absent, absent, absent, absent};
              r.supports[3].static_separation = absent;
              r.stinger_tip_clearance = {absent, absent, absent, absent};
              r.histories = {{"support/b 8/separation", "m", "", {absent, absent, absent, absent}, {absent}, {absent}}};
            }),
            "");
  EXPECT_EQ(named([&](DynamicResults& r) { r.supports[3].separation.min = INFINITY; }),
            "dynamic.supports[3].separation_min");
}

TEST(dynamic_writer, marks_where_a_history_is_absent) {
  const auto& [description, statics] = solved_case("J12-D400-T560");
  const TemporaryFolder folder;
  RunStore store = RunStore::create(folder.path(), "", 0);
  store.begin({{"time", "s", "Time", false, false}, {"support/a/separation", "m", "Separation", false, false}}, {0, 0});
  for (const double value : {0.5, std::numeric_limits<double>::quiet_NaN(), 0.25}) store.row(std::array{0.0, value});
  write_dynamic_hdf5(statics, filled_dynamics(statics), store, description, folder / "results.h5");
  const std::string command =
      "/usr/bin/python3 -c \"import h5py, numpy; d = h5py.File('" + (folder / "results.h5").string() +
      "')['dynamic/histories/support/a/separation']; assert numpy.isnan(d.attrs['_FillValue']); "
      "assert list(numpy.isnan(d[:])) == [False, True, False]\"";
  EXPECT_EQ(std::system(command.c_str()), 0);
}

TEST(dynamic_writer, rejects_stored_numbers_that_are_none_and_names_them) {
  const auto& [description, statics] = solved_case("J12-D400-T560");
  const DynamicResults dynamics = filled_dynamics(statics);
  const auto error_after_change = [&](auto spoil) -> std::string {
    const TemporaryFolder folder;
    RunStore store = RunStore::create(folder.path(), "", 0);
    store.begin({{"time", "s", "Time", false, false}, {"heave", "m", "Heave", false, false}}, {0, 0});
    spoil(store);
    try {
      write_dynamic_hdf5(statics, dynamics, store, description, folder / "results.h5");
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  const std::vector<double> row = {0.0, NAN};
  std::vector<double> pose(12, 1.0);
  pose[3] = INFINITY;
  EXPECT_EQ(error_after_change([](RunStore&) {}), "");
  EXPECT_NE(error_after_change([&](RunStore& s) { s.row(row); }).find("dynamic.histories.heave"), std::string::npos);
  EXPECT_NE(error_after_change([&](RunStore& s) { s.snapshot(0.0, pose); }).find("dynamic.snapshots"),
            std::string::npos);
  EXPECT_NE(error_after_change([&](RunStore& s) {
              s.impact({0, 1.0, NAN});
            }).find("dynamic.impacts.approach_velocity"),
            std::string::npos);
}

}  // namespace
}  // namespace overbend
