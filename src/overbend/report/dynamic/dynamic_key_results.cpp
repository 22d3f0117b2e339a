#include <fmt/format.h>

#include <algorithm>

#include "report/dynamic/dynamic_contacts.h"
#include "report/dynamic/dynamic_sections.h"
#include "report/page/html.h"
#include "report/page/places.h"
#include "report/page/quantity.h"
#include "report/page/sea_words.h"
#include "report/page/sections.h"
#include "results/fields/dynamic_values.h"
#include "results/findings.h"

namespace overbend {
namespace {

using html::fixed;
using html::tile;

std::string range(const Quantity& q, const Spread& spread, int digits) {
  return q.text(spread.min, digits) + " to " + q.text(spread.max, digits);
}

bool has_overbend(const StaticResults& statics) {
  return statics.overbend.has_value();
}

std::string where(const StaticResults& statics, const DynamicExtreme& extreme) {
  const std::string place = place_name(statics, extreme.s);
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

std::string stress_tile(const StaticResults& statics, const std::string& name, const DynamicExtreme& extreme,
                        double before) {
  return tile(name, stresses().text(extreme.over_time.max, 1), stresses().unit,
              stress_note(statics, extreme) + "; static " + stresses().text(before, 1), yields(statics, extreme));
}

std::string strain_tile(const StaticResults& statics, const std::string& name, const DynamicExtreme& extreme,
                        double before) {
  return tile(name, strains().text(extreme.over_time.max, 4), strains().unit,
              fmt::format("at {}, t = {} s; static {}", where(statics, extreme), fixed(extreme.time, 1),
                          strains().text(before, 4)));
}

std::string contact_tiles(const StaticResults& statics, const DynamicResults& r) {
  const ContactCount count = count_contacts(r);
  std::string out;
  if (count.hardest.roller != nullptr) {
    out += tile(
        "Largest roller reaction", forces().text(count.hardest.roller->reaction.max, 1), forces().unit,
        fmt::format("{}; static {}", count.hardest.name(), forces().text(count.hardest.roller->static_reaction, 1)));
  }
  if (!r.hardest_impacts.empty()) {
    const Impact& impact = r.hardest_impacts.front();
    out += tile("Hardest impact", forces().text(impact.peak_force, 1), forces().unit,
                fmt::format("{} at {}, t = {} s", shown(impact.approach_velocity, "m/s", 3),
                            find_roller(r, impact.roller).name(), fixed(impact.time, 1)));
  } else {
    out += tile("Impacts", "none", "", "the pipe never lands on a roller");
  }
  out += tile(
      "Rollers that lose contact", std::to_string(count.losing), fmt::format("of {}", count.carrying),
      fmt::format("carrying in the static state; {} of {} bottom rollers never touched", count.never, count.bottom));
  if (statics.stinger_tip_clearance) {
    out += tile("Stinger tip clearance", range(clearances(), r.stinger_tip_clearance, 1), clearances().unit,
                "pipe to the last bottom roller; static " + clearances().text(*statics.stinger_tip_clearance, 1));
  }
  return out;
}

std::string tiles(const StaticResults& statics, const DynamicResults& r) {
  std::string out = "<div class=\"tiles\">\n";
  out += tile("Top tension", range(forces(), r.top_tension, 1), forces().unit,
              "effective, at the tensioner; static " + forces().text(statics.top_tension, 1));
  if (has_overbend(statics)) {
    out += stress_tile(statics, "Overbend von Mises", r.overbend.von_mises, statics.overbend->von_mises.value);
  }
  out += stress_tile(statics, "Sagbend von Mises", r.sagbend.von_mises, statics.sagbend.von_mises.value);
  out += tile("Bottom tension", range(forces(), r.bottom_tension, 1), forces().unit,
              "horizontal, at touchdown; static " + forces().text(statics.bottom_tension, 1));
  if (!r.supports.empty()) {
    out += contact_tiles(statics, r);
  }
  if (has_overbend(statics)) {
    out += strain_tile(statics, "Overbend strain", r.overbend.strain, statics.overbend->strain.value);
  }
  out += strain_tile(statics, "Sagbend strain", r.sagbend.strain, statics.sagbend.strain.value);
  return out + "</div>\n";
}

/// The static extreme of the same quantity.
Extreme extreme_of(const RegionResult& region, const std::string& name) {
  Extreme found;
  visit_region(region, [&](const ResultField& field, const Extreme& extreme) {
    if (field.name == name) found = extreme;
  });
  return found;
}

/// Largest values of a region over its length and time beside those of the static state.
std::string region_table(const StaticResults& statics, const std::string& caption, const DynamicRegion& region,
                         const RegionResult& before) {
  html::Table table(caption,
                    {{"Largest", "", true},
                     {"dynamic", ""},
                     {"static", ""},
                     {"ratio", ""},
                     {"dynamic", "% yield"},
                     {"static", "% yield"},
                     {"Time", "s"},
                     {"Along pipe", shown_name("m")},
                     {"X", shown_name("m")},
                     {"Z", shown_name("m")},
                     {"Place", "", true}},
                    "plain");
  visit_dynamic_region(region, [&](const ResultField& field, const DynamicExtreme& now) {
    const Quantity q = quantity(field.name, std::string(field.units));
    const bool stress = field.units == "Pa";  // compared with yield
    const Extreme then = extreme_of(before, field.name);
    const Vec3 p = ship_point(statics, now.p_W);
    table.row({fmt::format("{} [{}]", q.name, q.unit), q.text(now.over_time.max), q.text(then.value),
               then.value > 0.0 ? fixed(now.over_time.max / then.value, 2) : "",
               stress ? fixed(yield_percent(statics, now.s, now.over_time.max), 1) : "",
               stress ? fixed(yield_percent(statics, then.s, then.value), 1) : "", fixed(now.time, 1),
               shown_number(from_tensioner(statics, now.s), "m", 2), shown_number(p.x(), "m", 2),
               shown_number(p.z(), "m", 2), place_name(statics, now.s)});
  });
  return table.str();
}

}  // namespace

std::vector<std::pair<std::string, std::string>> dynamic_entries(const StaticResults& statics,
                                                                 const DynamicResults& results,
                                                                 const std::optional<Description>& description,
                                                                 const std::string& written) {
  std::vector<std::pair<std::string, std::string>> entries = subject_entries(statics, description);
  if (description) {
    entries.emplace_back("Sea", sea_words(description->environment.waves));
    entries.emplace_back("Vessel motion", motion_words(description->vessel));
  }
  entries.emplace_back("Seed", std::to_string(results.seed));
  entries.emplace_back("Duration",
                       duration_words(results.duration) + " after a build-up of " + duration_words(results.build_up));
  entries.emplace_back("Integrator", results.run.integrator);
  if (statics.has_pipe()) entries.emplace_back("Tensioner", results.tensioner.mode);
  entries.emplace_back("Status", status_words("completed", all_findings(statics, results).size()));
  entries.emplace_back("Program", "Overbend " + statics.version);
  entries.emplace_back("Written", written);
  return entries;
}

std::string dynamic_key_results(const StaticResults& statics, const DynamicResults& results) {
  if (!statics.has_pipe()) return "";
  std::string body = tiles(statics, results) + "<div class=\"results one\">\n";
  if (has_overbend(statics)) {
    body += region_table(statics, "Overbend: tensioner to the inflection below the last support in contact",
                         results.overbend, *statics.overbend);
  }
  body += region_table(
      statics, has_overbend(statics) ? "Sagbend: from there to touchdown" : "Suspended pipe: tensioner to touchdown",
      results.sagbend, statics.sagbend);
  body +=
      "</div>\n<p class=\"small\">Times and statistics start at the end of the build-up. Along pipe: "
      "unstressed length from the tensioner. X: horizontal, astern of the stern shoe. Z: above the mean water level. "
      "Locations are those of the static state. Ratio: dynamic divided by static.</p>\n";
  return html::section("results", "Key results", body);
}

}  // namespace overbend
