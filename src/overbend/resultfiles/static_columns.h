/// The columns of the tables of a static analysis. Each function hands every member of one row with its ResultField to
/// `visit`, so that what is written, read and checked cannot drift apart. Rows may be const (writing) or not
/// (reading).
#pragma once

#include "resultfiles/result_field.h"

namespace overbend {

template <class Row, class Visit>
void visit_station(Row& r, Visit& visit) {
  visit(ResultField{"s", "m", "Unstressed arc length from the anchor"}, r.s);
  visit(ResultField{"", "m", "Pipe axis", kWorldFrame}, r.p_W);
  visit(ResultField{"astern", "m", "Horizontal distance astern of the stern shoe along the vessel's axis"}, r.astern);
  visit(ResultField{"inclination", "rad", "Of the pipe from horizontal, positive dipping astern"}, r.inclination);
  visit(ResultField{"effective_tension", "N", "Effective tension"}, r.effective_tension);
  visit(ResultField{"wall_tension", "N", "True wall tension"}, r.wall_tension);
  visit(ResultField{"bending_moment", "N m", "Bending moment, magnitude"}, r.bending_moment);
  visit(ResultField{"vertical_moment", "N m", "Bending moment in the vertical plane of the pipe, sagging positive"},
        r.vertical_moment);
  visit(ResultField{"lateral_moment", "N m",
                    "Bending moment out of that plane, positive when curving to port going astern"},
        r.lateral_moment);
  visit(ResultField{"curvature", "1/m", "Curvature, magnitude"}, r.curvature);
  visit(ResultField{"residual_curvature", "1/m", "Curvature left without moment, of steel that has yielded; magnitude"},
        r.residual_curvature);
  visit(ResultField{"axial_stress", "Pa", "Axial stress from the wall tension"}, r.axial_stress);
  visit(ResultField{"bending_stress", "Pa", "Bending stress at the outer fibre of the steel"}, r.bending_stress);
  visit(ResultField{"hoop_stress", "Pa", "Hoop stress at the inner wall, tension positive"}, r.hoop_stress);
  visit(ResultField{"von_mises", "Pa", "Largest von Mises stress over the section"}, r.von_mises);
  visit(ResultField{"strain", "1", "Largest longitudinal strain magnitude at the outer fibre"}, r.strain);
  visit(ResultField{"seabed_reaction", "N/m", "Seabed reaction per length"}, r.seabed_reaction);
  visit(ResultField{"penetration", "m", "Penetration into the seabed"}, r.penetration);
  visit(ResultField{"yield_stress", "Pa", "Yield stress of the section at the station"}, r.yield_stress);
  visit(
      ResultField{"current_vertical_moment", "N m", "What the current adds to vertical_moment; 0 where not separated"},
      r.current_vertical_moment);
  visit(ResultField{"current_lateral_moment", "N m", "What the current adds to lateral_moment; 0 where not separated"},
        r.current_lateral_moment);
  visit(ResultField{"current_tension", "N", "What the current adds to effective_tension; 0 where not separated"},
        r.current_tension);
  visit(ResultField{"region", "1", "Part of the line: tower, overbend, sagbend or seabed"}, r.region);
}

template <class Row, class Visit>
void visit_support(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the roller box"}, r.name);
  visit(ResultField{"stinger", "1", "1 on the stinger, 0 on the ramp"}, r.stinger);
  visit(ResultField{"", "m", "Box point: where the underside of the pipe rests, at the middle", kWorldFrame}, r.p_W);
  visit(ResultField{"astern", "m", "Distance of the box point astern of the stern shoe"}, r.astern);
  visit(ResultField{"inclination", "rad", "Of the box axis from horizontal, positive dipping astern"}, r.inclination);
  visit(ResultField{"length", "m", "Length of the box"}, r.length);
  visit(ResultField{"s", "m", "Arc length of the pipe at the middle of the box"}, r.s);
  visit(ResultField{"reaction", "N", "Resultant of all rollers on the pipe, magnitude"}, r.reaction);
  visit(ResultField{"vertical", "N", "Vertical part of the resultant", kWorldFrame}, r.vertical);
  visit(ResultField{"longitudinal", "N", "Part of the resultant along the box axis, astern positive", kBoxFrame},
        r.longitudinal);
  visit(ResultField{"lateral", "N", "Part of the resultant across, port positive", kBoxFrame}, r.lateral);
  visit(ResultField{"separation", "m", "Smallest clear distance of its bottom rollers, daylight positive"},
        r.separation);
  visit(ResultField{"separation_lateral", "m", "Smallest clear distance of its side rollers; 0 without sides"},
        r.separation_lateral);
  visit(ResultField{"has_sides", "1", "1 with side rollers"}, r.has_sides);
  visit(ResultField{"effective_tension", "N", "Largest effective tension over the box"}, r.effective_tension);
  visit(ResultField{"bending_moment", "N m", "Largest bending moment over the box"}, r.bending_moment);
  visit(ResultField{"bending_stress", "Pa", "Largest bending stress over the box"}, r.bending_stress);
  visit(ResultField{"von_mises", "Pa", "Largest von Mises stress over the box"}, r.von_mises);
  visit(ResultField{"strain", "1", "Largest strain over the box"}, r.strain);
}

template <class Row, class Visit>
void visit_row(Row& r, Visit& visit) {
  visit(ResultField{"", "m", "Row point: where the underside of a centred pipe rests", kWorldFrame}, r.p_W);
  visit(ResultField{"s", "m", "Arc length of the pipe where it crosses the plane of the row; -1 if it does not"}, r.s);
  visit(ResultField{"reaction", "N", "Resultant of the row on the pipe, magnitude"}, r.reaction);
}

template <class Row, class Visit>
void visit_roller(Row& r, Visit& visit) {
  visit(ResultField{"position", "1", "Place in the row: bottom, port or starboard"}, r.position);
  visit(ResultField{"reaction", "N", "Normal contact force on the pipe"}, r.reaction);
  visit(ResultField{"vertical", "N", "Vertical part of the reaction", kWorldFrame}, r.vertical);
  visit(ResultField{"longitudinal", "N", "Part of the reaction along the box axis, astern positive", kBoxFrame},
        r.longitudinal);
  visit(ResultField{"lateral", "N", "Part of the reaction across, port positive", kBoxFrame}, r.lateral);
  visit(ResultField{"separation", "m", "Clear distance from pipe to roller: daylight positive, penetration negative"},
        r.separation);
  visit(ResultField{"off_end", "m", "How far the closest point lies beyond the face; 0 when on it"}, r.off_end);
  visit(ResultField{"line_load", "N/m", "Of the reaction on the coating; 0 without one"}, r.line_load);
  visit(ResultField{"", "m", "Reference point: middle of the face", kWorldFrame}, r.p_W);
  visit(ResultField{"normal", "1", "Unit normal of the face towards the pipe", kWorldFrame}, r.normal_W);
  visit(ResultField{"axis", "1", "Unit vector along the axis of the roller", kWorldFrame}, r.axis_W);
  visit(ResultField{"radius", "m", "Radius of the roller"}, r.radius);
  visit(ResultField{"face", "m", "Length of the face"}, r.face);
}

template <class Row, class Visit>
void visit_section(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the section"}, r.name);
  visit(ResultField{"EA", "N", "Axial stiffness"}, r.EA);
  visit(ResultField{"EI", "N m2", "Bending stiffness"}, r.EI);
  visit(ResultField{"weight_in_air", "N/m", "Weight in air per length"}, r.weight_in_air);
  visit(ResultField{"weight_submerged", "N/m", "Submerged weight per length"}, r.weight_submerged);
  visit(ResultField{"steel_area", "m2", "Cross-section of the steel"}, r.steel_area);
  visit(ResultField{"second_moment", "m4", "Second moment of area of the steel"}, r.second_moment);
  visit(ResultField{"outer_diameter", "m", "Diameter over the coatings"}, r.outer_diameter);
  visit(ResultField{"mass", "kg/m", "Mass per length"}, r.mass);
}

}  // namespace overbend
