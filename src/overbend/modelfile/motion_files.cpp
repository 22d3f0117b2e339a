#include "modelfile/motion_files.h"

#include <filesystem>

#include "seafiles/motion_history_reader.h"
#include "seafiles/rao_reader.h"

namespace overbend {
namespace {

std::optional<Vec3> point_of(const FieldValue& convention, const std::string& key) {
  const FieldValue* group = convention.find(key);
  if (group == nullptr || !group->given) return std::nullopt;
  return Vec3(group->get_number("x").value_or(0.0), group->get_number("y").value_or(0.0),
              group->get_number("z").value_or(0.0));
}

RaoSettings settings_of(const FieldValue* convention) {
  RaoSettings settings;
  if (convention == nullptr) return settings;
  settings.set = convention->get_text("set").value_or("");
  for (const ConventionKey& key : convention_keys()) {
    if (const auto word = convention->get_text(key.key)) settings.words[key.key] = *word;
  }
  settings.reference = point_of(*convention, "reference");
  settings.wave_origin = point_of(*convention, "wave_origin");
  const std::optional<Vec3> origin = point_of(*convention, "file_origin");
  settings.file_origin = origin.value_or(Vec3::Zero());
  settings.file_origin_stated = origin.has_value();
  settings.length_scale = convention->get_number("length_scale").value_or(1.0);
  settings.vessel_type = convention->get_text("vessel_type").value_or("");
  settings.draught = convention->get_text("draught").value_or("");
  return settings;
}

}  // namespace

void read_motion_file(const FieldValue& root, Description& description, Diagnostics& diagnostics) {
  VesselDescription& vessel = description.vessel;
  const RaoSettings settings = settings_of(root.find("vessel.motion.convention"));
  vessel.motion_reference_V = settings.reference.value_or(Vec3::Zero());
  std::error_code fault;
  if (vessel.motion_file.empty() || !std::filesystem::exists(vessel.motion_file, fault)) return;
  if (vessel.motion == VesselMotion::raos) {
    vessel.raos = read_raos(vessel.motion_file, settings, description.environment.water_depth, diagnostics);
  } else if (vessel.motion == VesselMotion::history) {
    vessel.history = read_motion_history(vessel.motion_file, diagnostics);
  }
}

}  // namespace overbend
