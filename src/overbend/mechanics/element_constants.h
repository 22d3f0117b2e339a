/// Material and hydrodynamic constants of line elements, and their conversion to the arrays of LineElements: pipes from
/// their sections, cables from their line types.
#pragma once

#include <vector>

#include "mechanics/line_elements.h"
#include "model/description/line_description.h"

namespace overbend {

/// Constants of one kind of element; meanings as in LineElements. Per unstressed length.
struct ElementConstants {
  double EA = 0.0, EI = 0.0;  ///< [N], [N m2]
  double compression = 1.0;   ///< Fraction of EA effective in compression, see slack_law.h [-].
  double damping = 0.0;  ///< Internal damping of the tension-only part, see slack_law.h; set for the whole line [s].
  double weight = 0.0, buoyancy = 0.0;                                             ///< [N/m]
  double radius = 1.0;                                                             ///< [m]
  double drag_normal = 0.0, drag_axial = 0.0;                                      ///< [kg/m2]
  double pressure_constant = 0.0, pressure_slope = 0.0, pressure_external = 0.0;   ///< [N], [N/m], [N/m]
  double mass = 0.0, displaced_mass = 0.0, added_normal = 0.0, added_axial = 0.0;  ///< [kg/m]
  double drag_on_bed = 0.0;                                                        ///< [-]
};

/// Returns the constants of a pipe with this section in the model's water.
ElementConstants pipe_constants(const Model& model, const Section& section);

/// Returns the constants of a cable, chain or flexible in the model's water. It gets a small bending stiffness
/// regardless of its type, without effect on tensions, so that it has lateral stiffness when slack. Its axial stiffness
/// is that of the effective tension, so that pressure causes none; its displaced mass follows from its two weights, and
/// its radius, which decides when it is wet, from its displaced mass. Drag refers to its own diameter, axial drag to
/// its circumference (Morison et al. 1950; as in MoorDyn, Hall and Goupee 2015).
ElementConstants cable_constants(const Model& model, const LineTypeDescription& type);

/// Makes elements of the given unstressed lengths [m]; element i has the constants `constants[kinds[i]]`. Tension-only
/// elements are damped as one line.
LineElements make_elements_by_kind(const std::vector<double>& lengths, const std::vector<int>& kinds,
                                   const std::vector<ElementConstants>& constants);

}  // namespace overbend
