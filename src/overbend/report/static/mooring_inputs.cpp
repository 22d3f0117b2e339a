#include "report/static/mooring_inputs.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "base/shown_unit.h"
#include "report/page/listing.h"
#include "report/page/quantity.h"

namespace overbend {
namespace {

std::string force(const std::optional<double>& value) {
  return value ? general(*value, "N") : "-";
}

std::string triple(const Vec3& v) {
  return general(v.x(), "m") + ", " + general(v.y(), "m") + ", " + general(v.z(), "m");
}

std::string damping_text(const ModeDampingDescription& damping) {
  std::string label;
  const auto add = [&](const std::string& text) { label += (label.empty() ? "" : ", ") + text; };
  if (damping.ratio) add(general(100.0 * *damping.ratio) + " % of critical");
  const bool turns = damping.mode == "roll" || damping.mode == "pitch" || damping.mode == "yaw";
  const double force = shown_unit("N").factor,
               length = shown_unit("m").factor;  // per angle for a moment, else per length
  if (damping.linear) add("linear " + general(*damping.linear * force * (turns ? length : 1.0 / length)));
  if (damping.quadratic) {
    add("quadratic " + general(*damping.quadratic * force * (turns ? length : std::pow(length, -2))));
  }
  return label;
}

std::string current_text(const HullCurrentDescription& current) {
  switch (current.form) {
    case HullCurrentModel::none:
      return "none";
    case HullCurrentModel::table:
      return "table " + std::filesystem::path(current.table_file).filename().string();
    case HullCurrentModel::ufc:
      return "coefficients of UFC 4-159-03";
    case HullCurrentModel::strips:
      break;
  }
  return "strips, " + general(current.transverse) + " across, " + general(current.longitudinal) + " along";
}

const char* drift_text(WaveDrift drift) {
  return drift == WaveDrift::none ? "none" : drift == WaveDrift::mean ? "mean only" : "mean and slow, by Newman";
}

using Types = std::vector<const LineTypeDescription*>;

void add_types(const std::vector<LineSegmentDescription>& segments, Types& types) {
  for (const LineSegmentDescription& segment : segments) {
    const auto same = [&](const LineTypeDescription* type) {
      return type->name == segment.type.name && type->diameter == segment.type.diameter &&
             type->axial_stiffness == segment.type.axial_stiffness;
    };
    if (std::none_of(types.begin(), types.end(), same)) types.push_back(&segment.type);
  }
}

Table type_table(const Types& types) {
  Table table{"Types of line",
              {TableColumn("Type"),
               TableColumn::texts("Diameter", section_length().name),
               {"In air", line_weight(), 1},
               {"Submerged", line_weight(), 1},
               {"EA", rope_stiffness(), 1},
               TableColumn::texts("EI", shown_name("N m2")),
               TableColumn::texts("Breaking load", shown_name("N")),
               TableColumn::texts("Drag, normal and axial"),
               TableColumn::texts("Friction"),
               TableColumn("Made from")},
              "dense summary"};
  for (const LineTypeDescription* type : types) {
    table.row({type->name.empty() ? "in place" : type->name, general(type->diameter, section_length()),
               type->weight_in_air, type->weight_submerged, type->axial_stiffness,
               general(type->bending_stiffness, "N m2"), force(type->breaking_load),
               general(type->drag_normal) + ", " + general(type->drag_axial),
               type->friction ? general(*type->friction) : "-", type->made_from});
  }
  return table;
}

Table winch_table(const std::vector<WinchDescription>& winches) {
  const auto column = [](const char* title, std::string_view si) { return TableColumn::texts(title, shown_name(si)); };
  Table table{"Winches",
              {TableColumn("Winch"), column("Speed", "m/s"), column("Haul", "N"), column("Stall", "N"),
               column("Brake", "N"), column("Drum", "m")}};
  for (const WinchDescription& winch : winches) {
    table.row({winch.name, general(winch.speed, "m/s"), force(winch.haul), force(winch.stall), force(winch.brake),
               winch.drum ? general(*winch.drum, "m") : "-"});
  }
  return table;
}

std::string anchor_text(const MooringLineDescription& line) {
  std::string text;
  if (line.anchor) {
    text =
        fmt::format("x {}, y {} {}", general((*line.anchor)[0], "m"), general((*line.anchor)[1], "m"), shown_name("m"));
  }
  if (line.bearing) text = "bearing " + shown_number(*line.bearing, "rad", 1) + " deg";
  if (line.azimuth) text = "azimuth " + shown_number(*line.azimuth, "rad", 1) + " deg";
  if (line.anchor_distance) text += ", " + general(*line.anchor_distance, "m") + " " + shown_name("m");
  return text;
}

Blocks fairleads(const MooringsDescription& moorings) {
  Table table{"Fairleads and anchors as given",
              {TableColumn("Line"),
               TableColumn::texts("Fairlead x, y, z", shown_name("m")),
               TableColumn("Anchor"),
               TableColumn::texts("Target tension", shown_name("N")),
               {"Length", "m", 2},
               TableColumn("Winch"),
               TableColumn::texts("Holding power", shown_name("N"))},
              "dense summary"};
  for (const MooringLineDescription& line : moorings.lines) {
    double prescribed = 0.0;
    for (const LineSegmentDescription& segment : line.segments) prescribed += segment.length.value_or(0.0);
    table.row({line.name, triple(line.fairlead), anchor_text(line), force(line.tension),
               prescribed > 0.0 ? TableCell(prescribed) : TableCell("-"), line.winch,
               force(line.anchor_holding.holding)});
  }
  return table + block::remark(
                     "Fairleads in the vessel's frame. Bearings from the bow and azimuths from north, both "
                     "clockwise. A length of - is calculated from the tension.");
}

}  // namespace

Table hull_inputs(const Description& model) {
  const VesselDescription& vessel = model.vessel;
  if (vessel.hydrostatics) {
    Listing list("Floating hull");
    list.add("Restoring in heave", vessel.hydrostatics->heave, "N/m")
        .add("Restoring in roll, pitch", {vessel.hydrostatics->roll, vessel.hydrostatics->pitch}, "N m/rad");
    if (!vessel.coupled) return list.table();
  }
  if (!vessel.coupled) return {};
  const CoupledHullDescription& hull = *vessel.coupled;
  Listing list("Floating hull");
  list.add("Hydrodynamic coefficients", std::filesystem::path(hull.hydrodynamics).filename().string())
      .add("Mass", hull.mass, "kg")
      .add("Centre of gravity x, y, z",
           {hull.centre_of_gravity.x(), hull.centre_of_gravity.y(), hull.centre_of_gravity.z()}, "m")
      .add("Gyration in roll, pitch, yaw", {hull.gyration.x(), hull.gyration.y(), hull.gyration.z()}, "m")
      .add("Ballast", hull.ballast == Ballast::trim ? "keeps the trim" : "as given")
      .add("Radiation", hull.radiation == Radiation::state_space ? "state space" : "convolution")
      .add("Wave drift", drift_text(hull.wave_drift))
      .add("Wave drift damping", hull.wave_drift_damping == WaveDriftDamping::none ? "none" : "Aranha")
      .add("Current on the hull", current_text(hull.current))
      .add("Low-pass filter of position and heading", hull.low_frequency_period, "s");
  for (const ModeDampingDescription& damping : hull.damping) {
    list.add("Damping in " + damping.mode, damping_text(damping),
             damping.ratio ? "" : shown_name("N") + ", " + shown_name("m") + ", s");
  }
  if (!hull.wind.areas.empty()) {
    list.add("Wind from " + general(hull.wind.from, "rad") + " deg", hull.wind.speed, "m/s");
  }
  return list.table();
}

Blocks mooring_inputs(const Description& model) {
  if (!model.moorings || model.moorings->lines.empty()) return {};
  Types types;
  for (const MooringLineDescription& line : model.moorings->lines) add_types(line.segments, types);
  return type_table(types) + fairleads(*model.moorings) + winch_table(model.moorings->winches);
}

Table line_inputs(const Description& model) {
  Types types;
  for (const FreeLineDescription& line : model.lines) add_types(line.segments, types);
  return type_table(types);
}

}  // namespace overbend
