/// Waves radiated by a moving hull: added mass and memory [cummins1962], in the axes of HydrodynamicData.
///
///     F = A_inf v' + mu(t),    mu(t) = integral_0^inf K(tau) v(t - tau) dtau
///
/// is the force of the hull on the water; the hull feels its opposite. v: velocity of the reference point and rates of
/// roll, pitch, yaw [m/s, rad/s]. The model is constant, the memory a value that is advanced over steps of any length.
#pragma once

#include <complex>
#include <vector>

#include "model/description/hull_description.h"
#include "model/description/hydrodynamic_data.h"

namespace overbend {

using CMat6 = Eigen::Matrix<std::complex<double>, 6, 6>;

/// One decaying exponential of K: Re(residue exp(pole t)), with a state for each of the modes that drive it.
struct RadiationPole {
  std::complex<double> pole;      ///< Negative real part [1/s].
  CMat6 residue = CMat6::Zero();  ///< Symmetric; zero outside the modes of its group [N/m, N, N m].
  int group = 0;                  ///< Index in RadiationModel::groups.
};

/// K integrated twice on a fixed grid, for direct convolution: exact for velocities that are linear between its points.
struct RadiationSamples {
  double interval = 0.0;          ///< [s]
  std::vector<Mat6> once, twice;  ///< integral of K from 0 to i * interval, and the integral of that.
};

/// Constant data of a hull's radiation. Empty `poles` and `samples`: no memory.
struct RadiationModel {
  Radiation kind = Radiation::state_space;
  /// A_inf that belongs to K, which differs slightly from that of the file (RadiationReport). [kg, kg m, kg m2]
  Mat6 added_mass = Mat6::Zero();
  /// Damping without memory that makes the fit passive if it is not; mostly zero. [N s/m, ...]
  Mat6 constant_damping = Mat6::Zero();
  std::vector<std::vector<int>> groups;  ///< Coupled modes, 0 surge to 5 yaw.
  std::vector<RadiationPole> poles;      ///< State-space form.
  RadiationSamples samples;              ///< Convolution form.
};

/// Memory of K: real and imaginary part of each state, or the velocities on the convolution's grid. Of fixed size from
/// fresh_memory on; a copy restarts bit for bit.
struct RadiationMemory {
  std::vector<double> values;
};

/// Returns the memory of water at rest.
RadiationMemory make_bending_memory(const RadiationModel& model);

/// mu at the end of a step is force_at_rest_end + slope * v1, with v1 the velocity at its end.
struct RadiationStep {
  Vec6 force_at_rest_end = Vec6::Zero();
  Mat6 slope = Mat6::Zero();  ///< Symmetric [N s/m, N s, N m s].
};

/// Returns the force at the end of a step of length `h` > 0 [s] with initial velocity `v0`; exact for a linear velocity
/// in the step. Does not allocate.
RadiationStep radiation_step(const RadiationModel& model, const RadiationMemory& at_start, const Vec6& v0, double h);

/// Moves the memory to the end of that step, where the velocity is `v1`. Does not allocate.
void advance(const RadiationModel& model, RadiationMemory& memory, const Vec6& v0, const Vec6& v1, double h);

/// Returns mu at the memory's time, with velocity `v`.
Vec6 radiation_force(const RadiationModel& model, const RadiationMemory& memory, const Vec6& v);

}  // namespace overbend
