/// Straight weightless wires and their pull on bodies and on nodes of a line. At line nodes they may have weight in
/// statics: elastic catenaries.
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

inline constexpr int kGround = -1;  ///< In place of a body: the ground.

/// A straight weightless wire between two points of bodies or of the ground. It carries tension only.
struct Wire {
  std::string name;
  int first_body = kGround, second_body = kGround;
  Vec3 first = Vec3::Zero(), second = Vec3::Zero();  ///< In the frames of the bodies; W on the ground [m].
  double length = 0.0;                               ///< Unstressed [m].
  double axial_stiffness = 0.0;                      ///< EA [N]
  std::optional<double> held_tension;                ///< Tension kept by a winch at any length [N].
};

/// Pull of a wire between two points.
struct WirePull {
  double tension = 0.0;           ///< At its first end; 0 if slack [N].
  double span = 0.0;              ///< Distance of its ends [m].
  Vec3 first = Vec3::Zero();      ///< Position of its first end, W [m].
  Vec3 second = Vec3::Zero();     ///< Position of its second end, W [m].
  Vec3 force = Vec3::Zero();      ///< On the support of its first end, W [N].
  Vec3 on_second = Vec3::Zero();  ///< On the support of its second end [N]; the opposite, apart from its weight.
  Mat3 stiffness = Mat3::Zero();  ///< d force / d place of the second end [N/m].
};

/// Returns T = EA (span - length) / length where positive, or the tension of its winch.
WirePull wire_pull(const Wire& wire, const Vec3& first, const Vec3& second);

/// A wire from a body or the ground, its first end, to a node of a line.
struct LineWire {
  Wire wire;
  std::optional<CatenaryLine> catenary;  ///< Catenary of a wire with weight, from its first end.
  double share = 1.0;                    ///< Factor on its forces in a continuation.
  int node = 0;
  bool reversed = false;  ///< True if that first end is the second one of the model's line.
};

/// Position and motion of the first end of a wire, W.
struct WireEnd {
  Vec3 place = Vec3::Zero(), velocity = Vec3::Zero();
};
/// Returns the position and motion of the first end of a wire.
WireEnd wire_end(const Wire& wire, const std::vector<RigidMotion>& bodies);

/// Subtracts the pulls of wires from `residual` (six per node) and, unless null, adds their derivatives to the blocks;
/// `pulls` receives them. `ends` and `pulls` have one entry per wire.
void add_wire_forces(std::span<const LineWire> wires, std::span<const WireEnd> ends, const double* q, double* residual,
                     BlockTridiagonal* tangent, std::span<WirePull> pulls);

/// Adds the energy stored in wires to that of a line, and the power of their first ends to `power` [W].
void add_wire_energy(std::span<const LineWire> wires, std::span<const WireEnd> ends, std::span<const WirePull> pulls,
                     LineEnergy& sum, double& power);

}  // namespace overbend
