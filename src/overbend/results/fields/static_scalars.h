/// Single values of a static analysis; see result_field.h.
#pragma once

#include "results/fields/result_field.h"

namespace overbend {

/// Values of the run, at the top level of summary.json.
template <class Results, class Visit>
void visit_heading(Results& r, Visit& visit) {
  visit(ResultField{"title", "1", "Title of the model"}.summary(), r.title);
  visit(ResultField{"version", "1", "Version of the program"}.summary(), r.version);
  visit(ResultField{"assumptions", "1", "Assumptions"}.summary(), r.assumptions);
  visit(ResultField{"findings", "1", "Findings"}.summary().page(), r.findings);
}

/// Position and tension of the line.
template <class Results, class Visit>
void visit_lay(Results& r, Visit& visit) {
  visit(ResultField{"top_tension", "N", "Effective tension at the tensioner"}.summary().page(), r.top_tension);
  visit(ResultField{"bottom_tension", "N", "Horizontal tension at touchdown"}.summary().page(), r.bottom_tension);
  visit(ResultField{"residual_curvature", "1/m", "Residual curvature at touchdown, from yielding over the supports"}
            .summary(),
        r.residual_curvature);
  visit(ResultField{"largest_tension", "N", "Largest effective tension"}.summary(), r.max_tension);
  visit(ResultField{"departure_s", "m", "Arc length of the last support in contact; total length without contact"},
        r.departure_s);
  visit(ResultField{"inflection_s", "m", "Arc length of the boundary between sagbend and overbend or tower"},
        r.inflection_s);
  visit(ResultField{"wanted_tension", "N", "Set tension of the model"}.summary(), r.wanted_tension);
  visit(ResultField{"lay_back", "m", "Horizontal distance from stern shoe to touchdown"}.summary().page(), r.lay_back);
  visit(ResultField{"suspended_length", "m", "Length from the last support in contact to touchdown"}.summary().page(),
        r.suspended_length);
  visit(ResultField{"departure_angle", "rad",
                    "Departure angle from horizontal, at the last support in contact or "
                    "the tensioner (J-lay)"}
            .summary()
            .page(),
        r.departure_angle);
  visit(ResultField{"top_inclination", "rad",
                    "Inclination of the pipe at the tensioner from horizontal, positive "
                    "dipping astern"}
            .summary(),
        r.top_inclination);
  visit(ResultField{"anchor", "m", "Position of the anchor", kWorldFrame}.summary().report(), r.anchor_W);
  visit(ResultField{"top_to_touchdown", "m", "Horizontal distance from tensioner to touchdown"}.summary(),
        r.top_to_touchdown);
  visit(ResultField{"length_top_to_touchdown", "m", "Unstressed length from tensioner to touchdown"}.summary(),
        r.length_top_to_touchdown);
  visit(ResultField{"total_length", "m", "Unstressed length from tensioner to anchor"}.summary(), r.total_length);
  visit(ResultField{"stinger_tip_clearance", "m", "Separation at the last row of the stinger"}.summary().page(),
        r.stinger_tip_clearance);
  visit(ResultField{"ramp_fitted_radius", "m",
                    "Radius of the circle fitted to x and z of the ramp's boxes, without offsets, by least squares "
                    "of their distances from it"}
            .summary()
            .page(),
        r.ramp_fitted_radius);
  visit(ResultField{"stinger_fitted_radius", "m", "The same for the stinger's boxes, with the angles of its sections"}
            .summary()
            .page(),
        r.stinger_fitted_radius);
  visit(ResultField{"last_support", "1", "Name of the last support in contact; empty in J-lay"}.summary().report(),
        r.last_support);
}

/// Extremes of the contacts with rollers.
template <class Results, class Visit>
void visit_contacts(Results& r, Visit& visit) {
  visit(ResultField{"largest_reaction", "N", "Largest reaction of a single roller"}
            .summary("largest_reaction/value")
            .page(),
        r.max_reaction);
  visit(ResultField{"largest_reaction_support", "1", "Support with the largest reaction of a single roller"}.summary(
            "largest_reaction/support"),
        r.max_reaction_support);
  visit(ResultField{"smallest_separation", "m", "Smallest separation of all bottom rollers"}.summary(),
        r.min_bottom_separation);
  visit(ResultField{"largest_penetration", "m", "Maximum penetration into a roller, from the contact stiffness"}
            .summary(),
        r.max_penetration);
  visit(ResultField{"roller_stiffness", "N/m", "Largest contact stiffness in use"}.summary(), r.roller_stiffness);
}

template <class Results, class Visit>
void visit_balance(Results& r, Visit& visit) {
  visit(ResultField{"force_residual", "1", "Largest unbalanced nodal force divided by the total weight"}.summary(
            "balance/force_residual"),
        r.force_residual);
  visit(ResultField{"global_residual", "1", "Sum of all external forces and reactions divided by the total weight"}
            .summary("balance/global"),
        r.global_residual);
  visit(ResultField{"total_weight", "N", "Weight of the line in air"}, r.total_weight);
}

/// Key results: values in the group itself.
template <class Results, class Visit>
void visit_key_results(Results& r, Visit& visit) {
  visit_heading(r, visit);
  visit_lay(r, visit);
  visit_contacts(r, visit);
  visit_balance(r, visit);
}

template <class Row, class Visit>
void visit_touchdown(Row& r, Visit& visit) {
  visit(ResultField{"position", "m", "Touchdown point", kWorldFrame}.summary(kComponents).page("place").report("p"),
        r.p_W);
  visit(ResultField{"s", "m", "Arc length from the anchor"}.along().summary().page().report(), r.s);
  visit(ResultField{"astern", "m", "Distance astern of the stern shoe"}.summary(), r.astern);
}

template <class Results, class Visit>
void visit_sums(Results& r, Visit& visit) {
  visit(ResultField{"weight", "N", "Sum of the weight", kWorldFrame}, r.sum_weight);
  visit(ResultField{"buoyancy", "N", "Sum of the buoyancy", kWorldFrame}, r.sum_buoyancy);
  visit(ResultField{"current", "N", "Sum of the current's forces", kWorldFrame}, r.sum_current);
  visit(ResultField{"seabed", "N", "Sum of the seabed reaction", kWorldFrame}, r.sum_seabed);
  visit(ResultField{"rollers", "N", "Sum of the roller reactions", kWorldFrame}, r.sum_rollers);
  if (!r.points.empty() || !r.wires.empty()) {
    visit(ResultField{"attached", "N", "Sum of the forces of clumps, buoys and wires", kWorldFrame}, r.sum_attached);
  }
  visit(ResultField{"top_reaction", "N", "Force of the tensioner on the pipe", kWorldFrame}, r.top_reaction);
  visit(ResultField{"anchor_reaction", "N", "Force of the anchor on the pipe", kWorldFrame}, r.anchor_reaction);
}

template <class Report, class Visit>
void visit_solve(Report& r, Visit& visit) {
  visit(ResultField{"iterations", "1", "Newton iterations of all stages"}.summary(), r.iterations);
  visit(ResultField{"relaxation_steps", "1", "Steps of dynamic relaxation"}.summary(), r.relaxation_steps);
  visit(ResultField{"force_residual", "1", "Largest unbalanced nodal force divided by the total weight"},
        r.force_residual);
  visit(ResultField{"wall_time", "s", "Wall time of the solver"}.summary(), r.wall_time);
  visit(ResultField{"method", "1", "Method of solution"}.summary(), r.method);
  visit(ResultField{"history", "1", "One line per stage"}.summary(), r.history);
}

/// Data for figures.
template <class Results, class Visit>
void visit_scene(Results& r, Visit& visit) {
  visit(ResultField{"stern_shoe", "m", "Stern shoe", kWorldFrame}.report(), r.stern_shoe_W);
  visit(ResultField{"tensioner", "m", "Pipe axis at the tensioner", kWorldFrame}.report(), r.tensioner_W);
  visit(ResultField{"vessel_axes", "1", "Columns: vessel axes forward, port, up", kWorldFrame}.report("vessel/axes"),
        r.R_WV);
  visit(ResultField{"vessel_name", "1", "Name of the vessel"}.report("vessel/name"), r.vessel_name);
  visit(ResultField{"vessel_length", "m", "Length of the vessel"}.report("vessel/length"), r.vessel_length);
  visit(ResultField{"vessel_beam", "m", "Beam of the vessel"}.report("vessel/beam"), r.vessel_beam);
  visit(ResultField{"vessel_depth", "m", "Depth of the vessel's hull"}.report("vessel/depth"), r.vessel_depth);
  visit(ResultField{"vessel_draught", "m", "Draught of the vessel"}.report("vessel/draught"), r.vessel_draught);
  visit(ResultField{"water_depth", "m", "Water depth at the stern shoe"}.report(), r.water_depth);
  visit(ResultField{"pipe_outer_diameter", "m", "Diameter over the coatings, main section"}.report(),
        r.pipe_outer_diameter);
  visit(ResultField{"steel_outer_diameter", "m", "Diameter of the steel, main section"}.report(),
        r.steel_outer_diameter);
}

/// The five extremes of a region: visit_extreme(field, extreme).
template <class RegionType, class VisitExtreme>
void visit_region(RegionType& r, VisitExtreme&& visit_extreme) {
  visit_extreme(ResultField{"effective_tension", "N", "Largest effective tension"}
                    .summary("max_effective_tension")
                    .at("at_effective_tension")
                    .report(),
                r.effective_tension);
  visit_extreme(ResultField{"bending_moment", "N m", "Largest bending moment"}
                    .summary("max_bending_moment")
                    .at("at")
                    .page()
                    .report(),
                r.bending_moment);
  visit_extreme(ResultField{"bending_stress", "Pa", "Largest bending stress"}
                    .summary("max_bending_stress")
                    .at("at_bending_stress")
                    .page()
                    .report(),
                r.bending_stress);
  visit_extreme(ResultField{"strain", "1", "Largest strain"}.summary("max_strain").at("at_strain").page().report(),
                r.strain);
  visit_extreme(ResultField{"von_mises", "Pa", "Largest von Mises stress"}
                    .summary("max_von_mises")
                    .at("at_von_mises")
                    .page()
                    .report(),
                r.von_mises);
}

/// The extreme of the whole line.
inline ResultField min_effective_tension_field() {
  return ResultField{"smallest_tension", "N",
                     "Minimum effective tension along the line; negative values are compression"}
      .summary()
      .at("at");
}

/// Position of an extreme.
template <class Row, class Visit>
void visit_place_of_extreme(Row& r, Visit& visit) {
  visit(ResultField{"s", "m", "Arc length of the extreme from the anchor"}.along().summary().page().report(), r.s);
  visit(ResultField{"position", "m", "Position of the extreme", kWorldFrame}.summary(kComponents).report("p"), r.p_W);
  visit(ResultField{"astern", "m", "Distance of the extreme astern of the stern shoe"}.summary(), r.astern);
}

/// `of`: the field of the extreme, from visit_region.
template <class Row, class Visit>
void visit_extreme_fields(const ResultField& of, Row& r, Visit& visit) {
  visit(ResultField{"value", of.units, of.description}.summary().report(), r.value);
  visit_place_of_extreme(r, visit);
}

}  // namespace overbend
