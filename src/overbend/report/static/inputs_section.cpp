#include <fmt/format.h>

#include <array>
#include <utility>

#include "base/shown_unit.h"
#include "model/description/description_enum_names.h"
#include "model/site/wave_groups.h"
#include "model/vessel/mooring_queries.h"
#include "report/page/listing.h"
#include "report/page/quantity.h"
#include "report/page/sea_labels.h"
#include "report/page/sections.h"
#include "report/static/mooring_inputs.h"

namespace overbend {
namespace {

Table section_table(const SectionDescription& pipe, const std::string& name) {
  Listing list("Pipe: " + name);
  list.add("Steel outside diameter", pipe.steel.outside_diameter, section_length())
      .add("Wall thickness", pipe.steel.wall_thickness, section_length())
      .add("Young's modulus", pipe.steel.youngs_modulus, "Pa")
      .add("Poisson's ratio", pipe.steel.poissons_ratio, "")
      .add("Yield stress", pipe.steel.yield_stress, "Pa")
      .add("Steel weight density", pipe.steel.weight_density, "N/m3");
  for (const CoatingDescription& coating : pipe.coatings) {
    list.add("Coating: " + coating.name,
             fmt::format("{} {} at {}", general(coating.thickness, section_length()), section_length().name,
                         general(coating.weight_density, "N/m3")),
             shown_name("N/m3"));
  }
  if (pipe.joint) {
    list.add("Pipe joint, field joint", {pipe.joint->length, pipe.joint->field_joint}, "m")
        .add("Field joint infill", pipe.joint->infill_weight_density, "N/m3");
  }
  list.add("Drag, normal and axial",
           general(pipe.hydrodynamics.drag_normal) + ", " + general(pipe.hydrodynamics.drag_axial));
  if (pipe.contents_weight_density != 0.0 || pipe.internal_pressure != 0.0) {
    list.add("Contents", pipe.contents_weight_density, "N/m3")
        .add("Internal pressure at the water level", pipe.internal_pressure, "Pa");
  }
  return list.table();
}

/// The section of the line itself, then those of the segments.
Blocks pipe_tables(const Description& model) {
  if (!model.has_pipe) return {};
  Blocks tables = section_table(model.pipe.section, "the line");
  for (const SegmentDescription& segment : model.pipe.segments) {
    tables +=
        section_table(segment.section, segment.name + ", " + general(segment.length, "m") + " " + shown_name("m"));
  }
  return tables;
}

Table environment_table(const EnvironmentDescription& sea) {
  Listing list("Environment");
  list.add("Water depth at the stern shoe", sea.water_depth, "m")
      .add("Water weight density", sea.water_weight_density, "N/m3")
      .add("Seabed stiffness", sea.seabed.stiffness, "N/m2")
      .add("Seabed friction, axial and lateral",
           general(sea.seabed.friction_axial) + ", " + general(sea.seabed.friction_lateral));
  if (sea.seabed.slope != 0.0) {
    list.add("Seabed slope",
             shown_number(sea.seabed.slope, "rad", 2) + " deg, falling towards " +
                 shown_number(sea.seabed.slope_towards, "rad", 1),
             shown_name("rad"));
  }
  for (const ProfilePoint& point : sea.seabed.profile) {
    list.add("Depth of the seabed " + general(point.x, "m") + " " + shown_name("m") + " astern of the stern shoe",
             point.depth, "m");
  }
  if (!sea.seabed.bathymetry_file.empty()) list.add("Depths of the seabed", sea.seabed.bathymetry_file);
  for (const CurrentPoint& point : sea.current) {
    list.add("Current at " + general(point.depth, "m") + " " + shown_name("m") + ", towards " +
                 general(point.towards, "rad") + " deg",
             point.speed, "m/s");
  }
  return list.table();
}

/// Radius of a structure and, for generated boxes, their number and spacing.
void add_arc(Listing& list, const std::string& name, const std::optional<double>& radius,
             const std::optional<BoxRowDescription>& row) {
  if (radius) {
    list.add(name + " radius", *radius, "m");
  }
  if (row) {
    list.add(name + " boxes, spacing along the arc", std::to_string(row->count) + ", " + general(row->spacing, "m"),
             shown_name("m"));
  }
}

/// The lay vessel and its equipment.
void add_spread(Listing& list, const Description& model) {
  list.add("Stern shoe, x from midship and z", {model.vessel.stern_shoe_x, model.vessel.stern_shoe_z}, "m")
      .add("Tensioner X, Z from the stern shoe", {model.tensioner.x, model.tensioner.z}, "m")
      .add("Tensioner incline", model.tensioner.incline, "rad")
      .add("Pipe in the tensioner", model.tensioner.guide == Guide::clamped ? "direction fixed" : "pinned");
  if (model.tensioner.tension) {
    list.add("Set tension", *model.tensioner.tension, "N");
  }
  add_arc(list, "Ramp", model.supports.ramp_radius, model.supports.ramp_row);
  add_arc(list, "Stinger", model.supports.stinger_radius, model.supports.stinger_row);
  if (!model.supports.setting.empty()) {
    list.add("Stinger setting", model.supports.setting);
  }
}

Table vessel_table(const Description& model) {
  if (!has_vessel(model)) return {};
  const VesselDescription& vessel = model.vessel;
  Listing list(model.has_pipe ? "Vessel and tensioner" : "Vessel");
  list.add("Vessel", vessel.name)
      .add("Length, beam, depth", {vessel.length, vessel.beam, vessel.depth}, "m")
      .add("Draught", vessel.draught, "m")
      .add("Heading", vessel.heading, "rad")
      .add("Trim, heel", {vessel.trim, vessel.heel}, "rad");
  if (model.has_pipe) add_spread(list, model);
  return list.table();
}

Table roller_kinds_table(const std::vector<RollerKindDescription>& kinds) {
  Listing list("Rollers");
  for (const RollerKindDescription& kind : kinds) {
    list.add(kind.name + ": bottom radius, face", {kind.bottom.radius, kind.bottom.face}, "m");
    if (kind.sides) {
      list.add(kind.name + ": side radius, face", {kind.sides->radius, kind.sides->face}, "m")
          .add(kind.name + ": side angle, clearance",
               general(kind.sides->angle, "rad") + " deg, " + general(kind.sides->clearance, "m"), shown_name("m"));
    }
    if (kind.stiffness) {
      list.add(kind.name + ": stiffness", *kind.stiffness, "N/m");
    }
  }
  return list.table();
}

/// Parameters of a group of waves; its type is in the report's header. `group` is "" for the only one.
void add_group(Listing& list, const WavesDescription& waves, const std::string& group, std::uint64_t seed) {
  if (is_regular(waves.type)) {
    list.add(group + "Wave height", waves.height, "m").add(group + "Wave period", waves.period, "s");
  } else {
    if (waves.hs > 0.0) list.add(group + "Significant wave height", waves.hs, "m");
    if (waves.tp > 0.0 && waves.type != WaveType::user) list.add(group + "Peak period", waves.tp, "s");
    if (is_random(waves.type)) {
      list.add(group + "Wave components, seed", fmt::format("{}, {}", waves.components, seed));
    }
  }
  list.add(group + "Waves from", waves.from, "rad");
}

void add_waves(Listing& list, const WaveGroups& groups, std::uint64_t seed) {
  if (is_calm(groups)) {
    list.add("Waves", "none");
    return;
  }
  if (groups.size() > 1 && is_irregular(groups)) {
    list.add("Significant wave height of all waves", significant_height(groups), "m");
  }
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (groups[i].type == WaveType::none) continue;
    const std::string group = groups.size() == 1 ? "" : fmt::format("{}. {}: ", i + 1, enum_name(groups[i].type));
    add_group(list, groups[i], group, groups[i].seed + (seed - default_seed(groups)));
  }
}

Table dynamics_table(const Description& model, const DynamicResults& results) {
  const HydrodynamicsDescription& water = model.pipe.section.hydrodynamics;
  Listing list("Sea, motion and time");
  add_waves(list, model.environment.waves, results.seed);
  if (has_vessel(model)) list.add("Vessel motion", motion_label(model.vessel));
  list.add("Build-up, duration", {results.build_up, results.duration}, "s");
  if (model.has_pipe) {
    list.add("Added mass, normal and axial", general(water.added_mass_normal) + ", " + general(water.added_mass_axial));
  }
  if (model.dynamics) {
    if (model.dynamics->step) list.add("Fixed step", *model.dynamics->step, "s");
    if (model.dynamics->max_step) list.add("Maximum step", *model.dynamics->max_step, "s");
  }
  const TensionerDescription& tensioner = model.tensioner;
  if (tensioner.range_low && tensioner.range_high) {
    list.add("Operational range of tension",
             general(*tensioner.range_low, "N") + " to " + general(*tensioner.range_high, "N"), shown_name("N"));
  }
  return list.table();
}

Table derived_table(const StaticResults& results) {
  Table table{"Derived section properties",
              {TableColumn("Section"),
               {"EA", "N", 0},
               {"EI", "N m2", 1},
               {"Weight in air", "N/m", 6},
               {"Submerged", "N/m", 6},
               {"Steel area", steel_area(), 1},
               {"Second moment", steel_inertia(), 1},
               {"Outer diameter", section_length(), 1},
               {"Mass", "kg/m", 2}}};
  for (const DerivedSection& s : results.sections) {
    table.row({s.name, s.EA, s.EI, s.weight_in_air, s.weight_submerged, s.steel_area, s.second_moment, s.outer_diameter,
               s.mass});
  }
  return table;
}

}  // namespace

Blocks inputs_section(const StaticResults& results, const std::optional<Description>& description,
                      const DynamicResults* dynamic) {
  Blocks body;
  if (description) {
    Blocks listings = pipe_tables(*description) + vessel_table(*description) +
                      environment_table(description->environment) + roller_kinds_table(description->rollers) +
                      hull_inputs(*description);
    if (dynamic != nullptr) listings += dynamics_table(*description, *dynamic);
    body = block::columns(listings) + mooring_inputs(*description) + line_inputs(*description);
  }
  return block::section("inputs", "Inputs", body + derived_table(results));
}

Blocks assumptions_section(const Assumptions& assumptions) {
  constexpr std::array<std::pair<AssumptionRank, const char*>, 3> kHeads = {
      {{AssumptionRank::governing, "Governing assumptions"},
       {AssumptionRank::setting, "Settings of the model file"},
       {AssumptionRank::other, "Other assumptions"}}};
  Blocks body;
  for (const auto& [rank, head] : kHeads) {
    const std::vector<std::string> list = texts(assumptions, rank);
    if (!list.empty()) body += block::subheading(head) + block::list(list);
  }
  return block::section("assumptions", "Assumptions", body);
}

}  // namespace overbend
