/// Linear potential-flow coefficients of a hull, in SI: added mass, radiation damping, wave excitation, mean drift and
/// hydrostatic stiffness. Axes x forward, y port, z up. Modes: surge, sway, heave, roll, pitch, yaw.
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"

namespace overbend {

using Mat6 = Eigen::Matrix<double, 6, 6>;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using CVec6 = Eigen::Matrix<std::complex<double>, 6, 1>;

/// Added mass and radiation damping at one frequency.
struct RadiationPoint {
  double omega = 0.0;              ///< [rad/s]
  Mat6 added_mass = Mat6::Zero();  ///< [kg, kg m, kg m2]
  Mat6 damping = Mat6::Zero();     ///< [N s/m, N s, N m s]
};

/// Axes of a table by frequency and heading. Heading: direction of travel of the waves, anticlockwise from the hull's x
/// axis, in [0, 2 pi).
struct HeadingTable {
  std::vector<double> omega;    ///< Ascending [rad/s].
  std::vector<double> heading;  ///< Ascending [rad].
  std::size_t index(std::size_t i_omega, std::size_t i_heading) const { return i_omega * heading.size() + i_heading; }
};

struct HydrodynamicData {
  std::string source;  ///< File or common stem of the files.
  /// Reference point of all matrices and forces: the model's centre of gravity, frame V [m].
  Vec3 origin_V = Vec3::Zero();
  /// Reference point of the file's values if it differs; the values were transferred from it. Frame V [m].
  std::optional<Vec3> file_origin_V;
  double water_density = 0.0, gravity = 0.0;  ///< Used to make the values dimensional [kg/m3, m/s2].
  std::vector<std::string> notes;             ///< Conversions, assumptions and omissions of the reader: sentences.

  std::vector<RadiationPoint> radiation;  ///< By ascending, finite and positive frequency.
  Mat6 added_mass_infinite = Mat6::Zero();
  bool has_infinite = false, has_zero = false;
  Mat6 added_mass_zero = Mat6::Zero();

  HeadingTable excitation;
  /// Force per wave amplitude X: F = Re(a X exp(i omega t)) for a crest over the origin at t = 0 (phases lead). By
  /// HeadingTable::index. [N/m, N]
  std::vector<CVec6> force;

  HeadingTable drift;            ///< Axes of `mean_drift`; empty if there is none.
  std::vector<Vec6> mean_drift;  ///< Per squared amplitude: surge, sway and yaw; other modes zero. [N/m2, N/m]

  Mat6 hydrostatic_stiffness = Mat6::Zero();  ///< Weight included: C44 = M g GM. [N/m, N, N m]
};

}  // namespace overbend
