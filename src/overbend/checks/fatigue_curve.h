/// S-N curves of DNV-RP-C203 and the hot spot factor of a girth weld.
#pragma once

#include "model/description/fatigue_description.h"

namespace overbend {

/// Returns "DNV-RP-C203 (2016)" or the name of the other edition.
const char* fatigue_code(FatigueEdition edition);

/// Two straight lines in log S and log N; stress ranges of hot spots [Pa].
struct SnCurve {
  double slope = 3.0, log_a = 0.0;              ///< For large ranges, as in the table: MPa.
  double slope_below = 5.0, log_a_below = 0.0;  ///< For ranges below the knee.
  double knee = 0.0;                            ///< Intersection of the lines [Pa]; 0 for a single line.
  double thickness_exponent = 0.0;              ///< k

  /// Returns the damage of one cycle, 1/N; 0 for a range of 0.
  double damage(double range) const;
  /// Returns the range whose damage per cycle is `damage` [Pa].
  double find_range(double damage) const;
};

/// Returns the curve of tables 2-1, 2-2 and 2-4: log N = log a - m log S. In the edition of 2024 C, C1 and C2 have
/// another slope in air and in protected seawater, B1 and B2 other constants in protected seawater; the rest is that of
/// 2016.
SnCurve sn_curve(FatigueCurve curve, FatigueMedium medium, FatigueEdition edition = FatigueEdition::year_2016);

/// (t/25 mm)^k, factor on stress ranges for the wall thickness; 1 for walls thinner than the reference, DNV-RP-C203
/// 2.4. `thickness` [m].
double thickness_effect(const SnCurve& curve, double thickness);

/// Ratio of the stress at the weld to the nominal one for a wall offset `hi_lo`: 1 + 3 (e/t) exp(-(D/t)^-0.5), Connelly
/// and Zettlemoyer (1993), DNV-RP-C203 2.10. Lengths [m].
double hi_lo_factor(double hi_lo, double diameter, double thickness);

}  // namespace overbend
