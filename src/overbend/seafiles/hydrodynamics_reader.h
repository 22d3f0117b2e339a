/// Potential-flow coefficients of a hull from the files of a panel program (model/description/hydrodynamic_data.h).
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "base/vec.h"
#include "model/description/hydrodynamic_data.h"
#include "seafiles/wave_column.h"

namespace overbend {

/// Which files, and what gives their numbers back their dimension.
struct HydrodynamicsSource {
  /// Stem of WAMIT's files (`data/bgl1/bgl1` for bgl1.1, bgl1.3, bgl1.8 and bgl1.hst; the name of any of them will do),
  /// or a Capytaine file that ends in `.nc` (seafiles/capytaine_reader.h).
  std::string path;
  double water_density = 1025.0;  ///< [kg/m3]
  double gravity = 9.81;          ///< [m/s2]
  double length_scale = 1.0;      ///< ULEN of WAMIT [m].
  double water_depth = 0.0;       ///< Of the model; 0: not known [m].
  double mass = 0.0;              ///< Likewise [kg].
  Vec3 origin_V = Vec3::Zero();   ///< Centre of gravity, which the coefficients will be about, frame V [m].
  /// Point that the values of the file are about, frame V [m]. Where neither this nor the file says it, they are taken
  /// to be about the centre of gravity.
  std::optional<Vec3> reference = {};
  Vec3 file_origin = Vec3::Zero();  ///< Origin of the axes in which the file has its points, frame V [m].
  std::optional<WaveColumn> frequencies =
      {};  ///< What the first column of WAMIT's files holds; periods where not stated.
  /// Mean drift at lower frequencies is set to zero: panel programs give noise there [rad/s].
  double drift_from = 0.0;
  /// The hull is symmetric about its centreline: headings that the files lack are taken from the other side.
  bool mirror_headings = false;
};

/// `data/bgl1/bgl1` of that and of data/bgl1/bgl1.1. A dot in the stem itself stays: only known endings are cut.
std::string hydrodynamics_stem(const std::string& path);

/// How the first column of WAMIT's files is read.
WaveColumnSettings wave_column(const HydrodynamicsSource& source);
/// Checks it over the rows of a file; false after an error.
bool check_wave_column(const HydrodynamicsSource& source, const std::vector<double>& values, const std::string& file,
                       Diagnostics& diagnostics);

/// Reads the coefficients. Of WAMIT's files:
///
/// - `.1` PER I J A B: added mass and radiation damping. PER = 0 is infinite frequency, PER = -1 zero frequency (of
///   frequencies in place of periods the other way round); neither need be there (without the former `has_infinite` is
///   false). A pair that stands once (I J without J I) stands
///   for both; those that do not stand are zero;
/// - `.3` PER BETA I MOD PHA RE IM: wave excitation; where it is missing `.2` (Haskind) of the same layout;
/// - `.8` PER BETA1 BETA2 I MOD PHA RE IM: mean drift from momentum; where it is missing `.9`, then `.7` (pressure,
///   control surface); pairs of different headings are passed over. There may be none: `drift` is then empty;
/// - `.hst` I J C: hydrostatic stiffness.
///
/// Lines of free text before the first number are passed over. Headings are turned into [0, 2 pi) and sorted; where 360
/// deg repeats 0 it must agree. Periods may stand in any order. Each bad file is one error with line, found and
/// expected, in `diagnostics`; nothing is returned then.
std::optional<HydrodynamicData> read_hydrodynamics(const HydrodynamicsSource& source, Diagnostics& diagnostics);

}  // namespace overbend
