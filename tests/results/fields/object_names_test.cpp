#include "results/fields/object_names.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace overbend {
namespace {

using Paths = std::vector<std::string>;

TEST(object_names, stand_for_names_by_kind_and_back) {
  const std::vector<std::pair<std::string, std::string>> names = {
      {"lines[pipe].static.lay_back", "static.lay_back"},
      {"lines[pipe].static.sagbend.max_von_mises", "static.sagbend.max_von_mises"},
      {"lines[pipe].dynamic.top_tension.max", "dynamic.top_tension.max"},
      {"lines[bow].static.fairlead_tension", "static.moorings[bow].fairlead_tension"},
      {"bodies[vessel].static.surge", "static.vessel.surge"},
      {"bodies[vessel].static.thrust.yaw", "static.thrust.yaw"},
      {"bodies[vessel].dynamic.surge.max", "dynamic.vessel.surge.max"},
      {"bodies[vessel].dynamic.thrust[0].largest_asked", "dynamic.thrust[0].largest_asked"},
      {"bodies[stinger].static.sections[outer].angle", "static.stinger.sections[outer].angle"},
      {"supports[stinger 3].static.reaction", "static.supports[stinger 3].reaction"},
      {"supports[*].static.rows[0].bottom.reaction", "static.supports[*].rows[0].bottom.reaction"},
      {"supports[stinger 3].dynamic.hardest_impact.count", "dynamic.impacts[stinger 3].count"},
      {"seabed.free_spans[0].length", "static.seabed.free_spans[0].length"},
      {"run.static.iterations", "static.iterations"},
      {"run.dynamic.energy_drift", "dynamic.energy_drift"},
      {"stages[half way].barge_ahead", "operation.stages[half way].barge_ahead"},
      {"stages[2].lines[pipe].static.lay_back", "operation.stages[2].lay_back"},
      {"stages[2].supports[stinger 3].static.reaction", "operation.stages[2].supports[stinger 3].reaction"},
      {"stages[2].lines[bow].static.length", "operation.stages[2].moorings[bow].length"},
      {"stages[2].run.static.iterations", "operation.stages[2].iterations"}};
  for (const auto& [object, path] : names) {
    EXPECT_EQ(object_path(path), object);
    const Paths paths = summary_paths(object);
    EXPECT_NE(std::find(paths.begin(), paths.end(), path), paths.end()) << object;
    EXPECT_EQ(summary_paths("objects." + object), paths);
  }
}

TEST(object_names, may_stand_for_a_line_of_every_kind) {
  EXPECT_EQ(summary_paths("lines[bow].static.utilisation"),
            (Paths{"static.moorings[bow].utilisation", "static.lines[bow].utilisation"}));
  EXPECT_EQ(summary_paths("lines[*].static.length"),
            (Paths{"static.length", "static.moorings[*].length", "static.lines[*].length"}));
  EXPECT_EQ(summary_paths("lines.pipe.static.lay_back").front(), "static.lay_back");
}

TEST(object_names, name_nothing_twice_in_the_tree) {
  for (const char* name : {"lines[pipe].static.supports[0].reaction", "lines[pipe].static.vessel.surge",
                           "lines[pipe].static.iterations", "lines[pipe].dynamic.checks.worst.utilisation"}) {
    for (const std::string& path : summary_paths(name))
      EXPECT_TRUE(path.starts_with("static.moorings[pipe]") || path.starts_with("static.lines[pipe]") ||
                  path.starts_with("dynamic.moorings[pipe]") || path.starts_with("dynamic.lines[pipe]"))
          << name << " " << path;
  }
}

TEST(object_names, leave_names_by_kind_as_they_are) {
  for (const char* name : {"static.lay_back", "checks.worst.utilisation", "dynamic.checks.worst.utilisation",
                           "operation.stages[2].head.z", "seek.answer", "a..b"}) {
    EXPECT_EQ(summary_paths(name), Paths{name});
  }
  EXPECT_FALSE(object_path("checks.worst.utilisation"));
  EXPECT_FALSE(object_path("dynamic.checks.worst.utilisation"));
  EXPECT_FALSE(object_path("operation.stages[2].checks.worst.utilisation"));
  EXPECT_FALSE(object_path("title"));
}

TEST(object_names, keep_empty_items_of_lists) {
  EXPECT_EQ(object_path("static.supports[].rows[].bottom.reaction"), "supports[].static.rows[].bottom.reaction");
  EXPECT_EQ(object_path("static.moorings[].length"), "lines[].static.length");
}

}  // namespace
}  // namespace overbend
