#include "resultfiles/summary/result_objects.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/result_path.h"
#include "report/synthetic_dynamics.h"
#include "report/synthetic_moorings.h"
#include "report/synthetic_operation.h"
#include "resultfiles/stages/operation_writer.h"
#include "resultfiles/static/case_summary.h"
#include "resultfiles/summary/named_dynamics.h"
#include "resultfiles/summary/named_results.h"
#include "resultfiles/summary/result_units.h"
#include "resultfiles/summary/study_outputs.h"
#include "results/fields/object_names.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

using testing::solved_case;

/// A lay on moorings with everything that a run in time may have.
Json moored_lay() {
  StaticResults statics = solved_case("BGL1-T250").results;
  statics.moorings = testing::synthetic_moorings();
  statics.moorings->rest.thrust = {1e3, 2e3, 3e6};
  statics.moorings->rest.mooring_force = {1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
  statics.hull = testing::synthetic_hull();
  statics.bed.emplace().contacts.resize(1);
  statics.bed->spans.resize(2);
  statics.stinger.resize(2);
  statics.stinger[0].name = "inner";
  statics.stinger[1].name = "outer";
  DynamicResults run = testing::synthetic_dynamics(statics);
  testing::add_moored_dynamics(run);
  run.stinger.resize(2);
  run.stinger[0].name = "inner";
  run.stinger[1].name = "outer";
  run.fatigue.emplace().spots.resize(1);
  run.fatigue->spots[0].name = "root";
  return dynamic_summary_json(statics, run);
}

Json hull_alone() {
  StaticResults statics = testing::synthetic_hull_alone(testing::synthetic_stages());
  statics.hull = testing::synthetic_hull();
  DynamicResults run;
  testing::add_moored_dynamics(run);
  return dynamic_summary_json(statics, run);
}

Json pull_ahead() {
  return static_summary_json(testing::synthetic_hull_alone(testing::synthetic_pull_ahead()));
}

Json lines_alone() {
  return dynamic_summary_json(testing::synthetic_lines(), testing::synthetic_lines_in_time());
}

Json stages() {
  return operation_summary_json(testing::synthetic_start_up());
}

const std::vector<std::pair<std::string, Json>>& summaries() {
  static const std::vector<std::pair<std::string, Json>> kSummaries = {{"moored lay", moored_lay()},
                                                                       {"hull alone", hull_alone()},
                                                                       {"pull-ahead", pull_ahead()},
                                                                       {"lines alone", lines_alone()},
                                                                       {"stages", stages()}};
  return kSummaries;
}

/// Calls `visit` for every single value, items of lists by their names.
template <class Visit>
void walk(const Json& value, const std::string& path, Visit visit) {
  if (value.is_object() && !value.empty()) {
    for (const auto& [key, member] : value.items()) walk(member, path.empty() ? key : path + "." + key, visit);
  } else if (value.is_array() && !value.empty() && value.front().is_object()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      walk(value[i], path + "[" + value[i].value("name", std::to_string(i)) + "]", visit);
    }
  } else if (!value.is_structured() || !value.empty()) {
    visit(path, value);
  }
}

/// Paths that belong to the file or the operation and to no object.
bool belongs_to_no_object(const std::string& path) {
  static const std::vector<std::string> kRoots = {"status",   "title",    "version", "assumptions", "assumption_ranks",
                                                  "findings", "warnings", "units",   "frame",       "derived",
                                                  "sections", "verdict",  "checks"};
  const std::vector<PathPart> parts = *split_result_path(path);
  if (std::ranges::find(kRoots, parts[0].text) != kRoots.end()) return true;
  if (parts[0].text == "dynamic" || parts[0].text == "static") return parts.size() > 1 && parts[1].text == "checks";
  return parts[0].text == "operation" && (parts[1].text != "stages" || (parts.size() > 3 && parts[3].text == "checks"));
}

/// The value of a path by object in the tree; null where there is none.
const Json* value_in(const Json& objects, const std::string& path) {
  const Json* value = &objects;
  const std::vector<PathPart> parts = *split_result_path(path);
  for (const PathPart& part : parts) {
    if (value->is_array()) {
      std::size_t index = 0;
      while (index < value->size() && !chooses_item(part.text, index, (*value)[index].value("name", ""))) ++index;
      if (index == value->size()) return nullptr;
      value = &(*value)[index];
    } else if (value->is_object() && value->contains(part.text)) {
      value = &value->at(part.text);
    } else {
      return nullptr;
    }
  }
  return value;
}

TEST(result_objects, hold_every_value_of_the_summary_under_its_name_by_object) {
  for (const auto& [model, summary] : summaries()) {
    const Json objects = result_objects(summary);
    int reached = 0;
    walk(summary, "", [&](const std::string& path, const Json& value) {
      const std::optional<std::string> object = object_path(path);
      EXPECT_EQ(!object, belongs_to_no_object(path)) << model << ": " << path;
      if (!object) return;
      const Json* stored = value_in(objects, *object);
      ASSERT_NE(stored, nullptr) << model << ": " << path << ", " << *object;
      EXPECT_EQ(*stored, value) << model << ": " << *object;
      ++reached;
    });
    EXPECT_GT(reached, 15) << model;
  }
}

/// Takes the kinds of lines out of a tree, which must have one each.
void drop_kinds(Json& objects) {
  if (!objects.contains("lines")) return;
  for (auto& [name, line] : objects["lines"].items()) EXPECT_EQ(line.erase("kind"), 1U) << name;
}

TEST(result_objects, hold_nothing_else_but_the_kinds_of_lines) {
  for (const auto& [model, summary] : summaries()) {
    int in_objects = 0, in_summary = 0;
    Json objects = result_objects(summary);
    drop_kinds(objects);
    if (objects.contains("stages")) std::ranges::for_each(objects["stages"], drop_kinds);
    walk(objects, "", [&](const std::string&, const Json&) { ++in_objects; });
    walk(summary, "", [&](const std::string& path, const Json&) { in_summary += object_path(path) ? 1 : 0; });
    EXPECT_EQ(in_objects, in_summary) << model;
  }
}

TEST(result_objects, are_numbers_that_seeks_and_studies_find_by_either_name) {
  for (const auto& [model, summary] : summaries()) {
    walk(summary, "", [&](const std::string& path, const Json& value) {
      const std::optional<std::string> object = object_path(path);
      if (!object || !value.is_number()) return;
      EXPECT_EQ(named_values(summary, *object), named_values(summary, path)) << model << ": " << path;
      EXPECT_EQ(output_value(summary, StudyAnalysis::dynamic, *object), named_result(summary, path)) << *object;
    });
  }
}

/// Numbers whose unit depends on the row, and those of members that are named after lines.
bool has_no_unit(const std::string& path) {
  return std::ranges::any_of(std::vector<std::string>{".extremes[", "findings[", ".winch_lengths."},
                             [&](const std::string& part) { return path.find(part) != std::string::npos; });
}

TEST(result_objects, have_units_of_the_same_quantity) {
  for (const auto& [model, summary] : summaries()) {
    walk(summary, "", [&](const std::string& path, const Json& value) {
      const std::optional<std::string> object = object_path(path);
      if (!object || !value.is_number() || has_no_unit(path)) return;
      const bool stage = path.starts_with("operation.stages");
      const StudyAnalysis analysis = stage ? StudyAnalysis::operation : StudyAnalysis::dynamic;
      const std::optional<StudyOutput> output = study_output(analysis, *object), by_kind = study_output(analysis, path);
      ASSERT_TRUE(output.has_value()) << model << ": " << *object;
      EXPECT_EQ(output->unit, by_kind->unit) << *object;
      EXPECT_EQ(output->name, *object);
    });
  }
}

TEST(result_objects, are_suggested_where_a_name_is_misspelt) {
  EXPECT_EQ(nearest_output(StudyAnalysis::statics, "lines[pipe].static.lay_bak"), "lines[pipe].static.lay_back");
  EXPECT_EQ(nearest_output(StudyAnalysis::dynamic, "bodies[vessel].dynamic.sruge.max"),
            "bodies[vessel].dynamic.surge.max");
  EXPECT_EQ(nearest_output(StudyAnalysis::statics, "static.lay_bak"), "static.lay_back");
}

TEST(result_objects, distinguish_lines_of_the_same_name) {
  Json summary = moored_lay();
  summary["static"]["moorings"][0]["name"] = "pipe";
  summary["static"]["moorings"][1]["name"] = "bow";
  summary["static"]["moorings"][2]["name"] = "bow";
  const Json lines = result_objects(summary)["lines"];
  EXPECT_EQ(lines["pipe"]["kind"], "pipe");
  EXPECT_EQ(lines["pipe (mooring)"]["static"], summary["static"]["moorings"][0]);
  EXPECT_EQ(lines["bow (2)"]["static"], summary["static"]["moorings"][2]);
}

TEST(result_objects, of_units_stand_by_kind) {
  const Json units = result_objects(stored_summary_units());
  EXPECT_EQ(units["lines"]["pipe"]["static"]["lay_back"], "m");
  EXPECT_EQ(units["lines"]["mooring"]["static"]["fairlead_tension"], "N");
  EXPECT_EQ(units["lines"]["line"]["dynamic"]["largest_tension"], "N");
  EXPECT_EQ(units["supports"]["*"]["static"]["reaction"], "N");
  EXPECT_EQ(units["bodies"]["vessel"]["dynamic"]["roll"]["max"], "rad");
  EXPECT_EQ(units["run"]["dynamic"]["energy_drift"], "1");
}

TEST(result_objects, stand_in_the_file) {
  const StaticResults& results = solved_case("BGL1-T250").results;
  const Json summary = read_json(static_summary(results));
  EXPECT_EQ(summary["objects"], result_objects(static_summary_json(results)));
  EXPECT_EQ(summary["objects"]["lines"]["pipe"]["static"]["lay_back"], results.lay_back);
  EXPECT_FALSE(read_json(summary_text(Json{{"status", "failed"}})).contains("objects"));
}

/// "| `bodies[vessel].dynamic` | `dynamic`: `thrust` |"
std::string documented(const ObjectRow& row) {
  std::string line = row.object.empty() ? "| none | `" : "| `" + std::string(row.object) + "` | `";
  line.append(row.path).append("`");
  std::string members = row.members.empty() ? "" : ": `" + std::string(row.members) + "`";
  for (std::size_t place = members.find(' ', 2); place != std::string::npos; place = members.find(' ', place + 4)) {
    members.replace(place, 1, "`, `");
  }
  return line + members + " |\n";
}

TEST(result_objects, stand_in_the_table_of_the_documentation) {
  const std::string page = testing::file_text(OVERBEND_SOURCE_DIR "/docs/results-file.md");
  std::string rows, links;
  for (const ObjectRow& row : object_rows()) rows += documented(row);
  for (const ObjectLink& row : object_links()) {
    links.append("| `").append(row.link).append("` | `").append(row.group).append("` |\n");
  }
  EXPECT_NE(page.find("|---|---|\n" + rows + "\n"), std::string::npos) << rows;
  EXPECT_NE(page.find("|---|---|\n" + links + "\n"), std::string::npos) << links;
}

}  // namespace
}  // namespace overbend
