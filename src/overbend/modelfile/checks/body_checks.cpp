#include <filesystem>

#include "modelfile/binding/binding.h"
#include "modelfile/checks/line_checks.h"
#include "modelfile/checks/model_checks.h"

namespace overbend {
namespace {

bool is_used(const FieldValue& root, const std::string& name) {
  for (const FieldValue& line : Checker::items(root, "lines")) {
    for (const FieldValue& end : Checker::items(line, "ends")) {
      if (end.get_text("body") == name) return true;
    }
  }
  return false;
}

/// Warns of a missing motion file, which statics does not need.
void check_file(Checker& check, const FieldValue& motion, const std::string& source_file) {
  for (const char* key : {"raos", "history"}) {
    const FieldValue* named = motion.find(key);
    std::error_code code;
    if (named == nullptr || std::filesystem::exists(resolved_file(named->text, source_file), code)) continue;
    check.warn(*named, "the file " + named->shown + " does not exist; dynamic analysis will require it");
  }
}

}  // namespace

void check_bodies(Checker& check, const std::string& file) {
  const std::vector<FieldValue>& bodies = Checker::items(check.root(), "bodies");
  const std::vector<std::string> names = body_names(check.root());
  check_unique_names(check, bodies, "body");
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (names[i] == kVesselName) {
      check.error(bodies[i], "the name 'vessel', which is that of the lay vessel", "another name");
    } else if (!is_used(check.root(), names[i])) {
      check.warn(bodies[i], "no line is attached to this body", FindingCode::unused_input);
    }
    if (const FieldValue* motion = bodies[i].find("motion")) {
      check_motion_source(check, *motion);
      check_file(check, *motion, file);
    }
  }
}

}  // namespace overbend
