#include <fmt/format.h>

#include <algorithm>

#include "report/dynamic/dynamic_contacts.h"
#include "report/dynamic/dynamic_sections.h"
#include "report/page/quantity.h"
#include "report/page/sea_labels.h"
#include "report/page/sections.h"
#include "results/fields/dynamic_scalars.h"
#include "results/fields/location_names.h"
#include "results/findings.h"

namespace overbend {
namespace {

std::string range(const SummaryStatistics& force) {
  return forces().text(force.min, 1) + " to " + forces().text(force.max, 1);
}

std::string where(const StaticResults& statics, const DynamicExtreme& extreme) {
  const std::string place = location_name(statics, extreme.s);
  return place == "sagbend" ? "X = " + shown(ship_point(statics, extreme.p_W).x(), "m", 1) : place;
}

std::string stress_note(const StaticResults& statics, const DynamicExtreme& extreme) {
  return fmt::format("{} % of yield, at {}, t = {} s",
                     fixed(yield_percent(statics, extreme.s, extreme.over_time.max), 1), where(statics, extreme),
                     fixed(extreme.time, 1));
}

bool yields(const StaticResults& statics, const DynamicExtreme& extreme) {
  return yield_percent(statics, extreme.s, extreme.over_time.max) > 100.0;
}

Tile stress_tile(const StaticResults& statics, const std::string& name, const DynamicExtreme& extreme, double before) {
  return {name, stresses().text(extreme.over_time.max, 1), stresses().unit,
          stress_note(statics, extreme) + "; static " + stresses().text(before, 1), yields(statics, extreme)};
}

Tile strain_tile(const StaticResults& statics, const std::string& name, const DynamicExtreme& extreme, double before) {
  return {name, strains().text(extreme.over_time.max, 4), strains().unit,
          fmt::format("at {}, t = {} s; static {}", where(statics, extreme), fixed(extreme.time, 1),
                      strains().text(before, 4))};
}

void add_contact_tiles(std::vector<Tile>& tiles, const StaticResults& statics, const DynamicResults& r) {
  const ContactCount count = count_contacts(r);
  if (const RollerDynamics* const hardest = count.hardest.roller) {
    tiles.push_back({"Largest roller reaction", forces().text(hardest->reaction.max, 1), forces().unit,
                     count.hardest.name() + "; static " + forces().text(hardest->static_reaction, 1)});
  }
  if (!r.hardest_impacts.empty()) {
    const Impact& impact = r.hardest_impacts.front();
    tiles.push_back({"Hardest impact", forces().text(impact.peak_force, 1), forces().unit,
                     fmt::format("{} at {}, t = {} s", shown(impact.approach_velocity, "m/s", 3),
                                 find_roller(r, impact.roller).name(), fixed(impact.time, 1))});
  } else {
    tiles.push_back({"Impacts", "none", "", "the pipe never lands on a roller"});
  }
  tiles.push_back({"Rollers that lose contact", std::to_string(count.losing), fmt::format("of {}", count.carrying),
                   fmt::format("in contact in the static state; {} of {} bottom rollers never touched", count.never,
                               count.bottom)});
  if (statics.stinger_tip_clearance) {
    const SummaryStatistics& clearance = r.stinger_tip_clearance;
    tiles.push_back({"Stinger tip clearance",
                     clearances().text(clearance.min, 1) + " to " + clearances().text(clearance.max, 1),
                     clearances().unit,
                     "pipe to the last bottom roller; static " + clearances().text(*statics.stinger_tip_clearance, 1)});
  }
}

Blocks tiles(const StaticResults& statics, const DynamicResults& r) {
  const bool overbend = statics.overbend.has_value();
  std::vector<Tile> all = {{"Top tension", range(r.top_tension), forces().unit,
                            "effective, at the tensioner; static " + forces().text(statics.top_tension, 1)}};
  if (overbend) {
    all.push_back(stress_tile(statics, "Overbend von Mises", r.overbend.von_mises, statics.overbend->von_mises.value));
  }
  all.push_back(stress_tile(statics, "Sagbend von Mises", r.sagbend.von_mises, statics.sagbend.von_mises.value));
  all.push_back({"Bottom tension", range(r.bottom_tension), forces().unit,
                 "horizontal, at touchdown; static " + forces().text(statics.bottom_tension, 1)});
  if (!r.supports.empty()) add_contact_tiles(all, statics, r);
  if (overbend) {
    all.push_back(strain_tile(statics, "Overbend strain", r.overbend.strain, statics.overbend->strain.value));
  }
  all.push_back(strain_tile(statics, "Sagbend strain", r.sagbend.strain, statics.sagbend.strain.value));
  return block::tiles(all);
}

/// The static extreme of the same quantity.
Extreme static_extreme(const RegionResult& region, const std::string& name) {
  Extreme found;
  visit_region(region, [&](const ResultField& field, const Extreme& extreme) {
    if (field.name == name) found = extreme;
  });
  return found;
}

/// Maxima of a region over its length and time next to those of the static state.
Table region_table(const StaticResults& statics, const std::string& title, const DynamicRegion& region,
                   const RegionResult& before) {
  Table table{title,
              {TableColumn("Largest"),
               TableColumn::texts("dynamic"),
               TableColumn::texts("static"),
               {"ratio", "-", 2},
               {"dynamic", "% yield", 1},
               {"static", "% yield", 1},
               {"Time", "s", 1},
               {"Along pipe", "m", 2},
               {"X", "m", 2},
               {"Z", "m", 2},
               TableColumn("Place")}};
  visit_dynamic_region(region, [&](const ResultField& field, const DynamicExtreme& extreme) {
    const Quantity q = quantity(field.name, std::string(field.units));
    const Extreme at_rest = static_extreme(before, field.name);
    const Vec3 p = ship_point(statics, extreme.p_W);
    const double max_value = extreme.over_time.max;
    std::optional<double> ratio, use, use_at_rest;
    if (at_rest.value > 0.0) ratio = max_value / at_rest.value;
    if (field.units == "Pa") {  // a stress, compared with yield
      use = yield_percent(statics, extreme.s, max_value);
      use_at_rest = yield_percent(statics, at_rest.s, at_rest.value);
    }
    table.row({fmt::format("{} [{}]", q.name, q.unit), q.text(max_value), q.text(at_rest.value), ratio, use,
               use_at_rest, extreme.time, from_tensioner(statics, extreme.s), p.x(), p.z(),
               location_name(statics, extreme.s)});
  });
  return table;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> dynamic_entries(const StaticResults& statics,
                                                                 const DynamicResults& results,
                                                                 const std::optional<Description>& description,
                                                                 const std::string& written) {
  std::vector<std::pair<std::string, std::string>> entries = subject_entries(statics, description);
  if (description) {
    entries.emplace_back("Sea", sea_label(description->environment.waves));
    entries.emplace_back("Vessel motion", motion_label(description->vessel));
  }
  entries.emplace_back("Seed", std::to_string(results.seed));
  entries.emplace_back(
      "Duration", readable_duration(results.duration) + " after a build-up of " + readable_duration(results.build_up));
  entries.emplace_back("Integrator", results.run.integrator);
  if (statics.has_pipe()) entries.emplace_back("Tensioner", results.tensioner.mode);
  entries.emplace_back("Status", status_label("completed", all_findings(statics, results).size()));
  entries.emplace_back("Program", "Overbend " + statics.version);
  entries.emplace_back("Written", written);
  return entries;
}

Blocks dynamic_key_results(const StaticResults& statics, const DynamicResults& results) {
  if (!statics.has_pipe()) return {};
  Blocks regions;
  if (statics.overbend) {
    regions += region_table(statics, "Overbend: tensioner to the inflection below the last support in contact",
                            results.overbend, *statics.overbend);
  }
  regions += region_table(
      statics,
      statics.overbend ? "Sagbend: from the inflection to touchdown" : "Suspended pipe: tensioner to touchdown",
      results.sagbend, statics.sagbend);
  return block::section(
      "results", "Key results",
      tiles(statics, results) + block::group("results one", regions) +
          block::remark(
              "Times and statistics start at the end of the build-up. Along pipe: unstressed length from the "
              "tensioner. X: horizontal, astern of the stern shoe. Z: above the mean water level. Locations are those "
              "of the static state. Ratio: dynamic divided by static."));
}

}  // namespace overbend
