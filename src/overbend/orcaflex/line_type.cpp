#include "orcaflex/line_type.h"

#include <cmath>

#include "base/constants.h"
#include "base/text.h"

namespace overbend::orcaflex {
namespace {

double disc(double diameter) {
  return 0.25 * kPi * diameter * diameter;
}

std::optional<double> scaled(const std::optional<double>& value, double factor) {
  return value ? std::optional(*value * factor) : std::nullopt;
}

/// Coefficients across and along the line: `Cd: [across, ~, along]`, or by single keys.
void read_coefficients(const Object& object, const char* list, const char* across_key, const char* along_key,
                       double& across, double& along) {
  const std::vector<std::optional<double>> values = object.numbers(list);
  across = !values.empty() && values[0] ? *values[0] : object.number(across_key).value_or(0.0);
  along = values.size() > 2 && values[2] ? *values[2] : object.number(along_key).value_or(0.0);
}

double required(const Object& object, const std::string& key) {
  const std::optional<double> value = object.number(key);
  if (!value) object.reject(key, "nothing", "a number");
  return value.value_or(1.0);
}

void read_pipe(const Object& object, const UnitSystemOfFile& units, LineType& type) {
  type.youngs_modulus = required(object, "E") * units.pressure();
  type.poissons_ratio = object.number("PoissonRatio").value_or(0.293);
  type.density = required(object, "MaterialDensity") * units.density();
  type.coating = object.number("CoatingThickness").value_or(0.0) * units.length;
  type.coating_density = object.number("CoatingMaterialDensity").value_or(0.0) * units.density();
  type.lining = object.number("LiningThickness").value_or(0.0) * units.length;
  type.lining_density = object.number("LiningMaterialDensity").value_or(0.0) * units.density();
  type.yield_stress = scaled(object.number("DNVSTF101Fy"), units.pressure());
  if (!type.yield_stress) type.yield_stress = scaled(object.number("AllowableStress"), units.pressure());
}

void read_general(const Object& object, const UnitSystemOfFile& units, LineType& type) {
  type.mass = required(object, "MassPerUnitLength") * units.mass / units.length;
  type.axial_stiffness = required(object, "EA") * units.force;
  const std::vector<std::optional<double>> bending = object.numbers("EI");
  if (!bending.empty()) type.bending_stiffness = bending[0].value_or(0.0) * units.force * units.length * units.length;
}

}  // namespace

double LineType::area_inside() const {
  return disc(inside_diameter);
}

double LineType::mass_inside(double contents_density) const {
  const double bore = disc(inside_diameter - 2.0 * lining);
  return contents_density * bore + lining_density * (area_inside() - bore);
}

double LineType::mass_of_wall() const {
  if (!is_pipe) return mass;
  return density * (disc(outside_diameter) - area_inside()) +
         coating_density * (disc(diameter()) - disc(outside_diameter));
}

LineType read_line_type(const Object& object, const UnitSystemOfFile& units) {
  LineType type;
  type.name = object.name();
  const std::string category = object.text("Category", "General");
  type.is_pipe = category == "Homogeneous pipe";
  if (!type.is_pipe && category != "General") {
    object.reject("Category", "'" + for_display(category) + "'", "General or Homogeneous pipe");
  }
  type.outside_diameter = required(object, "OD") * units.length;
  type.inside_diameter = object.number("ID").value_or(0.0) * units.length;
  type.is_pipe ? read_pipe(object, units, type) : read_general(object, units, type);
  if (type.inside_diameter >= type.outside_diameter) object.reject("ID", "not less than OD", "less than OD");
  type.allowable_tension = scaled(object.number("AllowableTension"), units.force);
  type.contact_diameter = scaled(object.number("OuterContactDiameter"), units.length);
  type.drag_diameter = scaled(object.number("NormalDragLiftDiameter"), units.length);
  read_coefficients(object, "Cd", "Cdn", "Cdz", type.drag_normal, type.drag_axial);
  read_coefficients(object, "Ca", "Can", "Caz", type.added_mass_normal, type.added_mass_axial);
  type.friction = object.number("SeabedLateralFrictionCoefficient").value_or(0.0);
  return type;
}

}  // namespace overbend::orcaflex
