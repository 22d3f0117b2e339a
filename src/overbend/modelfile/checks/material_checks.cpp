#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/ranges.h"
#include "base/units.h"
#include "model/description/description_enum_names.h"
#include "model/pipe/moment_curve.h"
#include "modelfile/checks/model_checks.h"
#include "modelfile/schema/check_helper.h"

namespace overbend {
namespace {

double steel_number(const FieldValue& section, const FieldValue& pipe, const std::string& key, double otherwise) {
  return section.get_number("steel." + key).value_or(pipe.get_number("steel." + key).value_or(otherwise));
}

/// Reference for the linear part of a curve, and its maximum slope.
struct StraightPart {
  double slope = 0.0;      ///< SI; 0 if it is not known.
  const char* name = "";   ///< Description of the slope.
  const char* unit = "";   ///< Unit of the ordinate.
  const char* shown = "";  ///< Display unit of the slope.
  double min_share = 0.0;  ///< Fraction of the slope that the first point must reach; 0 if its own slope is used.
};

constexpr double kMinStraightShare = 0.9;  ///< For a tension test whose first point ends the linear part.

/// Checks that a curve increases, is concave, and starts along its linear part.
void check_curve(Checker& check, const std::vector<FieldValue>& points, const char* x, const char* y,
                 const StraightPart& straight) {
  constexpr double kSlack = 1.05;  // test data are accurate to a few per cent
  double last_x = 0.0, last_y = 0.0, last_slope = straight.slope > 0.0 ? kSlack * straight.slope : 1e300;
  for (const FieldValue& point : points) {
    const auto at_x = point.get_number(x), at_y = point.get_number(y);
    if (!at_x || !at_y) return;
    if (*at_x <= last_x || *at_y < last_y) {
      check.error(point, "a point that does not increase",
                  "curve points in increasing order, starting from the origin");
      return;
    }
    const double slope = (*at_y - last_y) / (*at_x - last_x);
    if (slope > (1.0 + 1e-9) * last_slope) {
      const bool first = last_x == 0.0;
      check.error(point, first ? "a point steeper than " + std::string(straight.name) : "a curve that grows steeper",
                  first ? "at most " + format_quantity(straight.slope * *at_x, straight.unit, straight.shown) + " there"
                        : "a concave curve: no segment steeper than the previous one");
      return;
    }
    if (last_x == 0.0 && slope < straight.min_share * straight.slope) {
      check.error(point,
                  fmt::format("a first point below {} ({} of its slope)", straight.name,
                              format_quantity(slope / straight.slope, "1", "%")),
                  "the end of the straight part, about " +
                      format_quantity(straight.slope * *at_x, straight.unit, straight.shown) + " at that " + x +
                      " or a point before it");
      return;
    }
    last_x = *at_x;
    last_y = *at_y;
    last_slope = slope;
  }
}

/// Returns true if the file gives a key, valid or not; a default is not given.
bool gives(const FieldValue& group, const char* key) {
  const FieldValue* value = group.find(key);
  return value != nullptr ? value->given : group.mentions(key);
}
bool gives_law(const FieldValue& material) {
  return gives(material, "law");
}
bool describes(const FieldValue& material) {
  constexpr std::array kNumbers = {"moment_coefficient", "moment_exponent", "hardening_exponent", "yield_strain",
                                   "hardening_modulus",  "stress_strain",   "moment_curvature"};
  return ranges::any_of(kNumbers, [&](const char* key) { return gives(material, key); });
}

void check_material(Checker& check, const FieldValue& section, const FieldValue& pipe) {
  const FieldValue* material = section.find("steel.material");
  if (material == nullptr || !material->given) return;
  const FieldValue* line = pipe.find("steel.material");  // values missing in a segment are those of the main section
  const auto mentions = [&](const char* key) {
    return material->mentions(key) || (line != nullptr && line->mentions(key));
  };
  const auto line_law = line != nullptr ? line->get_word<MaterialLaw>("law") : std::nullopt;
  const auto own_law = material->get_word<MaterialLaw>("law");
  const auto law = own_law ? own_law : line_law;
  const double modulus = steel_number(section, pipe, "youngs_modulus", SteelDescription{}.youngs_modulus);
  const double yield = steel_number(section, pipe, "yield_stress", 0.0);
  const std::vector<FieldValue>& stress_strain = Checker::items(*material, "stress_strain");
  const std::vector<FieldValue>& moment_curvature = Checker::items(*material, "moment_curvature");
  const bool exponent = mentions("hardening_exponent"), curve = mentions("stress_strain");
  const bool a = mentions("moment_coefficient"), b = mentions("moment_exponent");
  if (!gives_law(*material) && !(line != nullptr && gives_law(*line)) && describes(*material)) {
    check.missing(*material, "law", "the law that these numbers belong to", "without one the steel is linear");
  }
  if (law == MaterialLaw::ramberg_osgood && !exponent) {
    check.missing(*material, "hardening_exponent", "the exponent n of the stress-strain law, often 15 to 25");
  }
  if (law == MaterialLaw::stress_strain && !curve) {
    check.missing(*material, "stress_strain", "the points of a tension test");
  }
  if (law == MaterialLaw::moment_curvature && !mentions("moment_curvature")) {
    check.missing(*material, "moment_curvature", "the points of the moment-curvature curve of the pipe");
  }
  if (law == MaterialLaw::moment_ramberg_osgood && a != b) {
    check.missing(*material, a ? "moment_exponent" : "moment_coefficient",
                  "both A and B, or neither if they are to be fitted");
  }
  if (law == MaterialLaw::moment_ramberg_osgood && !a && !b && !exponent && !curve) {
    check.missing(*material, "moment_coefficient", "A and B, or a hardening_exponent or stress_strain to fit them to");
  }
  if (exponent && !curve && yield > 0.0 && material->get_number("yield_strain").value_or(1.0) <= yield / modulus) {
    check.error(*material->find("yield_strain"), "a total strain at yield of " + material->find("yield_strain")->shown,
                "more than the elastic strain there, " + format_quantity(yield / modulus, "1", "%"));
  }
  if (const auto slope = material->get_number("hardening_modulus"); slope && *slope >= modulus) {
    check.error(*material->find("hardening_modulus"), material->find("hardening_modulus")->shown,
                "less than Young's modulus, " + format_quantity(modulus, "N/m^2", "GPa"));
  }
  check_curve(check, stress_strain, "strain", "stress",
              {modulus, "Young's modulus", "N/m^2", "MPa", kMinStraightShare});
  const double outer = steel_number(section, pipe, "outside_diameter", 0.0);
  const double wall = steel_number(section, pipe, "wall_thickness", 0.0);
  const double EI = wall > 0.0 && outer > 2.0 * wall ? modulus * second_moment(outer, wall) : 0.0;
  check_curve(check, moment_curvature, "curvature", "moment", {EI, "the bending stiffness", "N*m", "kN*m"});
}

/// Returns true if a segment has a value of its own that differs.
bool differs(const FieldValue& section, const FieldValue& pipe, const char* key, double otherwise) {
  const auto section_value = section.get_number(std::string("steel.") + key);
  constexpr double kSame = 1e-9;  // rounding of other units
  const double line = pipe.get_number(std::string("steel.") + key).value_or(otherwise);
  return section_value && std::abs(*section_value - line) > kSame * std::abs(line);
}

/// Checks properties that a segment takes from the main section although they belong to that steel or pipe only.
void check_inherited(Checker& check, const FieldValue& section, const FieldValue& pipe) {
  const FieldValue* steel = section.find("steel");
  if (steel == nullptr) return;
  const FieldValue *own_material = section.find("steel.material"), *line = pipe.find("steel.material");
  const auto gives_own = [&](const char* key) { return own_material != nullptr && gives(*own_material, key); };
  const auto own_law = own_material != nullptr ? own_material->get_word<MaterialLaw>("law") : std::nullopt;
  const auto law = own_law ? own_law : line != nullptr ? line->get_word<MaterialLaw>("law") : std::nullopt;
  const bool yields_else = differs(section, pipe, "yield_stress", 0.0);
  const bool another = yields_else || differs(section, pipe, "outside_diameter", 0.0) ||
                       differs(section, pipe, "wall_thickness", 0.0) ||
                       differs(section, pipe, "youngs_modulus", SteelDescription{}.youngs_modulus);
  if (law == MaterialLaw::moment_curvature && another && !gives_own("moment_curvature")) {
    check.error(*steel, "the moment-curvature curve of the main section for another pipe",
                "steel.material.moment_curvature of this pipe, or another law");
  }
  if (!yields_else) return;
  if (law == MaterialLaw::stress_strain && !gives_own("stress_strain")) {
    check.warn(*steel->find("yield_stress"),
               "the stress-strain curve stays that of the main section: a yield stress alone does not change how the "
               "steel bends");
  }
  const FieldValue* strength = pipe.find("steel.tensile_strength");
  if (strength != nullptr && strength->given && !gives(*steel, "tensile_strength")) {
    check.warn(*steel->find("yield_stress"), "the tensile strength stays that of the main section, " + strength->shown +
                                                 ": the code checks use it; give that of this steel");
  }
}

}  // namespace

void check_materials(const FieldValue& root, const std::string& file, Diagnostics& diagnostics) {
  Checker check(root, file, diagnostics);
  const FieldValue* pipe = root.find("pipe");
  if (pipe == nullptr) return;
  check_material(check, *pipe, *pipe);
  for (const FieldValue& segment : Checker::items(*pipe, "segments")) {
    check_material(check, segment, *pipe);
    check_inherited(check, segment, *pipe);
  }
  if (const FieldValue* head = root.find("operation.head.section")) {
    check_material(check, *head, *pipe);
    check_inherited(check, *head, *pipe);
  }
}

}  // namespace overbend
