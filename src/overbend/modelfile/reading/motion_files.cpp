#include "modelfile/reading/motion_files.h"

#include <filesystem>

#include "modelfile/binding/binding.h"
#include "modelfile/fields/field_table.h"
#include "seafiles/motion_history_reader.h"
#include "seafiles/rao_reader.h"

namespace overbend {
namespace {

RaoSettings settings_of(const FieldValue& root, const std::string& source_file) {
  constexpr const char* kPath = "vessel.motion.convention";
  RaoSettings settings;
  const FieldValue* convention = root.find(kPath);
  if (convention != nullptr) bind_members(field_node(kPath), *convention, &settings, source_file);
  return settings;
}

}  // namespace

void read_motion_file(const FieldValue& root, Description& description, Diagnostics& diagnostics) {
  VesselDescription& vessel = description.vessel;
  RaoSettings settings = settings_of(root, description.source_file);
  const FieldValue* length = root.find("vessel.length");
  if (length != nullptr && length->given) settings.vessel_length = vessel.length;
  vessel.motion_reference_V = settings.reference.value_or(Vec3::Zero());
  std::error_code fault;
  if (vessel.motion_file.empty() || !std::filesystem::exists(vessel.motion_file, fault)) return;
  if (vessel.motion == VesselMotion::raos) {
    vessel.raos = read_raos(vessel.motion_file, settings, description.environment.water_depth, diagnostics);
  } else if (vessel.motion == VesselMotion::history) {
    vessel.history = read_motion_history(vessel.motion_file, vessel.heading, diagnostics);
  }
}

}  // namespace overbend
