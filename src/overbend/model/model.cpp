#include "model/model.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "base/constants.h"
#include "base/ranges.h"
#include "base/require.h"
#include "model/lay_stage.h"
#include "model/site/seabed_shape.h"
#include "model/structures.h"

namespace overbend {
namespace {

Vec3 azimuth_direction(double azimuth) {
  return {std::sin(azimuth), std::cos(azimuth), 0.0};
}

/// Ramp/stinger axes in V: X astern, Y starboard, Z up.
Vec3 turn_S_to_V(const Vec3& d_S) {
  return {-d_S.x(), -d_S.y(), d_S.z()};
}

/// Returns the depths in axes that are moved by `moved` in the vessel's frame, for a vessel that moves ahead.
Bathymetry moved_depths(Bathymetry depths, const Vec3& moved) {
  for (double& east : depths.east) east += moved.x();
  for (double& north : depths.north) north += moved.y();
  return depths;
}

/// `ahead`: distance of the vessel ahead of the position for which its seabed is described [m].
SeabedSurface resolve_surface(const EnvironmentDescription& environment, const Vec3& stern_shoe_W, const Vec3& astern_W,
                              double ahead) {
  const SeabedDescription& bed = environment.seabed;
  const Vec3 moved = ahead * astern_W, origin = stern_shoe_W + moved;
  if (!bed.profile.empty()) {
    return {profile_shape(bed.profile, origin.data(), astern_W.data()), -environment.water_depth};
  }
  if (bed.bathymetry) return {grid_shape(moved_depths(*bed.bathymetry, moved)), -environment.water_depth};
  const Vec3 point_W(stern_shoe_W.x(), stern_shoe_W.y(), -environment.water_depth);
  const Vec3 normal_W = (std::tan(bed.slope) * azimuth_direction(bed.slope_towards) + Vec3::UnitZ()).normalized();
  return {point_W, normal_W};
}

CurrentProfile resolve_current(const std::vector<CurrentPoint>& table) {
  CurrentProfile profile;
  for (auto row = table.rbegin(); row != table.rend(); ++row) {  // the file is ordered downwards, the profile upwards
    const Vec3 v = row->speed * azimuth_direction(row->towards);
    profile.z.push_back(-row->depth);
    profile.vx.push_back(v.x());
    profile.vy.push_back(v.y());
  }
  return profile;
}

void add_section(Model& model, Section section, const SectionDescription& described) {
  model.sections.push_back(std::move(section));
  model.described.push_back(described);
}

/// Appends a span of the last section after `from` and advances `from` to its end; parts inboard of the tensioner or
/// beyond `end` are omitted.
void add_span(Model& model, double& from, double length, double end = kInfinity) {
  const double begin = std::max(from, 0.0), to = std::min(from + length, end);
  if (to > begin) model.spans.push_back({begin, to, static_cast<int>(model.sections.size()) - 1});
  from += length;
}

void add_cable(Model& model, double& from, double length) {
  const CableDescription& cable = *model.description.operation.lay.cable;
  add_section(model, cable_section(cable, model.water_weight_density), model.description.pipe.section);
  add_span(model, from, length);
}

void add_head(Model& model, double& from) {
  const HeadDescription& head = *model.description.operation.lay.head;
  const SectionDescription& described = head.section ? *head.section : model.description.pipe.section;
  add_section(model, head_section(head, described, model.water_weight_density), described);
  add_span(model, from, head.length);
}

/// Sections and their spans: cable and head before the pipe's segments or after the whole pipe, according to the
/// operation stage.
void resolve_sections(Model& model) {
  const Description& d = model.description;
  add_section(model, derive_section("pipe", d.pipe.section, model.water_weight_density), d.pipe.section);
  double from = 0.0;
  if (cable_at_top(d)) {
    add_cable(model, from, *d.stage->cable_out);
    add_head(model, from);
  }
  from = pipe_shift(d);
  for (const SegmentDescription& segment : d.pipe.segments) {
    add_section(model, derive_section(segment.name, segment.section, model.water_weight_density), segment.section);
    add_span(model, from, segment.length, pipe_end_distance(d));
  }
  if (cable_at_far_end(d)) {
    from = pipe_end_distance(d);
    add_head(model, from);
    add_cable(model, from, is_dragged(d) ? kInfinity : *d.operation.lay.cable->length);
  }
}

/// Length from the tensioner over which field joints are modelled individually: the supports and three pipe joints
/// beyond.
double jointed_length(const Description& d, double joint) {
  double reach = 0.0;
  for (const BoxDescription& box : d.supports.boxes) reach = std::max(reach, box.x + box.length - d.tensioner.x);
  return reach > 0.0 ? 1.1 * reach + 3.0 * joint : 0.0;
}

/// Length from the tensioner to the middle of the first field joint, which moves with the pipe [m]. Below a cable no
/// joint precedes it; otherwise joints that leave the tensioner do.
double first_joint(const Description& d, const JointDescription& joint) {
  const double first = joint.first.value_or(0.5 * joint.length), gone = pipe_shift(d);
  if (gone == 0.0 || cable_at_top(d)) return first + gone;
  return first + gone - joint.length * std::floor((first + gone) / joint.length);
}

/// Returns the joint pattern of a section whose coated pipe is stiffer between the joints; null for others.
const JointDescription* stiff_between_joints(const Model& model, int section) {
  const auto i = static_cast<std::size_t>(section);
  const std::optional<JointDescription>& joint = model.described[i].joint;
  if (model.sections[i].kind != SectionKind::pipe || !joint || joint->coated_stiffness <= 1.0) return nullptr;
  return &*joint;
}

/// Returns the whole line in pieces of one section each, from the tensioner.
std::vector<SectionSpan> whole_line(const std::vector<SectionSpan>& spans) {
  std::vector<SectionSpan> pieces;
  double from = 0.0;
  for (const SectionSpan& span : spans) {
    if (span.from > from) pieces.push_back({from, span.from, 0});
    pieces.push_back(span);
    from = span.to;
  }
  pieces.push_back({from, kInfinity, 0});
  return pieces;
}

/// Adds the section of coated pipe between the field joints of a section; returns its index.
int add_coated(Model& model, int section, double stiffness) {
  Section coated = model.sections[static_cast<std::size_t>(section)];
  coated.name = section == 0 ? "coated pipe between field joints" : coated.name + " between field joints";
  coated.EI *= stiffness;
  const SectionDescription described = model.described[static_cast<std::size_t>(section)];
  add_section(model, coated, described);
  return static_cast<int>(model.sections.size()) - 1;
}

/// Splits a piece of the line, up to `end`, at its field joints into coated pipe and joints.
void split_at_joints(Model& model, const SectionSpan& piece, int coated, const JointDescription& joint, double end) {
  const auto put = [&](double from, double to, int section) {
    if (to > from && section != 0) model.spans.push_back({from, to, section});
  };
  double from = piece.from;
  for (double middle = first_joint(model.description, joint); from < std::min(end, piece.to); middle += joint.length) {
    const double bare = std::clamp(middle - 0.5 * joint.field_joint, from, piece.to);
    const double next = std::clamp(middle + 0.5 * joint.field_joint, from, piece.to);
    put(from, bare, coated);
    put(bare, next, piece.section);
    from = next;
  }
  put(from, piece.to, piece.section);
}

/// Stiffer pipe between field joints, for the main section and segments.
void resolve_joints(Model& model) {
  const std::vector<SectionSpan> pieces = whole_line(model.spans);
  std::map<int, int> coated;
  model.spans.clear();
  for (const SectionSpan& piece : pieces) {
    const JointDescription* const stiff = stiff_between_joints(model, piece.section);
    const double end = stiff != nullptr ? jointed_length(model.description, stiff->length) : 0.0;
    if (piece.from >= end) {
      if (piece.section != 0) model.spans.push_back(piece);
      continue;
    }
    const JointDescription joint = *stiff;  // copy: the vector of sections grows below
    if (!coated.contains(piece.section)) {
      coated[piece.section] = add_coated(model, piece.section, joint.coated_stiffness);
    }
    split_at_joints(model, piece, coated[piece.section], joint, end);
  }
  if (const JointDescription* const stiff = stiff_between_joints(model, 0); stiff != nullptr && !coated.contains(0)) {
    // the pipe that feeds in during a run has it, regardless of segments
    coated[0] = add_coated(model, 0, stiff->coated_stiffness);
  }
  model.coated = coated.contains(0) ? coated[0] : 0;  // index before structures are appended
}

/// Loads on the wall from the tensioner to the seabed for the suspended pipe: the target tension, or the one found,
/// less the weight below the tensioner. Water pressure acts from outside.
std::vector<LevelLoads> wall_levels(const Model& model, const Section& section, double top_z) {
  const double depth = model.description.environment.water_depth;
  const TensionerDescription& tensioner = model.description.tensioner;
  const double tension = tensioner.tension.value_or(tensioner.found);
  std::vector<LevelLoads> levels;
  for (const double z : {-depth, -0.5 * depth, 0.0, std::max(top_z, 1.0)}) {
    const double above = std::max(top_z, 0.0) - std::max(z, 0.0);
    const double suspended_weight = section.weight_in_air * above - section.weight_submerged * std::min(z, 0.0);
    const double outside = -model.water_weight_density * std::min(z, 0.0);
    const double inside = section.internal_pressure - section.contents_weight_density * z;
    const double bore = section.steel_diameter - 2.0 * section.wall_thickness;
    LevelLoads level{z, {}};
    level.wall.wall_tension =
        std::max(tension - suspended_weight, 0.0) - outside * section.pressure_area + inside * section.internal_area;
    level.wall.hoop_stress = (inside * bore - outside * section.steel_diameter) / (2.0 * section.wall_thickness);
    levels.push_back(level);
  }
  return levels;
}

void resolve_bending(Model& model) {
  const double top_z = model.description.vessel.stern_shoe_z + model.description.tensioner.z;
  for (std::size_t i = 0; i < model.sections.size(); ++i) {
    if (model.sections[i].kind == SectionKind::cable) continue;
    const SteelDescription& steel = model.find_section_description(i).steel;
    model.sections[i].bending = bending_law(steel, wall_levels(model, model.sections[i], top_z));
  }
}

/// Rollers of one type under the same section have equal stiffness, computed once.
void resolve_contact_stiffness(Model& model) {
  std::map<std::tuple<int, double, double>, double> found;
  for (Roller& roller : model.supports.rollers) {
    if (roller.is_stiffness_given || roller.default_stiffness == RollerStiffness::penalty) continue;
    const SupportRow& row = model.supports.rows[static_cast<std::size_t>(roller.row)];
    const std::tuple key(model.section_at(row.from_top), roller.face, roller.structure_stiffness);
    const auto [entry, fresh] = found.try_emplace(key, 0.0);
    if (fresh) entry->second = model.contact_parts(roller).total();
    roller.stiffness = entry->second;
  }
}

}  // namespace

Mat3 vessel_axes(double heading, double trim, double heel) {
  Mat3 level;
  level.col(0) = azimuth_direction(heading);
  level.col(2) = Vec3::UnitZ();
  level.col(1) = level.col(2).cross(level.col(0));
  if (trim == 0.0 && heel == 0.0) {
    return level;
  }
  // Rotation about +y (port) lowers the bow, hence the sign of trim.
  return level * Eigen::AngleAxisd(-trim, Vec3::UnitY()).toRotationMatrix() *
         Eigen::AngleAxisd(heel, Vec3::UnitX()).toRotationMatrix();
}

Vec3 astern_direction(const VesselPose& pose) {
  const Vec3 forward = pose.R_WV.col(0);
  return -Vec3(forward.x(), forward.y(), 0.0).normalized();
}

Vec3 direction_from_ramp(const VesselPose& pose, const Vec3& d_S) {
  return pose.R_WV * turn_S_to_V(d_S);
}

Vec3 point_from_ramp(const Model& model, const VesselPose& pose, const Vec3& p_S) {
  const VesselDescription& vessel = model.description.vessel;
  const Vec3 shoe_V(vessel.stern_shoe_x, 0.0, vessel.stern_shoe_z);
  return pose.p_WV + pose.R_WV * (shoe_V + turn_S_to_V(p_S));
}

int Model::section_at(double distance_from_top) const {
  const auto inside = [&](const SectionSpan& s) { return distance_from_top >= s.from && distance_from_top < s.to; };
  const auto span = std::find_if(spans.begin(), spans.end(), inside);
  return span == spans.end() ? 0 : span->section;
}

const Section& Model::section_over(const Roller& roller) const {
  const SupportRow& row = supports.rows[static_cast<std::size_t>(roller.row)];
  return sections[static_cast<std::size_t>(section_at(row.from_top))];
}

const Section& Model::pipe_over(const Roller& roller) const {
  const Section& section = section_over(roller);
  return section.kind == SectionKind::cable ? sections.front() : section;
}

ContactStiffness Model::contact_parts(const Roller& roller) const {
  const SupportRow& row = supports.rows[static_cast<std::size_t>(roller.row)];
  const std::size_t section = static_cast<std::size_t>(section_at(row.from_top));
  return contact_stiffness(pipe_over(roller), find_section_description(section), roller.face,
                           roller.structure_stiffness);
}

const SectionDescription& Model::find_section_description(std::size_t section) const {
  require(section < sections.size(), "a section is one of the model's");
  return described[section];
}

SectionKind Model::kind_at(double distance_from_top) const {
  return sections[static_cast<std::size_t>(section_at(distance_from_top))].kind;
}

Model build_model(const Description& description) {
  Model model;
  model.description = description;
  model.water_weight_density = description.environment.water_weight_density;
  model.water_density = model.water_weight_density / kGravity;
  if (description.has_pipe) {
    resolve_sections(model);
    resolve_bending(model);
    resolve_joints(model);
    model.supports = place_supports(description, [&](double from_top) {
      const Section& section = model.sections[static_cast<std::size_t>(model.section_at(from_top))];
      return (section.kind == SectionKind::cable ? model.pipe_section() : section).outer_radius();
    });
    resolve_contact_stiffness(model);
    add_structures(model);  // rollers keep the pipe's stiffness when a structure passes
  }
  model.mean_pose.R_WV = vessel_axes(description.vessel.heading, description.vessel.trim, description.vessel.heel);
  model.nominal_pose = model.mean_pose;
  const SeabedDescription& bed = description.environment.seabed;
  model.seabed = {resolve_surface(description.environment, point_from_ramp(model, model.nominal_pose, Vec3::Zero()),
                                  astern_direction(model.nominal_pose),
                                  description.stage ? description.stage->ahead.value_or(0.0) : 0.0),
                  bed.stiffness, bed.friction_axial, bed.friction_lateral};
  model.current = resolve_current(description.environment.current);
  return model;
}

bool update_moment_curvature(Model& model, double tension) {
  constexpr double kTensionTolerance = 1e-3;  // relative change of tension; changes the plastic moment by 1e-6
  TensionerDescription& tensioner = model.description.tensioner;
  const auto by_wall = [](const SectionDescription& section) {
    const MaterialLaw law = section.steel.material.law;
    return law == MaterialLaw::ramberg_osgood || law == MaterialLaw::bilinear || law == MaterialLaw::stress_strain;
  };
  if (tensioner.tension || ranges::none_of(model.described, by_wall)) return false;
  if (std::abs(tension - tensioner.found) <= kTensionTolerance * std::abs(tension)) return false;
  tensioner.found = tension;
  const Model again = build_model(model.description);
  for (std::size_t i = 0; i < model.sections.size(); ++i) model.sections[i].bending = again.sections[i].bending;
  return true;
}

Model::Model() = default;
Model::Model(const Model&) = default;
Model::Model(Model&&) noexcept = default;
Model& Model::operator=(const Model&) = default;
Model& Model::operator=(Model&&) noexcept = default;
Model::~Model() = default;

}  // namespace overbend
