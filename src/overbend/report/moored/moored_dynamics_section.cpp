#include "report/moored/moored_dynamics_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/ranges.h"
#include "report/dynamic/mooring_histories.h"
#include "report/page/figure_list.h"
#include "results/tables/mooring_tables.h"

namespace overbend {
namespace {

Blocks vessel_table(const VesselDynamics& v, const std::string& along) {
  return Blocks(vessel_motions(v, along)) +
         block::remark(fmt::format(
             "Surge to yaw: from the nominal pose; along, across and offset: from the position of midship at the "
             "start of the run. Low-frequency: periods above {} s. Most probable: low-frequency and wave-frequency "
             "parts combined.{}{}",
             fixed(v.cut_off, 1), v.confidence.empty() ? "" : " ", v.confidence));
}

Blocks thrust_table(const DynamicResults& results) {
  if (results.thrust.empty()) return {};
  return Blocks(thrust_over_time(results.thrust)) +
         block::remark(
             "For the low-frequency motion, along its heading. Max. demand: magnitude of the force of spring and "
             "damper without the limit.");
}

Blocks event_table(const std::vector<MooringLineDynamics>& lines) {
  const Table table = mooring_events(lines);
  if (table.rows.size() <= 8) return table;
  return block::folded(fmt::format("{} events of the mooring lines", table.rows.size()), table);
}

Tile shift_tile(const std::string& name, const MotionStatistics& motion) {
  return {name, shown_number(motion.whole.min, "m", 2) + " to " + shown_number(motion.whole.max, "m", 2),
          shown_name("m"),
          fmt::format("LF std {}, WF std {}", shown_number(motion.slow.std, "m", 2),
                      shown_number(motion.wave.std, "m", 2))};
}

Blocks tiles(const DynamicResults& results) {
  std::vector<Tile> all;
  if (results.vessel) {
    const VesselDynamics& v = *results.vessel;
    const std::optional<double>& probable = v.offset.most_probable_max;
    all = {{"Largest offset", shown_number(v.offset.whole.max, "m", 2), shown_name("m"),
            "horizontal, from the start of the run" +
                (probable ? "; most probable in 3 h " + shown_number(*probable, "m", 2) : "")},
           shift_tile(std::string("Across the ") + course(results), v.across),
           shift_tile(std::string("Along the ") + course(results), v.along)};
  }
  const auto hardest = ranges::max_element(
      results.moorings, {}, [](const MooringLineDynamics& line) { return line.fairlead_tension.whole.max; });
  if (hardest != results.moorings.end()) {
    const std::optional<double>& use = hardest->utilisation;
    all.push_back({"Largest line tension", shown_number(hardest->fairlead_tension.whole.max, "N", 1), shown_name("N"),
                   hardest->name + (use ? ", " + fixed(100.0 * *use, 1) + " % of its breaking load" : ""),
                   use.value_or(0.0) > 1.0});
  }
  return block::tiles(all);
}

const std::vector<Figure>& all_figures() {
  static const std::vector<Figure> kFigures = {
      {"mooring_offsets", "Position of midship during the run, north up", {"dynamic"}},
      {"history",
       "Time history of the vessel offset: total and low-frequency part; the build-up is shaded",
       {"offset"}},
      {"history",
       "Time history of the tension at the fairleads; dashed: at the start of the run; the build-up is shaded",
       {"moorings"},
       true},
  };
  return kFigures;
}

}  // namespace

Blocks moored_dynamics_section(const DynamicResults& results) {
  if (!results.vessel && results.moorings.empty()) return {};
  std::set<std::string> groups;
  for (const Json& history : mooring_history_data(results)) groups.insert(history["group"]);
  const auto is_applicable = [&](const Figure& figure, const std::string& part) {
    return figure.id == "mooring_offsets" ? results.vessel.has_value() : groups.contains(part);
  };
  Blocks body = tiles(results) + figure_list(all_figures(), is_applicable);
  if (results.vessel) body += vessel_table(*results.vessel, course(results));
  body += thrust_table(results) + fairlead_tensions(results.moorings) + moorings_over_time(results.moorings) +
          event_table(results.moorings);
  return block::section("dynamic-moorings", "Vessel and moorings over time", body);
}

}  // namespace overbend
