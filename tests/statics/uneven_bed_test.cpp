// Lays over uneven beds against independent answers: validation/bed_cases, by spectral collocation of the planar
// elastica on the same profiles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/json.h"
#include "modelfile/reading/yaml_reader.h"
#include "statics/recovery/recovery.h"
#include "statics/solver/statics.h"

namespace overbend {
namespace {

const std::string kCases = std::string(OVERBEND_SOURCE_DIR) + "/validation/bed_cases/";

Description described(const std::string& name) {
  return read_model(kCases + name + ".yaml").description.value();
}

StaticResults lay(const Description& description) {
  const Model model = build_model(description);
  const StaticOutcome outcome = solve_statics(model);
  EXPECT_TRUE(outcome.solution.has_value()) << (outcome.failure ? outcome.failure->why : "");
  return outcome.solution ? recover_statics(model, *outcome.solution) : StaticResults{};
}

Json expected(const std::string& name) {
  return read_json_file(kCases + name + ".expected.json")["static"];
}

/// Spans whose gap does not depend on the model of the soil.
std::vector<FreeSpanResult> open_spans(std::vector<FreeSpanResult> spans) {
  std::erase_if(spans, [](const FreeSpanResult& span) { return span.max_gap < 0.05; });
  return spans;
}

void expect_spans(const BedResults& bed, const Json& wanted) {
  std::vector<Json> open;
  for (const Json& span : wanted) {
    if (span["max_gap"] > 0.05) open.push_back(span);
  }
  const std::vector<FreeSpanResult> spans = open_spans(bed.spans);
  ASSERT_EQ(spans.size(), open.size());
  for (std::size_t i = 0; i < open.size(); ++i) {
    EXPECT_NEAR(spans[i].x_from, open[i]["x_from"].get<double>(), 0.1);
    EXPECT_NEAR(spans[i].x_to, open[i]["x_to"].get<double>(), 0.1);
    EXPECT_NEAR(spans[i].length, open[i]["length"].get<double>(), 0.2);
    EXPECT_NEAR(spans[i].max_gap, open[i]["max_gap"].get<double>(), 2e-3);
    EXPECT_NEAR(spans[i].gap_x, open[i]["max_gap_x"].get<double>(), 0.5);
    const double moment = open[i]["max_sagging_moment"];
    EXPECT_NEAR(spans[i].sagging_moment, moment, 3e-3 * moment);
  }
}

class uneven_bed : public ::testing::TestWithParam<const char*> {};

TEST_P(uneven_bed, lay_has_the_answers_of_the_elastica) {
  const StaticResults r = lay(described(GetParam()));
  const Json e = expected(GetParam()), bed = e["seabed"];
  ASSERT_TRUE(r.bed.has_value());
  EXPECT_NEAR(r.bottom_tension, e["bottom_tension"].get<double>(), 1e-3 * r.bottom_tension);
  EXPECT_NEAR(r.lay_back, e["lay_back"].get<double>(), 0.05);
  EXPECT_NEAR(r.touchdown.p_W.z(), e["touchdown"]["z"].get<double>(), 0.01);
  const double sagbend = e["sagbend"]["max_bending_moment"];
  EXPECT_NEAR(r.sagbend.bending_moment.value, sagbend, 3e-3 * sagbend);
  EXPECT_NEAR(r.bed->tail_tension, bed["tail_tension"].get<double>(), 1e-3 * r.bed->tail_tension);
  EXPECT_NEAR(r.bed->max_penetration, bed["max_penetration"].get<double>(), 5e-3 * r.bed->max_penetration);
  const double hogging = bed["max_hogging_moment"]["value"], sagging = bed["max_sagging_moment"]["value"];
  EXPECT_NEAR(r.bed->hogging_moment, hogging, 3e-3 * hogging + 100.0);
  EXPECT_NEAR(r.bed->sagging_moment, sagging, 3e-3 * sagging + 100.0);
  for (std::size_t i = 0; i < r.supports.size(); ++i) {
    const double reaction = e["supports"][i]["reaction"];
    EXPECT_NEAR(r.supports[i].reaction, reaction, std::max(500.0, 0.01 * reaction)) << r.supports[i].name;
  }
  expect_spans(*r.bed, bed["free_spans"]);
  EXPECT_LT(r.global_residual, 1e-8);
}

INSTANTIATE_TEST_SUITE_P(of_the_reference, uneven_bed,
                         ::testing::Values("BP16-bump", "BP16-slope", "BP24-depression", "BP24-sleeper"));

TEST(uneven_bed_mesh, changes_nothing_that_is_reported) {
  Description d = described("BP24-sleeper");
  const StaticResults coarse = lay(d);
  d.mesh.touchdown_element = 0.4;
  d.mesh.max_element_length = 1.0;
  const StaticResults fine = lay(d);
  ASSERT_GT(fine.stations.size(), coarse.stations.size());
  EXPECT_NEAR(coarse.lay_back, fine.lay_back, 0.02);
  EXPECT_NEAR(coarse.bed->hogging_moment, fine.bed->hogging_moment, 1e-3 * fine.bed->hogging_moment);
  EXPECT_NEAR(coarse.bed->sagging_moment, fine.bed->sagging_moment, 1e-3 * fine.bed->sagging_moment);
  const auto a = open_spans(coarse.bed->spans), b = open_spans(fine.bed->spans);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i].max_gap, b[i].max_gap, 1e-3);
}

TEST(uneven_bed_profile, of_a_plane_lays_as_the_plane_does) {
  Description d = described("BP16-slope");
  SeabedDescription& bed = d.environment.seabed;
  const double fall = 0.02;
  bed.profile = {{-500.0, 89.0 - 500.0 * fall}, {2000.0, 89.0 + 2000.0 * fall}};
  const StaticResults profile = lay(d);
  bed.profile.clear();
  bed.slope = std::atan(fall);
  bed.slope_towards = d.vessel.heading + 3.14159265358979323846;
  const StaticResults plane = lay(d);
  EXPECT_FALSE(plane.bed.has_value());
  EXPECT_NEAR(profile.lay_back, plane.lay_back, 2e-3);
  EXPECT_NEAR(profile.bottom_tension, plane.bottom_tension, 5.0);
  EXPECT_NEAR(profile.sagbend.bending_moment.value, plane.sagbend.bending_moment.value, 100.0);
  EXPECT_EQ(profile.bed->contacts.size(), 1U);
}

TEST(uneven_bed_grid, of_a_profile_drawn_wide_lays_as_the_profile_does) {
  Description d = described("BP24-depression");
  const StaticResults profile = lay(d);
  // The profile's own points as the columns of a grid; the barge heads east, so that x astern runs west.
  Bathymetry grid;
  const std::vector<ProfilePoint> points = d.environment.seabed.profile;
  grid.columns = static_cast<int>(points.size());
  grid.rows = 2;
  for (const double north : {-50.0, 50.0}) {
    for (auto point = points.rbegin(); point != points.rend(); ++point) {
      grid.east.push_back(d.vessel.stern_shoe_x - point->x);
      grid.north.push_back(north);
      grid.depth.push_back(point->depth);
    }
  }
  d.environment.seabed.profile.clear();
  d.environment.seabed.bathymetry = grid;
  const StaticResults wide = lay(d);
  EXPECT_NEAR(wide.lay_back, profile.lay_back, 1e-4);
  EXPECT_NEAR(wide.bed->hogging_moment, profile.bed->hogging_moment, 1e-4 * profile.bed->hogging_moment);
  EXPECT_EQ(wide.bed->spans.size(), profile.bed->spans.size());
}

/// Far behind touchdown the pipe rests where the soil's law carries its submerged weight.
TEST(uneven_bed_soil, carries_the_pipe_at_the_penetration_of_its_law) {
  Description d = described("BP16-slope");
  SeabedDescription& bed = d.environment.seabed;
  bed.profile = {{0.0, 89.0}, {900.0, 89.0}};
  const double weight = build_model(d).sections.front().weight_submerged, elastic = weight / bed.stiffness;
  bed.bearing_force = 3.0 * weight;
  bed.soil = SoilModel::hyperbolic;
  EXPECT_NEAR(lay(d).stations.front().penetration, elastic * 1.5, 1e-4 * elastic);  // x = w/k / (1 - w/bearing)
  bed.bearing_force = 0.5 * weight;
  bed.soil = SoilModel::bilinear;
  EXPECT_NEAR(lay(d).stations.front().penetration, elastic * 5.5, 1e-4 * elastic);  // half by k, half by k/10
}

TEST(uneven_bed_soil, that_does_not_bear_the_pipe_is_rejected) {
  Description d = described("BP16-slope");
  d.environment.seabed.soil = SoilModel::hyperbolic;
  d.environment.seabed.bearing_force = 100.0;
  const StaticOutcome outcome = solve_statics(build_model(d));
  ASSERT_TRUE(outcome.failure.has_value());
  EXPECT_EQ(outcome.failure->what, "the seabed does not carry the pipe");
}

}  // namespace
}  // namespace overbend
