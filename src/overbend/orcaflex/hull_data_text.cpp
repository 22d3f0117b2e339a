#include "orcaflex/hull_data_text.h"

#include <cmath>

namespace overbend::orcaflex {
namespace {

/// Centre of gravity above the water line [m]. The file gives the height of the reference origin over the water.
Vec3 centre_of_gravity(const Translation& translation, const Object& draught) {
  Vec3 centre = draught.triple("CentreOfMass");
  const std::vector<std::optional<double>> datum = draught.numbers("ReferenceOriginDatumPosition");
  if (!datum.empty() && datum.front()) centre.z() += *datum.front() - draught.triple("ReferenceOrigin").z();
  return centre * translation.units.length;
}

std::string gyration_text(const Translation& translation, const Object& draught, double mass) {
  constexpr const char* kColumns[] = {"MomentOfInertiaTensorX", "MomentOfInertiaTensorY", "MomentOfInertiaTensorZ"};
  constexpr const char* kKeys[] = {"roll", "pitch", "yaw"};
  const auto table = draught.table(kColumns[0]);
  if (!table || table->size() != 3 || !(mass > 0.0)) return "";
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) {
    const double inertia = table->number(i, kColumns[i]).value_or(0.0);
    if (!(inertia > 0.0) || !std::isfinite(inertia)) return "";
    const double radius = std::sqrt(inertia / mass) * translation.units.length;
    text += (i == 0 ? "" : ", ") + std::string(kKeys[i]) + ": " + quantity_text(radius, "m");
  }
  return "  #     gyration: {" + text + "}\n";
}

}  // namespace

bool has_hull_data(const Object& draught) {
  const auto loads = draught.object("LoadRAOs");
  return loads && !loads->objects("RAOs").empty() && draught.table("HydrostaticStiffnessz") &&
         !draught.objects("FrequencyDependentAddedMassAndDamping").empty();
}

std::string hull_data_text(const Translation& translation, const Object& draught, const std::string& file,
                           const std::string& convention) {
  const double mass = draught.number("Mass").value_or(0.0);
  const Vec3 centre = centre_of_gravity(translation, draught);
  std::string text =
      "  # A hull that floats, from load RAOs, added mass, damping and stiffness of the vessel type. It needs the "
      "beam,\n"
      "  # depth and draught of the vessel above, and how the current acts on the hull.\n"
      "  # motion:\n  #   coupled:\n";
  text += "  #     hydrodynamics: " + name_text(file) + "\n  #     convention: {" + convention + "}\n";
  if (mass > 0.0) text += "  #     mass: " + quantity_text(mass * translation.units.mass / 1000.0, "t") + "\n";
  text += fmt::format("  #     centre_of_gravity: {{x: {}, y: {}, z: {}}}\n", quantity_text(centre.x(), "m"),
                      quantity_text(centre.y(), "m"), quantity_text(centre.z(), "m"));
  return text + gyration_text(translation, draught, mass) + "  #     current: none\n";
}

}  // namespace overbend::orcaflex
