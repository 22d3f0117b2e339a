// Pulls along the bed by a winch at a distance: references, closed forms, what results must not depend on.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/constants.h"
#include "base/json.h"
#include "modelfile/reading/yaml_reader.h"
#include "resultfiles/static/case_summary.h"
#include "study/stages/lay_operation.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

const std::string kFolder = std::string(OVERBEND_SOURCE_DIR) + "/validation/operation_cases/";

/// Tolerance of the reference for a number, by its name and group.
double allowed(const std::string& group, const std::string& key, double wanted) {
  const double size = std::abs(wanted);
  if (group == "tension" || key == "wire_largest_tension" || key == "wire_utilisation") return 2e-3 * size;
  if (key == "least_tension") return 100.0;
  if (key.find("inclination") != std::string::npos || key.find("angle") != std::string::npos) return 0.05 * kDegree;
  if (key == "moment" || key == "stress") return 3e-3 * size;
  if (key == "reaction") return std::max(2e-2 * size, 1500.0);
  if (group == "lift_off") return 1.0;
  const bool edge = group == "touchdown" || group == "contacts" || key == "wire_out";
  if (edge && key != "z") return 0.3;
  return 0.02;
}

/// Every number of the reference, and every word.
void expect_all(const Json& wanted, const Json& found, const std::string& group, const std::string& key) {
  SCOPED_TRACE(key);
  if (wanted.is_object()) {
    for (const auto& [name, value] : wanted.items()) {
      ASSERT_TRUE(found.contains(name)) << name;
      expect_all(value, found[name], value.is_structured() ? name : group, name);
    }
  } else if (wanted.is_array()) {
    ASSERT_EQ(wanted.size(), found.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) expect_all(wanted[i], found[i], group, key);
  } else if (wanted.is_number()) {
    ASSERT_TRUE(found.is_number());
    EXPECT_NEAR(found.get<double>(), wanted.get<double>(), allowed(group, key, wanted.get<double>()));
  } else {
    EXPECT_EQ(found, wanted);
  }
}

void expect_reference(const std::string& name) {
  const OperationResults found = solve_operation(read_model(kFolder + name + ".yaml").description.value());
  const Json stages = operation_summary_json(found)["operation"]["stages"];
  const Json wanted = read_json_file(kFolder + name + ".expected.json")["operation"]["stages"];
  ASSERT_EQ(stages.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    SCOPED_TRACE(name + ", " + found.stages[i].stage.name);
    expect_all(wanted[i], stages[i], "", "stage");
  }
}

TEST(shore_pull, over_a_level_bed_has_the_stages_of_the_reference) {
  expect_reference("SP12");
}

TEST(shore_pull, up_a_slope_over_rollers_has_the_stages_of_the_reference) {
  expect_reference("SP16");
}

/// The model SP12 with some of its text exchanged.
struct Change {
  std::string from, to;
};

ModelReading read_changed(const std::vector<Change>& changes) {
  std::string text = testing::file_text(kFolder + "SP12.yaml");
  for (const Change& change : changes) {
    const std::size_t place = text.find(change.from);
    EXPECT_NE(place, std::string::npos) << change.from;
    if (place != std::string::npos) text.replace(place, change.from.size(), change.to);
  }
  return read_model_text(text, "pull.yaml");
}

/// The only stage of a pull, or of a hold-back.
StageResult only_stage(std::vector<Change> changes, double pipe_out) {
  changes.push_back(
      {"{from: 200 m, to: 1000 m, steps: 8, tension: 150 kN}", "[{pipe_out: " + std::to_string(pipe_out) + " m}]"});
  const ModelReading reading = read_changed(changes);
  for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
  return solve_operation(reading.description.value()).stages.at(0);
}

StaticResults only_lay(const std::vector<Change>& changes, double pipe_out) {
  StageResult stage = only_stage(changes, pipe_out);
  if (stage.failure) ADD_FAILURE() << stage.failure->what << ": " << stage.failure->why;
  return stage.lay.value_or(StaticResults{});
}

constexpr double kPipe = 772.728952, kCable = 140.0;  ///< Submerged weights [N/m].

/// Stations of pipe (else of cable) that lie on the bed well within their contact, from the vessel astern.
std::vector<Station> lying(const StaticResults& lay, SectionKind kind) {
  constexpr double kInside = 25.0;  // [m] from either end of the contact, where bending and sinking have died away
  std::vector<Station> stations;
  for (const Station& station : lay.stations) {
    const bool inside = std::ranges::any_of(lay.dragging->contacts, [&](const BedContactResult& contact) {
      return station.s < contact.s_from - kInside && station.s > contact.s_to + kInside;
    });
    const double joint = lay.head->s;
    const bool clear = kind == SectionKind::cable ? station.s < joint - kInside : station.s > joint + 6.0 + kInside;
    if (inside && clear && station.kind == kind) stations.push_back(station);
  }
  std::ranges::reverse(stations);
  return stations;
}

/// Gain of tension from the first to the last of stations, per length between them [N/m].
double gain(const std::vector<Station>& stations) {
  const Station &first = stations.front(), &last = stations.back();
  return (last.effective_tension - first.effective_tension) / (first.s - last.s);
}

/// dT/ds = w (mu cos a + sin a) along a plane bed.
void expect_plane(const std::vector<Change>& changes, double rise, double distance) {
  const StaticResults lay = only_lay(changes, 600.0);
  const double a = std::atan(rise);
  const auto wanted = [&](double weight, double mu) { return weight * (distance * mu * std::cos(a) + std::sin(a)); };
  // stretch changes the weight per length by less than 1e-4
  EXPECT_NEAR(gain(lying(lay, SectionKind::pipe)), wanted(kPipe, 0.45), 3e-4 * kPipe);
  EXPECT_NEAR(gain(lying(lay, SectionKind::cable)), wanted(kCable, 0.5), 2e-3 * kCable);
  // the free cable gains its weight times its height
  const double height = -2.0 - lay.dragging->lift_off->z;
  const Station* off = nullptr;
  for (const Station& station : lay.stations) {
    if (station.s <= lay.dragging->lift_off->before_winch) off = &station;
  }
  ASSERT_NE(off, nullptr);
  EXPECT_NEAR(lay.dragging->winch_tension, off->effective_tension + kCable * height, 1e-3 * kCable * height + 60.0);
}

TEST(shore_pull, on_a_level_bed_tension_grows_by_friction) {
  expect_plane({}, 0.0, 1.0);
}

TEST(shore_pull, up_a_plane_bed_tension_grows_by_friction_and_weight) {
  expect_plane({{"water_depth: 14 m", "water_depth: 60 m"},
                {"friction: {axial", "slope: 2 deg, slope_towards: 90 deg, friction: {axial"},
                {"tension: 150 kN}\n\n", "tension: 300 kN}\n\n"}},
               std::tan(2.0 * kDegree), 1.0);
}

TEST(shore_pull, down_a_plane_bed_weight_helps) {
  expect_plane({{"friction: {axial", "slope: 1 deg, slope_towards: 270 deg, friction: {axial"}},
               -std::tan(1.0 * kDegree), 1.0);
}

TEST(hold_back, tension_falls_away_from_the_vessel_by_friction) {
  expect_plane({{"type: shore_pull", "type: hold_back"}, {"tension: 150 kN}\n\n", "tension: 500 kN}\n\n"}}, 0.0, -1.0);
}

TEST(shore_pull, without_friction_tension_depends_on_height_alone) {
  const StaticResults lay = only_lay({{"{axial: 0.45, lateral: 0.45}", "0"}, {"friction: 0.5", "friction: 0"}}, 600.0);
  EXPECT_NEAR(gain(lying(lay, SectionKind::pipe)), 0.0, 1e-4 * kPipe);
  EXPECT_NEAR(gain(lying(lay, SectionKind::cable)), 0.0, 1e-4 * kCable);
}

TEST(shore_pull, the_cable_has_the_friction_of_the_bed_where_it_has_none_of_its_own) {
  const StaticResults lay = only_lay({{", friction: 0.5}", "}"}}, 600.0);
  EXPECT_NEAR(gain(lying(lay, SectionKind::cable)), 0.45 * kCable, 2e-3 * kCable);
}

/// A bed with a crest of 5 m, so flat that the line lies all along.
Change over_a_crest() {
  std::string rows;
  for (int x = -100; x <= 1500; x += 25) {
    rows += "{x: " + std::to_string(x) +
            " m, depth: " + std::to_string(14.0 - 5.0 * std::exp(-std::pow((x - 600.0) / 150.0, 2))) + " m}, ";
  }
  return {"friction: {axial", "profile: [" + rows + "], friction: {axial"};
}

/// Tension of a string on a bed of this shape, pressed against it where it turns downwards: integrated by itself from
/// the tension at the first station [N].
double string_tension(const std::vector<Station>& stations, double mu) {
  double tension = stations.front().effective_tension;
  for (std::size_t i = 1; i + 1 < stations.size(); ++i) {
    const Vec3 before = stations[i].p_W - stations[i - 1].p_W, behind = stations[i + 1].p_W - stations[i].p_W;
    const auto rise = [](const Vec3& step) { return std::atan2(step.z(), step.head<2>().norm()); };
    const double length = 0.5 * (before.norm() + behind.norm()), a = 0.5 * (rise(before) + rise(behind));
    const double turn = rise(behind) - rise(before);  // upwards: the bed pushes less
    tension += kPipe * length * (std::sin(a) + mu * std::cos(a)) - mu * tension * turn;
  }
  return tension;
}

TEST(shore_pull, a_crest_presses_the_line_and_costs_tension_by_its_turning) {
  const StaticResults lay = only_lay({over_a_crest()}, 900.0);
  std::vector<Station> crest = lying(lay, SectionKind::pipe);
  std::erase_if(crest, [](const Station& station) { return station.astern < 450.0 || station.astern > 750.0; });
  // Capstan: beyond weight, up and down, it costs mu T times the angle turned, here 0.08 rad each way and back.
  const double found = crest.back().effective_tension,
               weight_alone = crest.front().effective_tension + 0.45 * kPipe * (crest.front().s - crest.back().s);
  EXPECT_NEAR(found, string_tension(crest, 0.45), 0.02 * (found - crest.front().effective_tension));
  EXPECT_GT(found, weight_alone + 5e3);
}

TEST(shore_pull, there_is_no_friction_where_the_cable_bridges) {
  const StaticResults lay = only_lay({}, 600.0);
  ASSERT_GE(lay.dragging->contacts.size(), 2U);
  const double from = lay.head->s, to = lay.dragging->contacts[1].s_from;
  ASSERT_GT(from - to, 10.0);  // behind the head, thicker than the cable
  for (const Station& station : lay.stations) {
    if (station.kind != SectionKind::cable || station.s < to) continue;
    const double by_height = kCable * (station.p_W.z() - lay.head->p_W.z());
    EXPECT_NEAR(station.effective_tension, lay.head->tension + by_height, 1.0);
  }
}

TEST(shore_pull, results_depend_neither_on_the_mesh_nor_on_the_stiffness_of_the_bed) {
  const StaticResults lay = only_lay({}, 600.0);
  const std::vector<std::vector<Change>> others = {
      {{"operation:", "analysis: {mesh: {longest_element: 1 m, touchdown_element: 0.3 m}}\noperation:"}},
      {{"operation:", "analysis: {mesh: {longest_element: 8 m}}\noperation:"}},
      {{"stiffness: 150", "stiffness: 1500"}},
  };
  for (const std::vector<Change>& changes : others) {
    SCOPED_TRACE(changes.front().to);
    const StaticResults second_static_results = only_lay(changes, 600.0);
    EXPECT_NEAR(second_static_results.dragging->winch_tension, lay.dragging->winch_tension,
                5e-4 * lay.dragging->winch_tension);
    // on a bed ten times as stiff the head, 7 kN/m, stands 40 mm higher and carries a little more of the cable
    EXPECT_NEAR(second_static_results.head->tension, lay.head->tension, 1e-3 * lay.head->tension);
    EXPECT_NEAR(second_static_results.cable->length, lay.cable->length, 0.02);
    EXPECT_NEAR(second_static_results.far_anchor->distance, 1300.0, 1e-5);
  }
}

TEST(shore_pull, a_line_in_compression_is_rejected_by_name) {
  const StageResult stage = only_stage({{"type: shore_pull", "type: hold_back"}}, 600.0);
  ASSERT_TRUE(stage.failure.has_value());
  EXPECT_EQ(stage.failure->what, "the line is in compression");
  EXPECT_NE(stage.failure->where.find("from the tensioner"), std::string::npos);
  EXPECT_NE(stage.failure->why.find("friction"), std::string::npos);
}

TEST(shore_pull, a_cable_that_does_not_reach_is_rejected_by_name) {
  // 694 m from the head to the winch; bent and on the bed it takes half a metre more
  const StageResult stage = only_stage({{"friction: 0.5}", "friction: 0.5, length: 694.1 m}"}}, 600.0);
  ASSERT_TRUE(stage.failure.has_value());
  EXPECT_EQ(stage.failure->what, "the cable does not reach");
}

TEST(shore_pull, too_little_tension_for_the_suspended_weight_is_reported_with_the_tension_it_takes) {
  const StageResult stage = only_stage({{"tension: 150 kN}\n\n", "tension: 8 kN}\n\n"}}, 600.0);
  ASSERT_TRUE(stage.failure.has_value());
  EXPECT_NE(stage.failure->what.find("tension"), std::string::npos) << stage.failure->what;
  EXPECT_TRUE(stage.failure->min_tension.has_value());
}

TEST(shore_pull, findings_name_a_lifted_head_and_a_cable_that_lies_to_its_winch) {
  const auto has = [](const StaticResults& lay, FindingCode code) {
    return std::ranges::any_of(lay.findings, [&](const Finding& finding) { return finding.code == code; });
  };
  const StaticResults usual = only_lay({}, 600.0);
  EXPECT_FALSE(has(usual, FindingCode::dragged_head_lifted));
  EXPECT_FALSE(has(usual, FindingCode::dragged_cable_on_bed));
  EXPECT_TRUE(has(only_lay({}, 1230.0), FindingCode::dragged_head_lifted));
  EXPECT_TRUE(has(only_lay({{"depth: 2 m}", "depth: 13.968 m}"}}, 600.0), FindingCode::dragged_cable_on_bed));
}

}  // namespace
}  // namespace overbend
