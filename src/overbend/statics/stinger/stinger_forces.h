/// What acts on the sections of a stinger besides the pipe, at rest: weight, buoyancy, ballast, springs, the current.
/// Frame W, SI.
///
/// Buoyancy of the body is constant; that of a tank is gamma pi/4 d^2 per length of its axis below z = 0, where the
/// water line cuts the axis sharply, and acts in the middle of that part. Ballast is water of a fraction of the tank's
/// volume, its weight at mid-length: it does not run to the lower end.
#pragma once

#include <vector>

#include "model/model.h"

namespace overbend {

/// A force at a point.
struct PointForce {
  Vec3 force_W = Vec3::Zero();  ///< [N]
  Vec3 at_W = Vec3::Zero();     ///< [m]
};

/// A tank in still water.
struct FloatingTank {
  double weight = 0.0;                ///< With ballast [N].
  Vec3 weight_at_W = Vec3::Zero();    ///< [m]
  double buoyancy = 0.0;              ///< [N]
  Vec3 buoyancy_at_W = Vec3::Zero();  ///< Middle of the part of the axis below the water; of a dry tank mid-length [m].
  double submerged = 0.0;             ///< Fraction of its length [-].
  double draught = 0.0;               ///< Of its deeper end below the water; 0 of a dry tank [m].
};

/// Weight of the water that a tank holds when it is full [N].
double tank_capacity(const StingerTankDescription& tank, double water_weight_density);

/// How a tank of section `section` of the model floats where the supports and the vessel now lie.
FloatingTank floating_tank(const Model& model, std::size_t section, const StingerTankDescription& tank);

/// Pull of a spring of a section, negative where a strut is pressed; a wire does not push [N].
double spring_force(const StingerSectionDescription& section, const StingerSection& now,
                    const StingerSpringDescription& spring);

/// A point of the ramp's frame S in that of the vessel, V [m].
Vec3 point_in_vessel(const Model& model, const Vec3& p_S);

/// From the hinge of a section, where it rests, to the last box that it carries, else to the farthest of its tanks; V
/// [m].
Vec3 section_reach_V(const Model& model, std::size_t section);

/// Even parts of a tank's axis in which water flows past it.
int tank_strips(double length);

/// Weight, buoyancy and the drag of the current on one section, tanks with ballast.
std::vector<PointForce> floating_forces(const Model& model, std::size_t section);

/// Forces on one section: these, and its springs from the vessel.
std::vector<PointForce> section_forces(const Model& model, std::size_t section);

/// The hinge of a section, and the axis about which a positive angle turns the tip down.
struct HingeAxis {
  Vec3 at_W, axis_W;
};
HingeAxis hinge_axis(const Model& model, std::size_t section);

/// Moment of forces about a hinge, positive when it turns the tip down [N m].
double moment_about(const HingeAxis& hinge, const std::vector<PointForce>& forces);

/// Moment of inertia about the hinge of a section of it and all those behind, with ballast and the water that goes
/// along [kg m2]. Mass of the body with its radius of gyration, of an even rod from hinge to last box where none is
/// given; tanks as rods; added mass of a tank across its axis over its part below the water.
double inertia_about_hinge(const Model& model, std::size_t section);

}  // namespace overbend
