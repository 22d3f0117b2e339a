/// Line pipe grades: what a specified yield stress says about the steel.
#pragma once

#include <optional>
#include <string>

namespace overbend {

struct SteelGrade {
  const char* name;
  double yield_stress;      ///< SMYS [Pa].
  double tensile_strength;  ///< SMTS [Pa].
};

/// The grade of API 5L with this SMYS [Pa], within 2.5 MPa, so that values rounded from ksi and from MPa both find
/// theirs. The table holds both series; SMTS is of the one that is nearer.
std::optional<SteelGrade> grade_of(double yield_stress);

/// Allowed strains of the simplified laying criteria [-].
struct LayingLimits {
  const char* grade;       ///< Of the table's row.
  double yield_stress;     ///< SMYS of that grade [Pa].
  double static_strain;    ///< Criterion I.
  double combined_strain;  ///< Criterion II: static and dynamic.
};

/// The row of the nearest lower or equal grade for this SMYS; none below X52. Nothing is interpolated. DNV-ST-F101 sec.
/// 13 "simplified laying criteria", recalled: no public restatement was found.
std::optional<LayingLimits> laying_limits(double yield_stress);

/// The row of a grade by name ("X65"); none where the table has no such row.
std::optional<LayingLimits> laying_limits_of(const std::string& grade);

}  // namespace overbend
