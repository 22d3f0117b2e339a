#include "modelfile/model_binder.h"

#include <array>
#include <filesystem>

#include "modelfile/binding.h"
#include "modelfile/check_binder.h"

namespace overbend {
namespace {

/// A number for both directions, or a group with one each.
void take_friction(const FieldValue& group, double& axial, double& lateral) {
  if (const auto both = group.get_number("friction")) axial = lateral = *both;
  take(group, "friction.axial", axial);
  take(group, "friction.lateral", lateral);
}

std::string resolve(const std::string& file, const std::string& source_file) {
  const std::filesystem::path path(file);
  if (path.is_absolute()) return file;
  return (std::filesystem::path(source_file).parent_path() / path).lexically_normal().string();
}

const std::vector<FieldValue>& items(const FieldValue& group, const std::string& key) {
  static const std::vector<FieldValue> kNone;
  const FieldValue* list = group.find(key);
  return list != nullptr && list->kind == FieldValue::Kind::list ? list->children : kNone;
}

WavesDescription bind_waves(const FieldValue& group, const std::string& source_file) {
  WavesDescription waves;
  take_choice(group, "type", std::array{"none", "airy", "stokes5", "jonswap", "pierson_moskowitz", "user"}, waves.type);
  take(group, "hs", waves.hs);
  take(group, "tp", waves.tp);
  take(group, "height", waves.height);
  take(group, "period", waves.period);
  take(group, "phase", waves.phase);
  take(group, "from", waves.from);
  take(group, "gamma", waves.gamma);
  take(group, "spreading", waves.spreading);
  take(group, "components", waves.components);
  if (const auto seed = group.get_integer("seed")) waves.seed = static_cast<std::uint64_t>(*seed);
  if (const auto file = group.get_text("spectrum_file")) waves.spectrum_file = resolve(*file, source_file);
  return waves;
}

EnvironmentDescription bind_environment(const FieldValue& root, const std::string& source_file) {
  EnvironmentDescription environment;
  take(root, "environment.water_depth", environment.water_depth);
  take(root, "environment.water_weight_density", environment.water_weight_density);
  if (const FieldValue* seabed = root.find("environment.seabed")) {
    take(*seabed, "stiffness", environment.seabed.stiffness);
    take_friction(*seabed, environment.seabed.friction_axial, environment.seabed.friction_lateral);
    take(*seabed, "damping", environment.seabed.damping);
    take(*seabed, "slope", environment.seabed.slope);
    take(*seabed, "slope_towards", environment.seabed.slope_towards);
  }
  for (const FieldValue& item : items(root, "environment.current")) {
    CurrentPoint point;
    take(item, "depth", point.depth);
    take(item, "speed", point.speed);
    take(item, "towards", point.towards);
    environment.current.push_back(point);
  }
  if (const FieldValue* waves = root.find("environment.waves")) environment.waves = bind_waves(*waves, source_file);
  return environment;
}

std::vector<CoatingDescription> bind_coatings(const FieldValue& group) {
  std::vector<CoatingDescription> coatings;
  for (const FieldValue& item : items(group, "coatings")) {
    CoatingDescription coating;
    coating.name = "coating " + std::to_string(coatings.size() + 1);
    take(item, "name", coating.name);
    take(item, "thickness", coating.thickness);
    take(item, "weight_density", coating.weight_density);
    take(item, "youngs_modulus", coating.youngs_modulus);
    coatings.push_back(coating);
  }
  return coatings;
}

std::vector<CurvePoint> bind_curve(const FieldValue& group, const char* list, const char* x, const char* y) {
  std::vector<CurvePoint> points;
  for (const FieldValue& item : items(group, list)) {
    CurvePoint point;
    take(item, x, point.x);
    take(item, y, point.y);
    points.push_back(point);
  }
  return points;
}

MaterialDescription bind_material(const FieldValue& group) {
  MaterialDescription material;
  take_choice(
      group, "law",
      std::array{"linear", "moment_ramberg_osgood", "ramberg_osgood", "bilinear", "stress_strain", "moment_curvature"},
      material.law);
  take(group, "moment_coefficient", material.moment_coefficient);
  take(group, "moment_exponent", material.moment_exponent);
  take(group, "hardening_exponent", material.hardening_exponent);
  take(group, "yield_strain", material.yield_strain);
  take(group, "hardening_modulus", material.hardening_modulus);
  material.stress_strain = bind_curve(group, "stress_strain", "strain", "stress");
  material.moment_curvature = bind_curve(group, "moment_curvature", "curvature", "moment");
  return material;
}

/// Reads what a group gives on top of `section`: defaults for the line, the line's own for a segment.
SectionDescription bind_section(const FieldValue& group, SectionDescription section) {
  SteelDescription& steel = section.steel;
  take(group, "steel.outside_diameter", steel.outside_diameter);
  take(group, "steel.wall_thickness", steel.wall_thickness);
  take(group, "steel.youngs_modulus", steel.youngs_modulus);
  take(group, "steel.poissons_ratio", steel.poissons_ratio);
  take(group, "steel.yield_stress", steel.yield_stress);
  take(group, "steel.tensile_strength", steel.tensile_strength);
  take(group, "steel.weight_density", steel.weight_density);
  if (const FieldValue* material = group.find("steel.material")) steel.material = bind_material(*material);
  if (group.find("coatings") != nullptr) section.coatings = bind_coatings(group);
  if (const FieldValue* joint = group.find("joint")) {
    section.joint = JointDescription{};
    take(*joint, "length", section.joint->length);
    take(*joint, "field_joint", section.joint->field_joint);
    take(*joint, "infill_weight_density", section.joint->infill_weight_density);
    take(*joint, "coated_stiffness", section.joint->coated_stiffness);
    take(*joint, "first", section.joint->first);
    take(*joint, "strain_factor", section.joint->strain_factor);
  }
  HydrodynamicsDescription& hydrodynamics = section.hydrodynamics;
  take(group, "hydrodynamics.drag_normal", hydrodynamics.drag_normal);
  take(group, "hydrodynamics.drag_axial", hydrodynamics.drag_axial);
  take(group, "hydrodynamics.added_mass_normal", hydrodynamics.added_mass_normal);
  take(group, "hydrodynamics.added_mass_axial", hydrodynamics.added_mass_axial);
  take(group, "contents.weight_density", section.contents_weight_density);
  take(group, "contents.pressure", section.internal_pressure);
  return section;
}

PipeDescription bind_pipe(const FieldValue& group) {
  PipeDescription pipe;
  pipe.section = bind_section(group, {});
  take(group, "length", pipe.length);
  take(group, "anchor", pipe.anchor);
  for (const FieldValue& item : items(group, "segments")) {
    SegmentDescription segment;
    segment.name = "segment " + std::to_string(pipe.segments.size() + 1);
    take(item, "name", segment.name);
    take(item, "length", segment.length);
    segment.section = bind_section(item, pipe.section);
    pipe.segments.push_back(segment);
  }
  return pipe;
}

void bind_motion(const FieldValue& group, const std::string& source_file, VesselDescription& vessel) {
  const auto from_file = [&](const char* key, VesselMotion kind) {
    const auto file = group.get_text(std::string("motion.") + key);
    if (!file) return;
    vessel.motion = kind;
    vessel.motion_file = resolve(*file, source_file);
  };
  from_file("raos", VesselMotion::raos);
  from_file("history", VesselMotion::history);
  from_file("coupled", VesselMotion::coupled);
  const FieldValue* harmonic = group.find("motion.harmonic");
  if (harmonic == nullptr) return;
  vessel.motion = VesselMotion::harmonic;
  for (const FieldValue& freedom : harmonic->children) {
    HarmonicMotion& motion = vessel.harmonic[freedom.key];
    take(freedom, "amplitude", motion.amplitude);
    take(freedom, "period", motion.period);
    take(freedom, "phase", motion.phase);
  }
}

VesselDescription bind_vessel(const FieldValue& group, const std::string& source_file) {
  VesselDescription vessel;
  take(group, "name", vessel.name);
  take(group, "length", vessel.length);
  take(group, "beam", vessel.beam);
  take(group, "depth", vessel.depth);
  take(group, "draught", vessel.draught);
  take(group, "heading", vessel.heading);
  take(group, "trim", vessel.trim);
  take(group, "heel", vessel.heel);
  take(group, "stern_shoe.x", vessel.stern_shoe_x);
  take(group, "stern_shoe.z", vessel.stern_shoe_z);
  bind_motion(group, source_file, vessel);
  return vessel;
}

TensionerDescription bind_tensioner(const FieldValue& group) {
  TensionerDescription tensioner;
  take(group, "x", tensioner.x);
  take(group, "z", tensioner.z);
  take(group, "incline", tensioner.incline);
  take_choice(group, "guide", std::array{"clamped", "pinned"}, tensioner.guide);
  take(group, "tension", tensioner.tension);
  const std::vector<FieldValue>& range = items(group, "range");
  if (range.size() == 2) {
    tensioner.range_low = range[0].number;
    tensioner.range_high = range[1].number;
    tensioner.mode = TensionerMode::controlled;
  }
  take_choice(group, "mode", std::array{"controlled", "locked", "constant"}, tensioner.mode);
  take(group, "delay", tensioner.delay);
  take(group, "velocity", tensioner.velocity);
  take(group, "acceleration", tensioner.acceleration);
  take(group, "travel", tensioner.travel);
  return tensioner;
}

RollerKindDescription bind_roller_kind(const FieldValue& group) {
  RollerKindDescription kind;
  kind.name = group.key;
  take(group, "bottom.radius", kind.bottom.radius);
  take(group, "bottom.face", kind.bottom.face);
  if (const FieldValue* sides = group.find("sides")) {
    kind.sides = SideRollerDescription{};
    take(*sides, "radius", kind.sides->radius);
    take(*sides, "face", kind.sides->face);
    take(*sides, "angle", kind.sides->angle);
    take(*sides, "clearance", kind.sides->clearance);
  }
  take(group, "stiffness", kind.stiffness);
  take_choice(group, "default_stiffness", std::array{"physical", "penalty"}, kind.default_stiffness);
  take(group, "structure_stiffness", kind.structure_stiffness);
  take_friction(group, kind.friction_axial, kind.friction_lateral);
  take(group, "restitution", kind.restitution);
  take_choice(group, "damping", std::array{"clipped", "textbook"}, kind.damping);
  take(group, "tangential_stiffness", kind.tangential_stiffness);
  return kind;
}

void bind_structure(const FieldValue& group, Structure structure, std::vector<BoxDescription>& boxes) {
  int number = 0;
  for (const FieldValue& item : items(group, "boxes")) {
    BoxDescription box;
    box.name = (structure == Structure::ramp ? "ramp " : "stinger ") + std::to_string(++number);
    box.structure = structure;
    take(item, "name", box.name);
    take(item, "x", box.x);
    take(item, "z", box.z);
    take(item, "offset", box.offset);
    take(item, "length", box.length);
    take(item, "incline", box.incline);
    for (const FieldValue* from : {&group, &item}) {  // what the box says comes last and wins
      take(*from, "roller", box.roller);
      take(*from, "rows", box.rows);
    }
    boxes.push_back(box);
  }
}

SupportsDescription bind_supports(const FieldValue& root) {
  SupportsDescription supports;
  take_choice(root, "supports.contact", std::array{"rollers", "gap_springs"}, supports.contact);
  if (const FieldValue* ramp = root.find("supports.ramp")) {
    take(*ramp, "radius", supports.ramp_radius);
    bind_structure(*ramp, Structure::ramp, supports.boxes);
  }
  if (const FieldValue* stinger = root.find("supports.stinger")) {
    take(*stinger, "radius", supports.stinger_radius);
    bind_structure(*stinger, Structure::stinger, supports.boxes);
  }
  return supports;
}

std::vector<std::uint64_t> bind_seeds(const FieldValue& dynamic) {
  std::vector<std::uint64_t> seeds;
  for (const FieldValue& seed : items(dynamic, "seeds")) seeds.push_back(static_cast<std::uint64_t>(seed.integer));
  const std::int64_t count = dynamic.get_integer("seeds").value_or(0);
  for (std::int64_t seed = 1; seed <= count; ++seed) seeds.push_back(static_cast<std::uint64_t>(seed));
  return seeds;
}

void bind_analysis(const FieldValue& root, Description& description) {
  const FieldValue* group = root.find("analysis");
  if (group == nullptr) return;
  take(*group, "mesh.overbend_element", description.mesh.overbend_element);
  take(*group, "mesh.touchdown_element", description.mesh.touchdown_element);
  take(*group, "mesh.longest_element", description.mesh.longest_element);
  take_choice(*group, "static.method", std::array{"newton", "dynamic_relaxation"}, description.statics.method);
  take_choice(*group, "static.history", std::array{"laying", "monotonic"}, description.statics.history);
  take(*group, "static.tolerance", description.statics.tolerance);
  take(*group, "static.max_iterations", description.statics.max_iterations);
  const FieldValue* dynamic = group->find("dynamic");
  if (dynamic == nullptr) return;
  DynamicSettings& settings = description.dynamics.emplace();
  take(*dynamic, "duration", settings.duration);
  take(*dynamic, "build_up", settings.build_up);
  take(*dynamic, "step", settings.step);
  take(*dynamic, "max_step", settings.max_step);
  take(*dynamic, "spectral_radius", settings.spectral_radius);
  take(*dynamic, "output_step", settings.output_step);
  take(*dynamic, "impact_steps", settings.impact_steps);
  take(*dynamic, "impact_force", settings.impact_force);
  take(*dynamic, "tolerance", settings.tolerance);
  take(*dynamic, "step_error", settings.step_error);
  settings.seeds = bind_seeds(*dynamic);
}

ReportDescription bind_report(const FieldValue& root) {
  ReportDescription report;
  take(root, "report.client", report.client);
  take(root, "report.project", report.project);
  take(root, "report.document", report.document);
  take(root, "report.revision", report.revision);
  take(root, "report.prepared", report.prepared);
  take(root, "report.checked", report.checked);
  return report;
}

}  // namespace

Description bind_model(const FieldValue& root, const std::string& source_file) {
  Description description;
  description.source_file = source_file;
  description.title = std::filesystem::path(source_file).stem().string();
  take(root, "title", description.title);
  description.report = bind_report(root);
  description.environment = bind_environment(root, source_file);
  if (const FieldValue* pipe = root.find("pipe")) description.pipe = bind_pipe(*pipe);
  if (const FieldValue* vessel = root.find("vessel")) description.vessel = bind_vessel(*vessel, source_file);
  if (const FieldValue* tensioner = root.find("tensioner")) description.tensioner = bind_tensioner(*tensioner);
  if (const FieldValue* rollers = root.find("rollers")) {
    for (const FieldValue& kind : rollers->children) description.rollers.push_back(bind_roller_kind(kind));
  }
  description.supports = bind_supports(root);
  bind_analysis(root, description);
  description.checks = bind_checks(root);
  return description;
}

}  // namespace overbend
