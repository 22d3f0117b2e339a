/// Line pipe grades: properties that follow from a specified yield stress.
#pragma once

#include <optional>
#include <string>

namespace overbend {

struct SteelGrade {
  const char* name;
  double yield_stress;      ///< SMYS [Pa].
  double tensile_strength;  ///< SMTS [Pa].
};

/// Returns the grade of API 5L with this SMYS [Pa], within 2.5 MPa, so that values rounded from ksi and from MPa both
/// match. The table contains both series; SMTS is from the nearer one.
std::optional<SteelGrade> find_grade(double yield_stress);

/// Allowed strains of the simplified laying criteria [-].
struct LayingLimits {
  const char* grade;       ///< Grade of the table row.
  double yield_stress;     ///< SMYS of that grade [Pa].
  double static_strain;    ///< Criterion I.
  double combined_strain;  ///< Criterion II: static and dynamic.
};

/// Returns the row of the nearest lower or equal grade for this SMYS, without interpolation; empty below X52.
/// DNV-ST-F101 sec. 13 "simplified laying criteria", recalled: no public restatement was found.
std::optional<LayingLimits> laying_limits(double yield_stress);

/// Returns the row of a grade by name ("X65"); empty if the table has no such row.
std::optional<LayingLimits> find_grade_limits(const std::string& grade);

}  // namespace overbend
