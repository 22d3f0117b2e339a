/// What is built into the pipe: buckle arrestors, tees, valves, end terminations.
#pragma once

#include <optional>
#include <string>

namespace overbend {

/// A stretch of the line with a stiffness, weight and diameter of its own. What is not given is the pipe's.
struct StructureDescription {
  std::string name;
  /// Unstressed length from the tensioner to its middle [m]; a structure without it is in the line only at the stages
  /// of its passage.
  std::optional<double> at;
  double length = 0.0;                                        ///< Unstressed [m].
  double weight_in_air = 0.0;                                 ///< Of the whole structure, even over its length [N].
  double weight_submerged = 0.0;                              ///< [N]
  std::optional<double> bending_stiffness;                    ///< EI [N m2]
  std::optional<double> axial_stiffness;                      ///< EA [N]
  std::optional<double> diameter;                             ///< With which it lies on rollers and bed, and drags [m].
  std::optional<double> drag_normal, drag_axial;              ///< [-]
  std::optional<double> added_mass_normal, added_mass_axial;  ///< [-]
};

}  // namespace overbend
