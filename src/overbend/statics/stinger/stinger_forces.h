/// Static forces on the sections of a stinger other than those of the pipe: weight, buoyancy, ballast, springs,
/// current. Frame W, SI.
///
/// Buoyancy of the body is constant. That of a tank is gamma pi/4 d^2 per length of its axis below z = 0, cut off
/// sharply at the water line, and acts at the middle of that part. Ballast is water in a fraction of the tank's volume
/// with its weight at mid-length: it does not run to the lower end.
#pragma once

#include <vector>

#include "model/model.h"

namespace overbend {

/// Force at a point.
struct PointForce {
  Vec3 force_W = Vec3::Zero();  ///< [N]
  Vec3 at_W = Vec3::Zero();     ///< [m]
};

/// Tank in still water.
struct FloatingTank {
  double weight = 0.0;                ///< Including ballast [N].
  Vec3 weight_at_W = Vec3::Zero();    ///< [m]
  double buoyancy = 0.0;              ///< [N]
  Vec3 buoyancy_at_W = Vec3::Zero();  ///< Middle of the part of the axis below the water; mid-length of a dry tank [m].
  double submerged = 0.0;             ///< Fraction of its length [-].
  double draught = 0.0;               ///< Depth of its deeper end below the water; 0 for a dry tank [m].
};

/// Weight of the water in a full tank [N].
double tank_capacity(const StingerTankDescription& tank, double water_weight_density);

/// Returns weight and buoyancy of a tank of section `section` at the present angles of the supports and pose of the
/// vessel.
FloatingTank floating_tank(const Model& model, std::size_t section, const StingerTankDescription& tank);

/// Tension of a spring of a section, negative for a strut in compression; a wire takes no compression [N].
double spring_force(const StingerSectionDescription& section, const StingerSection& turned_section,
                    const StingerSpringDescription& spring);

/// Transforms a point from the ramp frame S to the vessel frame V [m].
Vec3 point_in_vessel(const Model& model, const Vec3& p_S);

/// Vector from the hinge of a section at its present angle to the last box that it carries, otherwise to its farthest
/// tank; V [m].
Vec3 section_reach_V(const Model& model, std::size_t section);

/// Number of equal parts of a tank's axis for the drag of water.
int tank_strips(double length);

/// Weight, buoyancy and current drag on one section; tanks include ballast.
std::vector<PointForce> floating_forces(const Model& model, std::size_t section);

/// Forces on one section: floating_forces() and its springs from the vessel.
std::vector<PointForce> section_forces(const Model& model, std::size_t section);

/// Hinge of a section, and the axis about which a positive angle turns the tip down.
struct HingeAxis {
  Vec3 at_W, axis_W;
};
/// Returns the hinge axis of a section at the model's mean pose, W.
HingeAxis hinge_axis(const Model& model, std::size_t section);

/// Moment of forces about a hinge, positive tip down [N m].
double moment_about(const HingeAxis& hinge, const std::vector<PointForce>& forces);

/// Moment of inertia, about the hinge of a section, of that section and all those behind it, with ballast and added
/// mass [kg m2]. Mass of the body with its radius of gyration, or that of a uniform rod from hinge to last box if none
/// is given; tanks as rods; added mass of a tank across its axis over its part below the water.
double inertia_about_hinge(const Model& model, std::size_t section);

}  // namespace overbend
