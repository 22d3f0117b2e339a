#include "statics/recovery/static_findings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numbers>

#include "support/solved_case.h"

namespace overbend {
namespace {

using testing::solved_case;

/// Warnings of a solved lay after a change of its model or of its results.
std::vector<std::string> warnings_with(const std::function<void(Description&, StaticResults&)>& change) {
  auto [description, results] = solved_case("S16-T300");
  results.findings.clear();
  change(description, results);
  warn_statics(build_model(description), results);
  return messages(results.findings);
}

int mentions(const std::vector<std::string>& list, const std::string& message) {
  return static_cast<int>(std::count_if(list.begin(), list.end(),
                                        [&](const std::string& s) { return s.find(message) != std::string::npos; }));
}

TEST(static_findings, a_sound_lay_has_none) {
  const std::vector<std::string> list =
      warnings_with([](Description& d, StaticResults&) { d.pipe.section.joint->strain_factor = 1.1; });
  EXPECT_TRUE(list.empty()) << list.front();
}

TEST(static_findings, compression_says_where_and_how_much) {
  const std::vector<std::string> list = warnings_with([](Description&, StaticResults& r) {
    r.min_effective_tension = {-8e3, r.touchdown.s, r.touchdown.p_W, r.touchdown.astern};
  });
  EXPECT_EQ(mentions(list, "the effective tension falls to -8.00 kN"), 1);
  EXPECT_EQ(mentions(list, "from the tensioner (sagbend)"), 1);
}

TEST(static_findings, the_smallest_tension_is_that_of_the_stations) {
  const StaticResults& r = solved_case("S16-T300").results;
  for (const Station& station : r.stations) EXPECT_GE(station.effective_tension, r.min_effective_tension.value);
}

TEST(static_findings, stress_past_yield_is_reported_for_linear_steel_alone) {
  const auto weak = [](Description& d, StaticResults& r) {
    d.pipe.section.steel.yield_stress = 200e6;
    for (Station& station : r.stations) station.yield_stress = 200e6;
  };
  EXPECT_EQ(mentions(warnings_with(weak), "exceeds the yield stress of 200 MPa"), 1);
  const auto yielding = [&](Description& d, StaticResults& r) {
    weak(d, r);
    d.pipe.section.steel.material.law = MaterialLaw::ramberg_osgood;
    d.pipe.section.steel.material.hardening_exponent = 20.0;
  };
  EXPECT_EQ(mentions(warnings_with(yielding), "exceeds the yield stress"), 0);
}

TEST(static_findings, supports_below_the_bed_are_named) {
  const auto shallow = [](Description& d, StaticResults&) { d.environment.water_depth = 8.0; };
  const std::vector<std::string> list = warnings_with(shallow);
  EXPECT_EQ(mentions(list, "below the seabed: '"), 1);
  EXPECT_EQ(mentions(list, "the stinger's tip among them"), 1);
}

TEST(static_findings, a_stern_shoe_below_the_water_is_reported) {
  const std::vector<std::string> list =
      warnings_with([](Description& d, StaticResults&) { d.vessel.stern_shoe_z = -1.5; });
  EXPECT_EQ(mentions(list, "the stern shoe is 1.50 m below the water"), 1);
}

TEST(static_findings, a_box_out_of_line_is_named) {
  const std::size_t box = solved_case("S16-T300").description.supports.boxes.size() - 4;
  for (const double shift : {1.0, -1.0}) {
    const std::vector<std::string> list =
        warnings_with([&](Description& d, StaticResults&) { d.supports.boxes.at(box).z += shift; });
    const std::string name = "the box '" + solved_case("S16-T300").description.supports.boxes.at(box).name + "' is";
    EXPECT_EQ(mentions(list, name), 1) << shift;
    EXPECT_EQ(mentions(list, shift > 0.0 ? "m above the line" : "m below the line"), 1);
  }
}

TEST(static_findings, a_structure_beyond_the_end_of_the_line_is_reported) {
  const double total = solved_case("S16-T300").results.total_length;
  const auto with = [](double position) {
    return warnings_with([position](Description& d, StaticResults&) {
      d.pipe.section.joint->strain_factor = 1.1;
      StructureDescription& tee = d.pipe.structures.emplace_back();
      tee.name = "tee";
      tee.at = position;
      tee.length = 4.0;
      tee.weight_in_air = 40e3;
      tee.weight_submerged = 30e3;
    });
  };
  EXPECT_TRUE(with(total - 3.0).empty());
  EXPECT_EQ(mentions(with(total - 1.0), "the structure 'tee'"), 1);
  EXPECT_EQ(mentions(with(total - 1.0), "extends beyond the end of the line"), 1);
  EXPECT_EQ(mentions(with(5000.0), "(at: 5000 m) lies beyond the end of the line"), 1);
}

TEST(static_findings, a_slope_on_which_friction_does_not_hold_the_laid_pipe_is_reported) {
  const auto prescribed = [](double friction, double slope) {
    int count = 0;
    for (const double towards : {0.0, 0.5, 1.0, 1.5}) {  // ahead, astern and to either side
      count += mentions(warnings_with([&](Description& d, StaticResults&) {
                          d.environment.seabed.friction_axial = friction;
                          d.environment.seabed.slope = slope;
                          d.environment.seabed.slope_towards = d.vessel.heading + towards * std::numbers::pi;
                        }),
                        "the laid pipe slides on its bed");
    }
    return count;
  };
  EXPECT_EQ(prescribed(0.02, 0.05), 2);  // falling astern and rising
  EXPECT_EQ(prescribed(0.06, 0.05), 0);
  EXPECT_EQ(prescribed(0.0, 0.0), 0);
}

TEST(static_findings, strain_at_field_joints_that_is_not_given_is_missing) {
  const auto joint = [](Description& d, StaticResults&) {
    d.pipe.section.coatings = {{"concrete", 0.04, 22e3}};
    d.pipe.section.joint = JointDescription{12.0, 0.6, 10e3};
  };
  const char* arguments = "the strain concentration at the field joints is missing";
  EXPECT_EQ(mentions(warnings_with(joint), arguments), 1);
  for (const bool stiff : {false, true}) {
    EXPECT_EQ(mentions(warnings_with([&](Description& d, StaticResults& r) {
                         joint(d, r);
                         if (stiff) {
                           d.pipe.section.joint->coated_stiffness = 1.3;
                         } else {
                           d.pipe.section.joint->strain_factor = 1.0;
                         }
                       }),
                       arguments),
              0);
  }
}

TEST(static_findings, a_seabed_that_leaves_the_water_under_the_laid_pipe_is_reported) {
  const auto prescribed = [](double slope, double towards) {
    return mentions(warnings_with([&](Description& d, StaticResults&) {
                      d.environment.seabed.friction_axial = 1.0;
                      d.environment.seabed.slope = slope;
                      d.environment.seabed.slope_towards = d.vessel.heading + towards;
                    }),
                    "the seabed is above the water under the laid pipe");
  };
  EXPECT_EQ(prescribed(0.5, 0.0), 1);               // falls ahead, rises astern
  EXPECT_EQ(prescribed(0.5, std::numbers::pi), 0);  // falls astern
  EXPECT_EQ(prescribed(0.01, 0.0), 0);
}

TEST(static_findings, a_tensioner_that_points_past_the_first_box_is_reported) {
  const auto prescribed = [](double incline) {
    return mentions(warnings_with([&](Description& d, StaticResults&) { d.tensioner.incline = incline; }),
                    "check tensioner.incline");
  };
  EXPECT_EQ(prescribed(0.5), 1);
  EXPECT_EQ(prescribed(-0.5), 1);
  EXPECT_EQ(prescribed(0.0), 0);
}

}  // namespace
}  // namespace overbend
