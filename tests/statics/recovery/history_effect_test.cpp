#include "statics/recovery/history_effect.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "modelfile/reading/yaml_reader.h"
#include "statics/recovery/recovery.h"

namespace overbend {
namespace {

Description bent_lay() {
  return read_model(OVERBEND_SOURCE_DIR "/examples/bgl1-as-printed-steel.yaml").description.value();
}

StaticResults solved(const Description& d) {
  const Model model = build_model(d);
  const StaticOutcome outcome = solve_statics(model);
  StaticResults results = recover_statics(model, *outcome.solution);
  note_history_effect(model, *outcome.solution, results);
  return results;
}

std::optional<std::string> find(const std::vector<std::string>& list, const std::string& text) {
  const auto found =
      std::ranges::find_if(list, [&](const std::string& s) { return s.find(text) != std::string::npos; });
  return found == list.end() ? std::nullopt : std::optional(*found);
}

}  // namespace

TEST(history_effect, yielding_lays_say_what_the_other_history_would_give) {
  Description d = bent_lay();
  const StaticResults laying = solved(d);
  d.statics.history = LayHistory::monotonic;
  const StaticResults monotonic = solved(d);
  const auto percent = [](const StaticResults& results) {
    return fmt::format("{:.3f} %", 100.0 * results.overbend->strain.value);
  };
  const std::string both = fmt::format("overbend {} after passing the supports (laying), {} bent directly (monotonic)",
                                       percent(laying), percent(monotonic));
  for (const StaticResults& results : {laying, monotonic}) {
    EXPECT_TRUE(find(messages(results.findings), both) || find(texts(results.assumptions), both)) << both;
  }
}

TEST(history_effect, a_lay_that_does_not_yield_says_nothing_of_it) {
  Description d = bent_lay();
  d.pipe.section.steel.yield_stress = 900e6;
  const StaticResults results = solved(d);
  EXPECT_FALSE(find(messages(results.findings), "loading history"));
  EXPECT_FALSE(find(texts(results.assumptions), "loading history of pipe"));
}

TEST(history_effect, the_strain_next_to_a_stiff_stretch_of_a_yielding_overbend_is_called_too_low) {
  Description d = bent_lay();
  StructureDescription valve;
  valve.name = "valve";
  valve.at = 57.0;
  valve.length = 1.0;
  valve.weight_in_air = 10e3;
  valve.weight_submerged = 5e3;
  valve.bending_stiffness = 3e8;
  d.pipe.structures = {valve};
  const StaticResults results = solved(d);
  const std::optional<std::string> warning =
      find(messages(results.findings), "next to 'valve' is too low: the pipe there yields");
  ASSERT_TRUE(warning.has_value());
  EXPECT_FALSE(find(messages(results.findings), "the steel is linear elastic here"));
  d.pipe.structures.clear();
  d.pipe.segments = {{"plain", 56.5, d.pipe.section}, {"thick", 1.0, d.pipe.section}};
  d.pipe.segments[1].section.steel.wall_thickness *= 2.0;
  EXPECT_TRUE(find(messages(solved(d).findings), "next to 'thick' is too low"));
  d.statics.history = LayHistory::monotonic;
  EXPECT_FALSE(find(messages(solved(d).findings), "is too low"));
}

}  // namespace overbend
