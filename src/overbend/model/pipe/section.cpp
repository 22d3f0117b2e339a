#include "model/pipe/section.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace overbend {
namespace {

double disc(double diameter) {
  return 0.25 * std::numbers::pi * diameter * diameter;
}

/// Returns the weight of all coatings per length [N/m]; increases `diameter` from the steel to the outermost layer.
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
  section.EI = elastic_bending_stiffness(steel);

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

Section cable_section(const CableDescription& cable, double water_weight_density) {
  constexpr double kSteelModulus = 200e9, kSteelWeight = 77e3;  // of wires [Pa], [N/m3]
  // 1e-5 of the bending stiffness of a solid bar, EA D^2/16: negligible for a taut cable, but keeps the shape of a
  // slack one defined.
  constexpr double kBending = 1e-5 / 16.0;
  Section section;
  section.kind = SectionKind::cable;
  section.name = "cable";
  section.steel_diameter = section.outer_diameter = cable.diameter;
  section.wall_thickness = 0.5 * cable.diameter;
  section.youngs_modulus = kSteelModulus;
  section.steel_area = cable.weight_in_air / kSteelWeight;
  section.second_moment = disc(cable.diameter) * cable.diameter * cable.diameter / 16.0;
  section.EA = cable.axial_stiffness;
  section.EI = kBending * cable.axial_stiffness * cable.diameter * cable.diameter;
  section.poissons_ratio = 0.5;  // its axial stiffness refers to the effective tension, which excludes pressure
  section.external_area = (cable.weight_in_air - cable.weight_submerged) / water_weight_density;
  section.weight_in_air = cable.weight_in_air;
  section.weight_submerged = cable.weight_submerged;
  section.drag_normal = cable.drag_normal;
  section.drag_axial = cable.drag_axial;
  section.added_mass_normal = cable.added_mass_normal;
  section.added_mass_axial = cable.added_mass_axial;
  return section;
}

Section head_section(const HeadDescription& head, const SectionDescription& described, double water_weight_density) {
  Section section = derive_section("head", described, water_weight_density);
  section.kind = SectionKind::head;
  section.weight_in_air = head.weight_in_air / head.length;
  section.weight_submerged = head.weight_submerged / head.length;
  section.external_area = (section.weight_in_air - section.weight_submerged) / water_weight_density;
  return section;
}

Section structure_section(const StructureDescription& structure, const Section& pipe, double water_weight_density) {
  Section section = pipe;
  section.kind = SectionKind::structure;
  section.name = structure.name;
  section.bending.reset();
  section.EI = structure.bending_stiffness.value_or(pipe.EI);
  section.EA = structure.axial_stiffness.value_or(pipe.EA);
  section.second_moment = section.EI / section.youngs_modulus;
  section.steel_area = section.EA / section.youngs_modulus;
  section.outer_diameter = structure.diameter.value_or(pipe.outer_diameter);
  section.weight_in_air = structure.weight_in_air / structure.length;
  section.weight_submerged = structure.weight_submerged / structure.length;
  section.external_area = (section.weight_in_air - section.weight_submerged) / water_weight_density;
  section.drag_normal = structure.drag_normal.value_or(pipe.drag_normal);
  section.drag_axial = structure.drag_axial.value_or(pipe.drag_axial);
  section.added_mass_normal = structure.added_mass_normal.value_or(pipe.added_mass_normal);
  section.added_mass_axial = structure.added_mass_axial.value_or(pipe.added_mass_axial);
  return section;
}

}  // namespace overbend
