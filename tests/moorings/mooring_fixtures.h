/// Lines of the reference barges, for tests.
#pragma once

#include <string>

#include "base/json.h"
#include "model/description/description.h"

namespace overbend {

/// 64 mm six-strand wire with wire core, after the rules by diameter: mass 3989.7 d^2, volume diameter 0.80 d, sea
/// water of 1025 kg/m3, gravity of 9.81 m/s2 as the figures to compare with were made [N/m].
inline double barge_wire_submerged() {
  const double d = 0.064, volume_diameter = 0.80 * d;
  return 9.81 * (3989.7 * d * d - 1025.0 * 0.25 * 3.14159265358979323846 * volume_diameter * volume_diameter);
}

inline LineSegmentDescription make_segment(std::optional<double> length, double air, double submerged, double EA,
                                           double mbl) {
  LineSegmentDescription segment;
  segment.length = length;
  segment.type.weight_in_air = air;
  segment.type.weight_submerged = submerged;
  segment.type.axial_stiffness = EA;
  segment.type.breaking_load = mbl;
  return segment;
}

inline LineSegmentDescription reference_wire(std::optional<double> length) {
  return make_segment(length, 170.0, 148.0, 190e6, 2600e3);
}

inline LineSegmentDescription reference_chain(double length) {
  return make_segment(length, 1240.0, 1080.0, 520e6, 4900e3);
}

inline MooringLineDescription mooring_line(const std::string& name, const Vec3& fairlead, double azimuth_deg,
                                           double anchor_distance, std::optional<double> tension,
                                           std::vector<LineSegmentDescription> segments) {
  MooringLineDescription line;
  line.name = name;
  line.fairlead = fairlead;
  line.azimuth = azimuth_deg * 3.14159265358979323846 / 180.0;
  line.anchor_distance = anchor_distance;
  line.tension = tension;
  line.segments = std::move(segments);
  return line;
}

/// The reference barge of the cases MO*: 89 m of water, heading east.
inline Description reference_barge() {
  Description d;
  d.environment.water_depth = 89.0;
  d.vessel.length = 120.0;
  d.vessel.beam = 30.0;
  d.vessel.draught = 5.182;
  d.vessel.heading = 0.5 * 3.14159265358979323846;
  d.vessel.stern_shoe_x = -60.0;
  d.moorings.emplace();
  return d;
}

/// Eight wires, port and starboard alike, 350 kN as drawn; hydrostatics of the barge.
inline Description eight_line_barge() {
  Description d = reference_barge();
  d.vessel.hydrostatics = HydrostaticsDescription{36198.9e3, 2075448.0763818e3, 42799210.5763818e3};
  const double ahead = 58.0, side = 14.0, up = 3.8;
  const struct {
    const char* name;
    double x, y, azimuth;
  } lines[] = {{"S1", ahead, -side, 115},  {"S2", ahead, -side, 155}, {"S3", -ahead, -side, 205},
               {"S4", -ahead, -side, 245}, {"P1", ahead, side, 65},   {"P2", ahead, side, 25},
               {"P3", -ahead, side, 335},  {"P4", -ahead, side, 295}};
  for (const auto& line : lines) {
    d.moorings->lines.push_back(
        mooring_line(line.name, {line.x, line.y, up}, line.azimuth, 992.0, 350e3, {reference_wire(std::nullopt)}));
  }
  return d;
}

inline VesselLoadDescription vessel_load(const std::string& name, const Vec3& point, const Vec3& force,
                                         const Vec3& moment = Vec3::Zero()) {
  VesselLoadDescription load;
  load.name = name;
  load.at = point;
  load.force = force;
  load.moment = moment;
  return load;
}

/// The answers of a reference case.
inline Json expected_case(const std::string& name) {
  return read_json_file(std::string(OVERBEND_SOURCE_DIR) + "/validation/mooring_cases/" + name + ".expected.json");
}

}  // namespace overbend
