/// Maximum speed at which the pipe enters the water, for slamming, which the equations of motion neglect.
#pragma once

#include <vector>

#include "system/assembly.h"

namespace overbend {

/// The fastest water entry of a run.
class SurfaceCrossing {
 public:
  /// Finds the intersections of the line with the surface, at an accepted state with its surroundings; counts from t >
  /// 0. `water` as in Surroundings::water of the line. `shift` [m] is added to the arc length of the mesh in s().
  void add(const LineState& state, double time, const std::vector<double>& water, const LineMesh& mesh,
           double shift = 0.0);

  /// Vertical speed of the pipe into the water, relative to the surface, its component across the pipe; 0 without an
  /// entry [m/s].
  double speed() const { return speed_; }
  double s() const { return s_; }        ///< Arc length from the anchor [m].
  double time() const { return time_; }  ///< [s]

  std::vector<double> save() const { return {speed_, s_, time_}; }
  void restore(const std::vector<double>& saved);

 private:
  double speed_ = 0.0, s_ = 0.0, time_ = 0.0;
};

/// Slamming force per length rho/2 C_s D v^2 of a horizontal cylinder with C_s = 5.15 at first contact, the maximum of
/// DNV-RP-C205 sec. 8.6 [N/m]. `density` [kg/m3], `diameter` [m], `speed` [m/s].
double slamming_force(double density, double diameter, double speed);

}  // namespace overbend
