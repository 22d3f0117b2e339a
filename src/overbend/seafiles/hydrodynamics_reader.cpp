#include "seafiles/hydrodynamics_reader.h"

#include <filesystem>
#include <initializer_list>

#include "seafiles/capytaine_reader.h"
#include "seafiles/reference_point.h"
#include "seafiles/wamit_radiation.h"
#include "seafiles/wamit_waves.h"

namespace overbend {
namespace {

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

std::optional<HydrodynamicData> read_wamit(const HydrodynamicsSource& source, Diagnostics& diagnostics) {
  const std::string stem = hydrodynamics_stem(source.path);
  HydrodynamicData data;
  data.source = stem;
  data.origin_V = source.origin_V;
  data.water_density = source.water_density;
  data.gravity = source.gravity;
  bool good = wamit::read_radiation(stem + ".1", source, data, diagnostics);
  good = wamit::read_excitation(first_existing(stem, {".3", ".2"}), source, data, diagnostics) && good;
  good = wamit::read_hydrostatics(stem + ".hst", source, data, diagnostics) && good;
  const std::string drift = first_existing(stem, {".8", ".9", ".7"});
  if (is_file(drift)) {
    good = wamit::read_drift(drift, source, data, diagnostics) && good;
  }
  if (!good) return std::nullopt;
  if (source.reference) move_coefficients(data, {*source.reference, *source.reference}, source.water_depth);
  return data;
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
  for (const char* ending : {".1", ".2", ".3", ".4", ".7", ".8", ".9", ".hst"}) {
    const std::filesystem::path file_path(path);
    if (file_path.extension() == ending && is_file(path)) {
      return (file_path.parent_path() / file_path.stem()).string();
    }
  }
  return path;
}

std::optional<HydrodynamicData> read_hydrodynamics(const HydrodynamicsSource& source, Diagnostics& diagnostics) {
  const bool netcdf = std::filesystem::path(source.path).extension() == ".nc";
  return netcdf ? read_capytaine(source, diagnostics) : read_wamit(source, diagnostics);
}

}  // namespace overbend
