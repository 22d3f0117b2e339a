/// Capacities of a cross-section under the settings of the checks: computed once, read at every station and step.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "checks/api_1111.h"
#include "checks/dnv_combined.h"
#include "checks/dnv_strain.h"
#include "checks/load_effects.h"
#include "checks/steel_grades.h"
#include "model/model.h"

namespace overbend {

/// Fraction of f_y for the equivalent stress in the sagbend (ST-F101 sec. 13) and of lifted pipe.
inline constexpr double kStressShare = 0.87;

struct CheckSection {
  std::string name;           ///< Name as in Model::sections.
  bool cable = false;         ///< True for a cable: pipe codes do not apply.
  Wall wall;                  ///< Wall with t2, the nominal wall.
  double thinnest = 0.0;      ///< t1 [m].
  double smys = 0.0;          ///< [Pa]
  double smts = 0.0;          ///< [Pa]; 0 if neither given nor known from the grade.
  std::string grade_of_smts;  ///< Name of the grade that gave the tensile strength; empty if given in the file.
  double fy = 0.0, fu = 0.0;  ///< Characteristic strengths [Pa].
  double alpha_fab = 0.0;
  double factor = 0.0;                                                ///< gamma_m gamma_SC [-].
  double collapse_thinnest = 0.0, collapse = 0.0, propagation = 0.0;  ///< p_c(t1), p_c(t2), p_pr [Pa].
  double strain_capacity = 0.0;                                       ///< eps_c(t2, 0) [-].
  LoadCapacity load;
  StrainCapacity strain;
  std::optional<LayingLimits> laying;
  bool laying_exact = false;   ///< True if the row is for the grade of this SMYS, or was named in the file.
  double stress_limit = 0.0;   ///< 0.87 f_y [Pa].
  double strain_factor = 1.0;  ///< Strain concentration factor at field joints.
  ApiPipe api;
  double api_collapse_share = 0.0;   ///< f_o
  double api_pressure_factor = 0.0;  ///< f_c
  double api_delta = 0.0;
};

CheckSection make_check_section(const SectionDescription& section, const CheckSettings& settings);

/// Returns the sections in the order of Model::sections.
std::vector<CheckSection> check_sections(const Model& model);

/// Returns combination b, and a if system effects are present.
std::vector<LoadFactors> load_combinations(const CheckSettings& settings);

}  // namespace overbend
