#include "model/dynamic_assumptions.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/fixtures.h"

namespace overbend {
namespace {

/// A sea state, a box of rollers and dynamics.
Description moving() {
  Description d = testing::plain_description();
  d.rollers.push_back({"v", {0.15, 0.6}, SideRollerDescription{0.15, 0.6, 1.0, 0.05}, std::nullopt, 0.0, 0.0, 0.5});
  BoxDescription box;
  box.x = 10.0;
  box.roller = "v";
  box.rows = 3;
  box.length = 3.0;
  d.supports.boxes.push_back(box);
  WavesDescription& waves = d.environment.waves.front();
  waves.type = WaveType::jonswap;
  waves.hs = 4.0;
  waves.tp = 8.5;  // Tp/sqrt(Hs) = 4.25: gamma = exp(5.75 - 1.15 * 4.25) = 2.37
  waves.seed = 17;
  d.dynamics.emplace();
  return d;
}

int mentions(const Description& d, const std::string& message) {
  const std::vector<std::string> list = texts(assumptions(build_model(d)));
  return static_cast<int>(std::count_if(list.begin(), list.end(),
                                        [&](const std::string& s) { return s.find(message) != std::string::npos; }));
}

TEST(dynamic_assumptions, of_a_stinger_are_reported_where_it_turns_by_itself) {
  Description d = moving();
  d.supports.boxes.front().structure = Structure::stinger;
  EXPECT_EQ(mentions(d, "The stinger rotates about its hinges during the dynamic analysis"), 0);
  StingerSectionDescription& section = d.supports.sections.emplace_back();
  section.body = StingerBodyDescription{};
  section.limits = StingerLimits{-0.1, 0.1};
  EXPECT_EQ(mentions(d, "The stinger rotates about its hinges during the dynamic analysis"), 1);
  EXPECT_EQ(mentions(d, "stops are springs with"), 1);
  section.angle = 0.02;
  EXPECT_EQ(mentions(d, "The stinger rotates about its hinges during the dynamic analysis"), 0);
}

TEST(dynamic_assumptions, are_reported_for_a_model_with_dynamics_alone) {
  Description d = moving();
  const std::size_t with = assumptions(build_model(d)).size();
  EXPECT_EQ(mentions(d, "half a cosine over the 60 s before t = 0"), 1);
  d.dynamics.reset();
  EXPECT_GT(with, assumptions(build_model(d)).size() + 8);
  EXPECT_EQ(mentions(d, "t = 0"), 0);
  EXPECT_EQ(mentions(d, "DNV-RP-F107"), 0);
}

TEST(dynamic_assumptions, are_reported_once_each_in_whole_sentences) {
  std::vector<std::string> list = texts(assumptions(build_model(moving())));
  for (const std::string& sentence : list) EXPECT_EQ(sentence.back(), '.') << sentence;
  std::sort(list.begin(), list.end());
  EXPECT_EQ(std::adjacent_find(list.begin(), list.end()), list.end());
}

TEST(dynamic_assumptions, call_steel_linear_only_where_it_is) {
  Description d = moving();
  EXPECT_EQ(mentions(d, "The steel stays linear in the dynamic analysis as well"), 1);
  d.pipe.section.steel.material.law = MaterialLaw::ramberg_osgood;
  d.pipe.section.steel.material.hardening_exponent = 20.0;
  EXPECT_EQ(mentions(d, "linear in the dynamic analysis"), 0);
  EXPECT_EQ(mentions(d, "Yielding in the dynamic analysis continues"), 1);
  SegmentDescription linear{"linear", 60.0, d.pipe.section};
  linear.section.steel.material = {};
  d.pipe.segments.push_back(linear);
  EXPECT_EQ(mentions(d, "Sections of linear steel stay linear in the dynamic analysis"), 1);
}

TEST(dynamic_assumptions, name_the_peak_of_the_sea_and_where_it_is_from) {
  Description d = moving();
  EXPECT_EQ(mentions(d, "JONSWAP spectrum with gamma = 2.37 from DNV-RP-C205"), 1);
  d.environment.waves.front().gamma = 3.3;
  EXPECT_EQ(mentions(d, "JONSWAP spectrum with gamma = 3.3 as given"), 1);
  d.environment.waves.front().type = WaveType::pierson_moskowitz;
  EXPECT_EQ(mentions(d, "Pierson-Moskowitz"), 1);
  EXPECT_EQ(mentions(d, "gamma"), 0);
}

TEST(dynamic_assumptions, name_the_components_the_seeds_and_the_spreading) {
  Description d = moving();
  EXPECT_EQ(mentions(d, "sum of 200 linear waves with random frequencies and phases, seed 17, all in one"), 1);
  d.dynamics->seeds = {4};
  EXPECT_EQ(mentions(d, "seed 4"), 1);
  d.dynamics->seeds = {4, 9};
  EXPECT_EQ(mentions(d, "seeds 4, 9"), 1);
  d.environment.waves.front().spreading = 8.0;
  EXPECT_EQ(mentions(d, "s = 8"), 1);
}

TEST(dynamic_assumptions, report_on_stretching_where_there_is_some) {
  Description d = moving();
  EXPECT_EQ(mentions(d, "Wheeler"), 1);
  d.environment.waves.front().type = WaveType::airy;
  EXPECT_EQ(mentions(d, "Wheeler"), 1);
  d.environment.waves.front().type = WaveType::stokes5;
  EXPECT_EQ(mentions(d, "Wheeler"), 0);
  EXPECT_EQ(mentions(d, "Stokes"), 1);
  EXPECT_EQ(mentions(d, "that at the stern shoe, 89.00 m"), 1);
  d.environment.waves.front().type = WaveType::none;
  EXPECT_EQ(mentions(d, "There are no waves."), 1);
  EXPECT_EQ(mentions(d, "that at the stern shoe"), 0);
}

TEST(dynamic_assumptions, of_several_groups_of_waves_name_each_and_the_height_of_all) {
  Description d = moving();
  WavesDescription& swell = d.environment.waves.emplace_back();
  swell.type = WaveType::pierson_moskowitz;
  swell.hs = 3.0;
  swell.tp = 14.0;
  swell.seed = 5;
  EXPECT_EQ(mentions(d, "The sea is the sum of 2 groups of waves with Hs 5 m together"), 1);
  EXPECT_EQ(mentions(d, "Waves 1 (jonswap): It has a JONSWAP spectrum"), 1);
  EXPECT_EQ(mentions(d,
                     "Waves 1 (jonswap): It is the sum of 200 linear waves with random frequencies and phases, seed "
                     "17"),
            1);
  EXPECT_EQ(mentions(d,
                     "Waves 2 (pierson_moskowitz): It is the sum of 200 linear waves with random frequencies and "
                     "phases, seed 5"),
            1);
  d.dynamics->seeds = {20};
  EXPECT_EQ(mentions(d, "phases, seed 8"), 1);  // three more, as for the first group
  EXPECT_EQ(mentions(d, "Wheeler"), 1);
}

TEST(dynamic_assumptions, report_periods_spectra_and_records_as_they_were_converted) {
  Description d = moving();
  WavesDescription& waves = d.environment.waves.front();
  waves.tz = 6.5;
  EXPECT_EQ(mentions(d,
                     "The peak period of 8.5 s is that of a JONSWAP spectrum with gamma = 2.37 from DNV-RP-C205 with "
                     "the zero up-crossing period of 6.5 s"),
            1);
  waves.tz.reset();
  waves.type = WaveType::torsethaugen;
  EXPECT_EQ(mentions(d, "simplified double peak model of 2004"), 1);
  EXPECT_EQ(mentions(d, "differs from the given one by up to 1.2 %"), 1);
  waves.type = WaveType::ochi_hubble;
  waves.parts = {{2.0, 14.0, 3.0}, {1.5, 7.0, 1.4}};
  EXPECT_EQ(mentions(d, "Hs 2 m, Tp 14 s and lambda 3, and Hs 1.5 m, Tp 7 s and lambda 1.4"), 1);
  waves.type = WaveType::elevation;
  waves.record = {0.5, 0.0, {0.3, -0.3, 0.3, -0.3, 0.3}};
  waves.assumptions = {{AssumptionRank::setting, "The mean of the measured elevation is subtracted."}};
  EXPECT_EQ(mentions(d, "measured elevation of 2 s"), 1);
  EXPECT_EQ(mentions(d, "Before and after the record the sea repeats it"), 1);
  EXPECT_EQ(mentions(d, "The mean of the measured elevation is subtracted."), 1);
}

TEST(dynamic_assumptions, report_what_the_tensioner_does) {
  Description d = moving();
  EXPECT_EQ(mentions(d, "is a locked brake"), 1);
  EXPECT_EQ(mentions(d, "mass and weight of the pipe behind the tensioner are neglected"), 0);
  d.tensioner.mode = TensionerMode::controlled;
  d.tensioner.range_low = 240e3;
  d.tensioner.range_high = 260e3;
  d.tensioner.delay = 2.0;
  d.tensioner.velocity = 0.25;
  EXPECT_EQ(mentions(d, "waits 2 s when the tension has left its range of 240 to 260 kN, then moves at up to 0.25 m/s"),
            1);
  EXPECT_EQ(mentions(d, "no acceleration is given: it reaches that speed in 0.5 s"), 1);
  EXPECT_EQ(mentions(d, "damps axial vibrations of the pipe that its steps do not resolve"), 1);
  d.dynamics->max_step = 0.02;
  EXPECT_EQ(mentions(d, "damps axial vibrations of the pipe that its steps do not resolve"), 0);
  EXPECT_EQ(mentions(d, "its travel is not limited"), 1);
  d.tensioner.acceleration = 0.1;
  d.tensioner.travel = 2.5;
  EXPECT_EQ(mentions(d, "accelerates and brakes at 0.1 m/s2"), 1);
  EXPECT_EQ(mentions(d, "its travel is limited to 2.5 m either way"), 1);
  d.tensioner.mode = TensionerMode::constant;
  EXPECT_EQ(mentions(d, "keeps the tension constant, without mass"), 1);
  EXPECT_EQ(mentions(d, "mass and weight of the pipe behind the tensioner are neglected"), 1);
}

TEST(dynamic_assumptions, report_how_rollers_damp_and_stick) {
  Description d = moving();
  EXPECT_EQ(mentions(d, "coefficient of restitution"), 1);
  EXPECT_EQ(mentions(d, "0.1 of the normal stiffness"), 1);
  EXPECT_EQ(mentions(d, "not in the static initial state"), 1);
  d.statics.roller_friction = RollerFriction::haul;
  EXPECT_EQ(mentions(d, "not in the static initial state"), 0);
  EXPECT_EQ(mentions(d, "initial state is that of statics"), 1);
  d.statics.roller_friction = RollerFriction::none;
  EXPECT_EQ(mentions(d, "weaker than 1 kN"), 1);
  d.rollers[0].damping = RollerDamping::textbook;
  d.rollers[0].tangential_stiffness = 1e6;
  d.dynamics->impact_force = 250.0;
  EXPECT_EQ(mentions(d, "textbook"), 1);
  EXPECT_EQ(mentions(d, "0.1 of the normal stiffness"), 0);
  EXPECT_EQ(mentions(d, "weaker than 0.25 kN"), 1);
}

TEST(dynamic_assumptions, report_on_impacts_that_are_captured) {
  Description d = moving();
  EXPECT_EQ(mentions(d, "Impacts are captured"), 0);
  d.dynamics->impacts = ImpactTreatment::captured;
  EXPECT_EQ(mentions(d, "Impacts are captured, not resolved"), 1);
  EXPECT_EQ(mentions(d, "neither counted nor recorded"), 1);
}

TEST(dynamic_assumptions, of_gap_springs_report_no_damping_and_no_friction) {
  Description d = moving();
  d.supports.contact = SupportContact::gap_springs;
  EXPECT_EQ(mentions(d, "one gap spring"), 1);
  EXPECT_EQ(mentions(d, "On either side a gap spring"), 1);
  EXPECT_EQ(mentions(d, "cylinders of finite length"), 0);
  EXPECT_EQ(mentions(d, "coefficient of restitution"), 0);
  EXPECT_EQ(mentions(d, "Roller friction"), 0);
  EXPECT_EQ(mentions(d, "weaker than 1 kN"), 1);
  d.rollers[0].sides.reset();
  EXPECT_EQ(mentions(d, "On either side a gap spring"), 0);
}

TEST(dynamic_assumptions, of_j_lay_report_nothing_of_rollers) {
  Description d = moving();
  d.supports.boxes.clear();
  EXPECT_EQ(mentions(d, "Impacts"), 0);
  EXPECT_EQ(mentions(d, "stress beyond yield is reported, not limited"), 1);
}

TEST(dynamic_assumptions, say_what_holds_the_laid_pipe) {
  Description d = moving();
  d.environment.seabed.friction_axial = 0.5;
  EXPECT_EQ(mentions(d, "the length over which axial friction balances"), 1);
  d.environment.seabed.friction_axial = 0.0;
  EXPECT_EQ(mentions(d, "The seabed has no axial friction"), 1);
  d.pipe.length = 900.0;  // its anchor is real
  EXPECT_EQ(mentions(d, "axial friction"), mentions(d, "axial friction is not mobilised"));
}

}  // namespace
}  // namespace overbend
