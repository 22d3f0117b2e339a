#include "report/moored/bodies_section.h"

#include "report/page/html.h"
#include "report/page/quantity.h"

namespace overbend {
namespace {

std::string rest_table(const std::vector<BodyResult>& bodies) {
  html::Table table("Bodies at rest",
                    {{"Body", "", true},
                     {"east", shown_name("m")},
                     {"north", shown_name("m")},
                     {"Heading", shown_name("rad")},
                     {"ahead", shown_name("m")},
                     {"to port", shown_name("m")},
                     {"up", shown_name("m")},
                     {"roll", shown_name("rad")},
                     {"pitch", shown_name("rad")},
                     {"yaw", shown_name("rad")},
                     {"east", shown_name("N")},
                     {"north", shown_name("N")},
                     {"up", shown_name("N")}},
                    "dense summary");
  table.groups({{"", 1}, {"Place", 2}, {"", 1}, {"From as drawn", 6}, {"Force of all lines on it", 3}});
  for (const BodyResult& b : bodies) {
    table.row({b.name, shown_number(b.place.x(), "m", 2), shown_number(b.place.y(), "m", 2),
               shown_number(b.heading, "rad", 2), shown_number(b.surge, "m", 3), shown_number(b.sway, "m", 3),
               shown_number(b.heave, "m", 3), shown_number(b.roll, "rad", 3), shown_number(b.pitch, "rad", 3),
               shown_number(b.yaw, "rad", 3), shown_number(b.force.x(), "N", 2), shown_number(b.force.y(), "N", 2),
               shown_number(b.force.z(), "N", 2)});
  }
  return table.str();
}

std::string time_table(const std::vector<BodyDynamics>& bodies) {
  html::Table table("Bodies over time",
                    {{"Body", "", true},
                     {"Quantity", "", true},
                     {"Unit", "", true},
                     {"min", ""},
                     {"max", ""},
                     {"mean", ""},
                     {"std", ""}},
                    "dense summary");
  for (const BodyDynamics& body : bodies) {
    const auto add = [&](const char* name, const Spread& spread, const char* unit) {
      table.row({body.name, name, shown_name(unit), shown_number(spread.min, unit, 3),
                 shown_number(spread.max, unit, 3), shown_number(spread.mean, unit, 3),
                 shown_number(spread.std, unit, 3)});
    };
    add("surge", body.surge, "m");
    add("sway", body.sway, "m");
    add("heave", body.heave, "m");
    add("roll", body.roll, "rad");
    add("pitch", body.pitch, "rad");
    add("yaw", body.yaw, "rad");
    add("horizontal force of all lines", body.pull, "N");
  }
  return table.str();
}

}  // namespace

std::string bodies_section(const StaticResults& statics, const DynamicResults* dynamics) {
  if (statics.bodies.empty()) return "";
  const bool moved = dynamics != nullptr && !dynamics->bodies.empty();
  return html::section("bodies", "Bodies", rest_table(statics.bodies) + (moved ? time_table(dynamics->bodies) : ""));
}

}  // namespace overbend
