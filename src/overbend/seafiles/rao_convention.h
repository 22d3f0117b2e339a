/// Conventions of the numbers in an RAO file, and their conversion to the internal convention.
///
/// Settings are words under short keys ("phase": "lead"). The same keys are used in the model file under
/// vessel.motion.convention, in the remarks at the head of a CSV file, and come from what other programs' files say.
#pragma once

#include <array>
#include <complex>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"

namespace overbend {

/// One key with the words it may have; the first is that of the house.
struct ConventionKey {
  std::string key;   ///< "phase", "positive.pitch".
  std::string text;  ///< One line for the user.
  std::vector<std::string> words;
};
const std::vector<ConventionKey>& convention_keys();

using ConventionWords = std::map<std::string, std::string>;

/// Names of the sets that define every key: "house", "wamit", ...
std::vector<std::string> convention_sets();
/// All keys of a named set; that of the house where the name is unknown.
ConventionWords convention_set(const std::string& name);

/// What a file says of its vessel's symmetry.
enum class RaoSymmetry {
  unstated,        ///< One side stands for the other where there is only one.
  none,            ///< No heading stands for another.
  port_starboard,  ///< OrcaFlex: xz plane.
  fore_aft,        ///< yz plane.
  quarters,        ///< Both planes.
  circular         ///< One heading stands for all.
};

/// Statements about a file, by the file or by the user. Points in frame V [m] unless a reader says otherwise.
struct RaoSettings {
  std::string set;        ///< Named set; empty: that of the file's type.
  ConventionWords words;  ///< Single keys, stronger than the set.
  std::optional<Vec3> reference, wave_origin;
  Vec3 file_origin = Vec3::Zero();  ///< Origin of the axes in which the file itself places its points, frame V.
  bool file_origin_stated = false;
  double length_scale = 1.0;         ///< ULEN of WAMIT [m].
  double vessel_length = 0.0;        ///< Of the model, to compare with that of the file; 0: not known [m].
  std::string vessel_type, draught;  ///< By name, where a file holds several.
};

/// One number pair of a file as given, angles in rad.
struct RaoRecord {
  double heading = 0.0;    ///< As numbered in the file [rad].
  double omega = 0.0;      ///< [rad/s]
  int freedom = 0;         ///< 0 surge to 5 yaw.
  double amplitude = 0.0;  ///< In the file's unit, lengths in m, angles still in the unit of `rotation`.
  double phase = 0.0;      ///< [rad]
  int line = 0;
};

/// Turns records into the convention of the house: settled once from words, then applied to each record.
class RaoTranslation {
 public:
  /// `words` must define every key; `depth` [m] gives the wave number behind slopes.
  RaoTranslation(const ConventionWords& words, double length_scale, double depth);

  /// Heading of travel, anticlockwise from V's x, in [0, 2 pi).
  double heading(double numbered) const;
  /// Complex response: m/m or rad/m, see RaoTable.
  std::complex<double> response(const RaoRecord& record) const;

 private:
  std::array<double, 6> signs_{};
  double lead_ = 1.0;       ///< -1: phases lead.
  double event_ = 0.0;      ///< Phase of the wave at the event from which phases count [rad].
  double zero_ = 0.0;       ///< Direction of travel of the heading numbered 0 [rad].
  double sense_ = 1.0;      ///< -1: headings count clockwise.
  double angle_ = 1.0;      ///< rad per unit of angle.
  double per_slope_ = 0.0;  ///< Slope per k a: 1 for the greatest slope, 1/pi for height over length; 0: per metre.
  double length_scale_ = 1.0, depth_ = 0.0;
};

}  // namespace overbend
