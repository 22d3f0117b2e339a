/// In-line structures: buckle arrestors, tees, valves, end terminations.
#pragma once

#include <optional>
#include <string>

namespace overbend {

/// Length of the line with its own stiffness, weight and diameter. Properties not given are those of the pipe.
struct StructureDescription {
  std::string name;
  /// Unstressed length from the tensioner to the middle of the structure [m]; without it the structure is in the line
  /// only at the stages of its passage.
  std::optional<double> at;
  double length = 0.0;                            ///< Unstressed [m].
  double weight_in_air = 0.0;                     ///< Weight of the whole structure, distributed over its length [N].
  double weight_submerged = 0.0;                  ///< [N]
  std::optional<double> bending_stiffness;        ///< EI [N m2]
  std::optional<double> axial_stiffness;          ///< EA [N]
  std::optional<double> diameter;                 ///< Contact diameter on rollers and seabed, and drag diameter [m].
  std::optional<double> drag_normal, drag_axial;  ///< [-]
  std::optional<double> added_mass_normal, added_mass_axial;  ///< [-]
};

}  // namespace overbend
