#include "statics/recovery/history_effect.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/ranges.h"
#include "statics/recovery/recovery.h"

namespace overbend {
namespace {

bool has_yielded(const StaticSolution& solution) {
  return ranges::any_of(solution.bending, [](const BendingMemory& memory) { return memory.stamp != 0; });
}

/// Maximum strains with the two histories.
struct Strains {
  double laying = 0.0, monotonic = 0.0;

  double ratio() const { return std::max(laying, monotonic) / std::max(std::min(laying, monotonic), 1e-12); }
  std::string text(const std::string& place) const {
    return fmt::format("{} {:.3f} % after passing the supports (laying), {:.3f} % bent directly (monotonic)", place,
                       100.0 * laying, 100.0 * monotonic);
  }
};

double max_strain_next_to(const StructureResult& structure) {
  return std::max(structure.upper.strain, structure.lower.strain);
}

}  // namespace

void note_history_effect(const Model& model, const StaticSolution& solution, StaticResults& results) {
  constexpr double kSmall = 1.05;
  if (solution.past.solution || !results.overbend || !has_yielded(solution)) return;
  Model with = model;
  LayHistory& history = with.description.statics.history;
  const bool lays = history == LayHistory::laying;
  history = lays ? LayHistory::monotonic : LayHistory::laying;
  const StaticOutcome outcome = solve_statics(with, &solution);
  if (!outcome.solution) {
    results.findings.push_back(
        Finding{FindingCode::history_dependent_strain,
                fmt::format("the pipe has yielded, and with analysis.static.history: {} there is no "
                            "equilibrium to compare with: {}",
                            lays ? "monotonic" : "laying", outcome.failure->what)}
            .on("pipe"));
    return;
  }
  const StaticResults compared = recover_state(with, *outcome.solution);
  const auto strains = [&](double actual, double alternative) {
    return lays ? Strains{actual, alternative} : Strains{alternative, actual};
  };
  const Strains overbend =
      strains(results.overbend->strain.value, compared.overbend ? compared.overbend->strain.value : 0.0);
  double ratio = overbend.ratio();
  std::string text = overbend.text("overbend");
  for (std::size_t i = 0; i < std::min(results.structures.size(), compared.structures.size()); ++i) {
    const Strains at_structure =
        strains(max_strain_next_to(results.structures[i]), max_strain_next_to(compared.structures[i]));
    ratio = std::max(ratio, at_structure.ratio());
    text += at_structure.text(fmt::format("; next to '{}'", results.structures[i].name));
  }
  text = "the strain of pipe that yields depends on its loading history (analysis.static.history): " + text;
  if (ratio > kSmall) {
    results.findings.push_back(
        Finding{FindingCode::history_dependent_strain, text}.on("pipe").with("strain_ratio", ratio, "1"));
  } else {
    results.assumptions.push_back({AssumptionRank::other, text});
  }
}

}  // namespace overbend
