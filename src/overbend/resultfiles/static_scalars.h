/// The single values of a static analysis with their Fields; see static_columns.h for the idea.
#pragma once

#include "resultfiles/result_field.h"

namespace overbend {

/// Key results: what stands directly in the group.
template <class Results, class Visit>
void visit_key_results(Results& r, Visit& visit) {
  visit(ResultField{"title", "1", "Title of the model"}, r.title);
  visit(ResultField{"version", "1", "Version of the program"}, r.version);
  visit(ResultField{"assumptions", "1", "What had to be assumed"}, r.assumptions);
  visit(ResultField{"warnings", "1", "Warnings on the model"}, r.warnings);
  visit(ResultField{"top_tension", "N", "Effective tension at the tensioner"}, r.top_tension);
  visit(ResultField{"bottom_tension", "N", "Horizontal tension at touchdown"}, r.bottom_tension);
  visit(ResultField{"residual_curvature", "1/m", "Of the pipe at touchdown, from yielding over the supports"},
        r.residual_curvature);
  visit(ResultField{"largest_tension", "N", "Largest effective tension"}, r.largest_tension);
  visit(ResultField{"departure_s", "m", "Arc length of the last support in contact; total length where none carries"},
        r.departure_s);
  visit(ResultField{"inflection_s", "m", "Arc length where the sagbend ends and overbend or tower begin"},
        r.inflection_s);
  visit(ResultField{"lay_back", "m", "Horizontal distance from stern shoe to touchdown"}, r.lay_back);
  visit(ResultField{"top_to_touchdown", "m", "Horizontal distance from tensioner to touchdown"}, r.top_to_touchdown);
  visit(ResultField{"length_top_to_touchdown", "m", "Unstressed length from tensioner to touchdown"},
        r.length_top_to_touchdown);
  visit(ResultField{"total_length", "m", "Unstressed length from tensioner to anchor"}, r.total_length);
  visit(ResultField{"suspended_length", "m", "Length from the last support in contact to touchdown"},
        r.suspended_length);
  visit(
      ResultField{"departure_angle", "rad", "From horizontal, at the last support in contact or the tensioner (J-lay)"},
      r.departure_angle);
  visit(ResultField{"stinger_tip_clearance", "m", "Separation at the last row of the stinger"},
        r.stinger_tip_clearance);
  visit(ResultField{"last_support", "1", "Name of the last support in contact; empty in J-lay"}, r.last_support);
  visit(ResultField{"largest_reaction_support", "1", "Support with the largest reaction of a single roller"},
        r.largest_reaction_support);
  visit(ResultField{"largest_reaction", "N", "Largest reaction of a single roller"}, r.largest_reaction);
  visit(ResultField{"smallest_separation", "m", "Smallest separation of all bottom rollers"}, r.smallest_separation);
  visit(ResultField{"largest_penetration", "m", "Largest penetration into a roller, by the penalty"},
        r.largest_penetration);
  visit(ResultField{"roller_stiffness", "N/m", "Largest contact stiffness in use"}, r.roller_stiffness);
  visit(ResultField{"anchor", "m", "Where the far end is held", kWorldFrame}, r.anchor_W);
  visit(ResultField{"wanted_tension", "N", "Tension asked for in the model"}, r.wanted_tension);
  visit(ResultField{"force_residual", "1", "Largest unbalanced nodal force over the total weight"}, r.force_residual);
  visit(ResultField{"global_residual", "1", "Sum of all external forces and reactions over the total weight"},
        r.global_residual);
  visit(ResultField{"total_weight", "N", "Weight of the line in air"}, r.total_weight);
}

template <class Row, class Visit>
void visit_touchdown(Row& r, Visit& visit) {
  visit(ResultField{"position", "m", "Touchdown point", kWorldFrame}, r.p_W);
  visit(ResultField{"s", "m", "Arc length from the anchor"}, r.s);
  visit(ResultField{"astern", "m", "Distance astern of the stern shoe"}, r.astern);
}

template <class Results, class Visit>
void visit_sums(Results& r, Visit& visit) {
  visit(ResultField{"weight", "N", "Sum of the weight", kWorldFrame}, r.sum_weight);
  visit(ResultField{"buoyancy", "N", "Sum of the buoyancy", kWorldFrame}, r.sum_buoyancy);
  visit(ResultField{"current", "N", "Sum of the current's forces", kWorldFrame}, r.sum_current);
  visit(ResultField{"seabed", "N", "Sum of the seabed reaction", kWorldFrame}, r.sum_seabed);
  visit(ResultField{"rollers", "N", "Sum of the roller reactions", kWorldFrame}, r.sum_rollers);
  visit(ResultField{"top_reaction", "N", "Force of the tensioner on the pipe", kWorldFrame}, r.top_reaction);
  visit(ResultField{"anchor_reaction", "N", "Force of the anchor on the pipe", kWorldFrame}, r.anchor_reaction);
}

template <class Report, class Visit>
void visit_solve(Report& r, Visit& visit) {
  visit(ResultField{"method", "1", "Method of solution"}, r.method);
  visit(ResultField{"iterations", "1", "Newton iterations of all stages"}, r.iterations);
  visit(ResultField{"relaxation_steps", "1", "Steps of dynamic relaxation"}, r.relaxation_steps);
  visit(ResultField{"force_residual", "1", "Largest unbalanced nodal force over the total weight"}, r.force_residual);
  visit(ResultField{"wall_time", "s", "Time inside the solver"}, r.wall_time);
  visit(ResultField{"history", "1", "One line per stage"}, r.history);
}

/// What pictures need.
template <class Results, class Visit>
void visit_scene(Results& r, Visit& visit) {
  visit(ResultField{"stern_shoe", "m", "Stern shoe", kWorldFrame}, r.stern_shoe_W);
  visit(ResultField{"tensioner", "m", "Pipe axis at the tensioner", kWorldFrame}, r.tensioner_W);
  visit(ResultField{"vessel_axes", "1", "Columns: vessel axes forward, port, up", kWorldFrame}, r.R_WV);
  visit(ResultField{"vessel_name", "1", "Name of the vessel"}, r.vessel_name);
  visit(ResultField{"vessel_length", "m", "Length of the vessel"}, r.vessel_length);
  visit(ResultField{"vessel_beam", "m", "Beam of the vessel"}, r.vessel_beam);
  visit(ResultField{"vessel_depth", "m", "Depth of the vessel's hull"}, r.vessel_depth);
  visit(ResultField{"vessel_draught", "m", "Draught of the vessel"}, r.vessel_draught);
  visit(ResultField{"water_depth", "m", "Water depth at the stern shoe"}, r.water_depth);
  visit(ResultField{"pipe_outer_diameter", "m", "Diameter over the coatings of the line's own section"},
        r.pipe_outer_diameter);
  visit(ResultField{"steel_outer_diameter", "m", "Diameter of the steel of the line's own section"},
        r.steel_outer_diameter);
}

/// The five extremes of a region: visit_extreme(name, units, description, extreme).
template <class RegionType, class VisitExtreme>
void visit_region(RegionType& r, VisitExtreme&& visit_extreme) {
  visit_extreme("bending_moment", "N m", "Largest bending moment", r.bending_moment);
  visit_extreme("bending_stress", "Pa", "Largest bending stress", r.bending_stress);
  visit_extreme("von_mises", "Pa", "Largest von Mises stress", r.von_mises);
  visit_extreme("strain", "1", "Largest strain", r.strain);
  visit_extreme("effective_tension", "N", "Largest effective tension", r.effective_tension);
}

inline constexpr const char* kSmallestTension = "Least effective tension along the line; below zero is compression";

template <class Row, class Visit>
void visit_extreme_fields(const char* units, const char* description, Row& r, Visit& visit) {
  visit(ResultField{"value", units, description}, r.value);
  visit(ResultField{"s", "m", "Arc length from the anchor where it stands"}, r.s);
  visit(ResultField{"position", "m", "Where it stands", kWorldFrame}, r.p_W);
  visit(ResultField{"astern", "m", "Distance astern of the stern shoe where it stands"}, r.astern);
}

}  // namespace overbend
