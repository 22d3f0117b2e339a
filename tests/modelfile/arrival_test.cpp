// Each key into the member that it says: a model in which no two numbers of a kind are alike.
#include <gtest/gtest.h>

#include "modelfile/binding/binding.h"
#include "modelfile/fields/field_table.h"

namespace overbend {
namespace {

/// Without the checks of one value against another, which no model with every key would pass.
Description bound(const std::string& text) {
  Diagnostics diagnostics;
  const YamlNode root = parse_yaml(text, "a.yaml", diagnostics).value();
  const FieldValue values = read_fields(root, field_tree(), "a.yaml", diagnostics);
  for (const std::string& line : diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
  return bind_model(values, "a.yaml");
}

/// The groups that every model must have, less those that `text` gives.
std::string completed(std::string text) {
  const std::pair<const char*, const char*> groups[] = {
      {"overbend:", "overbend: 1\n"},
      {"environment:", "environment: {water_depth: 9 m, seabed: {stiffness: 1 MPa}}\n"},
      {"pipe:", "pipe: {steel: {outside_diameter: 0.4 m, wall_thickness: 0.02 m, yield_stress: 400 MPa}}\n"},
      {"vessel:", "vessel: {stern_shoe: {x: -60 m, z: 1 m}}\n"},
      {"tensioner:", "tensioner: {x: 0 m, z: 1 m}\n"}};
  for (const auto& [key, group] : groups) {
    if (text.find(key) != 0 && text.find(std::string("\n") + key) == std::string::npos) text += group;
  }
  return text;
}

/// 101, 102, 103, ... in the order of the list, to rounding.
void expect_from(double first, std::initializer_list<double> values) {
  int i = 0;
  for (const double value : values) EXPECT_NEAR(value, first + i++, 1e-9) << "value " << i << " of the list";
}

TEST(arrival, of_the_environment) {
  const EnvironmentDescription e = bound(completed(R"(environment:
  water_depth: 101 m
  water_weight_density: 102 N/m^3
  seabed: {stiffness: 103 N/m^2, friction: {axial: 0.1, lateral: 0.2}, damping: 104 N*s/m^2, slope: 0.5 rad, slope_towards: 0.6 rad}
  current: [{depth: 1 m, speed: 2 m/s, towards: 3 rad}, {depth: 4 m, speed: 5 m/s, towards: 6 rad}]
  waves: {type: stokes5, hs: 1 m, tp: 2 s, height: 3 m, period: 4 s, phase: 5 rad, from: 6 rad, gamma: 7, spreading: 8, components: 9, seed: 10, spectrum_file: s.csv}
)"))
                                       .environment;
  expect_from(101, {e.water_depth, e.water_weight_density, e.seabed.stiffness, e.seabed.damping});
  expect_from(1, {10 * e.seabed.friction_axial, 10 * e.seabed.friction_lateral});
  expect_from(5, {10 * e.seabed.slope, 10 * e.seabed.slope_towards});
  ASSERT_EQ(e.current.size(), 2U);
  expect_from(1, {e.current[0].depth, e.current[0].speed, e.current[0].towards, e.current[1].depth, e.current[1].speed,
                  e.current[1].towards});
  const WavesDescription& w = e.waves.front();
  EXPECT_EQ(w.type, WaveType::stokes5);
  expect_from(1, {w.hs, w.tp, w.height, w.period, w.phase, w.from, w.gamma.value(), w.spreading.value(),
                  static_cast<double>(w.components), static_cast<double>(w.seed)});
  EXPECT_EQ(w.spectrum_file, "s.csv");
}

/// Values of a section, all in SI.
constexpr const char* kSection = R"({
  steel: {outside_diameter: 1 m, wall_thickness: 0.2 m, youngs_modulus: 3 Pa, poissons_ratio: 0.4, yield_stress: 5 Pa,
    tensile_strength: 6 Pa, weight_density: 7 N/m^3, material: {law: bilinear, moment_coefficient: 1, moment_exponent: 2,
    hardening_exponent: 3, yield_strain: 4 %, hardening_modulus: 5 Pa, stress_strain: [{strain: 0.1 %, stress: 6 Pa}],
    moment_curvature: [{curvature: 7 m-1, moment: 8 N*m}]}},
  coatings: [{name: a, thickness: 0.1 m, weight_density: 2 N/m^3, youngs_modulus: 3 Pa}, {thickness: 0.4 m, weight_density: 5 N/m^3}],
  joint: {length: 1 m, field_joint: 2 m, infill_weight_density: 3 N/m^3, coated_stiffness: 4, first: 5 m, strain_factor: 6},
  hydrodynamics: {drag_normal: 1, drag_axial: 2, added_mass_normal: 3, added_mass_axial: 4},
  contents: {weight_density: 5 N/m^3, pressure: 6 Pa})";

void expect_section(const SectionDescription& s) {
  const SteelDescription& steel = s.steel;
  expect_from(1, {steel.outside_diameter, 10 * steel.wall_thickness, steel.youngs_modulus, 10 * steel.poissons_ratio,
                  steel.yield_stress, steel.tensile_strength.value(), steel.weight_density});
  const MaterialDescription& m = steel.material;
  EXPECT_EQ(m.law, MaterialLaw::bilinear);
  ASSERT_EQ(m.stress_strain.size(), 1U);
  ASSERT_EQ(m.moment_curvature.size(), 1U);
  expect_from(
      1, {m.moment_coefficient.value(), m.moment_exponent.value(), m.hardening_exponent.value(), 100 * m.yield_strain,
          m.hardening_modulus, m.stress_strain[0].y, m.moment_curvature[0].x, m.moment_curvature[0].y});
  EXPECT_NEAR(m.stress_strain[0].x, 0.001, 1e-15);
  ASSERT_EQ(s.coatings.size(), 2U);
  EXPECT_EQ(s.coatings[0].name, "a");
  EXPECT_EQ(s.coatings[1].name, "coating 2");
  expect_from(1, {10 * s.coatings[0].thickness, s.coatings[0].weight_density, s.coatings[0].youngs_modulus.value(),
                  10 * s.coatings[1].thickness, s.coatings[1].weight_density});
  const JointDescription& j = s.joint.value();
  expect_from(1, {j.length, j.field_joint, j.infill_weight_density, j.coated_stiffness, j.first.value(),
                  j.strain_factor.value()});
  const HydrodynamicsDescription& h = s.hydrodynamics;
  expect_from(1, {h.drag_normal, h.drag_axial, h.added_mass_normal, h.added_mass_axial, s.contents_weight_density,
                  s.internal_pressure});
}

TEST(arrival, of_the_line) {
  const PipeDescription pipe =
      bound(completed("pipe: " + std::string(kSection) + ", length: 11 m, anchor: 12 m}\n")).pipe;
  expect_section(pipe.section);
  expect_from(11, {pipe.length.value(), pipe.anchor.value()});
}

TEST(arrival, of_a_segment_that_gives_all) {
  const PipeDescription pipe =
      bound(completed("pipe: {steel: {outside_diameter: 0.4 m, wall_thickness: 0.02 m, yield_stress: 400 MPa}, "
                      "segments: [{length: 3 m}, " +
                      std::string(kSection) + ", name: b, length: 4 m}]}\n"))
          .pipe;
  ASSERT_EQ(pipe.segments.size(), 2U);
  EXPECT_EQ(pipe.segments[0].name, "segment 1");
  EXPECT_EQ(pipe.segments[1].name, "b");
  expect_from(3, {pipe.segments[0].length, pipe.segments[1].length});
  expect_section(pipe.segments[1].section);
  EXPECT_EQ(pipe.section.hydrodynamics.drag_axial, 0.0);
}

TEST(arrival, of_the_vessel) {
  const VesselDescription v =
      bound(completed(R"(vessel: {name: Karl, length: 101 m, beam: 102 m, depth: 103 m, draught: 104 m,
  heading: 0.1 rad, trim: 0.2 rad, heel: 0.3 rad, stern_shoe: {x: 4 m, z: 5 m}, motion: {harmonic: {
  surge: {amplitude: 1 m, period: 2 s, phase: 3 rad}, yaw: {amplitude: 4 rad, period: 5 s, phase: 6 rad}}}}
)"))
          .vessel;
  EXPECT_EQ(v.name, "Karl");
  expect_from(101, {v.length, v.beam, v.depth, v.draught});
  expect_from(1, {10 * v.heading, 10 * v.trim, 10 * v.heel, v.stern_shoe_x, v.stern_shoe_z});
  EXPECT_EQ(v.motion, VesselMotion::harmonic);
  ASSERT_EQ(v.harmonic.size(), 2U);
  const HarmonicMotion &surge = v.harmonic.at("surge"), &yaw = v.harmonic.at("yaw");
  expect_from(1, {surge.amplitude, surge.period, surge.phase, yaw.amplitude, yaw.period, yaw.phase});
}

TEST(arrival, of_the_tensioner) {
  const TensionerDescription t =
      bound(completed(R"(tensioner: {x: 1 m, z: 2 m, incline: 0.3 rad, guide: pinned, tension: 4 N,
  range: [5 N, 6 N], mode: constant, delay: 7 s, velocity: 8 m/s, acceleration: 9 m/s^2, travel: 10 m}
)"))
          .tensioner;
  expect_from(1, {t.x, t.z, 10 * t.incline, t.tension.value(), t.range_low.value(), t.range_high.value(), t.delay,
                  t.velocity, t.acceleration.value(), t.travel.value()});
  EXPECT_EQ(t.guide, Guide::pinned);
  EXPECT_EQ(t.mode, TensionerMode::constant);
}

TEST(arrival, of_rollers_and_supports) {
  const Description d = bound(completed(R"(rollers:
  v: {bottom: {radius: 1 m, face: 2 m}, sides: {radius: 3 m, face: 4 m, angle: 0.5 rad, clearance: 6 m}, stiffness: 7 N/m,
    default_stiffness: penalty, structure_stiffness: 8 N/m, friction: {axial: 0.1, lateral: 0.2}, restitution: 0.3,
    damping: textbook, tangential_stiffness: 9 N/m}
supports:
  contact: gap_springs
  ramp: {roller: v, rows: 2, boxes: [{x: 3 m, z: 4 m, offset: 5 m, length: 6 m, incline: 0.7 rad}]}
  stinger: {roller: v, rows: 12, boxes: [{name: tip, x: 13 m, z: 14 m, roller: w, rows: 15}]}
)"));
  ASSERT_EQ(d.rollers.size(), 1U);
  const RollerKindDescription& r = d.rollers[0];
  EXPECT_EQ(r.name, "v");
  const SideRollerDescription& sides = r.sides.value();
  expect_from(1, {r.bottom.radius, r.bottom.face, sides.radius, sides.face, 10 * sides.angle, sides.clearance,
                  r.stiffness.value(), r.structure_stiffness.value(), r.tangential_stiffness.value()});
  expect_from(1, {10 * r.friction_axial, 10 * r.friction_lateral, 10 * r.restitution});
  EXPECT_EQ(r.default_stiffness, RollerStiffness::penalty);
  EXPECT_EQ(r.damping, RollerDamping::textbook);
  EXPECT_EQ(d.supports.contact, SupportContact::gap_springs);
  ASSERT_EQ(d.supports.boxes.size(), 2U);
  const BoxDescription &ramp = d.supports.boxes[0], &tip = d.supports.boxes[1];
  expect_from(2, {static_cast<double>(ramp.rows), ramp.x, ramp.z, ramp.offset, ramp.length, 10 * ramp.incline.value()});
  expect_from(13, {tip.x, tip.z, static_cast<double>(tip.rows)});
  EXPECT_EQ(ramp.name, "ramp 1");
  EXPECT_EQ(ramp.roller, "v");
  EXPECT_EQ(ramp.structure, Structure::ramp);
  EXPECT_EQ(tip.name, "tip");
  EXPECT_EQ(tip.roller, "w");
  EXPECT_EQ(tip.structure, Structure::stinger);
}

TEST(arrival, of_the_analysis_and_the_head) {
  const Description d = bound(completed(R"(overbend: 1
title: t
report: {client: a, project: b, document: c, revision: d, prepared: e, checked: f}
analysis:
  mesh: {overbend_element: 1 m, touchdown_element: 2 m, longest_element: 3 m}
  static: {method: dynamic_relaxation, history: monotonic, tolerance: 0.0004, max_iterations: 5}
  dynamic: {duration: 1 s, build_up: 2 s, step: 3 s, max_step: 4 s, spectral_radius: 0.5, output_step: 6 s, impact_steps: 7,
    impact_force: 8 N, tolerance: 0.0009, step_error: 0.01 m, seeds: [11, 12], impacts: captured}
)"));
  EXPECT_EQ(d.title, "t");
  EXPECT_EQ(
      d.report.client + d.report.project + d.report.document + d.report.revision + d.report.prepared + d.report.checked,
      "abcdef");
  expect_from(1, {d.mesh.overbend_element.value(), d.mesh.touchdown_element.value(), d.mesh.max_element_length.value(),
                  1e4 * d.statics.tolerance, static_cast<double>(d.statics.max_iterations)});
  EXPECT_EQ(d.statics.method, StaticMethod::dynamic_relaxation);
  EXPECT_EQ(d.statics.history, LayHistory::monotonic);
  const DynamicSettings& s = d.dynamics.value();
  expect_from(1, {s.duration, s.build_up, s.step.value(), s.max_step.value(), 10 * s.spectral_radius, s.output_step,
                  s.impact_steps, s.impact_force.value(), 1e4 * s.tolerance, 1e3 * s.step_error.value()});
  EXPECT_EQ(s.seeds, (std::vector<std::uint64_t>{11, 12}));
  EXPECT_EQ(s.impacts, ImpactTreatment::captured);
}

}  // namespace
}  // namespace overbend
