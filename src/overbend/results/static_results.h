/// Results of a static analysis: plain data, SI units, world frame W (x east, y north, z up, origin midship at z = 0 =
/// mean water level) unless a member says otherwise. Reports, files and checks read this and compute no mechanics of
/// their own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/assumption.h"
#include "base/finding.h"
#include "base/vec.h"
#include "model/pipe/section.h"
#include "model/vessel/supports.h"
#include "results/attachment_results.h"
#include "results/body_results.h"
#include "results/check_results.h"
#include "results/dragging_results.h"
#include "results/ground_results.h"
#include "results/hull_results.h"
#include "results/lift_results.h"
#include "results/line_results.h"
#include "results/mooring_results.h"
#include "results/stinger_results.h"

namespace overbend {

/// Parts of the line, see docs/theory/regions.md.
enum class Region {
  tower,     ///< Where a clamped guide bends a pipe that no support carries.
  overbend,  ///< Tensioner to the inflection below the last support in contact.
  sagbend,   ///< From there to touchdown.
  seabed,
};

/// One station of the pipe, stations run from the anchor (s = 0) to the tensioner.
struct Station {
  double s = 0.0;                  ///< Unstressed arc length from the anchor [m].
  Vec3 p_W = Vec3::Zero();         ///< Pipe axis [m].
  double astern = 0.0;             ///< Horizontal distance astern of the stern shoe along the vessel's axis [m].
  double inclination = 0.0;        ///< Of the pipe from horizontal, positive dipping astern [rad].
  double effective_tension = 0.0;  ///< [N]
  double wall_tension = 0.0;       ///< True wall tension [N].
  double bending_moment = 0.0;     ///< Magnitude [N m].
  double vertical_moment = 0.0;    ///< Part in the vertical plane of the pipe, sagging positive [N m].
  double lateral_moment = 0.0;  ///< Part out of that plane, positive when the pipe curves to port going astern [N m].
  double curvature = 0.0;       ///< Magnitude [1/m].
  double residual_curvature = 0.0;  ///< Left without moment, of steel that has yielded; magnitude [1/m].
  double axial_stress = 0.0;        ///< From wall tension [Pa].
  double bending_stress = 0.0;      ///< At the steel's outer fibre [Pa].
  double hoop_stress = 0.0;         ///< At the inner wall, tension positive [Pa].
  double von_mises = 0.0;           ///< Largest over the section [Pa].
  double strain = 0.0;              ///< Largest longitudinal strain magnitude at the outer fibre [-].
  double seabed_reaction = 0.0;     ///< Per length [N/m].
  double penetration = 0.0;         ///< Into the seabed [m].
  double yield_stress = 0.0;        ///< Of the section here [Pa].
  // What the current adds to the above; 0 where the checks do not count it as environmental load.
  double current_vertical_moment = 0.0, current_lateral_moment = 0.0;  ///< [N m]
  double current_tension = 0.0;                                        ///< Effective [N].
  Region region = Region::sagbend;
  SectionKind kind = SectionKind::pipe;  ///< What the line is here: of a cable, moments and stresses say nothing.
};

/// Contact of one roller.
struct RollerResult {
  RollerPosition position = RollerPosition::bottom;
  double reaction = 0.0;      ///< Normal contact force on the pipe [N].
  double vertical = 0.0;      ///< World z [N].
  double longitudinal = 0.0;  ///< Along the box axis, astern positive [N].
  double lateral = 0.0;       ///< Across, port positive [N].
  double separation = 0.0;    ///< Clear distance pipe to roller, positive for daylight, negative for penetration [m].
  double off_end = 0.0;       ///< How far the closest point lies beyond the roller's face, 0 when on it [m].
  Vec3 p_W = Vec3::Zero();    ///< Reference point: middle of the roller's face [m].
  Vec3 normal_W = Vec3::UnitZ();  ///< Unit normal of the roller towards the pipe.
  Vec3 axis_W = Vec3::UnitY();    ///< Unit vector along the roller's axis.
  double radius = 0.0;            ///< [m]
  double face = 0.0;              ///< [m]
  double line_load = 0.0;         ///< Of the reaction on the coating, 0 without one [N/m].
};

/// The rollers of one row of a box: bottom first, then port and starboard where the kind has sides.
struct RowResult {
  Vec3 p_W = Vec3::Zero();  ///< Row point, where the underside of a centred pipe rests [m].
  double s = 0.0;           ///< Arc length of the pipe where it crosses the row's plane; -1 if it does not [m].
  double reaction = 0.0;    ///< Magnitude of the resultant [N].
  std::vector<RollerResult> rollers;
};

/// One roller box.
struct SupportResult {
  std::string name;
  bool stinger = false;             ///< On the stinger (else the ramp).
  Vec3 p_W = Vec3::Zero();          ///< Box point [m].
  double astern = 0.0;              ///< Frame S, X of the box point [m].
  double inclination = 0.0;         ///< Of the box axis, positive dipping astern [rad].
  double length = 0.0;              ///< [m]
  double s = 0.0;                   ///< Arc length of the pipe at the box middle [m].
  double reaction = 0.0;            ///< Magnitude of the resultant of all its rollers [N].
  double vertical = 0.0;            ///< World z [N].
  double longitudinal = 0.0;        ///< Along the box axis, astern positive [N].
  double lateral = 0.0;             ///< Across, port positive [N].
  double separation = 0.0;          ///< Smallest over its bottom rollers [m].
  double separation_lateral = 0.0;  ///< Smallest over its side rollers; infinity-free: 0 with no sides [m].
  bool has_sides = false;
  double effective_tension = 0.0, bending_moment = 0.0, bending_stress = 0.0, von_mises = 0.0,
         strain = 0.0;  ///< Pipe at the box: maxima over its length.
  std::vector<RowResult> rows;
};

/// The largest of a region with the station where it stands.
struct Extreme {
  double value = 0.0;
  double s = 0.0;
  Vec3 p_W = Vec3::Zero();
  double astern = 0.0;
};

struct RegionResult {
  Extreme bending_moment, bending_stress, von_mises, strain, effective_tension;
};

struct Touchdown {
  Vec3 p_W = Vec3::Zero();
  double s = 0.0;
  double astern = 0.0;
};

/// The head that closes the pipe, where a cable is in the line.
struct HeadResult {
  Vec3 p_W = Vec3::Zero();         ///< Where the cable takes it: the axis [m].
  double astern = 0.0;             ///< Of the stern shoe [m].
  double inclination = 0.0;        ///< Of the head there, positive dipping astern [rad].
  double cable_inclination = 0.0;  ///< Of the cable there [rad].
  double tension = 0.0;            ///< Effective, of the cable there [N].
  double clearance = 0.0;          ///< Of its underside over the bed, negative where it lies in it [m].
  double s = 0.0;                  ///< Arc length from the far end [m].
};

/// The cable of the line.
struct CableResult {
  double length = 0.0;                ///< Unstressed [m].
  double largest_tension = 0.0;       ///< Effective [N].
  std::optional<double> utilisation;  ///< Over its breaking load, where that is given [-].
  double winch_inclination = 0.0;     ///< At the winch, positive dipping astern; 0 where it ends at an anchor [rad].
};

/// What holds the far end of the cable of a start-up.
struct StartUpAnchorResult {
  double distance = 0.0;    ///< Astern of the stern shoe [m].
  double horizontal = 0.0;  ///< Pull [N].
  double uplift = 0.0;      ///< [N]
};

/// The pipe beside one end of a structure: the largest within two diameters of it, where stiffness steps.
struct StructureEndResult {
  double s = 0.0;               ///< Arc length of the end from the anchor [m].
  double bending_moment = 0.0;  ///< At the end itself [N m].
  double bending_stress = 0.0;  ///< Of the pipe [Pa].
  double von_mises = 0.0;       ///< Of the pipe [Pa].
  double strain = 0.0;          ///< Of the pipe [-].
};

/// What is built into the pipe, where it lies.
struct StructureResult {
  std::string name;
  double from_top = 0.0;           ///< Along the line, tensioner to its middle [m].
  Vec3 p_W = Vec3::Zero();         ///< Of its middle [m].
  double astern = 0.0;             ///< Of the stern shoe [m].
  double inclination = 0.0;        ///< Positive dipping astern [rad].
  double bending_moment = 0.0;     ///< Largest in it [N m].
  double effective_tension = 0.0;  ///< Largest in it [N].
  double reaction = 0.0;           ///< Largest of a roller under it; 0 where none carries it [N].
  std::string support;             ///< Box of that roller; empty where none.
  StructureEndResult upper;        ///< Towards the tensioner.
  StructureEndResult lower;        ///< Towards the seabed.
};

/// How the solver got there.
struct SolveReport {
  std::string method;  ///< "newton", "dynamic_relaxation + newton", ...
  int iterations = 0;  ///< Newton iterations, all stages.
  int relaxation_steps = 0;
  double force_residual = 0.0;       ///< Largest unbalanced nodal force over the total weight.
  double wall_time = 0.0;            ///< Inside the solver [s].
  std::vector<std::string> history;  ///< One line per stage.
};

struct DerivedSection {
  std::string name;
  double EA = 0.0, EI = 0.0;      ///< [N], [N m2]
  double weight_in_air = 0.0;     ///< [N/m]
  double weight_submerged = 0.0;  ///< [N/m]
  double steel_area = 0.0;        ///< [m2]
  double second_moment = 0.0;     ///< [m4]
  double outer_diameter = 0.0;    ///< Over the coatings = hydrodynamic diameter [m].
  double mass = 0.0;              ///< [kg/m]
};

/// Everything a static run hands on.
struct StaticResults {
  StaticResults();  // These six are compiled once: a copy of all members is long, and many sources make one.
  StaticResults(const StaticResults&);
  StaticResults(StaticResults&&) noexcept;
  StaticResults& operator=(const StaticResults&);
  StaticResults& operator=(StaticResults&&) noexcept;
  ~StaticResults();

  std::string title, version;
  Assumptions assumptions;
  Findings findings;
  std::vector<DerivedSection> sections;  ///< First the line's own, then the segments'.

  double top_tension = 0.0;                     ///< Effective, at the tensioner [N].
  double bottom_tension = 0.0;                  ///< Horizontal, at touchdown [N].
  double residual_curvature = 0.0;              ///< Of the pipe at touchdown, from yielding over the supports [1/m].
  double largest_tension = 0.0;                 ///< Effective [N].
  Extreme smallest_tension;                     ///< Effective, where it is least; below zero is compression.
  double lay_back = 0.0;                        ///< Horizontal, stern shoe to touchdown [m].
  double top_to_touchdown = 0.0;                ///< Horizontal, tensioner to touchdown [m].
  double length_top_to_touchdown = 0.0;         ///< Unstressed length [m].
  double total_length = 0.0;                    ///< Unstressed, tensioner to anchor [m].
  double suspended_length = 0.0;                ///< Last support in contact to touchdown [m].
  double departure_angle = 0.0;                 ///< At the last support in contact, or the tensioner in J-lay [rad].
  double top_inclination = 0.0;                 ///< At the tensioner, positive dipping astern [rad].
  std::optional<double> stinger_tip_clearance;  ///< Separation at the last row of the stinger [m].
  std::optional<double> ramp_fitted_radius;     ///< Of the circle fitted to the boxes' coordinates [m].
  std::optional<double> stinger_fitted_radius;  ///< [m]
  std::string last_support;                     ///< Name of the last support in contact; empty in J-lay.
  std::string largest_reaction_support;
  double largest_reaction = 0.0;     ///< Of a single roller [N].
  double smallest_separation = 0.0;  ///< Of all bottom rollers [m].
  double largest_penetration = 0.0;  ///< Pipe into rollers, by the penalty [m].
  double roller_stiffness = 0.0;     ///< Largest in use [N/m].
  Touchdown touchdown;
  Vec3 anchor_W = Vec3::Zero();
  double departure_s = 0.0;   ///< Arc length of the last contact with a support; total_length where none carries [m].
  double inflection_s = 0.0;  ///< Upper end of the sagbend: overbend or tower lie above it [m].
  /// Extremes from the tensioner to the inflection below the last support in contact; absent when no support carries
  /// the pipe (J-lay).
  std::optional<RegionResult> overbend;
  /// Extremes where the clamped guide bends the pipe; absent where a support carries it or it may turn in its guide.
  std::optional<RegionResult> tower;
  RegionResult sagbend;  ///< Extremes from there to touchdown.

  std::vector<Station> stations;
  std::vector<SupportResult> supports;
  std::vector<StructureResult> structures;  ///< From the tensioner astern.
  std::vector<PipePointResult> points;      ///< Clumps and buoys on the pipe, likewise.
  std::vector<PipeWireResult> wires;        ///< From the pipe to something else, likewise.

  double force_residual = 0.0;   ///< Largest unbalanced nodal force over the total weight.
  double global_residual = 0.0;  ///< |sum of external forces and reactions| over the total weight.
  double total_weight = 0.0;     ///< Of the line in air [N].
  Vec3 sum_weight = Vec3::Zero(), sum_buoyancy = Vec3::Zero(), sum_current = Vec3::Zero(), sum_seabed = Vec3::Zero(),
       sum_rollers = Vec3::Zero(), top_reaction = Vec3::Zero(), anchor_reaction = Vec3::Zero();  ///< [N]
  Vec3 sum_attached = Vec3::Zero();  ///< Of clumps, buoys and wires [N].
  SolveReport solve;

  // What pictures need beside the numbers above.
  Vec3 stern_shoe_W = Vec3::Zero(), tensioner_W = Vec3::Zero();
  Mat3 R_WV = Mat3::Identity();                                                             ///< Vessel axes in W.
  double vessel_length = 0.0, vessel_beam = 0.0, vessel_depth = 0.0, vessel_draught = 0.0;  ///< [m]
  std::string vessel_name;
  double water_depth = 0.0;                                      ///< At the stern shoe [m].
  double pipe_outer_diameter = 0.0, steel_outer_diameter = 0.0;  ///< Of the line's own section [m].
  double wanted_tension = 0.0;

  CheckTable checks;  ///< Of the static state.

  std::optional<HeadResult> head;                 ///< Of a line with a cable.
  std::optional<CableResult> cable;               ///< Likewise.
  std::optional<StartUpAnchorResult> far_anchor;  ///< Of a line whose cable is pinned to an anchor or a winch there.
  std::optional<DraggingResults> dragging;        ///< Of a line that is dragged along the bed.

  std::vector<StingerSectionResult> stinger;        ///< Of a stinger on hinges, from the barge astern.
  std::optional<BedResults> bed;                    ///< Of a line that touches the bed.
  std::optional<RouteResults> route;                ///< Likewise.
  std::vector<RollerFrictionCase> roller_friction;  ///< Where rollers have friction: the limits and the way of laying.

  std::optional<HullResults> hull;         ///< Of a hull with hydrodynamic coefficients.
  std::optional<LiftResults> lift;         ///< Of lines that are pipe, and of lines that hold each other.
  std::vector<LineResult> lines;           ///< That stand by themselves.
  std::vector<BodyResult> bodies;          ///< Besides the vessel; and the vessel, where lines hold it afloat.
  std::optional<MooringResults> moorings;  ///< Of a vessel on mooring lines: where it lies, and the lines.

  bool has_pipe() const { return !stations.empty(); }  ///< Whether a laid pipe is among the objects.
};

}  // namespace overbend
