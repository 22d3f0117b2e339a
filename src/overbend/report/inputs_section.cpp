#include <fmt/format.h>

#include <array>

#include "base/constants.h"
#include "model/station.h"
#include "report/assumption_rank.h"
#include "report/listing.h"
#include "report/mooring_inputs.h"
#include "report/sea_words.h"
#include "report/sections.h"

namespace overbend {
namespace {

using html::fixed;

std::string pipe_table(const SectionDescription& pipe, const std::string& name) {
  Listing list("Pipe: " + name);
  list.add("Steel outside diameter", 1e3 * pipe.steel.outside_diameter, "mm")
      .add("Wall thickness", 1e3 * pipe.steel.wall_thickness, "mm")
      .add("Young's modulus", 1e-6 * pipe.steel.youngs_modulus, "MPa")
      .add("Poisson's ratio", pipe.steel.poissons_ratio, "")
      .add("Yield stress", 1e-6 * pipe.steel.yield_stress, "MPa")
      .add("Steel weight density", 1e-3 * pipe.steel.weight_density, "kN/m3");
  for (const CoatingDescription& coating : pipe.coatings) {
    list.add("Coating: " + coating.name,
             general(1e3 * coating.thickness) + " mm at " + general(1e-3 * coating.weight_density), "kN/m3");
  }
  if (pipe.joint) {
    list.add("Pipe joint, field joint", general(pipe.joint->length) + ", " + general(pipe.joint->field_joint), "m")
        .add("Field joint infill", 1e-3 * pipe.joint->infill_weight_density, "kN/m3");
  }
  list.add("Drag, normal and axial",
           general(pipe.hydrodynamics.drag_normal) + ", " + general(pipe.hydrodynamics.drag_axial));
  if (pipe.contents_weight_density != 0.0 || pipe.internal_pressure != 0.0) {
    list.add("Contents", 1e-3 * pipe.contents_weight_density, "kN/m3")
        .add("Internal pressure at the water level", 1e-6 * pipe.internal_pressure, "MPa");
  }
  return list.str();
}

std::string environment_table(const EnvironmentDescription& sea) {
  Listing list("Environment");
  list.add("Water depth at the stern shoe", sea.water_depth, "m")
      .add("Water weight density", 1e-3 * sea.water_weight_density, "kN/m3")
      .add("Seabed stiffness", 1e-3 * sea.seabed.stiffness, "kN/m2")
      .add("Seabed friction, axial and lateral",
           general(sea.seabed.friction_axial) + ", " + general(sea.seabed.friction_lateral));
  if (sea.seabed.slope != 0.0) {
    list.add("Seabed slope",
             fixed(sea.seabed.slope * kToDegrees, 2) + " deg, falling towards " +
                 fixed(sea.seabed.slope_towards * kToDegrees, 1),
             "deg");
  }
  for (const ProfilePoint& at : sea.seabed.profile) {
    list.add("Depth of the seabed " + general(at.x) + " m astern of the stern shoe", at.depth, "m");
  }
  if (!sea.seabed.bathymetry_file.empty()) list.add("Depths of the seabed", sea.seabed.bathymetry_file);
  for (const CurrentPoint& at : sea.current) {
    list.add("Current at " + general(at.depth) + " m, towards " + general(at.towards * kToDegrees) + " deg", at.speed,
             "m/s");
  }
  return list.str();
}

/// The vessel by itself.
Listing& add_vessel(Listing& list, const VesselDescription& vessel) {
  return list.add("Vessel", vessel.name)
      .add("Length, beam, depth", general(vessel.length) + ", " + general(vessel.beam) + ", " + general(vessel.depth),
           "m")
      .add("Draught", vessel.draught, "m")
      .add("Heading", vessel.heading * kToDegrees, "deg")
      .add("Trim, heel", general(vessel.trim * kToDegrees) + ", " + general(vessel.heel * kToDegrees), "deg");
}

/// Radius of a structure and, of boxes told as a row, how many there are and how far apart.
void add_arc(Listing& list, const std::string& name, const std::optional<double>& radius,
             const std::optional<BoxRowDescription>& row) {
  if (radius) {
    list.add(name + " radius", *radius, "m");
  }
  if (row) {
    list.add(name + " boxes, spacing along the arc", std::to_string(row->count) + ", " + general(row->spacing), "m");
  }
}

std::string vessel_table(const Description& model) {
  const VesselDescription& vessel = model.vessel;
  Listing list("Vessel and tensioner");
  add_vessel(list, vessel)
      .add("Stern shoe, x from midship and z", general(vessel.stern_shoe_x) + ", " + general(vessel.stern_shoe_z), "m")
      .add("Tensioner X, Z from the stern shoe", general(model.tensioner.x) + ", " + general(model.tensioner.z), "m")
      .add("Tensioner incline", model.tensioner.incline * kToDegrees, "deg")
      .add("Pipe in the tensioner", model.tensioner.guide == Guide::clamped ? "direction fixed" : "pinned");
  if (model.tensioner.tension) {
    list.add("Set tension", 1e-3 * *model.tensioner.tension, "kN");
  }
  add_arc(list, "Ramp", model.supports.ramp_radius, model.supports.ramp_row);
  add_arc(list, "Stinger", model.supports.stinger_radius, model.supports.stinger_row);
  if (!model.supports.setting.empty()) {
    list.add("Stinger setting", model.supports.setting);
  }
  return list.str();
}

std::string roller_kinds_table(const std::vector<RollerKindDescription>& kinds) {
  if (kinds.empty()) {
    return "";
  }
  Listing list("Rollers");
  for (const RollerKindDescription& kind : kinds) {
    list.add(kind.name + ": bottom radius, face", general(kind.bottom.radius) + ", " + general(kind.bottom.face), "m");
    if (kind.sides) {
      list.add(kind.name + ": side radius, face", general(kind.sides->radius) + ", " + general(kind.sides->face), "m")
          .add(kind.name + ": side angle, clearance",
               general(kind.sides->angle * kToDegrees) + " deg, " + general(kind.sides->clearance), "m");
    }
    if (kind.stiffness) {
      list.add(kind.name + ": stiffness", 1e-3 * *kind.stiffness, "kN/m");
    }
  }
  return list.str();
}

/// Numbers of the sea; its type is in the report's header.
void add_waves(Listing& list, const WavesDescription& waves, std::uint64_t seed) {
  if (waves.type == WaveType::none) {
    list.add("Waves", "none");
    return;
  }
  if (waves.type == WaveType::airy || waves.type == WaveType::stokes5) {
    list.add("Wave height", waves.height, "m").add("Wave period", waves.period, "s");
  } else {
    if (waves.hs > 0.0) list.add("Significant wave height", waves.hs, "m");
    if (waves.type != WaveType::user) list.add("Peak period", waves.tp, "s");
    list.add("Wave components, seed", fmt::format("{}, {}", waves.components, seed));
  }
  list.add("Waves from", waves.from * kToDegrees, "deg");
}

std::string dynamics_table(const Description& model, const DynamicResults& results) {
  const HydrodynamicsDescription& water = model.pipe.section.hydrodynamics;
  Listing list("Sea, motion and time");
  add_waves(list, model.environment.waves, results.seed);
  list.add("Vessel motion", motion_words(model.vessel))
      .add("Build-up, duration", general(results.build_up) + ", " + general(results.duration), "s")
      .add("Added mass, normal and axial", general(water.added_mass_normal) + ", " + general(water.added_mass_axial));
  if (model.dynamics) {
    if (model.dynamics->step) list.add("Fixed step", *model.dynamics->step, "s");
    if (model.dynamics->max_step) list.add("Maximum step", *model.dynamics->max_step, "s");
  }
  const TensionerDescription& tensioner = model.tensioner;
  if (tensioner.range_low && tensioner.range_high) {
    list.add("Operational range of tension",
             general(1e-3 * *tensioner.range_low) + " to " + general(1e-3 * *tensioner.range_high), "kN");
  }
  return list.str();
}

std::string derived_table(const StaticResults& results) {
  html::Table table("Derived section properties",
                    {{"Section", "", true},
                     {"EA", "kN"},
                     {"EI", "kN m2"},
                     {"Weight in air", "kN/m"},
                     {"Submerged", "kN/m"},
                     {"Steel area", "mm2"},
                     {"Second moment", "cm4"},
                     {"Outer diameter", "mm"},
                     {"Mass", "kg/m"}},
                    "plain");
  for (const DerivedSection& s : results.sections) {
    table.row({s.name, fixed(s.EA / 1e3, 0), fixed(s.EI / 1e3, 1), fixed(s.weight_in_air / 1e3, 6),
               fixed(s.weight_submerged / 1e3, 6), fixed(s.steel_area * 1e6, 1), fixed(s.second_moment * 1e8, 1),
               fixed(s.outer_diameter * 1e3, 1), fixed(s.mass, 2)});
  }
  return table.str();
}

}  // namespace

std::string inputs_section(const StaticResults& results, const std::optional<Description>& description,
                           const DynamicResults* dynamic) {
  std::string body;
  if (description) {
    body += "<div class=\"columns\">\n" + pipe_table(description->pipe.section, "the line");
    for (const SegmentDescription& segment : description->pipe.segments) {
      body += pipe_table(segment.section, segment.name + ", " + general(segment.length) + " m");
    }
    body += vessel_table(*description) + environment_table(description->environment) +
            roller_kinds_table(description->rollers) + hull_inputs(*description) +
            (dynamic != nullptr ? dynamics_table(*description, *dynamic) : "") + "</div>\n" +
            mooring_inputs(*description);
  }
  body += derived_table(results);
  return html::section("inputs", "Inputs", body);
}

std::string inputs_section(const Description& description) {
  std::string vessel;
  if (has_station(description)) {
    Listing list("Vessel");
    vessel = add_vessel(list, description.vessel).str() + hull_inputs(description);
  }
  return html::section("inputs", "Inputs",
                       "<div class=\"columns\">\n" + vessel + environment_table(description.environment) + "</div>\n" +
                           mooring_inputs(description) + line_inputs(description));
}

std::string assumptions_section(const std::vector<std::string>& assumptions) {
  constexpr std::array<const char*, 3> kHeads = {"Governing assumptions", "Settings of the model file",
                                                 "Other assumptions"};
  const std::array<std::vector<std::string>, 3> lists = ranked(assumptions);
  std::string body;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    if (!lists[i].empty()) body += "<h3>" + std::string(kHeads[i]) + "</h3>\n" + html::list(lists[i]);
  }
  return body.empty() ? "" : html::section("assumptions", "Assumptions", body);
}

}  // namespace overbend
