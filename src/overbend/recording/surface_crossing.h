/// How fast the pipe goes into the water: what slamming, which the equations of motion leave out, would follow from.
#pragma once

#include <vector>

#include "system/assembly.h"

namespace overbend {

/// The fastest entry of a run.
class SurfaceCrossing {
 public:
  /// Looks where the line goes through the surface, at an accepted state with its surroundings; counts from t > 0.
  /// `water` as Surroundings::water of the line. `shift` is added to the arc length of the mesh that s() tells [m].
  void add(const LineState& state, double time, const std::vector<double>& water, const LineMesh& mesh,
           double shift = 0.0);

  /// Of the pipe into the water, vertical and relative to the surface, its part across the pipe; 0 without an entry
  /// [m/s].
  double speed() const { return speed_; }
  double s() const { return s_; }        ///< Arc length from the anchor [m].
  double time() const { return time_; }  ///< [s]

  std::vector<double> save() const { return {speed_, s_, time_}; }
  void restore(const std::vector<double>& saved);

 private:
  double speed_ = 0.0, s_ = 0.0, time_ = 0.0;
};

/// Slamming force per length rho/2 C_s D v^2 of a horizontal cylinder with C_s = 5.15 at first touch, the largest of
/// DNV-RP-C205 sec. 8.6 [N/m]. `density` [kg/m3], `diameter` [m], `speed` [m/s].
double slamming_force(double density, double diameter, double speed);

}  // namespace overbend
