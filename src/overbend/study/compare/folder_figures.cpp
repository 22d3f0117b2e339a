#include "study/compare/folder_figures.h"

#include <algorithm>
#include <cmath>

#include "base/ranges.h"
#include "base/shown_unit.h"

namespace overbend {
namespace {

constexpr const char* kAlong = "distance from the tensioner";

double unit_factor(const char* si) {
  return shown_unit(si).factor;
}

std::string headed(const std::string& name, const char* si) {
  return name + " [" + shown_name(si) + "]";
}

void add(FolderCurves& curves, const std::string& title, const std::string& x_label, const std::string& y_label,
         const std::vector<double>& x, const std::vector<double>& y) {
  if (x.empty() || x.size() != y.size()) return;
  FolderCurve curve{title, x_label, y_label, {}, {}};
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
    curve.x.push_back(x[i]);
    curve.y.push_back(y[i]);
  }
  curves.push_back(std::move(curve));
}

std::vector<double> times(const std::vector<double>& values, double factor) {
  std::vector<double> out;
  for (const double value : values) out.push_back(factor * value);
  return out;
}

double top_position(const StaticResults& results) {
  double top = 0.0;
  for (const Station& station : results.stations) top = std::max(top, station.s);
  return top;
}

/// Adds a decimated history: minimum and maximum of each interval in turn.
void add_history(FolderCurves& curves, const DynamicResults& results, const std::string& name, const std::string& title,
                 const std::string& quantity, const char* si) {
  const auto history = ranges::find(results.histories, name, &HistorySummary::name);
  if (history == results.histories.end() || history->low.size() != history->high.size() || history->low.empty()) return;
  const double count = static_cast<double>(history->low.size());
  const double stretch = (results.duration + results.build_up) / count;
  std::vector<double> time, values;
  for (std::size_t i = 0; i < history->low.size(); ++i) {
    const double from = -results.build_up + stretch * static_cast<double>(i);
    time.insert(time.end(), {from + 0.25 * stretch, from + 0.75 * stretch});
    values.insert(values.end(), {unit_factor(si) * history->low[i], unit_factor(si) * history->high[i]});
  }
  add(curves, title, "time [s]", headed(quantity, si), time, values);
}

}  // namespace

void add_curves(FolderCurves& curves, const StaticResults& results) {
  std::vector<double> s, astern, height, tension, moment, stress;
  const double top = top_position(results);
  for (const Station& station : results.stations) {
    s.push_back(unit_factor("m") * (top - station.s));
    astern.push_back(unit_factor("m") * station.astern);
    height.push_back(unit_factor("m") * station.p_W.z());
    tension.push_back(unit_factor("N") * station.effective_tension);
    moment.push_back(unit_factor("N m") * station.bending_moment);
    stress.push_back(unit_factor("Pa") * station.von_mises);
  }
  add(curves, "Static shape", headed("distance astern of the stern shoe", "m"), headed("height", "m"), astern, height);
  add(curves, "Static effective tension", headed(kAlong, "m"), headed("tension", "N"), s, tension);
  add(curves, "Static bending moment", headed(kAlong, "m"), headed("bending moment", "N m"), s, moment);
  add(curves, "Static von Mises stress", headed(kAlong, "m"), headed("von Mises stress", "Pa"), s, stress);
}

void add_curves(FolderCurves& curves, const StaticResults& statics, const DynamicResults& results) {
  std::vector<double> s;
  const double top = top_position(statics);
  for (const double station : results.station_s) s.push_back(unit_factor("m") * (top - station));
  const auto envelope = [&](const char* title, const char* label, const std::vector<double>& values, const char* si) {
    add(curves, title, headed(kAlong, "m"), headed(label, si), s, times(values, unit_factor(si)));
  };
  envelope("Largest effective tension over time", "tension", results.effective_tension.max, "N");
  envelope("Smallest effective tension over time", "tension", results.effective_tension.min, "N");
  envelope("Largest bending moment over time", "bending moment", results.bending_moment.max, "N m");
  envelope("Largest von Mises stress over time", "von Mises stress", results.von_mises.max, "Pa");
  add_history(curves, results, "vessel/offset", "History of the vessel's offset", "offset", "m");
  for (const MooringLineDynamics& line : results.moorings) {
    add_history(curves, results, "mooring/" + line.name + "/fairlead_tension", "Fairlead tension of " + line.name,
                "tension", "N");
  }
  add_history(curves, results, "top_tension", "History of the top tension", "tension", "N");
  add_history(curves, results, "overbend_von_mises", "History of the largest stress of the overbend",
              "von Mises stress", "Pa");
  add_history(curves, results, "sagbend_von_mises", "History of the largest stress of the sagbend", "von Mises stress",
              "Pa");
}

std::vector<OverlaidFigure> overlaid(const std::vector<FolderCurves>& folders) {
  std::vector<OverlaidFigure> figures;
  for (std::size_t i = 0; i < folders.size(); ++i) {
    for (const FolderCurve& curve : folders[i]) {
      auto found = ranges::find(figures, curve.title, &OverlaidFigure::title);
      if (found == figures.end()) {
        figures.push_back({curve.title, curve.x_label, curve.y_label, {}});
        found = std::prev(figures.end());
      }
      found->curves.push_back({i, curve.x, curve.y});
    }
  }
  std::erase_if(figures, [](const OverlaidFigure& figure) { return figure.curves.size() < 2; });
  return figures;
}

}  // namespace overbend
