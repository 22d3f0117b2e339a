/// Display units of results: one table for text output, command line, messages, reports and the page.
///
/// Calculations and machine-readable files (summary.json, results.h5) are in SI. Output for people is in metric
/// engineering units, or in US customary units if the program was started so. All text takes its units from here.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace overbend {

enum class UnitSystem { metric, us };

/// Sets the units of all further output, in all threads. Call once, before results are printed.
void use_units(UnitSystem system);
UnitSystem units_in_use();

/// Display of values of an SI unit: multiplied by `factor`, usually with `digits` decimals.
struct ShownUnit {
  std::string_view si;
  std::string_view name;  ///< Empty for plain numbers.
  double factor = 1.0;
  int digits = 3;
  /// Number of decimals in addition to those of the metric unit of the same SI unit, so that no text loses precision.
  int more = 0;
};

/// Special unit of the quantities whose name contains `part`.
struct SpecialUnit {
  std::string_view part;
  ShownUnit unit;
};

/// The tables of a system, in the same order for both.
std::span<const ShownUnit> shown_units(UnitSystem system);
std::span<const SpecialUnit> special_units(UnitSystem system);

/// Returns the display unit of the quantity `name`, which may be any text that contains it ("design strain"), stored in
/// `si`. An SI unit that is not in the table is shown unchanged.
ShownUnit shown_unit(std::string_view name, std::string_view si, UnitSystem system);
inline ShownUnit shown_unit(std::string_view name, std::string_view si) {
  return shown_unit(name, si, units_in_use());
}
inline ShownUnit shown_unit(std::string_view si) {
  return shown_unit("", si);
}

/// Unit of lengths of a cross-section and gaps: millimetres or inches.
ShownUnit section_length();
/// Unit of the weight of lines: N/m or lbf/ft.
ShownUnit line_weight_unit();
/// Unit of contact stiffness: MN/m or kip/in.
ShownUnit contact_stiffness_unit();
/// Unit of axial stiffness of mooring lines: MN or kip.
ShownUnit axial_stiffness_unit();
/// Unit of moduli of steel: GPa or ksi.
ShownUnit modulus_unit();
/// Unit of seabed stiffness, per metre or foot of penetration: kN/m or lbf/ft.
ShownUnit bed_stiffness_unit();
/// Unit of distances along a route: kilometres or feet.
ShownUnit route_length();

/// Returns a number with `digits` decimals, never "-0.00"; "-" for non-finite values.
std::string fixed(double value, int digits);

/// Returns the name of the unit, or a dash for plain numbers.
std::string unit_label(const ShownUnit& unit);

/// Returns a value [SI] without its unit: "276.5". `decimals`: those of metric values.
std::string shown_number(double value, const ShownUnit& unit, int decimals);
inline std::string shown_number(double value, std::string_view si, int decimals) {
  return shown_number(value, shown_unit(si), decimals);
}

/// Returns a value [SI] with its unit: "276.5 kN".
std::string shown(double value, const ShownUnit& unit, int decimals);
inline std::string shown(double value, std::string_view si, int decimals) {
  return shown(value, shown_unit(si), decimals);
}

/// Returns a value [SI] with its unit and at most `digits` significant digits: "89 m".
std::string shown_digits(double value, const ShownUnit& unit, int digits);
inline std::string shown_digits(double value, std::string_view si, int digits) {
  return shown_digits(value, shown_unit(si), digits);
}

/// Returns a value [SI] with at most `digits` significant digits, without its unit: "89".
std::string shown_digits_number(double value, const ShownUnit& unit, int digits);

/// Returns the name of the unit: "kN".
inline std::string shown_name(std::string_view si) {
  return std::string(shown_unit(si).name);
}

}  // namespace overbend
