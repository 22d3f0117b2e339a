/// Results of a static analysis: plain data, SI units, world frame W (x east, y north, z up, origin midship at z = 0 =
/// mean water level) unless a member says otherwise. Reports, files and checks read these data and compute no mechanics
/// of their own.
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
  tower,     ///< Clamped guide that bends a pipe without support contact.
  overbend,  ///< Tensioner to the inflection below the last support in contact.
  sagbend,   ///< Inflection to touchdown.
  seabed,
};

/// One station of the pipe; stations run from the anchor (s = 0) to the tensioner.
struct Station {
  double s = 0.0;                  ///< Unstressed arc length from the anchor [m].
  Vec3 p_W = Vec3::Zero();         ///< Pipe axis [m].
  double astern = 0.0;             ///< Horizontal distance astern of the stern shoe along the vessel's axis [m].
  double inclination = 0.0;        ///< Inclination of the pipe from horizontal, positive dipping astern [rad].
  double effective_tension = 0.0;  ///< [N]
  double wall_tension = 0.0;       ///< True wall tension [N].
  double bending_moment = 0.0;     ///< Magnitude [N m].
  double vertical_moment = 0.0;    ///< Part in the vertical plane of the pipe, sagging positive [N m].
  double lateral_moment = 0.0;  ///< Part out of that plane, positive when the pipe curves to port going astern [N m].
  double curvature = 0.0;       ///< Magnitude [1/m].
  double residual_curvature = 0.0;  ///< Curvature without moment of a section that has yielded; magnitude [1/m].
  double axial_stress = 0.0;        ///< From wall tension [Pa].
  double bending_stress = 0.0;      ///< At the steel's outer fibre [Pa].
  double hoop_stress = 0.0;         ///< At the inner wall, tension positive [Pa].
  double von_mises = 0.0;           ///< Maximum over the section [Pa].
  double strain = 0.0;              ///< Maximum magnitude of the longitudinal strain at the outer fibre [-].
  double seabed_reaction = 0.0;     ///< Per length [N/m].
  double penetration = 0.0;         ///< Into the seabed [m].
  double yield_stress = 0.0;        ///< Yield stress of the section at the station [Pa].
  // Contribution of the current to the above; 0 if the checks do not count it as environmental load.
  double current_vertical_moment = 0.0, current_lateral_moment = 0.0;  ///< [N m]
  double current_tension = 0.0;                                        ///< Effective [N].
  Region region = Region::sagbend;
  SectionKind kind = SectionKind::pipe;  ///< Kind of section; for a cable, moments and stresses have no meaning.
};

/// Contact of one roller.
struct RollerResult {
  RollerPosition position = RollerPosition::bottom;
  double reaction = 0.0;          ///< Normal contact force on the pipe [N].
  double vertical = 0.0;          ///< World z [N].
  double longitudinal = 0.0;      ///< Along the box axis, astern positive [N].
  double lateral = 0.0;           ///< Across, port positive [N].
  double separation = 0.0;        ///< Clear distance between pipe and roller, negative for penetration [m].
  double off_end = 0.0;           ///< Distance of the closest point beyond the roller's face, 0 if on the face [m].
  Vec3 p_W = Vec3::Zero();        ///< Reference point: middle of the roller's face [m].
  Vec3 normal_W = Vec3::UnitZ();  ///< Unit normal of the roller towards the pipe.
  Vec3 axis_W = Vec3::UnitY();    ///< Unit vector along the roller's axis.
  double radius = 0.0;            ///< [m]
  double face = 0.0;              ///< [m]
  double line_load = 0.0;         ///< Load of the reaction on the coating, 0 without a coating [N/m].
};

/// The rollers of one row of a box: bottom first, then port and starboard if there are side rollers.
struct RowResult {
  Vec3 p_W = Vec3::Zero();  ///< Row point: contact point of the underside of a centred pipe [m].
  double s = 0.0;           ///< Arc length at which the pipe crosses the row's plane; -1 if it does not [m].
  double reaction = 0.0;    ///< Magnitude of the resultant [N].
  std::vector<RollerResult> rollers;
};

/// One roller box.
struct SupportResult {
  std::string name;
  bool stinger = false;             ///< True on the stinger, false on the ramp.
  Vec3 p_W = Vec3::Zero();          ///< Box point [m].
  double astern = 0.0;              ///< Frame S, X of the box point [m].
  double inclination = 0.0;         ///< Inclination of the box axis, positive dipping astern [rad].
  double length = 0.0;              ///< [m]
  double s = 0.0;                   ///< Arc length of the pipe at the box middle [m].
  double reaction = 0.0;            ///< Magnitude of the resultant of all its rollers [N].
  double vertical = 0.0;            ///< World z [N].
  double longitudinal = 0.0;        ///< Along the box axis, astern positive [N].
  double lateral = 0.0;             ///< Across, port positive [N].
  double separation = 0.0;          ///< Minimum over its bottom rollers [m].
  double separation_lateral = 0.0;  ///< Minimum over its side rollers; 0 without any [m].
  bool has_sides = false;
  double effective_tension = 0.0, bending_moment = 0.0, bending_stress = 0.0, von_mises = 0.0,
         strain = 0.0;  ///< Maxima of the pipe over the length of the box.
  std::vector<RowResult> rows;
};

/// Maximum in a region and its station.
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

/// The head that closes the pipe, for a line with a cable.
struct HeadResult {
  Vec3 p_W = Vec3::Zero();         ///< Attachment point of the cable, on the axis [m].
  double astern = 0.0;             ///< Distance astern of the stern shoe [m].
  double inclination = 0.0;        ///< Inclination of the head, positive dipping astern [rad].
  double cable_inclination = 0.0;  ///< Inclination of the cable at the head [rad].
  double tension = 0.0;            ///< Effective tension of the cable at the head [N].
  double clearance = 0.0;          ///< Clearance of its underside above the seabed, negative for penetration [m].
  double s = 0.0;                  ///< Arc length from the far end [m].
};

/// The cable of the line.
struct CableResult {
  double length = 0.0;                ///< Unstressed [m].
  double max_tension = 0.0;           ///< Effective [N].
  std::optional<double> utilisation;  ///< Maximum tension over breaking load, if given [-].
  double winch_inclination = 0.0;     ///< At the winch, positive dipping astern; 0 where it ends at an anchor [rad].
};

/// Anchor of the cable in a start-up.
struct StartUpAnchorResult {
  double distance = 0.0;    ///< Distance astern of the stern shoe [m].
  double horizontal = 0.0;  ///< Horizontal force on the anchor [N].
  double uplift = 0.0;      ///< [N]
};

/// Maxima of the pipe within two diameters of one end of a structure, where stiffness changes abruptly.
struct StructureEndResult {
  double s = 0.0;               ///< Arc length of the end from the anchor [m].
  double bending_moment = 0.0;  ///< At the end itself [N m].
  double bending_stress = 0.0;  ///< Maximum in the pipe [Pa].
  double von_mises = 0.0;       ///< Maximum in the pipe [Pa].
  double strain = 0.0;          ///< Maximum in the pipe [-].
};

/// A structure built into the pipe.
struct StructureResult {
  std::string name;
  double from_top = 0.0;           ///< Distance along the line from the tensioner to its middle [m].
  Vec3 p_W = Vec3::Zero();         ///< Position of its middle [m].
  double astern = 0.0;             ///< Distance astern of the stern shoe [m].
  double inclination = 0.0;        ///< Positive dipping astern [rad].
  double bending_moment = 0.0;     ///< Maximum in the structure [N m].
  double effective_tension = 0.0;  ///< Maximum in the structure [N].
  double reaction = 0.0;           ///< Maximum of a roller under it; 0 without contact [N].
  std::string support;             ///< Roller box of that maximum; empty without contact.
  StructureEndResult upper;        ///< Towards the tensioner.
  StructureEndResult lower;        ///< Towards the seabed.
};

/// Record of the solution.
struct SolveReport {
  std::string method;  ///< "newton", "dynamic_relaxation + newton", ...
  int iterations = 0;  ///< Total number of Newton iterations.
  int relaxation_steps = 0;
  double force_residual = 0.0;       ///< Maximum unbalanced nodal force over the total weight.
  double wall_time = 0.0;            ///< Wall time of the solver [s].
  std::vector<std::string> history;  ///< One line per load step.
};

struct DerivedSection {
  std::string name;
  double EA = 0.0, EI = 0.0;      ///< [N], [N m2]
  double weight_in_air = 0.0;     ///< [N/m]
  double weight_submerged = 0.0;  ///< [N/m]
  double steel_area = 0.0;        ///< [m2]
  double second_moment = 0.0;     ///< [m4]
  double outer_diameter = 0.0;    ///< Outer diameter including coatings = hydrodynamic diameter [m].
  double mass = 0.0;              ///< [kg/m]
};

/// Results of a static analysis.
struct StaticResults {
  StaticResults();  // These six are defined in the source file: the member-wise copy is long, and many sources would
                    // instantiate it.
  StaticResults(const StaticResults&);
  StaticResults(StaticResults&&) noexcept;
  StaticResults& operator=(const StaticResults&);
  StaticResults& operator=(StaticResults&&) noexcept;
  ~StaticResults();

  std::string title, version;
  Assumptions assumptions;
  Findings findings;
  std::vector<DerivedSection> sections;  ///< First the section of the line itself, then those of the segments.

  double top_tension = 0.0;                     ///< Effective, at the tensioner [N].
  double bottom_tension = 0.0;                  ///< Horizontal, at touchdown [N].
  double residual_curvature = 0.0;              ///< Residual curvature of the pipe at touchdown, from yielding over the
                                                ///< supports [1/m].
  double max_tension = 0.0;                     ///< Effective [N].
  Extreme min_effective_tension;                ///< Minimum effective tension; negative for compression.
  double lay_back = 0.0;                        ///< Horizontal, stern shoe to touchdown [m].
  double top_to_touchdown = 0.0;                ///< Horizontal, tensioner to touchdown [m].
  double length_top_to_touchdown = 0.0;         ///< Unstressed length [m].
  double total_length = 0.0;                    ///< Unstressed, tensioner to anchor [m].
  double suspended_length = 0.0;                ///< Last support in contact to touchdown [m].
  double departure_angle = 0.0;                 ///< At the last support in contact, or the tensioner in J-lay [rad].
  double top_inclination = 0.0;                 ///< At the tensioner, positive dipping astern [rad].
  std::optional<double> stinger_tip_clearance;  ///< Separation at the last row of the stinger [m].
  std::optional<double> ramp_fitted_radius;     ///< Radius of the circle fitted to the boxes' coordinates [m].
  std::optional<double> stinger_fitted_radius;  ///< Radius of the circle fitted to the boxes' coordinates [m].
  std::string last_support;                     ///< Name of the last support in contact; empty in J-lay.
  std::string max_reaction_support;
  double max_reaction = 0.0;           ///< Maximum of a single roller [N].
  double min_bottom_separation = 0.0;  ///< Minimum over all bottom rollers [m].
  double max_penetration = 0.0;   ///< Maximum penetration of the pipe into rollers, from the penalty stiffness [m].
  double roller_stiffness = 0.0;  ///< Maximum in use [N/m].
  Touchdown touchdown;
  Vec3 anchor_W = Vec3::Zero();
  double departure_s = 0.0;   ///< Arc length of the last contact with a support; total_length without contact [m].
  double inflection_s = 0.0;  ///< Upper end of the sagbend, below overbend or tower [m].
  /// Extremes from the tensioner to the inflection below the last support in contact; none if no support carries the
  /// pipe (J-lay).
  std::optional<RegionResult> overbend;
  /// Extremes where the clamped guide bends the pipe; none if a support carries it or it can rotate in its guide.
  std::optional<RegionResult> tower;
  RegionResult sagbend;  ///< Extremes from the inflection to touchdown.

  std::vector<Station> stations;
  std::vector<SupportResult> supports;
  std::vector<StructureResult> structures;  ///< From the tensioner astern.
  std::vector<PipePointResult> points;      ///< Clumps and buoys on the pipe, from the tensioner astern.
  std::vector<PipeWireResult> wires;        ///< From the pipe to other objects, from the tensioner astern.

  double force_residual = 0.0;   ///< Maximum unbalanced nodal force over the total weight.
  double global_residual = 0.0;  ///< |sum of external forces and reactions| over the total weight.
  double total_weight = 0.0;     ///< Weight of the line in air [N].
  Vec3 sum_weight = Vec3::Zero(), sum_buoyancy = Vec3::Zero(), sum_current = Vec3::Zero(), sum_seabed = Vec3::Zero(),
       sum_rollers = Vec3::Zero(), top_reaction = Vec3::Zero(), anchor_reaction = Vec3::Zero();  ///< [N]
  Vec3 sum_attached = Vec3::Zero();  ///< Resultant of clumps, buoys and wires [N].
  SolveReport solve;

  // Additional data for figures.
  Vec3 stern_shoe_W = Vec3::Zero(), tensioner_W = Vec3::Zero();
  Mat3 R_WV = Mat3::Identity();                                                             ///< Vessel axes in W.
  double vessel_length = 0.0, vessel_beam = 0.0, vessel_depth = 0.0, vessel_draught = 0.0;  ///< [m]
  std::string vessel_name;
  double water_depth = 0.0;                                      ///< At the stern shoe [m].
  double pipe_outer_diameter = 0.0, steel_outer_diameter = 0.0;  ///< Outer diameters of the section of the line itself
                                                                 ///< [m].
  double wanted_tension = 0.0;

  CheckTable checks;  ///< Checks of the static state.

  std::optional<HeadResult> head;                 ///< Only for a line with a cable.
  std::optional<CableResult> cable;               ///< Only for a line with a cable.
  std::optional<StartUpAnchorResult> far_anchor;  ///< Only for a cable that ends at an anchor or a winch.
  std::optional<DraggingResults> dragging;        ///< Only for a line that is dragged along the seabed.

  std::vector<StingerSectionResult> stinger;        ///< Only for a stinger on hinges, from the vessel astern.
  std::optional<BedResults> bed;                    ///< Only for a line in contact with the seabed.
  std::optional<RouteResults> route;                ///< Only for a line in contact with the seabed.
  std::vector<RollerFrictionCase> roller_friction;  ///< Limit cases and laying direction; only for rollers with
                                                    ///< friction.

  std::optional<HullResults> hull;         ///< Only for a hull with hydrodynamic coefficients.
  std::optional<LiftResults> lift;         ///< Only for pipe lines and connected lines.
  std::vector<LineResult> lines;           ///< Stand-alone lines.
  std::vector<BodyResult> bodies;          ///< Bodies other than the vessel; and the vessel if it floats on lines.
  std::optional<MooringResults> moorings;  ///< Only for a vessel on mooring lines: its equilibrium, and the lines.

  bool has_pipe() const { return !stations.empty(); }  ///< Returns true if there is a laid pipe.
};

}  // namespace overbend
