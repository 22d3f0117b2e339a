/// Rollers and roller boxes as given in the model file.
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
  double angle = 0.0;      ///< Angle of the roller's axis from horizontal [rad].
  double clearance = 0.0;  ///< Gap to a pipe centred on the bottom roller [m].
};

/// Relation between roller damping and coefficient of restitution.
enum class RollerDamping {
  clipped,   ///< For a contact without tension, as used here: rebounds have the given coefficient.
  textbook,  ///< -ln e / sqrt(pi^2 + ln^2 e), for comparison with programs that use it.
};

/// Stiffness of a roller without a given value.
enum class RollerStiffness {
  physical,  ///< Springs in series of pipe shell, coating and roller structure.
  penalty,   ///< EI/D^3 of the pipe: practically rigid in statics.
};

/// Type of roller row, referred to by name in the supports.
struct RollerKindDescription {
  std::string name;
  BottomRollerDescription bottom;
  std::optional<SideRollerDescription> sides;
  std::optional<double> stiffness;  ///< Total contact stiffness [N/m]; according to default_stiffness if not given.
  double friction_axial = 0.0;
  double friction_lateral = 0.0;
  double restitution = 0.5;
  RollerDamping damping = RollerDamping::clipped;
  /// Stiffness of sticking friction [N/m]; a tenth of the normal stiffness if not given.
  std::optional<double> tangential_stiffness = {};
  RollerStiffness default_stiffness = RollerStiffness::physical;
  /// Stiffness of roller, bearings and box [N/m]; kRollerStructure if not given.
  std::optional<double> structure_stiffness = {};
};

enum class Structure { ramp, stinger };

struct BoxDescription {
  std::string name;
  Structure structure = Structure::ramp;
  double x = 0.0;       ///< Frame S: point of the underside of the coated pipe, mid-box [m].
  double z = 0.0;       ///< Frame S [m].
  double offset = 0.0;  ///< Raises the box along the outward normal of the support curve [m].
  double length = 0.0;  ///< Length along the pipe [m].
  std::optional<double>
      /// Inclination of the box axis, positive when it dips astern [rad]; tangent of the curve if not given.
      incline;
  std::string roller;  ///< Name of a type of roller row.
  int rows = 1;
  int section = 0;  ///< Index of the hinged stinger section that carries the box.
};

/// Contact model of the supports: individual rollers, or one gap spring per box.
enum class SupportContact { rollers, gap_springs };

struct SupportsDescription {
  SupportContact contact = SupportContact::rollers;
  std::optional<double> ramp_radius;     ///< Radius of the arc of ramp_row; empty for listed boxes [m].
  std::optional<double> stinger_radius;  ///< [m]
  std::vector<BoxDescription> boxes;     ///< From the tensioner astern: ramp boxes first, then those of the stinger.
  std::optional<BoxRowDescription> ramp_row, stinger_row;  ///< Generated rows; their boxes are stored in `boxes`.
  std::vector<StingerSectionDescription> sections;  ///< Hinged sections, from the barge astern; empty: fixed stinger.
  std::vector<StingerSettingDescription> settings;  ///< Table of section angles.
  std::string setting;                              ///< Name of the selected setting; empty: none.
};

}  // namespace overbend
