/// Formatted output file of WAMIT (`.out`): one file with the hull, added mass and damping, wave forces, motions,
/// drift.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "seafiles/hull_text.h"
#include "seafiles/hydrodynamics_reader.h"

namespace overbend {

/// Numbers of the file: dimensionless, modes from 1 to 6 for the first body, from 7 to 12 for the second.
struct WamitOutput {
  struct Body {
    Vec3 place = Vec3::Zero();              ///< XBODY, YBODY, ZBODY [m].
    double turned = 0.0;                    ///< PHIBODY, of the body's x axis from the global X axis [rad].
    std::optional<double> volume;           ///< Mean of VOLX, VOLY, VOLZ [m3].
    std::optional<Vec3> centre_of_gravity;  ///< In the body's axes [m].
    std::optional<Mat6> stiffness;          ///< With weight, over rho g ULEN^k.
  };
  struct Radiation {
    double omega = 0.0;  ///< 0 and infinity are the limits [rad/s].
    int i = 0, j = 0;
    double added_mass = 0.0;
    std::optional<double> damping;
    int line = 0;
  };
  struct WaveValue {
    double omega = 0.0, heading = 0.0;  ///< Direction of travel from the global X axis [rad/s, rad].
    int mode = 0;
    double modulus = 0.0, phase = 0.0;  ///< Phases lead the wave at the global X = Y = 0 [rad].
    int line = 0;
  };

  double gravity = 0.0, length_scale = 1.0;
  std::optional<double> water_depth;  ///< Infinite for deep water [m].
  std::optional<double> water_density;
  std::vector<Body> bodies;
  std::vector<Radiation> radiation;
  std::vector<WaveValue> diffraction, haskind, motions;
  std::vector<WaveValue> drift_momentum, drift_pressure, drift_control_surface;  ///< Pairs of equal headings.
};

/// Parses the text of a file. Throws HullFileError: asterisks and other text in the place of a number are errors.
WamitOutput parse_wamit_output(const HullText& text);

/// Reads a file as hull data about the model's centre of gravity: read_hydrodynamics().
std::optional<HydrodynamicData> read_wamit_output(const HydrodynamicsSource& source, Diagnostics& diagnostics);

/// Body's origin, and origin of the phases, in frame V [m]; the axes of the file are those of the body, with their
/// origin at `file_origin` moved up by ZBODY.
struct WamitPoints {
  Vec3 origin, wave_origin;
};
WamitPoints find_wamit_points(const WamitOutput::Body& body, const Vec3& file_origin);

}  // namespace overbend
