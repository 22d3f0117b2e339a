/// Time-domain radiation model of a hull, made once from its frequency-domain coefficients.
#pragma once

#include <string>
#include <vector>

#include "base/finding.h"
#include "hull/radiation.h"

namespace overbend {

/// Accuracy of K for one pair of modes; errors relative to the maximum value, of sqrt(max ii * max jj).
struct RadiationEntryReport {
  int i = 0, j = 0;                              ///< 0 surge to 5 yaw, i <= j.
  double tail_exponent = 0.0;                    ///< n of B ~ omega^-n above the file's frequencies.
  double added_mass_file = 0.0;                  ///< A_inf of the file; that of K if the file has none.
  double added_mass_used = 0.0;                  ///< A_inf that belongs to K.
  double damping_error = 0.0, mass_error = 0.0;  ///< Maximum errors of B and A over the file's frequencies [-].
};

/// One group of coupled modes.
struct RadiationGroupReport {
  std::vector<int> modes;
  int order = 0;                          ///< Number of poles, a conjugate pair counted as two; 0: convolution.
  double min_fitted_damping = 0.0;        ///< Minimum eigenvalue of the fitted, scaled B, before constant damping [-].
  double min_fitted_damping_omega = 0.0;  ///< Its frequency [rad/s].
  double added_damping = 0.0;             ///< Added constant damping, share of the maximum B [-].
};

/// Accuracy of the radiation model.
struct RadiationReport {
  std::vector<RadiationEntryReport> entries;
  std::vector<RadiationGroupReport> groups;
  int states = 0;     ///< Number of real states of the memory.
  Findings findings;  ///< Warnings as sentences.
};

/// Radiation model with its report.
struct Radiated {
  RadiationModel model;
  RadiationReport report;
};

/// Returns kernel, matching A_inf and, for the state space, the fit. Falls back to convolution with a warning if no
/// order up to 20 represents damping and added mass within 1 %. `data` needs at least four frequencies.
Radiated make_radiation(const HydrodynamicData& data, Radiation kind);

/// Returns the damping [N s/m, ...] and added mass of the model at a frequency [rad/s], for comparison with the file.
RadiationPoint radiation_at(const RadiationModel& model, double omega);

}  // namespace overbend
