/// Waves that a moving hull radiates: added mass and memory [cummins1962], in the axes of HydrodynamicData.
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
  int group = 0;                  ///< Into RadiationModel::groups.
};

/// K integrated twice on a fixed grid, for direct convolution: exact for velocities that are linear between its points.
struct RadiationSamples {
  double interval = 0.0;          ///< [s]
  std::vector<Mat6> once, twice;  ///< integral of K from 0 to i * interval, and the integral of that.
};

/// What is constant of a hull's radiation. Empty `poles` and `samples`: no memory.
struct RadiationModel {
  Radiation kind = Radiation::state_space;
  /// A_inf that belongs to K, which is not quite that of the file (RadiationReport). [kg, kg m, kg m2]
  Mat6 added_mass = Mat6::Zero();
  /// Damping without memory that makes the fit passive where the fit alone is not quite; mostly zero. [N s/m, ...]
  Mat6 constant_damping = Mat6::Zero();
  std::vector<std::vector<int>> groups;  ///< Modes that are coupled with each other, 0 surge to 5 yaw.
  std::vector<RadiationPole> poles;      ///< Of the state space.
  RadiationSamples samples;              ///< Of the convolution.
};

/// What K remembers of the past: real and imaginary part of each state, or the velocities on the convolution's grid.
/// Fixed size from fresh_memory on; copied it resumes bit for bit.
struct RadiationMemory {
  std::vector<double> values;
};

/// Memory of water that was at rest.
RadiationMemory fresh_memory(const RadiationModel& model);

/// mu at the end of a step is force_at_rest_end + slope * v1, v1 the velocity at its end.
struct RadiationStep {
  Vec6 force_at_rest_end = Vec6::Zero();
  Mat6 slope = Mat6::Zero();  ///< Symmetric [N s/m, N s, N m s].
};

/// The force at the end of a step of length `h` > 0 [s], which begins with velocity `v0`; exact where the velocity is
/// linear in the step. Does not allocate.
RadiationStep radiation_step(const RadiationModel& model, const RadiationMemory& at_start, const Vec6& v0, double h);

/// Moves the memory to the end of that step, where the velocity is `v1`. Does not allocate.
void advance(const RadiationModel& model, RadiationMemory& memory, const Vec6& v0, const Vec6& v1, double h);

/// mu where the memory stands, `v` the velocity there.
Vec6 radiation_force(const RadiationModel& model, const RadiationMemory& memory, const Vec6& v);

}  // namespace overbend
