/// What is told of a floating hull beside where it lies: how well its memory of radiated waves represents the file,
/// what damps its slow motions, what acts on it steadily. Plain data, SI units.
#pragma once

#include <string>
#include <vector>

namespace overbend {

/// One pair of modes of added mass and damping; errors as shares of the largest value, of sqrt(max ii * max jj).
struct RadiationEntryResult {
  std::string first, second;                     ///< "surge", "pitch".
  double tail_exponent = 0.0;                    ///< n of B ~ omega^-n above the file's frequencies.
  double added_mass_file = 0.0;                  ///< A_inf of the file [kg, kg m, kg m2].
  double added_mass_used = 0.0;                  ///< A_inf that belongs to the memory.
  double damping_error = 0.0, mass_error = 0.0;  ///< Largest errors of B and A over the file's frequencies [-].
};

/// A group of coupled modes, fitted together.
struct RadiationGroupResult {
  std::string modes;                 ///< "surge, pitch".
  std::string method;                ///< "state space" or "convolution".
  int order = 0;                     ///< Poles, a conjugate pair counted as two; 0: convolution.
  double least_damping = 0.0;        ///< Smallest eigenvalue of the fitted B over its largest, before `added_damping`.
  double least_damping_omega = 0.0;  ///< Where [rad/s].
  double added_damping = 0.0;        ///< Constant damping added, share of the largest B [-].
};

/// What damps a slow motion, as shares of critical damping. The drag of the lines is not in it.
struct ModeDampingResult {
  std::string mode;       ///< surge, sway, yaw.
  double period = 0.0;    ///< Natural, of the mode alone on the stiffness of the moorings [s].
  double critical = 0.0;  ///< [N s/m, N m s]
  double radiation = 0.0, drift = 0.0, current = 0.0, viscous = 0.0, station_keeping = 0.0;
  double total = 0.0;
  double radiation_file = 0.0;  ///< By the damping of the hydrodynamic file at that period.
};

/// Horizontal force and moment on the hull where it lies, along its axes.
struct SteadyLoad {
  double surge = 0.0, sway = 0.0;  ///< Forward, to port [N].
  double yaw = 0.0;                ///< Bow to port, about the centre of gravity [N m].
};

/// Of a hull with hydrodynamic coefficients.
struct HullResults {
  std::vector<RadiationEntryResult> entries;
  std::vector<RadiationGroupResult> groups;
  int states = 0;                          ///< Real numbers of the water's memory.
  std::vector<ModeDampingResult> damping;  ///< Surge, sway, yaw; empty where nothing keeps the hull's place.
  SteadyLoad drift;                        ///< Mean of the waves' drift.
  SteadyLoad current, wind;
  double below_table = 0.0, above_table = 0.0;  ///< Share of the sea's variance beyond the wave forces' table [-].
  /// Sideways current force with coefficients of 0.44 (a barge in deep water by UFC 4-159-03) and 1.2 (sharp edges in
  /// two dimensions) in place of the one in use [N]; zero where the current is not by strips.
  double current_least = 0.0, current_most = 0.0;
};

}  // namespace overbend
