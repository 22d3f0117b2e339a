/// Diagnostics of the hull model: accuracy of the radiation memory compared with the hydrodynamic file, damping of the
/// low-frequency motions, steady loads. Plain data, SI units.
#pragma once

#include <string>
#include <vector>

namespace overbend {

/// One pair of modes of added mass and damping; errors relative to the maximum, or to sqrt(max ii * max jj) for
/// coupling.
struct RadiationEntryResult {
  std::string first, second;                     ///< "surge", "pitch".
  double tail_exponent = 0.0;                    ///< Exponent n of the high-frequency tail, B ~ omega^-n above the
                                                 ///< file's frequencies.
  double added_mass_file = 0.0;                  ///< A_inf of the file [kg, kg m, kg m2].
  double added_mass_used = 0.0;                  ///< A_inf consistent with the radiation memory [kg, kg m, kg m2].
  double damping_error = 0.0, mass_error = 0.0;  ///< Maximum errors of B and A over the file's frequencies [-].
};

/// A group of coupled modes, fitted together.
struct RadiationGroupResult {
  std::string modes;                ///< "surge, pitch".
  std::string method;               ///< "state space" or "convolution".
  int order = 0;                    ///< Poles, a conjugate pair counted as two; 0: convolution.
  double min_fitted_damping = 0.0;  ///< Minimum eigenvalue of the fitted B over its maximum, before `added_damping`
                                    ///< [-].
  double min_fitted_damping_omega = 0.0;  ///< Frequency of that minimum [rad/s].
  double added_damping = 0.0;             ///< Constant damping added, as a share of the maximum B [-].
};

/// Damping of a low-frequency motion as shares of critical damping, without the drag of the lines.
struct ModeDampingResult {
  std::string mode;       ///< surge, sway, yaw.
  double period = 0.0;    ///< Natural period of the mode alone on the mooring stiffness [s].
  double critical = 0.0;  ///< [N s/m, N m s]
  double radiation = 0.0, drift = 0.0, current = 0.0, viscous = 0.0, station_keeping = 0.0;
  double total = 0.0;
  double radiation_file = 0.0;  ///< From the damping of the hydrodynamic file at that period.
};

/// Horizontal force and moment on the hull in its equilibrium position, in its axes.
struct SteadyLoad {
  double surge = 0.0, sway = 0.0;  ///< Forward, to port [N].
  double yaw = 0.0;                ///< Bow to port, about the centre of gravity [N m].
};

/// Results of a hull with hydrodynamic coefficients.
struct HullResults {
  std::vector<RadiationEntryResult> entries;
  std::vector<RadiationGroupResult> groups;
  int states = 0;                          ///< Number of real states of the radiation memory.
  std::vector<ModeDampingResult> damping;  ///< Surge, sway, yaw; empty without station keeping.
  SteadyLoad drift;                        ///< Mean wave drift.
  SteadyLoad current, wind;
  double below_table = 0.0, above_table = 0.0;  ///< Share of the wave spectrum's variance outside the table of wave
                                                ///< forces [-].
  /// Lateral current force with coefficients of 0.44 (a barge in deep water by UFC 4-159-03) and 1.2 (sharp edges in
  /// two dimensions) in place of the one in use [N]; zero unless the current is calculated by strips.
  double min_current_force = 0.0, max_current_force = 0.0;
};

}  // namespace overbend
