/// Forces and tangents of all elements of a line, as many at a time as a register holds. Compiled once per instruction
/// set; raw pointers only, so that no inline function of another header is compiled for an instruction set that the
/// machine may lack.
#pragma once

#include "model/site/route_piece.h"

namespace overbend {

struct BedShape;

/// Element constants, see LineElements.
struct LineView {
  int count = 0;
  const double *length, *EA, *EI, *compression, *damping, *weight, *buoyancy, *radius, *drag_normal, *drag_axial;
  const double *pressure_constant, *pressure_slope, *pressure_external;
  const double *mass, *displaced_mass, *added_normal, *added_axial;
  const double* drag_on_bed;
};

/// What acts on every element. Directions and points in W. Bed and route are numbers here and functions of the place in
/// ground.h and line_kernel_ground.h.
struct LineEnvironment {
  double bed_normal[3] = {0.0, 0.0, 1.0};
  double bed_offset = -1e30;  ///< normal . point of the bed [m].
  /// Heights of a bed that is not a plane, in place of normal and offset; null for a plane.
  const BedShape* bed_shape = nullptr;
  double bed_relief = 1.0;     ///< Factor on the shape's heights over `bed_level`, for continuation.
  double bed_level = 0.0;      ///< [m]
  double bed_lowered = 0.0;    ///< How far the shape lies lower, along its normal [m].
  double bed_highest = -1e30;  ///< No place of the shape is higher, whatever its relief [m].
  double bed_stiffness = 0.0;  ///< [N/m2]
  double bed_friction_lateral = 0.0;
  double bed_friction_axial = 0.0;
  double bed_stick = 0.0;  ///< Elastic stick per length [N/m2].
  /// Whether the line is dragged along the bed: in statics LineView::drag_on_bed acts instead of bed_friction_axial.
  bool dragged = false;
  int bed_soil = 0;                          ///< As SoilModel: linear, hyperbolic, bilinear.
  double bed_bearing = 0.0;                  ///< Of soil that is not linear [N/m].
  double bed_damping = 0.0;                  ///< On approach, in motion only [N s/m2].
  double route_normal[3] = {0.0, 1.0, 0.0};  ///< Horizontal, across the lay route, to port.
  double bed_along[3] = {1.0, 0.0, 0.0};     ///< Along the laid line on the bed, away from the barge.
  double route_offset = 0.0;                 ///< route_normal . point of the route [m].
  int route_pieces = 0;                      ///< 0: the route is straight, as the three above have it.
  const RoutePiece* route = nullptr;         ///< Of one that is not; `route_normal` and `bed_along` are at its start.
  double route_shift = 0.0;                  ///< How far to port of these the pipe was laid [m].
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

/// Doubles per node that describe the water: velocity, acceleration, elevation of the surface, head of the dynamic
/// pressure.
inline constexpr int kWaterValues = 8;
/// Directions in which the bed holds by friction: across the route, along it.
inline constexpr int kBedDirections = 2;

/// Numbers of a section whose steel may yield, see HeldSections: tangent and first axis of its memory, in these axes
/// the curvature about which nothing slides and how far from there (negative: not known), the plastic moment of its
/// slips in these axes, and the energy that they store.
enum HeldValue { kHeldTangent = 0, kHeldAxis = 3, kHeldCenter = 6, kHeldSlack = 8, kHeldMoment = 9, kHeldStored = 11 };
inline constexpr int kHeldValues = 12;

/// Steel that may yield, at the Gauss points of a line in motion (mechanics/plastic_bending.h). A section that nothing
/// slides in holds its plastic moment, whose axes go with the pipe: the kernel takes that off the elastic moment.
struct HeldSections {
  const double* values = nullptr;  ///< kHeldValues by Gauss point, number and element (padded count).
  double* after = nullptr;         ///< The same after the step, of which tangents and axes are written.
  /// By Gauss point and element (padded count), written: above zero where springs slide and nothing was taken off.
  double* left = nullptr;
  /// Energy stored beyond that of elastic bending where nothing slides [J]: kLanes sums, added to.
  double* stored = nullptr;
};

/// What motion adds to a shape. In statics there is none.
struct LineMotion {
  const double* v = nullptr;        ///< Velocities of all unknowns, six per node [m/s], [1/s].
  const double* acc = nullptr;      ///< Accelerations of all unknowns.
  double velocity_share = 0.0;      ///< Change of a velocity with its unknown, by the integrator's formula [1/s].
  double acceleration_share = 0.0;  ///< The same for the acceleration [1/s2].
  double step = 0.0;                ///< Time since the stretch of the bed's friction was `bed_slip` [s].
  /// Waves at every node, kWaterValues each, current not included; null in calm water. Linear along an element.
  const double* water = nullptr;
  /// Elastic stretch of the bed's friction, by Gauss point, direction and element (padded count) [m]: at the start of
  /// the step, and where what it has become is put.
  const double* bed_slip = nullptr;
  double* bed_slip_next = nullptr;
  const HeldSections* held = nullptr;  ///< Null where no steel yields.
};

/// Sums over the line at one instant.
struct LineEnergy {
  double kinetic = 0.0, strain = 0.0, gravity = 0.0, seabed = 0.0;  ///< [J]
  double fluid_power = 0.0;  ///< Of buoyancy, drag, inertia forces of the water and pressure on the pipe [W].
  double seabed_loss = 0.0;  ///< Damping and friction of the bed, stored stretch included [W].
  double line_loss = 0.0;    ///< Internal damping of what only pulls [W].
};

/// Where the results go, whatever is not null. Everything is written.
struct LineTarget {
  double* residual = nullptr;                                  ///< Six per node.
  double *diag = nullptr, *upper = nullptr, *lower = nullptr;  ///< As stored by BlockTridiagonal.
  /// Six per node: what the element below a node adds to the node's residual; at the first node minus what the first
  /// element adds. In balance that is what the line above a cut at the node exerts on what is below.
  double* cuts = nullptr;
  LineEnergy* energy = nullptr;  ///< In motion, and only without blocks: at the end of the step.
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
