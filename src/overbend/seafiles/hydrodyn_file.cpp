#include "seafiles/hydrodyn_file.h"

#include <filesystem>

#include "base/constants.h"
#include "base/text.h"
#include "seafiles/body_number.h"
#include "seafiles/hull_text.h"

namespace overbend {
namespace {

/// Values of a key, which precede it in its line: "1025.0 WtrDens - Water density (kg/m^3)".
std::vector<std::string> values_before(const HullText& text, std::string_view key, int& line) {
  for (const TextRow& row : text.rows()) {
    for (std::size_t k = 1; k < row.cells.size() && row.cells[k] != "-"; ++k) {
      if (row.cells[k] != key) continue;
      std::vector<std::string> values;
      for (std::size_t i = 0; i < k; ++i) {
        std::string value(row.cells[i]);
        while (!value.empty() && (value.back() == ',' || value.back() == '"')) value.pop_back();
        if (!value.empty() && value.front() == '"') value.erase(0, 1);
        values.push_back(value);
      }
      line = row.line;
      return values;
    }
  }
  return {};
}

/// Number of a key; nothing if it is absent or DEFAULT.
std::optional<double> number_before(const HullText& text, const std::string& key, std::size_t body = 0) {
  int line = 0;
  const std::vector<std::string> values = values_before(text, key, line);
  if (values.empty()) return std::nullopt;
  const std::string& value = values[std::min(body, values.size() - 1)];
  if (lower_case(value) == "default") return std::nullopt;
  const std::optional<double> number = cell_number(value);
  if (!number) throw HullFileError(line, "'" + for_display(value) + "' for " + key, "a number");
  return number;
}

}  // namespace

HydroDynFile read_hydrodyn_file(const HydrodynamicsSource& source) {
  const HullText text = HullText::read(source.path);
  int line = 0;
  const std::vector<std::string> stems = values_before(text, "PotFile", line);
  if (stems.empty()) throw HullFileError("no PotFile", "the input file of HydroDyn for a hull with WAMIT files");
  const std::size_t body = find_body(source.body, stems);
  const std::filesystem::path named(stems[body]);
  HydroDynFile file;
  file.stem = (named.is_absolute() ? named : std::filesystem::path(source.path).parent_path() / named).string();
  file.source = source;
  file.source.path = file.stem;
  file.source.body.reset();
  const HydrodynamicsSource defaults;
  if (const auto density = number_before(text, "WtrDens")) {
    file.source.water_density =
        settled_constant("water_density", source.water_density, defaults.water_density, *density);
  }
  if (const auto length = number_before(text, "WAMITULEN", body)) {
    file.source.length_scale = settled_constant("length_scale", source.length_scale, defaults.length_scale, *length);
  }
  if (source.gravity == defaults.gravity) {
    file.source.gravity = kGravity;
    file.gravity_note = file_name(source.path) + " does not state the gravity: 9.80665 m/s^2, as OpenFAST by default.";
  }
  if (const auto depth = number_before(text, "WtrDpth"); depth && *depth > 0.0) file.statements.water_depth = *depth;
  if (const auto volume = number_before(text, "PtfmVol0", body); volume && *volume > 0.0) {
    file.statements.displaced_volume = *volume;
  }
  const double x = number_before(text, "PtfmRefxt", body).value_or(0.0);
  const double y = number_before(text, "PtfmRefyt", body).value_or(0.0);
  if (x != 0.0 || y != 0.0) {
    throw HullFileError("PtfmRefxt or PtfmRefyt other than 0", "a hull at the origin of OpenFAST",
                        "name the WAMIT files themselves, with convention.origin and convention.stiffness");
  }
  const double z = number_before(text, "PtfmRefzt", body).value_or(0.0);
  file.statements.reference = source.file_origin + Vec3(0.0, 0.0, z);
  file.statements.stiffness = StiffnessContents::hydrostatic_only;
  return file;
}

}  // namespace overbend
