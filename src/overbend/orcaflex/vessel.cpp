// The vessel: place, heading, motion.
#include <cmath>

#include "base/constants.h"
#include "base/text.h"
#include "orcaflex/hull_data_text.h"
#include "orcaflex/translation.h"

namespace overbend::orcaflex {
namespace {

constexpr double kDegree = kPi / 180.0;

/// Dimensions that the file does not have. A hull that is held does not depend on them.
constexpr double kBeam = 30.0, kDepth = 9.0, kDraught = 5.0;

/// Vessel to which lines or supports refer; the first one if there are several of them, or none.
std::optional<Object> choose_vessel(Translation& translation) {
  const std::vector<Object> vessels = translation.objects("Vessels");
  if (vessels.empty()) return std::nullopt;
  std::optional<Object> chosen;
  for (const Object& vessel : vessels) {
    if (!chosen && vessel.table("SupportArclength")) chosen = vessel;
    if (!chosen && !vessel.objects("Supports").empty()) chosen = vessel;
  }
  if (!chosen) chosen = vessels.front();
  for (const Object& vessel : vessels) {
    if (vessel.name() == chosen->name()) continue;
    translation.left_out("vessel " + for_display(vessel.name()) + ": the model has one, " + for_display(chosen->name()),
                         true);
  }
  return chosen;
}

std::optional<Object> find_type(const Translation& translation, const Object& vessel) {
  const std::string wanted = vessel.text("VesselType");
  for (const Object& type : translation.objects("VesselTypes")) {
    if (type.name() == wanted) return type;
  }
  if (!wanted.empty()) vessel.reject("VesselType", "'" + for_display(wanted) + "'", "one of the VesselTypes");
  return std::nullopt;
}

/// Draught of the type that the vessel uses, if it has displacement RAOs.
std::optional<Object> draught_with_raos(const Object& type, const std::string& name) {
  for (const Object& draught : type.objects("Draughts")) {
    if ((name.empty() || draught.name() == name) && draught.object("DisplacementRAOs")) return draught;
  }
  return std::nullopt;
}

/// Draught of the type that the vessel uses, if it has hull data and no displacement RAOs.
std::optional<Object> draught_with_hull_data(const Object& type, const std::string& name) {
  if (draught_with_raos(type, name)) return std::nullopt;
  for (const Object& draught : type.objects("Draughts")) {
    if ((name.empty() || draught.name() == name) && has_hull_data(draught)) return draught;
  }
  return std::nullopt;
}

/// Name by which the model finds a file.
std::string name_from_model(const ImportOptions& options, const std::filesystem::path& file) {
  if (options.is_one_folder) return file.filename().string();
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(file, error).lexically_normal();
  const std::filesystem::path folder = std::filesystem::absolute(options.model_folder, error).lexically_normal();
  const std::filesystem::path relative = absolute.lexically_relative(folder);
  return (relative.empty() ? absolute : relative).generic_string();
}

/// `motion` with the file of the RAOs, which the program reads as it is.
std::string motion_text(Translation& translation) {
  const Object& type = *translation.vessel_type;
  const std::string draught = translation.vessel_object->text("Draught");
  if (const auto data = draught_with_hull_data(type, draught)) {
    const std::string named = name_from_model(translation.options, type.origin().file);
    const std::string names = "vessel_type: " + name_text(type.name()) + ", draught: " + name_text(data->name());
    translation.left_out(
        "motions of the vessel: its type has load RAOs, added mass, damping and stiffness. The model "
        "has vessel.motion.coupled with them as a comment: a floating hull also needs beam, depth and "
        "draught",
        true);
    return hull_data_text(translation, *data, named, names);
  }
  if (!draught_with_raos(type, draught)) {
    translation.left_out("motions of the vessel: its type has no displacement RAOs; a run in time needs them", true);
    return "";
  }
  const std::string named = name_from_model(translation.options, type.origin().file);
  std::string convention = "vessel_type: " + name_text(type.name());
  if (!draught.empty()) convention += ", draught: " + name_text(draught);
  translation.translated("displacement RAOs of " + for_display(type.name()) + ", read from " + for_display(named));
  return "  motion:\n    raos: " + name_text(named) + "\n    convention: {" + convention + "}\n";
}

}  // namespace

void read_vessel(Translation& translation) {
  const double length_unit = translation.units.length;
  translation.vessel_object = choose_vessel(translation);
  Vessel& vessel = translation.vessel;
  if (!translation.vessel_object) return;
  const Object& object = *translation.vessel_object;
  translation.vessel_type = find_type(translation, object);
  if (!translation.vessel_type) return;
  vessel.name = object.name();
  const std::optional<double> length_of_vessel = object.number("Length"),
                              length_of_type = translation.vessel_type->number("Length");
  const std::optional<double> length = length_of_vessel ? length_of_vessel : length_of_type;
  if (!length || !(*length > 0.0)) object.reject("Length", "nothing, nor in its type", "the length of the vessel");
  vessel.length = length.value_or(100.0) * length_unit;
  vessel.stern_shoe = -0.5 * vessel.length;
  vessel.position = object.triple("InitialPosition") * length_unit;
  vessel.position.z() -= translation.water_level;
  const Vec3 orientation = object.triple("Orientation");
  vessel.heading = orientation.z() * kDegree;
  if (orientation.x() != 0.0 || orientation.y() != 0.0) {
    translation.left_out(fmt::format("heel {} deg and trim {} deg of the vessel: give vessel.heel and vessel.trim",
                                     number_text(orientation.x()), number_text(orientation.y())),
                         true);
  }
}

std::string vessel_text(Translation& translation) {
  const Vessel& vessel = translation.vessel;
  if (!translation.vessel_type) return "";
  const double heading = 90.0 - vessel.heading / kDegree;
  std::string text = "vessel:\n  length: " + quantity_text(vessel.length, "m") + "\n";
  text += "  # Not in the file; of no matter to a hull that is held.\n";
  text += fmt::format("  beam: {} m\n  depth: {} m\n  draught: {} m\n", kBeam, kDepth, kDraught);
  text += "  heading: " + quantity_text(heading, "deg") + "\n";
  if (translation.laid_pipe() != nullptr) {
    text += fmt::format("  stern_shoe: {{x: {}, z: 0 m}}\n", quantity_text(vessel.stern_shoe, "m"));
  }
  text += motion_text(translation);
  translation.translated(fmt::format("vessel {}: place, heading {} deg from X", for_display(vessel.name),
                                     number_text(vessel.heading / kDegree)));
  const std::string statics = translation.vessel_object->text("IncludedInStatics", "None");
  if (statics != "None") {
    translation.approximated("IncludedInStatics: " + for_display(statics) +
                             ": the vessel is held as drawn; its hull is not read from this file");
  }
  translation.left_out("beam, depth and draught of the vessel: not in the file; of no matter to a hull that is held");
  return text + "\n";
}

}  // namespace overbend::orcaflex
