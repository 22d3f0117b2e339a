#include "report/page/curve_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "report/page/html.h"

namespace overbend {
namespace {

constexpr double kWidth = 960.0, kHeight = 340.0, kLeft = 78.0, kRight = 16.0, kTop = 14.0, kBottom = 46.0;
constexpr std::array kColours = {"#0b6fa4", "#c4472b", "#2e8b57", "#8a5fb0",
                                 "#b8860b", "#008b8b", "#a0522d", "#4a5a6a"};

struct Span {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double size() const { return high - low; }
};

/// A step of 1, 2 or 5 times a power of ten that divides a span into some six parts.
double step_for(double span) {
  const double rough = span / 6.0, power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (rough <= factor * power) return factor * power;
  }
  return 10.0 * power;
}

/// Multiples of the step within a span.
std::vector<double> ticks(const Span& span) {
  const double step = step_for(span.size());
  const auto first = static_cast<long>(std::ceil(span.low / step)),
             last = static_cast<long>(std::floor(span.high / step));
  std::vector<double> all;
  for (long i = first; i <= last; ++i) all.push_back(static_cast<double>(i) * step);
  return all;
}

class Frame {
 public:
  explicit Frame(const CurveChart& chart) {
    for (const auto* list : {&chart.curves, &chart.ground, &chart.water}) {
      for (const ChartCurve& curve : *list) {
        for (const auto& [x, y] : curve.points) {
          if (list == &chart.curves) x_.take(x);
          y_.take(y);
        }
      }
    }
    if (!(x_.size() > 0.0)) x_.high = x_.low + 1.0;
    const double margin = y_.size() > 0.0 ? 0.05 * y_.size() : 1.0;
    y_.low -= margin;
    y_.high += margin;
  }

  double x(double value) const { return kLeft + (value - x_.low) / x_.size() * (kWidth - kLeft - kRight); }
  double y(double value) const { return kHeight - kBottom - (value - y_.low) / y_.size() * (kHeight - kTop - kBottom); }

  std::string axes(const CurveChart& chart) const {
    std::string out;
    for (const double tick : ticks(x_)) {
      out += fmt::format(
          "<path d=\"M{0:.1f} {1} V{2}\" class=\"grid\"/><text x=\"{0:.1f}\" y=\"{3}\" "
          "text-anchor=\"middle\">{4:.6g}</text>\n",
          x(tick), kTop, kHeight - kBottom, kHeight - kBottom + 16.0, tick);
    }
    for (const double tick : ticks(y_)) {
      out += fmt::format(
          "<path d=\"M{0} {1:.1f} H{2}\" class=\"grid\"/><text x=\"{3}\" y=\"{4:.1f}\" "
          "text-anchor=\"end\">{5:.6g}</text>\n",
          kLeft, y(tick), kWidth - kRight, kLeft - 6.0, y(tick) + 4.0, tick);
    }
    return out +
           fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
                       0.5 * (kLeft + kWidth - kRight), kHeight - 10.0, html::escape(chart.across)) +
           fmt::format("<text transform=\"translate(16 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                       0.5 * (kTop + kHeight - kBottom), html::escape(chart.up));
  }

  std::string path(const ChartCurve& curve) const {
    std::string out;
    for (const auto& [across, up] : curve.points) {
      out += fmt::format("{}{:.1f} {:.1f}", out.empty() ? "M" : " L", x(std::clamp(across, x_.low, x_.high)), y(up));
    }
    return out;
  }

 private:
  Span x_, y_;
};

std::string surrounding_path(const Frame& frame, const ChartCurve& curve, const char* css) {
  return fmt::format("<path class=\"{}\" d=\"{}\"><title>{}</title></path>\n", css, frame.path(curve),
                     html::escape(curve.name));
}

std::string curve_path(const Frame& frame, const ChartCurve& curve, std::size_t colour) {
  const char* css = curve.look == CurveLook::thin ? "curve thin" : "curve";
  const char* dash = colour < kColours.size() ? "" : " stroke-dasharray=\"8 3\"";
  return fmt::format("<path class=\"{}\" stroke=\"{}\"{} d=\"{}\"><title>{}</title></path>\n", css,
                     kColours[colour % kColours.size()], dash, frame.path(curve), html::escape(curve.name));
}

std::string marks(const Frame& frame, const ChartCurve& curve, std::size_t colour) {
  std::string out;
  for (const auto& [across, up] : curve.points) {
    out += fmt::format(
        "<circle class=\"mark\" stroke=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\"><title>{}</title></circle>\n",
        kColours[colour % kColours.size()], frame.x(across), frame.y(up), html::escape(curve.name));
  }
  return out;
}

}  // namespace

std::string curve_figure(const CurveChart& chart, const std::string& caption) {
  const Frame frame(chart);
  std::string out = fmt::format(
      "<figure id=\"{}\">\n<svg class=\"curves\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\" "
      "style=\"width:100%;height:auto;font:12px Arial,sans-serif;fill:#33414e\">\n"
      "<style>.curves .grid{{stroke:#dde3e8;fill:none}}.curves .curve{{fill:none;stroke-width:2}}"
      ".curves .thin{{stroke-width:1}}.curves .mark{{fill:#fff;stroke-width:1.5}}"
      ".curves .ground{{fill:none;stroke:#8c7a5b;stroke-width:1.2;stroke-dasharray:6 4}}"
      ".curves .water{{fill:none;stroke:#4f9bd9;stroke-width:1.2;stroke-dasharray:10 3}}</style>\n",
      chart.id, kWidth, kHeight, html::escape(caption));
  out += frame.axes(chart);
  for (const ChartCurve& curve : chart.ground) out += surrounding_path(frame, curve, "ground");
  for (const ChartCurve& curve : chart.water) out += surrounding_path(frame, curve, "water");
  std::string legend;
  for (std::size_t i = 0; i < chart.curves.size(); ++i) {
    const ChartCurve& curve = chart.curves[i];
    const std::size_t colour = curve.colour.value_or(i);
    out += curve.look == CurveLook::marks ? marks(frame, curve, colour) : curve_path(frame, curve, colour);
    if (!curve.in_legend) continue;
    legend += fmt::format(
        "<span style=\"white-space:nowrap;margin-right:1.2em\"><span style=\"color:{}\">"
        "&#9644;</span> {}</span> ",
        kColours[colour % kColours.size()], html::escape(curve.name));
  }
  return out + "</svg>\n<p class=\"small\">" + legend + "</p>\n<figcaption>" + html::escape(caption) +
         "</figcaption>\n</figure>\n";
}

}  // namespace overbend
