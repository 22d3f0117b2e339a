/// Where the pipe lies on the bed, where it spans, and how it lies on its route. SI.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace overbend {

/// A stretch of pipe that touches the bed; x astern of the stern shoe.
struct BedContactResult {
  double x_from = 0.0, x_to = 0.0;   ///< [m]
  double s_from = 0.0, s_to = 0.0;   ///< Arc length from the far end; `s_from` the one nearer the barge [m].
  double largest_penetration = 0.0;  ///< [m]
};

/// A stretch between two contacts.
struct FreeSpanResult {
  double x_from = 0.0, x_to = 0.0;              ///< [m]
  double s_from = 0.0, s_to = 0.0;              ///< As of contacts [m].
  double length = 0.0;                          ///< Unstressed [m].
  double largest_gap = 0.0, gap_x = 0.0;        ///< Of the underside over the bed, and where [m].
  double sagging_moment = 0.0, moment_x = 0.0;  ///< Largest, and where [N m], [m].
  double bending_stress = 0.0;                  ///< Largest [Pa].
};

/// Height of the bed under the line, for figures.
struct BedHeight {
  double x = 0.0;  ///< Astern of the stern shoe [m].
  double z = 0.0;  ///< [m]
};

/// The laid pipe on the bed.
struct BedResults {
  std::vector<BedHeight> heights;                         ///< From the stern shoe to the far end.
  std::vector<BedContactResult> contacts;                 ///< From the barge astern.
  std::vector<FreeSpanResult> spans;                      ///< Likewise.
  double largest_penetration = 0.0, penetration_x = 0.0;  ///< [m]
  double hogging_moment = 0.0, hogging_x = 0.0;           ///< Largest over the laid pipe [N m], [m].
  double sagging_moment = 0.0, sagging_x = 0.0;           ///< Likewise.
  double bending_stress = 0.0;                            ///< Largest over the laid pipe [Pa].
  double tail_tension = 0.0;                              ///< At the far end [N].
};

/// How the pipe lies on its route, and what holds it there.
struct RouteResults {
  double radius = 0.0;        ///< Smallest of the route in plan behind touchdown; 0: straight [m].
  double least_radius = 0.0;  ///< That bottom tension and lateral friction hold, H / (mu w) [m]; 0 without tension.
  bool holds = true;
  double largest_offset = 0.0;      ///< Of the pipe on the bed from its route, to port positive [m].
  double offset_x = 0.0;            ///< Where, astern of the stern shoe [m].
  double slid_length = 0.0;         ///< Of pipe that has slid sideways [m].
  double laid_offset = 0.0;         ///< Of touchdown from the route, to port [m].
  double side_load_bed = 0.0;       ///< Of the current and the route on the bed's friction, to port [N].
  double side_load_supports = 0.0;  ///< On rollers and tensioner, to port [N].
};

/// One answer to how rollers hold the pipe by friction.
struct RollerFrictionCase {
  std::string name;               ///< "lay", "haul", "port", "starboard", "frictionless".
  double top_tension = 0.0;       ///< [N]
  double bottom_tension = 0.0;    ///< [N]
  double lay_back = 0.0;          ///< [m]
  double tip_side = 0.0;          ///< Pipe at the last row of the stinger, to port of the barge's axis [m].
  double off_roller = 0.0;        ///< How far it runs off its roller's face there, 0 on it [m].
  double overbend_stress = 0.0;   ///< Largest von Mises [Pa].
  double sagbend_stress = 0.0;    ///< Largest von Mises [Pa].
  double largest_reaction = 0.0;  ///< [N]
};

}  // namespace overbend
