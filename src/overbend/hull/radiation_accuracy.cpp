#include "hull/radiation_accuracy.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "hull/make_radiation.h"
#include "model/waves/rao_table.h"

namespace overbend {
namespace {

constexpr double kTolerated = 0.05;

/// Energy of the sea at each frequency of the file, from the nearest waves.
std::vector<double> wave_weights(const HydrodynamicData& data, const Sea& sea) {
  std::vector<double> weights(data.radiation.size(), sea.calm() ? 1.0 : 0.0);
  if (sea.calm()) return weights;
  for (const WaveComponent& wave : sea.components) {
    const auto nearest = std::min_element(data.radiation.begin(), data.radiation.end(),
                                          [&](const RadiationPoint& a, const RadiationPoint& b) {
                                            return std::abs(a.omega - wave.omega) < std::abs(b.omega - wave.omega);
                                          });
    weights[static_cast<std::size_t>(nearest - data.radiation.begin())] += wave.amplitude * wave.amplitude;
  }
  return weights;
}

/// Deviation of `made` from `reference`, relative to the maximum in the band of the weights.
double misfit(const std::vector<double>& made, const std::vector<double>& reference,
              const std::vector<double>& weights) {
  constexpr double kInBand = 0.01;  // of the maximum weight
  const double max_weight = *std::max_element(weights.begin(), weights.end());
  double max_value = 0.0, sum = 0.0, whole = 0.0;
  for (std::size_t k = 0; k < reference.size(); ++k) {
    if (weights[k] >= kInBand * max_weight) max_value = std::max(max_value, std::abs(reference[k]));
    sum += weights[k] * std::pow(made[k] - reference[k], 2);
    whole += weights[k];
  }
  if (!(max_value > 0.0) || !(whole > 0.0)) return 0.0;
  return std::max(std::sqrt(sum / whole), std::abs(made[0] - reference[0])) / max_value;
}

}  // namespace

std::vector<RadiationMisfit> radiation_misfits(const RadiationModel& model, const HydrodynamicData& data,
                                               const Sea& sea) {
  std::vector<RadiationMisfit> misfits;
  if (data.radiation.empty()) return misfits;
  std::vector<RadiationPoint> made;
  for (const RadiationPoint& point : data.radiation) made.push_back(radiation_at(model, point.omega));
  const std::vector<double> weights = wave_weights(data, sea);
  const auto values = [](const std::vector<RadiationPoint>& points, Mat6 RadiationPoint::*matrix, int mode) {
    std::vector<double> list;
    for (const RadiationPoint& point : points) list.push_back((point.*matrix)(mode, mode));
    return list;
  };
  for (int mode = 0; mode < 6; ++mode) {
    RadiationMisfit& found = misfits.emplace_back(RadiationMisfit{mode, 0.0, 0.0});
    for (const auto& [matrix, share] : {std::pair{&RadiationPoint::added_mass, &found.added_mass},
                                        std::pair{&RadiationPoint::damping, &found.damping}}) {
      *share = misfit(values(made, matrix, mode), values(data.radiation, matrix, mode), weights);
    }
  }
  return misfits;
}

Findings misfit_findings(const std::vector<RadiationMisfit>& misfits) {
  Findings findings;
  for (const RadiationMisfit& found : misfits) {
    if (found.added_mass <= kTolerated && found.damping <= kTolerated) continue;
    findings.push_back(
        Finding{FindingCode::radiation_misfit,
                "the time-domain radiation does not represent the hydrodynamic file in " +
                    std::string(kFreedomNames[static_cast<std::size_t>(found.mode)]) + ": its added mass deviates by " +
                    format_number(100.0 * found.added_mass, 3) + " % and its damping by " +
                    format_number(100.0 * found.damping, 3) +
                    " % of the maximum value in the waves; check its frequencies and units, and whether the "
                    "frequencies extend far enough"}
            .on(std::string(kFreedomNames[static_cast<std::size_t>(found.mode)]))
            .with("added_mass_error", found.added_mass, "1")
            .with("damping_error", found.damping, "1"));
  }
  return findings;
}

}  // namespace overbend
