/// Forces and tangents of all elements of a line, one SIMD register of elements at a time. Compiled once per
/// instruction set; raw pointers only, so that no inline function of another header is compiled for an instruction set
/// that the machine may lack.
#pragma once

#include "model/site/route_piece.h"

namespace overbend {

struct SeabedShape;

/// Pointers to element constants, see LineElements.
struct LineView {
  int count = 0;
  const double *length, *EA, *EI, *compression, *damping, *weight, *buoyancy, *radius, *drag_normal, *drag_axial;
  const double *pressure_constant, *pressure_slope, *pressure_external;
  const double *mass, *displaced_mass, *added_normal, *added_axial;
  const double* drag_on_bed;
};

/// Environment of every element. Directions and points in W. Seabed and route are evaluated in ground.h and
/// line_kernel_ground.h.
struct LineEnvironment {
  double bed_normal[3] = {0.0, 0.0, 1.0};
  double bed_offset = -1e30;  ///< normal . point of the seabed [m].
  /// Bathymetry in place of normal and offset; null for a plane seabed.
  const SeabedShape* bed_shape = nullptr;
  double bed_relief = 1.0;     ///< Factor on the shape's heights above `bed_level`, for continuation.
  double bed_level = 0.0;      ///< [m]
  double bed_lowered = 0.0;    ///< Distance by which the shape is lowered, along its normal [m].
  double bed_highest = -1e30;  ///< Upper bound of the height of the shape, for any relief [m].
  double bed_stiffness = 0.0;  ///< [N/m2]
  double bed_friction_lateral = 0.0;
  double bed_friction_axial = 0.0;
  double bed_stick = 0.0;  ///< Elastic friction stiffness per length [N/m2].
  /// True if the line is dragged along the seabed: in statics LineView::drag_on_bed then replaces bed_friction_axial.
  bool dragged = false;
  int bed_soil = 0;                          ///< Values of SoilModel: linear, hyperbolic, bilinear.
  double bed_bearing = 0.0;                  ///< Bearing force of nonlinear soil [N/m].
  double bed_damping = 0.0;                  ///< Damping on approach, in dynamics only [N s/m2].
  double route_normal[3] = {0.0, 1.0, 0.0};  ///< Horizontal, across the lay route, to port.
  double bed_along[3] = {1.0, 0.0, 0.0};     ///< Along the laid line on the seabed, away from the vessel.
  double route_offset = 0.0;                 ///< route_normal . point of the route [m].
  int route_pieces = 0;                      ///< 0: the route is straight, given by the three members above.
  /// Pieces of a curved route; `route_normal` and `bed_along` then refer to its start.
  const RoutePiece* route = nullptr;
  double route_shift = 0.0;           ///< Distance to port by which the pipe was laid off the route [m].
  double current_scale = 1.0;         ///< Factor on the current speed, for continuation.
  int current_rows = 0;               ///< 0: no current.
  const double* current_z = nullptr;  ///< Ascending z [m].
  const double* current_vx = nullptr;
  const double* current_vy = nullptr;
};

/// Position and tangent of every node, six doubles each. `low`, which may be null, holds the rounding error of `q`:
/// with an axial stiffness of 1e9 N, rounding of positions of hundreds of metres in double precision corresponds to
/// 1e-3 N.
struct LineShape {
  const double* q = nullptr;
  const double* low = nullptr;
};

/// Doubles per node that describe the water: velocity, acceleration, surface elevation, head of the dynamic pressure.
inline constexpr int kWaterValues = 8;
/// Directions of seabed friction: across the route, along it.
inline constexpr int kBedDirections = 2;

/// Offsets of the values of a section with plasticity, see HeldSections: tangent and first axis of its memory; in these
/// axes the centre and radius of the curvature range without slip (negative radius: unknown) and the plastic moment of
/// its slips; and the stored energy of the slips.
enum HeldValue { kHeldTangent = 0, kHeldAxis = 3, kHeldCenter = 6, kHeldSlack = 8, kHeldMoment = 9, kHeldStored = 11 };
inline constexpr int kHeldValues = 12;

/// Plastic history at the Gauss points of a moving line (mechanics/plastic_bending.h). A section without slip keeps its
/// plastic moment, whose axes move with the pipe: the kernel subtracts it from the elastic moment.
struct HeldSections {
  const double* values = nullptr;  ///< Values kHeldValues by Gauss point, number and element (padded count).
  double* after = nullptr;         ///< Values after the step; only tangents and axes are written.
  /// Output by Gauss point and element (padded count): above zero where springs slip and nothing was subtracted.
  double* left = nullptr;
  /// Energy beyond that of elastic bending in sections without slip [J]: kLanes sums, accumulated.
  double* stored = nullptr;
};

/// Kinematic state of a moving line; not used in statics.
struct LineMotion {
  const double* v = nullptr;        ///< Velocities of all unknowns, six per node [m/s], [1/s].
  const double* acc = nullptr;      ///< Accelerations of all unknowns.
  double velocity_share = 0.0;      ///< Derivative of a velocity with its unknown, by the integrator's formula [1/s].
  double acceleration_share = 0.0;  ///< Derivative of an acceleration with its unknown [1/s2].
  double step = 0.0;                ///< Time since the elastic slip of the seabed friction was `bed_slip` [s].
  /// Waves at every node, kWaterValues each, current not included; null in calm water. Interpolated linearly along an
  /// element.
  const double* water = nullptr;
  /// Elastic slip of the seabed friction by Gauss point, direction and element (padded count) [m]: at the start of the
  /// step, and output at its end.
  const double* bed_slip = nullptr;
  double* bed_slip_next = nullptr;
  const HeldSections* held = nullptr;  ///< Null if no steel yields.
};

/// Sums over the line at one instant.
struct LineEnergy {
  double kinetic = 0.0, strain = 0.0, gravity = 0.0, seabed = 0.0;  ///< [J]
  double fluid_power = 0.0;  ///< Power of buoyancy, drag, inertia forces of the water and pressure on the pipe [W].
  double seabed_loss = 0.0;  ///< Dissipation by seabed damping and friction, including stored elastic slip [W].
  double line_loss = 0.0;    ///< Dissipation by internal damping of tension-only elements [W].
};

/// Output pointers; null ones are skipped. Everything is overwritten.
struct LineTarget {
  double* residual = nullptr;                                  ///< Six per node.
  double *diag = nullptr, *upper = nullptr, *lower = nullptr;  ///< As stored by BlockTridiagonal.
  /// Six per node: contribution of the element below a node to the node's residual; at the first node minus the
  /// contribution of the first element. In equilibrium it is the force of the line above a cut at the node on the line
  /// below.
  double* cuts = nullptr;
  LineEnergy* energy = nullptr;  ///< Only in dynamics without blocks: at the end of the step.
};

namespace isa_baseline {
void add_line_forces(const LineView& line, const LineEnvironment& env, const LineShape& shape,
                     const LineTarget& target);
void add_moving_line_forces(const LineView& line, const LineEnvironment& env, const LineShape& shape,
                            const LineMotion& motion, const LineTarget& target);
}  // namespace isa_baseline
namespace isa_avx2 {
void add_line_forces(const LineView& line, const LineEnvironment& env, const LineShape& shape,
                     const LineTarget& target);
void add_moving_line_forces(const LineView& line, const LineEnvironment& env, const LineShape& shape,
                            const LineMotion& motion, const LineTarget& target);
}  // namespace isa_avx2
namespace isa_avx512 {
void add_line_forces(const LineView& line, const LineEnvironment& env, const LineShape& shape,
                     const LineTarget& target);
void add_moving_line_forces(const LineView& line, const LineEnvironment& env, const LineShape& shape,
                            const LineMotion& motion, const LineTarget& target);
}  // namespace isa_avx512

}  // namespace overbend
