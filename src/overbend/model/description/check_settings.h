/// Settings of the code checks: the `checks` section of the model file, in SI units. Defaults give a complete
/// table without it.
#pragma once

#include <optional>
#include <string>

namespace overbend {

enum class CheckCodes { both, dnv, api };
enum class SafetyClass { low, medium, high };
enum class Manufacture { seamless, erw, hfw, trb, uo, uoe };
enum class YieldBasis { smys, fy };
enum class ApiEdition { third, fourth, fifth };
enum class CurrentLoad { environmental, functional };

/// A buckle arrestor, as used by the propagation check.
struct ArrestorSettings {
  double propagation_pressure = 0.0;  ///< Of the arrestor itself, p_BA [Pa].
  double length = 0.0;                ///< [m]
};

/// API RP 1111.
struct ApiSettings {
  ApiEdition edition = ApiEdition::fifth;
  std::optional<double> collapse_factor;           ///< f_o; from the manufacture where not given [-].
  double bending_factor = 3.33;                    ///< f_1 on the strain of installation [-].
  std::optional<double> combined_collapse_factor;  ///< f_c; from the edition where not given [-].
  std::optional<double> ovality;  ///< delta = (D_max - D_min)/(D_max + D_min); half of O_0 where not given [-].
};

/// Allowed von Mises stress over SMYS, where a project still works so; none is checked that is not given [-].
struct YieldShares {
  std::optional<double> overbend_static, overbend_dynamic, sagbend_static, sagbend_dynamic;
};

/// Limits of the lay equipment and the coating; none is checked that is not given.
struct EquipmentLimits {
  std::optional<double> roller_load;        ///< Of one roller [N].
  std::optional<double> coating_line_load;  ///< Roller force over the length of coating under it [N/m].
  std::optional<double> tension;            ///< At the tensioner [N].
  std::optional<double> tip_clearance;      ///< Least distance of the pipe from the stinger's last roller [m].
};

/// Required strength over load of lines, anchors and cables; by code and analysis where not given, see
/// checks/mooring_rows.h [-].
struct SafetyFactors {
  std::optional<double> mooring_intact, mooring_damaged;
  std::optional<double> anchor_intact, anchor_damaged;
  std::optional<double> cable;  ///< Wire of abandonment and recovery, start-up wire.
  std::optional<double> line;   ///< Lines by themselves, hawsers.
};

struct CheckSettings {
  CheckCodes codes = CheckCodes::both;
  SafetyClass safety_class = SafetyClass::low;
  std::optional<Manufacture> manufacture;   ///< UOE, the weakest, is taken where not given.
  double alpha_u = 0.96;                    ///< Material strength factor [-].
  std::optional<double> alpha_fab;          ///< Fabrication factor instead of the manufacture's [-].
  double wall_tolerance = 0.0;              ///< t_fab [m].
  double ovality = 0.005;                   ///< O_0 = (D_max - D_min)/D [-].
  double alpha_h = 0.93;                    ///< Largest yield over tensile strength the steel may have [-].
  double condition_factor = 1.0;            ///< gamma_C [-].
  bool system_effects = true;               ///< Load combination a as well.
  YieldBasis yield_basis = YieldBasis::fy;  ///< Of f_y in 0.87 f_y.
  CurrentLoad current_load = CurrentLoad::environmental;  ///< Classification of the steady current's load effects.
  std::string grade;                                      ///< Row of the laying criteria; empty: from SMYS.
  bool point_load = false;                                ///< Roller force reduces the plastic moment.
  std::vector<std::string> accepted_findings;  ///< Names of serious findings that do not reserve the verdict.
  std::optional<ArrestorSettings> arrestor;
  ApiSettings api;
  YieldShares yield_share;
  EquipmentLimits limits;
  SafetyFactors safety_factors;
};

}  // namespace overbend
