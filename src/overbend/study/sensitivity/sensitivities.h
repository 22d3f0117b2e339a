/// Sensitivities of a lay: the derivative of every result by every number of the model file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/model.h"
#include "results/sensitivity_results.h"
#include "results/static_results.h"
#include "statics/solver/statics.h"

namespace overbend {

struct SensitivityRequest {
  std::vector<std::string> keys;  ///< Keys or names of inputs; empty: every number of the file.
  bool one_sided = true;          ///< True if contacts about to change are evaluated.
};

/// Reason that there are no sensitivities.
inline constexpr const char* kNoSensitivities =
    "no sensitivities: the equilibrium is about to snap through, so that no derivative exists";

/// Returns the sensitivities at the equilibrium of a model whose description has its text. The pose of a vessel on
/// mooring lines is fixed.
///
/// Results come from the first-order equilibria at the input plus and minus a small step, see
/// statics/solver/sensitivity.h, by the usual recovery and checks: maxima are followed at their station. Empty if the
/// tangent is singular.
std::optional<SensitivityResults> find_sensitivities(const Model& model, const StaticSolution& solution,
                                                     const SensitivityRequest& request = {});

/// Returns the derivatives of named results by named keys, row by row of the results; for searches. Empty if a name is
/// unknown or the tangent is singular.
std::optional<std::vector<double>> jacobian(const Model& model, const StaticSolution& solution,
                                            const std::vector<std::string>& results,
                                            const std::vector<std::string>& keys);

}  // namespace overbend
