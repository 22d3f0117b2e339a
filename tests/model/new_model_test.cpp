// What `overbend new` chooses must be a lay that stands, not only a file that reads.
#include "model/new_model.h"

#include <gtest/gtest.h>

#include "analysis/recovery.h"
#include "io/yaml_reader.h"

namespace overbend {
namespace {

StaticOutcome solve_new(const NewOptions& options, Model& model) {
  const auto chosen = choose_model(options);
  if (const auto* why = std::get_if<std::string>(&chosen)) {
    ADD_FAILURE() << *why;
    return {};
  }
  const ModelReading reading = read_model_text(model_text(std::get<NewModel>(chosen)), "new.yaml");
  if (!reading.description) return {};
  model = build_model(*reading.description);
  return solve_statics(model);
}

TEST(new_model, a_lay_chosen_from_pipe_and_depth_stands_within_yield) {
  for (const char* pipe : {"8", "16", "24", "48"}) {
    for (const char* depth : {"60 m", "300 m", "1000 m", "2000 m"}) {
      for (const char* lay : {"s", "j"}) {
        NewOptions options;
        options.pipe = pipe;
        options.depth = depth;
        options.lay = lay;
        Model model;
        const StaticOutcome outcome = solve_new(options, model);
        ASSERT_TRUE(outcome.solution.has_value()) << pipe << " in, " << depth << ", " << lay
                                                  << "-lay: " << (outcome.failure ? outcome.failure->what : "not read");
        const StaticResults results = recover_statics(model, *outcome.solution);
        const double yield = model.sections.front().yield_stress;
        EXPECT_LT(results.sagbend.bending_stress.value, yield) << pipe << " in, " << depth << ", " << lay;
        if (results.overbend) {
          EXPECT_LT(results.overbend->bending_stress.value, yield) << pipe << " in, " << depth << ", " << lay;
        }
        EXPECT_EQ(results.overbend.has_value(), options.lay == "s") << pipe << " in, " << depth << ", " << lay;
      }
    }
  }
}

TEST(new_model, the_wall_stands_the_water_pressure) {
  // 16 in at 2500 m: API RP 1111 with 0.7 asks for a D/t of about 20; shallow water for 40 at most.
  NewOptions options;
  options.pipe = "16";
  options.depth = "2500 m";
  const NewModel deep = std::get<NewModel>(choose_model(options));
  EXPECT_LT(deep.diameter / deep.wall, 22.0);
  options.depth = "20 m";
  const NewModel shallow = std::get<NewModel>(choose_model(options));
  EXPECT_LE(shallow.diameter / shallow.wall, 40.0);
  EXPECT_GT(shallow.diameter / shallow.wall, 30.0);
}

TEST(new_model, nominal_sizes_are_those_of_api_5l) {
  EXPECT_DOUBLE_EQ(nominal_diameter(4).value_or(0.0), 0.1143);
  EXPECT_DOUBLE_EQ(nominal_diameter(12).value_or(0.0), 0.3239);
  EXPECT_DOUBLE_EQ(nominal_diameter(16).value_or(0.0), 0.4064);
  EXPECT_DOUBLE_EQ(nominal_diameter(48).value_or(0.0), 1.2192);
  EXPECT_FALSE(nominal_diameter(17).has_value());
  EXPECT_FALSE(nominal_diameter(50).has_value());
}

}  // namespace
}  // namespace overbend
