/// Contents of AQWA's files of hydrodynamic data.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "base/diagnostics.h"
#include "model/description/hydrodynamic_data.h"
#include "seafiles/hull_text.h"
#include "seafiles/hydrodynamics_reader.h"

namespace overbend {

/// Numbers of a file in SI. Added mass, damping, stiffness, forces and motions of a structure refer to its centre of
/// gravity; directions are those of travel, anticlockwise from the x axis; phases lag behind the crest at the centre of
/// gravity.
struct AqwaData {
  static constexpr int kMaxStructures = 50, kMaxFrequencies = 10000;

  struct Matrices {
    Mat6 added_mass = Mat6::Zero(), damping = Mat6::Zero();
    bool has_mass = false, has_damping = false;
    int line = 0;
  };
  struct WaveValues {
    double omega = 0.0, heading = 0.0;           ///< [rad/s, rad]
    std::array<double, 6> amplitude{}, phase{};  ///< Rotations of motions in deg per m. [rad]
    int line = 0;
  };
  struct Structure {
    std::optional<double> mass, volume;     ///< [kg, m3]
    std::optional<Vec3> centre_of_gravity;  ///< In the axes of the file [m].
    std::optional<Mat6> stiffness;          ///< With weight.
    std::map<double, Matrices> radiation;   ///< By frequency [rad/s].
    std::vector<WaveValues> forces, motions;
  };

  std::optional<double> water_depth, water_density, gravity;
  std::map<int, Structure> structures;  ///< By their number in the file.
};

/// Parses a listing (`.LIS`). Added mass and damping are those of the matrices per frequency, which have more digits
/// than the tables of their variation. Throws HullFileError.
AqwaData parse_aqwa_listing(const HullText& text);

/// Parses a hydrodynamic database in text (`.AH1`). Throws HullFileError.
AqwaData parse_aqwa_database(const HullText& text);

/// Returns the structure that the user selects, or the only one. Throws HullFileError.
const AqwaData::Structure& find_structure(const AqwaData& data, const std::optional<int>& number);

/// Reads either file as hull data about the model's centre of gravity: read_hydrodynamics().
std::optional<HydrodynamicData> read_aqwa(const HydrodynamicsSource& source, bool database, Diagnostics& diagnostics);

}  // namespace overbend
