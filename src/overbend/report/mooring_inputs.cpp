#include "report/mooring_inputs.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "base/constants.h"
#include "report/listing.h"

namespace overbend {
namespace {

using html::fixed;

std::string kilo(const std::optional<double>& value) {
  return value ? general(1e-3 * *value) : "-";
}

std::string triple(const Vec3& v) {
  return general(v.x()) + ", " + general(v.y()) + ", " + general(v.z());
}

std::string damping_words(const ModeDampingDescription& damping) {
  std::string words;
  const auto add = [&](const std::string& text) { words += (words.empty() ? "" : ", ") + text; };
  if (damping.ratio) add(general(100.0 * *damping.ratio) + " % of critical");
  if (damping.linear) add("linear " + general(1e-3 * *damping.linear));
  if (damping.quadratic) add("quadratic " + general(1e-3 * *damping.quadratic));
  return words;
}

std::string current_words(const HullCurrentDescription& current) {
  switch (current.form) {
    case HullCurrentForm::none:
      return "none";
    case HullCurrentForm::table:
      return "table " + std::filesystem::path(current.table_file).filename().string();
    case HullCurrentForm::ufc:
      return "coefficients of UFC 4-159-03";
    case HullCurrentForm::strips:
      break;
  }
  return "strips, " + general(current.transverse) + " across, " + general(current.longitudinal) + " along";
}

const char* drift_words(WaveDrift drift) {
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

std::string type_table(const Types& types) {
  html::Table table("Types of line",
                    {{"Type", "", true},
                     {"Diameter", "mm"},
                     {"In air", "N/m"},
                     {"Submerged", "N/m"},
                     {"EA", "MN"},
                     {"EI", "kN m2"},
                     {"Breaking load", "kN"},
                     {"Drag, normal and axial", ""},
                     {"Friction", ""},
                     {"Made from", "", true}},
                    "dense summary");
  for (const LineTypeDescription* type : types) {
    table.row({type->name.empty() ? "in place" : type->name, general(1e3 * type->diameter),
               fixed(type->weight_in_air, 1), fixed(type->weight_submerged, 1), fixed(1e-6 * type->axial_stiffness, 1),
               general(1e-3 * type->bending_stiffness), kilo(type->breaking_load),
               general(type->drag_normal) + ", " + general(type->drag_axial),
               type->friction ? general(*type->friction) : "-", type->made_from});
  }
  return table.str();
}

std::string winch_table(const std::vector<WinchDescription>& winches) {
  if (winches.empty()) return "";
  html::Table table(
      "Winches",
      {{"Winch", "", true}, {"Speed", "m/s"}, {"Haul", "kN"}, {"Stall", "kN"}, {"Brake", "kN"}, {"Drum", "m"}},
      "plain");
  for (const WinchDescription& winch : winches) {
    table.row({winch.name, general(winch.speed), kilo(winch.haul), kilo(winch.stall), kilo(winch.brake),
               winch.drum ? general(*winch.drum) : "-"});
  }
  return table.str();
}

std::string fairlead_table(const MooringsDescription& moorings) {
  html::Table table("Fairleads and anchors as given",
                    {{"Line", "", true},
                     {"Fairlead x, y, z", "m"},
                     {"Anchor", "", true},
                     {"Wished tension", "kN"},
                     {"Length", "m"},
                     {"Winch", "", true},
                     {"Holding power", "kN"}},
                    "dense summary");
  for (const MooringLineDescription& line : moorings.lines) {
    std::string anchor = line.anchor
                             ? fmt::format("x {}, y {} m", general((*line.anchor)[0]), general((*line.anchor)[1]))
                             : std::string();
    if (line.bearing) anchor = "bearing " + fixed(*line.bearing * kToDegrees, 1) + " deg";
    if (line.azimuth) anchor = "azimuth " + fixed(*line.azimuth * kToDegrees, 1) + " deg";
    if (line.anchor_distance) anchor += ", " + general(*line.anchor_distance) + " m";
    double given = 0.0;
    for (const LineSegmentDescription& segment : line.segments) given += segment.length.value_or(0.0);
    table.row({line.name, triple(line.fairlead), anchor, kilo(line.tension), given > 0.0 ? fixed(given, 2) : "-",
               line.winch, kilo(line.anchor_holding.holding)});
  }
  return table.str() +
         "<p class=\"small\">Fairleads in the vessel's frame. Bearings from the bow and azimuths from "
         "north, both clockwise. A length of - follows from the tension.</p>\n";
}

}  // namespace

std::string hull_inputs(const Description& model) {
  const VesselDescription& vessel = model.vessel;
  if (vessel.hydrostatics) {
    Listing list("Floating hull");
    list.add("Restoring in heave", 1e-3 * vessel.hydrostatics->heave, "kN/m")
        .add("Restoring in roll, pitch",
             general(1e-3 * vessel.hydrostatics->roll) + ", " + general(1e-3 * vessel.hydrostatics->pitch), "kN m/rad");
    if (!vessel.coupled) return list.str();
  }
  if (!vessel.coupled) return "";
  const CoupledHullDescription& hull = *vessel.coupled;
  Listing list("Floating hull");
  list.add("Hydrodynamic coefficients", std::filesystem::path(hull.hydrodynamics).filename().string())
      .add("Mass", 1e-3 * hull.mass, "t")
      .add("Centre of gravity x, y, z", triple(hull.centre_of_gravity), "m")
      .add("Gyration in roll, pitch, yaw", triple(hull.gyration), "m")
      .add("Ballast", hull.ballast == Ballast::trim ? "keeps the trim" : "as given")
      .add("Radiation", hull.radiation == Radiation::state_space ? "state space" : "convolution")
      .add("Wave drift", drift_words(hull.wave_drift))
      .add("Wave drift damping", hull.wave_drift_damping == WaveDriftDamping::none ? "none" : "Aranha")
      .add("Current on the hull", current_words(hull.current))
      .add("Low-pass of place and heading", hull.slow_period, "s");
  for (const ModeDampingDescription& damping : hull.damping) {
    list.add("Damping in " + damping.mode, damping_words(damping), damping.ratio ? "" : "kN, m, s");
  }
  if (!hull.wind.areas.empty()) {
    list.add("Wind from " + general(hull.wind.from * kToDegrees) + " deg", hull.wind.speed, "m/s");
  }
  return list.str();
}

std::string mooring_inputs(const Description& model) {
  if (!model.moorings || model.moorings->lines.empty()) return "";
  Types types;
  for (const MooringLineDescription& line : model.moorings->lines) add_types(line.segments, types);
  return type_table(types) + fairlead_table(*model.moorings) + winch_table(model.moorings->winches);
}

std::string line_inputs(const Description& model) {
  if (model.lines.empty()) return "";
  Types types;
  for (const FreeLineDescription& line : model.lines) add_types(line.segments, types);
  return type_table(types);
}

}  // namespace overbend
