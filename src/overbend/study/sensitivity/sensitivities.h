/// What the results of a lay hang on: the derivative of every result by every number of the model file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/model.h"
#include "results/sensitivity_results.h"
#include "results/static_results.h"
#include "statics/solver/statics.h"

namespace overbend {

struct SensitivityWish {
  std::vector<std::string> keys;  ///< Keys or names of inputs; empty: every number that the file has.
  bool one_sided = true;          ///< Whether contacts about to change are looked at.
};

/// Why there are none.
inline constexpr const char* kNoSensitivities =
    "no sensitivities: the equilibrium is about to snap to another place, so that no derivative exists";

/// At the equilibrium of a model whose description has its text. The pose of a vessel on mooring lines is held.
///
/// Results are taken from the equilibria to first order at the input plus and minus a small step, see
/// statics/solver/sensitivity.h, by the same recovery and checks as any: maxima are followed at the station of the
/// maximum. Empty where the tangent has no inverse there.
std::optional<SensitivityResults> find_sensitivities(const Model& model, const StaticSolution& solution,
                                                     const SensitivityWish& wish = {});

/// The derivatives of named results by named keys, row by row of the results; for searches. Nothing where one of them
/// is unknown or the tangent has no inverse.
std::optional<std::vector<double>> jacobian(const Model& model, const StaticSolution& solution,
                                            const std::vector<std::string>& results,
                                            const std::vector<std::string>& keys);

}  // namespace overbend
