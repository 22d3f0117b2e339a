#include "report/static/sensitivity_section.h"

#include <fmt/format.h>

#include "report/page/html.h"
#include "results/fields/sensitivity_words.h"

namespace overbend {
namespace {

constexpr std::size_t kBars = 10;
constexpr double kRow = 24.0, kLabels = 470.0, kCentre = 640.0, kHalf = 160.0, kWidth = 920.0;

/// A bar from the middle; the tolerance upwards is the darker of the two.
std::string bar(double effect, double scale, double y, bool up) {
  const double length = kHalf * std::abs(effect) / scale;
  return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"/>\n",
                     effect < 0.0 ? kCentre - length : kCentre, y, length, kRow - 8.0, up ? "#2f6f9f" : "#a9c8de");
}

std::string text(double x, double y, const char* anchor, const std::string& words, const char* css = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, css,
                     html::escape(words));
}

std::string tornado(const SensitivityResults& s, std::size_t result, const std::vector<std::size_t>& inputs) {
  const double scale = s.largest_effect(result, inputs.front());
  const double height = kRow * static_cast<double>(inputs.size()) + 34.0;
  std::string svg = fmt::format("<svg viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"{}\">\n", kWidth, height,
                                html::escape("Effect of the tolerances on: " + s.results[result].text));
  svg += text(8.0, 16.0, "start",
              s.results[result].text + ", " + result_text(s.results[result], s.results[result].value, false),
              " class=\"title\"");
  double y = 30.0;
  for (const std::size_t i : inputs) {
    const bool marked = s.at(result, i).one_sided();
    svg += text(kLabels, y + 13.0, "end", s.inputs[i].name + " \u00b1 " + tolerance_text(s.inputs[i]));
    svg += bar(s.effect(result, i, -1.0), scale, y, false);
    svg += bar(s.effect(result, i, 1.0), scale, y, true);
    svg +=
        text(kWidth - 6.0, y + 13.0, "end",
             result_text(s.results[result], s.effect(result, i, 1.0), true) + (marked ? " *" : ""), " class=\"soft\"");
    y += kRow;
  }
  svg += fmt::format("<line class=\"domain\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"26\" y2=\"{1:.1f}\"/>\n</svg>\n",
                     kCentre, y);
  return svg;
}

/// What is marked with a star.
std::vector<std::string> notes(const SensitivityResults& s, std::size_t result,
                               const std::vector<std::size_t>& inputs) {
  std::vector<std::string> list;
  for (const std::size_t i : inputs) {
    const Derivative& slope = s.at(result, i);
    if (!slope.one_sided()) continue;
    list.push_back(fmt::format("{}: {}; beyond, the derivative is {} times that here", s.inputs[i].name,
                               contact_text(s.inputs[i], slope),
                               slope.value != 0.0 ? format_number(slope.beyond / slope.value, 3) : "many"));
  }
  return list;
}

std::string table_of(const SensitivityResults& s, std::size_t result) {
  html::Table table(s.results[result].text, {{"Input", "", true},
                                             {"Value", ""},
                                             {"Tolerance", ""},
                                             {"Derivative", "SI"},
                                             {"Effect upwards", ""},
                                             {"Effect downwards", ""},
                                             {"Changes contact", "", true}});
  for (const std::size_t i : s.foremost(result, s.inputs.size())) {
    const SensitivityInput& input = s.inputs[i];
    const Derivative& slope = s.at(result, i);
    table.row({input.name, value_text(input, input.value),
               tolerance_text(input) + (input.own_tolerance ? "" : " (usual)"), format_number(slope.value, 6),
               result_text(s.results[result], s.effect(result, i, 1.0), true),
               result_text(s.results[result], s.effect(result, i, -1.0), true), contact_text(input, slope)});
  }
  return table.str();
}

}  // namespace

std::string sensitivity_section(const SensitivityResults& s, int& figure) {
  std::string figures, tables;
  for (std::size_t r = 0; r < s.results.size(); ++r) {
    if (!s.results[r].key) continue;
    const std::vector<std::size_t> inputs = s.foremost(r, kBars);
    if (inputs.empty()) continue;
    const std::vector<std::string> stars = notes(s, r, inputs);
    figures += "<figure>\n<div class=\"panel\">\n" + tornado(s, r, inputs) + "</div>\n" +
               (stars.empty() ? "" : "<p>* One-sided:</p>\n" + html::list(stars)) +
               fmt::format(
                   "<figcaption>Figure {}. {}: effect of the tolerance of each input, the others unchanged; dark: "
                   "input increased, light: decreased</figcaption>\n</figure>\n",
                   ++figure, html::escape(s.results[r].text));
    tables += table_of(s, r);
  }
  if (figures.empty()) return "";
  std::string body =
      html::list(texts(s.assumptions)) + figures + html::folded("Derivatives by all inputs", tables, false);
  return html::section("sensitivities", "What this result hangs on", body);
}

}  // namespace overbend
