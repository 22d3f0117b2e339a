#include "seafiles/hydrodynamics_reader.h"

#include <algorithm>
#include <filesystem>
#include <initializer_list>

#include "seafiles/aqwa_data.h"
#include "seafiles/bemio_reader.h"
#include "seafiles/capytaine_reader.h"
#include "seafiles/hull_file_error.h"
#include "seafiles/hull_file_kind.h"
#include "seafiles/hull_statements.h"
#include "seafiles/hydrodyn_file.h"
#include "seafiles/nemoh_reader.h"
#include "seafiles/orcaflex_hull.h"
#include "seafiles/wamit_out.h"
#include "seafiles/wamit_radiation.h"
#include "seafiles/wamit_waves.h"

namespace overbend {
namespace {

constexpr const char* kWamitEndings[] = {".1", ".2", ".3", ".4", ".7", ".8", ".9", ".hst"};

bool is_file(const std::string& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

/// Returns the first of these files that exists; the first name if none exists.
std::string first_existing(const std::string& stem, std::initializer_list<const char*> endings) {
  for (const char* ending : endings) {
    if (is_file(stem + ending)) {
      return stem + ending;
    }
  }
  return stem + *endings.begin();
}

/// Reads the files of a stem. `statements` are those of another file on them.
std::optional<HydrodynamicData> read_wamit_files(const HydrodynamicsSource& source, const HullStatements& statements,
                                                 Diagnostics& diagnostics) {
  const std::string stem = hydrodynamics_stem(source.path);
  HydrodynamicData data;
  data.source = stem;
  data.origin_V = source.origin_V;
  data.water_density = source.water_density;
  data.gravity = source.gravity;
  const std::string excitation = first_existing(stem, {".3", ".2"});
  bool good = wamit::read_radiation(stem + ".1", source, data, diagnostics);
  good = wamit::read_excitation(excitation, source, data, diagnostics) && good;
  const bool stiffness = is_file(stem + ".hst") || !source.stated_stiffness;
  if (stiffness) good = wamit::read_hydrostatics(stem + ".hst", source, data, diagnostics) && good;
  // Drift by momentum, .8, is that of all bodies together.
  const std::string drift = source.body ? first_existing(stem, {".9", ".7"}) : first_existing(stem, {".8", ".9", ".7"});
  if (is_file(drift)) {
    good = wamit::read_drift(drift, source, data, diagnostics) && good;
  }
  if (!good) return std::nullopt;
  check_same_frequencies(data, excitation, stem + ".1", diagnostics);
  try {
    complete_hull(data, statements, source, diagnostics);
    if (!stiffness) use_stated_stiffness(data, source);
  } catch (const HullFileError& error) {
    add_error(error, stem, diagnostics);
    return std::nullopt;
  }
  return data;
}

/// Reads the WAMIT files that an input file of HydroDyn names.
std::optional<HydrodynamicData> read_hydrodyn(const HydrodynamicsSource& source, Diagnostics& diagnostics) {
  try {
    const HydroDynFile file = read_hydrodyn_file(source);
    std::optional<HydrodynamicData> data = read_wamit_files(file.source, file.statements, diagnostics);
    if (data && !file.gravity_note.empty()) data->notes.push_back(file.gravity_note);
    return data;
  } catch (const HullFileError& error) {
    add_error(error, source.path, diagnostics);
    return std::nullopt;
  }
}

std::string hydrodyn_stem(const std::string& path) {
  try {
    HydrodynamicsSource source;
    source.path = path;
    source.body = 1;
    return read_hydrodyn_file(source).stem;
  } catch (const HullFileError&) {
    return path;
  }
}

std::optional<HydrodynamicData> read_by_contents(const HydrodynamicsSource& source, Diagnostics& diagnostics) {
  switch (find_hull_file_kind(source.path).value_or(HullFileKind::wamit_files)) {
    case HullFileKind::wamit_files:
      return read_wamit_files(source, {}, diagnostics);
    case HullFileKind::wamit_output:
      return read_wamit_output(source, diagnostics);
    case HullFileKind::aqwa_listing:
      return read_aqwa(source, false, diagnostics);
    case HullFileKind::aqwa_database:
      return read_aqwa(source, true, diagnostics);
    case HullFileKind::nemoh:
      return read_nemoh(source, diagnostics);
    case HullFileKind::bemio:
      return read_bemio(source, diagnostics);
    case HullFileKind::capytaine:
      return read_capytaine(source, diagnostics);
    case HullFileKind::hydrodyn:
      return read_hydrodyn(source, diagnostics);
    case HullFileKind::orcaflex:
      return read_orcaflex_hull(source, diagnostics);
    case HullFileKind::hydrostar_rao:
      break;
  }
  diagnostics.add({Severity::error, source.path, 0, 0, "", "motions of HydroStar",
                   "added mass, damping and wave forces", "vessel.motion.raos reads motions"});
  return std::nullopt;
}

bool is_finite(const HydrodynamicData& data) {
  const auto finite = [](const auto& values) {
    return std::all_of(values.begin(), values.end(), [](const auto& value) { return value.allFinite(); });
  };
  return data.hydrostatic_stiffness.allFinite() && data.added_mass_infinite.allFinite() &&
         data.added_mass_zero.allFinite() && finite(data.force) && finite(data.mean_drift) &&
         std::all_of(data.radiation.begin(), data.radiation.end(), [](const RadiationPoint& point) {
           return point.added_mass.allFinite() && point.damping.allFinite();
         });
}

}  // namespace

WaveColumnSettings wave_column(const HydrodynamicsSource& source) {
  return {source.frequencies, source.length_scale, source.gravity, source.water_depth};
}

bool check_wave_column(const HydrodynamicsSource& source, const std::vector<double>& values, const std::string& file,
                       Diagnostics& diagnostics) {
  const int errors = diagnostics.error_count();
  check_column(wave_column(source), values, file, "vessel.motion.coupled.convention.frequencies", diagnostics);
  return diagnostics.error_count() == errors;
}

std::string hydrodynamics_stem(const std::string& path) {
  for (const char* ending : kWamitEndings) {
    const std::filesystem::path file_path(path);
    if (file_path.extension() == ending && is_file(path)) {
      return (file_path.parent_path() / file_path.stem()).string();
    }
  }
  return path;
}

std::vector<std::string> hydrodynamic_files(const std::string& path) {
  if (has_hull_binary_ending(path)) return is_file(path) ? std::vector<std::string>{path} : std::vector<std::string>();
  const auto kind = find_hull_file_kind(path);
  std::vector<std::string> files = {path};
  if (kind == HullFileKind::nemoh) files = nemoh_files(path);
  if (kind == HullFileKind::wamit_files) files.clear();  // the path is the stem, or one of those below
  if (!kind || kind == HullFileKind::wamit_files || kind == HullFileKind::hydrodyn) {
    const std::string stem = kind == HullFileKind::hydrodyn ? hydrodyn_stem(path) : hydrodynamics_stem(path);
    for (const char* ending : kWamitEndings) files.push_back(stem + ending);
  }
  std::erase_if(files, [](const std::string& file) { return !is_file(file); });
  return files;
}

std::optional<HydrodynamicData> read_hydrodynamics(const HydrodynamicsSource& source, Diagnostics& diagnostics) {
  std::optional<HydrodynamicData> data = read_by_contents(source, diagnostics);
  if (!data || is_finite(*data)) return data;
  diagnostics.add({Severity::error, source.path, 0, 0, "", "values too large for a hull", "finite numbers", ""});
  return std::nullopt;
}

}  // namespace overbend
