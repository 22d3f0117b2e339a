/// Conventions of RAO files and their conversion to the internal convention.
///
/// A convention maps short keys to enum names ("phase": "lead"). The same keys are used in the model file under
/// vessel.motion.convention and in the comments at the head of a CSV file; files of other programs are translated.
#pragma once

#include <array>
#include <complex>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"

namespace overbend {

/// A key and its accepted names; the first is that of the internal convention ("house").
struct ConventionKey {
  std::string key;   ///< "phase", "positive.pitch".
  std::string text;  ///< One line for the user.
  std::vector<std::string> values;
};
/// Returns all keys.
const std::vector<ConventionKey>& convention_keys();

using ConventionValues = std::map<std::string, std::string>;

/// Returns the names of the sets that define every key: "house", "wamit", ...
std::vector<std::string> convention_sets();
/// Returns all keys of a named set; the set "house" if the name is unknown.
ConventionValues convention_set(const std::string& name);

/// Symmetry of the vessel as stated in a file.
enum class RaoSymmetry {
  unstated,        ///< If only one side is given, it is mirrored.
  none,            ///< No heading is derived from another.
  port_starboard,  ///< OrcaFlex: xz plane.
  fore_aft,        ///< yz plane.
  quarters,        ///< Both planes.
  circular         ///< All headings follow from one.
};

/// Settings of an RAO file, stated in the file or by the user. Points in frame V [m] unless a reader documents another
/// frame.
struct RaoSettings {
  std::string set;          ///< Named set; empty: default of the file type.
  ConventionValues values;  ///< Single keys, which override the set.
  std::optional<Vec3> reference, wave_origin;
  Vec3 file_origin = Vec3::Zero();  ///< Origin of the axes of the file, frame V [m].
  bool file_origin_stated = false;
  double length_scale = 1.0;         ///< ULEN of WAMIT [m].
  double vessel_length = 0.0;        ///< Length of the model's vessel, compared with the file; 0: unknown [m].
  std::string vessel_type, draught;  ///< Names to select if a file holds several.
  std::optional<int> body;           ///< Number of the body, from 1, if a file holds several.
};

/// One response as given in a file; angles in rad.
struct RaoRecord {
  double heading = 0.0;    ///< Heading in the convention of the file [rad].
  double omega = 0.0;      ///< [rad/s]
  int freedom = 0;         ///< 0 surge to 5 yaw.
  double amplitude = 0.0;  ///< Lengths in m, angles in the unit of the key `rotation`.
  double phase = 0.0;      ///< [rad]
  int line = 0;
};

/// Converts records to the internal convention.
class RaoTranslation {
 public:
  /// `convention` must define every key. The water `depth` [m] determines the wave number of slopes.
  RaoTranslation(const ConventionValues& convention, double length_scale, double depth);

  /// Returns the direction of wave travel, anticlockwise from x of frame V, in [0, 2 pi).
  double heading(double numbered) const;
  /// Returns the complex response [m/m or rad/m], see RaoTable.
  std::complex<double> response(const RaoRecord& record) const;

 private:
  std::array<double, 6> signs_{};
  double lead_ = 1.0;       ///< -1 if positive phases lead the wave.
  double event_ = 0.0;      ///< Phase of the wave at the event to which phases refer [rad].
  double zero_ = 0.0;       ///< Direction of travel of heading 0 [rad].
  double sense_ = 1.0;      ///< -1 if headings increase clockwise.
  double angle_ = 1.0;      ///< Angle unit [rad].
  double per_slope_ = 0.0;  ///< Slope per k a: 1 for the maximum slope, 1/pi for height over length; 0: per metre.
  double length_scale_ = 1.0, depth_ = 0.0;
};

}  // namespace overbend
