/// Potential damage of the pipe by an impact: dents in bare steel, crushed coating. Simple measures for ranking impacts
/// and for comparison with limits; docs/theory/impacts.md describes their range of validity.
#pragma once

#include "model/pipe/contact_stiffness.h"
#include "model/pipe/section.h"

namespace overbend {

/// Returns the depth of the dent that a transverse force [N] leaves in bare steel [m], from the energy of a knife-edge
/// dent in [dnvf107], after [wierzbicki1988]. Outside diameter of the steel and wall thickness [m], yield stress [Pa],
/// all > 0. The relation is rigid-plastic and has no elastic threshold: any force > 0 leaves a dent, however small. It
/// is valid for dents small against the diameter; values beyond a third of the diameter only indicate a flattened pipe.
double dent_depth(double force, double steel_diameter, double wall_thickness, double yield_stress);

/// Returns the dent depth [m] for a section of the line; 0 if it has no wall of known strength, as in a cable.
double dent_depth(double force, const Section& section);

/// Returns the force per length of coating [N/m]; 0 without contact length, i.e. without coating.
double line_load(double force, double contact_length);

}  // namespace overbend
