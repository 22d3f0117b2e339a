/// Fatigue of girth welds during laying. SI.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace overbend {

/// S-N curves of DNV-RP-C203: B1, B2, C, C1, C2, D, E, F, F1, F3, G, W1, W2, W3.
enum class FatigueCurve { b1, b2, c, c1, c2, d, e, f, f1, f3, g, w1, w2, w3 };

/// Editions of DNV-RP-C203: April 2016 and October 2024.
enum class FatigueEdition { year_2016, year_2024 };

enum class FatigueMedium { air, seawater_protected, seawater_free };

/// Hot spot of the weld with its S-N curve.
struct FatigueSpotDescription {
  std::string name;
  bool inside = false;  ///< True: inner surface of the wall; false: outer surface.
  FatigueCurve curve = FatigueCurve::d;
  std::optional<FatigueMedium> medium;  ///< If not given: air above the water, seawater_protected below.
  std::optional<double> stress_factor;  ///< Hot-spot stress divided by nominal stress; from hi_lo if not given.
};

struct FatigueDescription {
  FatigueEdition edition = FatigueEdition::year_2016;  ///< Edition of the S-N curves.
  std::vector<FatigueSpotDescription> spots;
  double hi_lo = 0.0;               ///< Misalignment of the walls at the weld [m].
  std::optional<double> thickness;  ///< Thickness for the thickness effect [m]; that of the wall if not given.
  double weld_time = 0.0;           ///< Waiting time of the pipe before each move by one joint [s].
  double move_time = 0.0;           ///< Duration of the move [s].
  std::optional<double> joint;      ///< Length of a move [m]; that of a pipe joint if not given.
  double budget = 0.1;              ///< Allowed damage during laying, design fatigue factor included.
  double design_factor = 1.0;       ///< Design fatigue factor, multiplies the damage.
};

}  // namespace overbend
