/// Reads hydrodynamic coefficients of a hull from files of a panel program (model/description/hydrodynamic_data.h).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/enum_names.h"
#include "base/vec.h"
#include "model/description/hydrodynamic_data.h"
#include "seafiles/wave_column.h"

namespace overbend {

/// Point of the vessel to which the values in a file refer.
enum class HullOrigin {
  waterline,      ///< Origin of the axes of the file, on the water line.
  gravity_centre  ///< Centre of gravity.
};
template <>
inline constexpr std::array kEnumNames<HullOrigin> = {Word{HullOrigin::waterline, "waterline"},
                                                      Word{HullOrigin::gravity_centre, "gravity_centre"}};

/// Contents of the hydrostatic stiffness in a file.
enum class StiffnessContents {
  with_weight,      ///< Buoyancy and weight: C44 = M g GM.
  hydrostatic_only  ///< Buoyancy alone; the weight is missing.
};
template <>
inline constexpr std::array kEnumNames<StiffnessContents> = {
    Word{StiffnessContents::with_weight, "with_weight"}, Word{StiffnessContents::hydrostatic_only, "hydrostatic_only"}};

/// Files to read, and the quantities that convert their non-dimensional numbers to SI.
struct HydrodynamicsSource {
  /// Stem of the WAMIT files (`data/bgl1/bgl1` for bgl1.1, bgl1.3, bgl1.8 and bgl1.hst; the name of any of these files
  /// is accepted too), or a file or folder of another program (seafiles/hull_file_kind.h).
  std::string path;
  double water_density = 1025.0;  ///< [kg/m3]
  double gravity = 9.81;          ///< [m/s2]
  double length_scale = 1.0;      ///< ULEN of WAMIT [m].
  double water_depth = 0.0;       ///< Water depth of the model; 0: unknown [m].
  double mass = 0.0;              ///< Mass of the model's vessel; 0: unknown [kg].
  Vec3 origin_V = Vec3::Zero();   ///< Centre of gravity, reference point of the coefficients returned, frame V [m].
  /// Reference point of the values in the file, frame V [m]. If neither this nor the file states it, the centre of
  /// gravity is assumed.
  std::optional<Vec3> reference = {};
  std::optional<HullOrigin> origin = {};            ///< Another way to state the reference point.
  std::optional<StiffnessContents> stiffness = {};  ///< Default: as the program writes it, usually with weight.
  /// Stiffness for files without any: heave, roll and pitch about the centre of gravity, with weight.
  std::optional<Vec3> stated_stiffness = {};
  std::optional<int> body = {};                ///< Number of the body, from 1; needed if a file has several.
  std::string vessel_type = {}, draught = {};  ///< Names to select if an OrcaFlex file holds several.
  Vec3 file_origin = Vec3::Zero();             ///< Origin of the axes of the file, frame V [m].
  std::optional<WaveColumn> frequencies = {};  ///< Contents of the first column of WAMIT files; default: periods.
  /// Frequency below which mean drift is set to zero, because panel programs give noise there [rad/s].
  double drift_from = 0.0;
  /// True if the hull is symmetric about its centreline: missing headings are taken from the other side.
  bool mirror_headings = false;
};

/// Returns the stem `data/bgl1/bgl1` for itself and for data/bgl1/bgl1.1. Only known endings are removed, so the stem
/// may contain dots.
std::string hydrodynamics_stem(const std::string& path);

/// Returns the settings for reading the first column of WAMIT files.
WaveColumnSettings wave_column(const HydrodynamicsSource& source);
/// Checks the first column of a file; returns false after an error.
bool check_wave_column(const HydrodynamicsSource& source, const std::vector<double>& values, const std::string& file,
                       Diagnostics& diagnostics);

/// Returns the reference point stated by the user, frame V [m]; nothing if none is stated.
std::optional<Vec3> stated_reference(const HydrodynamicsSource& source);

/// Returns the files that are read for `path`, as far as they exist: for caches and archives.
std::vector<std::string> hydrodynamic_files(const std::string& path);

/// Reads the coefficients. The contents decide which reader is used (seafiles/hull_file_kind.h). WAMIT files:
///
/// - `.1` PER I J A B: added mass and radiation damping. PER = 0 is infinite frequency, PER = -1 zero frequency (the
///   reverse if the column holds frequencies); both are optional (without the former `has_infinite` is false). If only
///   one of I J and J I is present, it is used for both; pairs that are missing are zero;
/// - `.3` PER BETA I MOD PHA RE IM: wave excitation; if missing, `.2` (Haskind) of the same layout;
/// - `.8` PER BETA1 BETA2 I MOD PHA RE IM: mean drift from momentum; if missing, `.9`, then `.7` (pressure, control
///   surface); pairs of different headings are skipped. If there is none, `drift` is empty;
/// - `.hst` I J C: hydrostatic stiffness.
///
/// Lines of free text before the first number are skipped. Headings are wrapped to [0, 2 pi) and sorted; values at 0
/// and 360 deg must agree. Periods may be in any order. Each bad file gives one error with line, found and expected in
/// `diagnostics`; nothing is returned then.
std::optional<HydrodynamicData> read_hydrodynamics(const HydrodynamicsSource& source, Diagnostics& diagnostics);

}  // namespace overbend
