/// Forces and tangents of all elements of a line, as many at a time as a register holds. Compiled once per instruction
/// set; raw pointers only, so that no inline function of another header is compiled for an instruction set that the
/// machine may lack.
#pragma once

namespace overbend {

/// Element constants, see LineElements.
struct LineView {
  int count = 0;
  const double *length, *EA, *EI, *weight, *buoyancy, *radius, *drag_normal, *drag_axial;
  const double *pressure_constant, *pressure_slope, *pressure_external;
};

/// What acts on every element. Directions and points in W.
struct LineEnvironment {
  double bed_normal[3] = {0.0, 0.0, 1.0};
  double bed_offset = -1e30;   ///< normal . point of the bed [m].
  double bed_stiffness = 0.0;  ///< [N/m2]
  double bed_friction_lateral = 0.0;
  double bed_friction_axial = 0.0;
  double bed_stick = 0.0;                    ///< Elastic stick per length [N/m2].
  double route_normal[3] = {0.0, 1.0, 0.0};  ///< Horizontal, across the lay route, to port.
  double bed_along[3] = {1.0, 0.0, 0.0};     ///< Along the laid line on the bed, away from the barge.
  double route_offset = 0.0;                 ///< route_normal . point of the route [m].
  double current_scale = 1.0;                ///< Of the current's speed, for continuation.
  int current_rows = 0;                      ///< 0: no current.
  const double* current_z = nullptr;         ///< Rising z [m].
  const double* current_vx = nullptr;
  const double* current_vy = nullptr;
};

/// Position and tangent of every node, six doubles each. `low`, which may be null, holds what rounding cut off `q`:
/// with axial stiffness of 1e9 N, positions of hundreds of metres in plain doubles are worth 1e-3 N.
struct LineShape {
  const double* q = nullptr;
  const double* low = nullptr;
};

/// Where the results are added: residual (six per node) and, unless null, the blocks of the tangent.
struct LineTarget {
  double* residual = nullptr;
  double *diag = nullptr, *upper = nullptr, *lower = nullptr;  ///< As stored by BlockTridiagonal.
};

namespace isa_baseline {
void add_line_forces(const LineView& line, const LineEnvironment& env, const LineShape& shape,
                     const LineTarget& target);
}
namespace isa_avx2 {
void add_line_forces(const LineView& line, const LineEnvironment& env, const LineShape& shape,
                     const LineTarget& target);
}
namespace isa_avx512 {
void add_line_forces(const LineView& line, const LineEnvironment& env, const LineShape& shape,
                     const LineTarget& target);
}

}  // namespace overbend
