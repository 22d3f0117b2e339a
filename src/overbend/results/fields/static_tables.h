/// Fields of the tables of a static analysis; see result_field.h. Their order is that of the text tables.
#pragma once

#include <limits>

#include "results/fields/result_field.h"

namespace overbend {

template <class Row, class Visit>
void visit_station(Row& r, Visit& visit) {
  visit(ResultField{"s", "m", "Unstressed arc length from the anchor"}.csv("s").along().page().report(), r.s);
  visit(ResultField{"", "m", "Pipe axis", kWorldFrame}.csv(kComponents).page(kComponents).report(kComponents), r.p_W);
  visit(ResultField{"effective_tension", "N", "Effective tension"}.csv("tension").page().report(), r.effective_tension);
  visit(ResultField{"bending_moment", "N m", "Bending moment, magnitude"}.csv("bending moment").page().report(),
        r.bending_moment);
  visit(ResultField{"curvature", "1/m", "Curvature, magnitude"}.csv("curvature"), r.curvature);
  visit(ResultField{"axial_stress", "Pa", "Axial stress from the wall tension"}.csv("axial stress"), r.axial_stress);
  visit(ResultField{"bending_stress", "Pa", "Bending stress at the outer fibre of the steel"}
            .csv("bending stress")
            .page()
            .report(),
        r.bending_stress);
  visit(ResultField{"hoop_stress", "Pa", "Hoop stress at the inner wall, tension positive"}.csv("hoop stress"),
        r.hoop_stress);
  visit(ResultField{"von_mises", "Pa", "Largest von Mises stress over the section"}
            .csv("von Mises stress")
            .page()
            .report(),
        r.von_mises);
  visit(ResultField{"strain", "1", "Largest longitudinal strain magnitude at the outer fibre"}
            .csv("strain")
            .page()
            .report(),
        r.strain);
  visit(
      ResultField{"astern", "m", "Horizontal distance astern of the stern shoe along the vessel's axis"}.csv("astern"),
      r.astern);
  visit(ResultField{"inclination", "rad", "Inclination of the pipe from horizontal, positive dipping astern"}.csv(
            "inclination"),
        r.inclination);
  visit(ResultField{"wall_tension", "N", "True wall tension"}.csv("wall tension").report(), r.wall_tension);
  visit(ResultField{"vertical_moment", "N m", "Bending moment in the vertical plane of the pipe, sagging positive"}
            .csv("vertical moment")
            .report(),
        r.vertical_moment);
  visit(ResultField{"lateral_moment", "N m",
                    "Bending moment out of that plane, positive when curving to port going astern"}
            .csv("lateral moment")
            .report(),
        r.lateral_moment);
  visit(ResultField{"seabed_reaction", "N/m", "Seabed reaction per length"}.csv("seabed reaction"), r.seabed_reaction);
  visit(ResultField{"penetration", "m", "Penetration into the seabed"}.csv("penetration"), r.penetration);
  visit(ResultField{"residual_curvature", "1/m", "Residual curvature at zero moment, of yielded steel; magnitude"}.csv(
            "residual curvature"),
        r.residual_curvature);
  visit(ResultField{"region", "1", "Part of the line: tower, overbend, sagbend or seabed"}.csv("region"), r.region);
  visit(ResultField{"yield_stress", "Pa", "Yield stress of the section at the station"}.report(), r.yield_stress);
  visit(ResultField{"current_vertical_moment", "N m",
                    "Contribution of the current to vertical_moment; 0 where not separated"},
        r.current_vertical_moment);
  visit(ResultField{"current_lateral_moment", "N m",
                    "Contribution of the current to lateral_moment; 0 where not separated"},
        r.current_lateral_moment);
  visit(ResultField{"current_tension", "N", "Contribution of the current to effective_tension; 0 where not separated"},
        r.current_tension);
}

/// Fields derived from an arc length from the anchor, for a line that ends at the tensioner at `top` [m].
template <class Visit>
void visit_from_tensioner(double top, double s, Visit& visit) {
  const double from = s < 0.0 ? std::numeric_limits<double>::quiet_NaN() : top - s;  // NaN without an arc length
  visit(ResultField{"from_top", "m", "Distance along the pipe from the tensioner"}.csv("from tensioner"), from);
}

template <class Row, class Visit>
void visit_support(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the roller box"}.csv("name").summary().page().report(), r.name);
  visit(ResultField{"stinger", "1", "1 on the stinger, 0 on the ramp"}.report(), r.stinger);
  visit(ResultField{"", "m", "Box point: where the underside of the pipe rests, at the middle", kWorldFrame}
            .page("place")
            .report("p"),
        r.p_W);
  visit(ResultField{"astern", "m", "Distance of the box point astern of the stern shoe"}.summary(), r.astern);
  visit(ResultField{"inclination", "rad", "Inclination of the box axis from horizontal, positive dipping astern"}
            .report(),
        r.inclination);
  visit(ResultField{"length", "m", "Length of the box"}.report(), r.length);
  visit(ResultField{"s", "m", "Arc length of the pipe at the middle of the box"}.along().summary().page().report(),
        r.s);
  visit(ResultField{"reaction", "N", "Resultant of all rollers on the pipe, magnitude"}.summary().page().report(),
        r.reaction);
  visit(ResultField{"vertical", "N", "Vertical part of the resultant", kWorldFrame}.summary(), r.vertical);
  visit(ResultField{"longitudinal", "N", "Part of the resultant along the box axis, astern positive", kBoxFrame}
            .summary(),
        r.longitudinal);
  visit(ResultField{"lateral", "N", "Part of the resultant across, port positive", kBoxFrame}.summary(), r.lateral);
  visit(ResultField{"separation", "m", "Smallest clear distance of its bottom rollers, positive if clear"}
            .summary()
            .page()
            .report(),
        r.separation);
  visit(
      ResultField{"separation_lateral", "m", "Smallest clear distance of its side rollers; 0 without sides"}.summary(),
      r.separation_lateral);
  visit(ResultField{"has_sides", "1", "1 with side rollers"}, r.has_sides);
  visit(
      ResultField{"effective_tension", "N", "Largest effective tension over the box"}.summary("max_effective_tension"),
      r.effective_tension);
  visit(ResultField{"bending_moment", "N m", "Largest bending moment over the box"}.summary("max_bending_moment"),
        r.bending_moment);
  visit(ResultField{"bending_stress", "Pa", "Largest bending stress over the box"}.summary("max_bending_stress"),
        r.bending_stress);
  visit(ResultField{"von_mises", "Pa", "Largest von Mises stress over the box"}.summary("max_von_mises"), r.von_mises);
  visit(ResultField{"strain", "1", "Largest strain over the box"}.summary("max_strain"), r.strain);
}

template <class Row, class Visit>
void visit_row(Row& r, Visit& visit) {
  visit(ResultField{"", "m", "Row point: where the underside of a centred pipe rests", kWorldFrame}.report("p"), r.p_W);
  visit(ResultField{"s", "m", "Arc length of the pipe where it crosses the plane of the row; -1 if it does not"}
            .along()
            .csv("pipe s"),
        r.s);
  visit(ResultField{"reaction", "N", "Resultant of the row on the pipe, magnitude"}.report(), r.reaction);
}

template <class Row, class Visit>
void visit_roller(Row& r, Visit& visit) {
  visit(ResultField{"position", "1", "Position in the row: bottom, port or starboard"}.csv("position").page().report(),
        r.position);
  visit(
      ResultField{"reaction", "N", "Normal contact force on the pipe"}.csv("reaction normal").summary().page().report(),
      r.reaction);
  visit(ResultField{"vertical", "N", "Vertical part of the reaction", kWorldFrame}.csv("reaction vertical"),
        r.vertical);
  visit(ResultField{"longitudinal", "N", "Part of the reaction along the box axis, astern positive", kBoxFrame}.csv(
            "reaction longitudinal"),
        r.longitudinal);
  visit(ResultField{"lateral", "N", "Part of the reaction across, port positive", kBoxFrame}.csv("reaction lateral"),
        r.lateral);
  visit(
      ResultField{"separation", "m", "Clear distance from pipe to roller: positive if clear, negative for penetration"}
          .csv("separation")
          .summary()
          .page()
          .report(),
      r.separation);
  visit(ResultField{"off_end", "m", "Distance of the closest point beyond the face; 0 on the face"}.report(),
        r.off_end);
  visit(ResultField{"line_load", "N/m", "Line load of the reaction on the coating; 0 without a coating"}, r.line_load);
  visit(ResultField{"", "m", "Reference point: middle of the face", kWorldFrame}.csv(kComponents).report("p"), r.p_W);
  visit(ResultField{"normal", "1", "Unit normal of the face towards the pipe", kWorldFrame}.report(), r.normal_W);
  visit(ResultField{"axis", "1", "Unit vector along the axis of the roller", kWorldFrame}.page().report(), r.axis_W);
  visit(ResultField{"radius", "m", "Radius of the roller"}.page().report(), r.radius);
  visit(ResultField{"face", "m", "Length of the face"}.page().report(), r.face);
}

template <class Row, class Visit>
void visit_structure_ends(Row& r, Visit& visit) {
  visit(ResultField{"upper_s", "m", "Arc length of its end towards the tensioner, from the anchor"}.summary("upper/s"),
        r.upper.s);
  visit(ResultField{"upper_bending_moment", "N m", "Bending moment at that end"}.summary("upper/bending_moment"),
        r.upper.bending_moment);
  visit(ResultField{"upper_bending_stress", "Pa", "Largest bending stress of the pipe within two diameters of it"}
            .summary("upper/max_bending_stress"),
        r.upper.bending_stress);
  visit(
      ResultField{"upper_von_mises", "Pa", "Largest von Mises stress of the pipe there"}.summary("upper/max_von_mises"),
      r.upper.von_mises);
  visit(ResultField{"upper_strain", "1", "Largest strain of the pipe there"}.summary("upper/max_strain"),
        r.upper.strain);
  visit(ResultField{"lower_s", "m", "Arc length of its end towards the seabed, from the anchor"}.summary("lower/s"),
        r.lower.s);
  visit(ResultField{"lower_bending_moment", "N m", "Bending moment at that end"}.summary("lower/bending_moment"),
        r.lower.bending_moment);
  visit(ResultField{"lower_bending_stress", "Pa", "Largest bending stress of the pipe within two diameters of it"}
            .summary("lower/max_bending_stress"),
        r.lower.bending_stress);
  visit(
      ResultField{"lower_von_mises", "Pa", "Largest von Mises stress of the pipe there"}.summary("lower/max_von_mises"),
      r.lower.von_mises);
  visit(ResultField{"lower_strain", "1", "Largest strain of the pipe there"}.summary("lower/max_strain"),
        r.lower.strain);
}

/// Structures built into the pipe.
template <class Row, class Visit>
void visit_structure(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the structure"}.summary(), r.name);
  visit(ResultField{"from_top", "m", "Distance along the pipe from the tensioner to its middle"}.summary(), r.from_top);
  visit(ResultField{"p", "m", "Position of its middle", kWorldFrame}.summary("place"), r.p_W);
  visit(ResultField{"astern", "m", "Distance of its middle astern of the stern shoe"}.summary(), r.astern);
  visit(ResultField{"inclination", "rad", "Inclination from horizontal, positive dipping astern"}.summary(),
        r.inclination);
  visit(ResultField{"bending_moment", "N m", "Largest bending moment in it"}.summary("max_bending_moment"),
        r.bending_moment);
  visit(ResultField{"effective_tension", "N", "Largest effective tension in it"}.summary("max_effective_tension"),
        r.effective_tension);
  visit(ResultField{"reaction", "N", "Maximum reaction of a roller under it; 0 without contact"}.summary(), r.reaction);
  visit(ResultField{"support", "1", "Box of that roller; empty without contact"}.summary(), r.support);
  visit_structure_ends(r, visit);
}

template <class Row, class Visit>
void visit_section(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the section"}.summary(), r.name);
  visit(ResultField{"EA", "N", "Axial stiffness"}.summary(), r.EA);
  visit(ResultField{"EI", "N m2", "Bending stiffness"}.summary(), r.EI);
  visit(ResultField{"weight_in_air", "N/m", "Weight in air per length"}.summary(), r.weight_in_air);
  visit(ResultField{"weight_submerged", "N/m", "Submerged weight per length"}.summary(), r.weight_submerged);
  visit(ResultField{"steel_area", "m2", "Cross-section of the steel"}.summary(), r.steel_area);
  visit(ResultField{"second_moment", "m4", "Second moment of area of the steel"}.summary(), r.second_moment);
  visit(ResultField{"outer_diameter", "m", "Diameter over the coatings"}.summary(), r.outer_diameter);
  visit(ResultField{"mass", "kg/m", "Mass per length"}.summary(), r.mass);
}

}  // namespace overbend
