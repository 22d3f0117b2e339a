/// The pipe on the seabed: contacts, free spans and position on the route. SI.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace overbend {

/// A stretch of pipe in contact with the seabed; x astern of the stern shoe.
struct BedContactResult {
  double x_from = 0.0, x_to = 0.0;  ///< [m]
  double s_from = 0.0, s_to = 0.0;  ///< Arc length from the far end; `s_from` is nearer the vessel [m].
  double max_penetration = 0.0;     ///< [m]
};

/// A stretch between two contacts.
struct FreeSpanResult {
  double x_from = 0.0, x_to = 0.0;              ///< [m]
  double s_from = 0.0, s_to = 0.0;              ///< Arc length, as for contacts [m].
  double length = 0.0;                          ///< Unstressed [m].
  double max_gap = 0.0, gap_x = 0.0;            ///< Maximum gap between the underside and the seabed, and its position
                                                ///< [m].
  double sagging_moment = 0.0, moment_x = 0.0;  ///< Maximum moment and its position [N m], [m].
  double bending_stress = 0.0;                  ///< Maximum [Pa].
};

/// Seabed elevation under the line, for figures.
struct BedHeight {
  double x = 0.0;  ///< Distance astern of the stern shoe [m].
  double z = 0.0;  ///< Elevation above the mean water level [m].
};

/// The laid pipe on the seabed.
struct BedResults {
  std::vector<BedHeight> heights;                     ///< From the stern shoe to the far end.
  std::vector<BedContactResult> contacts;             ///< From the vessel astern.
  std::vector<FreeSpanResult> spans;                  ///< From the vessel astern.
  double max_penetration = 0.0, penetration_x = 0.0;  ///< [m]
  double hogging_moment = 0.0, hogging_x = 0.0;       ///< Maximum over the laid pipe and its position [N m], [m].
  double sagging_moment = 0.0, sagging_x = 0.0;       ///< Maximum over the laid pipe and its position [N m], [m].
  double bending_stress = 0.0;                        ///< Maximum over the laid pipe [Pa].
  double tail_tension = 0.0;                          ///< At the far end [N].
};

/// Position of the pipe on its route, and the forces that hold it there.
struct RouteResults {
  double radius = 0.0;  ///< Minimum radius of the route in plan behind touchdown; 0 for a straight route [m].
  double min_stable_radius = 0.0;  ///< Minimum stable radius for the bottom tension and lateral friction, H / (mu w); 0
                                   ///< without tension [m].
  bool holds = true;
  double max_offset = 0.0;          ///< Offset of the pipe on the seabed from its route, positive to port [m].
  double offset_x = 0.0;            ///< Position of that offset, astern of the stern shoe [m].
  double slid_length = 0.0;         ///< Length of pipe that has slid sideways [m].
  double laid_offset = 0.0;         ///< Offset of touchdown from the route, positive to port [m].
  double side_load_bed = 0.0;       ///< Lateral load of current and route on the seabed friction, to port [N].
  double side_load_supports = 0.0;  ///< Lateral load on rollers and tensioner, to port [N].
};

/// One limit case of roller friction.
struct RollerFrictionCase {
  std::string name;              ///< "lay", "haul", "port", "starboard", "frictionless".
  double top_tension = 0.0;      ///< [N]
  double bottom_tension = 0.0;   ///< [N]
  double lay_back = 0.0;         ///< [m]
  double tip_side = 0.0;         ///< Position of the pipe at the last row of the stinger, to port of the vessel's axis
                                 ///< [m].
  double off_roller = 0.0;       ///< Distance beyond the roller's face at that row; 0 if on the face [m].
  double overbend_stress = 0.0;  ///< Maximum von Mises stress [Pa].
  double sagbend_stress = 0.0;   ///< Maximum von Mises stress [Pa].
  double max_reaction = 0.0;     ///< [N]
};

}  // namespace overbend
