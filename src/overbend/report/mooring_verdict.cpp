#include "report/mooring_verdict.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/html.h"
#include "report/quantity.h"

namespace overbend {
namespace {

/// The largest of one kind of use, with where it is.
struct Worst {
  std::optional<UtilisationBar> bar;

  void add(const char* title, double use, const std::string& what) {
    if (!bar || use > bar->utilisation) bar = UtilisationBar{title, use, what};
  }
};

std::string kilo(double newton) {
  return forces().text(newton, 1) + " kN";
}

std::vector<UtilisationBar> there(const std::vector<Worst>& all) {
  std::vector<UtilisationBar> bars;
  for (const Worst& worst : all) {
    if (worst.bar) bars.push_back(*worst.bar);
  }
  return bars;
}

constexpr const char* kBreaking = "Mooring lines";
constexpr const char* kWorking = "Working load";
constexpr const char* kHolding = "Anchors";

}  // namespace

std::vector<UtilisationBar> mooring_bars(const MooringResults& results, const std::optional<double>& working_load) {
  Worst breaking, working, holding;
  const auto add = [&](const MooredState& state) {
    for (const MooringLineResult& line : state.moorings) {
      if (line.parted) continue;
      const std::string who = line.name + ", " + state.name + ", ";
      const std::string at_fairlead = who + kilo(line.fairlead_tension);
      if (line.utilisation) breaking.add(kBreaking, *line.utilisation, at_fairlead + " of the breaking load");
      if (working_load) {
        working.add(kWorking, line.fairlead_tension / *working_load,
                    at_fairlead + " of the working load of " + kilo(*working_load));
      }
      if (line.anchor_utilisation) {
        holding.add(kHolding, *line.anchor_utilisation, who + kilo(line.anchor_tension) + " of the holding power");
      }
    }
  };
  add(results.rest);
  for (const MooredState& stage : results.stages) add(stage);
  return there({breaking, working, holding});
}

std::vector<UtilisationBar> mooring_bars(const std::vector<MooringLineDynamics>& lines,
                                         const std::optional<double>& working_load) {
  Worst breaking, working, holding;
  for (const MooringLineDynamics& line : lines) {
    const double most = line.fairlead_tension.whole.max;
    const std::string at_fairlead = line.name + ", largest of the run, " + kilo(most);
    if (line.utilisation) breaking.add(kBreaking, *line.utilisation, at_fairlead + " of the breaking load");
    if (working_load) {
      working.add(kWorking, most / *working_load, at_fairlead + " of the working load of " + kilo(*working_load));
    }
    if (line.anchor_utilisation) {
      holding.add(kHolding, *line.anchor_utilisation,
                  line.name + ", largest of the run, " + kilo(line.anchor_tension.whole.max) + " of the holding power");
    }
  }
  return there({breaking, working, holding});
}

std::vector<UtilisationBar> line_bars(const LinesResults& results) {
  Worst breaking;
  for (const LineResult& line : results.lines) {
    if (!line.utilisation || !(line.largest_tension > 0.0)) continue;
    if (results.moved && line.utilisation_in_time) {  // another segment may be used most than at rest
      breaking.add("Lines", std::max(*line.utilisation_in_time, *line.utilisation),
                   line.name + ", largest of the run, of the breaking load of the segment used most");
      continue;
    }
    // Results of before that have no use over time: that of the segment that is used most at rest.
    const double most = results.moved ? std::max(line.largest_in_time, line.largest_tension) : line.largest_tension;
    breaking.add("Lines", *line.utilisation * most / line.largest_tension,
                 line.name + (results.moved ? ", " + kilo(most) + ", largest of the run," : ", at rest,") +
                     " of the breaking load of the segment used most at rest");
  }
  return there({breaking});
}

Verdict load_verdict(const std::vector<UtilisationBar>& bars, const std::vector<WeighedWarning>& warnings) {
  if (bars.empty()) {
    return {VerdictKind::open, "NOT JUDGED", "The model gives no breaking load, working load or holding power."};
  }
  const auto worst = std::max_element(bars.begin(), bars.end(), [](const UtilisationBar& a, const UtilisationBar& b) {
    return a.utilisation < b.utilisation;
  });
  const std::string because = fmt::format("The largest utilisation is {}: {}. No code's safety factors are applied.",
                                          html::fixed(worst->utilisation, 3), worst->what);
  if (worst->utilisation > 1.0) {
    return {VerdictKind::exceeded,
            fmt::format("EXCEEDED {}, {}", html::fixed(worst->utilisation, worst->utilisation < 1.005 ? 4 : 2),
                        worst->what),
            because};
  }
  const auto serious = std::count_if(warnings.begin(), warnings.end(),
                                     [](const WeighedWarning& w) { return w.weight == WarningWeight::serious; });
  if (serious > 0) {
    return {VerdictKind::reserved,
            fmt::format("NO LOAD EXCEEDED, {} serious warning{}", serious, serious == 1 ? "" : "s"), because};
  }
  return {VerdictKind::passed, "NO LOAD EXCEEDED", because};
}

}  // namespace overbend
