/// Operations on the laid line: a cable replaces the pipe at the tensioner or at its far end, and in-line structures
/// pass the rollers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/description/section_description.h"

namespace overbend {

/// Cable in the line. It has no bending stiffness and is hinged to the head.
struct CableDescription {
  double diameter = 0.0;                ///< Contact diameter on rollers and seabed, and drag diameter [m].
  double weight_in_air = 0.0;           ///< [N/m]
  double weight_submerged = 0.0;        ///< [N/m]
  double axial_stiffness = 0.0;         ///< EA [N]
  std::optional<double> breaking_load;  ///< [N]
  double drag_normal = 1.2, drag_axial = 0.0, added_mass_normal = 1.0, added_mass_axial = 0.0;  ///< [-]
  std::optional<double> length;  ///< start_up: unstressed length from the head to the anchor [m].
  /// Seabed friction in shore_pull and hold_back; the axial friction of the seabed if not given [-].
  std::optional<double> friction;
};

/// Head that closes the pipe and connects the cable. Its weight is distributed over its length.
struct HeadDescription {
  double length = 0.0;                        ///< [m]
  double weight_in_air = 0.0;                 ///< Weight of the whole head [N].
  double weight_submerged = 0.0;              ///< [N]
  std::optional<SectionDescription> section;  ///< Steel, coatings and hydrodynamics; those of the pipe if not given.
};

/// Fixed end of the cable: on the vessel, in frame S, or at a distance [m].
struct WinchPlace {
  double x = 0.0, z = 0.0;
  double distance = 0.0;  ///< shore_pull and hold_back: horizontal distance astern of the stern shoe.
  double depth = 0.0;     ///< Depth below the water of the cable's fixed end; negative above water.
};

/// Dead-man anchor or bow-string to which the start-up cable is pinned.
struct StartUpAnchor {
  double depth = 0.0;              ///< Depth of the pin below the water [m].
  std::optional<double> distance;  ///< Distance astern of the stern shoe; follows from the tension if not given [m].
};

/// Value for a line, by its name.
struct LineValue {
  std::string line;
  double value = 0.0;
};

/// Offset of the vessel from its nominal position, along the axes of its nominal pose [m], [rad].
struct VesselOffset {
  double x = 0.0, y = 0.0, heading = 0.0;
};

/// The same for another body.
struct BodyOffset {
  std::string body;
  VesselOffset offset;
};

/// Joins the first ends of two lines into one node.
struct JoinDescription {
  std::string first, second;
  double kink = 0.0;  ///< Change of direction from the first line to the second [rad].
};

/// One operation stage: progress of the line and its tension.
struct LayStageDescription {
  std::string name;
  std::optional<double> cable_out;       ///< Unstressed length from winch to head [m].
  std::optional<double> pipe_out;        ///< start_up and pulls: unstressed length from tensioner to head [m].
  std::optional<double> passed;          ///< passage: length from the tensioner to the middle of the structure [m].
  std::optional<double> ahead;           ///< move: distance the barge has moved ahead [m].
  std::optional<double> tension;         ///< Top tension [N].
  std::optional<double> bottom_tension;  ///< Alternative: horizontal tension at touchdown [N].
  std::optional<double> tank_weight;     ///< ballast: weight of the empty tank [N].
  std::optional<double> tank_ballast;    ///< ballast: flooded fraction of the tank [-].
  /// lift: unstressed lengths [m]; tensions at the upper ends [N].
  std::vector<LineValue> lengths = {}, tensions = {};
  std::optional<VesselOffset> vessel = {};   ///< lift only.
  std::vector<BodyOffset> bodies = {};       ///< lift only.
  std::optional<JoinDescription> join = {};  ///< lift only.
};

/// Selection of the tension of generated stages.
enum class StageTension {
  hold,    ///< Tension of the tensioner, or linear interpolation of `values`.
  bottom,  ///< Gives the prescribed horizontal tension at touchdown.
  seek,    ///< Minimum tension that satisfies every limit.
};

/// Limits for a tension found by search.
struct StageLimits {
  std::optional<double> sagbend_strain;  ///< [-]
  std::optional<double> sagbend_stress;  ///< von Mises [Pa]
  std::optional<double> tip_clearance;   ///< Min. clearance at the stinger tip [m].
  std::optional<double> roller_load;     ///< Max. reaction of a roller [N].
  double utilisation = 1.0;              ///< Max. utilisation of the cable's breaking load and of the code checks.
};

/// Evenly spaced stages.
struct StageProgram {
  double from = 0.0, to = 0.0;  ///< cable_out, pipe_out, passed or ahead [m].
  int steps = 10;               ///< Number of steps; there is one more stage.
  StageTension tension = StageTension::hold;
  std::vector<double> values;                      ///< hold: evenly spaced from `from` to `to` [N].
  std::optional<double> bottom_tension;            ///< bottom: horizontal tension at touchdown [N].
  std::optional<double> tension_from, tension_to;  ///< Bounds of the search [N].
  StageLimits limits;
};

struct LayOperationDescription {
  std::optional<HeadDescription> head;
  std::optional<CableDescription> cable;
  std::optional<WinchPlace> winch;  ///< Position of the tensioner if not given.
  std::optional<StartUpAnchor> anchor;
  std::vector<LayStageDescription> stages;
  std::optional<StageProgram> program;  ///< Replaces `stages`.
  std::string structure;                ///< passage: name of the structure under pipe.structures.
  std::string tank;                     ///< ballast: name of the stinger tank.
};

}  // namespace overbend
