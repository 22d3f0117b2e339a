#include "report/moored/moored_dynamics_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "report/dynamic/mooring_histories.h"
#include "report/page/figure_list.h"
#include "report/page/html.h"
#include "report/page/quantity.h"

namespace overbend {
namespace {

using html::fixed;
using html::tile;

const std::vector<html::Head>& spread_head() {
  static const std::vector<html::Head> kHead = {
      {"", "", true}, {"Unit", "", true}, {"min", ""}, {"max", ""}, {"mean", ""},  {"std", ""},    {"min", ""},
      {"max", ""},    {"std", ""},        {"max", ""}, {"std", ""}, {"least", ""}, {"largest", ""}};
  return kHead;
}

const std::vector<std::pair<std::string, int>>& spread_groups() {
  static const std::vector<std::pair<std::string, int>> kGroups = {
      {"", 2}, {"Whole", 4}, {"Slow part", 3}, {"Wave part", 2}, {"Most probable in 3 h", 2}};
  return kGroups;
}

void add_row(html::Table& table, const std::string& name, const Quantity& q, int digits, const MotionSpread& motion) {
  const auto text = [&](double value) { return q.text(value, digits); };
  const auto or_dash = [&](const std::optional<double>& value) { return value ? text(*value) : "-"; };
  table.row({name, q.unit, text(motion.whole.min), text(motion.whole.max), text(motion.whole.mean),
             text(motion.whole.std), text(motion.slow.min), text(motion.slow.max), text(motion.slow.std),
             text(motion.wave.max), text(motion.wave.std), or_dash(motion.most_probable_min),
             or_dash(motion.most_probable_max)});
}

/// What the shifts ahead and to port are along and across: a hull without a pipe has no route.
const char* course(const DynamicResults& results) {
  return results.station_s.empty() ? "hull" : "route";
}

std::string vessel_table(const VesselDynamics& v, const std::string& along) {
  html::Table table("Motion of the vessel: slow and wave part", spread_head(), "dense summary");
  table.groups(spread_groups());
  add_row(table, "Surge, forward", lengths(), 3, v.surge);
  add_row(table, "Sway, to port", lengths(), 3, v.sway);
  add_row(table, "Heave, up", lengths(), 3, v.heave);
  add_row(table, "Roll, starboard down", angles(), 3, v.roll);
  add_row(table, "Pitch, bow down", angles(), 3, v.pitch);
  add_row(table, "Yaw, bow to port", angles(), 3, v.yaw);
  add_row(table, "Along the " + along + ", ahead", lengths(), 3, v.along);
  add_row(table, "Across the " + along + ", to port", lengths(), 3, v.across);
  add_row(table, "Horizontal offset", lengths(), 3, v.offset);
  std::string note = fmt::format(
      "<p class=\"small\">Surge to yaw from the hull as drawn; along, across and offset from where midship lay at the "
      "start of the run. Slow: periods above {} s. Most probable: slow and wave part combined.",
      fixed(v.cut_off, 1));
  if (!v.confidence.empty()) note += " " + html::escape(v.confidence);
  return table.str() + note + "</p>\n";
}

std::string thrust_table(const DynamicResults& results) {
  if (results.thrust.empty()) return "";
  html::Table table("Dynamic positioning over time",
                    {{"", "", true},
                     {"Mean", ""},
                     {"Std", ""},
                     {"Min", ""},
                     {"Max", ""},
                     {"Most asked for", ""},
                     {"Limit", ""},
                     {"At the limit", "s"},
                     {"Unit", "", true}},
                    "dense summary");
  constexpr std::array<const char*, 3> kTold = {"Thrust ahead", "Thrust to port", "Moment, bow to port"};
  for (std::size_t i = 0; i < results.thrust.size(); ++i) {
    const ThrustDynamics& one = results.thrust[i];
    const Quantity quantity = i == 2 ? moments() : forces();
    const auto text = [&](double value) { return quantity.text(value, i == 2 ? 0 : 1); };
    table.row(
        {kTold.at(i), text(one.given.mean), text(one.given.std), text(one.given.min), text(one.given.max),
         text(one.largest_asked), one.limit ? text(*one.limit) : "none", fixed(one.time_at_limit, 1), quantity.unit},
        one.time_at_limit > 0.0 ? "over" : "");
  }
  return table.str() +
         "<p class=\"small\">Of the slow motion, along its heading. Most asked for: magnitude of what spring and "
         "damper "
         "would give without a limit.</p>\n";
}

std::string tension_table(const std::vector<MooringLineDynamics>& lines) {
  html::Table table("Tension at the fairleads: slow and wave part", spread_head(), "dense summary");
  table.groups(spread_groups());
  for (const MooringLineDynamics& line : lines) add_row(table, line.name, forces(), 1, line.fairlead_tension);
  return table.str();
}

std::string percent(const std::optional<double>& use) {
  return use ? fixed(100.0 * *use, 1) : "-";
}

bool rendered(const std::vector<MooringLineDynamics>& lines) {
  return std::any_of(lines.begin(), lines.end(), [](const MooringLineDynamics& line) {
    return line.brake_rendered > 0.0 || line.anchor_slip > 0.0;
  });
}

std::string use_table(const std::vector<MooringLineDynamics>& lines) {
  const bool near =
      std::any_of(lines.begin(), lines.end(), [](const auto& line) { return line.clearance.has_value(); });
  const bool gave = rendered(lines);
  std::vector<html::Head> head = {
      {"Line", "", true},        {"start", shown_name("N")},  {"largest", shown_name("N")},
      {"of breaking load", "%"}, {"most probable", "%"},      {"largest", shown_name("N")},
      {"of holding power", "%"}, {"uplift", shown_name("N")}, {"Least on bed", shown_name("m")},
      {"Slack for", "s"}};
  std::vector<std::pair<std::string, int>> groups = {{"", 1}, {"Tension at the fairlead", 4}, {"Anchor", 3}, {"", 2}};
  if (gave) {
    head.push_back({"Brake let out", shown_name("m")});
    head.push_back({"Anchor slip", shown_name("m")});
  }
  if (near) {
    head.push_back({"Clearance", shown_name("m")});
    head.push_back({"to", "", true});
  }
  html::Table table("Mooring lines over time", head, "dense summary");
  table.groups(groups);
  for (const MooringLineDynamics& l : lines) {
    std::vector<std::string> cells = {l.name,
                                      forces().text(l.start_fairlead_tension, 1),
                                      forces().text(l.fairlead_tension.whole.max, 1),
                                      percent(l.utilisation),
                                      percent(l.most_probable_utilisation),
                                      forces().text(l.anchor_tension.whole.max, 1),
                                      percent(l.anchor_utilisation),
                                      forces().text(l.largest_uplift, 1),
                                      shown_number(l.least_on_bed, "m", 1),
                                      fixed(l.time_slack, 1)};
    if (gave) {
      cells.push_back(shown_number(l.brake_rendered, "m", 2));
      cells.push_back(shown_number(l.anchor_slip, "m", 2));
    }
    if (near) {
      cells.push_back(l.clearance ? shown_number(*l.clearance, "m", 1) : "-");
      cells.push_back(l.nearest_object);
    }
    table.row(cells, l.utilisation.value_or(0.0) > 1.0 || l.anchor_utilisation.value_or(0.0) > 1.0 ? "over" : "");
  }
  return table.str();
}

std::string event_table(const std::vector<MooringLineDynamics>& lines) {
  struct Told {
    double time;
    std::string line, what;
  };
  std::vector<Told> all;
  for (const MooringLineDynamics& line : lines) {
    for (const MooringEvent& event : line.events) all.push_back({event.time, line.name, event.what});
  }
  if (all.empty()) return "";
  std::stable_sort(all.begin(), all.end(), [](const Told& a, const Told& b) { return a.time < b.time; });
  html::Table table("Events of the mooring lines", {{"Time", "s"}, {"Line", "", true}, {"Event", "", true}}, "plain");
  for (const Told& told : all) table.row({fixed(told.time, 1), told.line, told.what});
  return all.size() > 8 ? html::folded(fmt::format("{} events of the mooring lines", all.size()), table.str())
                        : table.str();
}

std::string spread_text(const Quantity& q, int digits, const Spread& spread) {
  return q.text(spread.min, digits) + " to " + q.text(spread.max, digits);
}

std::string tiles(const DynamicResults& results) {
  std::string out;
  if (results.vessel) {
    const VesselDynamics& v = *results.vessel;
    out += tile(
        "Largest offset", shown_number(v.offset.whole.max, "m", 2), shown_name("m"),
        std::string("horizontal, from the start of the run") +
            (v.offset.most_probable_max ? "; most probable in 3 h " + shown_number(*v.offset.most_probable_max, "m", 2)
                                        : ""));
    const std::string along = course(results);
    out += tile("Across the " + along, spread_text(lengths(), 2, v.across.whole), shown_name("m"),
                fmt::format("std slow {}, waves {}", shown_number(v.across.slow.std, "m", 2),
                            shown_number(v.across.wave.std, "m", 2)));
    out += tile("Along the " + along, spread_text(lengths(), 2, v.along.whole), shown_name("m"),
                fmt::format("std slow {}, waves {}", shown_number(v.along.slow.std, "m", 2),
                            shown_number(v.along.wave.std, "m", 2)));
  }
  const auto hardest = std::max_element(results.moorings.begin(), results.moorings.end(),
                                        [](const MooringLineDynamics& a, const MooringLineDynamics& b) {
                                          return a.fairlead_tension.whole.max < b.fairlead_tension.whole.max;
                                        });
  if (hardest != results.moorings.end()) {
    out += tile("Largest line tension", forces().text(hardest->fairlead_tension.whole.max, 1), forces().unit,
                hardest->name + (hardest->utilisation ? ", " + percent(hardest->utilisation) + " % of its breaking load"
                                                      : std::string()),
                hardest->utilisation.value_or(0.0) > 1.0);
  }
  return "<div class=\"tiles\">\n" + out + "</div>\n";
}

const std::vector<Figure>& all_figures() {
  static const std::vector<Figure> kFigures = {
      {"mooring_offsets", "Where midship was during the run, north up", {"dynamic"}},
      {"history", "Offset of the vessel in time: whole motion and its slow part; the build-up is shaded", {"offset"}},
      {"history",
       "Tension at the fairleads in time; dashed: at the start of the run; the build-up is shaded",
       {"moorings"},
       true},
  };
  return kFigures;
}

}  // namespace

std::string moored_dynamics_section(const DynamicResults& results, int& figure) {
  if (!results.vessel && results.moorings.empty()) return "";
  std::set<std::string> groups;
  for (const Json& history : mooring_history_data(results)) groups.insert(history["group"]);
  const auto makes_sense = [&](const Figure& shown, const std::string& part) {
    return std::string(shown.id) == "mooring_offsets" ? results.vessel.has_value() : groups.count(part) != 0;
  };
  std::string body = tiles(results) + figure_list(all_figures(), makes_sense, figure);
  if (results.vessel) body += vessel_table(*results.vessel, course(results));
  body += thrust_table(results);
  if (!results.moorings.empty()) {
    body += tension_table(results.moorings) + use_table(results.moorings) + event_table(results.moorings);
  }
  return html::section("dynamic-moorings", "Vessel and moorings over time", body);
}

}  // namespace overbend
