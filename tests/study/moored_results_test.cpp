/// A moored lay in time from the model to its files and back.
#include <gtest/gtest.h>

#include "base/json.h"
#include "checks/run_checks.h"
#include "modelfile/reading/yaml_reader.h"
#include "recording/run_dynamics.h"
#include "resultfiles/dynamic/dynamic_reader.h"
#include "resultfiles/dynamic/dynamic_writer.h"
#include "resultfiles/dynamic/long_data_reader.h"
#include "study/run/history_statistics.h"
#include "study/run/motion_statistics.h"
#include "study/run/static_analysis.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

struct Finished {
  Description description;
  StaticResults statics;
  DynamicResults results;
  testing::TemporaryFolder folder;
};

/// BGL-1 on its moorings for two seconds, on a coarse mesh.
void run(Finished& made) {
  Description& d = made.description;
  d = read_model(OVERBEND_SOURCE_DIR "/examples/bgl1-moored.yaml").description.value();
  d.environment.waves.front().components = 40;
  d.mesh.overbend_element = 1.0;
  d.mesh.touchdown_element = 3.0;
  d.mesh.max_element_length = 8.0;
  d.dynamics = DynamicSettings{};
  d.dynamics->duration = 1.5;
  d.dynamics->build_up = 0.5;
  Model model = build_model(d);
  const ModelEquilibrium lay = solve_lay(model);
  made.statics = checked_statics(model, lay);
  add_hull_results(model, made.statics);
  RunStore store = RunStore::create(made.folder / "run", d.source_text, 1);
  DynamicOutcome outcome = run_dynamics(model, *lay.solution, made.statics, dynamic_options(model), store, nullptr,
                                        [](const DynamicProgress&) { return DynamicControl::go_on; });
  made.results = outcome.results.value();
  fill_checks(model, made.statics, made.results);
  finish_motions(made.statics, d, made.results, store);
  finish_histories(d, made.results, store);
  write_dynamic_files(made.statics, made.results, store, d, made.folder.path());
}

TEST(moored_results, files_of_a_moored_lay_in_time_are_read_back) {
  Finished made;
  run(made);
  const std::filesystem::path h5 = made.folder / "results.h5";
  const StoredDynamics stored = read_dynamic_results(h5);
  EXPECT_EQ(dynamic_summary(stored.statics.results, stored.results), dynamic_summary(made.statics, made.results));
  ASSERT_TRUE(stored.statics.results.moorings);
  EXPECT_EQ(stored.statics.results.moorings->rest.moorings[3].shape_W, made.statics.moorings->rest.moorings[3].shape_W);
  const Json summary = read_json(dynamic_summary(made.statics, made.results));
  EXPECT_EQ(summary["dynamic"]["vessel"]["sway"]["max"], made.results.vessel->sway.whole.max);
  EXPECT_EQ(summary["dynamic"]["moorings"].size(), 8U);
  EXPECT_FALSE(summary["static"]["hull"]["radiation"].empty());
  EXPECT_EQ(summary["static"]["moorings"].size(), 8U);

  const SnapshotBlock append_snapshot = read_snapshots(h5, 0, 1000);
  std::size_t points = 0;
  for (const MooringLineDynamics& line : stored.results.moorings) points += line.points.size();
  ASSERT_EQ(append_snapshot.line_points, static_cast<std::int64_t>(points));
  ASSERT_EQ(append_snapshot.line_x.size(), points * append_snapshot.time.size());
  const Vec3& anchor = made.statics.moorings->rest.moorings[0].anchor_W;
  EXPECT_NEAR(append_snapshot.line_x[0], anchor.x(), 1e-6);
  EXPECT_NEAR(append_snapshot.line_y[0], anchor.y(), 1e-6);
  EXPECT_EQ(read_history(h5, "vessel/slow_sway").size(), read_history(h5, "time").size());
  EXPECT_TRUE(std::filesystem::exists(made.folder / "moorings.csv"));
}

}  // namespace
}  // namespace overbend
