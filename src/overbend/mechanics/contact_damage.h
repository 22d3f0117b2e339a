/// Possible damage of the pipe by an impact: dents in bare steel, crushed coating. Simple measures for ranking impacts
/// and for comparing with limits; docs/theory/impacts.md says how far they reach.
#pragma once

#include "model/pipe/contact_stiffness.h"
#include "model/pipe/section.h"

namespace overbend {

/// Depth of the dent that a force [N] across the pipe leaves in bare steel [m], from the energy of a knife-edge dent in
/// [dnvf107], after [wierzbicki1988]. Diameter of the steel outside, wall [m], yield stress [Pa], all > 0. The relation
/// is rigid-plastic and has no elastic threshold: any force > 0 dents, a small one hardly. It is meant for dents small
/// against the diameter; beyond a third of it the value says no more than "flattened".
double dent_depth(double force, double steel_diameter, double wall_thickness, double yield_stress);

/// The same in a section of the line; 0 where there is no wall of known strength that could be dented, as in a cable.
double dent_depth(double force, const Section& section);

/// Force per length of coating [N/m]; 0 where there is no length, as there is no coating to crush.
double line_load(double force, double contact_length);

}  // namespace overbend
