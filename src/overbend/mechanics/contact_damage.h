/// What an impact may do to the pipe: dents in bare steel, crushed coating. Simple measures for ranking impacts and for
/// comparing with limits; docs/theory/impacts.md says how far they reach.
#pragma once

namespace overbend {

/// Depth of the dent that a force [N] across the pipe leaves in bare steel [m], from the energy of a knife-edge dent in
/// [dnvf107], after [wierzbicki1988]. Diameter of the steel outside, wall [m], yield stress [Pa], all > 0. The relation
/// is rigid-plastic and has no elastic threshold: any force > 0 dents, a small one hardly. It is meant for dents small
/// against the diameter; beyond a third of it the value says no more than "flattened".
double dent_depth(double force, double steel_diameter, double wall_thickness, double yield_stress);

/// Length on which a roller bears on the coating [m]: along the roller, across the pipe, the chord of the coating that
/// just touches the steel, but not more than the roller's face. 0 for a pipe without coating.
///
///        ___---___
///     .-----------.   <- chord       roller below or beside, its axis along the chord
///    /  .-steel-.  \.
///
double contact_length(double roller_face, double outer_diameter, double steel_diameter);

/// Force per length of coating [N/m]; 0 where there is no length, as there is no coating to crush.
double line_load(double force, double contact_length);

}  // namespace overbend
