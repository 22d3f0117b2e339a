#include <algorithm>
#include <filesystem>

#include "base/text.h"
#include "base/units.h"
#include "model/description/description_enum_names.h"
#include "model/pipe/section.h"
#include "modelfile/binding/binding.h"
#include "modelfile/checks/line_checks.h"
#include "modelfile/checks/model_checks.h"
#include "seafiles/hull_file_kind.h"

namespace overbend {
namespace {

const FieldValue* find_coupled(const FieldValue& root) {
  const FieldValue* hull = root.find("vessel.motion.coupled");
  return hull != nullptr && hull->given ? hull : nullptr;
}

bool has_current(const FieldValue& root) {
  const std::vector<FieldValue>& rows = Checker::items(root, "environment.current");
  return std::any_of(rows.begin(), rows.end(),
                     [](const FieldValue& row) { return row.get_number("speed").value_or(0.0) != 0.0; });
}

/// Checks that the hull is declared free to float in one way only.
void check_freedom(Checker& check) {
  const FieldValue& root = check.root();
  const FieldValue* stiffness = root.find("vessel.hydrostatics");
  if (stiffness == nullptr) return;
  const FieldValue* motion = root.find("vessel.motion");
  if (find_coupled(root) != nullptr) {
    check.error(*stiffness, "hydrostatics and a coupled hull, whose files contain them", "one of them");
  } else if (motion != nullptr && motion->given && motion->kind == FieldValue::Kind::text) {
    check.error(*stiffness, "hydrostatics for a hull that 'motion: fixed' holds", "one of them");
  }
  if (has_current(root)) {
    check.warn(*stiffness,
               "the current acts on lines and pipe only: give its force on the hull under vessel.loads, or use a "
               "coupled hull");
  }
}

void check_held(Checker& check) {
  if (hull_floats(check.root())) return;
  for (const char* key : {"vessel.loads", "station_keeping"}) {
    const FieldValue* value = check.root().find(key);
    if (value == nullptr || !value->given) continue;
    check.error(*value, "given for a hull that is held",
                "a hull that floats: vessel.hydrostatics or vessel.motion.coupled");
  }
}

void check_damping(Checker& check, const FieldValue& hull) {
  const FieldValue* damping = hull.find("damping");
  if (damping == nullptr) return;
  for (const FieldValue& mode : damping->children) {
    if (mode.find("ratio") != nullptr && mode.find("linear") != nullptr) {
      check.error(*mode.find("linear"), "a fraction of critical damping and a coefficient", "one of them");
    }
  }
}

/// Checks that a table of coefficients states its convention.
void check_table(Checker& check, const FieldValue& group, const std::string& file) {
  const FieldValue* table = group.find("table");
  for (const char* key : {"axes", "frontal_area", "lateral_area", "length"}) {
    const FieldValue* value = group.find(key);
    if (table == nullptr && value != nullptr && value->given) {
      check.error(*value, "a key of a table of coefficients", "the key table as well");
    }
  }
  if (table == nullptr) return;
  for (const char* key : {"axes", "frontal_area", "lateral_area"}) {
    if (!group.mentions(key)) check.missing(group, key, "the convention of the table", "there is no default");
  }
  std::error_code code;
  if (!std::filesystem::exists(resolved_file(table->text, file), code)) {
    check.error(*table, "the file " + table->shown + ", which does not exist", "a CSV file with angle_deg,cx,cy,cz");
  }
}

void check_hull_current(Checker& check, const FieldValue& hull, const std::string& file) {
  const FieldValue* current = hull.find("current");
  if (current == nullptr || !current->given) {
    if (has_current(check.root()) && !hull.mentions("current")) {
      check.missing(hull, "current", "the current load on the hull",
                    "give {transverse: 0.8, longitudinal: 0.5} for strips, a table, or none");
    }
    return;
  }
  if (current->kind != FieldValue::Kind::map) return;
  check_table(check, *current, file);
  const bool by_table = current->find("table") != nullptr;
  const bool by_dimensions = current->get_word<HullCurrentModel>("form") == HullCurrentModel::ufc;
  for (const char* key : {"form", "transverse", "longitudinal", "relative_to"}) {
    const FieldValue* value = current->find(key);
    if (value == nullptr || !value->given) continue;
    const bool coefficient = key == std::string("transverse") || key == std::string("longitudinal");
    if (by_table) {
      check.error(*value, "a key of strips together with a table", "one of them");
    } else if (by_dimensions && coefficient) {
      check.error(*value, "a coefficient together with form: ufc, which has its own", "one of them");
    }
  }
}

void check_wind(Checker& check, const FieldValue& hull, const std::string& file) {
  const FieldValue* wind = hull.find("wind");
  if (wind == nullptr || !wind->given) return;
  check_table(check, *wind, file);
  const FieldValue* table = wind->find("table");
  if (table != nullptr && wind->mentions("areas")) check.error(*table, "a table and areas", "one of them");
  if (table == nullptr && !wind->mentions("areas") && wind->get_number("speed").value_or(0.0) > 0.0) {
    check.missing(*wind, "areas", "a list of areas", "or a table; without either the wind has no effect");
  }
}

/// Checks that the reference point is given in one way.
void check_origin(Checker& check, const FieldValue& hull) {
  const FieldValue* origin = hull.find("convention.origin");
  const FieldValue* reference = hull.find("convention.reference");
  if (origin == nullptr || !origin->given || reference == nullptr || !reference->given) return;
  check.error(*origin, "an origin and a reference, which mean the same", "one of them");
}

/// Checks that the radiation file of a stem, or the file itself, exists.
void check_hydrodynamics(Checker& check, const FieldValue& hull, const std::string& file) {
  const FieldValue* stem = hull.find("hydrodynamics");
  if (stem == nullptr) return;
  const std::string path = resolved_file(stem->text, file);
  std::error_code code;
  const auto kind = find_hull_file_kind(path);
  const bool exists = std::filesystem::exists(path, code);
  if (kind && (exists || kind == HullFileKind::wamit_files)) return;
  if (exists) {
    return check.error(*stem, "the file " + stem->shown + ", whose type is not supported",
                       "the common stem of WAMIT files .1, .3, .8 and .hst, or a file of WAMIT (.out), AQWA (.LIS, "
                       ".AH1), Nemoh (Nemoh.cal), BEMIO (.h5), Capytaine (.nc), HydroDyn or OrcaFlex (.yml)");
  }
  check.error(*stem, "the stem " + stem->shown + ", but there is no file '" + stem->text + ".1'",
              "the common stem of files .1, .3, .8 and .hst in the folder of the model file");
}

/// Checks that the hull does not displace more than its bounding box.
void check_mass(Checker& check, const FieldValue& hull) {
  const FieldValue* mass = hull.find("mass");
  const FieldValue* vessel = check.root().find("vessel");
  const auto water = check.root().get_number("environment.water_weight_density");
  if (mass == nullptr || vessel == nullptr || !water) return;
  const double box = vessel->get_number("length").value_or(0.0) * vessel->get_number("beam").value_or(0.0) *
                     vessel->get_number("draught").value_or(0.0) * *water / kGravity;
  if (mass->number > 1.02 * box) {
    check.error(
        *mass, mass->shown,
        "at most the water displaced by a box of its length, beam and draught, " + format_quantity(box, "kg", "t"));
  }
}

}  // namespace

bool hull_floats(const FieldValue& root) {
  return root.find("vessel.hydrostatics") != nullptr || find_coupled(root) != nullptr;
}

void check_hull(Checker& check, const std::string& file) {
  check_freedom(check);
  check_held(check);
  const FieldValue* hull = find_coupled(check.root());
  if (hull == nullptr) return;
  check_damping(check, *hull);
  check_hull_current(check, *hull, file);
  check_wind(check, *hull, file);
  check_hydrodynamics(check, *hull, file);
  check_origin(check, *hull);
  check_mass(check, *hull);
}

}  // namespace overbend
