#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/ranges.h"
#include "base/shown_unit.h"
#include "model/description/operation_names.h"
#include "model/dynamic_assumptions.h"
#include "model/lay_stage.h"
#include "model/material_description.h"
#include "model/model.h"
#include "model/mooring_assumptions.h"
#include "model/pipe_attachments.h"
#include "model/stinger_assumptions.h"

namespace overbend {
namespace {

double degrees(double radians) {
  return radians * kToDegrees;
}

/// Ratios of coated-pipe to bare-pipe stiffness by section, as in "1.3" or "1.3 (segment 'thick': 1.2)".
std::string coated_stiffnesses(const PipeDescription& pipe) {
  const auto of = [](const SectionDescription& section) {
    return section.joint ? section.joint->coated_stiffness : 1.0;
  };
  const double main = of(pipe.section);
  std::string others;
  for (const SegmentDescription& segment : pipe.segments) {
    const double stiffness = of(segment.section);
    if (stiffness == main) continue;
    others += fmt::format("{}segment '{}': {:.3g}", others.empty() ? "" : ", ", segment.name, stiffness);
  }
  if (main <= 1.0 && others.empty()) return {};
  return fmt::format("{:.3g}{}", main, others.empty() ? "" : " (" + others + ")");
}

void assume_pipe(Assumptions& list, const Model& model) {
  const Section& pipe = model.pipe_section();
  const std::string stiff = coated_stiffnesses(model.description.pipe);
  list.push_back({AssumptionRank::governing,
                  stiff.empty() ? "EA and EI are those of the steel only; coatings add weight, not stiffness."
                                : fmt::format("EA is that of the steel only. EI is also that of the steel, except for "
                                              "the coated pipe between the field joints over the supports and three "
                                              "joints beyond, which is {} times as stiff; stress is that in the steel.",
                                              stiff)});
  list = merge(std::move(list), material_assumptions(model));
  if (model.description.pipe.section.joint) {
    list.push_back({AssumptionRank::other,
                    "Field-joint infill replaces the outermost coating over part of each pipe joint; weight is "
                    "averaged along the joint."});
  }
  if (pipe.contents_weight_density == 0.0 && pipe.internal_pressure == 0.0) {
    list.push_back({AssumptionRank::setting, "The pipe is empty, at atmospheric pressure."});
  }
  list.push_back(
      {AssumptionRank::setting,
       fmt::format(
           "The weight density of water is {}; external pressure is hydrostatic from the mean water level and acts on "
           "the outside of the steel: the coating is under pressure on all sides and carries no axial force.",
           shown_digits(model.water_weight_density, "N/m3", 4))});
}

const char* seabed_sentence(const Model& model) {
  const SeabedDescription& bed = model.description.environment.seabed;
  if (!bed.profile.empty()) {
    return "; the seabed is the monotone piecewise cubic through the points of its profile, level beyond its ends and "
           "across";
  }
  if (bed.bathymetry) {
    return bed.bathymetry->columns > 0
               ? "; the seabed is bicubic between the depths of its grid, level beyond its edges"
               : "; the seabed is bicubic on a grid of planes fitted to the scattered depths, level beyond its edges";
  }
  return bed.slope == 0.0 ? "; the seabed is horizontal" : "; the seabed is a sloping plane";
}

void assume_vessel(Assumptions& list, const Model& model) {
  const VesselDescription& vessel = model.description.vessel;
  if (model.description.has_pipe) {
    list.push_back(
        {AssumptionRank::setting,
         fmt::format(
             "The stern shoe, origin of ramp and stinger, is at x = {} from midship and {} above the mean water level.",
             shown(vessel.stern_shoe_x, "m", 3), shown(vessel.stern_shoe_z, "m", 3))});
  }
  if (vessel.trim == 0.0 && vessel.heel == 0.0) {
    list.push_back({AssumptionRank::setting, "The vessel floats on even keel, without static trim or heel."});
  } else {
    list.push_back({AssumptionRank::setting, fmt::format("The vessel is trimmed {:.2f} deg (bow up) and heeled {:.2f} "
                                                         "deg (starboard down) about midship at the water line.",
                                                         degrees(vessel.trim), degrees(vessel.heel))});
  }
  list.push_back(
      {AssumptionRank::setting,
       fmt::format("Water depth {} applies at {}{}.", shown(model.description.environment.water_depth, "m", 2),
                   model.description.has_pipe ? "the stern shoe" : "the vessel", seabed_sentence(model))});
}

void assume_motion(Assumptions& list, const Model& model) {
  const VesselDescription& vessel = model.description.vessel;
  if (!vessel.raos) return;
  const Vec3& p = vessel.raos->reference_V;
  list.push_back({AssumptionRank::governing,
                  fmt::format("The vessel moves by linear RAOs ({}) of the point {} forward of midship, {} to port and "
                              "{} above the water; the pipe does not act back on it.",
                              vessel.raos->source, shown(p.x(), "m", 3), shown(p.y(), "m", 3), shown(p.z(), "m", 3))});
  list.insert(list.end(), vessel.raos->assumptions.begin(), vessel.raos->assumptions.end());
}

std::string stiffness_label(double stiffness) {
  return stiffness > 0.0 ? shown_digits(stiffness, contact_stiffness_unit(), 3) : std::string("rigid");
}

/// Adds one sentence for each contact stiffness that the program chose.
void assume_contact_stiffness(Assumptions& list, const Model& model) {
  std::vector<double> reported;
  bool penalty = false;
  for (const Roller& roller : model.supports.rollers) {
    penalty = penalty || roller.stiffness == 0.0;
    // the contact stiffness is that of the pipe
    if (model.section_over(roller).kind == SectionKind::structure) continue;
    if (roller.is_stiffness_given || roller.stiffness == 0.0 ||
        std::find(reported.begin(), reported.end(), roller.stiffness) != reported.end()) {
      continue;
    }
    reported.push_back(roller.stiffness);
    const ContactStiffness parts = model.contact_parts(roller);
    list.push_back({AssumptionRank::governing,
                    fmt::format("Contact of '{}' with a roller of {} face and no given stiffness: {}, from pipe shell "
                                "{} (Morley's equation, load on a line across the pipe), coating {} and roller "
                                "structure {} in series. Impact forces are roughly proportional to its cube root.",
                                model.section_over(roller).name, shown_digits(roller.face, "m", 3),
                                shown_digits(parts.total(), contact_stiffness_unit(), 3), stiffness_label(parts.shell),
                                stiffness_label(parts.coating), stiffness_label(parts.structure))});
  }
  if (penalty) {
    list.push_back({AssumptionRank::other,
                    "Contact with rollers of default_stiffness: penalty has the bending stiffness of a piece of pipe "
                    "as long as it is thick, EI/D^3; the largest penetration is reported."});
  }
}

void assume_structures(Assumptions& list, const Model& model) {
  for (const Section& section : model.sections) {
    if (section.kind != SectionKind::structure) continue;
    list.push_back(
        {AssumptionRank::other,
         fmt::format(
             "'{}' is a length of the line with uniform stiffness, weight and diameter and linear steel; its own "
             "stresses are not checked. Rollers keep the positions and the contact stiffness that belong to the pipe.",
             section.name)});
  }
}

void assume_attachments(Assumptions& list, const Description& description) {
  const std::vector<PipeAttachment> attached = pipe_attachments(description);
  if (ranges::any_of(attached, [](const PipeAttachment& attachment) { return attachment.point != nullptr; })) {
    list.push_back({AssumptionRank::other,
                    "Clumps and buoys act at points of the pipe's axis; the out-of-water fraction of a buoy is that of "
                    "a sphere about the axis. They pass the rollers without contact."});
  }
  if (ranges::any_of(attached, [](const PipeAttachment& attachment) { return attachment.line != nullptr; })) {
    list.push_back({AssumptionRank::other,
                    "Lines on the pipe are hinged to its axis and carry no compression: straight wires, or elastic "
                    "catenaries if they have weight; they have no drag and no contact with the seabed."});
  }
}

void assume_gap_springs(Assumptions& list, const Model& model) {
  list.push_back({AssumptionRank::governing,
                  "Each roller box is one gap spring at its middle instead of its rollers, as in traditional models: "
                  "it supports the pipe at the box's point, without damping and friction."});
  const auto is_side = [](const Roller& roller) { return roller.position != RollerPosition::bottom; };
  if (std::any_of(model.supports.rollers.begin(), model.supports.rollers.end(), is_side)) {
    list.push_back(
        {AssumptionRank::other,
         "On either side a gap spring acts laterally once the pipe has moved by the clearance of the side rollers."});
  }
  assume_contact_stiffness(list, model);
}

void assume_supports(Assumptions& list, const Model& model) {
  if (model.supports.boxes.empty()) {
    list.push_back({AssumptionRank::other, "No supports: the pipe hangs directly from the tensioner (J-lay)."});
    return;
  }
  list.push_back({AssumptionRank::other,
                  "The X, Z of a roller box is the point where the underside of the coated pipe rests; the X, Z of the "
                  "tensioner is the pipe's axis."});
  list.push_back({AssumptionRank::other,
                  "A box without a given inclination is aligned with the tangent of the circle through its point and "
                  "those of its neighbours."});
  if (model.description.supports.contact == SupportContact::gap_springs) {
    assume_gap_springs(list, model);
    return;
  }
  const RollerFriction friction = model.description.statics.roller_friction;
  if (friction == RollerFriction::none) {
    list.push_back({AssumptionRank::governing,
                    "Rollers are rigid cylinders of finite length; in statics they are frictionless: the pipe moves "
                    "over them during laying and friction has no permanent direction."});
  } else {
    list.push_back({AssumptionRank::other, fmt::format("Rollers are rigid cylinders of finite length; in statics full "
                                                       "friction acts along the pipe, opposing its motion as it is {}.",
                                                       friction == RollerFriction::lay ? "paid out" : "hauled in")});
  }
  assume_contact_stiffness(list, model);
}

void assume_axial_friction(Assumptions& list, const Model& model) {
  const Description& d = model.description;
  if (!is_dragged(d)) {
    list.push_back({AssumptionRank::governing,
                    "The laid pipe rests under the lay tension: axial friction is not mobilised in statics."});
    return;
  }
  const double axial = model.seabed.friction_axial;
  list.push_back(
      {AssumptionRank::governing,
       fmt::format("Friction of the seabed acts fully against the motion, {} the vessel, along pipe, head and "
                   "cable: {:.3g} of the normal force under pipe and head, {:.3g} under the cable.",
                   dragging_direction(d) > 0.0 ? "away from" : "towards", axial,
                   d.operation.lay.cable->friction.value_or(axial))});
}

void assume_seabed(Assumptions& list, const Model& model) {
  list.push_back({AssumptionRank::setting,
                  fmt::format("The seabed stiffness is {} per {} of pipe and penetration, without adhesion.",
                              shown_digits(model.seabed.stiffness, bed_stiffness_unit(), 4),
                              units_in_use() == UnitSystem::us ? "foot" : "metre")});
  if (model.description.environment.seabed.soil != SoilModel::linear) {
    list.push_back(
        {AssumptionRank::other,
         fmt::format("The soil softens {} {} (environment.seabed.soil) and follows one curve down and up: no trench, "
                     "no suction.",
                     model.description.environment.seabed.soil == SoilModel::hyperbolic
                         ? "along a hyperbola towards"
                         : "to a tenth of its stiffness at",
                     shown_digits(model.description.environment.seabed.bearing_force.value_or(0.0), "N/m", 4))});
  }
  assume_axial_friction(list, model);
  if (model.seabed.friction_lateral > 0.0) {
    list.push_back({AssumptionRank::other,
                    "Lateral friction resists displacement from the lay route: elastic with the stiffness of the "
                    "seabed, up to the friction coefficient times the normal force."});
    list.push_back(
        {AssumptionRank::other,
         model.description.statics.laying == SeabedLayHistory::steady
             ? "Steady laying: the pipe on the seabed lies parallel to the lay route, offset by the lateral offset of "
               "its touchdown point, and stays there; the side load of a current is carried by the supports."
             : "The pipe was first laid straight on the lay route and then pulled sideways by the side load."});
  }
  list.push_back({AssumptionRank::other,
                  model.description.route.given()
                      ? "The lay route bends in plan as given; the barge is aligned with its first part, and the pipe "
                        "was laid along it under the bottom tension of this state."
                      : "The lay route is the vertical plane through the tensioner along the vessel's axis."});
}

void assume_tensioner(Assumptions& list, const Model& model) {
  const TensionerDescription& tensioner = model.description.tensioner;
  if (tensioner.tension) {
    list.push_back({AssumptionRank::setting, fmt::format("The tension of {} is the effective tension at the tensioner.",
                                                         shown_digits(*tensioner.tension, "N", 4))});
  }
  if (tensioner.guide == Guide::clamped) {
    list.push_back({AssumptionRank::setting,
                    fmt::format("The tensioner holds the pipe's direction, {:.2f} deg below horizontal astern.",
                                degrees(tensioner.incline) + 0.0)});
  } else {
    list.push_back({AssumptionRank::other, "The pipe is free to rotate at the tensioner."});
  }
}

/// Adds the operation stage of the model and the properties of its cable.
void assume_stage(Assumptions& list, const Description& d) {
  if (!d.stage) return;
  list.push_back({AssumptionRank::other, "The model is at " + stage_label(*d.stage, d.operation.type) + "."});
  if (!cable_at_top(d) && !cable_at_far_end(d)) return;
  list.push_back({AssumptionRank::other,
                  "The cable has no bending stiffness and is hinged to the head; the head's weight is spread evenly "
                  "over its length."});
}

}  // namespace

Assumptions assumptions(const Model& model) {
  Assumptions list;
  if (!model.description.has_pipe) {
    const bool vessel = model.description.moorings || model.description.vessel.coupled;
    if (vessel) assume_vessel(list, model);
    assume_floating(list, model);
    return list;
  }
  assume_pipe(list, model);
  assume_vessel(list, model);
  assume_motion(list, model);
  assume_floating(list, model);
  assume_tensioner(list, model);
  assume_stage(list, model.description);
  assume_structures(list, model);
  assume_attachments(list, model.description);
  assume_supports(list, model);
  assume_stinger(list, model);
  assume_seabed(list, model);
  if (!model.current.z.empty()) {
    list.push_back(
        {AssumptionRank::setting,
         "The current is steady; drag is from Morison's equation with normal and axial coefficients on the outermost "
         "diameter; the velocity vector is interpolated between the rows of the table and constant beyond its ends."});
  }
  if (model.description.dynamics) {
    assume_dynamics(list, model);
  }
  return list;
}

}  // namespace overbend
