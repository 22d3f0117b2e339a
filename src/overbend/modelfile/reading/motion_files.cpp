#include "modelfile/reading/motion_files.h"

#include <filesystem>

#include "modelfile/binding/binding.h"
#include "modelfile/fields/field_table.h"
#include "seafiles/motion_history_reader.h"
#include "seafiles/rao_reader.h"

namespace overbend {
namespace {

/// Returns the settings for the motion of a body, from the keys in `group`.
RaoSettings read_settings(const FieldValue& group, const std::string& source_file) {
  RaoSettings settings;
  const FieldValue* convention = group.find("motion.convention");
  if (convention != nullptr) bind_members(field_node("vessel.motion.convention"), *convention, &settings, source_file);
  return settings;
}

/// Returns the meaning of columns of a recorded motion, from the keys in `group`.
MotionColumns read_columns(const FieldValue& group) {
  MotionColumns columns;
  if (const FieldValue* keys = group.find("motion.columns")) {
    for (const FieldValue& key : keys->children) columns.emplace(key.key, key.text);
  }
  return columns;
}

void read_file(const FieldValue& group, const Description& description, VesselDescription& body,
               Diagnostics& diagnostics) {
  RaoSettings settings = read_settings(group, description.source_file);
  const FieldValue* length = group.find("length");
  if (length != nullptr && length->given) settings.vessel_length = body.length;
  body.motion_reference_V = settings.reference.value_or(Vec3::Zero());
  std::error_code code;
  if (body.motion_file.empty() || !std::filesystem::exists(body.motion_file, code)) return;
  if (body.motion == VesselMotion::raos) {
    body.raos = read_raos(body.motion_file, settings, description.environment.water_depth, diagnostics);
  } else if (body.motion == VesselMotion::history) {
    body.history = read_motion_history(body.motion_file, body.heading, diagnostics, read_columns(group));
  }
}

}  // namespace

void read_motion_file(const FieldValue& root, Description& description, Diagnostics& diagnostics) {
  if (const FieldValue* vessel = root.find("vessel")) read_file(*vessel, description, description.vessel, diagnostics);
  const FieldValue* bodies = root.find("bodies");
  for (std::size_t i = 0; bodies != nullptr && i < description.bodies.size(); ++i) {
    read_file(bodies->children[i], description, description.bodies[i].hull, diagnostics);
  }
}

}  // namespace overbend
