/// Straight wires without weight: their pull on what they are between, and on nodes of a line. There they may have
/// weight, at rest: elastic catenaries.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/vec.h"
#include "mechanics/line_kernel.h"
#include "mechanics/vessel_motion.h"
#include "moorings/catenary_line.h"
#include "numerics/block_tridiagonal.h"

namespace overbend {

inline constexpr int kGround = -1;  ///< In place of a body: the world.

/// A straight wire without weight between two points of bodies or of the ground. It bears tension alone.
struct Wire {
  std::string name;
  int first_body = kGround, second_body = kGround;
  Vec3 first = Vec3::Zero(), second = Vec3::Zero();  ///< In the frames of the bodies; W on the ground [m].
  double length = 0.0;                               ///< Unstressed [m].
  double axial_stiffness = 0.0;                      ///< EA [N]
  std::optional<double> held_tension;                ///< By a winch that gives it what length that needs [N].
};

/// Of a wire between two places.
struct WirePull {
  double tension = 0.0;           ///< At its first end; 0 while it is slack [N].
  double span = 0.0;              ///< Distance of its ends [m].
  Vec3 first = Vec3::Zero();      ///< Place of its first end, W [m].
  Vec3 second = Vec3::Zero();     ///< Of its second.
  Vec3 force = Vec3::Zero();      ///< On what holds its first end, W [N].
  Vec3 on_second = Vec3::Zero();  ///< On what holds its second; the opposite, but for its weight.
  Mat3 stiffness = Mat3::Zero();  ///< d force / d place of the second end [N/m].
};

/// T = EA (span - length) / length where that is positive, or what its winch holds.
WirePull wire_pull(const Wire& wire, const Vec3& first, const Vec3& second);

/// A wire from a body or the ground, its first end, to a node of a line.
struct LineWire {
  Wire wire;
  std::optional<CatenaryLine> hanging;  ///< Of one with weight: what hangs there, from its first end.
  double share = 1.0;                   ///< Of that its forces are, in a continuation.
  int node = 0;
  bool reversed = false;  ///< That first end is the second of the line that it is in the model.
};

/// Where the first end of such a wire is, and how it moves, W.
struct WireEnd {
  Vec3 place = Vec3::Zero(), velocity = Vec3::Zero();
};
WireEnd wire_end(const Wire& wire, const std::vector<RigidMotion>& bodies);

/// Subtracts the pulls of wires from `residual` (six per node) and, unless null, their derivatives from the blocks;
/// `pulls` takes them. Each wire has its end, and its place among the pulls.
void add_wire_forces(std::span<const LineWire> wires, std::span<const WireEnd> ends, const double* q, double* residual,
                     BlockTridiagonal* tangent, std::span<WirePull> pulls);

/// Adds what wires store to the energy of a line, and what their first ends put into it to `power` [W].
void add_wire_energy(std::span<const LineWire> wires, std::span<const WireEnd> ends, std::span<const WirePull> pulls,
                     LineEnergy& sum, double& power);

}  // namespace overbend
