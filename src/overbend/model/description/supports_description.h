/// Rollers and roller boxes as the model file has them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/description/stinger_description.h"

namespace overbend {

struct BottomRollerDescription {
  double radius = 0.0;  ///< [m]
  double face = 0.0;    ///< Length of the roller [m].
};

struct SideRollerDescription {
  double radius = 0.0;     ///< [m]
  double face = 0.0;       ///< Length of the roller [m].
  double angle = 0.0;      ///< Of the roller's axis from horizontal [rad].
  double clearance = 0.0;  ///< Gap to a pipe centred on the bottom roller [m].
};

/// How the damping of a roller follows from its coefficient of restitution.
enum class RollerDamping {
  clipped,   ///< For a contact that never pulls, as the program's do: rebounds have the coefficient given.
  textbook,  ///< -ln e / sqrt(pi^2 + ln^2 e), for comparison with programs that take it.
};

/// Stiffness used for a roller that gives none.
enum class RollerStiffness {
  physical,  ///< Springs in series of pipe shell, coating and roller structure.
  penalty,   ///< EI/D^3 of the pipe: as good as rigid in statics.
};

/// A kind of roller row, used by name in the supports.
struct RollerKindDescription {
  std::string name;
  BottomRollerDescription bottom;
  std::optional<SideRollerDescription> sides;
  std::optional<double> stiffness;  ///< Of the contact as a whole [N/m]; where not given, as default_stiffness says.
  double friction_axial = 0.0;
  double friction_lateral = 0.0;
  double restitution = 0.5;
  RollerDamping damping = RollerDamping::clipped;
  /// Of sticking friction [N/m]; a tenth of the normal one if not given.
  std::optional<double> tangential_stiffness = {};
  RollerStiffness default_stiffness = RollerStiffness::physical;
  std::optional<double> structure_stiffness = {};  ///< Of roller, bearings and box [N/m]; kRollerStructure if absent.
};

enum class Structure { ramp, stinger };

struct BoxDescription {
  std::string name;
  Structure structure = Structure::ramp;
  double x = 0.0;       ///< Frame S: where the underside of the coated pipe rests, mid-box [m].
  double z = 0.0;       ///< Frame S [m].
  double offset = 0.0;  ///< Raises the box along the outward normal of the support curve [m].
  double length = 0.0;  ///< Along the pipe [m].
  std::optional<double>
      incline;         ///< Of the box axis, positive when it dips astern [rad]; tangent of the curve if not given.
  std::string roller;  ///< Name of a roller kind.
  int rows = 1;
  int section = 0;  ///< Of a stinger on hinges: which of its sections carries the box.
};

/// Model of the supports: their rollers, or one gap spring for each box.
enum class SupportContact { rollers, gap_springs };

struct SupportsDescription {
  SupportContact contact = SupportContact::rollers;
  std::optional<double> ramp_radius;     ///< Of the arc that ramp_row stands on; none beside listed boxes [m].
  std::optional<double> stinger_radius;  ///< [m]
  std::vector<BoxDescription> boxes;     ///< From the tensioner astern: ramp boxes first, then the stinger's.
  std::optional<BoxRowDescription> ramp_row, stinger_row;  ///< Boxes told as a row; those in `boxes` are made from it.
  std::vector<StingerSectionDescription> sections;  ///< On hinges, from the barge astern; empty: a fixed stinger.
  std::vector<StingerSettingDescription> settings;  ///< Of the angles of the sections.
  std::string setting;                              ///< The one chosen; empty: none.
};

}  // namespace overbend
