/// Radiation of a hull in time, made once from its coefficients in frequency.
#pragma once

#include <string>
#include <vector>

#include "base/finding.h"
#include "hull/radiation.h"

namespace overbend {

/// How well K represents one pair of modes; errors as shares of the largest value, of sqrt(max ii * max jj).
struct RadiationEntryReport {
  int i = 0, j = 0;                              ///< 0 surge to 5 yaw, i <= j.
  double tail_exponent = 0.0;                    ///< n of B ~ omega^-n above the file's frequencies.
  double added_mass_file = 0.0;                  ///< A_inf of the file; that of K where it has none.
  double added_mass_used = 0.0;                  ///< A_inf that belongs to K.
  double damping_error = 0.0, mass_error = 0.0;  ///< Largest errors of B and A over the file's frequencies [-].
};

/// One group of coupled modes.
struct RadiationGroupReport {
  std::vector<int> modes;
  int order = 0;                     ///< Poles, a conjugate pair counted as two; 0: convolution.
  double least_damping = 0.0;        ///< Smallest eigenvalue of the fitted, scaled B, before constant damping [-].
  double least_damping_omega = 0.0;  ///< Where [rad/s].
  double added_damping = 0.0;        ///< Constant damping added, share of the largest B [-].
};

struct RadiationReport {
  std::vector<RadiationEntryReport> entries;
  std::vector<RadiationGroupReport> groups;
  int states = 0;     ///< Real numbers of memory.
  Findings findings;  ///< Plain sentences.
};

struct Radiated {
  RadiationModel model;
  RadiationReport report;
};

/// Kernel, A_inf that goes with it and, for the state space, the fit. Falls back to convolution with a warning where no
/// order up to 20 represents damping and added mass within 1 %. `data` needs at least four frequencies.
Radiated make_radiation(const HydrodynamicData& data, Radiation kind);

/// The damping [N s/m, ...] and added mass that the model has at a frequency [rad/s], for comparison with the file's.
RadiationPoint radiation_at(const RadiationModel& model, double omega);

}  // namespace overbend
