/// Prescribed motion history of the vessel, with exact first and second derivatives.
///
/// Frames: W (x east, y north, z up), V fixed in the vessel (origin midship on the water, x forward, y port, z up).
/// Theory: docs/theory/vessel-motion.md.
#pragma once

#include <array>
#include <complex>
#include <limits>
#include <string>
#include <vector>

#include "base/aligned.h"
#include "base/vec.h"
#include "mechanics/build_up.h"
#include "mechanics/sea.h"
#include "mechanics/wave_kernel.h"
#include "model/model.h"

namespace overbend {

/// Position and motion of the vessel at an instant, as a rigid body.
struct RigidMotion {
  VesselPose pose;
  Vec3 velocity = Vec3::Zero(), acceleration = Vec3::Zero();  ///< Motion of V's origin, in W [m/s], [m/s2].
  Vec3 omega = Vec3::Zero(), alpha = Vec3::Zero();  ///< Angular velocity and acceleration, in W [rad/s], [rad/s2].
  std::array<double, 6> freedoms{};                 ///< Surge, sway, heave [m], roll, pitch, yaw [rad] from the mean.
};

/// One harmonic term of the motion: Re(amplitude exp(i omega t)).
struct MotionTerm {
  double omega = 0.0;                                  ///< [rad/s]
  std::array<std::complex<double>, 6> amplitude = {};  ///< [m], [rad]
};

/// Terms, one array per quantity, as the kernel reads them: each is padded to whole batches of eight.
class MotionTerms {
 public:
  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  MotionTerm operator[](std::size_t i) const;
  void add(const MotionTerm& term);
  ResponseView view() const;

 private:
  std::size_t count_ = 0;
  AlignedDoubles omega_;
  std::array<AlignedDoubles, 12> parts_;  ///< Real and imaginary parts of the amplitudes, alternating.
};

/// Natural cubic spline through the points of a recorded motion.
struct MotionSpline {
  std::vector<double> time;                         ///< [s]
  std::vector<std::array<double, 6>> value, curve;  ///< Freedoms and their second derivatives at the points.
};

/// Made by make_vessel_motion: the mean pose with a sum of harmonic terms, or a spline, or neither (fixed).
struct VesselMotionModel {
  VesselPose mean;
  Vec3 ahead_W = Vec3::UnitX();     ///< Horizontal unit vector of a move ahead: along the lay route.
  Vec3 reference_V = Vec3::Zero();  ///< Reference point of the translations [m].
  MotionTerms terms;
  MotionSpline spline;
  /// Time range of the description; there are no data beyond `last` [s].
  double first = -std::numeric_limits<double>::infinity(), last = std::numeric_limits<double>::infinity();
  /// Fractions of the sea's variance at frequencies below and above the RAO table.
  double below_table = 0.0, above_table = 0.0;

  bool moving() const { return !terms.empty() || !spline.time.empty(); }
};

/// Makes the motion that a model describes, in a given sea. RAOs apply to every component of the sea with its own
/// direction of travel; in a calm sea they leave the vessel at rest. Throws std::invalid_argument if the description
/// cannot be evaluated: the motion's file could not be read, or the motion is coupled.
VesselMotionModel make_vessel_motion(const Model& model, const Sea& sea);
/// Makes the motion of any body about its mean pose, where the sea is evaluated; a move ahead is towards its bow.
VesselMotionModel make_body_motion(const VesselDescription& body, const VesselPose& mean, const Sea& sea);

/// Returns the motion at time t [s], every freedom times the build-up factor; the derivatives include those of the
/// factor.
///
/// A recorded motion is continued before its first point by point reflection, so that it starts with continuous
/// acceleration, and holds its last value after the end. Does not allocate.
RigidMotion vessel_motion(const VesselMotionModel& motion, double t, const BuildUp& b);

/// A point fixed in the vessel: position, velocity, acceleration in W.
struct PointMotion {
  Vec3 place, velocity, acceleration;
};
PointMotion point_motion(const RigidMotion& m, const Vec3& p_V);

/// A direction fixed in the vessel, with its first and second time derivatives, in W.
struct DirectionMotion {
  Vec3 direction, rate, acceleration;
};
DirectionMotion direction_motion(const RigidMotion& m, const Vec3& d_V);

}  // namespace overbend
