/// Formats of RAO files; include seafiles/rao_reader.h instead.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "seafiles/rao_convention.h"
#include "seafiles/wave_column.h"

namespace overbend::rao_formats {

/// Contents of a file: its records and settings. Angles of records are in rad except amplitudes.
struct RaoFile {
  std::vector<RaoRecord> records;
  RaoSettings stated;
  RaoSymmetry symmetry = RaoSymmetry::unstated;
  std::vector<std::string> assumptions;  ///< Sentences on the origin of the data, for reports.
  std::vector<std::string> notes;        ///< Sentences on what was converted or left out, for reports.
  bool axes_of_file = false;             ///< The points of `stated` are in the axes of the file, not in frame V.
};

/// Readers of the text of a file; errors go to `diagnostics`. `user_settings` selects one of several vessel types and
/// draughts.
RaoFile read_csv(const std::string& text, const std::string& file, Diagnostics& diagnostics);
RaoFile read_wamit(const std::string& text, const std::string& file, const WaveColumnSettings& column,
                   Diagnostics& diagnostics);
/// Motions in a `.out` of WAMIT and in a listing of AQWA; points are in the axes of the file.
RaoFile read_wamit_output(const std::string& text, const std::string& file, const RaoSettings& user_settings,
                          Diagnostics& diagnostics);
RaoFile read_aqwa_listing(const std::string& text, const std::string& file, const RaoSettings& user_settings,
                          Diagnostics& diagnostics);
/// Motions of HydroStar: `file` is one of six, named hull_surge.rao to hull_yaw.rao, and `text` its contents; the
/// others are read from its folder. The files do not state the sense of their phases: an error unless the user does.
RaoFile read_hydrostar(const std::string& text, const std::string& file, const RaoSettings& user_settings,
                       Diagnostics& diagnostics);

/// Tables of responses in an OrcaFlex vessel type.
enum class OrcaFlexRaos {
  displacement,  ///< [m/m, rad/m or as the key `rotation` says]
  load,          ///< Force per wave amplitude [N/m, N].
  drift          ///< Mean drift per squared amplitude, with its sign [N/m2, N/m].
};
RaoFile read_orcaflex(const std::string& text, const std::string& file, const RaoSettings& user_settings,
                      Diagnostics& diagnostics, OrcaFlexRaos raos = OrcaFlexRaos::displacement);

/// True if the selected draught of the selected vessel type has a table of these responses.
bool has_orcaflex_raos(const std::string& text, const RaoSettings& user_settings, OrcaFlexRaos raos);

}  // namespace overbend::rao_formats
