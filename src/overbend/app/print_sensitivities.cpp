#include "app/print_sensitivities.h"

#include <fmt/format.h>

#include "results/fields/sensitivity_texts.h"

namespace overbend {
namespace {

constexpr std::size_t kForemost = 3;

std::string one_sided_text(const SensitivityInput& input, const Derivative& slope) {
  return slope.one_sided() ? " (one-sided: " + contact_text(input, slope) + ")" : "";
}

}  // namespace

std::string sensitivity_lines(const SensitivityResults& s) {
  std::string lines = "Sensitivities (effect of the tolerance):\n";
  for (std::size_t r = 0; r < s.results.size(); ++r) {
    if (!s.results[r].key) continue;
    lines += fmt::format("  {}\n", s.results[r].text);
    for (const std::size_t i : s.most_influential_inputs(r, kForemost)) {
      lines += fmt::format("    {:<14}{} + {}{}\n", result_text(s.results[r], s.effect(r, i, 1.0), true),
                           s.inputs[i].name, tolerance_text(s.inputs[i]), one_sided_text(s.inputs[i], s.at(r, i)));
    }
  }
  return lines + fmt::format("  {} inputs in {:.2f} s\n", s.inputs.size(), s.wall_time);
}

}  // namespace overbend
