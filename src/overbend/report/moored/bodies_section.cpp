#include "report/moored/bodies_section.h"

namespace overbend {
namespace {

Table rest_table(const std::vector<BodyResult>& bodies) {
  Table table{"Bodies at rest",
              {TableColumn("Body"),
               {"east", "m", 2},
               {"north", "m", 2},
               {"Heading", "rad", 2},
               {"ahead", "m", 3},
               {"to port", "m", 3},
               {"up", "m", 3},
               {"roll", "rad", 3},
               {"pitch", "rad", 3},
               {"yaw", "rad", 3},
               {"east", "N", 2},
               {"north", "N", 2},
               {"up", "N", 2}},
              "dense summary"};
  table.groups(
      {{"", 1}, {"Place", 2}, {"", 1}, {"Offset from the nominal pose", 6}, {"Resultant force of all lines", 3}});
  for (const BodyResult& b : bodies) {
    table.row({b.name, b.place.x(), b.place.y(), b.heading, b.surge, b.sway, b.heave, b.roll, b.pitch, b.yaw,
               b.force.x(), b.force.y(), b.force.z()});
  }
  return table;
}

Table time_table(const std::vector<BodyDynamics>& bodies) {
  Table table{"Bodies over time", {TableColumn("Body"), TableColumn("Quantity"), TableColumn("Unit")}, "dense summary"};
  for (const char* statistic : {"min", "max", "mean", "std"}) table.column(TableColumn::texts(statistic));
  for (const BodyDynamics& body : bodies) {
    const auto add = [&](const char* name, const SummaryStatistics& spread, const char* unit) {
      std::vector<TableCell> cells = {body.name, name, shown_name(unit)};
      for (const double value : {spread.min, spread.max, spread.mean, spread.std}) {
        cells.push_back(shown_number(value, unit, 3));
      }
      table.row(cells);
    };
    add("surge", body.surge, "m");
    add("sway", body.sway, "m");
    add("heave", body.heave, "m");
    add("roll", body.roll, "rad");
    add("pitch", body.pitch, "rad");
    add("yaw", body.yaw, "rad");
    add("horizontal force of all lines", body.pull, "N");
  }
  return table;
}

}  // namespace

Blocks bodies_section(const StaticResults& statics, const DynamicResults* dynamics) {
  if (statics.bodies.empty()) return {};
  Blocks body = rest_table(statics.bodies);
  if (dynamics != nullptr) body += time_table(dynamics->bodies);
  return block::section("bodies", "Bodies", body);
}

}  // namespace overbend
