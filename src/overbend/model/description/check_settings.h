/// Settings of the code checks: the `checks` section of the model file, in SI units. The defaults give a complete table
/// without this section.
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

/// Buckle arrestor, for the propagation check.
struct ArrestorSettings {
  double propagation_pressure = 0.0;  ///< Propagation pressure of the arrestor, p_BA [Pa].
  double length = 0.0;                ///< [m]
};

/// API RP 1111.
struct ApiSettings {
  ApiEdition edition = ApiEdition::fifth;
  std::optional<double> collapse_factor;           ///< f_o; from the manufacturing process if not given [-].
  double bending_factor = 3.33;                    ///< f_1 on the installation strain [-].
  std::optional<double> combined_collapse_factor;  ///< f_c; from the edition if not given [-].
  std::optional<double> ovality;  ///< delta = (D_max - D_min)/(D_max + D_min); half of O_0 if not given [-].
};

/// Allowable von Mises stress divided by SMYS, for projects that use such limits; not checked if not given [-].
struct AllowableStressFactors {
  std::optional<double> overbend_static, overbend_dynamic, sagbend_static, sagbend_dynamic;
};

/// Limits of the lay equipment and the coating; not checked if not given.
struct EquipmentLimits {
  std::optional<double> roller_load;        ///< Max. force on one roller [N].
  std::optional<double> coating_line_load;  ///< Max. roller force per length of coating under it [N/m].
  std::optional<double> tension;            ///< Max. tension at the tensioner [N].
  std::optional<double> tip_clearance;      ///< Min. distance between the pipe and the last roller of the stinger [m].
};

/// Required ratio of strength to load of lines, anchors and cables; depends on code and analysis if not given, see
/// checks/mooring_rows.h [-].
struct SafetyFactors {
  std::optional<double> mooring_intact, mooring_damaged;
  std::optional<double> anchor_intact, anchor_damaged;
  std::optional<double> cable;  ///< Abandonment and recovery cable, start-up cable.
  std::optional<double> line;   ///< Free lines, hawsers.
};

struct CheckSettings {
  CheckCodes codes = CheckCodes::both;
  SafetyClass safety_class = SafetyClass::low;
  std::optional<Manufacture> manufacture;  ///< UOE, the least favourable, if not given.
  double alpha_u = 0.96;                   ///< Material strength factor [-].
  std::optional<double> alpha_fab;  ///< Fabrication factor that replaces the one of the manufacturing process [-].
  double wall_tolerance = 0.0;      ///< t_fab [m].
  double ovality = 0.005;           ///< O_0 = (D_max - D_min)/D [-].
  double alpha_h = 0.93;            ///< Max. ratio of yield to tensile strength of the steel [-].
  double condition_factor = 1.0;    ///< gamma_C [-].
  bool system_effects = true;       ///< Checks load combination a in addition to b.
  YieldBasis yield_basis = YieldBasis::fy;                ///< Yield stress f_y in the limit 0.87 f_y.
  CurrentLoad current_load = CurrentLoad::environmental;  ///< Classification of the steady current's load effects.
  std::string grade;                                      ///< Row of the laying criteria; from SMYS if empty.
  bool point_load = false;                                ///< Roller force reduces the plastic moment.
  std::vector<std::string> accepted_findings;             ///< Names of serious findings that do not block a pass.
  std::optional<ArrestorSettings> arrestor;
  ApiSettings api;
  AllowableStressFactors allowable_stress;
  EquipmentLimits limits;
  SafetyFactors safety_factors;
};

}  // namespace overbend
