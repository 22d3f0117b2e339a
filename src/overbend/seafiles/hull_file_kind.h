/// The kind of a file of hull data or motions, from its contents where they suffice.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace overbend {

enum class HullFileKind {
  wamit_files,    ///< Numeric files of WAMIT with a common stem: .1, .3, .hst, ...
  wamit_output,   ///< Formatted output of WAMIT, usually .out.
  aqwa_listing,   ///< Listing of AQWA, usually .LIS.
  aqwa_database,  ///< Hydrodynamic database of AQWA in text, usually .AH1.
  nemoh,          ///< Nemoh.cal or its folder.
  bemio,          ///< HDF5 of BEMIO, usually .h5.
  capytaine,      ///< netCDF of Capytaine, usually .nc.
  hydrodyn,       ///< Input file of HydroDyn, which names WAMIT files.
  orcaflex,       ///< Text data file of OrcaFlex, usually .yml.
  hydrostar_rao   ///< Motions of HydroStar, usually .rao; no hull data.
};

/// Returns the kind of a text by its first lines; nothing if they do not suffice.
std::optional<HullFileKind> find_text_kind(std::string_view text);

/// Returns the kind of a file, folder or stem; nothing if it does not exist or is of another kind.
std::optional<HullFileKind> find_hull_file_kind(const std::string& path);

/// True if the name ends as text files of hulls and motions do: ".1", ".out", ".LIS", ..., in upper or lower case.
bool has_hull_text_ending(const std::string& name);
/// The same for binary files: ".nc", ".h5".
bool has_hull_binary_ending(const std::string& name);
/// Returns these endings for messages.
const std::vector<std::string>& hull_text_endings();

}  // namespace overbend
