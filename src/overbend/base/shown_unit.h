/// Units in which people read results: one table for tables of text, command line, messages, reports and the page.
///
/// Calculations and files for scripts (summary.json, results.h5) are in SI. What people read is in metric engineering
/// units, or in US customary units where the program was started so. Every text takes its units from here.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace overbend {

enum class UnitSystem { metric, us };

/// The units of everything that is printed from now on, in all threads. Set once, before results are printed.
void use_units(UnitSystem system);
UnitSystem units_in_use();

/// How values of an SI unit are shown: times `factor`, usually with `digits` decimals.
struct ShownUnit {
  std::string_view si;
  std::string_view name;  ///< Empty for plain numbers.
  double factor = 1.0;
  int digits = 3;
  int more = 0;  ///< Decimals more than the metric unit of the same SI unit has, so that no text loses precision.
};

/// Quantities that are read in a unit of their own: those whose name holds `part`.
struct OwnUnit {
  std::string_view part;
  ShownUnit unit;
};

/// The tables of a system, in the same order for both.
std::span<const ShownUnit> shown_units(UnitSystem system);
std::span<const OwnUnit> own_units(UnitSystem system);

/// Of the quantity `name`, which may be any text that holds what it is ("design strain"), kept in `si`. An SI unit that
/// is not in the table is shown as it is.
ShownUnit shown_unit(std::string_view name, std::string_view si, UnitSystem system);
inline ShownUnit shown_unit(std::string_view name, std::string_view si) {
  return shown_unit(name, si, units_in_use());
}
inline ShownUnit shown_unit(std::string_view si) {
  return shown_unit("", si);
}

/// Lengths of a cross-section, gaps: millimetres or inches.
ShownUnit section_length();
/// Weight of lines: N/m or lbf/ft.
ShownUnit line_weight_unit();
/// Stiffness of contacts: MN/m or kip/in.
ShownUnit contact_stiffness_unit();
/// Axial stiffness of mooring lines: MN or kip.
ShownUnit axial_stiffness_unit();
/// Moduli of steel: GPa or ksi.
ShownUnit modulus_unit();
/// Stiffness of the seabed, to be read per metre or foot of penetration: kN/m or lbf/ft.
ShownUnit bed_stiffness_unit();
/// Distances along a route: kilometres or feet.
ShownUnit route_length();

/// A plain number with `digits` decimals, never "-0.00"; "-" for what is not finite.
std::string fixed(double value, int digits);

/// Its name, or a dash for plain numbers.
std::string text_of(const ShownUnit& unit);

/// A value [SI] without its unit: "276.5". `decimals`: those of metric values.
std::string shown_number(double value, const ShownUnit& unit, int decimals);
inline std::string shown_number(double value, std::string_view si, int decimals) {
  return shown_number(value, shown_unit(si), decimals);
}

/// A value [SI] with its unit: "276.5 kN".
std::string shown(double value, const ShownUnit& unit, int decimals);
inline std::string shown(double value, std::string_view si, int decimals) {
  return shown(value, shown_unit(si), decimals);
}

/// The same with at most `digits` significant digits: "89 m".
std::string shown_digits(double value, const ShownUnit& unit, int digits);
inline std::string shown_digits(double value, std::string_view si, int digits) {
  return shown_digits(value, shown_unit(si), digits);
}

/// The same without its unit: "89".
std::string shown_digits_number(double value, const ShownUnit& unit, int digits);

/// The name of the unit: "kN".
inline std::string shown_name(std::string_view si) {
  return std::string(shown_unit(si).name);
}

}  // namespace overbend
