/// Fatigue of girth welds while the pipe is laid. SI.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace overbend {

/// Of DNV-RP-C203: B1, B2, C, C1, C2, D, E, F, F1, F3, G, W1, W2, W3.
enum class FatigueCurve { b1, b2, c, c1, c2, d, e, f, f1, f3, g, w1, w2, w3 };

/// Of DNV-RP-C203: April 2016 and October 2024.
enum class FatigueEdition { year_2016, year_2024 };

enum class FatigueMedium { air, seawater_protected, seawater_free };

/// A place of the weld that is looked at, with its curve.
struct FatigueSpotDescription {
  std::string name;
  bool inside = false;  ///< At the inner surface of the wall, else at the outer.
  FatigueCurve curve = FatigueCurve::d;
  std::optional<FatigueMedium> medium;  ///< Air above and protected seawater below the water where not given.
  std::optional<double> stress_factor;  ///< Hot spot over nominal stress; from hi-lo where not given.
};

struct FatigueDescription {
  FatigueEdition edition = FatigueEdition::year_2016;  ///< Of the S-N curves.
  std::vector<FatigueSpotDescription> spots;
  double hi_lo = 0.0;               ///< Misalignment of the walls at the weld [m].
  std::optional<double> thickness;  ///< For the thickness effect [m]; the wall's where not given.
  double weld_time = 0.0;           ///< Wait of the pipe for each move of a joint [s].
  double move_time = 0.0;           ///< Of the move itself [s].
  std::optional<double> joint;      ///< Length of a move [m]; of the pipe's joints where not given.
  double budget = 0.1;              ///< Damage that laying may use up, design fatigue factor included.
  double design_factor = 1.0;       ///< Damage is multiplied by it.
};

}  // namespace overbend
