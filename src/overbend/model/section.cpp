#include "model/section.h"

#include <numbers>

namespace overbend {
namespace {

double disc(double diameter) {
  return 0.25 * std::numbers::pi * diameter * diameter;
}

/// Weight of all coatings per length [N/m]; `diameter` grows from the steel to the outermost layer.
double coating_weight(const SectionDescription& description, double& diameter) {
  double weight = 0.0;
  for (std::size_t i = 0; i < description.coatings.size(); ++i) {
    const CoatingDescription& coating = description.coatings[i];
    const double outer = diameter + 2.0 * coating.thickness;
    const double area = disc(outer) - disc(diameter);
    const bool outermost = i + 1 == description.coatings.size();
    double density = coating.weight_density;
    if (outermost && description.joint) {
      const double bare = description.joint->field_joint / description.joint->length;
      density = (1.0 - bare) * density + bare * description.joint->infill_weight_density;
    }
    weight += area * density;
    diameter = outer;
  }
  return weight;
}

}  // namespace

Section derive_section(const std::string& name, const SectionDescription& description, double water_weight_density) {
  const SteelDescription& steel = description.steel;
  Section section;
  section.name = name;
  section.steel_diameter = steel.outside_diameter;
  section.wall_thickness = steel.wall_thickness;
  section.youngs_modulus = steel.youngs_modulus;
  section.poissons_ratio = steel.poissons_ratio;
  section.yield_stress = steel.yield_stress;

  const double bore = steel.outside_diameter - 2.0 * steel.wall_thickness;
  section.internal_area = disc(bore);
  section.pressure_area = disc(steel.outside_diameter);
  section.steel_area = section.pressure_area - section.internal_area;
  section.second_moment = second_moment(steel.outside_diameter, steel.wall_thickness);
  section.EA = steel.youngs_modulus * section.steel_area;
  section.EI = steel.youngs_modulus * section.second_moment;

  section.outer_diameter = steel.outside_diameter;
  const double coatings = coating_weight(description, section.outer_diameter);
  section.external_area = disc(section.outer_diameter);
  section.contents_weight_density = description.contents_weight_density;
  section.internal_pressure = description.internal_pressure;
  section.weight_in_air = steel.weight_density * section.steel_area + coatings +
                          description.contents_weight_density * section.internal_area;
  section.weight_submerged = section.weight_in_air - water_weight_density * section.external_area;

  section.drag_normal = description.hydrodynamics.drag_normal;
  section.drag_axial = description.hydrodynamics.drag_axial;
  section.added_mass_normal = description.hydrodynamics.added_mass_normal;
  section.added_mass_axial = description.hydrodynamics.added_mass_axial;
  return section;
}

}  // namespace overbend
