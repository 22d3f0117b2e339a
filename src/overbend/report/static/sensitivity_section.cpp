#include "report/static/sensitivity_section.h"

#include <fmt/format.h>

#include "report/page/json_number.h"
#include "results/fields/sensitivity_texts.h"

namespace overbend {
namespace {

constexpr std::size_t kBars = 10;

/// Explanation of a bar whose derivative is one-sided.
std::string one_sided_note(const SensitivityInput& input, const Derivative& slope) {
  return fmt::format("{}: {}; beyond, the derivative is {} times that here", input.name, contact_text(input, slope),
                     slope.value != 0.0 ? format_number(slope.beyond / slope.value, 3) : "many");
}

/// Effects in the unit of the result.
Json tornado_data(const SensitivityResults& s, std::size_t result, const std::vector<std::size_t>& inputs) {
  const SensitivityOutput& output = s.results[result];
  const ShownUnit unit = shown_unit(output.name, output.unit);
  Json bars = Json::array(), notes = Json::array();
  for (const std::size_t i : inputs) {
    const SensitivityInput& input = s.inputs[i];
    const Derivative& slope = s.at(result, i);
    const double low = s.effect(result, i, -1.0), high = s.effect(result, i, 1.0);
    bars.push_back({{"name", input.name + " \u00b1 " + tolerance_text(input)},
                    {"low", json_number(low * unit.factor)},
                    {"high", json_number(high * unit.factor)},
                    {"low_label", result_text(output, low, true)},
                    {"high_label", result_text(output, high, true) + (slope.one_sided() ? " *" : "")}});
    if (slope.one_sided()) notes.push_back(one_sided_note(input, slope));
  }
  return {{"title", output.text + ", " + result_text(output, output.value, false)},
          {"unit", unit.name},
          {"digits", unit.digits},
          {"bars", bars},
          {"notes", notes}};
}

Table derivative_table(const SensitivityResults& s, std::size_t result) {
  const SensitivityOutput& output = s.results[result];
  Table table{output.text,
              {TableColumn("Input"), TableColumn::texts("Value"), TableColumn::texts("Tolerance"),
               TableColumn::texts("Derivative", "SI"), TableColumn::texts("Effect upwards"),
               TableColumn::texts("Effect downwards"), TableColumn("Changes contact")},
              ""};
  for (const std::size_t i : s.most_influential_inputs(result, s.inputs.size())) {
    const SensitivityInput& input = s.inputs[i];
    const Derivative& slope = s.at(result, i);
    table.row({input.name, value_text(input, input.value),
               tolerance_text(input) + (input.own_tolerance ? "" : " (default)"), format_number(slope.value, 6),
               result_text(output, s.effect(result, i, 1.0), true),
               result_text(output, s.effect(result, i, -1.0), true), contact_text(input, slope)});
  }
  return table;
}

}  // namespace

Blocks sensitivity_section(const SensitivityResults& s) {
  Blocks figures, tables;
  for (std::size_t r = 0; r < s.results.size(); ++r) {
    if (!s.results[r].key) continue;
    const std::vector<std::size_t> inputs = s.most_influential_inputs(r, kBars);
    if (inputs.empty()) continue;
    const std::string caption = s.results[r].text +
                                ": effect of the tolerance of each input, the others unchanged; dark: input "
                                "increased, light: decreased";
    figures += block::figure({"tornado", caption, {"whole"}}, tornado_data(s, r, inputs));
    tables += derivative_table(s, r);
  }
  if (figures.empty()) return {};
  return block::section("sensitivities", "Sensitivity analysis",
                        block::list(texts(s.assumptions)) + figures +
                            block::folded("Derivatives with respect to all inputs", tables, false));
}

}  // namespace overbend
