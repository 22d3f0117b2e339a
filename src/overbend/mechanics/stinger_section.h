/// A rigid section of a stinger in motion: inertia, weight, and what water and wires do to it.
///
/// Tanks are cut into strips along their axis. Each strip has Froude-Krylov force and buoyancy of the part of its axis
/// below the surface as it is at the instant, rho V (g + a_w), and across the axis the force of Morison, O'Brien,
/// Johnson and Schaaf (1950) on a moving cylinder, rho V C_a (a_w - a) + 1/2 rho C_d D l |u| u with u the velocity of
/// the water past the strip. Theory: docs/theory/stinger-motion.md. Places are in the frame V as the section rests.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mechanics/sea.h"
#include "mechanics/vessel_motion.h"
#include "model/model.h"

namespace overbend {

/// A length of a round tank.
struct TankStrip {
  Vec3 from_V = Vec3::Zero(), to_V = Vec3::Zero();  ///< Ends of its axis [m].
  double diameter = 0.0;                            ///< [m]
  double drag = 1.0, added_mass = 1.0;              ///< Across the axis [-].
  int tank = 0;
};

/// The structure's part that stays under water.
struct ImmersedBody {
  Vec3 place_V = Vec3::Zero();    ///< [m]
  Vec3 across_V = Vec3::UnitZ();  ///< Unit vector across the section, in its plane.
  double volume = 0.0;            ///< [m3]
  double added_mass = 0.0;        ///< Of motion across it [kg].
  double drag_area = 0.0;         ///< Cd A of motion across it [m2].
};

/// A wire or strut to the barge.
struct SectionSpring {
  Vec3 base_V = Vec3::Zero(), own_V = Vec3::Zero();  ///< On the barge, on the section [m].
  double stiffness = 0.0;                            ///< [N/m]
  double length = 0.0;                               ///< Unstressed [m].
  bool wire = true;                                  ///< Pulls only.
};

struct SectionBody {
  double mass = 0.0;              ///< Of the structure, tanks and ballast [kg].
  Vec3 center_V = Vec3::Zero();   ///< Centre of gravity [m].
  Mat3 inertia_V = Mat3::Zero();  ///< About it [kg m2].
  std::vector<TankStrip> strips;
  std::optional<ImmersedBody> immersed;
  std::vector<SectionSpring> springs;
};

/// The water that a section meets.
struct SectionSea {
  Sea sea;
  CurrentProfile current;
  double build_up = 0.0;        ///< Of the waves, before t = 0; the current flows in full as in statics [s].
  double weight_density = 0.0;  ///< [N/m3]
};

/// Velocity of a current at a height [m/s].
Vec3 current_at(const CurrentProfile& current, double z);

/// Water at the middles of the strips and at the immersed body, current included, with the section where it is.
/// `points` and `water` have a place for each; nothing is allocated.
void water_at_section(const SectionSea& sea, double time, const SectionBody& body, const RigidMotion& motion,
                      std::span<Vec3> points, std::span<WaterState> water);

/// How many places water_at_section() needs.
std::size_t water_places(const SectionBody& body);

/// A force and its moment about a point, W [N], [N m].
struct Wrench {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
};

/// Inertia minus all that acts on the section but rollers and hinges; moment about `about` (W). `barge` moves the
/// other ends of the springs.
Wrench unbalance_of_section(const SectionBody& body, const RigidMotion& motion, const RigidMotion& barge,
                            std::span<const WaterState> water, double weight_density, const Vec3& about);

/// What the springs do to the barge; moment about `about` (W).
Wrench springs_on_barge(const SectionBody& body, const RigidMotion& motion, const RigidMotion& barge,
                        const Vec3& about);

/// Energies of a section [J], and the powers on it of the water and of the barge through the springs [W].
struct SectionEnergy {
  double kinetic = 0.0, stored = 0.0, power = 0.0, barge_power = 0.0;
};
SectionEnergy section_energy(const SectionBody& body, const RigidMotion& motion, const RigidMotion& barge,
                             std::span<const WaterState> water, double weight_density);

/// Deepest end of the tanks below the surface over it [m]; 0 without tanks.
double section_draught(const SectionBody& body, const RigidMotion& motion, std::span<const WaterState> water);

}  // namespace overbend
