/// Dynamics of a rigid stinger section: inertia, weight, and forces of water and wires.
///
/// Tanks are cut into strips along their axis. Each strip has Froude-Krylov force and buoyancy of the part of its axis
/// below the instantaneous surface, rho V (g + a_w), and across the axis the force of Morison, O'Brien, Johnson and
/// Schaaf (1950) on a moving cylinder, rho V C_a (a_w - a) + 1/2 rho C_d D l |u| u with u the velocity of the water
/// relative to the strip. Theory: docs/theory/stinger-motion.md. Positions are in the frame V with the section at its
/// reference angle.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mechanics/sea.h"
#include "mechanics/vessel_motion.h"
#include "model/model.h"

namespace overbend {

/// Length of a round tank.
struct TankStrip {
  Vec3 from_V = Vec3::Zero(), to_V = Vec3::Zero();  ///< Ends of its axis [m].
  double diameter = 0.0;                            ///< [m]
  double drag = 1.0, added_mass = 1.0;              ///< Coefficients across the axis [-].
  int tank = 0;
};

/// Part of the structure that stays under water.
struct ImmersedBody {
  Vec3 place_V = Vec3::Zero();    ///< [m]
  Vec3 across_V = Vec3::UnitZ();  ///< Unit vector across the section, in its plane.
  double volume = 0.0;            ///< [m3]
  double added_mass = 0.0;        ///< Added mass of motion across it [kg].
  double drag_area = 0.0;         ///< Drag area Cd A of motion across it [m2].
};

/// Wire or strut to the vessel.
struct SectionSpring {
  Vec3 vessel_V = Vec3::Zero(), section_V = Vec3::Zero();  ///< Ends on the vessel and on the section [m].
  double stiffness = 0.0;                                  ///< [N/m]
  double length = 0.0;                                     ///< Unstressed [m].
  bool wire = true;                                        ///< Tension-only.
};

struct SectionBody {
  double mass = 0.0;              ///< Mass of structure, tanks and ballast [kg].
  Vec3 center_V = Vec3::Zero();   ///< Centre of gravity [m].
  Mat3 inertia_V = Mat3::Zero();  ///< Inertia about the centre of gravity [kg m2].
  std::vector<TankStrip> strips;
  std::optional<ImmersedBody> immersed;
  std::vector<SectionSpring> springs;
};

/// Water around a section.
struct SectionSea {
  Sea sea;
  CurrentProfile current;
  /// Ramp duration of the waves before t = 0; the current has its full speed as in statics [s].
  double build_up = 0.0;
  double weight_density = 0.0;  ///< [N/m3]
};

/// Returns the velocity of a current at a height [m/s].
Vec3 current_at(const CurrentProfile& current, double z);

/// Evaluates the water at the middles of the strips and at the immersed body, current included, for the current
/// position of the section. `points` and `water` have an item for each; nothing is allocated.
void water_at_section(const SectionSea& sea, double time, const SectionBody& body, const RigidMotion& motion,
                      std::span<Vec3> points, std::span<WaterState> water);

/// Returns the number of points needed by water_at_section().
std::size_t water_places(const SectionBody& body);

/// Force and moment about a point, W [N], [N m].
struct Wrench {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
};

/// Returns inertia minus all external forces on the section except rollers and hinges; moment about `about` (W).
/// `barge` moves the other ends of the springs.
Wrench section_residual(const SectionBody& body, const RigidMotion& motion, const RigidMotion& barge,
                        std::span<const WaterState> water, double weight_density, const Vec3& about);

/// Returns the forces of the springs on the vessel; moment about `about` (W).
Wrench springs_on_barge(const SectionBody& body, const RigidMotion& motion, const RigidMotion& barge,
                        const Vec3& about);

/// Energies of a section [J], and the power of the water and, through the springs, of the vessel on it [W].
struct SectionEnergy {
  double kinetic = 0.0, stored = 0.0, power = 0.0, barge_power = 0.0;
};
SectionEnergy section_energy(const SectionBody& body, const RigidMotion& motion, const RigidMotion& barge,
                             std::span<const WaterState> water, double weight_density);

/// Returns the maximum depth of the ends of the tanks below the surface above them [m]; 0 without tanks.
double section_draught(const SectionBody& body, const RigidMotion& motion, std::span<const WaterState> water);

}  // namespace overbend
