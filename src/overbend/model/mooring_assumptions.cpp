#include "model/mooring_assumptions.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/shown_unit.h"
#include "model/pipe/line_types.h"

namespace overbend {
namespace {

Assumption current_assumption(const HullCurrentDescription& current) {
  switch (current.form) {
    case HullCurrentModel::none:
      return {AssumptionRank::other, "The current does not act on the hull."};
    case HullCurrentModel::table:
      return {AssumptionRank::other,
              fmt::format("The current acts on the hull by the table of coefficients {}.", current.table_file)};
    case HullCurrentModel::ufc:
      return {AssumptionRank::governing,
              "The current acts on the hull by the coefficients of UFC 4-159-03 for a ship or barge of its dimensions; "
              "sharp edges may double the transverse force, and the offset of the vessel depends on them."};
    case HullCurrentModel::strips:
      break;
  }
  return {
      AssumptionRank::governing,
      fmt::format("The current acts on the hull by strips along its length, with drag coefficients of {:.3g} across "
                  "and {:.3g} along; these are uncertain by 50 %, and the offset of the vessel depends on them.",
                  current.transverse, current.longitudinal)};
}

/// Formats a length without its unit.
std::string length_number(double length) {
  return shown_digits_number(length, shown_unit("m"), 4);
}

void assume_coupled(Assumptions& list, const Model& model) {
  const CoupledHullDescription& hull = *model.description.vessel.coupled;
  list.push_back(
      {AssumptionRank::setting,
       fmt::format("The hull is a rigid body of {} with radii of gyration of {}, {} and {}, without "
                   "products of inertia; forces of the water are linear, from {}.",
                   shown_digits(hull.mass, "kg", 6), length_number(hull.gyration.x()), length_number(hull.gyration.y()),
                   shown_digits(hull.gyration.z(), "m", 4), hull.hydrodynamics)});
  list.push_back({AssumptionRank::other,
                  hull.ballast == Ballast::trim
                      ? "Ballast: constant forces keep draught, heel and trim as given, with lines and pipe attached."
                      : "Ballast: the mass is as given, and the hull sinks under the pull of lines and pipe."});
  if (hull.data && hull.data->file_origin_V) {
    const Vec3& p = *hull.data->file_origin_V;
    list.push_back({AssumptionRank::other,
                    fmt::format("The hydrodynamic coefficients are transferred from their reference point ({}, {}, {}) "
                                "{} to the centre of gravity.",
                                length_number(p.x()), length_number(p.y()), length_number(p.z()), shown_name("m"))});
  }
  if (hull.data) {
    for (const std::string& note : hull.data->notes) list.push_back({AssumptionRank::other, note});
  }
  if (!model.current.z.empty()) list.push_back(current_assumption(hull.current));
  if (hull.wind.speed <= 0.0) {
    list.push_back({AssumptionRank::other, "There is no wind."});
  } else {
    list.push_back({AssumptionRank::other,
                    fmt::format("A steady wind of {} acts on the hull by {}.", shown_digits(hull.wind.speed, "m/s", 3),
                                hull.wind.table_file.empty() ? std::string("areas with shape and height coefficients")
                                                             : "the table of coefficients " + hull.wind.table_file)});
  }
  if (hull.wave_drift == WaveDrift::newman && hull.data && !hull.data->mean_drift.empty()) {
    list.push_back({AssumptionRank::governing,
                    "Slowly varying drift follows from mean drift (Newman's approximation), in surge, sway and yaw; it "
                    "is underestimated in shallow water."});
  }
  list.push_back(
      {AssumptionRank::other,
       fmt::format(
           "Wave phases and heading follow the low-frequency motion of the hull, from a low-pass filter of {:.4g} s.",
           hull.low_frequency_period)});
}

void assume_types(Assumptions& list, const std::vector<LineSegmentDescription>& segments,
                  std::set<std::string>& listed) {
  for (const LineSegmentDescription& segment : segments) {
    const LineTypeDescription& type = segment.type;
    if (type.made_from.empty() || type.made_from == kGivenNumbers || !listed.insert(type.made_from).second) continue;
    list.push_back(
        {AssumptionRank::other,
         fmt::format(
             "Line type '{}' is a {}: {}, EA {}{}, from fits to makers' tables; drag {:.3g} on {}.", type.name,
             type.made_from, shown(type.weight_in_air / kGravity, "kg/m", 2),
             shown(type.axial_stiffness, axial_stiffness_unit(), 1),
             type.breaking_load ? fmt::format(", breaking load {}", shown(*type.breaking_load, "N", 0)) : std::string(),
             type.drag_normal, shown_digits(type.drag_diameter, section_length(), 4))});
  }
}

void assume_moorings(Assumptions& list, const MooringsDescription& moorings, std::set<std::string>& listed) {
  if (moorings.lines.empty()) return;
  for (const MooringLineDescription& line : moorings.lines) assume_types(list, line.segments, listed);
  list.push_back({AssumptionRank::other,
                  "A fairlead is a fixed point of the vessel: the radius and friction of its sheave and the line from "
                  "there to the winch are not modelled."});
  const bool slides = std::any_of(moorings.lines.begin(), moorings.lines.end(),
                                  [](const MooringLineDescription& line) { return line.anchor_holding.slides; });
  list.push_back({AssumptionRank::other,
                  slides ? "Anchors that may slide do so along their line when its load exceeds the holding power less "
                           "the uplift; the others are fixed."
                         : "Anchors are fixed points; if their holding power is given, its utilisation is reported."});
  if (moorings.model == MooringModel::quasi_static) {
    list.push_back({AssumptionRank::other,
                    "In the dynamic analysis mooring lines are quasi-static elastic catenaries without mass, drag and "
                    "wave loads."});
  }
}

}  // namespace

void assume_floating(Assumptions& list, const Model& model) {
  const Description& d = model.description;
  std::set<std::string> listed;
  if (d.vessel.coupled) assume_coupled(list, model);
  if (d.vessel.hydrostatics) {
    list.push_back({AssumptionRank::other,
                    "The hull has linear hydrostatic stiffness in heave, roll and pitch and is balanced as drawn "
                    "without lines and pipe: it sinks a little under their load."});
  }
  if (d.moorings) assume_moorings(list, *d.moorings, listed);
  if (d.moorings && model.seabed.surface.shape() != nullptr) {
    list.push_back({AssumptionRank::other,
                    "On an uneven seabed a catenary mooring line has its seabed on the straight line from below its "
                    "fairlead to its anchor; lines of elements lie on the seabed itself."});
  }
  for (const FreeLineDescription& line : d.lines) assume_types(list, line.segments, listed);
  if (d.station_keeping) {
    list.push_back({AssumptionRank::other,
                    "Dynamic positioning is a spring, a damper and a limit on the low-frequency motion; thrusters have "
                    "no delay."});
  }
}

}  // namespace overbend
