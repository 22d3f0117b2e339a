/// What elements are made of, kind by kind, and how that becomes the arrays of LineElements: pipes by their sections,
/// cables by their numbers.
#pragma once

#include <vector>

#include "mechanics/line_elements.h"
#include "model/description/line_description.h"

namespace overbend {

/// Of one kind of element; see LineElements for the meanings. Per unstressed length.
struct ElementConstants {
  double EA = 0.0, EI = 0.0;                   ///< [N], [N m2]
  double compression = 1.0;                    ///< Share of EA that bears compression, see slack_law.h [-].
  double damping = 0.0;                        ///< Of what bears none, see slack_law.h; that of its line [s].
  double weight = 0.0, buoyancy = 0.0;         ///< [N/m]
  double radius = 1.0;                         ///< [m]
  double drag_normal = 0.0, drag_axial = 0.0;  ///< [kg/m2]
  double pressure_constant = 0.0, pressure_slope = 0.0, pressure_external = 0.0;   ///< [N], [N/m], [N/m]
  double mass = 0.0, displaced_mass = 0.0, added_normal = 0.0, added_axial = 0.0;  ///< [kg/m]
  double drag_on_bed = 0.0;                                                        ///< [-]
};

/// Of a pipe with this section in the model's water.
ElementConstants pipe_constants(const Model& model, const Section& section);

/// Of a cable, chain or flexible in the model's water. It has a little bending stiffness
/// whatever its type says, of no effect on tensions, so that it has some where it is slack. Its axial stiffness is that
/// of the effective tension, so that pressure makes none; what it displaces follows from its two weights, and its
/// radius, which says when it is wet, from what it displaces. Drag counts on its own diameter, along it on the
/// circumference (Morison et al. 1950; as MoorDyn, Hall and Goupee 2015, has it).
ElementConstants cable_constants(const Model& model, const LineTypeDescription& type);

/// Elements of the given unstressed lengths [m]; element i is of `kinds[i]`. Those that only pull are damped as one
/// line.
LineElements elements_of_kinds(const std::vector<double>& lengths, const std::vector<int>& kinds,
                               const std::vector<ElementConstants>& constants);

}  // namespace overbend
