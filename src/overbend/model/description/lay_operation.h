/// Operations on the line itself: a cable takes the place of the pipe at the tensioner or at its far end, and what is
/// built into the pipe passes the rollers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/description/section_description.h"

namespace overbend {

/// A wire in the line. It has no bending stiffness and is hinged to the head.
struct CableDescription {
  double diameter = 0.0;                ///< With which it lies on rollers and bed, and drags [m].
  double weight_in_air = 0.0;           ///< [N/m]
  double weight_submerged = 0.0;        ///< [N/m]
  double axial_stiffness = 0.0;         ///< EA [N]
  std::optional<double> breaking_load;  ///< [N]
  double drag_normal = 1.2, drag_axial = 0.0, added_mass_normal = 1.0, added_mass_axial = 0.0;  ///< [-]
  std::optional<double> length;    ///< Of start_up: unstressed, from the head to the anchor [m].
  std::optional<double> friction;  ///< On the seabed, of shore_pull and hold_back; the seabed's axial where not given.
};

/// What closes the pipe and takes the cable. Its weight is spread over its length.
struct HeadDescription {
  double length = 0.0;                        ///< [m]
  double weight_in_air = 0.0;                 ///< Of the whole head [N].
  double weight_submerged = 0.0;              ///< [N]
  std::optional<SectionDescription> section;  ///< Steel, coatings and hydrodynamics; the pipe's where not given.
};

/// Where the cable is held: on the vessel, in frame S, or at a distance [m].
struct WinchPlace {
  double x = 0.0, z = 0.0;
  double distance = 0.0;  ///< Of shore_pull and hold_back: horizontal, astern of the stern shoe.
  double depth = 0.0;     ///< Of the fixed end of the cable there, below the water; negative above it.
};

/// Dead-man anchor or end of a bow-string, to which the cable of a start-up is pinned.
struct StartUpAnchor {
  double depth = 0.0;              ///< Of the pin below the water [m].
  std::optional<double> distance;  ///< Astern of the stern shoe; follows from the tension where not given [m].
};

/// A line by its name, and a number that it gets.
struct LineValue {
  std::string line;
  double value = 0.0;
};

/// Where the vessel lies, from its place as drawn along its axes there [m], [rad].
struct VesselOffset {
  double x = 0.0, y = 0.0, heading = 0.0;
};

/// The same of another body.
struct BodyOffset {
  std::string body;
  VesselOffset offset;
};

/// First ends of two lines that become one node.
struct JoinDescription {
  std::string first, second;
  double kink = 0.0;  ///< By which the direction turns on the way along the first and on along the second [rad].
};

/// One stage: how far the line has gone, and what pulls it.
struct LayStageDescription {
  std::string name;
  std::optional<double> cable_out;       ///< Unstressed length from winch to head [m].
  std::optional<double> pipe_out;        ///< Of start_up and pulls: unstressed length from tensioner to head [m].
  std::optional<double> passed;          ///< Of passage: length from the tensioner to the middle of the structure [m].
  std::optional<double> ahead;           ///< Of move: how far the barge has moved ahead [m].
  std::optional<double> tension;         ///< At the top [N].
  std::optional<double> bottom_tension;  ///< Instead: horizontal tension at touchdown [N].
  std::optional<double> tank_weight;     ///< Of ballast: weight of the tank, empty [N].
  std::optional<double> tank_ballast;    ///< Of ballast: fraction of it that is flooded [-].
  std::vector<LineValue> lengths = {}, tensions = {};  ///< Of lift: unstressed [m]; at the upper end [N].
  std::optional<VesselOffset> vessel = {};             ///< Of lift.
  std::vector<BodyOffset> bodies = {};                 ///< Of lift.
  std::optional<JoinDescription> join = {};            ///< Of lift.
};

/// How the tension of generated stages is chosen.
enum class StageTension {
  hold,    ///< That of the tensioner, or of `values`, between which it is linear.
  bottom,  ///< Such that the horizontal tension at touchdown is the one given.
  seek,    ///< The least that keeps every limit.
};

/// What a sought tension keeps.
struct StageLimits {
  std::optional<double> sagbend_strain;  ///< [-]
  std::optional<double> sagbend_stress;  ///< von Mises [Pa]
  std::optional<double> tip_clearance;   ///< [m]
  std::optional<double> roller_load;     ///< Largest reaction of a roller [N].
  double utilisation = 1.0;              ///< Of the cable's breaking load and of the code checks.
};

/// Stages at even steps.
struct StageProgram {
  double from = 0.0, to = 0.0;  ///< cable_out, pipe_out, passed or ahead [m].
  int steps = 10;               ///< Stages are one more.
  StageTension tension = StageTension::hold;
  std::vector<double> values;                      ///< Of hold: at even distances from `from` to `to` [N].
  std::optional<double> bottom_tension;            ///< Of bottom [N].
  std::optional<double> tension_from, tension_to;  ///< Bounds of what is sought [N].
  StageLimits limits;
};

struct LayOperationDescription {
  std::optional<HeadDescription> head;
  std::optional<CableDescription> cable;
  std::optional<WinchPlace> winch;  ///< The tensioner's place where not given.
  std::optional<StartUpAnchor> anchor;
  std::vector<LayStageDescription> stages;
  std::optional<StageProgram> program;  ///< Instead of `stages`.
  std::string structure;                ///< Of passage: its name under pipe.structures.
  std::string tank;                     ///< Of ballast: name of the stinger's tank.
};

}  // namespace overbend
