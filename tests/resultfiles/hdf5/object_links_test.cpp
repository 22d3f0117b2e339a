#include "resultfiles/hdf5/object_links.h"

#include <gtest/gtest.h>

#include "report/synthetic_moorings.h"
#include "report/synthetic_operation.h"
#include "resultfiles/dynamic/dynamic_writer.h"
#include "resultfiles/hdf5/dataset_path.h"
#include "resultfiles/stages/operation_writer.h"
#include "resultfiles/static/rechecked_hdf5.h"
#include "resultfiles/static/results_writer.h"
#include "results/fields/object_names.h"
#include "support/dynamic_case.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

using testing::solved_case;
using testing::TemporaryFolder;

TEST(object_links, of_a_lay_lead_to_the_values_of_the_pipe) {
  const TemporaryFolder folder;
  const auto& [description, statics] = solved_case("BGL1-T250");
  write_static_hdf5(statics, description, folder / "results.h5");
  const Hdf5Reader file(folder / "results.h5");
  EXPECT_EQ(file.doubles("/objects/lines/pipe/static/lay_back"), std::vector{statics.lay_back});
  EXPECT_EQ(file.doubles("/objects/lines/pipe/static/stations/s"), file.doubles("/static/stations/s"));
  EXPECT_EQ(file.names("/objects"), std::vector<std::string>{"lines/"});  // nothing moves, the bed is flat
}

TEST(object_links, of_a_run_lead_to_the_groups_of_the_table) {
  const TemporaryFolder folder;
  const auto& [description, lay] = solved_case("BGL1-T250");
  StaticResults statics = lay;
  statics.moorings = testing::synthetic_moorings();
  statics.hull = testing::synthetic_hull();
  statics.bed.emplace().contacts.resize(1);
  DynamicResults dynamics = testing::filled_dynamics(statics);
  testing::add_moored_dynamics(dynamics);
  write_dynamic_hdf5(statics, dynamics, testing::filled_run(folder.path()), description, folder / "results.h5");
  const Hdf5Reader file(folder / "results.h5");
  int links = 0;
  for (const ObjectLink& row : object_links()) {
    const std::string link = "/objects/" + std::string(row.link), group(row.group);
    if (link.find('<') != std::string::npos || !file.has(group)) continue;
    EXPECT_EQ(file.names(link), file.names(group)) << link;
    ++links;
  }
  EXPECT_GE(links, 9);
  EXPECT_EQ(file.doubles("/objects/lines/pipe/dynamic/lay_back_max"), std::vector{dynamics.lay_back.max});
}

TEST(object_links, lead_to_the_new_checks_of_results_that_are_checked_again) {
  const TemporaryFolder folder;
  const auto& [description, statics] = solved_case("BGL1-T250");
  const DynamicResults dynamics = testing::filled_dynamics(statics);
  write_dynamic_hdf5(statics, dynamics, testing::filled_run(folder.path()), description, folder / "results.h5");
  StaticResults checked = statics;
  checked.checks.rows.resize(1);
  copy_rechecked(folder / "results.h5", folder / "again.h5", checked, dynamics, description);
  EXPECT_EQ(Hdf5Reader(folder / "again.h5").doubles("/objects/lines/pipe/static/checks/list/utilisation").size(), 1U);
}

TEST(object_links, of_lines_by_themselves_have_their_names) {
  const TemporaryFolder folder;
  write_static_hdf5(testing::synthetic_lines(), {}, folder / "results.h5");
  const Hdf5Reader file(folder / "results.h5");
  EXPECT_EQ(file.names("/objects/lines"), std::vector<std::string>{"jumper/"});
  EXPECT_EQ(file.doubles("/objects/lines/jumper/static/length"), std::vector{170.0});
}

TEST(object_links, of_stages_have_the_objects_of_each) {
  const TemporaryFolder folder;
  const OperationResults operation = testing::synthetic_abandonment();
  write_operation_hdf5(operation, {}, folder / "results.h5");
  const Hdf5Reader file(folder / "results.h5");
  int stages = 0;
  for (const StageResult& stage : operation.stages) {
    const std::string group = "/objects/stages/" + dataset_path(stage.stage.name);
    EXPECT_EQ(file.has(group), stage.lay.has_value()) << group;
    if (!stage.lay) continue;
    EXPECT_EQ(file.doubles(group + "/lines/pipe/static/lay_back"), std::vector{stage.lay->lay_back});
    ++stages;
  }
  EXPECT_GT(stages, 2);
}

}  // namespace
}  // namespace overbend
