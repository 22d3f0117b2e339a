// The line's inclination at the tensioner, against the elastica by collocation.
#include <gtest/gtest.h>

#include "modelfile/reading/yaml_reader.h"
#include "statics/moored/moored_lay.h"
#include "study/run/static_analysis.h"

namespace overbend {
namespace {

// GS12-J-angle: with 502.468169 kN a pinned J-lay leaves its tower at 65 degrees.
TEST(top_inclination, of_a_pinned_j_lay_is_that_of_the_reference) {
  Description d = read_model(OVERBEND_SOURCE_DIR "/validation/seek_cases/GS12-J-angle.yaml").description.value();
  d.tensioner.tension = 502468.169363;
  Model model = build_model(d);
  const StaticResults results = checked_statics(model, solve_lay(model));
  constexpr double kWanted = 1.1344640138;  // [rad]
  constexpr double kSlope = 1.284e-6;       // [rad/N]: 0.1 % of the tension are 0.6 mrad
  EXPECT_NEAR(results.top_inclination, kWanted, kSlope * 0.001 * 502e3);
}

}  // namespace
}  // namespace overbend
